"""Cases with stable orbits of every kind of switch, and states from which they are reached."""

from made_scenes import BACKLASH, CLEARANCE, TWO_SIDED, dry

from nonsmooth.solver.kernels import registry

IMPACT = registry.load("impact")
DAMPED = registry.load("stick-slip-damped")
BELT = {"mass": 1, "stiffness": 1, "belt_speed": 1, "normal_force": 1, "damping": 0.1}

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
