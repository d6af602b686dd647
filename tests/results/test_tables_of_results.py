"""Results as tables of pandas and xarray: flat numbers with their units."""

import numpy as np
import pytest
from results_things import MAKERS, MOTIONS, thing

import nonsmooth as ns
from nonsmooth.solver.presentation.frames import column

WHY = "not installed: pip install 'nonsmooth[pandas,xarray]'"


@pytest.mark.parametrize("kind", MAKERS)
def test_columns_are_flat_and_of_one_length(kind: str) -> None:
    table = thing(kind).table()
    lengths = {len(column(values)) for values in table.columns.values()}
    assert len(lengths) == 1
    for name, values in table.columns.items():
        assert column(values).dtype.kind in "bfiU", name
    assert set(table.index) <= set(table.columns)
    assert all(isinstance(value, str | int | float) for value in table.about.values())


@pytest.mark.parametrize("kind", MOTIONS)
def test_a_motion_over_one_period(kind: str) -> None:
    motion = thing(kind)
    table = motion.table(samples=50)
    t = np.array(table.columns["t"])
    np.testing.assert_allclose(np.diff(t), motion.period / 50)
    assert t[0] == 0
    for name in ("displacement", "velocity", "acceleration"):
        np.testing.assert_array_equal(table.columns[name], getattr(motion, name)(t))
    assert table.units["acceleration"] == "m/s**2"
    starts = np.cumsum([0, *motion.durations])
    phase = np.array(table.columns["phase"])
    assert (starts[phase] <= t).all()
    assert (t < starts[phase + 1]).all()
    assert len(table.about["phases"].split()) == len(motion.durations)


def test_rows_that_have_no_orbit_have_no_numbers() -> None:
    table = thing("family").table()
    assert table.columns["status"] == ["ok", "ok", "no-orbit"]
    assert np.isnan(column(table.columns["period"])[2])
    assert table.columns["gap"] == [0.1, 0.2, 50.0]
    assert table.columns["largest_displacement"][0] == pytest.approx(0.1)
    assert table.columns["duration_1"][:2] == table.columns["period"][:2]
    assert "gap" not in table.about
    assert (table.units["gap"], table.units["duration_1"]) == ("m", "s")
    assert "durations" not in table.columns
    assert "extremes" not in table.columns


def test_rows_are_found_and_told_one_after_another() -> None:
    for kind in ("sweep", "sweep-belt"):
        sweep = thing(kind)
        assert len(sweep) == len(sweep.rows) == 6
        assert sweep[-1] is sweep.rows[-1]
        assert [row.order for row in sweep][:2] == [row.order for row in sweep[:2]]
    family = thing("family")
    assert family[1].value == 0.2
    assert [row.status for row in family] == ["ok", "ok", "no-orbit"]
    assert family[:1] == family.rows[:1]


@pytest.mark.parametrize("kind", MAKERS)
def test_a_dataframe(kind: str) -> None:
    pd = pytest.importorskip("pandas", reason=WHY)
    frame = thing(kind).to_dataframe()
    table = thing(kind).table()
    assert isinstance(frame, pd.DataFrame)
    assert list(frame.columns) == list(table.columns)
    numbers = frame.drop(columns=[n for n in ("method", "status", "message") if n in frame])
    dtypes = {str(kind) for kind in numbers.dtypes} - {"bool"}
    assert dtypes <= {"float64", "int64"}, dtypes
    assert frame.attrs["units"] == dict(table.units)
    for name in numbers:
        np.testing.assert_array_equal(frame[name], column(table.columns[name]))


@pytest.mark.parametrize("kind", MAKERS)
def test_a_dataset(kind: str) -> None:
    xr = pytest.importorskip("xarray", reason=WHY)
    found = thing(kind).to_xarray()
    table = thing(kind).table()
    assert isinstance(found, xr.Dataset)
    assert set(found.coords) == set(table.index)
    for name, unit in table.units.items():
        if name in found:
            assert found[name].attrs["units"] == unit
    assert found.attrs == dict(table.about)


def test_a_dataset_of_a_sweep_has_a_place_for_each_method_and_order() -> None:
    pytest.importorskip("xarray", reason=WHY)
    found = thing("sweep").to_xarray()
    for row in thing("sweep"):
        one = found.sel({"method": row.method, "order": row.order})
        assert float(one["error_times"]) == row.errors.times
        assert str(one["status"].values) == "ok"
    uneven = ns.sweep(ns.scene("impact")(), orders=[1, 4]).to_xarray()  # ck begins at 2
    assert np.isnan(float(uneven["period"].sel({"method": "ck", "order": 1})))


@pytest.mark.parametrize(
    ("method", "extra"), [("to_dataframe", "pandas"), ("to_xarray", "xarray")]
)
def test_without_the_library_the_extra_is_named(method: str, extra: str, monkeypatch) -> None:
    monkeypatch.setattr("nonsmooth.extras.find_spec", lambda name: None)
    with pytest.raises(ns.MissingExtra, match=rf"pip install 'nonsmooth\[{extra}\]'"):
        getattr(thing("orbit"), method)()
