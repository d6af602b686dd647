"""``nonsmooth modes`` and the sweep of a structure: what they print, write and refuse."""

import csv
import json
import math
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pytest
from known import NAMES, attached

import nonsmooth as ns
from nonsmooth.cli.space.modes import structures_of, vary_of
from nonsmooth.cli.values import values_of
from nonsmooth.plots import modes as pictures
from nonsmooth.solver.space.convergence import Line, convergence
from nonsmooth.solver.space.eigenvalues.exact import exact_modes

ROTATIONAL = "beam-rotational-spring"


def rows_of(path: Path) -> list[dict[str, str]]:
    return list(csv.DictReader(path.read_text("utf-8").splitlines()))


def test_the_command_of_the_documentation(run) -> None:
    status, out, err = run(
        "modes", ROTATIONAL, "--position", "3/10", "--stiffness", "10", "--order", "8"
    )
    assert (status, err) == (0, "")
    lines = out.splitlines()
    assert lines[0] == f"{ROTATIONAL}: a beam with a rotational spring (C1)"
    assert max(map(len, lines)) <= 80
    first = next(line for line in lines if line.startswith("1 ")).split()
    exact = "1.89405287"
    assert first == ["1", exact, exact, "11.9006852", "5.9e-11", "5.9e-11", "5.5e-05"]
    fifth = next(line for line in lines if line.startswith("5 "))
    assert fifth.split()[-3:] == ["n", "=", "5"]


def test_the_document_has_what_is_promised(run) -> None:
    status, out, _ = run("modes", "beam-mass", "--method", "ritz-c2", "--json", "--count", "2")
    found = json.loads(out)
    assert status == 0
    assert (found["schema"], found["structure"], found["class"]) == (2, "beam-mass", "C2")
    assert (found["method"], found["order"], found["forced"]) == ("ritz-ck", 8, 1)
    keys = {"number", "beta", "frequency", "omega", "eigenvalue", "exact", "error", "bounds",
            "modal_mass", "jump_mismatch", "node"}  # fmt: skip
    for mode in found["modes"]:
        assert set(mode) == keys
        low, high = mode["bounds"]
        assert low <= mode["exact"]["beta"] ** 4 <= high
        assert mode["eigenvalue"] == pytest.approx(mode["beta"] ** 4, rel=1e-14)
        assert mode["frequency"] == pytest.approx(mode["beta"] ** 2 / (2 * math.pi))


def test_every_structure_by_every_method(run) -> None:
    for name in NAMES:
        status, out, _ = run("modes", name, "--method", "all", "--count", "2", "--json")
        found = json.loads(out)
        assert status == 0
        assert [each["method"] for each in found["expansions"]] == ["ritz", "ritz-ck", "ck"]
        for each in found["expansions"][1:]:
            assert max(abs(mode["error"]) for mode in each["modes"]) < 1e-4


def test_so_many_forced_modes_as_are_asked_for(run) -> None:
    """By the method that is meant where none is named; of all methods, by the one with them."""
    for how in ((), ("--method", "all")):
        _, out, _ = run("modes", "beam-mass", "--forced", "2", *how, "--count", "1", "--json")
        found = json.loads(out)
        (own,) = (q for q in found.get("expansions", [found]) if q["method"] == "ritz-ck")
        assert own["forced"] == 2
        assert own["modes"][0]["beta"] == ns.modes("beam-mass", forced=2, count=1)[0].beta


def test_frequencies_are_in_hertz_and_scale_with_the_units(run) -> None:
    """A beam of 2 m, and the same in centimetres."""
    beam = {"length": 2.0, "bending_stiffness": 1.7e4, "mass_per_length": 7.85, "mass": 3.0}
    found = ns.modes("beam-mass", position="1/4", **beam)
    unit = math.sqrt(1.7e4 / 7.85) / 2.0**2 / (2 * math.pi)
    one = attached("beam-mass", "1/4", 3.0 / (7.85 * 2.0))
    wanted = exact_modes(one, 6).beta ** 2 * unit
    np.testing.assert_allclose([mode.frequency for mode in found], wanted, rtol=1e-4)
    centimetres = beam | {
        "length": 200.0,
        "bending_stiffness": 1.7e10,
        "mass_per_length": 0.0785,
    }
    other = ns.modes("beam-mass", position="1/4", **centimetres)
    assert other[3].frequency == pytest.approx(found[3].frequency, rel=1e-13)
    heavier = ns.modes("string-spring", tension=9.0)
    assert heavier.attached.s == pytest.approx(10 / 9)


def test_a_case_file_names_the_structure(run, tmp_path) -> None:
    file = tmp_path / "beam.toml"
    file.write_text('[beam_crack]\nposition = "1/3"\ncompliance = 0.5\n', encoding="utf-8")
    by_file = run("modes", "--case", file, "--count", "3")
    by_flags = run(
        "modes", "beam-crack", "--position", "1/3", "--compliance", "0.5", "--count", "3"
    )
    assert by_file == by_flags
    assert run("sweep", "--case", file, "--orders", "2,3")[0] == 0
    overridden = run("modes", "--case", file, "--compliance", "2", "--json")
    assert json.loads(overridden[1])["parameters"]["compliance"] == 2.0


