"""Read a page of HTML: its equations, their words, and the MathML of both."""

import xml.etree.ElementTree as ET
from collections.abc import Iterator
from dataclasses import dataclass

from .tokens import Cases, Fraction, ReadingError, Root, Sub, Sup, Token, letter

_OPERATORS = {"\N{MINUS SIGN}": "-", "′": "'", "¨": "''", "˙": "'", "″": "''"}


def _tag(element: ET.Element) -> str:
    return element.tag.rpartition("}")[2]


def _operator(element: ET.Element) -> list[Token]:
    text = (element.text or "").strip()
    text = _OPERATORS.get(text, text)
    return list(text) if text.strip("'") == "" else [text]


def _name(element: ET.Element) -> list[Token]:
    text = "".join(map(letter, element.text or ""))
    return ["'"] * len(text) if text.strip("′'") == "" else [text]


def _children(element: ET.Element) -> list[Token]:
    """Return the tokens of what is inside; letters that stand upright are one word."""
    found: list[Token] = []
    upright = [_tag(part) == "mi" and part.get("mathvariant") == "normal" for part in element]
    if len(upright) > 1 and all(upright):
        return ["".join(part.text or "" for part in element)]
    differential = ""
    for part in element:
        if _tag(part) == "mspace":
            differential = "?"
        elif differential == "?":
            differential = "d" if part.text == "d" else ""
            found += [] if differential else tokens(part)
        elif differential == "d":
            found.append("".join(map(str, ("d", *tokens(part)))))
            differential = ""
        elif _tag(part) == "mtable" and found and found[-1] == "{":
            found[-1:] = [_cases(part)]
        else:
            found += tokens(part)
    return found


def _cases(table: ET.Element) -> Cases:
    rows = []
    for row in table:
        value, condition = row
        words = condition[0].text
        rest = tuple(token for part in condition[1:] for token in tokens(part))
        if (words == "for") != bool(rest):
            raise ReadingError(f"the condition {words!r}")
        rows.append((tuple(tokens(value)), rest or (words,)))
    return Cases(tuple(rows))


def _over(base: ET.Element, above: ET.Element) -> list[Token]:
    raised = tokens(above)
    if raised and set(raised) == {"'"}:
        return [*tokens(base), *raised]
    return [*tokens(base), Sup(tuple(raised))]


def tokens(element: ET.Element) -> list[Token]:
    """Return the tokens of an element of MathML."""
    match _tag(element):
        case "math" | "mrow" | "mtd":
            found = _children(element)
        case "mi":
            found = _name(element)
        case "mn":
            found = [element.text or ""]
        case "mo":
            found = _operator(element)
        case "mspace":
            found = []
        case "mfrac":
            found = [Fraction(*(tuple(tokens(part)) for part in element))]
        case "msqrt":
            found = [Root(tuple(_children(element)))]
        case "msub":
            base, low = element
            found = [*tokens(base), Sub(tuple(tokens(low)))]
        case "msup" | "mover":
            found = _over(*element)
        case "msubsup" | "munderover":
            base, *parts = element
            low, high = (tuple(tokens(part)) for part in parts)
            scripts = [Sub(low), Sup(high)]
            # A label belongs to the name, before its index: H^s_j, S^(1)_j, P^*_n.
            label = high in {("s",), ("c",), ("*",)} or (high[0] == "(" and len(high) == 3)
            found = [*tokens(base), *(scripts[::-1] if label else scripts)]
        case other:
            raise ReadingError(f"an element {other}")
    return found


@dataclass
class Printed:
    """An equation as it was found: heading, anchor, words, number and its sides."""

    heading: str
    anchor: str
    words: str
    number: str
    sides: ET.Element

    def tokens(self) -> list[Token]:
        """Return the tokens of all formulas, one after the other."""
        return [token for formula in self.sides.iter() if _tag(formula) == "math"
                for token in tokens(formula)]  # fmt: skip


def _body(page: str) -> ET.Element:
    body = page.rpartition("<body>")[2].partition("</body>")[0]
    body = body.replace("<wbr>", "").replace("&nbsp;", " ")
    return ET.fromstring(f"<body>{body}</body>")


def equations(page: str) -> Iterator[Printed]:
    """Yield the equations of a page or a fragment."""
    heading = ""
    for element in _body(page).iter():  # what is folded as well
        if element.tag == "h2":
            heading = "".join(element.itertext())
        if element.tag != "figure":
            continue
        caption, sides, *number = element
        anchor = element.get("id", "")
        text = number[0].text if number else ""
        if bool(anchor) != bool(number) or (anchor and number[0].get("href") != f"#{anchor}"):
            raise ReadingError(f"anchor {anchor!r} and number {text!r}")
        words = "".join(caption.itertext())
        yield Printed(heading, anchor, words, (text or "").strip("()"), sides)
