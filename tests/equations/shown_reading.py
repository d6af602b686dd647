"""What is printed of a scene, spelled so that the readers of the paper's equations read it.

A word that is set high behind a name, ``d^flight``, becomes capitals behind it, and so do the
marks of the sides of a time; the record is spelled the same way, and both are compared.
"""

import re
import unicodedata
from collections.abc import Sequence
from textwrap import wrap

import pytest
import sympy as sp
from reading import grammar
from reading.compare import value
from reading.drawing import Drawing
from reading.grammar import expression, sides
from reading.latex import tokens as latex_tokens
from reading.plain import named, plain
from reading.tokens import ReadingError, Token

from nonsmooth.codegen.equations.conditions.functions import Member, Rate
from nonsmooth.codegen.printing import html
from nonsmooth.codegen.printing.latex import aligned
from nonsmooth.codegen.printing.words import spoken
from nonsmooth.codegen.system import Equation, Section

_RAISED = "ᵃᵇᶜᵈᵉᶠᵍʰⁱʲᵏˡᵐⁿᵒᵖʳˢᵗᵘᵛʷˣʸᶻ"
_WORD = re.compile(rf"(?<=[^\W\d])[{_RAISED}]{{3,}}")
_MARKS = {"+": "p", "-": "m", "⁺": "p", "⁻": "m"}


def spelled(record: sp.Basic, raised: bool) -> sp.Basic:
    """Return an expression of a record in the spelling in which it is read."""
    parts = [spelled(part, raised) for part in record.args]
    match record:
        case sp.Symbol():
            found = sp.Symbol(_name(record.name, raised), **record.assumptions0)
        case sp.Indexed():
            label = _label(str(record.base.label), raised)
            found = sp.IndexedBase(label)[tuple(parts[1:])]
        case sp.KroneckerDelta():
            found = sp.IndexedBase("Y" if raised else "delta")[record.args]
        case sp.Abs() | sp.factorial():
            found = parts[0]
        case sp.bernoulli() | sp.euler() | sp.legendre():
            letter = {"bernoulli": "B", "euler": "E", "legendre": "P"}[record.func.__name__]
            found = Member(sp.Symbol(letter), *parts)
        case Member():
            found = Member(sp.Symbol(_label(record.args[0].name, raised)), *parts[1:])
        case sp.Sum() | sp.Integral():
            found = record.func(parts[0], *record.limits)
        case sp.Derivative():
            found = sp.Derivative(parts[0], record.variables[0], evaluate=False)
        case _:
            found = record.func(*parts) if parts else record
    return found


def _name(name: str, raised: bool) -> str:
    """Return the name of a symbol; the reader takes a Greek capital for a small letter."""
    if name.endswith(("^+", "^-")):
        return _sided(name[:-2], name[-1])
    return "Z" if name == "Omega" and raised else name


def _label(label: str, raised: bool) -> str:
    name, _, word = label.partition("_")
    return name + word.upper() if raised and len(word) > 1 else label


def _sided(time: str, mark: str) -> str:
    return f"{time[0].replace('0', 'O')}{_MARKS[mark]}{time[1:]}"


def meant(side: sp.Basic, raised: bool) -> sp.Expr:
    """Return a side of a record in plain words, functions of scenes included."""
    known: dict[sp.Expr, sp.Expr] = {}

    def put(found: sp.Expr) -> sp.Expr:
        symbol = sp.Symbol(f"KEPT{len(known)}Q")
        known[symbol] = found
        return symbol

    def inside(e: sp.Basic) -> sp.Basic:
        if isinstance(e, Rate):
            return put(named("x", (), int(e.args[0]), (plain(e.args[1]),)))
        if isinstance(e, Member):
            name, index, argument = e.args
            letters, primes = name.name.rstrip("'"), name.name.count("'")
            parts = plain(index), plain(inside(argument))
            return put(named(letters, (parts[0],), primes, (parts[1],)))
        if not e.args or isinstance(e, sp.Indexed | sp.Derivative):
            return e
        if isinstance(e, sp.Sum | sp.Integral):
            return e.func(inside(e.function), *e.limits)
        return e.func(*map(inside, e.args))

    found = plain(inside(spelled(side, raised)))
    while found.free_symbols & known.keys():
        found = found.xreplace(known)
    return found


def drawn_tokens(equation: Equation, unicode: bool) -> list[Token]:
    """Return the tokens of an equation of a terminal, its words left out."""
    words = wrap(f"    -  {spoken(equation.words, unicode)}", 80, subsequent_indent=" " * 7)
    lines = equation.text(unicode).split("\n")[len(words) :]
    found: list[Token] = []
    for block in "\n".join(line[7:] for line in lines).strip("\n").split("\n\n"):
        found += _row([_readable(line) for line in block.split("\n")])
    return found


