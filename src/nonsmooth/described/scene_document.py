"""What a scene is, as a document: parameters, phases, events, jumps, demands, class."""

from typing import TYPE_CHECKING, Any

from nonsmooth.solver.kernels import registry
from nonsmooth.solver.scenes.method_names import shown
from nonsmooth.solver.scenes.methods import in_order

from .formulas import STATE, linear, rows, state_of

if TYPE_CHECKING:
    from nonsmooth.solver.scenes.loaded import LoadedScene

#: What the coefficients of an equation of motion stand before, right side last.
LEFT, RIGHT = ("x''", "x'", "x"), ("", "cos(Omega t + phi)")


def brief(scene: "LoadedScene") -> dict[str, Any]:
    """Return what a list of scenes says of one."""
    return {
        "name": scene.name,
        "what": scene.title,
        "class": f"C{scene.k}",
        "phases": list(scene.phases),
        "motions": _orders(scene),
    }


def _orders(scene: "LoadedScene") -> list[dict[str, Any]]:
    """Return the motions of a scene, where it has several: name and phases of each."""
    if not scene.motions:
        return []
    return [
        {"name": each.motion, "class": f"C{each.k}", "phases": list(each.phases)}
        for each in scene.each_motion
    ]


def document(scene: "LoadedScene") -> dict[str, Any]:
    """Return all of a scene."""
    module = scene.module
    return {
        "name": scene.name,
        "what": scene.title,
        "class": f"C{scene.k}",
        "source": module.SOURCE,
        "frequency": scene.frequency,
        "half_period": scene.half_period,
        "parameters": [
            {
                "name": q.name, "symbol": q.symbol, "unit": q.unit, "default": q.default,
                "what": q.what, "expected": q.expected, "bound": q.bound, "most": q.most,
            }
            for q in scene.parameters
        ],
        "requires": list(module.REQUIRES),
        **({"body": _body(scene)} if scene.has_body else {}),
        "phases": [] if scene.motions else _phases(scene),
        "motions": [
            {**order, "phases": _phases(each)}
            for order, each in zip(_orders(scene), scene.each_motion, strict=False)
        ],
        "methods": [
            {
                "name": method, "shown": shown(scene, method),
                "functions": list(registry.functions(scene, method)),
            }
            for method in in_order(registry.methods(scene))
        ],
    }  # fmt: skip


def _body(scene: "LoadedScene") -> dict[str, Any]:
    """Return what the body of a scene is: degrees of freedom, contacts, modes, damping."""
    from nonsmooth.solver.scenes.bodies.files import matrices_of  # noqa: PLC0415  (NumPy)

    ratio, modes = rows(scene.module, "modal")
    return {
        "degrees_of_freedom": int(matrices_of(scene)["M_shape"][0]),
        "contacts": list(scene.module.CONTACTS),
        "damping_ratio": None if ratio == ("None",) else ratio[0],
        "modes": None if modes == ("None",) else modes[0],
    }


def _phases(scene: "LoadedScene") -> list[dict[str, Any]]:
    """Return the phases of a scene of one motion."""
    return [_phase(scene, p) for p in range(len(scene.phases))]


def _phase(scene: "LoadedScene", p: int) -> dict[str, Any]:
    module = scene.module
    frequency = next((q.symbol for q in scene.parameters if q.name == scene.frequency), "Omega")

    def named(text: str) -> str:
        return text.replace("cos(Omega", f"cos({frequency}")

    name, held = scene.kinds[p]
    words = [word for word, *_ in scene.memory]
    own = state_of(module.CONTACTS) if scene.has_body else STATE
    state = (*own, *words)
    if scene.has_body:
        laws = (f"{linear(law, state)} = 0" for law in rows(module, "laws")[p])
        equation = ", ".join(laws)
    else:
        m, c, k, f, g, *memory = rows(module, "coefficients")[p]
        right = linear((f, g, *memory), (*RIGHT, *words))
        equation = f"{linear((m, c, k), LEFT)} = {right}"
    at_switch = rows(module, "switch_demands")[p]
    k_of_switch, jumps = module.SWITCHES[p]
    forms = rows(module, "demands")[p]
    return {
        "name": name,
        "equation": named(equation),
        "held": f"x' = {rows(module, 'held')[p][0]}" if held else None,
        "ends": named(f"{linear(rows(module, 'events')[p], state)} = 0"),
        "jump": _jumps(rows(module, "jumps")[p]),
        "demands": [
            {"what": words, "expression": named(f"{linear(form, state)} >= 0")}
            for words, form in zip(module.DEMANDS[p], forms, strict=True)
        ],
        "switch_demands": [
            {"what": words, "expression": named(f"{linear(form, state)} >= 0")}
            for words, form in zip(module.SWITCH_DEMANDS[p], at_switch, strict=True)
        ],
        "sets": [
            {"memory": name, "what": what, "expression": named(linear(form, own))}
            for (name, phase, _, what), form in zip(
                scene.memory, rows(module, "memory"), strict=True
            )
            if phase == p
        ],
        "begins": {
            "class": f"C{k_of_switch}", "jumps": jumps,
            "class_of_defaults": f"C{module.CLASSES_OF_DEFAULTS[p]}",
        },
    }  # fmt: skip


def _jumps(row: tuple[str, ...]) -> str | None:
    """Return what the switch at the end of a phase makes of each velocity, if it does."""
    found = (_jump(*row[i : i + 2]) for i in range(0, len(row), 2))
    return ", ".join(filter(None, found)) or None


def _jump(rho: str, d: str) -> str | None:
    """Return what the switch at the end of a phase makes of the velocity, if it does."""
    if rho in {"1", "1.0"} and d in {"0", "0.0"}:
        return None
    return f"x' -> {linear((rho, d), STATE[1::2])}"
