"""Springs of negative stiffness: down to the critical one, at which a frequency is lost."""

import json
from fractions import Fraction

import mpmath as mp
import numpy as np
import pytest
from known import SPRINGS, attached, critical, lower, receptance

import nonsmooth as ns
from nonsmooth.solver.space.attached import attach
from nonsmooth.solver.space.eigenvalues.exact import exact_modes
from nonsmooth.solver.space.modes import at_order
from nonsmooth.solver.space.structure import load

PLACES = ("1/4", "1/2", "2/3", "0.0003", "0.9997")
EXPANSIONS = (("ritz", 16, 0), ("ritz-ck", 8, 1), ("ritz-ck", 16, 3), ("ck", 8, 0))


@pytest.mark.parametrize("place", PLACES)
@pytest.mark.parametrize("name", SPRINGS)
def test_the_critical_stiffness_is_that_of_statics(name: str, place: str) -> None:
    """The load that holds a unit of the felt derivative: the receptance at rest, inverted."""
    one = attached(name, place, 1.0)
    with mp.workdps(60):
        at_rest = receptance(one, mp.mpf(10) ** -9)
        assert float(-1 / at_rest) == pytest.approx(float(critical(name, one.a)), rel=1e-15)
    assert one.critical == pytest.approx(float(critical(name, one.a)), rel=1e-15)
    # the work of a unit moment or force along the static answer, by three different units
    scaled = attach(load(name), place, length=3.0, stiffness=2.0)
    power = {"beam-spring": 3, "beam-rotational-spring": 1, "string-spring": 1}[name]
    assert scaled.critical == pytest.approx(one.critical / 3.0**power, rel=1e-15)


@pytest.mark.parametrize("place", PLACES)
@pytest.mark.parametrize("name", SPRINGS)
def test_at_the_critical_stiffness_and_beyond_it_is_named(name: str, place: str) -> None:
    value = float(critical(name, Fraction(place)))
    for stiffness in (value, 1.001 * value, 100 * value):
        with pytest.raises(ns.ParameterError) as caught:
            ns.modes(name, position=place, stiffness=stiffness)
        (error,) = caught.value.errors
        assert error.startswith(
            f"stiffness: got {stiffness!r}, expected more than the critical"
        )
        assert f"{value:.12g} N" in error
    assert ns.modes(name, position=place, stiffness=0.999 * value, count=1)[0].beta > 0


@pytest.mark.parametrize("name", SPRINGS)
@pytest.mark.parametrize("method", EXPANSIONS)
def test_the_lowest_eigenvalue_goes_to_zero(name: str, method: tuple[str, int, int]) -> None:
    """Like what is left of the stiffness, which keeps its digits; of sines it stays above."""
    for place in ("1/4", "1/2", "0.0003"):  # at a node and beside an end
        whole, last = critical(name, Fraction(place)), np.inf
        for part in (1e-2, 1e-5, 1e-8, 1e-12):
            one = attached(name, place, float(whole) * (1 - part))
            mode = at_order(one, *method, 1)[0]
            assert 0 < mode.eigenvalue <= last
            assert lower(one, mode.bounds[1]) >= 1
            if method[0] == "ritz":
                continue
            assert mode.eigenvalue < last
            last = mode.eigenvalue
            assert abs(mode.error) < 1e-7 or part > 1e-6
            assert lower(one, last * (1 - 2 * abs(mode.error) - 1e-12)) == 0
        if method[0] == "ritz-ck":
            left = float(1 - Fraction(one.s) / whole)
            slope = mode.eigenvalue / left
            half = attached(name, place, float(whole) * (1 - 1e-10))
            other = at_order(half, *method, 1)[0].eigenvalue
            assert other / float(1 - Fraction(half.s) / whole) == pytest.approx(slope, rel=1e-6)


@pytest.mark.parametrize("name", SPRINGS)
def test_a_negative_stiffness_lowers_all_eigenvalues(name: str) -> None:
    weak, strong = (
        exact_modes(attached(name, "3/10", float(critical(name, Fraction(3, 10))) * part), 8)
        for part in (0.2, 0.9)
    )
    bare = weak.attached.bare(np.arange(1, 9))
    felt = ~weak.untouched
    assert (strong.eigenvalues <= weak.eigenvalues).all()
    assert (strong.eigenvalues[felt] < weak.eigenvalues[felt]).all()
    assert (weak.eigenvalues[felt] < bare[felt]).all()
    assert (strong.eigenvalues[1:] > bare[:-1] * (1 - 1e-14)).all()


def test_commands_and_files_take_a_negative_stiffness(run, tmp_path) -> None:
    path = tmp_path / "modes.json"
    spring = ("modes", "beam-spring", "--position", "1/4")
    status, _, err = run(*spring, "--stiffness", "-85.3333", "--json", "-o", path)
    assert (status, err) == (0, f"wrote {path}\n")
    found = ns.modes("beam-spring", position="1/4", stiffness=-85.3333)
    modes = json.loads(path.read_text("utf-8"))["modes"]
    assert [mode["eigenvalue"] for mode in modes] == [mode.eigenvalue for mode in found]
    assert found[0].bounds[0] < found[0].eigenvalue < found[0].bounds[1]
    assert lower(found.attached, found[0].bounds[0]) == 0
    varied = (*spring, "--vary", "stiffness=-80:80:4", "--count", "2")
    points = json.loads(run(*varied, "--json")[1])["points"]
    first = [point["modes"][0]["beta"] for point in points]
    assert sorted(first) == first
    assert first[1] < np.pi < first[2]
    assert run(*varied, "-o", tmp_path / "family.svg")[0] == 0
    sweep = ("sweep", "string-spring", "--stiffness", "-4.7", "--orders", "4,8")
    assert run(*sweep)[0] == 0
