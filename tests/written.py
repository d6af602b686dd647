"""Numbers as the report writes them, read back."""

_RAISED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹·−", "-0123456789.-")


def value(text: str) -> float:
    """Return a number as the report writes it."""
    head, _, power = text.partition("×10")
    return float(head.translate(_RAISED)) * 10.0 ** int(power.translate(_RAISED) or 0)
