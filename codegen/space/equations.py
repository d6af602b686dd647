"""A structure for a reader: its problem, its exact modes, the three expansions, their rates."""

from collections.abc import Iterable, Iterator

import sympy as sp

from ..system import Equation, Inner, Section, line
from . import forced_modes, green, matching, series
from .data import Structure, a, beta, lam, s, x
from .structures import structure_named

n, N, i, j, l = sp.symbols("n N i j l", integer=True, positive=True)
u, g = sp.Function("u"), sp.IndexedBase("g")
phi, bare, r, S, left_over = (sp.IndexedBase(name) for name in ("phi", "mu", "r", "S", "s"))
G, zero = sp.Symbol("G"), sp.Integer(0)

#: What is shown of each expansion, by its generic name.
METHODS = ("ritz", "ritz-ck", "ck")


def sections(name: str | Structure, methods: Iterable[str] = ()) -> list[Section]:
    """Return the sections on a structure: what it is, its exact modes, and each expansion.

    Parameters
    ----------
    name : str or Structure
    methods : iterable of str
        Of `METHODS`, also spelled with the class; without any, all.

    Raises
    ------
    ValueError
        If a name is unknown.

    Examples
    --------
    >>> [section.heading for section in sections("string-mass", ["ritz"])][1:]
    ['Exact modes', 'Sines (ritz)']
    """
    structure = name if isinstance(name, Structure) else structure_named(name)
    shown = {
        "ritz": ("Sines (ritz)", _ritz),
        "ritz-ck": (f"Sines and forced modes (ritz-c{structure.k})", _forced),
        "ck": (f"Functions of class `C^{structure.k}` only (c{structure.k})", _series),
    }
    chosen = [_generic(structure, method) for method in methods] or list(METHODS)
    heading = f"{structure.name} (`C^{structure.k}`): {structure.title}"
    listed = [
        Section(heading, tuple(_problem(structure)), _parameters(structure)),
        Section("Exact modes", tuple(_exact(structure))),
    ]
    for method in chosen:
        title, equations = shown[method]
        listed.append(Section(title, tuple(equations(structure))))
    return listed


def _generic(structure: Structure, method: str) -> str:
    generic = method.replace(f"c{structure.k}", "ck")
    if generic not in METHODS:
        expected = f"one of {', '.join(METHODS)}: {structure.name} is C{structure.k}"
        raise ValueError(f"method: got {method!r}, expected {expected}")
    return generic


def _parameters(structure: Structure) -> str:
    listed = "; ".join(
        f"`{each.symbol}`: {each.what} in {each.unit}" for each in structure.parameters
    )
    source = f"  See {structure.source}." if structure.source else ""
    return f"Parameters: {listed}.{source}  Lengths are parts of `L`, `b = 1 - a`."


def _derivative(order: int, at: sp.Expr = x) -> sp.Expr:
    """Return a derivative of the mode shape, with primes."""
    return sp.Function("u" + "'" * order)(at)


def _jump(order: int) -> sp.Expr:
    """Return the jump of a derivative of the mode shape at the attachment."""
    before, behind = sp.Symbol("a^-"), sp.Symbol("a^+")
    return _derivative(order, behind) - _derivative(order, before)


def _problem(structure: Structure) -> Iterator[Equation]:
    m = structure.m
    equation = (-1) ** m * _derivative(2 * m)
    yield line("equation of the mode; away from the attachment", (equation, lam * u(x)))
    yield line("eigenvalue and wave number", (lam, beta ** (2 * m)))
    for end in (0, 1):
        for order in (0, 2)[:m]:
            words = "supported at" if order == 0 else "free of moment at"
            yield line(f"{words} `x = {end}`", (_derivative(order, sp.Integer(end)), zero))
    for order in range(2 * m):
        if order != structure.broken:
            yield line(f"derivative {order} is continuous at `x = a`", (_jump(order), zero))
    law = structure.law * _derivative(structure.felt, a)
    yield line(
        f"what jumps first: the modes are of class `C^{structure.k}`",
        (_jump(structure.broken), law),
    )
    yield line("strength of the attachment", (s, structure.strength))
    omega = sp.Symbol("omega")
    yield line("angular frequency", (omega, beta**m * structure.bare.frequency))


def _exact(structure: Structure) -> Iterator[Equation]:
    first, second = green.response(structure)
    words = f"response to a unit load on derivative {structure.felt} at `x = a`; `x <= a`"
    yield line(words, (sp.Function("R")(x), first + second))
    yield line(
        "receptance: that derivative of it at `x = a`", (G, sum(green.receptance(structure)))
    )
    yield line("equation of the attachment", (structure.equation(G), zero))
    yield line("characteristic equation", (green.characteristic(structure), zero))
    factor = matching.check_determinant(structure)
    yield line(
        "determinant of the matching conditions, over the left side of that",
        (sp.Symbol("D"), factor),
    )
    wave = n * sp.pi
    around = (sp.sin(wave * a), sp.cos(wave * a), -sp.sin(wave * a))[structure.felt]
    yield line("modes without the attachment", (phi[n], sp.sqrt(2) * sp.sin(wave * x)))
    yield line("their eigenvalues", (bare[n], wave ** (2 * structure.m)))
    yield line(
        "what the attachment feels of them; where it is zero, the mode stays",
        (r[n], sp.sqrt(2) * wave**structure.felt * around),
    )


