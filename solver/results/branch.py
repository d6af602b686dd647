"""A branch of orbits along a parameter as a result: its orbits and events."""

from dataclasses import asdict, dataclass
from typing import Any, ClassVar

from ...nearest import counted, in_short
from .family import Family


@dataclass(frozen=True)
class BranchEvent:
    """A bifurcation or another event on a branch, at one value of the parameter.

    Parameters
    ----------
    kind : {"fold", "flip", "torus", "branch-point", "grazing", "sticking", "vanishing"}
        The branch turns back; period doubling; Neimark-Sacker; the symmetry is lost, or
        branches meet; a surface is touched, or left at zero speed; a phase of rest begins or
        ends; another phase vanishes.
    parameter : float
        The value, in SI units.
    motion : str or None
        The motion of the branch there; None if the scene has only one.
    phase : str or None
        The phase in which it happens; None if it concerns the whole orbit.
    estimate : float
        Estimated error of the value: the difference from the value located from the other side.
    """

    kind: str
    parameter: float
    motion: str | None
    phase: str | None
    estimate: float


@dataclass(frozen=True, repr=False)
class Branch(Family):
    """A branch of exact orbits along a parameter, from one end to the other.

    Parameters
    ----------
    case : Case
        The oscillator.
    parameter : str
        Name of the parameter that varies.
    method, order, functions : str, int, int or None
        An expansion that was solved next to each orbit, if one was asked for.
    rows : tuple of FamilyRow
        The orbits in the order of the branch; after a fold there are several at one value.
    events : tuple of BranchEvent
        Events in the same order.
    why_it_ended : (str, str)
        Why it ends at its start, and at its end.
    """

    events: tuple[BranchEvent, ...] = ()
    why_it_ended: tuple[str, str] = ("", "")

    in_turn: ClassVar[bool] = True

    def __hash__(self) -> int:
        return super().__hash__()

    def __repr__(self) -> str:
        scene, values = self.case.scene, self["value"]
        kinds = [event.kind for event in self.events]
        named = [f"{kinds.count(kind)} {kind}" for kind in dict.fromkeys(kinds)]
        span = f"{self.parameter} = {values.min():g} to {values.max():g}"
        events = ", ".join(named) or "no event"
        orbits = counted(len(self), "orbit")
        return f"<branch of {scene.label} along {span}: {orbits}, {events}>"

    def __str__(self) -> str:
        lines = [f"{'event':>14}  {self.parameter:>20}  motion"] if self.events else []
        for event in self.events:
            words = in_short(event.motion or ""), event.phase and f"in {event.phase}"
            where = ", ".join(filter(None, words))
            lines += [f"{event.kind:>14}  {event.parameter:20.15g}  {where}".rstrip()]
        values = self["value"]
        start, end = (f"{values[i]:.6g} ({self.why_it_ended[i]})" for i in (0, -1))
        return "\n".join([*lines, f"from {self.parameter} = {start} to {end}"])

    def as_dict(self) -> dict[str, Any]:
        """Return the branch as the document that ``branch --json`` writes."""
        times = "motion", "period", "forcing_phase", "durations"
        keys = (*times, "extremes", "multipliers", "stable", "strobe")
        rows = [row.as_dict() for row in self.rows]
        how = {"method": self.method, "order": self.order} if self.order else {}
        beside = ["beside"] if how else []
        return self.head(**how) | {
            "vary": self.parameter,
            "points": [
                {"parameter": row["value"], **{key: row.get(key) for key in (*keys, *beside)}}
                for row in rows
            ],
            "events": [asdict(event) for event in self.events],
            "why_it_ended": dict(zip(("start", "end"), self.why_it_ended, strict=True)),
        }
