"""Stage 3, Sections 3.1 and 3.2 by their symmetry: half of the unknowns, the same orbit.

Input: sines about mid-stick, and the odd C1 functions ``g_l``.
Output: `derive`, the record of one kernel for the Fourier series (no C1 function) and for
the series with the first of them (the ``g1`` of the paper) or more.

The expansion is ``y = sum b_n sin(n omega_0 tau) + sum c_l tail(g_l)``, where the tail of
``g_l`` is ``g_l`` without its first ``N`` harmonics.  (6) makes each coefficient a response
to the spring force in slip,

    b_j = -(force_j)/(D_j),    D_j = -(j omega_0)**2 T/2,

and the kernel puts these into (9) and (10) instead of the ``b_j`` themselves.  Where (6)
holds it is the same; on the way there it is not: the velocity of a series has a kink where
stick ends, which a step of Newton's method in ``t1`` cannot see beyond ``1/N``, and the
velocity of the response has not.
"""

import sympy as sp

from ...system import ClosedForm, GalerkinSystem, require_zero
from ..paper import fourier
from ..paper import g1 as smooth
from ..paper.slip_moments import bessel_forms, z
from . import odd_functions, symmetric_equations, symmetry

#: The recurrence by which ``j_{l+1}`` follows from ``j_l`` and ``j_{l-1}``.
_l = odd_functions.l
NEXT_BESSEL = (2 * _l + 1) / z * odd_functions.here - odd_functions.below


def check_recurrence() -> None:
    """Check the recurrence of the spherical Bessel functions for a few degrees.

    Raises
    ------
    DerivationError
        If it does not hold.
    """
    names = {odd_functions.below: -1, odd_functions.here: 0}
    claims = []
    for degree in (1, 2, 5):
        values = {name: sp.jn(degree + shift, z) for name, shift in names.items()}
        step = NEXT_BESSEL.subs(values).subs(_l, degree)
        claims.append((f"j_{degree + 1}", sp.expand_func(sp.jn(degree + 1, z) - step)))
    require_zero(claims)


def closed_forms() -> tuple[ClosedForm, ...]:
    """Return the closed forms of the kernel."""
    shared = {form.name: form for form in (*fourier.closed_forms(), *smooth.closed_forms())}
    taken = (
        "angle",
        "period_term",
        "velocity_weight",
        "initial_state",
        "harmonic_acceleration",
        "residual_in_stick",
        "residual_in_slip",
    )
    step = ClosedForm(
        "spherical_bessel_next",
        "j_{l+1}(z) from j_l(z) and j_{l-1}(z), for z >= l + 2; below, it loses digits.",
        (odd_functions.below, odd_functions.here, _l, z),
        (NEXT_BESSEL,),
    )
    return (
        *(shared[name] for name in taken),
        *symmetry.closed_forms(),
        *bessel_forms()[:2],
        step,
        *odd_functions.closed_forms(),
    )


def derive() -> GalerkinSystem:
    """Derive the halved system of Sections 3.1 and 3.2.

    Raises
    ------
    DerivationError
        If the residual of an odd motion is not odd, or a closed form is wrong.
    """
    symmetry.check_integrals()
    symmetry.check_derivatives()
    symmetry.check_symmetry()
    odd_functions.check_functions()
    check_recurrence()
    return GalerkinSystem(
        method="hb-symmetric",
        section="3.1 and 3.2",
        title="Sines and K C1 functions about mid-stick",
        unknowns="b_1..b_N, c_1..c_K beside the tails of the C1 functions, t1, T",
        equations=symmetric_equations.equations(),
        jacobian=(),
        forms=closed_forms(),
    )
