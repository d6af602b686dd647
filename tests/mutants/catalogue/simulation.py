"""Mistakes in simulated motion: when an event happens, what follows it, where it settles."""

from ..mutant import Mutant

LOCATE = ("tests/simulation/test_locate.py",)
CHATTER = ("tests/simulation/test_chatter.py",)
SURFACES = ("tests/simulation/test_integrated.py::test_two_surfaces_are_two_however_near",)
MOTION = ("tests/simulation/test_simulate.py",)
RUN = (
    "tests/simulation/test_run.py::test_the_states_at_whole_turns_are_those_of_the_simulation",
)
SETTLE = "tests/simulation/test_settle.py"
BODIES = "tests/simulation/test_events_of_bodies.py"
CLOCK = ("tests/simulation/test_run.py::test_the_clock_loses_no_digit_behind_many_phases",)

JOINTS = "tests/scenes/test_memories_of_several_phases.py"

MUTANTS = (
    Mutant(
        "Newton's method does not start where a motion almost repeats",
        "solver/simulation/outcome.py",
        "islice(returns(cell, motion.segments, cycles), RETURNS)",
        "islice(returns(cell, motion.segments, cycles), 0)",
        ("tests/simulation/test_settle.py::test_newton_starts_where_a_motion_almost_repeats",),
    ),
    Mutant(
        "times are sums in float64",
        "solver/simulation/walk.py",
        "t = place.t + Fraction(s)",
        "t = Fraction(float(place.t) + s)",
        MOTION,
    ),
    Mutant(
        "the angle of the forcing is not reduced by whole turns",
        "solver/simulation/steps/clock.py",
        "    _, high, _ = whole_turns(high, low + clock.low)\n    return high",
        "    return high + (low + clock.low)",
        CLOCK,
    ),
    Mutant(
        "what is rounded of the angle of the forcing is lost",
        "solver/simulation/steps/clock.py",
        "whole_turns(high, rest + (clock.low + error))",
        "whole_turns(high, 0.0)",
        CLOCK + MOTION,
    ),
    Mutant(
        "a state at a whole turn is that in which its phase begins",
        "solver/simulation/steps/run.py",
        "state.angle, rules.omega, t)",
        "state.angle, rules.omega, 0.0)",
        RUN,
    ),
    Mutant(
        "two surfaces near each other are taken for one",
        "solver/scenes/mirror.py",
        "if not abs(ratio - first) <= ROUNDING * abs(first):",
        "if not abs(ratio - first) <= abs(ratio) + abs(first):",
        SURFACES,
    ),
    Mutant(
        "a switch that its event forbids is taken",
        "solver/simulation/steps/switches.py",
        "if q == refused or not follows(rules, p, ended, int(q), state):",
        "if not follows(rules, p, ended, int(q), state):",
        (f"{SETTLE}::test_a_switch_that_its_event_forbids_is_not_taken",),
    ),
    Mutant(
        "the event of a mirrored phase is not mirrored",
        "solver/scenes/mirror.py",
        "return phase.with_forms(_mirrored, **turned)",
        "turned['event'] = phase.event\n    return type(phase)(**vars(phase.with_forms(_mirrored)) | turned)",
        MOTION,
    ),
    Mutant(
        "the jumps that are left take the time of a mass that gains by them",
        "solver/simulation/steps/chatter.py",
        "remaining = -2 * v / (a * (1 + rho))",
        "remaining = -2 * v / (a * (1 - rho))",
        CHATTER,
    ),
    Mutant(
        "short phases are chatter whether they get shorter or not",
        "solver/simulation/steps/chatter.py",
        "return second <= 0.999 * first",
        "return True",
        CHATTER,
    ),
    Mutant(
        "the polynomial is raised by the bound in place of lowered",
        "solver/simulation/steps/locate.py",
        "-rest * (s4 * s / 5 * s / 6)",
        "rest * (s4 * s / 5 * s / 6)",
        LOCATE,
    ),
    Mutant(
        "negative damping is not bounded",
        "solver/simulation/steps/bounds.py",
        "growth = (-damping + length(damping, (kappa - stiffness) / root)) / 2",
        "growth = 0.0",
        LOCATE,
    ),
    Mutant(
        "the second half of an interval is looked at first",
        "solver/simulation/steps/zeros.py",
        "            row, right = halves(row)\n"
        "            width = width / 2\n"
        "            waiting.append((right, start + width, width))\n",
        "            left, row = halves(row)\n"
        "            width = width / 2\n"
        "            waiting.append((left, start, width))\n"
        "            start = start + width\n",
        LOCATE,
    ),
    Mutant(
        "the velocity does not jump",
        "solver/simulation/steps/state.py",
        "State(x, rho * v + d, end.angle",
        "State(x, v + d, end.angle",
        MOTION,
    ),
    Mutant(
        "a phase lasts for ever whatever its transient does",
        "solver/simulation/lasting.py",
        " - turning - abs(ex) * far - abs(ev) * fast",
        " - turning",
        (f"{SETTLE}::test_whether_a_phase_lasts_is_decided_at_the_edge",),
    ),
    Mutant(
        "what has not settled is a start",
        "solver/simulation/repeats.py",
        "off <= max(near * size, ROUNDING)",
        "True",
        (f"{SETTLE}::test_what_still_decays_has_not_settled",),
    ),
    Mutant(
        "a form of a body falls no further between two times than at them",
        "solver/simulation/bodies/locate.py",
        "min(left, right, inner)",
        "min(left, right)",
        (f"{BODIES}::test_a_crest_behind_many_lower_ones_is_not_stepped_over",),
    ),
    Mutant(
        "a pole of a body that resonates has no bound",
        "solver/simulation/bodies/along.py",
        "modulus = power * modulus + drive * terms",
        "modulus = 0.0",
        (f"{BODIES}::test_a_form_stays_within_its_bounds",),
    ),
    Mutant(
        "a body is not struck where it hits",
        "solver/simulation/bodies/state.py",
        "return struck(rules, laws.switching[ending], end, on_surface)",
        "return BodyState(end.y, end.angle, on_surface, end.memory)",
        ("tests/simulation/test_one_mass_as_body.py",),
    ),
    Mutant(
        "an order that is its own mirror image is half a period at any times",
        "solver/simulation/outcome.py",
        "    return abs(one - two) <= NEAR * max(one, two, 1.0)",
        "    return True",
        ("tests/bodies/test_bodies_that_move_freely.py",),
    ),
    Mutant(
        "a memory is set anew within the phases in which it holds",
        "solver/scenes/orders.py",
        "return phase in setter and before not in setter",
        "return phase in setter",
        (f"{JOINTS}::test_a_memory_is_not_set_within_the_phases_in_which_it_holds",),
    ),
    Mutant(
        "an event does not say which phase follows",
        "solver/simulation/nodes.py",
        "NONE if laws and nodes[q].law not in laws else q for q in found[p]",
        "q for q in found[p]",
        (f"{JOINTS}::test_a_simulation_settles_on_the_orbit",),
    ),
    Mutant(
        "of several phases that may follow the first is taken",
        "solver/simulation/steps/switches.py",
        "if law == NONE or (found",
        "if found == NONE or (found",
        (f"{JOINTS}::test_what_neither_demands_nor_events_decide_is_no_motion",),
    ),
    Mutant(
        "along a branch a demand has the memory of the next cell",
        "solver/branch/bodies/course.py",
        "phase: Phase = cell.carrying(p)",
        "phase: Phase = cell.phases[p]",
        (f"{JOINTS}::test_a_branch_goes_from_order_to_order",),
    ),
    Mutant(
        "a demand goes on to fall behind the event at which it falls through zero",
        "solver/simulation/followers.py",
        "if before.changes_velocity:\n        return False\n    fallen",
        "if before:\n        return False\n    fallen",
        ("tests/scenes/test_several_events.py::test_a_demand_does_not_go_on_to_fall",),
    ),
)
