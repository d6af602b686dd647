"""Conditions solved phase by phase: what a kernel has beside residual and Jacobian for that."""

from collections.abc import Sequence

from ...galerkin import GalerkinConditions
from ..functions import function, prologue
from ..loops import Row
from ..used import with_used
from .bands import condensed
from .writer import Writer

#: What the functions of the condensed form do.
KEPT_PLACES = "Return the places in z of the unknowns that remain where each band is solved."
BAND_PLACES = """Return for each band: where it stands in z, how many unknowns it determines,
    where its others stand among those that remain, how many, and how many the joints see."""
BANDS = """Fill the band matrices, [p, row, BELOW + ABOVE + j - i] for unknown j of row i in
    band p, and right sides; rows begin at BELOW + ABOVE, so that no diagonal needs an end."""
BAND_RATES = "Fill in how right sides less the bands change with the unknowns that remain."
JOINTS = "Fill R with the left sides of the conditions that are not in a band."
JOINT_RATES = "Fill J with their derivatives, slopes being those of the unknowns of the bands."


def functions(system: GalerkinConditions, rows: Sequence[Row]) -> list[str]:
    """Return the functions of the condensed form, if there is one."""
    found = condensed(system, rows)
    if found is None:
        return []
    writer = Writer(system, found)
    plain, with_rates = ([f"rates = {rates}", *prologue(system)] for rates in (False, True))
    written = (
        ("kept_places(z)", KEPT_PLACES, plain, writer.kept_places()),
        ("band_places(z)", BAND_PLACES, plain, writer.band_places()),
        ("bands(case, z, diagonals, right)", BANDS, plain, writer.bands()),
        ("band_rates(case, z, right, slopes)", BAND_RATES, with_rates, writer.band_rates()),
        ("joints(case, z, R)", JOINTS, plain, ["row = 0", *writer.joints()]),
        (
            "joint_rates(case, z, slopes, J)",
            JOINT_RATES,
            with_rates,
            ["row = 0", *writer.joint_rates()],
        ),
    )
    functions = [
        function(name, what, with_used(known, body)) for name, what, known, body in written
    ]
    return ["\n".join(writer.constants()), *functions]