def test_a_tolerance_takes_the_lowest_order_within_it(run) -> None:
    status, out, _ = run("modes", "string-mass", "--tol", "1e-6", "--count", "2", "--json")
    found = json.loads(out)
    assert status == 0
    within = [math.sqrt(high / low) - 1 for low, high in (m["bounds"] for m in found["modes"])]
    assert max(within) < 1e-6
    below = ns.modes("string-mass", order=found["order"] - 1, count=2)
    assert max(mode.proved_within for mode in below) > 1e-6
    assert ns.modes("beam-crack", "ck", tol=1e-9, count=2)[1].error < 1e-9
    with pytest.raises(ns.ToleranceNotMet, match="no order of ritz is within it; order 4096"):
        ns.modes("string-mass", "ritz", tol=1e-9, count=1)
    assert (
        run("modes", "string-mass", "--method", "ritz", "--tol", "1e-9", "--count", "1")[0] == 1
    )


def test_a_sweep_prints_errors_and_rates(run, tmp_path) -> None:
    target = tmp_path / "rows.csv"
    status, out, _ = run(
        "sweep", "string-mass", "--orders", "8,16,32", "--forced", "1,2", "-o", target
    )
    assert status == 0
    rates = out.split("from N = 4 on above rounding:")[1].splitlines()
    wanted = {"ritz": "-1", "ritz-c0": "-5", "ritz-c0(2)": "-9"}
    found = {line.split()[0]: line.split()[-1] for line in rates if line.split()}
    assert wanted.items() <= found.items()
    rows = rows_of(target)
    assert [row["order"] for row in rows] == ["8", "16", "32"] * 4
    forced = [row for row in rows if row["forced"] == "1"]
    assert float(forced[0]["eigenvalue_error"]) == pytest.approx(1.9e-9, rel=0.1)
    assert run("sweep", "beam-mass", "--orders", "1,2", "--mode", "40")[0] == 1
    status, out, _ = run("sweep", "string-mass", "--orders", "2", "--json")
    assert {row["method"] for row in json.loads(out)["rows"]} == {"ritz", "ritz-ck", "ck"}


def test_modes_over_the_position(run, tmp_path) -> None:
    target = tmp_path / "family.csv"
    status, out, _ = run(
        "modes", "beam-mass", "--vary", "position=1/10:1/2:5", "--count", "2", "-o", target
    )
    assert status == 0
    assert [line.split()[0] for line in out.splitlines()[-5:]] == [
        "1/10",
        "1/5",
        "3/10",
        "2/5",
        "1/2",
    ]
    rows = rows_of(target)
    assert len(rows) == 10
    assert float(out.split()[-2]) == pytest.approx(float(rows[-1]["omega"]), rel=1e-7)
    assert rows[-1]["node"] == "2"  # recognised, though 1/2 is the fifth of five values
    status, out, _ = run("modes", "beam-mass", "--vary", "mass=1:100:3", "--log", "--json")
    assert [point["value"] for point in json.loads(out)["points"]] == [1.0, 10.0, 100.0]


def test_sines_on_a_crack_are_said_to_be_of_the_sound_beam(run) -> None:
    _, _, err = run("modes", "beam-crack", "--method", "ritz")
    assert err == "nonsmooth: ritz: sines have no jump: these are the modes of the sound beam\n"


def test_the_list_of_structures(run) -> None:
    status, out, _ = run("modes")
    assert status == 0
    assert all(name in out for name in NAMES)
    listed = json.loads(run("modes", "--json")[1])["structures"]
    assert [each["name"] for each in listed] == list(ns.structures())


def test_help_loads_nothing_heavy(python) -> None:
    code = """
import sys
from nonsmooth.cli import main
for words in (["modes"], ["modes", "beam-mass", "--help"], ["sweep", "beam-mass", "-h"]):
    try:
        main(words)
    except SystemExit as end:
        assert not end.code
print([q for q in ("sympy", "numba", "numpy", "matplotlib") if q in sys.modules])
"""
    assert python(code).splitlines()[-1] == "[]"


def test_computing_modes_needs_neither_sympy_nor_numba(python) -> None:
    code = "import sys, nonsmooth as ns; ns.modes('beam-crack', forced=3)\n"
    code += "print([q for q in ('sympy', 'numba', 'matplotlib') if q in sys.modules])"
    assert python(code) == "[]\n"


