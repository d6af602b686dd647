"""What float64 keeps at the extremes of every scene, and what is said where it loses."""

import numpy as np
import one_mass
import pytest
import sympy as sp

pytest.importorskip("flint")

from nonsmooth.solver.exact import exact_orbit
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.precision import digits
from nonsmooth.solver.precision.digits import condition
from nonsmooth.solver.scenes.parameter_error import ParameterError

#: ck-tau has singular equations for orbits that are their own reflection in time.
SINGULAR = {("clearance", "no damping", "ck-tau")}

#: Where the one function of hb-c1 hardly differs from the harmonics, and rounding of its many
#: sums comes to several times what the condition of its equations says of one rounding.
DEPENDENT = {(f"alpha = 1e{n}", "hb-c1") for n in (2, 4, 6)}

#: Where the search for the exact orbit takes seconds.
COSTLY = {"a spring 1e6 times as stiff", "an element 1e3 times as stiff"}

EXTREMES = [
    pytest.param(
        *(scene, words, case),
        id=f"{scene}: {words or 'as given'}",
        marks=pytest.mark.long if words in COSTLY else [],
    )
    for scene in one_mass.NAMES
    for words, case in digits.extremes(registry.load(scene)())
]


def case_at(scene, words, **values):
    return dict(digits.extremes(registry.load(scene)(**values)))[words]


@pytest.mark.parametrize(("scene", "words", "case"), EXTREMES)
def test_the_times_keep_the_digits_that_the_orbit_leaves(scene, words, case) -> None:
    exact, *found = digits.at(words, case, (10,), ("hb", "ck-tau"))
    assert exact.status == "ok"
    assert exact.met, exact
    for kept in found:
        assert not kept.lost, kept
        if (scene, words, kept.method) in SINGULAR:
            assert kept.status == "not-converged"
        elif kept.method == "ck-tau":
            assert kept.met, kept


def test_a_scene_of_several_motions_is_measured() -> None:
    case = registry.load("dry-friction")()
    found = digits.measure(case, (10,), ("ck-tau",))
    assert len(found) == 2 * len(digits.extremes(case))
    assert {kept.status for kept in found} == {"ok"}


@pytest.mark.long
@pytest.mark.parametrize(("scene", "words", "case"), EXTREMES)
def test_what_any_method_loses_is_explained_by_its_condition(scene, words, case) -> None:
    lost = [kept for kept in digits.at(words, case, digits.ORDERS) if kept.lost]
    known = [kept for kept in lost if (words, kept.method) in DEPENDENT]
    assert lost == known
    assert all(kept.error <= 10 * digits.EPSILON * kept.condition for kept in known)


def test_a_slip_that_ends_where_it_began_keeps_its_end() -> None:
    """Stick for 3e-7 of the period; the difference of two speeds would leave four digits."""
    for scene, words in [("stick-slip", "alpha = 1e-6")] + [
        ("stick-slip-damped", f"alpha = {alpha}, no damping") for alpha in ("1e-6", "1e-4")
    ]:
        (exact,) = digits.at(words, case_at(scene, words), (), ())
        assert exact.condition > 1e4
        assert exact.error < 1e-15


def test_the_extremes_are_what_they_say() -> None:
    slow = [
        exact_orbit(case_at("impact", f"{part} before grazing")) for part in ("1e-4", "1e-8")
    ]
    speeds = [orbit.phases[0].velocity / orbit.extremes["velocity"][1] for orbit in slow]
    assert (np.abs(speeds) < [1.1e-4, 1.1e-8]).all()
    assert speeds[0] / speeds[1] == pytest.approx(1e4, rel=1e-3)
    rest = exact_orbit(case_at("dry-friction", "rest for 99.9 % of the time"))
    assert 2 * rest.durations[1] / rest.period == pytest.approx(0.9987, abs=1e-4)
    plastic = exact_orbit(
        case_at("elastic-plastic", "a yield force 1e-10 below the elastic one")
    )
    assert 1e-5 < plastic.durations[1] < 3e-5
    play = exact_orbit(case_at("backlash", "a play 1e-3 as wide"))
    assert play.case.values["gap"] / play.extremes["displacement"][1] < 1e-3
    contact = case_at("clearance", "a contact 1e6 times as stiff")
    assert contact.values["contact_stiffness"] == 1e6 * contact.values["stiffness"]
    assert case_at("impact", "hardly any rebound").values["restitution"] == 0.05


