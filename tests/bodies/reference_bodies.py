"""The bodies of ``references.json`` as scenes, from the conventions that it states.

The orbits are from Newton's method in ball arithmetic of 60 digits on matrix exponentials.
"""

import json
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import sympy as sp

from nonsmooth.codegen.scene import Body, Event, Memory, Parameter, Phase, Scene
from nonsmooth.scene import find
from nonsmooth.solver.scenes.case import Case

Omega = sp.Symbol("Omega", positive=True)


@dataclass(frozen=True)
class Reference:
    """One orbit of the file, in floats."""

    name: str
    scene: str
    parameters: dict[str, Any]
    phases: tuple[str, ...]
    durations: tuple[float, ...]
    angle: float | None
    period: float
    half_period: bool
    cycles: int
    states: tuple[tuple[float, ...], ...]
    radius: float
    multipliers: tuple[complex, ...]
    admissible: bool


@cache
def references() -> tuple[Reference, ...]:
    """Return all orbits of the file."""
    path = Path(__file__).with_name("references.json")
    found = []
    for q in json.loads(path.read_text("utf-8"))["orbits"]:
        parameters = {
            name: [float(c) for c in value] if isinstance(value, list) else float(value)
            for name, value in q["parameters"].items()
        }
        durations = tuple(map(float, q["durations"]))
        found.append(
            Reference(
                q["name"],
                q["scene"],
                parameters,
                tuple(q["phases"]),
                durations,
                None if q["phase_angle"] is None else float(q["phase_angle"]),
                float(q["period"] or sum(durations)),
                q["half_period"],
                q["cycles"] or 1,
                tuple(tuple(map(float, state)) for state in q["states_after_switch"]),
                float(q["spectral_radius"]),
                tuple(complex(*map(float, pair)) for pair in q["multipliers"]),
                q["admissible"],
            )
        )
    return tuple(found)


def chain(p: dict[str, Any], ground: float = 1, end: float = 0) -> dict[str, Any]:
    """Return the matrices of unit masses with unit springs between neighbours."""
    n = int(p.get("n", 4))
    stiffness = p.get("k", 1.0)
    K = np.zeros((n, n))
    for i in range(n - 1):
        K[i : i + 2, i : i + 2] += stiffness * np.array([[1, -1], [-1, 1]])
    K[0, 0] += p.get("ground", ground) * stiffness
    K[-1, -1] += p.get("end", end) * stiffness
    C = p.get("cm", 0.0) * np.eye(n) + p["ck"] * K
    if "Cextra" in p:
        C[int(p["Cextra"][0]), int(p["Cextra"][0])] += p["Cextra"][1]
    return {"M": np.eye(n), "K": K, "C": C}


def cantilever(p: dict[str, Any]) -> dict[str, Any]:
    """Return the matrices of a cantilever of unit length, stiffness and mass, by Hermite."""
    ne = int(p["ne"])
    h = 1.0 / ne
    k = np.array(
        [[12, 6 * h, -12, 6 * h], [6 * h, 4 * h * h, -6 * h, 2 * h * h],
         [-12, -6 * h, 12, -6 * h], [6 * h, 2 * h * h, -6 * h, 4 * h * h]]
    ) / h**3  # fmt: skip
    m = np.array(
        [[156, 22 * h, 54, -13 * h], [22 * h, 4 * h * h, 13 * h, -3 * h * h],
         [54, 13 * h, 156, -22 * h], [-13 * h, -3 * h * h, -22 * h, 4 * h * h]]
    ) * (h / 420)  # fmt: skip
    M, K = np.zeros((2 * ne + 2, 2 * ne + 2)), np.zeros((2 * ne + 2, 2 * ne + 2))
    for e in range(ne):
        here = slice(2 * e, 2 * e + 4)
        M[here, here] += m
        K[here, here] += k
    M, K = M[2:, 2:], K[2:, 2:]
    M[-2, -2] += p["tip"]
    return {"M": M, "K": K, "C": p["alpha"] * M + p["beta"] * K}


