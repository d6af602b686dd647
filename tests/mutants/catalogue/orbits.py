"""Mistakes in orbits: exact flow, scan, iteration, what is an orbit, estimates, stability."""

from ..mutant import Mutant

FLOW = ("tests/flow/test_flow.py",)
SCAN = ("tests/existence/test_two_phases.py",)
NONE = ("tests/existence/test_existence.py",)
ITERATION = "tests/kernels/test_iteration_scenes.py"
WRONG = ("tests/orbit/test_never_wrong.py",)
SINGLE = ("tests/maps/test_single_unknown.py",)

TOGETHER = ("tests/maps/test_together.py",)
ORBITS = "tests/orbit/test_orbit_scenes.py"
MULTIPLIERS = ("tests/stability/test_multipliers.py",)
BALLS = ("tests/precision/test_balls.py",)
DIGITS = "tests/precision/test_digits_of_scenes.py"
PAPER = ("tests/accuracy/test_kim_perkins.py",)
BRANCHES = "tests/branch/test_branches_of_bodies.py"
ENDS = "tests/branch/test_ends_of_branches.py"
EIGENBASES = "tests/branch/test_eigenbases.py"
EVENTS = "tests/branch/test_events.py"
LARGE = "tests/bodies/test_large_and_free_bodies.py"
BALLS_OF_BODIES = "tests/precision/test_digits_of_bodies.py"

