"""Printed tables of orbits against their own JSON, column by column, by the headings."""

import json
from collections.abc import Callable
from pathlib import Path

import pytest
from computed import Exact
from printed_table import Columns, Document, compare, read

import nonsmooth as ns

#: Another oscillator than the default: no two of its scales are alike.
FLAGS = (
    "--mass", 0.02, "--stiffness", 8, "--belt-speed", 0.75,
    "--mu-s", 0.9, "--mu-k", 0.5, "--normal-force", 1,
)  # fmt: skip


def of_durations(row: Document) -> list[float]:
    return row["durations"] if "durations" in row else [q["duration"] for q in row["phases"]]


def extreme(end: int) -> tuple[Callable[[Document], float], str]:
    return lambda row: row["extremes"]["displacement"][end], ".6g"


def method(ck: str = "ck") -> Columns:
    """Return the column of methods, whose names a table spells with the class of the scene."""
    return {"method": (lambda row: row["method"].replace("ck", ck), "")}


#: What headings show wherever they stand.
ORDER: Columns = {"N": (lambda row: row["order"], "")}
PERIOD: Columns = {"T [s]": (lambda row: row["period"], ".9g")}
FORCED = PERIOD | {"phi [rad]": (lambda row: row["forcing_phase"], ".7g")}
STICK_SLIP: Columns = {
    "stick [s]": (lambda row: of_durations(row)[0], ".7g"),
    "slip [s]": (lambda row: of_durations(row)[1], ".7g"),
}
ERRORS: Columns = {
    "times": (lambda row: row["errors"]["times"], ".2e"),
    "estimate": (lambda row: row["estimate"]["times"], ".1e"),
    "it": (lambda row: row["iterations"], ""),
}
JUMPS: Columns = {"x''": (lambda row: row["errors"]["discontinuous"], ".2e")}
JUMPS_OF_C0: Columns = {"x'": JUMPS["x''"]}
SWEEP = method() | ORDER | PERIOD | ERRORS | JUMPS
SOLVE = SWEEP | STICK_SLIP
SWEEP_OF_IMPACT = method("c0") | ORDER | FORCED | ERRORS | JUMPS_OF_C0
ALONG: Columns = {
    "least x [m]": extreme(0),
    "largest x [m]": extreme(1),
    "estimate": ERRORS["estimate"],
    "it": ERRORS["it"],
}
PHASES: Columns = {
    "phase": (lambda row: row["name"], ""),
    "t [s]": (lambda row: row["time"], ".7g"),
    "lasts [s]": (lambda row: row["duration"], ".7g"),
    "x [m]": (lambda row: row["start"]["displacement"], ".7g"),
    "x' [m/s]": (lambda row: row["start"]["velocity"], ".7g"),
}

#: Commands, the columns of their tables, and where the rows are in their documents.
TABLES: list[tuple[tuple[object, ...], Columns, str]] = [
    (("solve", "--order", 6, *FLAGS), SOLVE, "orbits"),
    (("solve", "impact", "--gap", 0.2, "--order", 6), SWEEP_OF_IMPACT, "orbits"),
    (("solve", "stick-slip-damped", "--order", 8), SOLVE | method("c1"), "orbits"),
    (("sweep", "--orders", "5-10", *FLAGS), SWEEP, "rows"),
    (("sweep", "impact", "--methods", "hb,ck", "--orders", "3,5"), SWEEP_OF_IMPACT, "rows"),
    (
        ("sweep", "impact", "--vary", "gap=0.2:0.1:2", "--orders", 8),
        {"g [m]": (lambda row: row["value"], ".6g")} | FORCED | ALONG,
        "rows",
    ),
    (("simulate", "impact", "--cycles", 4, "--state", "-0.5,0.25"), PHASES, "phases"),
]