def test_the_moment_of_the_sines_swings_and_that_of_the_others_does_not() -> None:
    expansions = [ns.modes(ROTATIONAL, q, 16) for q in ("ritz", "ritz-ck", "ck")]
    figure = pictures.modes_figure(expansions)
    assert len(figure.axes) == 12
    moments = figure.axes[1]
    assert moments.get_ylabel() == "moment [N]"
    drawn = [np.array(line.get_data()) for line in moments.lines if len(line.get_xdata()) > 2]
    exact, *others = drawn
    jump = (
        exact[1][np.nanargmin(np.abs(exact[0] - 0.3001))]
        - exact[1][np.nanargmin(np.abs(exact[0] - 0.2999))]
    )
    off = [np.nanmax(np.abs(each[1] - exact[1])) / abs(jump) for each in others]
    assert off[0] > 0.4  # at the jump itself half of it
    assert max(off[1:]) < 1e-4
    plt.close(figure)


def test_all_modes_that_were_asked_for_are_drawn() -> None:
    """One below the other down the columns, and shape beside slope."""
    for count, columns in ((1, 2), (6, 2), (7, 4)):
        modes = ns.modes("string-mass", order=32, count=count)
        figure = pictures.modes_figure([modes])
        assert len(figure.axes) == 2 * count
        assert {axes.get_gridspec().ncols for axes in figure.axes} == {columns}
        shapes = [axes for axes in figure.axes if axes.get_ylabel().startswith("mode")]
        by_place = sorted(shapes, key=lambda q: (q.get_position().x0, -q.get_position().y0))
        found = [axes.get_ylabel() for axes in by_place]
        assert found == [f"mode {number}" for number in range(1, count + 1)]
        for mode, axes in zip(modes, by_place, strict=True):
            np.testing.assert_allclose(
                axes.lines[1].get_ydata(), mode.shape(axes.lines[1].get_xdata())
            )
        plt.close(figure)


def test_more_modes_than_a_picture_shows_are_refused(run, tmp_path) -> None:
    arguments = ("modes", "string-mass", "--order", "128", "--count", "101")
    status, _, err = run(*arguments, "-o", tmp_path / "modes.svg")
    assert (status, err.strip()) == (
        2, "nonsmooth: --count: got 101, expected at most 100 in a picture"
    )  # fmt: skip
    assert not (tmp_path / "modes.svg").exists()


def test_what_the_pictures_of_a_study_show() -> None:
    study = convergence(attached("beam-mass"), [Line("ritz"), Line("ritz-ck", 2)], (2, 4, 8))
    figure = pictures.convergence_figure(study)
    errors = figure.axes[0].lines[0].get_ydata()
    np.testing.assert_allclose(errors, [abs(row.eigenvalue_error) for row in study.rows[:3]])
    assert list(figure.axes[0].lines[1].get_xdata()) == [4, 6, 10]
    along = vary_of("position=1/4:1/2:2", False, attached("beam-mass"))
    found = [ns.modes(each, count=2) for each in structures_of(along, attached("beam-mass"))]
    family = pictures.family_figure(along.flag, values_of(along), found)
    assert family.axes[0].lines[1].get_ydata()[-1] == pytest.approx((2 * np.pi) ** 2)


@pytest.mark.parametrize(
    "arguments",
    [
        ("modes", "string-mass", "--count", "1"),
        ("modes", "string-mass", "--vary", "mass=1:2:2"),
        pytest.param(("sweep", "string-mass", "--orders", "2,3"), marks=pytest.mark.long),
    ],
)
def test_pictures_are_written(run, tmp_path, arguments: tuple[str, ...]) -> None:
    target = tmp_path / "picture.svg"
    status, _, err = run(*arguments, "-o", target)
    assert (status, f"wrote {target}" in err) == (0, True)
    assert target.read_text("utf-8").startswith("<?xml")


def test_python_refuses_what_the_command_line_refuses() -> None:
    with pytest.raises(ns.UnknownStructure, match="did you mean string-mass"):
        ns.modes("string-mas")
    with pytest.raises(ns.ParameterError, match="colour: unknown"):
        ns.modes("string-mass", colour=1)
    for place in (0.0, 1.0, True, None, "x", math.nan, "1e999999999", "1e-999999999"):
        with pytest.raises(ns.ParameterError, match="position: got"):
            ns.modes("string-mass", position=place)
    for count in (513, 600):  # orders up to 512 have 513 modes
        with pytest.raises(ValueError, match=r"count: got 600|no order of ritz-c0 is within"):
            ns.modes("string-mass", count=count, tol=1e-3)
    found = ns.modes("string-mass", count=2)
    assert found[0].shape([[0.1, 0.2], [0.3, 0.4]]).shape == (2, 2)
    for derivative in (-1, 3, 1.5):
        with pytest.raises(ValueError, match=f"derivative: got {derivative}, expected a whole"):
            found[0].shape(0.1, derivative)
    with pytest.raises(ValueError, match="parameters beside it"):
        ns.modes(found.attached, mass=3.0)
    again = ns.modes(found.attached, "ck", 12, count=2)
    assert again[0].beta == pytest.approx(found[0].beta, rel=1e-8)
    head = "<2 modes of string-mass by c0, N = 12: "
    assert repr(again) == f"{head}{again[0].frequency:.10g} to {again[1].frequency:.10g} Hz>"
    assert [mode.number for mode in again[:2]] == [1, 2]
