"""Libraries that are installed with an extra, for what not everybody needs."""

from importlib.util import find_spec


class MissingExtra(ImportError):  # noqa: N818  (named like the other errors of the package)
    """A library that is not installed; the message says with which extra it is."""


def require(library: str, extra: str, what: str, package: str = "") -> None:
    """Check that a library of an extra is installed.

    Parameters
    ----------
    library, extra : str
        What is imported, and the extra that installs it.
    what : str
        What needs it, for the message.
    package : str
        Whose the library is, where that has another name.

    Raises
    ------
    MissingExtra
        An `ImportError`: saying how to install it.

    Examples
    --------
    >>> require("no_such", "plot", "a picture")
    Traceback (most recent call last):
    nonsmooth.extras.MissingExtra: a picture needs no_such: pip install 'nonsmooth[plot]'
    """
    if find_spec(library) is None:
        needs = f"{what} needs {package or library}"
        raise MissingExtra(f"{needs}: pip install 'nonsmooth[{extra}]'")