def absorber(p: dict[str, Any]) -> dict[str, Any]:
    """Return the matrices of a mass and an absorber."""
    M = np.diag([1, p["m2"]])
    K = np.array([[p["k1"] + p["k2"], -p["k2"]], [-p["k2"], p["k2"]]])
    C = np.array([[p["c1"] + p["c2"], -p["c2"]], [-p["c2"], p["c2"]]])
    return {"M": M, "K": K, "C": C}


def unit(n: int, *places: tuple[int, float]) -> np.ndarray:
    found = np.zeros(n)
    for i, value in places:
        found[i] = value
    return found


def body(r: Reference) -> Body:
    p = r.parameters
    if r.scene.startswith("beam"):
        matrices = cantilever(p)
        n = len(matrices["M"])
        at = {"tip": unit(n, (n - 2, 1.0))}
    elif r.scene.startswith("absorber"):
        matrices, n = absorber(p), 2
        at = {"joint": np.array([-1.0, 1.0])}
    elif r.scene == "two_stops":
        matrices = chain(p)
        n = len(matrices["M"])
        at = {f"stop{i}": unit(n, (int(p[f"at{i}"]), 1.0)) for i in (0, 1)}
    else:
        matrices = chain(p)
        n = len(matrices["M"])
        at = {"end": unit(n, (int(p["at"]), 1.0))}
    forcing = unit(n, (int(p.get("force", 0)), p["F"])) if r.angle is not None else None
    return Body(**matrices, at=at, forcing=forcing)


@dataclass
class Maker:
    """What the phases of an orbit are made with: its parameters, in their order of use."""

    r: Reference
    body: Body
    parameters: list[Parameter]
    memory: list[Memory]

    def positive(self, name: str, unit_: str, value: float) -> sp.Symbol:
        symbol = sp.Symbol(name, positive=True)
        if symbol not in [q.symbol for q in self.parameters]:
            self.parameters.append(Parameter(name, symbol, unit_, value, name))
        return symbol

    def beside(self, i: int) -> tuple[str, str]:
        """Return the kinds of the phases before and after one; a half goes on mirrored."""
        kinds = self.r.phases
        before, after = kinds[i - 1], kinds[(i + 1) % len(kinds)]
        if self.r.half_period:
            before = MIRRORED.get(before, before) if i == 0 else before
            after = MIRRORED.get(after, after) if i == len(kinds) - 1 else after
        return before, after


#: What slips one way slips the other way in the mirror image.
MIRRORED = {"slip+": "slip-", "slip-": "slip+"}


def impact(make: Maker, name: str, i: int) -> Phase:
    p, contact = make.r.parameters, next(iter(make.body.at.values()))
    gap = make.positive("gap", "m", p["g"])
    ratio = make.positive("restitution", "", p["r"])
    event = Event(contact.x - gap, jump={contact.v: -ratio * contact.v})
    demands = {"before the stop": gap - contact.x}
    return Phase(name, contact.force, ends=event, demands=demands)


def spring(make: Maker, name: str, i: int) -> Phase:
    p, contact = make.r.parameters, next(iter(make.body.at.values()))
    gap, k = make.positive("gap", "m", p["g"]), make.positive("kc", "N/m", p["kc"])
    c = make.positive("cc", "N s/m", p["cc"]) if p.get("cc") else 0
    if make.r.phases[i] == "open":  # with a damper it begins beyond the gap
        demands = {} if c else {"before the stop": gap - contact.x}
        return Phase(name, contact.force, ends=Event(contact.x - gap), demands=demands)
    push = k * (contact.x - gap) + c * contact.v
    return Phase(name, contact.force + push, ends=Event(push), demands={"it presses": push})


