"""``nonsmooth sweep --vary``: period, amplitude and stick along one parameter."""

import sys
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ...output import DATA, write_file, write_picture
from ...problems import Problem, about_option
from ...values.orders import is_whole
from .vary import parse_vary

if TYPE_CHECKING:
    from nonsmooth.solver.shortcuts.orbit.oscillator import StickSlip

    from .family_job import Job
    from .family_store import Store

#: Points of a picture, of each method.
PICTURE = 2_000


def run(job: "Job", json_: bool, output: Path | None) -> int:
    """Compute the points, or what of them is missing, then print and write them."""
    from nonsmooth.files.shortcuts.texts import stream_points  # noqa: PLC0415

    from .family_job import compute  # noqa: PLC0415
    from .family_shown import every, show  # noqa: PLC0415
    from .family_store import beside, check_room, opened  # noqa: PLC0415

    check_room(output, len(job))
    written = False
    try:
        with opened(output, job.plan()) as store:
            compute(job, store, output)
            if output is not None:
                _write(job, store, output)
                written = True
            if json_:
                stream_points(job.saved(store), sys.stdout)
            else:
                show(job, store)
            complete = not any(points["status"].any() for points in every(job, store))
    finally:
        if output is not None and written:
            beside(output).unlink(missing_ok=True)
    return 0 if complete else 1


def job_from(
    text: str,
    log: bool,
    belt: "StickSlip",
    flags: Mapping[str, float | None],
    methods: list[str] | None,
    orders: str | None,
    c1_terms: int,
) -> "Job":
    """Return what the command line asks for.

    Raises
    ------
    Problem
        If it cannot be computed.
    """
    vary = parse_vary(text, log)
    if flags[vary.parameter] is not None:
        raise Problem(f"--{vary.flag}: given beside --vary {vary.flag}, which sets it")
    import numpy as np  # noqa: PLC0415

    from nonsmooth.solver.case.parameters import ParameterError  # noqa: PLC0415
    from nonsmooth.solver.shortcuts.orbit.methods import METHODS, check_order, with_terms  # noqa: PLC0415
    from nonsmooth.solver.shortcuts.search import family  # noqa: PLC0415

    from .family_job import Job  # noqa: PLC0415

    if orders is not None and not is_whole(orders):
        raise Problem(f"--orders: got {orders!r} beside --vary, expected one order")
    order = family.ORDER if orders is None else int(orders)
    chosen = tuple(dict.fromkeys(methods or ["c1"]))
    ends = np.array([vary.first, vary.last])
    first: dict[str, Any] = {vary.parameter: vary.first}
    try:
        for name in chosen:
            terms = c1_terms if name == "hb-c1" else 1
            check_order(order, with_terms(METHODS[name], terms))
        family.check(belt, vary.parameter, ends)
        return Job(replace(belt, **first), vary, chosen, order, c1_terms)
    except ParameterError as error:
        raise Problem(f"--vary: {error}") from error
    except ValueError as error:
        raise about_option(error) from error


def _write(job: "Job", store: "Store", output: Path) -> None:
    if output.suffix.lower() in DATA:
        write_file(output, job.saved(store))
        return
    from nonsmooth.plots.shortcuts.families import family_figure  # noqa: PLC0415

    from .family_shown import spread  # noqa: PLC0415

    drawn = job.families(spread(job, store, PICTURE))
    write_picture(output, lambda: family_figure(drawn, job.vary.log))
