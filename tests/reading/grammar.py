"""From tokens to an expression in the plain words of `plain`: the notation of the paper."""

import re
from collections.abc import Sequence

import sympy as sp

from .plain import made, named
from .tokens import Cases, Cursor, Fraction, ReadingError, Root, Sub, Sup, Token

#: What an opening bracket applies: names without an index, and names with one.
FUNCTIONS = {*"xyabGRSqH", "sin", "cos", "atan", "sign", "max", "jacobi", "xi", "eta", "zeta"}
FUNCTIONS |= {"g1", "R1", "R2", "R3", "j0", "j1", "j2", "j3", "j_l"}
INDEXED_FUNCTIONS = {"R", "g", "P*", "Q", "j"}

CLOSING = {"(": ")", "[": "]"}


def _is_label(token: Token | None) -> bool:
    """Whether a superscript belongs to the name: ``H^s``, ``S^(1)``, ``P^*``."""
    if not isinstance(token, Sup):
        return False
    inside = token.inside
    bracketed = len(inside) == 3 and inside[0] == "(" and inside[1].isdigit()
    return bracketed or inside in {("s",), ("c",), ("*",)}


class _Reader(Cursor):
    """Reads from left to right; `spaced` if factors stand side by side without a sign."""

    def __init__(self, tokens: Sequence[Token], spaced: bool) -> None:
        super().__init__(tokens)
        self.spaced = spaced

    def inside(self, tokens: Sequence[Token], spaced: bool | None = None) -> sp.Expr:
        return expression(tokens, self.spaced if spaced is None else spaced)

    def terms(self) -> sp.Expr:
        negative = self.passes("-")
        total = [-self.product() if negative else self.product()]
        while self.next() in {"+", "-"}:
            total.append(self.product() if self.take() == "+" else -self.product())
        return sp.Add(*total)

    def product(self) -> sp.Expr:
        factors = [self.factor()]
        while self.passes("⋅") or (self.spaced and self._starts()):
            factors.append(self.factor())
        return sp.Mul(*factors)

    def _starts(self) -> bool:
        token = self.next()
        if isinstance(token, str):
            opens = token[0].isalnum() or token in {"(", "[", "∑", "∫", "⟨"}
            return opens and not re.fullmatch("d[a-z]+", token)
        return isinstance(token, Fraction | Root | Cases)

    def factor(self) -> sp.Expr:
        base = self.atom()
        if isinstance(self.next(), Sup):
            return base ** self.inside(self.take().inside, spaced=True)
        return base ** self.atom() if self.passes("**") else base

    def atom(self) -> sp.Expr:
        token = self.take()
        match token:
            case Fraction():
                found = self.fraction(token)
            case Root():
                found = sp.sqrt(self.inside(token.inside))
            case Cases():
                found = made(
                    "cases", *(self.inside(part) for row in token.rows for part in row)
                )
            case "∑" | "∫":
                found = self.summed(token)
            case "⟨":
                found = made("inner", *self.listed("⟩"))
            case "(" | "[":
                found = self.terms()
                self.take(CLOSING[token])
            case str() if token.isdigit():
                found = sp.Rational(int(token), int(self.take() if self.passes("/") else 1))
            case str() if token[0].isalpha():
                found = self.name(token)
            case _:
                raise ReadingError(f"{token!r} where a factor is due")
        return found

    def fraction(self, token: Fraction) -> sp.Expr:
        above, below = token.above, token.below
        if below[0] == "∂" and above[0] == "∂":
            of = self.inside(above[1:]) if above[1:] else self.factor()
            return made("D", of, self.inside(below[1:]))
        return self.inside(above) / self.inside(below)

    def summed(self, sign: str) -> sp.Expr:
        limits = {}
        while isinstance(self.next(), Sub | Sup):
            token = self.take()
            limits[type(token)] = token.inside
        if set(limits) != {Sub, Sup}:
            raise ReadingError(f"{sign} without its limits")
        start, end = limits[Sub], self.inside(limits[Sup])
        if sign == "∑":
            if start[1:2] != ("=",):
                raise ReadingError(f"a sum from {start}")
            body = -self.product() if self.passes("-") else self.product()
            return made("Sum", body, self.inside(start[:1]), self.inside(start[2:]), end)
        body = self.product()
        variable = self.take()
        if not re.fullmatch("d[a-z]+", str(variable)):
            raise ReadingError(f"an integral that ends in {variable!r}")
        return made("Int", body, sp.Symbol(variable[1:]), self.inside(start), end)

    def listed(self, closing: str) -> list[sp.Expr]:
        """Return what stands between commas, up to a closing bracket."""
        parts = [self.terms()]
        while self.passes(","):
            parts.append(self.terms())
        self.take(closing)
        return parts

    def name(self, name: str) -> sp.Expr:
        """Return a name with label, primes and indices; applied, if it is a function."""
        if _is_label(self.next()):
            label = "".join(self.take().inside).strip("()")
            name += label if label in {"*", "1", "3"} else f"^{label}"
        primes = self.primes()
        indices = None
        if isinstance(self.next(), Sub):
            indices = _Reader(self.take().inside, spaced=True).indices()
        elif self.passes("["):
            indices = self.listed("]")
        primes += self.primes()
        raised = self.next()
        if name == "P" and isinstance(raised, Sup) and "," in raised.inside:
            self.take()
            weights = _Reader(raised.inside[1:], self.spaced).listed(")")
            self.take("(")
            return named("jacobi", (), 0, [*indices, *weights, *self.listed(")")])
        known = FUNCTIONS if indices is None else INDEXED_FUNCTIONS
        if name not in known or not self.passes("("):
            return named(name, indices or (), primes)
        arguments = self.listed(")")
        if name == "max":
            arguments.sort(key=str)
        return named(name, indices or (), primes, arguments)

    def indices(self) -> list[sp.Expr]:
        """Return the indices of a subscript, with commas between them or side by side."""
        if len(self.tokens) == 2 and self.tokens[0].isdigit() and self.tokens[1] in "eo":
            return [sp.Integer(self.tokens[0]), sp.Symbol(self.tokens[1])]
        parts = [self.terms()]
        while self.passes(","):
            parts.append(self.terms())
        self.end()
        return parts


def expression(tokens: Sequence[Token], spaced: bool) -> sp.Expr:
    """Return the expression that the tokens are."""
    if len(tokens) > 1 and isinstance(tokens, tuple) and "=" in tokens:
        return made("equal", *(expression(side, spaced) for side in sides(tokens)))
    reader = _Reader(tokens, spaced)
    total = reader.terms()
    reader.end()
    return total


def sides(tokens: Sequence[Token]) -> list[list[Token]]:
    """Return the tokens of each side of a chain of equal sides."""
    found: list[list[Token]] = [[]]
    for token in tokens:
        if token == "=":
            found.append([])
        else:
            found[-1].append(token)
    return found
