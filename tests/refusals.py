"""Commands that are refused: status 2, one line on stderr, nothing on stdout."""


def refused(run, *arguments: object, below: int = 0) -> str:
    """Return the one line of an error with status 2, and so many indented ones below it."""
    status, out, err = run(*arguments)
    assert status == 2, (out, err)
    assert out == ""
    assert err.count("\n") == 1 + below == 1 + err.count("\n  "), err
    assert err.startswith("nonsmooth: ")
    return str(err)
