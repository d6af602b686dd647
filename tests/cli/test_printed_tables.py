"""Printed tables of orbits against their own JSON, column by column, by the headings."""

import json
from collections.abc import Callable

import pytest
from computed import Exact
from printed_table import Columns, Document, compare, read

import nonsmooth as ns
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT

#: Another oscillator than the default: no two of its scales are alike.
FLAGS = (
    "--mass", 0.02, "--stiffness", 8, "--belt-speed", 0.75,
    "--mu-s", 0.9, "--mu-k", 0.5, "--normal-force", 1,
)  # fmt: skip

SOLVE: Columns = {
    "method": (lambda row: row["method"], ""),
    "N": (lambda row: row["order"], ""),
    "T [s]": (lambda row: row["period"], ".9g"),
    "T/T_ex-1": (lambda row: row["errors"]["period"], ".2e"),
    "t1 [s]": (lambda row: row["t1"], ".7g"),
    "(22)": (lambda row: row["errors"]["acceleration"], ".2e"),
    "aligned": (lambda row: row["errors"]["acceleration_aligned"], ".2e"),
    "estimate": (lambda row: row["estimate"]["period"], ".1e"),
    "it": (lambda row: row["iterations"], ""),
}


def test_the_table_of_solve(run) -> None:
    _, out, _ = run("solve", "--order", 6, *FLAGS)
    orbits = json.loads(run("solve", "--order", 6, *FLAGS, "--json")[1])["orbits"]
    exact, *table = read(out, list(SOLVE))
    compare(table, orbits, SOLVE)
    assert [orbit["method"] for orbit in orbits] == ["hb", "hb-c1", "c1"]
    assert exact["method"] == "exact"
    belt = ns.StickSlip(**orbits[0]["parameters"])
    assert exact["T [s]"] == f"{Exact(belt).period:.9g}"
    assert exact["t1 [s]"] == f"{Exact(belt).t1:.7g}"
    for orbit in orbits:  # what the JSON says is the error, from its own times
        off = orbit["period"] / Exact(belt).period - 1
        assert orbit["errors"]["period"] == pytest.approx(off, abs=1e-14)
        assert orbit["errors"]["t1"] == pytest.approx(
            orbit["t1"] / Exact(belt).t1 - 1, abs=1e-13
        )


def test_the_table_of_solve_names_the_c1_functions(run) -> None:
    arguments = ("solve", "--method", "hb-c1", "--order", 20, "--c1-terms", 3)
    _, out, _ = run(*arguments)
    document = json.loads(run(*arguments, "--json")[1])
    (_, row) = read(out, list(SOLVE))
    assert row["method"] == "hb-c1(3)"
    assert row["T [s]"] == format(document["period"], ".9g")


def test_the_digits_below_the_table_of_solve_are_of_the_same_orbit(run) -> None:
    arguments = ("solve", "--method", "c1", "--order", 12, *FLAGS)
    document = json.loads(run(*arguments, "--json")[1])
    (line,) = (q for q in run(*arguments)[1].splitlines() if ": T = " in q)
    name, _, values = line.partition(": T = ")
    assert name == "c1, N = 12"
    period, t1 = values.removesuffix(" s").split(" s, t1 = ")
    for shown, of in ((period, "period"), (t1, "t1")):
        places = len(shown.partition(".")[2])
        assert len(shown) > 9
        assert float(shown) == pytest.approx(document[of], rel=0, abs=0.5001 * 10.0**-places)


SWEEP: Columns = {
    "method": (lambda row: row["method"], ""),
    "N": (lambda row: row["order"], ""),
    "T [s]": (lambda row: row["period"], ".9g"),
    "T/T_ex-1": (lambda row: row["errors"]["period"], ".3e"),
    "t1/t1_ex-1": (lambda row: row["errors"]["t1"], ".3e"),
    "(22)": (lambda row: row["errors"]["acceleration"], ".3e"),
    "estimate": (lambda row: row["estimate"]["period"], ".1e"),
    "it": (lambda row: row["iterations"], ""),
}


