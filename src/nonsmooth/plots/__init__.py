"""Every picture of a result: on axes of the caller's, and as a figure of the command line.

``draw`` in a module draws one thing on one pair of axes: it is behind the ``plot`` methods of
results, the figures of the command line and those of the report.
"""

from ..extras import require

require("matplotlib", "plot", "a picture")
