"""The commands that the paper's oscillator has, some of them instead of those of any scene."""

from .digits import digits, stability
from .report import report
from .roots import roots
from .solve import solve
from .sweep import sweep
from .tradeoff import tradeoff

#: In the order of ``nonsmooth --help``.
COMMANDS = (solve, sweep, roots, digits, stability, tradeoff, report)
