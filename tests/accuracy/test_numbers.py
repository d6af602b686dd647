"""The numbers to reproduce at alpha = 1, computed elsewhere in 70 digits."""

import pytest

import nonsmooth as ns

#: Method, order, T/T_exact - 1, t1 in 1/omega_n, error (22) on normalised time.
TABLE = [
    ("hb", 1, -2.1954594193e-02, 1.5954231315, 4.293165e-01),
    ("hb", 3, -1.2143313348e-02, 1.8230530724, 2.188128e-01),
    ("hb", 10, -4.4732321531e-03, 1.9387994591, 1.165467e-01),
    ("hb", 40, -1.2353669413e-03, 1.9833420403, 5.858168e-02),
    ("hb-c1", 1, -1.6823644082e-02, 1.6717970065, 3.995075e-01),
    ("hb-c1", 2, 1.1966743444e-03, 2.0146800478, 7.939342e-02),
    ("hb-c1", 3, -1.6532019025e-03, 1.9773402595, 7.570245e-02),
    ("hb-c1", 10, -1.0584104192e-04, 1.9985755231, 1.780582e-02),
    ("hb-c1", 40, -1.8802313730e-06, 1.9999747548, 2.292212e-03),
    ("c1", 3, -3.2190935766e-03, 2.0664684046, 1.309510e-01),
    ("c1", 4, 5.2573137163e-04, 1.8256599426, 9.367631e-02),
    ("c1", 5, 5.4627209206e-05, 1.9969932539, 2.319290e-02),
    ("c1", 7, -7.7046783053e-07, 2.0000745382, 3.650406e-03),
    ("c1", 10, -6.7957022274e-09, 2.0000014687, 5.094122e-04),
    ("c1", 13, 2.8474088305e-13, 1.99999999991658, 3.834424e-06),
]

OTHER = ns.StickSlip(
    mass=0.02, stiffness=8.0, belt_speed=3.0, mu_s=0.7, mu_k=0.6, normal_force=12.0
)


def at_alpha_1(belt: ns.StickSlip) -> ns.StickSlip:
    """Return `belt` with the belt speed that makes alpha = 1."""
    values = {name: getattr(belt, name) for name in ("mass", "stiffness", "mu_s", "mu_k")}
    speed = belt.alpha * belt.belt_speed
    return ns.StickSlip(**values, belt_speed=speed, normal_force=belt.normal_force)


@pytest.mark.parametrize("which", ["default", "other"])
@pytest.mark.parametrize(("method", "order", "period", "t1", "acceleration"), TABLE)
def test_errors_at_alpha_1(
    method: str,
    order: int,
    period: float,
    t1: float,
    acceleration: float,
    which: str,
    belt: ns.StickSlip,
) -> None:
    chosen = belt if which == "default" else at_alpha_1(OTHER)
    orbit = ns.solve(chosen, method, order)
    # the equations of hb-c1 have a condition of 4e6 at N = 40: rounding is worth 1e-9 of T
    rounding = 1e-11 if method == "hb-c1" else 1e-12
    assert orbit.errors.period == pytest.approx(period, rel=1e-8, abs=rounding)
    assert orbit.t1 * chosen.omega_n == pytest.approx(t1, abs=6e-11)
    # (22) to half of the last of seven digits; near its floor a part in 1e-5.
    assert orbit.errors.acceleration == pytest.approx(
        acceleration, rel=2.2e-7, abs=1e-9 if method == "hb-c1" else 1e-10
    )


def test_every_row_of_the_paper_is_an_orbit(belt: ns.StickSlip) -> None:
    sweep = ns.sweep(belt, ["hb", "hb-c1", "c1"], range(1, 41))
    assert len(sweep.rows) == 120
    assert {row.status for row in sweep.rows} == {"ok"}
    # those of the coarse orbit from which each starts are counted
    assert max(row.iterations for row in sweep.rows) <= 18
    for row in sweep.of("c1")[19:]:
        assert row.errors is not None
        assert abs(row.errors.period) < 1e-15
