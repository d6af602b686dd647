"""Motions of the shipped scenes by an integrator, each written out from its equations."""

import math
from types import SimpleNamespace

from scipy.integrate import solve_ivp

from nonsmooth.solver.kernels import registry

#: A start in units of the scene.
STARTS = {
    "impact": (-1.5, -0.4), "impact-two-sided": (0.0, 0.3), "clearance": (-1.2, 0.4),
    "backlash": (-1.7, 0.4), "dry-friction": (0.3, -0.4), "stick-slip": (-0.5, 0.3),
    "stick-slip-damped": (-0.5, 0.3), "elastic-plastic": (0.0, 0.1),
}  # fmt: skip


def modes(scene, q, load):
    """Return the modes of a scene: acceleration, and what ends it.

    Each end is a function of t, x, v that is positive within the mode, and one that returns
    the mode behind it and the velocity there.
    """

    def spring(force):  # a mass on a damper, and what else pulls it back
        return lambda t, x, v: (load(t) - q.damping * v - force(x)) / q.mass

    def to(name, factor=1.0):
        return lambda t, x, v: (name, factor * v)

    if scene == "impact":
        hit = (lambda t, x, v: q.gap - x, to("flight", -q.restitution))
        return {"flight": (spring(lambda x: q.stiffness * x), [hit])}
    if scene == "impact-two-sided":
        hits = [
            (lambda t, x, v: q.gap - x, to("crossing", -q.restitution)),
            (lambda t, x, v: q.gap + x, to("crossing", -q.restitution)),
        ]
        return {"crossing": (spring(lambda x: q.stiffness * x), hits)}
    if scene == "clearance":
        both = spring(lambda x: q.stiffness * x + q.contact_stiffness * (x - q.gap))
        return {
            "contact": (both, [(lambda t, x, v: x - q.gap, to("separated"))]),
            "separated": (
                spring(lambda x: q.stiffness * x),
                [(lambda t, x, v: q.gap - x, to("contact"))],
            ),
        }
    if scene == "backlash":
        within = q.gap_stiffness * q.gap

        def engaged(side):
            return spring(lambda x: side * within + q.stiffness * (x - side * q.gap))

        return {
            "engaged": (engaged(1), [(lambda t, x, v: x - q.gap, to("loose"))]),
            "-engaged": (engaged(-1), [(lambda t, x, v: -q.gap - x, to("loose"))]),
            "loose": (
                spring(lambda x: q.gap_stiffness * x),
                [
                    (lambda t, x, v: q.gap - x, to("engaged")),
                    (lambda t, x, v: q.gap + x, to("-engaged")),
                ],
            ),
        }
    if scene == "dry-friction":
        kinetic, static = q.mu_k * q.normal_force, q.mu_s * q.normal_force

        def pull(t, x):
            return load(t) - q.stiffness * x

        def stopped(t, x, v):
            if abs(pull(t, x)) < static:
                return "stop", 0.0
            return ("-slide" if pull(t, x) > 0 else "slide"), 0.0

        def slides(side):
            friction = spring(lambda x: q.stiffness * x + side * kinetic)
            return friction, [(lambda t, x, v: side * v, stopped)]

        return {
            "slide": slides(-1),
            "-slide": slides(1),
            "stop": (
                lambda t, x, v: 0.0,
                [
                    (lambda t, x, v: static - pull(t, x), to("-slide")),
                    (lambda t, x, v: static + pull(t, x), to("slide")),
                ],
            ),
        }
    static, kinetic = q.mu_s * q.normal_force, q.mu_k * q.normal_force
    c = getattr(q, "damping", 0.0)
    weak = getattr(q, "weakening", 0.0) * q.normal_force

    def slip(t, x, v):
        return (kinetic - weak * (q.belt_speed - v) - c * v - q.stiffness * x) / q.mass

    def on_the_belt(t, x, v):
        held = abs(q.stiffness * x + c * q.belt_speed) < static
        return ("stick" if held else "slip"), q.belt_speed

    return {
        "slip": (slip, [(lambda t, x, v: q.belt_speed - v, on_the_belt)]),
        "stick": (
            lambda t, x, v: 0.0,
            [(lambda t, x, v: static - q.stiffness * x - c * q.belt_speed, to("slip"))],
        ),
    }


def integrated(case, name, state, angle, time, most):
    """Return mode, time, displacement and velocity where each mode of a motion begins."""
    q = SimpleNamespace(**case.values)
    amplitude, omega = getattr(q, "force", 0.0), getattr(q, "frequency", 0.0)
    table = modes(case.scene.name, q, lambda t: amplitude * math.cos(omega * t + angle))
    t, (x, v), found = 0.0, state, []
    while len(found) < most:
        found.append((name, t, x, v))
        acceleration, ends = table[name]
        inside = [lambda t, y, f=f: f(t, *y) for f, _ in ends]
        for event in inside:
            event.terminal, event.direction = True, -1
        solved = solve_ivp(
            lambda t, y, a=acceleration: [y[1], a(t, *y)], (t, time), [x, v], "DOP853",
            rtol=1e-12, atol=1e-15, events=inside, max_step=0.02 * case.units.time,
        )  # fmt: skip
        if solved.status == 0:
            break
        which = next(i for i, times in enumerate(solved.t_events) if len(times))
        t, (x, v) = float(solved.t_events[which][0]), map(float, solved.y_events[which][0])
        name, v = ends[which][1](t, x, v)
    return found


def random_case(scene, rng):
    """Return a case with random parameters, in half of those with a play a tiny one."""
    load = registry.load(scene)
    values = {q.name: q.default * math.exp(rng.uniform(-0.4, 0.4)) for q in load.parameters}
    if "restitution" in values:
        values["restitution"] = rng.uniform(0.3, 0.9)
    if "mu_k" in values:
        values["mu_k"] = values["mu_s"] * rng.uniform(0.3, 1)
    if "gap" in values and scene != "impact-two-sided" and rng.random() < 0.5:
        values["gap"] = 10.0 ** rng.uniform(-12, -6)
    return load(**values)
