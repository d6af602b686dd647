"""Cases with stable orbits of every kind of switch, and states from which they are reached."""

from made_scenes import made

from nonsmooth.solver.kernels import registry

IMPACT = registry.load("impact")
DAMPED = registry.load("stick-slip-damped")
BELT = {"mass": 1, "stiffness": 1, "belt_speed": 1, "normal_force": 1, "damping": 0.1}


def mirrored(x, v, cos, constant):
    return (-x, -v, -cos, constant)


#: A spring behind a gap.
CLEARANCE = made(
    [(1, 0.2, 5, 2, 1), (1, 0.2, 1, 0, 1)],
    [(1, 0, 0, -0.5), (1, 0, 0, -0.5)],
    omega=1.3,
    demands=[{"in contact": (1, 0, 0, -0.5)}, {"free": (-1, 0, 0, 0.5)}],
)

#: A dead zone, whose other half is the mirror image.
BACKLASH = made(
    [(1, 0.1, 1, 1, 0.8), (1, 0.1, 0, 0, 0.8)],
    [(1, 0, 0, -1), mirrored(1, 0, 0, -1)],
    omega=0.7,
    half=True,
    demands=[{"engaged": (1, 0, 0, -1)}, {"loose": (-1, 0, 0, 1), "loose too": (1, 0, 0, 1)}],
)


def dry(omega, kinetic, static):
    """Return dry friction with stops: slides down, then rests while the load allows."""
    return made(
        [(1, 0.1, 1, kinetic, 1), (1, 0, 0, 0, 0)],
        [(0, 1, 0, 0), mirrored(1, 0, -1, -static)],
        omega=omega,
        half=True,
        held=(None, 0.0),
        demands=[
            {"it slides down": (0, -1, 0, 0)},
            {"the load is held": (-1, 0, 1, static), "both ways": (1, 0, -1, static)},
        ],
    )


#: Impacts on both sides: the event of a phase is the stop that it flies to.
TWO_SIDED = made(
    [(1, 0.1, 1, 0, 1)],
    [mirrored(1, 0, 0, -0.8)],
    omega=1.2,
    half=True,
    jumps=((-0.6, 0),),
    demands=[{"above": (1, 0, 0, 0.8), "below": (-1, 0, 0, 0.8)}],
    k=0,
)

#: Case; rough times; a state that is not on the orbit; cycles until it is.
REACHED = {
    "impact": (IMPACT(), (3.49,), 0.93, (-0.4, 0.2), 40),
    "belt": (DAMPED(**BELT, mu_s=3, mu_k=1), (3.4, 4.2), 0.0, (-0.5, 0.3), 6),
    "belt that weakens": (
        DAMPED(**BELT, mu_s=2, mu_k=1, weakening=0.2), (2.6, 4.5), 0.0, (1, 0), 9,
    ),
    "clearance": (CLEARANCE(), (1.39, 3.45), 0.35, (0.1, 0.2), 70),
    "backlash": (BACKLASH(), (3.68, 0.81), 5.35, (1.5, 0.3), 80),
    "friction with stops": (dry(0.4, 0.5, 0.6)(), (4.9, 3.0), 1.1, (0.2, -0.1), 30),
    "friction, equal at rest": (dry(0.4, 0.4, 0.4)(), (5.4, 2.5), 0.8, (0.2, -0.1), 30),
    "two-sided": (TWO_SIDED(), (2.6,), 0.15, (0.1, 0.9), 60),
}  # fmt: skip

#: Those of every run; the others have phases and switches of the same kinds.
EVERY_RUN = ("impact", "belt that weakens", "backlash", "friction with stops", "two-sided")
