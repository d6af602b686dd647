"""How every periodic motion is shown: as text, as a table over time, as a picture."""

from typing import Any, ClassVar

import numpy as np

from ..presentation.notebook import facts, svg
from ..presentation.table import COURSE, Table, Tabular
from ..stability.in_words import in_words
from .motion import Motion

#: Times per period in a table, unless others are asked for.
SAMPLES = 1000


class Shown(Motion, Tabular):
    """A motion that can be shown as a picture, a table, or text."""

    #: What its label is called among its facts.
    _role: ClassVar[str] = "orbit"

    @property
    def label(self) -> str:
        """Name in a legend: method and order, or ``"exact"``."""
        raise NotImplementedError

    @property
    def about(self) -> dict[str, Any]:
        """Scene, period and parameters, for tables and files."""
        scene, turn = self.case.scene, self.forcing_phase
        about: dict[str, Any] = {"scene": scene.name, "class": f"C{scene.k}"}
        about |= {"motion": scene.motion} if scene.motion else {}
        about |= {"cycles": self.case.cycles, "period": self.period}
        about |= {} if turn is None else {"forcing_phase": turn}
        phases = " ".join(phase.name for phase in self.phases)
        return about | {"phases": phases} | dict(self.case.values)

    @property
    def facts(self) -> dict[str, str]:
        """Lines that a notebook shows: scene, parameters, period, phases, stability."""
        scene, turn = self.case.scene, self.forcing_phase
        return {
            "scene": f"{scene.name}: {scene.title}",
            "parameters": self.case.description,
            self._role: self.label,
            "period": f"{self.period:.10g} s",
            "phases": ", ".join(f"{p.name} {p.duration:.8g} s" for p in self.phases),
            "phase of the forcing": "" if turn is None else f"{turn:.8g} rad",
            "stability": in_words(self),
        }

    @property
    def _times(self) -> str:
        """The period, and the durations of the phases of a cell or the phase of the forcing."""
        words, turn = [f"T = {self.period:.10g} s"], self.forcing_phase
        if len(self.cell_durations) > 1:
            of_cell = self.phases[: len(self._of_cell)]
            words += [f"{p.name} {p.duration:.10g} s" for p in of_cell]
        if turn is not None:
            words.append(f"phi = {turn:.10g} rad")
        return ", ".join(words)

    @property
    def _verdict(self) -> str:
        """``", stable"`` or ``", unstable"``; empty where neither is known."""
        stable = self.stable
        return "" if stable is None else ", stable" if stable else ", unstable"

    def plot(self, ax: Any = None, quantity: str = "plane", **style: Any) -> Any:
        """Draw the motion and return the axes; needs matplotlib, the extra ``plot``.

        Parameters
        ----------
        ax : matplotlib Axes, optional
            Axes to draw in; new ones by default.
        quantity : {"plane", "displacement", "velocity", "acceleration"}
            The phase plane, or one of the three against time in periods.
        **style
            Of the line, as `matplotlib.axes.Axes.plot` takes it.

        Raises
        ------
        ValueError
            If `quantity` is none of these.
        MissingExtra
            An `ImportError`: if matplotlib is not installed.
        """
        from ...plots.orbits import draw  # noqa: PLC0415  (an extra)

        return draw(self, ax, quantity, **style)

    def table(self, samples: int = SAMPLES) -> Table:
        """Return the motion over one period, at equal steps of time.

        Its columns are `t` in s, `displacement`, `velocity` and `acceleration` in SI units, and
        the number of the `phase`, from 0.  The names of the phases are in `about`.

        Parameters
        ----------
        samples : int
            Number of times.
        """
        t = self.period * np.arange(samples) / samples
        switches = np.cumsum(self.durations)[:-1]
        columns = {"t": t} | {name: getattr(self, name)(t) for name in list(COURSE)[1:]}
        columns["phase"] = np.searchsorted(switches, t, side="right")
        return Table(("t",), columns, COURSE, self.about)

    def _repr_html_(self) -> str:
        return facts(self.facts) + svg(self.plot)
