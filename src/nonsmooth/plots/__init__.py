"""Plots of results: on given axes, and as figures of the command line.

``draw`` in a module draws one quantity on one pair of axes.  The ``plot`` methods of results,
the figures of the command line and those of the report use it.
"""

from ..extras import require

require("matplotlib", "plot", "a picture")