def friction(make: Maker, name: str, i: int) -> Phase:
    p, contact = make.r.parameters, next(iter(make.body.at.values()))
    speed = make.positive("speed", "m/s", p["V"]) if "V" in p else sp.Integer(0)
    kinetic = make.positive("kinetic", "N", p.get("R", p.get("Fk", 0)))
    if make.r.phases[i] == "stick":
        static = make.positive("static", "N", p.get("Rs", p.get("Fs", 0)))
        limit = -static if make.beside(i)[1] == "slip+" else static
        demands = {"it sticks": static - sp.Abs(contact.force)}
        ends = Event(contact.force - limit)
        return Phase(name, contact.a, ends=ends, demands=demands, held=speed)
    sign = 1 if make.r.phases[i] == "slip+" else -1
    demands = {"it slips": sign * (contact.v - speed)}
    law = contact.force + sign * kinetic
    return Phase(name, law, ends=Event(contact.v - speed), demands=demands)


def jenkins(make: Maker, name: str, i: int) -> Phase:
    p, contact = make.r.parameters, next(iter(make.body.at.values()))
    k, limit = make.positive("kt", "N/m", p["kt"]), make.positive("limit", "N", p["R"])
    if make.r.phases[i] != "stick":
        sign = 1 if make.r.phases[i] == "slip+" else -1
        law, demands = contact.force + sign * limit, {"it slips": sign * contact.v}
        return Phase(name, law, ends=Event(contact.v), demands=demands)
    before, after = make.beside(i)
    z = sp.Symbol(f"z_at_{i}", real=True)
    start = contact.x - (1 if before == "slip+" else -1) * limit / k
    make.memory.append(Memory(z, name, start, "where the slider is"))
    push = k * (contact.x - z)
    demands = {"it sticks": limit - sp.Abs(push)}
    ends = Event(push - (1 if after == "slip+" else -1) * limit)
    return Phase(name, contact.force + push, ends=ends, demands=demands)


def two_stops(make: Maker, name: str, i: int) -> Phase:
    p, kind, after = make.r.parameters, make.r.phases[i], make.beside(i)[1]
    touching = {"open": set(), "first": {0}, "second": {1}, "both": {0, 1}}
    contacts = list(make.body.at.values())
    gaps = [make.positive(f"gap{j}", "m", p[f"g{j}"]) for j in (0, 1)]
    laws, demands = [], {}
    for j, contact in enumerate(contacts):
        k = make.positive(f"kc{j}", "N/m", p[f"kc{j}"])
        pressed = j in touching[kind]
        laws.append(contact.force + (k * (contact.x - gaps[j]) if pressed else 0))
        demands[f"stop {j}"] = (contact.x - gaps[j]) * (1 if pressed else -1)
    (changed,) = touching[kind] ^ touching[after]
    ends = Event(contacts[changed].x - gaps[changed])
    return Phase(name, tuple(laws), ends=ends, demands=demands)


#: The laws of each kind of scene of the file.
LAWS = {
    "impact_chain": impact,
    "beam_impact": impact,
    "clearance_chain": spring,
    "beam_spring": spring,
    "chain_friction": friction,
    "absorber_coulomb": friction,
    "belt_chain": friction,
    "absorber_jenkins": jenkins,
    "two_stops": two_stops,
}


def of(name: str) -> Reference:
    """Return a reference by its name."""
    return next(q for q in references() if q.name == name)


@cache
def scene(name: str) -> Scene:
    """Return the scene of a reference by its name; each phase has a name of its own."""
    r = of(name)
    make = Maker(r, body(r), [], [])
    names = [f"{kind.strip('+-')}_{i}" for i, kind in enumerate(r.phases)]
    found = tuple(LAWS[r.scene](make, each, i) for i, each in enumerate(names))
    frequency = None
    if r.angle is not None:
        frequency = Omega
        omega = r.parameters["Omega"]
        make.parameters.append(Parameter("frequency", Omega, "rad/s", omega, "of the forcing"))
    return Scene(
        f"of-{r.name}", r.name, tuple(make.parameters), found, body=make.body,
        frequency=frequency, half_period=r.half_period, memory=tuple(make.memory),
    )  # fmt: skip


@cache
def case(name: str) -> Case:
    """Return the case of a reference by its name."""
    return find(scene(name))(cycles=of(name).cycles)
