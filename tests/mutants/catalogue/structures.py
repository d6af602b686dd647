"""Mistakes in the modes of beams and strings: derivation, expansions, bounds, eigenvalues."""

from ..mutant import Mutant

DERIVED = ("tests/space/test_space_derivation.py",)
MATRICES = ("tests/space/test_space_matrices.py",)
SUMS = ("tests/space/test_space_matrices.py::test_sums_over_the_modes_beyond_the_first",)
REFERENCES = ("tests/space/test_space_references.py",)

FREELY = ("tests/bodies/test_bodies_that_move_freely.py",)
ROUNDING = ("tests/bodies/test_orders_of_bodies.py",)

MUTANTS = (
    Mutant(
        "an inertia pulls the wrong way",
        "codegen/space/data.py",
        '"inertia": s * lam, "compliance": s}',
        '"inertia": -s * lam, "compliance": s}',
        DERIVED,
    ),
    Mutant(
        "the hyperbolic part of a beam with the other sign",
        "codegen/space/green.py",
        "    return string(beta) * half, -hyperbolic * half",
        "    return string(beta) * half, hyperbolic * half",
        DERIVED,
    ),
    Mutant(
        "the smooth part of a sum beyond the modes is left out",
        "solver/space/expansions/beyond.py",
        " + np.exp(turned) * smooth",
        "",
        SUMS,
    ),
    Mutant(
        "the exponential integral is that of the order below",
        "solver/space/expansions/beyond.py",
        "for q in range(1, p):",
        "for q in range(1, p - 1):",
        SUMS,
    ),
    Mutant(
        "the right piece of a forced mode is not mirrored",
        "solver/space/expansions/forced.py",
        "        right = (-1) ** (structure.felt + derivative) * right",
        "        right = (-1) ** structure.felt * right",
        MATRICES,
    ),
    Mutant(
        "the pieces of a C2 series may jump in the second derivative",
        "solver/space/expansions/pieces.py",
        "    for derivative in range(k - m + 1):",
        "    for derivative in range(k - m):",
        REFERENCES,
    ),
    Mutant(
        "bounds from below are given beyond the first sine left out",
        "solver/space/eigenvalues/bounds.py",
        "    valid = (roots.values < attached.bare(np.array([N + 1]))[0]) & (low > 0)",
        "    valid = low > 0",
        MATRICES,
    ),
    Mutant(
        "sines of a fraction are not reduced in whole numbers",
        "solver/space/position.py",
        "    p = np.asarray(numbers_).astype(object) * P % (2 * Q)",
        "    p = np.asarray(numbers_) * float(a) % 2 * Q",
        REFERENCES,
    ),
    Mutant(
        "the jump of a mode is not that of its shape",
        "solver/space/modes.py",
        "else jump_mismatch(attached, shape, eigenvalue)",
        "else jump_mismatch(attached, shape, 2 * eigenvalue)",
        ("tests/space/test_space_claims.py::test_the_mismatch_of_a_jump_is_that_of_its_shape",),
    ),
    Mutant(
        "what is attached does not count in the modal mass",
        "solver/space/mode.py",
        "            mass += attached.values[attached.structure.attached.name] * float(moved) ** 2\n",
        "",
        ("tests/space/test_space_shapes.py",),
    ),
    Mutant(
        "the modes left out of a body answer as if they were stiffer",
        "solver/bodies/left_out.py",
        "before, response = response, first + shift * without(stiff(M @ response))",
        "before, response = response, first",
        ("tests/bodies/test_large_and_free_bodies.py",),
    ),
    Mutant(
        "natural modes keep what the computation of eigenvalues left of them",
        "solver/bodies/modes.py",
        "shapes + (shapes @ turns + outside)",
        "shapes + outside",
        ("tests/bodies/test_natural_modes.py",),
    ),
    Mutant(
        "a mesh without digits passes",
        "solver/bodies/modes.py",
        "    if lost > LOST:",
        "    if lost > 1.0:",
        ("tests/bodies/test_large_and_free_bodies.py",),
    ),
    Mutant(
        "a velocity moves no place of a body that nothing holds",
        "solver/bodies/flow.py",
        "        states[: self.free] += start[self.free : 2 * self.free, None] * t",
        "",
        FREELY,
    ),
    Mutant(
        "a law leaves out what holds a body that moves freely",
        "solver/bodies/poles.py",
        "                variables[..., force] = -reaction",
        "                variables[..., force] = 0.0",
        FREELY,
    ),
    Mutant(
        "events do not say where a ball is between impacts",
        "solver/bodies/switch.py",
        "        state = self.state - shift @ self.gradient[None]",
        "        state = self.state",
        FREELY,
    ),
    Mutant(
        "rounding of a sum over modes is a violation",
        "solver/orbit/exact_orbit.py",
        "        return magnitudes(cell, self.times, p) * (NOISE / admissible.ROUNDING)",
        "        return 0.0",
        ROUNDING,
    ),
)
