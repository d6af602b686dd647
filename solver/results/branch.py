"""What a branch of orbits along a parameter comes to: its orbits, and what happens on it."""

from dataclasses import asdict, dataclass
from typing import Any, ClassVar

from .family import Family


@dataclass(frozen=True)
class BranchEvent:
    """Something that happens on a branch, at one value of the parameter.

    Parameters
    ----------
    kind : {"fold", "flip", "torus", "branch-point", "grazing", "sticking", "vanishing"}
        The branch turns back; a period is doubled; a second period comes up; the symmetry is
        lost, or branches meet; a surface is touched, or left at no speed; a rest begins or
        ends; another phase vanishes.
    parameter : float
        The value, in SI units.
    motion : str or None
        That of the branch there; None where the scene has only one.
    phase : str or None
        In which it happens; None where it is of the whole orbit.
    estimate : float
        Of the error of the value: what finding it from the other side gives otherwise.
    """

    kind: str
    parameter: float
    motion: str | None
    phase: str | None
    estimate: float


@dataclass(frozen=True, repr=False)
class Branch(Family):
    """A branch of exact orbits along a parameter, from the one end to the other.

    Parameters
    ----------
    case : Case
        The oscillator.
    parameter : str
        What varies.
    method, order, functions : str, int, int or None
        An expansion that was solved beside each orbit, if one was asked for.
    rows : tuple of FamilyRow
        The orbits, as they lie on the branch: where it turns, there are several at one value.
    events : tuple of BranchEvent
        What happens on it, in the same turn.
    why_it_ended : (str, str)
        At its start and at its end.
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
        along = f"{self.parameter} = {values.min():g} to {values.max():g}"
        events = ", ".join(named) or "no event"
        return f"<branch of {scene.label} along {along}: {len(self)} orbits, {events}>"

    def __str__(self) -> str:
        lines = [f"{'event':>14}  {self.parameter:>20}  motion"]
        lines += [
            f"{event.kind:>14}  {event.parameter:20.15g}  {event.motion or ''}"
            f"{', in ' + event.phase if event.phase else ''}"
            for event in self.events
        ]
        values = self["value"]
        start, end = (f"{values[i]:.6g} ({self.why_it_ended[i]})" for i in (0, -1))
        return "\n".join([*lines, f"from {self.parameter} = {start} to {end}"])

    def as_dict(self) -> dict[str, Any]:
        """Return the branch as the document that ``branch --json`` writes."""
        times = "motion", "period", "forcing_phase", "durations"
        keys = (*times, "extremes", "multipliers", "stable", "strobe")
        rows = [row.as_dict() for row in self.rows]
        how = {"method": self.method, "order": self.order} if self.order else {}
        more = ["beside"] if how else []
        return self.head(**how) | {
            "vary": self.parameter,
            "points": [
                {"parameter": row["value"], **{key: row.get(key) for key in (*keys, *more)}}
                for row in rows
            ],
            "events": [asdict(event) for event in self.events],
            "why_it_ended": dict(zip(("start", "end"), self.why_it_ended, strict=True)),
        }
