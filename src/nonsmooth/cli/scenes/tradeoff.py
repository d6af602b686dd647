"""``nonsmooth tradeoff SCENE``: time against error, measured on this machine for one case."""

from nonsmooth.files import documents
from nonsmooth.solver.no_orbit import NoOrbit
from nonsmooth.solver.scenes.loaded import LoadedScene
from nonsmooth.solver.trade.measured import trade, ways

from ..about import Given
from ..output import Destination, drawn_by
from ..problems import no_orbit
from ..progress import progress
from . import tables
from .case import case_from


def run(given: Given[LoadedScene], to: Destination) -> int:
    """Measure, show, write; the exit status."""
    case = case_from(given)
    try:
        with progress(1 + len(ways(case)), "tradeoff") as advance:
            result = trade(case, advance)
    except NoOrbit as finding:
        raise no_orbit(finding) from finding
    methods = dict.fromkeys(method for method, _ in ways(case))
    text = documents.text(case, result.as_dict(), methods)
    to.show(text, tables.trade(result))
    to.write(text, drawn_by("sweeps.trade_figure", result))
    return 0