MUTANTS = (
    Mutant(
        "the end of a phase moves with the forcing the other way",
        "solver/flow/responses.py",
        "return x.real, v.real, -x.imag",
        "return x.real, v.real, x.imag",
        FLOW,
    ),
    Mutant(
        "divided differences of near nodes without their odd terms",
        "solver/flow/divided.py",
        "last, now, product * before - pairs * last",
        "last, now, -pairs * last",
        FLOW,
    ),
    Mutant(
        "the change of the velocity without its own digits",
        "solver/flow/responses.py",
        "less_v = expm1(large * s) + small * impulse",
        "less_v = exp(large * s) - 1 + small * impulse",
        (f"{DIGITS}::test_a_slip_that_ends_where_it_began_keeps_its_end",),
    ),
    Mutant(
        "the exact end of a phase does not move with the memory",
        "solver/flow/exact_system.py",
        "gained_by[p, 0, 2], gained_by[p, 1, 2] = unit_x, unit_v",
        "gained_by[p, 0, 2], gained_by[p, 1, 2] = 0.0, 0.0",
        (f"{WRONG[0]}::test_the_jacobian_of_the_exact_equations_with_a_memory",),
    ),
    Mutant(
        "one phase: both solutions on the circle are the same",
        "solver/existence/one_phase.py",
        "at = (large / a, c / large if large else 0.0)",
        "at = (large / a, large / a)",
        NONE,
    ),
    Mutant(
        "scan: the second phase begins where the first does",
        "solver/existence/two_phases.py",
        "np.exp(1j * omega * begin)",
        "np.exp(0j * omega * begin)",
        SCAN,
    ),
    Mutant(
        "scan: half a period is not mirrored",
        "solver/existence/two_phases.py",
        "law = sign * np.array",
        "law = 1 * np.array",
        SCAN,
    ),
    Mutant(
        "scan: the memory does not move the events",
        "solver/existence/two_phases.py",
        "A[:, row, by_memory] += np.array(factors)",
        "pass",
        SCAN,
    ),
    Mutant(
        "roots: parts in which two functions may meet are left out",
        "solver/existence/enclosure.py",
        "far = np.abs(np.abs(D) - np.hypot(P, Q)) > change + error[which]",
        "far = np.abs(np.abs(D) - np.hypot(P, Q)) > 0.1 * change",
        SCAN,
    ),
    Mutant(
        "roots: the list is complete though rounding hides some",
        "solver/existence/enclosure.py",
        "return self.resolved and not len(self.doubtful)",
        "return self.resolved",
        SCAN,
    ),
    Mutant(
        "roots: the list is complete though a function is not resolved",
        "solver/existence/enclosure.py",
        "resolved, fine = bool(fine.all()), np.ones_like(fine)",
        "fine = np.ones_like(fine)",
        SCAN,
    ),
    Mutant(
        "of two orbits the unstable one is returned",
        "solver/existence/known.py",
        "key=lambda q: q.stable is not True",
        "key=lambda q: q.stable is True",
        (f"{WRONG[0]}::test_of_two_orbits_the_stable_one_is_returned_and_the_other_named",),
    ),
    Mutant(
        "linear systems without exchanges of rows",
        "solver/iteration/linear.py",
        "if abs(A[i, k]) > abs(A[pivot, k]):",
        "if False:",
        ("tests/kernels/test_linear.py",),
    ),
    Mutant(
        "the last correction is not taken",
        "solver/iteration/iteration.py",
        "add(z, 1.0, following, z)",
        "add(z, 0.0 if converged else 1.0, following, z)",
        (f"{ITERATION}::test_a_jacobian_is_not_used_where_corrections_shrink_slowly",),
    ),
    Mutant(
        "one unknown: factors of the product keep their sign",
        "solver/iteration/single.py",
        "product *= -points",
        "product *= points",
        SINGLE,
    ),
    Mutant(
        "the duration of a held phase that one condition gives is counted from the other end",
        "solver/maps/alone.py",
        "(sign * y[at[q]] - y[at[p]])",
        "(y[at[p]] - sign * y[at[q]])",
        ("tests/existence/test_roots.py",),
    ),
    Mutant(
        "of two full columns the second is that of the first row alone",
        "solver/maps/series.py",
        "room[PAD + low, FULL + 1] += tables[p, low, 1] * second",
        "room[PAD + low, FULL + 1] += 0.0",
        TOGETHER,
    ),
    Mutant(
        "rows of a band are never exchanged",
        "solver/maps/band.py",
        "if LARGE * abs(diagonal) <",
        "if 1e300 * abs(diagonal) <",
        ("tests/maps/test_band.py",),
    ),
    Mutant(
        "the phase of the forcing goes the long way round",
        "solver/orbit/errors.py",
        "turn = math.remainder(motion.angle - angle, 2 * math.pi)",
        "turn = motion.angle - angle",
        (f"{ORBITS}::test_errors_of_the_forcing_phase_go_the_short_way_round",),
    ),
    Mutant(
        "any better solution is taken for an orbit",
        "solver/accuracy/estimate.py",
        "return change.times <= SAME and change.discontinuous <= SAME_DERIVATIVE",
        "return True",
        (f"{ORBITS}::test_a_far_better_solution_has_to_be_an_orbit",),
    ),
    Mutant(
        "an estimate leaves out what rounding of the exact equations does",
        "solver/accuracy/estimate.py",
        "EPSILON * condition(near)",
        "EPSILON",
        ("tests/accuracy/test_estimate.py::test_near_a_fold_the_estimate_holds",),
    ),
    Mutant(
        "the exact equations in balls without the damping",
        "solver/precision/exact_balls.py",
        "-arb(phase.c) / m",
        "arb(0) / m",
        BALLS,
    ),
    Mutant(
        "a wide ball counts as digits",
        "solver/precision/refine.py",
        "if not rounding < goal / 10:",
        "if False:",
        BALLS,
    ),
    Mutant(
        "the saltation of an impact with the other sign",
        "solver/stability/cell_map.py",
        "jump += after - np.dot(saltation, before)",
        "jump += after + np.dot(saltation, before)",
        MULTIPLIERS,
    ),
    Mutant(
        "the mirror image is forgotten at the end of the cell",
        "solver/stability/cell_map.py",
        "sign, cosine_rate = cell[0] if q == 0 else 1.0, ",
        "sign, cosine_rate = 1.0, ",
        MULTIPLIERS,
    ),
    Mutant(
        "the multipliers of half a period for those of a whole",
        "solver/stability/stability.py",
        "values, remaining = eigenvalues**2 if twice else eigenvalues, ",
        "values, remaining = eigenvalues, ",
        MULTIPLIERS,
    ),
    Mutant(
        "at the boundary an orbit is called stable",
        "solver/stability/stability.py",
        "None if abs(self.margin) <= self.rounding else self.margin > 0",
        "self.margin > -1e-9",
        MULTIPLIERS,
    ),
    Mutant(
        "of the paper: the coefficient of the printed g1 with one power of T less",
        "src/nonsmooth/kim_perkins.py",
        "(self.durations[1], -3), (self.period, -1)",
        "(self.durations[1], -3), (self.period, 0)",
        PAPER,
    ),
    Mutant(
        "of the paper: the signs of the powers of (15)",
        "src/nonsmooth/kim_perkins.py",
        "float((-1) ** (n + k) * math.comb(n, k)",
        "float((-1) ** n * math.comb(n, k)",
        PAPER,
    ),
    Mutant(
        "of the paper: (22) is integrated over the jumps of the orbit",
        "solver/orbit/errors.py",
        "(_switches(motion), _switches(reference))",
        "(_switches(reference), _switches(reference))",
        PAPER,
    ),
    Mutant(
        "of the paper: all solutions of (18) to (20) for the other sign of alpha",
        "src/nonsmooth/all_solutions.py",
        "coefficients += [exact * D, -E]",
        "coefficients += [exact * D, E]",
        ("tests/existence/test_roots.py",),
    ),
    Mutant(
        "of the paper: (12) is shown without its ramp",
        "codegen/equations/conditions/one_function.py",
        "u**2 * (3 - 2 * u) - t / T",
        "u**2 * (3 - 2 * u)",
        ("tests/equations/test_shown_equations.py",),
    ),
    Mutant(
        "a doubled orbit is judged with the cycles of the case",
        "solver/branch/orders/itinerary.py",
        "is_own = scene == case.scene and case.cycles == self.cycles",
        "is_own = scene == case.scene",
        (f"{BRANCHES}::test_an_orbit_that_loses_an_impact_keeps_its_cycles",),
    ),
    Mutant(
        "a phase of a body that begins where it ends has its event undivided",
        "solver/branch/bodies/equations.py",
        "event_row = events[p] @ (Y if divided[p] == 0 else gain / s)",
        "event_row = events[p] @ Y",
        (f"{BRANCHES}::test_contact_ends_in_the_linear_response_and_begins_there",),
    ),
    Mutant(
        "multipliers of a body outside the unit circle are not counted",
        "solver/branch/bodies/equations.py",
        "least_factors(values + 1), outside(values)",
        "least_factors(values + 1), 0.0",
        (f"{BRANCHES}::test_where_multipliers_leave_the_unit_circle",),
    ),
    Mutant(
        "what happens next to a change of the order is left out",
        "solver/branch/branch.py",
        "[*reversed(back.events[:-1])]",
        "[]",
        (
            "tests/branch/test_events.py::"
            "test_close_to_each_grazing_of_a_damped_mass_there_is_a_flip",
        ),
    ),
    Mutant(
        "an orbit that begins with another of its phases is another one",
        "solver/existence/known.py",
        "[*phases[i:], *phases[:i]]",
        "phases",
        ("tests/branch/test_events.py::test_orbits_are_one_wherever_they_begin",),
    ),
    Mutant(
        "a map has the units of whichever orbit was found first",
        "solver/charts/plane.py",
        "course = replace(course, units=case.units)",
        "course = replace(course)",
        (f"{BRANCHES}::test_a_map_over_the_frequency_has_the_orbits_of_the_solver",),
    ),
    Mutant(
        "a slip of a body that vanishes has its event divided never",
        "solver/branch/along.py",
        "            divided[p] = least if least > 1 else divided[p]\n",
        "            divided[p] = 0\n",
        (f"{ENDS}::test_a_slip_vanishes_where_friction_just_holds",),
    ),
    Mutant(
        "slow poles of a body keep the rounding of the quickest",
        "solver/bodies/flow.py",
        "initial=0.0) < TURN",
        "initial=0.0) < 0",
        (
            f"{EIGENBASES}::test_slow_poles_have_their_own_digits",
            f"{EIGENBASES}::test_a_flip_of_a_beam_of_60_modes",
            f"{EIGENBASES}::test_parts_that_rounding_alone_couples_stay_apart",
        ),
    ),
    Mutant(
        "the eigenbasis at one value of a parameter stands for those at others",
        "solver/branch/bodies/arrays.py",
        "(a <= SAME * b).all()",
        "(a <= 1.0 * b).all()",
        (f"{EIGENBASES}::test_no_basis_is_known_where_a_rate_depends_on_the_parameter",),
    ),
    Mutant(
        "places of a body are in other scales than its eigenbasis",
        "solver/branch/bodies/exponential.py",
        "scales[i] = generator[i, n // 2 + i]",
        "scales[i] = 1.0",
        (f"{EIGENBASES}::test_states_grow_as_exact_exponentials",),
    ),
    Mutant(
        "a rate of a body that dips between two times is never looked at",
        "solver/branch/bodies/watched.py",
        "SHALLOW = 0.5",
        "SHALLOW = -1e9",
        (
            "tests/branch/test_branches.py::test_a_form_of_a_body_that_falls_and_rises_again_has_its_least",
        ),
    ),
    Mutant(
        "what poles make of the forcing does not turn with it where a time is doubled",
        "solver/branch/bodies/exponential.py",
        "[np.exp(-1j * omega * t)]",
        "[np.exp(1j * omega * t)]",
        (f"{EIGENBASES}::test_coordinates_of_a_phase_are_its_states",),
    ),
    Mutant(
        "the force series answers an odd polynomial as it begins, not as it ends",
        "solver/bodies/force_series/series.py",
        "alternating[1::2] *= -1",
        "alternating[1::2] *= 1",
        (f"{BALLS_OF_BODIES}::test_solutions_in_balls_are_those_of_the_kernels",),
    ),
    Mutant(
        "impulses of harmonics are at the other end of their phase",
        "solver/bodies/harmonics/frame.py",
        "Break(p + 1, 0, int(c)) for p in range(count)",
        "Break(p, 0, int(c)) for p in range(count)",
        (f"{BALLS_OF_BODIES}::test_solutions_in_balls_are_those_of_the_kernels",),
    ),
    Mutant(
        "what modes left out answer has no mass, though a force may jump",
        "solver/scenes/bodies/body.py",
        "jumps or bool(scene.module.MEMORY)",
        "False",
        (f"{LARGE}::test_modes_left_out_have_a_mass_where_a_force_may_jump",),
    ),
    Mutant(
        "the multipliers of what lasts are not all",
        "solver/stability/cell_map.py",
        "lasts[j] = itself > DIED or through > DIED",
        "lasts[j] = itself > 0.1",
        (f"{EIGENBASES}::test_multipliers_of_what_lasts_are_all",),
    ),
    Mutant(
        "a flight that begins without speed has its event divided once",
        "solver/branch/along.py",
        "divided[p] = least if least > 1 else divided[p]",
        "divided[p] = least if least > 2 else divided[p]",
        (f"{EVENTS}::test_what_happens_is_located_to_rounding",),
    ),
    Mutant(
        "a form that falls and rises again between two times has no least value",
        "solver/branch/watch.py",
        "dips = i > 0 and before >= 0 <= rate and bent < 0 < bend",
        "dips = False",
        (f"{EVENTS}::test_impacts_that_follow_ever_faster_are_put_in",),
    ),
    Mutant(
        "behind a rest that vanishes a flight goes on, though it ends by an impact",
        "solver/branch/orders/candidates.py",
        "if self.leaps(p):",
        "if False:",
        (f"{EVENTS}::test_what_happens_is_located_to_rounding",),
    ),
    Mutant(
        "a transient that is short against its phase goes unseen",
        "solver/orbit/transients.py",
        "FAST = 50.0",
        "FAST = 5e9",
        WRONG,
    ),
    Mutant(
        "a surface that is touched just before a phase ends on it goes unseen",
        "solver/branch/watch.py",
        "peaks = i > 0 and before < 0 and rate < 0 and bent > 0 > bend",
        "peaks = False",
        ("tests/branch/test_branches_either_way.py",),
    ),
)
