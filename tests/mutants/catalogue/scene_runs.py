"""Mistakes in what runs over many orbits of a scene: trade, budget, a parameter; their pages."""

from ..mutant import Mutant

TRADE = ("tests/cli_scenes/test_scene_trade.py",)
FAMILY = ("tests/cli_scenes/test_scene_family.py",)
ESTIMATE = ("tests/scenes/test_orbit_scenes.py", "tests/scenes/test_never_wrong.py")
KEYS = ("tests/files/test_keys_of_any_scene.py",)
OWN = ("tests/galerkin/test_new_expansion.py",)
CLI = "src/nonsmooth/cli/scenes"

MUTANTS: tuple[Mutant, ...] = (
    Mutant(
        "what another matches is on the front",
        "solver/trade/measured.py", "if points[index][1] < best:", "if points[index][1] <= best:", TRADE,
    ),
    Mutant(
        "the estimate for the error of a trade",
        "solver/trade/measured.py",
        "error, judged = max(orbit.errors.times, ROUNDING), orbit.estimate.times",
        "error, judged = max(orbit.errors.discontinuous, ROUNDING), orbit.estimate.times", TRADE,
    ),
    Mutant(
        "a scene's budget is overdrawn",
        "solver/trade/budget.py", "if seconds > budget:", "if seconds > 2 * budget:", TRADE,
    ),
    Mutant(
        "the worst within a scene's budget",
        "solver/trade/budget.py",
        "size(orbit.estimate) < size(best.estimate)",
        "size(orbit.estimate) > size(best.estimate)", TRADE,
    ),
    Mutant(
        "a family of one cycle",
        "solver/family.py",
        "{parameter: value}, case.cycles)", "{parameter: value})", FAMILY,
    ),
    Mutant(
        "a family followed by another motion",
        "solver/family.py",
        "case.of_motion(before.case.scene.motion)", "case.each_motion[-1]", FAMILY,
    ),
    Mutant(
        "durations by the names of another motion",
        "solver/family.py",
        "registry.of_motion(scene, row.motion) if row.motion else scene", "scene", FAMILY,
    ),
    Mutant(
        "a family without its cycles in a file",
        "solver/family.py",
        '"cycles": self.case.cycles,\n            "method"', '"cycles": 1,\n            "method"', FAMILY,
    ),
    Mutant(
        "any better solution is taken for an orbit",
        "solver/accuracy/estimate.py",
        "return change.times <= SAME and change.discontinuous <= SAME_DERIVATIVE", "return True", ESTIMATE,
    ),
    Mutant(
        "no better solution is taken for an orbit",
        "solver/accuracy/estimate.py",
        "(is_orbit and _same(change)) or found.admissible", "found.admissible and False", ESTIMATE,
    ),
    Mutant(
        "columns of a printed trade swapped",
        f"{CLI}/shown/tables.py",
        'f"{point.error:.1e}",\n            "" if exact else f"{point.estimate:.1e}",',
        '"" if exact else f"{point.estimate:.1e}",\n            f"{point.seconds:.1e}",', TRADE,
    ),
    Mutant(
        "axes of a drawn trade swapped",
        "src/nonsmooth/plots/trade.py",
        "axes.plot(times, errors, label=words,",
        "axes.plot(errors, times, label=words,", TRADE,
    ),
    Mutant(
        "an orbit is followed in the units of the one before",
        "solver/family.py",
        "        times[durations] *= before.case.units.time / case.units.time\n", "", FAMILY,
    ),
    Mutant(
        "an orbit that is not admissible is followed",
        "solver/family.py",
        "if found.converged and found.admissible:", "if not found.converged:", FAMILY,
    ),
    Mutant(
        "what was spent in vain is forgotten",
        "solver/family.py",
        "found = replace(found, iterations=found.iterations + spent)",
        "found = replace(found, iterations=found.iterations)", FAMILY,
    ),
    Mutant(
        "least and largest swapped in a file along a parameter",
        "src/nonsmooth/files/scenes/tables.py",
        'values |= {f"least_{name}": low, f"largest_{name}": high}',
        'values |= {f"least_{name}": high, f"largest_{name}": low}', FAMILY,
    ),
    Mutant(
        "least and largest swapped in a table along a parameter",
        f"{CLI}/shown/tables.py",
        'without_rounding(row.extremes["displacement"])', 'without_rounding(row.extremes["velocity"])',
        FAMILY,
    ),
    Mutant(
        "velocities drawn for displacements along a parameter",
        "src/nonsmooth/plots/families.py",
        "axes.plot(along, _ends(result, quantity, end), **look)",
        'axes.plot(along, _ends(result, "velocity", end), **look)', FAMILY,
    ),
    Mutant(
        "a value without an orbit ends with status 0",
        f"{CLI}/family.py",
        'return 0 if all(row.status == "ok" for row in result.rows) else 1', "return 0", FAMILY,
    ),
    Mutant(
        "the error of stick for that of the times",
        "src/nonsmooth/files/shortcuts/as_any_scene.py",
        "largest = max(abs(stick), abs(whole - stick))", "largest = abs(stick)", KEYS,
    ),
    Mutant(
        "the last end of a phase is left out",
        "solver/shortcuts/orbit/extremes.py",
        "for start, end in ((0.0, t1), (t1, T)):", "for start, end in ((0.0, t1),):", KEYS,
    ),
    Mutant(
        "a velocity is sought at the samples of the displacement",
        "solver/shortcuts/orbit/extremes.py",
        "values, step = sampled[derivative], tau[1] - tau[0]",
        "values, step = sampled[0], tau[1] - tau[0]", KEYS,
    ),
)  # fmt: skip
