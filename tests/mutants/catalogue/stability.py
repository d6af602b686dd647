"""Mistakes in the multipliers of orbits, and in what is said of them."""

from ..mutant import Mutant

MULTIPLIERS = ("tests/stability/test_multipliers.py",)
SALTATION = ("tests/scene/test_saltation.py",)
SHOWN = ("tests/cli_scenes/test_scene_commands.py",)


def numeric(what: str, file: str, old: str, new: str) -> Mutant:
    """Return a mistake in the numbers."""
    return Mutant(what, f"solver/stability/{file}", old, new, MULTIPLIERS)


MUTANTS: tuple[Mutant, ...] = (
    Mutant(
        "the delay of a perturbed event has the wrong sign",
        "codegen/scene/saltation.py",
        "behind = law.jacobian(state) * moved - rates_after * delay",
        "behind = law.jacobian(state) * moved + rates_after * delay",
        SALTATION,
    ),
    Mutant(
        "the event of a perturbed motion does not move with the forcing",
        "codegen/scene/saltation.py",
        "sp.diff(zero, forcing) * turning * delay",
        "0 * turning * delay",
        SALTATION,
    ),
    Mutant(
        "a held mass accelerates",
        "codegen/scene/saltation.py",
        "    if right.held is not None:\n        values[after] = sp.Integer(0)\n",
        "    if right.held is not None:\n",
        SALTATION,
    ),
    numeric(
        "the sign of an impact in the saltation",
        "linear_maps.py",
        "np.asarray(self.rates_after - self.law @ self.rates_before - self.turning)",
        "np.asarray(self.rates_after + self.law @ self.rates_before - self.turning)",
    ),
    numeric(
        "the forcing does not move the event",
        "monodromy.py",
        "drift=float(-ec * cell.omega * sine),",
        "drift=0.0,",
    ),
    numeric(
        "the mirror image is forgotten at the end of the cell",
        "monodromy.py",
        "sign = cell.sign if after == 0 else 1",
        "sign = 1",
    ),
    numeric(
        "the determinant is not checked",
        "monodromy.py",
        "    _check_determinant(matrix, size, expected)\n    return",
        "    return",
    ),
    numeric(
        "the rate of the motion is not checked",
        "monodromy.py",
        "if not (off <= allowed + ROUNDING * _force(phase, start)).all():",
        "if False:",
    ),
    numeric(
        "an event that is touched has multipliers",
        "monodromy.py",
        "if not abs(switch.approach) > TOUCH * switch.size:",
        "if False:",
    ),
    numeric(
        "the multipliers of half a period for those of a whole",
        "stability.py",
        "values, errors = values**2, 2 * np.abs(values) * errors + errors**2",
        "pass",
    ),
    numeric(
        "the smallest multiplier first",
        "stability.py",
        "key=lambda j: (-abs(values[j]), -values[j].imag)",
        "key=lambda j: (abs(values[j]), -values[j].imag)",
    ),
    numeric(
        "the zero of a held phase is computed",
        "stability.py",
        "values[zero], errors[zero] = 0.0, 0.0",
        "errors[zero] = 0.0",
    ),
    numeric(
        "at the boundary an orbit is called stable",
        "stability.py",
        "None if abs(self.margin) <= self.rounding else self.margin > 0",
        "self.margin > -1e-9",
    ),
    Mutant(
        "multipliers at the times of the expansion for those of the exact orbit",
        "solver/orbit/orbit.py",
        "return super().stability if self.exact is None else self.exact.stability",
        "return super().stability",
        MULTIPLIERS,
    ),
    Mutant(
        "the imaginary part for the real one in a document",
        "solver/stability/words.py",
        '"re": float(value.real), "im": float(value.imag)',
        '"re": float(value.imag), "im": float(value.real)',
        SHOWN,
    ),
    Mutant(
        "the sine of the closed form has the wrong sign",
        "solver/shortcuts/orbit/motion.py",
        "math.cos(T - t1) - self.belt.alpha * math.sin(T - t1)",
        "math.cos(T - t1) + self.belt.alpha * math.sin(T - t1)",
        MULTIPLIERS,
    ),
)
