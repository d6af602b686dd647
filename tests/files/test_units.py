"""Units: the table of all that is written, and that the motion is in SI units."""

import json
from pathlib import Path

import numpy as np
import pytest
import units
from units import BELT

import nonsmooth as ns
from nonsmooth.solver.kernels.registry import mathematics

SWEPT = ["t1", "duration_1", "duration_2", "period", "seconds"]
ENDS = {
    f"{end}_{name}" for end in ("least", "largest") for name in ("displacement", "velocity")
}


MAKERS = {
    "orbits": lambda: [ns.solve(BELT, method, 7) for method in ("hb", "c1")],
    "sweep": lambda: ns.sweep(BELT, ["c1"], [5, 6]),
    "family": lambda: ns.family(BELT, "stiffness", [700.0, 787.5], "c1", 9),
}


@pytest.mark.parametrize("kind", MAKERS)
def test_the_units_in_a_document_and_in_a_netcdf(kind: str, tmp_path: Path) -> None:
    made = MAKERS[kind]()
    ns.save(made, tmp_path / "result.json")
    document = json.loads((tmp_path / "result.json").read_text())
    for each in document.get("orbits", [document]):
        expected = units.PARAMETERS | units.OF_ANY_SCENE | units.WALL_TIME | {"period": "s"}
        assert expected.items() <= each["units"].items()
        assert all(unit == units.SCALARS[name] for name, unit in each["units"].items())
        assert (each["schema"], each["version"]) == (2, ns.__version__)
        own = ["hb"] if each.get("method") == "hb" else ["ck"]
        assert each["mathematics"] == mathematics(BELT.scene, own)

    netcdf4 = pytest.importorskip("netCDF4")
    ns.save(made, tmp_path / "result.nc")
    ends = {name: units.MOTION[name.partition("_")[2]] for name in ENDS}
    known = units.SCALARS | dict.fromkeys(SWEPT, "s") | ends
    with netcdf4.Dataset(tmp_path / "result.nc") as file:
        numbers = {v.name: v.units for v in file.variables.values() if v.dtype == "f8"}
        assert len(numbers) >= 4
        assert numbers == {name: known.get(name, "1") for name in numbers}
        if kind == "orbits":
            assert numbers.keys() == units.MOTION.keys()
            for name in numbers.keys() - {"t"}:
                assert np.array_equal(file[name][1], getattr(made[1], name)(file["t"][1]))
        own = {name for name in units.PARAMETERS if (kind, name) != ("family", "stiffness")}
        assert {name: file.getncattr(name) for name in own} == {
            name: BELT.values[name] for name in own
        }
        assert own == set(file.ncattrs()) & set(units.PARAMETERS)
