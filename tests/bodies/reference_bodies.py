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

#: Laws that are Coulomb's: slip with a force against the velocity, stick.
FRICTION = ("chain_friction", "absorber_coulomb", "belt_chain")

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


def phases(r: Reference, made: Body) -> tuple[tuple[Phase, ...], tuple[Memory, ...], list]:
    """Return the phases of an orbit, each with a name of its own."""
    p, contact = r.parameters, next(iter(made.at.values()))
    x, v, f = contact.x, contact.v, contact.force
    names = [f"{q.strip('+-')}_{i}" for i, q in enumerate(r.phases)]
    found, parameters = [], []

    def positive(name: str, unit_: str, value: float) -> sp.Symbol:
        symbol = sp.Symbol(name, positive=True)
        if symbol not in [q.symbol for q in parameters]:
            parameters.append(Parameter(name, symbol, unit_, value, name))
        return symbol

    memory = []
    for i, (name, kind) in enumerate(zip(names, r.phases, strict=True)):
        before, after = r.phases[i - 1], r.phases[(i + 1) % len(r.phases)]
        if r.half_period:  # the other half is the mirror image
            before = {"slip+": "slip-", "slip-": "slip+"}.get(before, before) if i == 0 else before
            after = {"slip+": "slip-", "slip-": "slip+"}.get(after, after) if i else after
        if r.scene.endswith("impact") or r.scene == "impact_chain":
            gap, ratio = positive("gap", "m", p["g"]), positive("restitution", "", p["r"])
            event = Event(x - gap, jump={v: -ratio * v})
            found.append(Phase(name, f, ends=event, demands={"before the stop": gap - x}))
        elif r.scene in ("clearance_chain", "beam_spring"):
            gap, k = positive("gap", "m", p["g"]), positive("kc", "N/m", p["kc"])
            c = positive("cc", "N s/m", p["cc"]) if p.get("cc") else 0
            if kind == "open":
                demands = {} if p.get("cc") else {"before the stop": gap - x}
                found.append(Phase(name, f, ends=Event(x - gap), demands=demands))
            else:
                push = k * (x - gap) + c * v
                demands = {"it presses": push}
                found.append(Phase(name, f + push, ends=Event(push), demands=demands))
        elif r.scene in FRICTION:
            kinetic = positive("kinetic", "N", p.get("R", p.get("Fk", 0)))
            speed = positive("speed", "m/s", p["V"]) if "V" in p else sp.Integer(0)
            if kind == "stick":
                static = positive("static", "N", p.get("Rs", p.get("Fs", 0)))
                sign = -1 if after == "slip+" else 1  # of the force that reaches the limit
                demands = {"it sticks": static - sp.Abs(f)}
                event = Event(f - sign * static)
                found.append(Phase(name, contact.a, ends=event, demands=demands, held=speed))
            else:
                sign = 1 if kind == "slip+" else -1
                demands = {"it slips": sign * (v - speed)}
                found.append(
                    Phase(name, f + sign * kinetic, ends=Event(v - speed), demands=demands)
                )
        elif r.scene == "absorber_jenkins":
            kt, R = positive("kt", "N/m", p["kt"]), positive("limit", "N", p["R"])
            if kind == "stick":
                z = sp.Symbol(f"z_at_{i}", real=True)
                sign = 1 if before == "slip+" else -1
                memory.append(Memory(z, name, x - sign * R / kt, "where the slider is"))
                end = 1 if after == "slip+" else -1
                demands = {"it sticks": R - sp.Abs(kt * (x - z))}
                event = Event(kt * (x - z) - end * R)
                found.append(Phase(name, f + kt * (x - z), ends=event, demands=demands))
            else:
                sign = 1 if kind == "slip+" else -1
                demands = {"it slips": sign * v}
                found.append(Phase(name, f + sign * R, ends=Event(v), demands=demands))
        elif r.scene == "two_stops":
            found.append(_two_stops(r, made, name, kind, after, before, positive))
    return tuple(found), tuple(memory), parameters


def _two_stops(r, made, name, kind, after, before, positive):  # type: ignore[no-untyped-def]
    p = r.parameters
    touching = {"open": (), "first": (0,), "second": (1,), "both": (0, 1)}
    laws, demands = [], {}
    (changed,) = {*touching[kind]} ^ {*touching[after]}
    contacts = list(made.at.values())
    for i, contact in enumerate(contacts):
        gap = positive(f"gap{i}", "m", p[f"g{i}"])
        k = positive(f"kc{i}", "N/m", p[f"kc{i}"])
        pressed = i in touching[kind]
        laws.append(contact.force + (k * (contact.x - gap) if pressed else 0))
        demands[f"stop {i}"] = (contact.x - gap) * (1 if pressed else -1)
    gap = positive(f"gap{changed}", "m", p[f"g{changed}"])
    return Phase(name, tuple(laws), ends=Event(contacts[changed].x - gap), demands=demands)


@cache
def case(name: str) -> Case:
    """Return the case of a reference by its name."""
    r = next(q for q in references() if q.name == name)
    made = body(r)
    found, memory, parameters = phases(r, made)
    frequency = None
    if r.angle is not None:
        frequency = Omega
        omega = r.parameters["Omega"]
        parameters.append(Parameter("frequency", Omega, "rad/s", omega, "of the forcing"))
    scene = Scene(
        f"of-{r.name}", r.name, tuple(parameters), found, body=made, frequency=frequency,
        half_period=r.half_period, memory=memory,
    )  # fmt: skip
    return find(scene)(cycles=r.cycles)