def shown_rate(name: str) -> tuple[Callable[[Document], str], str]:
    def shown(row: Document) -> str:
        power = f"{-row[name]:.3f}" if row["kind"] == "power" else f"{-row[name]:.2f}"
        return f"N^{power}" if row["kind"] == "power" else f"10^({power} N)"

    return shown, ""


def test_the_tables_of_sweep(run) -> None:
    arguments = ("sweep", "--orders", "5-10", *FLAGS)
    out, document = run(*arguments)[1], json.loads(run(*arguments, "--json")[1])
    compare(read(out, list(SWEEP)), document["rows"], SWEEP)
    assert len(document["rows"]) == 18
    rates: Columns = {
        "method": (lambda row: row["method"], ""),
        "T": shown_rate("period"),
        "t1": shown_rate("t1"),
        "(22)": shown_rate("acceleration"),
    }
    rows = [{"method": name} | rate for name, rate in document["rates"].items()]
    compare(read(out, list(rates)), rows, rates)
    assert [row["kind"] for row in rows] == ["power", "power", "geometric"]


def test_a_row_of_sweep_without_an_orbit_says_so(run) -> None:
    arguments = ("sweep", "--methods", "c1", "--orders", "3-5", "--normal-force", 100)
    out, rows = run(*arguments)[1], json.loads(run(*arguments, "--json")[1])["rows"]
    table = read(out, list(SWEEP))
    assert [row["status"] for row in rows] == ["no-orbit", "no-orbit", "ok"]
    compare(table[2:], rows[2:], SWEEP)
    for cells, row in zip(table[:2], rows[:2], strict=True):
        filled = {heading: cell for heading, cell in cells.items() if cell}
        names = {"method": "c1", "N": str(row["order"]), "it": str(row["iterations"])}
        assert filled == names | {"T [s]": "no-orbit"}


def test_the_table_of_roots(run) -> None:
    arguments = ("roots", "--order", 7, *FLAGS)
    out, document = run(*arguments)[1], json.loads(run(*arguments, "--json")[1])

    top, *lines = out[out.index("slip [s]") :].splitlines()
    place, shown = top.index("verdict"), ""
    for line in filter(None, lines):
        head, words = line[:place].split(), line[place:].strip()
        shown += f"\n{' '.join(head)} | {words}" if head else f" {words}"
    expected = [
        f"{row['slip']:.6g} {row['t1']:.6g} {row['period']:.6g} "
        f"{row['transition_mismatch']:.1e} | "
        + ("the orbit" if row["admissible"] else str(row["violations"][0]))
        for row in document["roots"]
    ]
    assert shown.strip().splitlines() == expected
    assert max(map(len, out.splitlines())) <= 80
    exact = Exact(ns.StickSlip(**document["parameters"]))
    (orbit,) = (row for row in document["roots"] if row["admissible"])
    assert orbit["period"] == pytest.approx(exact.period, rel=1e-4)
    assert orbit["t1"] == pytest.approx(exact.t1, rel=1e-3)
    for row in document["roots"]:
        assert row["slip"] == pytest.approx(row["period"] - row["t1"], rel=1e-12)
    assert len(document["roots"]) > 2


def test_the_lines_above_a_table_name_the_oscillator(run) -> None:
    out = " ".join(run("solve", "--method", "c1", "--order", 7, *FLAGS)[1].split())
    assert out.startswith(
        "M = 0.02 kg, K = 8 N/m, V = 0.75 m/s, mu_s = 0.9, mu_k = 0.5, F_N = 1 N; "
        "alpha = omega_n (mu_s - mu_k) F_N / (K V) = 1.33333 "
    )
    assert "our choice" not in out
    assert DEFAULT.alpha == 1
    assert "F_N = 400 N is assumed" in run("roots", "--order", 3)[1]