def _scalar(structure: Structure, last: sp.Expr, tail: sp.Expr) -> sp.Expr:
    """Return the equation of an expansion, with sines up to `last` and a tail."""
    total = sp.Sum(r[n] ** 2 / (bare[n] - lam), (n, 1, last)) + tail
    if structure.kind == "compliance":
        inner = sp.Sum(r[n] ** 2 / (bare[n] ** 2 * (bare[n] - lam)), (n, 1, last)) + tail
        return 1 - s * lam * (S[2] + lam * inner)
    return structure.equation(total)


def _ritz(structure: Structure) -> Iterator[Equation]:
    c = sp.IndexedBase("c")
    yield line("expansion", (u(x), sp.Sum(c[n] * phi[n], (n, 1, N))))
    if structure.kind == "compliance":
        yield line(
            "no sine has a jump: the modes are those without the attachment, at any order",
            (lam, bare[n]),
        )
        return
    yield line("all conditions as one equation", (_scalar(structure, N, zero), zero))
    yield from _rate(structure, 0)


def _rate(structure: Structure, K: int) -> Iterator[Equation]:
    power = forced_modes.rate(structure, K)
    forced = f" with {K} forced mode{'s' if K > 1 else ''}" if K else ""
    words = f"the error of the eigenvalue{forced} falls like"
    yield line(words, (N ** sp.Integer(-power),))


def _forced(structure: Structure) -> Iterator[Equation]:
    c, d = sp.IndexedBase("c"), sp.IndexedBase("d")
    K = sp.Symbol("K", integer=True, positive=True)
    expansion = sp.Sum(c[n] * phi[n], (n, 1, N)) + sp.Sum(d[i] * g[i], (i, 1, K))
    yield line("expansion", (u(x), expansion))
    yield from _forced_modes(structure)
    yield from _products(structure)
    yield from _tails(structure, K)
    for number in range(1, forced_modes.MOST + 1):
        yield from _rate(structure, number)


def _forced_modes(structure: Structure) -> Iterator[Equation]:
    for number in range(1, forced_modes.MOST + 1):
        left, right = map(sp.factor, forced_modes.forced_mode(structure, number))
        yield line(f"forced mode {number}; `x <= a`", (g[number], left))
        if number == 1:
            yield line(f"forced mode {number}; `a < x`", (g[number], right))
    lowest = 2 if structure.kind == "compliance" else 1
    for number in range(lowest, lowest + 2):
        total = sp.Sum(r[n] ** 2 / bare[n] ** number, (n, 1, sp.oo))
        sides = (S[number], total, forced_modes.static_sum(structure, number))
        yield line("sum of what is felt, a Bernoulli polynomial of `a`", sides)


def _products(structure: Structure) -> Iterator[Equation]:
    primes = "'" * structure.m
    primed = sp.IndexedBase(f"g{primes}")
    sine = (Inner(phi[n], g[i]), r[n] / bare[n] ** i)
    yield line("inner product with a sine: one term", sine)
    yield line("inner product of two", (Inner(g[i], g[j]), S[i + j]))
    but = ", on both sides; zero for the first by itself"
    words = f"of their derivatives {structure.m}{but if structure.kind == 'compliance' else ''}"
    yield line(words, (Inner(primed[i], primed[j]), S[i + j - 1]))


def _tails(structure: Structure, K: sp.Symbol) -> Iterator[Equation]:
    remainder = sp.Sum(r[n] ** 2 / bare[n] ** i, (n, N + 1, sp.oo))
    yield line("sums over the modes left out", (left_over[i], remainder))
    tail = sp.Function("t_K")(lam)
    yield line("all conditions as one equation", (_scalar(structure, N, tail), zero))
    shift = 2 if structure.kind == "compliance" else 0
    names = {old: left_over[q + 1 + shift] for q, old in enumerate(forced_modes.sums(2))}
    closed = forced_modes.tail(1).subs(names, simultaneous=True)
    words = "tail of two forced modes" if shift else "tail of one forced mode"
    yield line(words, (sp.Function("t_2" if shift else "t_1")(lam), closed))
    power_series = sp.Sum(lam ** (i - 1) * left_over[i + shift], (i, 1, 2 * K - shift))
    words = "any tail, as a power series: to this order that of all modes left out"
    yield line(words, (tail, power_series))


def _series(structure: Structure) -> Iterator[Equation]:
    m, k = structure.m, structure.k
    order = max(k + 1, m)
    d, P = sp.IndexedBase("d"), sp.IndexedBase("P^*")
    expansion = sp.Sum(d[l] * P[l], (l, 0, N))
    sign = "`0 <= x < a`, and with coefficients of its own beyond"
    yield line(f"expansion of derivative {order}; {sign}", (_derivative(order), expansion))
    h = sp.Symbol("h", positive=True)
    integral = sp.Integral(P[l], (sp.Symbol("x"), 0, sp.Symbol("x")))
    yield line(
        "integration, on a segment of length `h`",
        (integral, series.integral_factor() * (P[l + 1] - P[l - 1])),
    )
    yield line("norm", (Inner(P[l], P[l]), series.norm_squared().subs(series.h, h)))
    for derivative in range(min(order, k + 1)):
        words = f"derivative {derivative} is continuous at `x = a`"
        yield line(words, (_jump(derivative), zero))
    for end in (0, 1):
        yield line(f"supported at `x = {end}`", (u(sp.Integer(end)), zero))
    Lam, psi = sp.IndexedBase("Lambda"), sp.IndexedBase("r")
    total = sp.Sum(psi[i] ** 2 / (Lam[i] - lam), (i, 1, sp.Symbol("M")))
    words = "the attachment, in the modes of the expansion without it"
    if structure.kind == "compliance":
        hinge = sp.Symbol("h_0")
        left = 1 - s * lam * (hinge + lam * total)
    else:
        left = structure.equation(total)
    yield line(words, (left, zero))
