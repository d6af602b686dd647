"""Mistakes by which bad input passes, or what is no orbit, or a proof that is none."""

from ..mutant import Mutant

INPUT = ("tests/scenes/test_bad_scene_input.py",)
NONE = ("tests/existence/test_existence.py",)
SCAN = ("tests/existence/test_two_phases.py",)
WRONG = ("tests/orbit/test_never_wrong.py",)
ADMISSIBLE = ("tests/orbit/test_admissible_scenes.py",)
CROSSED = ("tests/orbit/test_crossings.py",)

MUTANTS = (
    Mutant(
        "terms of different units may be added",
        "codegen/scene/units.py",
        "        if unit != expected:",
        "        if not unit:",
        ("tests/scene/test_scene_units.py",),
    ),
    Mutant(
        "a parameter may be out of its bounds",
        "solver/scenes/case.py",
        "if is_number(value) and parameter.allows(float(value)):",
        "if is_number(value):",
        INPUT,
    ),
    Mutant(
        "a parameter may be infinite",
        "solver/scenes/parameter_error.py",
        "return math.isfinite(float(value))",
        "return float(value) == float(value)",
        INPUT,
    ),
    Mutant(
        "what a scene requires of its parameters is not looked at",
        "solver/scenes/case.py",
        "        if not value >= 0:\n",
        "        if False:\n",
        ("tests/scenes/test_case.py::test_what_the_scene_requires_is_checked_with_numbers",),
    ),
    Mutant(
        "a scene file that leaves takes the command along",
        "src/nonsmooth/scene_files/read.py",
        "except (Exception, SystemExit) as error:",
        "except Exception as error:",
        ("tests/cli_scenes/test_broken_scene_files.py",),
    ),
    Mutant(
        "an event may be crossed in the wrong direction",
        "solver/orbit/admissible.py",
        "not _slope_at_end(orbit, p, form, parts) < 0:",
        "False:",
        ADMISSIBLE,
    ),
    Mutant(
        "an expansion may violate its demands by any amount",
        "solver/orbit/allowance.py",
        "return min(MOST, max(ROUNDING, excused))",
        "return max(1e9, max(ROUNDING, excused))",
        ADMISSIBLE,
    ),
    Mutant(
        "an event may be met before the end",
        "solver/orbit/admissible.py",
        "    if u is None:\n",
        "    if True:\n",
        CROSSED,
    ),
    Mutant(
        "what is demanded at a switch is not looked at",
        "solver/orbit/admissible.py",
        "if below <= ROUNDING * scale or below <= allowed(p, form) * scale:",
        "if True:",
        WRONG,
    ),
    Mutant(
        "an orbit is returned that the exact equations disprove",
        "solver/orbit/solution.py",
        "        return self.own_violations or self._disproof",
        "        return self.own_violations",
        WRONG,
    ),
    Mutant(
        "there is said to be no orbit though one is listed",
        "solver/existence/known.py",
        "return self.complete and not self.orbits",
        "return self.complete",
        SCAN,
    ),
    Mutant(
        "there is said to be no orbit though a root led nowhere",
        "solver/existence/known.py",
        "            complete = False",
        "            pass",
        SCAN,
    ),
    Mutant(
        "infinitely many solutions are taken for none",
        "solver/existence/known.py",
        "complete = closed.none or bool(roots)",
        "complete = True",
        NONE,
    ),
    Mutant(
        "a motion that leaves its phase is one without switches",
        "solver/existence/reasons.py",
        "if not all(abs(form @ swing) <= form @ mean for _, form in phase.demands):",
        "if False:",
        NONE,
    ),
)
