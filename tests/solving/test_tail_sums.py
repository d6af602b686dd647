"""Sums over the harmonics that a series leaves out, against mpmath's Lerch transcendent."""

import json
from pathlib import Path

import mpmath as mp
import pytest

from nonsmooth.solver.shortcuts.series.tail_sums import tail_sums

#: Real and imaginary parts of the sums, to 17 digits, under "N x p".  Written by
#: ``python tests/solving/test_tail_sums.py``, which takes a minute.
REFERENCE = Path(__file__).with_name("tail_sums.json")

HARMONICS = (0, 10, 1000)
ANGLES = (0.0, 1e-9, 1e-3, 0.7, 3.1, -0.4)
POWERS = (4, 5, 9, 24, 58)


def by_mpmath(N: int, x: float, p: int) -> tuple[str, str]:
    """Return the sum over m > N of exp(i m x)/m**p, to 17 digits."""
    with mp.workdps(40 + int(p * mp.log10(N + 1))):
        unit = mp.exp(1j * mp.mpf(x))
        whole = mp.lerchphi(unit, p, N + 1) if x else mp.zeta(p, N + 1)
        total = mp.mpc(unit ** (N + 1) * whole)
        return mp.nstr(total.real, 17), mp.nstr(total.imag, 17)


def reference() -> dict[str, list[str]]:
    table: dict[str, list[str]] = json.loads(REFERENCE.read_text("utf-8"))
    return table


@pytest.mark.parametrize("N", HARMONICS)
@pytest.mark.parametrize("x", ANGLES)
def test_sums_beyond_the_harmonics(N: int, x: float) -> None:
    found, table = tail_sums(N, x, max(POWERS)), reference()
    for p in POWERS:
        real, imaginary = table[f"{N} {x} {p}"]
        assert complex(found[p]) == pytest.approx(
            complex(float(real), float(imaginary)), rel=5e-13, abs=0.0
        )


@pytest.mark.parametrize(("N", "p"), [(0, 9), (0, 58), (10, 24), (10, 58), (1000, 58)])
@pytest.mark.parametrize("x", ANGLES)
def test_the_table_is_that_of_the_first_terms_where_they_fall_off_quickly(
    N: int, p: int, x: float
) -> None:
    with mp.workdps(30):
        terms = (mp.expj(m * mp.mpf(x)) / mp.mpf(m) ** p for m in range(N + 1, N + 400))
        expected = mp.mpc(*map(mp.mpf, reference()[f"{N} {x} {p}"]))
        assert abs(mp.fsum(terms) / expected - 1) < mp.mpf("1e-7")


@pytest.mark.long
def test_the_table_is_mpmaths() -> None:
    assert reference() == table_by_mpmath()


def table_by_mpmath() -> dict[str, list[str]]:
    return {
        f"{N} {x} {p}": list(by_mpmath(N, x, p))
        for N in HARMONICS
        for x in ANGLES
        for p in POWERS
    }


if __name__ == "__main__":
    REFERENCE.write_text(json.dumps(table_by_mpmath(), indent=1) + "\n", "utf-8")
