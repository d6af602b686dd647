"""Printed tables of families and measurements against their own JSON, column by column."""

import json
from collections.abc import Callable
from pathlib import Path

import pytest
from printed_table import Columns, Document, compare, read

from nonsmooth.shortcuts import digits, tradeoff


@pytest.mark.parametrize(
    ("vary", "heading"),
    [("belt-speed=0.1:10:4", "V [m/s]"), ("mu-k=0.1:0.4:4", "mu_k"), ("mass=1:9:30", "M [kg]")],
)
def test_the_table_along_a_parameter(vary: str, heading: str, run, tmp_path: Path) -> None:
    path = tmp_path / "family.json"
    arguments = ("sweep", "--vary", vary, "--methods", "hb-c1,c1", "--orders", 9)
    out, document = run(*arguments, "-o", path)[1], json.loads(path.read_text())
    columns: Columns = {
        "method": (lambda row: row["method"], ""),
        "N": (lambda row: row["order"], ""),
        heading: (lambda row: row["value"], ".6g"),
        "alpha": (lambda row: row["alpha"], ".4g"),
        "T [s]": (lambda row: row["period"], ".9g"),
        "amp. [m]": (lambda row: row["amplitude"], ".7g"),
        "stick/T": (lambda row: row["stick_fraction"], ".5f"),
        "estimate": (lambda row: row["estimate"]["period"], ".1e"),
    }
    table, rows = read(out, list(columns)), document["rows"]
    if len(rows) > 50:  # 25 of each method, spread from the first to the last
        keys = {(cells["method"], cells[heading]) for cells in table}
        assert len(keys) == len(table) == 50
        rows = [row for row in rows if (row["method"], f"{row['value']:.6g}") in keys]
        assert [rows[0]["value"], rows[24]["value"]] == [1, 9]
    compare(table, rows, columns)
    for row in rows:
        assert row["stick_fraction"] == pytest.approx(row["t1"] / row["period"], rel=1e-12)
    worst = max(document["rows"], key=lambda row: row["estimate"]["period"])
    end = " ".join(out.split()).rpartition("; largest estimated error of T: ")
    flag = vary.partition("=")[0]
    assert end[2] == f"{worst['estimate']['period']:.1e}, at {flag} = {worst['value']:g}"
    assert end[0].endswith(f"{len(document['rows'])} ok")


def test_the_table_of_time_against_error(run, tmp_path: Path, monkeypatch) -> None:
    points = [
        tradeoff.Point("float64", "hb", 1, 4, None, 1.1e-4, 3.2e-2, 2.5e-2, True),
        tradeoff.Point("float64", "hb-c1", 3, 16, None, 5.2e-4, 2.3e-2, 1.4e-2),
        tradeoff.Point("float64", "c1-tau", 1, 9, None, 9.3e-3, 2.0e-14, 2.2e-14),
        tradeoff.Point("precise", "c1", 1, 24, 30, 2.6e-2, 8.7e-30, None, True),
    ]
    monkeypatch.setattr(tradeoff, "measure", lambda belt, progress: points)
    path = tmp_path / "tradeoff.json"
    out, document = run("tradeoff", "-o", path)[1], json.loads(path.read_text())
    columns: Columns = {
        "method": (lambda row: "hb-c1(3)" if row["c1_terms"] == 3 else row["method"], ""),
        "N": (lambda row: row["order"], ""),
        "digits": (lambda row: row["digits"], ""),
        "time [s]": (lambda row: row["seconds"], ".1e"),
        "T/T_ex-1": (lambda row: row["error"], ".1e"),
        "estimate": (lambda row: row["estimate"], ".1e"),
        "front": (lambda row: "*" if row["front"] else None, ""),
    }
    compare(read(out, list(columns)), document["points"], columns)
    assert max(map(len, out.splitlines())) <= 80
    assert document["points"][1] == {
        "regime": "float64",
        "method": "hb-c1",
        "c1_terms": 3,
        "order": 16,
        "digits": None,
        "seconds": 5.2e-4,
        "error": 2.3e-2,
        "estimate": 1.4e-2,
        "front": False,
    }
    assert json.loads(run("tradeoff", "--json")[1]) == document


def digits_of(form: str) -> tuple[Callable[[Document], str], str]:
    def shown(row: Document) -> str:
        found = row[form]
        text = found["status"] if found["digits"] is None else f"{found['digits']:.1f}"
        return text + ("*" if found["status"] == "helped" else "")

    return shown, ""


def test_the_table_of_digits(run, tmp_path: Path, monkeypatch) -> None:
    pytest.importorskip("flint")
    none, lost = (digits.Form(s, None, None, 3) for s in ("no-orbit", "not-converged"))
    kept, helped = digits.Form("ok", 2e-15, 3e4, 5), digits.Form("helped", 4e-9, 7e11, 8)
    cells = [
        digits.Cell("hb", 0.25, 10, kept, helped),
        digits.Cell("hb-c1", 3.0, 20, kept, lost),
        digits.Cell("c1", 1e-6, 60, none, none),
        digits.Cell("c1", 30.0, 7, helped, kept),  # the target is missed
    ]
    monkeypatch.setattr(digits, "measure", lambda grid, progress: cells)
    path = tmp_path / "digits.json"
    status, out, _ = run("digits", "-o", path)
    document = json.loads(path.read_text())
    columns: Columns = {
        "method": (lambda row: row["method"], ""),
        "alpha": (lambda row: row["alpha"], "g"),
        "N": (lambda row: row["order"], ""),
        "digits": digits_of("stable"),
        "cond": (lambda row: row["stable"]["condition"], ".0e"),
        "it": (lambda row: row["stable"]["iterations"], ""),
        "as printed": digits_of("printed"),
        "cond'": (lambda row: row["printed"]["condition"], ".0e"),
        "it'": (lambda row: row["printed"]["iterations"], ""),
        "met": (lambda row: "yes" if row["met"] else "NO", ""),
    }
    compare(read(out, list(columns)), document["rows"], columns)
    assert [row["met"] for row in document["rows"]] == [True, True, True, False]
    assert status == 1
    assert "3 of 4 cells meet their target" in out
    assert json.loads(run("digits", "--json")[1]) == document