def _row(lines: list[str]) -> list[Token]:
    try:
        return Drawing(lines).read()
    except ReadingError:
        return [token for line in lines for token in Drawing([line]).read()]


def _readable(line: str) -> str:
    """Return a row of a drawing in signs that the reader knows, each in its place."""
    line = _WORD.sub(lambda q: unicodedata.normalize("NFKC", q[0]).upper(), line)
    line = re.sub(r"(?<=\()([T0t])([₀-₉]?)([⁺⁻])(?=\))", _sided_drawn, line)
    line = re.sub(r"(?<=\()([T0t])(\d?)\^([+-])(?=\))", _sided_drawn, line)
    if re.search("[<>]=|[≤≥]", line):
        line = re.sub(r"[│|](.*)[│|]", r"(\1)", re.sub("[<>]=|[≤≥]", "=", line))
    return line.replace("!", " ").replace("Ω", "Z").replace("δ", "Y")


def _sided_drawn(found: re.Match[str]) -> str:
    digit = unicodedata.normalize("NFKC", found[2])
    return _sided(found[1] + digit, found[3]).ljust(len(found[0]))


def typeset_tokens(equation: Equation) -> list[Token]:
    """Return the tokens of an equation in LaTeX."""
    return _typeset(aligned(equation).split("\n", 1)[1].rsplit("\n", 1)[0])


def page_tokens(equation: Equation) -> list[Token]:
    """Return the tokens of an equation on a page, as LaTeX, of which MathML is made there."""
    pieces: list[str] = []

    def convert(piece: str, display: str = "inline") -> str:
        pieces.extend([piece] if display == "block" else [])  # else a word's in the caption
        return f"<math display={display!r}/>"

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(html, "convert", convert)
        html.fragment_of([Section("", (equation,), "")])
    return _typeset(" ".join(pieces))


def _typeset(body: str) -> list[Token]:
    """Return the tokens of LaTeX, whose signs are replaced by those that the reader knows."""
    body = re.sub(r"\\?([A-Za-z]+)\^\{\\mathrm\{(\w+)\}\}", _capitals, body)
    body = re.sub(r"t\^\{([+-])\}_\{(\d)\}", lambda q: _upright("t" + q[2], q[1]), body)
    body = re.sub(r"\b([T0])\^\{([+-])\}", lambda q: _upright(q[1], q[2]), body)
    body = re.sub(r"x\^\{\((\d)\)\}", lambda q: "x" + "'" * int(q[1]), body)
    body = body.replace(r"\delta", " Y")  # delta would be a differential
    body = re.sub(r"\\(beta|nu)(?![A-Za-z])", r"\\mathrm{\1}", body)
    body = body.replace(r"\Omega", " Z ").replace(r"\cdot", "")
    body = re.sub(r"\\[lg]eq\b", "=", body)
    body = re.sub(r"\\left\||\\right\||!", "", body)
    body = re.sub(r"\\\\(?=\n)", "", body)
    return latex_tokens(body)


def _capitals(found: re.Match[str]) -> str:
    return rf"\mathrm{{{found[1]}{found[2].upper()}}}"


def _upright(time: str, mark: str) -> str:
    return rf"\mathrm{{{_sided(time, mark)}}}"


def wrong(equation: Equation, tokens: Sequence[Token], spaced: bool, raised: bool) -> str:
    """Return what is wrong with an equation that is read, or nothing."""
    (first, *_), relation = equation.sides, len(equation.sides) == 1
    shown = list(first.args) if relation else list(equation.sides)
    try:
        printed = [expression(side, spaced) for side in sides(tokens)]
    except (ReadingError, ZeroDivisionError) as error:
        return f"{equation.words}: cannot be read: {error}\n{equation.text()}"
    wanted = [meant(side, raised) for side in shown]
    same = [value(q) for q in printed] == [value(q) for q in wanted]
    return "" if same else f"{equation.words}: {printed} is printed for {wanted}"


@pytest.fixture
def functions(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let the reader know the functions of scenes."""
    families = {"beta", "r", "W", "J", "B", "E", "P"}
    words = (
        "flight",
        "stick",
        "slip",
        "contact",
        "separated",
        "slide",
        "stop",
        "rest",
        "crossing",
    )
    named_ = {f"{name}{end}" for name in families for end in ("", *map(str.upper, words))}
    named_ |= {f"{name}_{word}" for name in families for word in words}
    monkeypatch.setattr(grammar, "INDEXED_FUNCTIONS", grammar.INDEXED_FUNCTIONS | named_)
