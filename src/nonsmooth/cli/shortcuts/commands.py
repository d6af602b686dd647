"""The commands that the paper's oscillator has, some of them instead of those of any scene."""

from .report import report
from .roots import roots
from .solve import solve
from .stability import stability
from .sweep import sweep
from .tradeoff import tradeoff

#: In the order of ``nonsmooth --help``.
COMMANDS = (solve, sweep, roots, stability, tradeoff, report)
