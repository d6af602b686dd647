"""The remark that the idea holds in space, too: structures of Sections 1 and 3.3."""

from dataclasses import dataclass

#: What is shown: the structures that the paper names.
NAMES = (
    "beam-rotational-spring",
    "beam-spring",
    "beam-mass",
    "beam-crack",
    "string-mass",
)

#: Method, order and forced modes of each column.
COLUMNS = (("ritz", 16, None), ("ritz-ck", 8, 1), ("ritz-ck", 8, 2), ("ck", 4, None))

#: Relative error of a frequency below which only rounding is seen.
ROUNDING = 1e-15


@dataclass(frozen=True)
class SpaceRow:
    """One structure: its class, and the error of its lowest frequency by each expansion."""

    title: str
    name: str
    k: int
    errors: tuple[str, ...]


def heads() -> tuple[str, ...]:
    """Return the headings of the columns: the expansion and its size."""
    words = {"ritz": "{N} sines", "ck": "Cᵏ functions, N = {N}"}
    forced = "{N} sines, {K} forced mode{s}"
    return tuple(
        words.get(method, forced).format(N=N, K=K, s="s" if K != 1 else "")
        for method, N, K in COLUMNS
    )


def rows() -> list[SpaceRow]:
    """Return the table of the remark, computed anew."""
    from nonsmooth.solver.space.modes import modes  # noqa: PLC0415

    found = []
    for name in NAMES:
        errors = []
        for method, order, forced in COLUMNS:
            expansion = modes(name, method, order, forced, count=1)
            errors.append(_shown(abs(expansion[0].error)))
        structure = expansion.structure
        found.append(SpaceRow(structure.title, name, structure.k, tuple(errors)))
    return found


def _shown(error: float) -> str:
    if error < ROUNDING:
        return "rounding"
    return f"{error:.1e}" if error < 0.1 else f"{error:.0%}"
