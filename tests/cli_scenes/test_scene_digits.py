"""``nonsmooth digits SCENE``: the table and the picture are read back from the document."""

import json

import numpy as np
import pytest
from refusals import refused

pytest.importorskip("flint")

from nonsmooth.cli import progress
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.precision import digits

ARGUMENTS = ("impact", "--methods", "hb,c0-tau", "--orders", "4,6")


@pytest.fixture
def found(monkeypatch):
    """Measurements of every kind, without the time that they take."""
    made = [
        digits.Kept("", "exact", None, "ok", 2e-16, 8.0, 2.0, 2),
        digits.Kept("", "hb", 4, "ok", 3e-16, 4e1, 2.0, 3),
        digits.Kept("", "hb", 6, "ok", 4e-13, 7e2, 2.0, 3),
        digits.Kept("", "ck-tau", 4, "ok", 5e-13, 6e4, 2.0, 3),
        digits.Kept("", "ck-tau", 6, "not-converged", None, None, 2.0, 9),
        digits.Kept("no damping", "exact", None, "no-orbit"),
        *(
            digits.Kept("no damping", m, n, "no-orbit")
            for m in ("hb", "ck-tau")
            for n in (4, 6)
        ),
    ]
    monkeypatch.setattr(digits, "measure", lambda case, orders, methods, progress: made)
    return made


def test_the_table_says_what_is_kept_and_why_not_more(run, found) -> None:
    status, out, _ = run("digits", *ARGUMENTS)
    rows = [line.split() for line in out.splitlines()]
    assert ["as", "given", "2e+00", "15.7"] in rows
    assert ["hb", "15.5", "12.4!", "7e+02"] in rows  # 2.2e-16 times 7e2 is 1.6e-13
    assert ["c0-tau", "12.3c", "-", "6e+04"] in rows
    assert ["no", "damping", "no-orbit", "-"] in rows
    assert max(map(len, out.splitlines())) <= 80
    assert "2 of 4 within 1e-13 times the orbit's condition; 1 lost without a reason" in out
    assert status == 1


def test_the_old_name_of_the_command_says_the_new_one(run, found) -> None:
    status, out, err = run("stability", *ARGUMENTS)
    assert (status, out) == run("digits", *ARGUMENTS)[:2]
    assert "nonsmooth: stability: it is now `nonsmooth digits`" in err
    assert not any(
        line.strip().startswith("stability") for line in run("--help")[1].splitlines()
    )


def test_the_document_has_every_measurement(run, found, tmp_path) -> None:
    path = tmp_path / "digits.json"
    status, out, _ = run("digits", *ARGUMENTS, "--json", "-o", path)
    document = json.loads(out)
    assert json.loads(path.read_text())["rows"] == document["rows"]
    assert (status, document["lost"], document["scene"]) == (1, True, "impact")
    assert document["parameters"]["gap"] == 0.1
    for row, kept in zip(document["rows"], found, strict=True):
        for name in ("extreme", "method", "order", "status", "error", "condition", "digits"):
            assert row[name] == getattr(kept, name)
        assert (row["met"], row["conditioned"]) == (kept.met, kept.conditioned)


def test_the_picture_has_a_map_a_method(found) -> None:
    from nonsmooth.plots.digits import digits_figure

    figure = digits_figure(registry.load("impact")(), found)
    exact, hb, tau, _ = figure.axes
    assert [axes.get_title() for axes in (exact, hb, tau)] == ["exact", "hb", "c0-tau"]
    assert [t.get_text() for t in exact.get_yticklabels()] == ["no damping", "as given"]
    assert [t.get_text() for t in hb.get_xticklabels()] == ["4", "6"]
    assert [t.get_text() for t in tau.texts] == ["-", "-", "12.3c", "-"]
    colours = np.ma.filled(hb.collections[0].get_array(), np.nan).reshape(2, 2)
    np.testing.assert_allclose(colours[1], [kept.digits for kept in found[1:3]])
    assert np.isnan(colours[0]).all()
    for axes in (exact, hb, tau):  # words can be read on their colour
        (mesh,) = axes.collections
        assert (mesh.norm.vmin, mesh.norm.vmax) == (0, 16)
        seen = mesh.cmap(mesh.norm(mesh.get_array()))[..., :3] @ (0.299, 0.587, 0.114)
        for text, light in zip(axes.texts, seen.ravel(), strict=True):
            assert text.get_text() == "-" or abs(light - float(text.get_color())) > 0.4


def test_it_measures_the_scene_at_its_extremes(run, tmp_path, monkeypatch) -> None:
    monkeypatch.setattr(progress, "QUIET", 0.0)
    picture = tmp_path / "digits.png"
    status, out, err = run("digits", "impact", "--quick", "--methods", "ck-tau", "-o", picture)
    words = [words for words, _ in digits.extremes(registry.load("impact")())[1:]]
    assert (status, [line[:2] for line in out.splitlines()].count("  ")) == (0, len(words) + 2)
    assert all(any(line.startswith(each) for line in out.splitlines()) for each in words)
    assert picture.read_bytes().startswith(b"\x89PNG")
    assert "digits: 14 of 14 done (a stop 1e-3 of the amplitude away: c0-tau, N = 10)" in err


def test_a_scene_that_names_no_extremes_is_measured_as_it_is(run, monkeypatch) -> None:
    monkeypatch.setattr(registry.load("impact").module, "EXTREMES", ())
    status, out, err = run("digits", "impact", "--orders", 4, "--methods", "hb")
    assert status == 0
    assert "nonsmooth: impact: its field `extremes` names none" in err
    assert "no damping" not in out


def test_without_python_flint_a_scene_says_how_to_install_it(run, monkeypatch) -> None:
    monkeypatch.setattr("nonsmooth.extras.find_spec", lambda name: None)
    assert "pip install 'nonsmooth[precise]'" in refused(run, "digits", "impact")