@pytest.mark.parametrize(
    ("arguments", "columns", "key"), TABLES, ids=[" ".join(map(str, q[0])) for q in TABLES]
)
def test_a_table_shows_its_document(
    run, tmp_path: Path, arguments: tuple[object, ...], columns: Columns, key: str
) -> None:
    path = tmp_path / "document.json"
    status, out, err = run(*arguments, "-o", path)
    assert (status, err) == (0, f"wrote {path}\n")
    rows = json.loads(path.read_text("utf-8"))[key]
    table = read(out.partition(f"\n{len(rows)} ok")[0], list(columns))
    exact = [cells for cells in table if cells.get("method") == "exact"]
    compare(table[len(exact) :], rows, columns)
    times = {name: columns[name] for name in {*FORCED, *STICK_SLIP} & {*columns}}
    compare(exact, [rows[0]["exact"]] if exact else [], times)
    assert bool(exact) == (arguments[0] == "solve")
    assert max(map(len, out.splitlines())) <= 80


def test_the_exact_orbit_is_above_every_method_of_the_scene(run) -> None:
    _, out, _ = run("solve", "--order", 6, *FLAGS)
    exact, *table = read(out, list(SOLVE))
    assert [cells["method"] for cells in table] == ["hb", "hb-c1", "hb-ck", "c1", "c1-tau"]
    flags = dict(zip(FLAGS[::2], FLAGS[1::2], strict=True))
    belt = ns.StickSlip(**{str(q).strip("-").replace("-", "_"): v for q, v in flags.items()})
    assert exact["T [s]"] == f"{Exact(belt).period:.9g}"
    assert exact["stick [s]"] == f"{Exact(belt).t1:.7g}"


def test_the_digits_below_the_table_of_solve_are_of_the_same_orbit(run) -> None:
    arguments = ("solve", "--method", "c1", "--order", 12, *FLAGS)
    document = json.loads(run(*arguments, "--json")[1])
    words = " ".join(
        run(*arguments)[1].partition("c1, N = 12: ")[2].partition("\n\n")[0].split()
    )
    expected = {
        "T": document["period"],
        **{q["name"]: q["duration"] for q in document["phases"]},
    }
    shown = dict(part.removesuffix(" s").split(" = ") for part in words.split(", "))
    assert list(shown) == list(expected)
    for name, digits in shown.items():
        places = len(digits.partition(".")[2])
        assert len(digits) > 9
        assert float(digits) == pytest.approx(expected[name], rel=0, abs=0.5001 * 10.0**-places)


def shown_rate(name: str) -> tuple[Callable[[Document], str], str]:
    def shown(row: Document) -> str:
        if row[name] is None:
            return "too few orders"
        power = f"{-row[name]:.3f}" if row["kind"] == "power" else f"{-row[name]:.2f}"
        return f"N^{power}" if row["kind"] == "power" else f"10^({power} N)"

    return shown, ""


def test_the_rates_of_sweep(run) -> None:
    arguments = ("sweep", "--orders", "5-10", *FLAGS)
    out, document = run(*arguments)[1], json.loads(run(*arguments, "--json")[1])
    rates: Columns = method() | {
        "times": shown_rate("times"),
        "x''": shown_rate("discontinuous"),
    }
    rows = [{"method": name} | rate for name, rate in document["rates"].items()]
    compare(read(out, list(rates)), rows, rates)
    assert [row["kind"] for row in rows] == ["power"] * 3 + ["geometric"] * 2


def test_a_row_of_sweep_without_an_orbit_says_so(run) -> None:
    arguments = ("sweep", "--methods", "c1", "--orders", "3-5", "--normal-force", 100)
    status, out, _ = run(*arguments)
    of_document, document, _ = run(*arguments, "--json")
    table, rows = read(out, list(SWEEP)), json.loads(document)["rows"]
    assert status == of_document == 1
    assert [row["order"] for row in rows] == [3, 4, 5]
    assert set(rows[1]["errors"].values()) == {rows[1]["t1"]} == {None}
    assert rows[1]["errors"].keys() == rows[2]["errors"].keys()
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
    assert len(document["roots"]) == 5
    (orbit,) = (row for row in document["roots"] if row["admissible"])
    solved = json.loads(run("solve", "--method", "c1", "--order", 7, *FLAGS, "--json")[1])
    for name in ("t1", "period", "transition_mismatch"):
        assert orbit[name] == pytest.approx(solved[name], rel=1e-8)
    for row in document["roots"]:
        assert row["slip"] == pytest.approx(row["period"] - row["t1"], rel=1e-12)


