"""Mistakes in the tables that commands print: a wrong column, heading, unit or mark."""

from ..mutant import Mutant

TABLES = ("tests/cli/test_printed_tables.py", "tests/cli/test_printed_measurements.py")


def table(what: str, old: str, new: str, file: str = "tables.py") -> Mutant:
    """Return a mistake in a printed table."""
    return Mutant(what, f"src/nonsmooth/cli/shortcuts/{file}", old, new, TABLES)


MUTANTS: tuple[Mutant, ...] = (
    table(
        "two columns of the sweep swapped",
        'f"{errors.t1:.3e}",\n            f"{errors.acceleration:.3e}",',
        'f"{errors.acceleration:.3e}",\n            f"{errors.t1:.3e}",',
    ),
    table(
        "two headings of the sweep swapped",
        '"T/T_ex-1", "t1/t1_ex-1", "(22)"',
        '"T/T_ex-1", "(22)", "t1/t1_ex-1"',
    ),
    table(
        "the estimate of t1 in the sweep",
        '            f"{row.estimate.period:.1e}",',
        '            f"{row.estimate.t1:.1e}",',
    ),
    table(
        "(22) and the aligned error of solve swapped",
        '        "(22)",\n        "aligned",',
        '        "aligned",\n        "(22)",',
    ),
    table(
        "the exact times swapped",
        'f"{reference.period:.9g}", "", f"{reference.t1:.7g}"',
        'f"{reference.t1:.9g}", "", f"{reference.period:.7g}"',
    ),
    table(
        "the digits of t1 by the estimate of the period, and of the period",
        "t1 = certain_digits(orbit.t1, orbit.estimate.t1)",
        "t1 = certain_digits(orbit.period, orbit.estimate.t1)",
    ),
    table(
        "two rates swapped",
        '("period", "t1", "acceleration")))',
        '("t1", "period", "acceleration")))',
    ),
    table(
        "amplitude and stick fraction along a parameter swapped",
        '"T [s]", "amp. [m]", "stick/T", "estimate")',
        '"T [s]", "stick/T", "amp. [m]", "estimate")',
    ),
    table(
        "a wrong unit along a parameter",
        "heading = SYMBOLS[parameter]",
        'heading = "V"',
        "families/family_shown.py",
    ),
    table(
        "the largest error at the last point",
        "i = int(np.argmax(errors))",
        "i = len(errors) - 1",
        "families/family_shown.py",
    ),
    table(
        "error and estimate of tradeoff swapped",
        '"time [s]", "T/T_ex-1", "estimate", "front")',
        '"time [s]", "estimate", "T/T_ex-1", "front")',
    ),
    table(
        "the front marks what is not on it",
        '"*" if point.front else ""',
        '"" if point.front else "*"',
    ),
    table(
        "the stable form printed twice",
        "*_form(cell.printed),",
        "*_form(cell.stable),",
    ),
    table(
        "a target that is always met",
        '"yes" if cell.met else "NO"',
        '"yes"',
    ),
    table(
        "t1 and the period of the roots swapped",
        '("slip", "t1", "period"))',
        '("slip", "period", "t1"))',
    ),
    table(
        "the slip of a root is its stick",
        'row = {"slip": T - t1,',
        'row = {"slip": t1,',
        "roots.py",
    ),
)
