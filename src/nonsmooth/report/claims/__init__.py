"""What the paper claims, claim by claim, with the checks that decide each."""

from ..finding import Claim
from .c1_series import C1
from .exact_orbit import ORBIT
from .harmonics import HB
from .one_function import HB_C1

#: The headings under which the claims stand, in the order of the paper's methods.
GROUPS: dict[str, tuple[Claim, ...]] = {
    "The exact orbit (Section 2)": ORBIT,
    "Classical harmonic balance (Section 3.1)": HB,
    "One C¹ function beside the harmonics (Section 3.2)": HB_C1,
    "A series of C¹ functions (Section 3.3)": C1,
}

CLAIMS = tuple(claim for group in GROUPS.values() for claim in group)
