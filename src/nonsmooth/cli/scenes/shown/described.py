"""What a scene is, as a document: parameters, phases, events, jumps, demands, class."""

from typing import TYPE_CHECKING, Any

from nonsmooth.solver.case import registry
from nonsmooth.solver.case.methods import in_order
from nonsmooth.solver.case.names import shown

from .formulas import STATE, linear, nested, rows

if TYPE_CHECKING:
    from nonsmooth.solver.case.numbers import SceneNumbers

#: What the coefficients of an equation of motion stand before, right side last.
LEFT, RIGHT = ("x''", "x'", "x"), ("", "cos(Omega t + phi)")


def brief(scene: "SceneNumbers") -> dict[str, Any]:
    """Return what a list of scenes says of one."""
    return {
        "name": scene.name,
        "what": scene.title,
        "class": f"C{scene.k}",
        "phases": list(scene.phases),
    }


def document(scene: "SceneNumbers") -> dict[str, Any]:
    """Return all of a scene."""
    module = scene.module
    return {
        "name": scene.name,
        "what": scene.title,
        "class": f"C{scene.k}",
        "source": module.SOURCE,
        "frequency": scene.frequency,
        "half_period": bool(module.HALF_PERIOD),
        "parameters": [
            {
                "name": q.name, "symbol": q.symbol, "unit": q.unit, "default": q.default,
                "what": q.what, "expected": q.expected, "bound": q.bound, "most": q.most,
            }
            for q in scene.parameters
        ],
        "requires": list(module.REQUIRES),
        "phases": [_phase(scene, p) for p in range(len(scene.phases))],
        "methods": [
            {
                "name": method, "shown": shown(scene, method),
                "functions": list(registry.functions(scene, method)),
            }
            for method in in_order(registry.methods(scene))
        ],
    }  # fmt: skip


def _phase(scene: "SceneNumbers", p: int) -> dict[str, Any]:
    module = scene.module
    frequency = next((q.symbol for q in scene.parameters if q.name == scene.frequency), "Omega")

    def named(text: str) -> str:
        return text.replace("cos(Omega", f"cos({frequency}")

    name, held = module.PHASES[p]
    m, c, k, f, g = rows(module, "coefficients")[p]
    equation = f"{linear((m, c, k), LEFT)} = {linear((f, g), RIGHT)}"
    k_of_switch, jumps = module.SWITCHES[p]
    forms = nested(module, "demands")[p]
    return {
        "name": name,
        "equation": named(equation),
        "held": f"x' = {rows(module, 'held')[p][0]}" if held else None,
        "ends": named(f"{linear(rows(module, 'events')[p])} = 0"),
        "jump": _jump(*rows(module, "jumps")[p]),
        "demands": [
            {"what": words, "expression": named(f"{linear(form)} >= 0")}
            for words, form in zip(module.DEMANDS[p], forms, strict=True)
        ],
        "begins": {"class": f"C{k_of_switch}", "jumps": jumps},
    }


def _jump(rho: str, d: str) -> str | None:
    """Return what the switch at the end of a phase makes of the velocity, if it does."""
    if rho in {"1", "1.0"} and d in {"0", "0.0"}:
        return None
    return f"x' -> {linear((rho, d), STATE[1::2])}"
