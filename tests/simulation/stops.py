"""A mass that bounces off a stop, and rests on it while a force presses."""

from made_scenes import made

GAP, OMEGA, DAMPING = 0.1, 0.3, 0.3
FLIGHT, REST = (1, DAMPING, 1, 0, 1), (1, 0, 0, 0, 0)
PRESSES = (0, 0, 1, -GAP)  # the force, less that of the spring, on the stop


def resting(restitution, presses=PRESSES, two=False):
    """Return a mass that bounces off a stop, and rests on it while a force presses.

    Or between two stops: the other half is the mirror image.
    """
    before = {"before one": (-1, 0, 0, GAP)}
    if two:
        before["before the other"] = (1, 0, 0, GAP)
    return made(
        [FLIGHT, REST],
        [(1, 0, 0, -GAP), presses],
        omega=OMEGA,
        half=two,
        jumps=((-restitution, 0), (1, 0)),
        held=(None, 0.0),
        demands=[before, {"the stop presses": presses}],
        k=0,
    )()


def between_two(restitution):
    """Return the same between two stops."""
    return resting(restitution, two=True)
