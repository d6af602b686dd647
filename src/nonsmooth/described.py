"""A scene as a document: parameters, phases, events, jumps, demands, class.

Its formulas are read as text from its generated module: no SymPy is needed.
"""

import ast
import inspect
from collections.abc import Iterable
from functools import cache
from types import ModuleType
from typing import TYPE_CHECKING, Any

from nonsmooth.solver.kernels import registry
from nonsmooth.solver.scenes.methods import in_order, shown

if TYPE_CHECKING:
    from nonsmooth.solver.scenes.loaded import LoadedScene

#: The factors of the coefficients of an equation of motion, left and right side.
LEFT, RIGHT = ("x''", "x'", "x"), ("", "cos(Omega t + phi)")


#: The fields of a parameter in the document.
PARAMETER = ("name", "symbol", "unit", "default", "what", "expected", "bound", "most")


def brief(scene: "LoadedScene") -> dict[str, Any]:
    """Return the entry of a scene in the list of all scenes."""
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
        {"name": motion.motion, "class": f"C{motion.k}", "phases": list(motion.phases)}
        for motion in scene.each_motion
    ]


def document(scene: "LoadedScene") -> dict[str, Any]:
    """Return the whole document of a scene."""
    module = scene.module
    return {
        "name": scene.name,
        "what": scene.title,
        "class": f"C{scene.k}",
        "source": module.SOURCE,
        "frequency": scene.frequency,
        "half_period": scene.half_period,
        "parameters": [
            {name: getattr(q, name) for name in PARAMETER} for q in scene.parameters
        ],
        "requires": list(module.REQUIRES),
        **({"body": _body(scene)} if scene.has_body else {}),
        "phases": [] if scene.motions else _phases(scene),
        "motions": [
            {**order, "phases": _phases(motion)}
            for order, motion in zip(_orders(scene), scene.each_motion, strict=False)
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
    """Return degrees of freedom, contacts, modes and damping of the body of a scene."""
    from nonsmooth.solver.scenes.bodies.body import matrices_of  # noqa: PLC0415  (NumPy)

    ratio, modes = rows(scene.module, "modal")
    return {
        "degrees_of_freedom": int(matrices_of(scene)["M_shape"][0]),
        "contacts": list(scene.module.CONTACTS),
        "damping_ratio": None if ratio == ("None",) else ratio[0],
        "modes": None if modes == ("None",) else modes[0],
    }


def _phases(scene: "LoadedScene") -> list[dict[str, Any]]:
    """Return the phases of a scene of one motion; each once, where an order repeats them."""
    return [_phase(scene, p) for p in scene.class_at_start]


def _phase(scene: "LoadedScene", p: int) -> dict[str, Any]:
    """Return phase `p` of the module of a scene; with all its events, if they are several."""
    module, at_start, ends = scene.module, scene.class_at_start[p], [p]
    whole = scene.whole
    if whole.to and module is not whole.module:  # as it is written, whatever its order sets
        q, mirrored = whole.orders[whole.motions.index(str(scene.motion))][p]
        if not mirrored:
            module, p = whole.module, q
            names = getattr(module, "LISTED", [name for name, _ in module.PHASES])
            ends = [i for i, name in enumerate(names) if name == names[p]]
    frequency = next((q.symbol for q in scene.parameters if q.name == scene.frequency), "Omega")

    def named(text: str) -> str:
        return text.replace("cos(Omega", f"cos({frequency}")

    def demanded(words: tuple[str, ...], forms: tuple[Any, ...]) -> list[dict[str, str]]:
        return [
            {"what": what, "expression": named(f"{linear(form, state)} >= 0")}
            for what, form in zip(words, forms, strict=True)
        ]

    name, held = module.PHASES[p]
    words = [word for word, *_ in module.MEMORY]
    variables = state_of(module.CONTACTS) if scene.has_body else STATE
    state = (*variables, *words)
    if scene.has_body:
        laws = (f"{linear(law, state)} = 0" for law in rows(module, "laws")[p])
        equation = ", ".join(laws)
    else:
        m, c, k, f, g, *memory = rows(module, "coefficients")[p]
        right = linear((f, g, *memory), (*RIGHT, *words))
        equation = f"{linear((m, c, k), LEFT)} = {right}"
    return {
        "name": name,
        "equation": named(equation),
        "held": f"x' = {rows(module, 'held')[p][0]}" if held else None,
        "ends": _either(named(f"{linear(rows(module, 'events')[q], state)} = 0") for q in ends),
        "jump": _either(_jumps(rows(module, "jumps")[q]) for q in ends),
        "demands": demanded(module.DEMANDS[p], rows(module, "demands")[p]),
        "switch_demands": demanded(
            module.SWITCH_DEMANDS[p], rows(module, "switch_demands")[p]
        ),
        "sets": [
            {"memory": name, "what": what, "expression": named(linear(form, variables))}
            for (name, phase, _, what), form in zip(
                module.MEMORY, rows(module, "memory"), strict=True
            )
            if phase == p or (isinstance(phase, tuple) and p in phase)
        ],
        "begins": {
            "class": f"C{at_start}", "jumps": "x" + "'" * (at_start + 1),
            "class_of_defaults": f"C{scene.default_classes.get(p, at_start)}",
        },
    }  # fmt: skip


def _either(texts: Iterable[str | None]) -> str | None:
    """Return texts that differ, joined by "or"; None without any."""
    different = dict.fromkeys(text or "nothing" for text in texts)
    return None if different.keys() <= {"nothing"} else " or ".join(different)


def _jumps(row: tuple[str, ...]) -> str | None:
    """Return the jumps of the velocities at the end of a phase, as text; None without any."""
    texts = (
        f"x' -> {linear((rho, d), STATE[1::2])}"
        for rho, d in zip(row[::2], row[1::2], strict=True)
        if not (rho in ONE and d in ZERO)
    )
    return ", ".join(texts) or None


#: Texts of coefficients that are 0, and 1.
ZERO, ONE = ("0", "0.0"), ("1", "1.0")

#: The variables of a linear form.
STATE = ("x", "x'", "cos(Omega t + phi)", "")

#: The variables of a further contact of a body.
CONTACT = ("x_{}", "x_{}'", "force_{}", "x_{}''")


def state_of(contacts: tuple[str, ...]) -> tuple[str, ...]:
    """Return the variables of a linear form of a body.

    Examples
    --------
    >>> state_of(("tip", "root"))[4:]
    ('force', "x''", 'x_root', "x_root'", 'force_root', "x_root''")
    """
    further = (f"{q.format(name)}" for name in contacts[1:] for q in CONTACT)
    return (*STATE, "force", "x''", *further)


@cache
def rows(module: ModuleType, function: str) -> tuple[Any, ...]:
    """Return the expressions that a function of the module returns, as text, by phase.

    It has expressions, or rows of them; of a single expression it is a tuple of one.  Of a
    function that is not there it is empty.
    """
    if not hasattr(module, function):
        return ()
    source = ast.parse(inspect.getsource(getattr(module, function)))
    (result,) = (node for node in ast.walk(source) if isinstance(node, ast.Return))
    assert isinstance(result.value, ast.Tuple)
    phases = map(_texts, result.value.elts)
    return tuple(phase if isinstance(phase, tuple) else (phase,) for phase in phases)


def _texts(node: ast.expr) -> Any:
    """Return an expression as text, or several as a tuple."""
    return tuple(map(_texts, node.elts)) if isinstance(node, ast.Tuple) else _text(node)


def linear(coefficients: tuple[str, ...], words: tuple[str, ...] = STATE) -> str:
    """Return a sum of coefficients times words.

    Examples
    --------
    >>> linear(("-K", "1", "0", "F_N*mu_s - c"))
    "-K x + x' + F_N*mu_s - c"
    >>> linear(("a + b", "-1", "0", "0"))
    "(a + b) x - x'"
    """
    text = ""
    for coefficient, word in zip(coefficients, words, strict=True):
        if coefficient in ZERO:
            continue
        if word:
            minus, factor = _signed(coefficient)
            term = _product(factor, word)
        else:  # a constant is not put in parentheses
            minus, term = coefficient.startswith("-"), coefficient.removeprefix("-")
        sign = "-" if minus else "+"
        text += f" {sign} {term}" if text else f"{'-' if minus else ''}{term}"
    return text or "0"


def _text(node: ast.expr) -> str:
    """Return an expression as text, products without spaces."""
    text = ast.unparse(node)
    for sign in ("*", "/", "**"):
        text = text.replace(f" {sign} ", sign)
    return text


def _signed(text: str) -> tuple[bool, str]:
    """Return whether a product or quotient begins with a minus, and the text without it."""
    node = ast.parse(text, mode="eval").body
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        return True, _text(node.operand)
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Mult | ast.Div):
        minus, _ = _signed(_text(node.left))
        return minus, text.replace("-", "", 1) if minus else text
    return False, text


def _product(factor: str, word: str) -> str:
    if factor in ONE:
        return word
    node = ast.parse(factor, mode="eval").body
    divided = isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add | ast.Sub)
    return f"({factor}) {word}" if divided else f"{factor} {word}"
