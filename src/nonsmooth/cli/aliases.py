"""One name for one thing: ``--method`` and ``--methods``, ``--order`` and ``--orders``.

`solve` is about one order, `sweep` about several; what one of them understands the other does.
Help and messages have the name that is documented.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import click

from .problems import Problem
from .values import parse_orders

if TYPE_CHECKING:
    IntegerType = click.ParamType[int]
else:  # not generic in click 8.2
    IntegerType = click.ParamType


class Aliased(click.Option):
    """An option with an alias that the help does not show."""

    def __init__(self, *arguments: Any, alias: str, **options: Any) -> None:
        super().__init__(*arguments, **options)
        self.alias = alias

    def add_to_parser(self, parser: Any, ctx: click.Context) -> None:
        """Add the option to a parser, by both names."""
        shown = self.opts
        self.opts = [*shown, self.alias]
        try:
            super().add_to_parser(parser, ctx)
        finally:
            self.opts = shown


class Once(click.Option):
    """An option that is given once: another would take the place of the first in silence."""

    def __init__(self, names: Sequence[str], **options: Any) -> None:
        super().__init__(names, multiple=True, callback=_only, **options)


def _only(ctx: click.Context, option: click.Parameter, values: tuple[Any, ...]) -> Any:
    """Return the single value of an option; None without it."""
    if len(values) > 1:
        listed = " and ".join(map(str, values))
        raise Problem(f"{option.opts[0]}: got {listed}, expected one of them")
    return values[0] if values else None


class OneOrder(IntegerType):
    """The type of one order, which may be written as a list of one, as `sweep` takes it."""

    name = "integer"

    def convert(
        self, value: Any, param: click.Parameter | None, ctx: click.Context | None
    ) -> int:
        """Return the order.

        A `Problem` is raised if these are several; it says which command takes them.
        """
        try:
            return int(value)  # one that is out of range is refused with the range
        except ValueError:
            pass
        try:
            orders = parse_orders(value)
        except Problem:
            self.fail(f"{value!r} is not a valid integer.", param, ctx)
        if len(orders) > 1:
            raise Problem(
                f"--order: got {value!r}, expected one order; "
                f"'nonsmooth sweep --orders {value}' takes several"
            )
        return orders[0]


def split_methods(text: str | None) -> list[str]:
    """Return the methods of a list with commas, each once; none of None.

    Examples
    --------
    >>> split_methods("hb, ck,hb"), split_methods(None)
    (['hb', 'ck'], [])
    """
    return [] if text is None else list(dict.fromkeys(q.strip() for q in text.split(",")))


def check_one_method(names: Sequence[str], beside: str) -> None:
    """Check that there is at most one method where an option takes no more.

    A `Problem` names the methods and the option.
    """
    if len(names) > 1:
        raise Problem(f"--method: got {','.join(names)!r} beside {beside}, expected one method")