def test_an_extreme_starts_from_the_parameters_that_are_given() -> None:
    case = case_at("stick-slip", "alpha = 1e2", mass=3.0, mu_s=0.75)
    values = case.values
    assert values["mass"] == 3.0
    drop = (values["mu_s"] - values["mu_k"]) * values["normal_force"]
    alpha = drop / np.sqrt(values["stiffness"] * values["mass"]) / values["belt_speed"]
    assert alpha == pytest.approx(100, rel=1e-14)


def test_parameters_that_have_no_extremes_are_named() -> None:
    with pytest.raises(ParameterError, match="extremes: no numbers"):
        digits.extremes(registry.load("stick-slip")(mu_k=0.5))


def test_the_condition_of_an_orbit_against_its_closed_form() -> None:
    """Section 2 of the paper: the times in the parameters, differentiated by SymPy."""
    M, K, V, s, k, F = symbols = sp.symbols("M K V mu_s mu_k F_N", positive=True)
    drop, omega = (s - k) * F, sp.sqrt(K / M)
    times = (2 * drop / (K * V), (sp.pi + 2 * sp.atan(K * V / (omega * drop))) / omega)
    case = registry.load("stick-slip")()
    values = dict(zip(symbols, case.values.values(), strict=True))
    moved = [
        sum(abs((q * sp.diff(time, q)).subs(values).evalf()) for q in symbols) for time in times
    ]
    expected = max(moved) / sum(time.subs(values).evalf() for time in times)
    assert condition(exact_orbit(case)) == pytest.approx(float(expected), rel=1e-6)


def test_a_condition_counts_the_phase_of_the_forcing_as_a_time() -> None:
    """Impact without damping at twice the natural frequency: phi answers, no duration does."""
    orbit = exact_orbit(registry.load("impact")())
    values, step = dict(orbit.case.values), 1e-6
    total = 0.0
    for name, value in values.items():
        if name == "frequency":  # the unit of time: its own change is seen in the others
            continue
        ends = [
            exact_orbit(registry.load("impact")(**values | {name: value * (1 + q)})).angle
            for q in (step, -step)
        ]
        total += abs(ends[0] - ends[1]) / (2 * step) / (2 * np.pi)
    assert condition(orbit) > 0.9 * total


def test_what_is_met_and_what_is_lost() -> None:
    kept = digits.Kept("", "hb", 5, "ok", 5e-13, 1e6, 10.0, 3)
    assert (kept.target, kept.met, kept.conditioned, kept.lost) == (1e-12, True, True, False)
    kept = digits.Kept("", "hb", 5, "ok", 5e-13, 1e6, 1.0, 3)
    assert (kept.target, kept.met, kept.conditioned, kept.lost) == (1e-13, False, True, False)
    kept = digits.Kept("", "hb", 5, "ok", 5e-13, 1e3, 0.1, 3)
    assert (kept.target, kept.met, kept.conditioned, kept.lost) == (1e-13, False, False, True)
    none = digits.Kept("", "hb", 5, "not-converged")
    assert (none.met, none.conditioned, none.lost, none.digits) == (None, None, False, None)


def test_an_extreme_without_an_orbit_is_said_to_have_none() -> None:
    case = registry.load("impact")(gap=100.0)
    found = list(digits.at("far", case, (5, 10), ("ck-tau",)))
    assert [(kept.method, kept.order, kept.status) for kept in found] == [
        ("exact", None, "no-orbit"), ("ck-tau", 5, "no-orbit"), ("ck-tau", 10, "no-orbit"),
    ]  # fmt: skip
