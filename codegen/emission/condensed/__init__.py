"""Conditions solved phase by phase: what a kernel has beside residual and Jacobian for that."""

from collections.abc import Sequence

from ...galerkin import GalerkinConditions
from ..functions import function, prologue
from ..loops import Row
from ..used import with_used
from .bands import bands_of
from .order import order
from .writer import Writer

#: What the functions of the condensed form do.
BEFORE = "Fill in the unknowns that single conditions give, before the others are solved for."
AFTER = "Fill in the unknowns that follow from the others."
KEPT_PLACES = "Return the places in z of the unknowns that are solved for together."
BAND_PLACES = """Return for each band: where it stands in z, how many unknowns it determines,
    where its others stand among those solved for together, how many, and how many of its
    own the joints see."""
BANDS = """Fill the band matrices, [p, row, BELOW + ABOVE + j - i] for unknown j of row i in
    band p, and right sides; rows begin at BELOW + ABOVE, so that no diagonal needs an end."""
BAND_RATES = """Fill in how right sides less the bands change with what is solved for together;
    `found` has the unknowns of the bands."""
JOINTS = "Fill R with the left sides of the conditions that are solved together."
JOINT_RATES = "Fill J with their derivatives, slopes being those of the unknowns of the bands."


def functions(system: GalerkinConditions, rows: Sequence[Row]) -> list[str]:
    """Return the functions of the condensed form, if there is one."""
    found = bands_of(system, rows)
    if found is None:
        return []
    solved = order(system, found.bands, found.joints)
    writer = Writer(system, found, solved)
    plain, with_rates = ([f"rates = {rates}", *prologue(system)] for rates in (False, True))
    joints = ["row = 0", *writer.joints()]
    joint_rates = ["row = 0", *writer.joint_rates()]
    first, last = solved.before, solved.after
    written = (
        ("before(case, z)", BEFORE, writer.named(first), writer.assigned(first) or ["pass"]),
        ("kept_places(z)", KEPT_PLACES, plain, writer.kept_places()),
        ("band_places(z)", BAND_PLACES, plain, writer.band_places()),
        ("bands(case, z, diagonals, right)", BANDS, plain, writer.bands()),
        ("band_rates(case, z, found, slopes)", BAND_RATES, with_rates, writer.band_rates()),
        ("joints(case, z, R)", JOINTS, plain, joints),
        ("joint_rates(case, z, slopes, J)", JOINT_RATES, with_rates, joint_rates),
        ("after(case, z)", AFTER, writer.named(last), writer.assigned(last) or ["pass"]),
    )
    functions = [
        function(name, what, with_used(known, body)) for name, what, known, body in written
    ]
    return ["\n".join(writer.constants()), *functions]