def test_the_lines_above_a_table_name_the_oscillator(run) -> None:
    out = " ".join(run("solve", "--method", "c1", "--order", 7, *FLAGS)[1].split())
    assert out.startswith(
        "stick-slip: a mass on a moving belt, stick and slip (C1) "
        "M = 0.02 kg, K = 8 N/m, V = 0.75 m/s, mu_s = 0.9, mu_k = 0.5, F_N = 1 N "
        "alpha = omega_n (mu_s - mu_k) F_N / (K V) = 1.33333 "
    )
    assert "is assumed" not in out
    assert "F_N = 400 N is assumed" in run("roots", "--order", 3)[1]


@pytest.mark.parametrize(
    ("vary", "heading"),
    [("belt-speed=0.1:10:4", "V [m/s]"), ("mu-k=0.1:0.4:4", "mu_k"), ("mass=1:9:30", "M [kg]")],
)
def test_the_table_along_a_parameter(vary: str, heading: str, run, tmp_path: Path) -> None:
    path = tmp_path / "family.json"
    arguments = ("sweep", "--vary", vary, "--methods", "c1", "--orders", 9)
    out, document = run(*arguments, "-o", path)[1], json.loads(path.read_text())
    columns: Columns = {heading: (lambda row: row["value"], ".6g")} | PERIOD | ALONG
    columns |= {name: (value, ".6g") for name, (value, _) in STICK_SLIP.items()}
    rows = document["rows"]
    out, ok, _ = out.partition(f"{len(rows)} ok")
    table = read(out, list(columns))
    assert ok
    if len(rows) > 25:  # spread from the first to the last
        shown = {cells[heading] for cells in table}
        assert len(shown) == len(table) == 25
        assert "25 of 30 points" in out
        rows = [row for row in rows if f"{row['value']:.6g}" in shown]
        assert [rows[0]["value"], rows[24]["value"]] == [1, 9]
    compare(table, rows, columns)


@pytest.mark.parametrize(
    "arguments",
    [
        ("solve", "elastic-plastic"),
        ("solve", "beam-clearance", "--modes", 4),
        ("solve", "clearance", "--force", 0.3, "--damping", 0.1, "--gap", 1, "--all"),
        ("solve", "dry-friction", "--force", 0.4, "--phases", "slide,stop,slide,stop", "--all"),
        ("sweep", "dry-friction", "--vary", "force=0.36:0.5:2", "--orders", 12),
        ("solve", "--method", "c1", "--order", 24, "--mu-k", "0.4999999"),
        ("solve", "--method", "c1", "--normal-force", "4.1234e-6", "--stiffness", "1.234e-7"),
    ],
)  # fmt: skip
def test_a_wide_table_stands_in_eighty_columns(run, arguments: tuple[object, ...]) -> None:
    """By smaller gaps, units below their headings, or in two parts; no cell is lost."""
    _, out, _ = run(*arguments)
    assert max(map(len, out.splitlines())) <= 80
    assert "estimate" in out.partition("\n\n")[2]


def test_the_parts_of_a_wide_table_have_the_same_rows(run) -> None:
    _, out, _ = run("solve", "beam-clearance", "--modes", 4)
    left, right = out.split("\n\n")[1:3]
    rows = [line.split()[:2] for line in left.splitlines()[2:]]
    assert [line.split()[:2] for line in right.splitlines()[2 : 1 + len(rows)]] == rows[1:]
    assert left.split().count("[s]") == 3
    assert right.split()[:6] == ["method", "N", "times", "x'''", "estimate", "it"]
