"""What the report writes, read back: its numbers, and the elements of its pages."""

from html.parser import HTMLParser

_RAISED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹·−", "-0123456789.-")


def value(text: str) -> float:
    """Return a number as the report writes it."""
    head, _, power = text.partition("×10")
    return float(head.translate(_RAISED)) * 10.0 ** int(power.translate(_RAISED) or 0)


class Elements(HTMLParser):
    """Every element of a page with its attributes, and those that are not closed."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.found: list[tuple[str, dict[str, str | None]]] = []
        self.open: list[str] = []
        self.feed(text)

    def handle_starttag(self, tag, attributes) -> None:
        self.handle_startendtag(tag, attributes)
        if tag not in {"meta", "br", "wbr", "hr", "img"}:
            self.open.append(tag)

    def handle_startendtag(self, tag, attributes) -> None:
        self.found.append((tag, dict(attributes)))

    def handle_endtag(self, tag) -> None:
        assert self.open.pop() == tag
