"""A generated scene as an object: its name, parameters and motions; called, it makes a case."""

import hashlib
import sys
import types
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ...nearest import in_short, one_of
from . import sealed
from .sealed import Kept

if TYPE_CHECKING:
    from .case import Case
    from .cell import Cell
    from .dimensionless import Units


#: Name of the module of a scene in its folder.
SCENE = "scene"

#: Generated modules that were loaded, by path and hash of the text.
_LOADED: dict[tuple[Path, str], types.ModuleType] = {}


class UnknownScene(ValueError):  # noqa: N818  (named like the other errors of the package)
    """No scene, or no method of a scene, has the name that was given."""


@dataclass(frozen=True)
class Parameter:
    """One parameter of a scene.

    Parameters
    ----------
    name, symbol, unit, what : str
        Name in code and flags, symbol in equations, SI unit, description.
    default : float
        In SI units.
    bound : {"positive", "nonnegative", ""}
        Restriction of its sign.
    most : float or None
        The largest value allowed.
    """

    name: str
    symbol: str
    unit: str
    default: float
    what: str
    bound: str = ""
    most: float | None = None

    @property
    def expected(self) -> str:
        """The values allowed, in words."""
        phrases = {"positive": "a positive number", "nonnegative": "a number not below 0"}
        low = phrases.get(self.bound, "a finite number")
        return low if self.most is None else f"{low}, at most {self.most:g}"

    def allows(self, value: float) -> bool:
        """Return whether a finite value is allowed."""
        low = value > 0 if self.bound == "positive" else self.bound == "" or value >= 0
        return low and (self.most is None or value <= self.most)


@dataclass(frozen=True, eq=False, repr=False)
class LoadedScene:
    """A scene that was loaded from its generated module ``scene.py``.

    Calling it makes a case: ``scene(mass=2.0)``, with defaults for the other parameters.  A
    scene of several motions has a folder for each, which is a scene of one motion.

    Parameters
    ----------
    module : module
        The generated module.
    folder : Path
        Where the module lies, and those of several motions.
    kept : mapping of str to bytes, optional
        Content of its files, used in place of the files themselves; see `sealed`.
    """

    module: types.ModuleType
    folder: Path
    kept: Kept | None = None

    def __call__(self, *, cycles: int = 1, **values: object) -> "Case":
        """Return the case of these parameters, in SI units.

        `cycles` is the number of periods of the forcing in one period of the motion.

        Raises
        ------
        ParameterError
            Naming every error in them.
        """
        from .case import Case  # noqa: PLC0415  (NumPy: a list of scenes needs none)

        return Case(self, values, cycles)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, LoadedScene) and self._identity == other._identity

    def __hash__(self) -> int:
        return hash(self._identity)

    def __reduce__(self) -> tuple[object, ...]:
        return load_folder, (str(self.folder),)

    def __repr__(self) -> str:
        return f"<scene {self.label}: {self.title} (C{self.k})>"

    @property
    def _identity(self) -> tuple[object, ...]:
        return self.name, self.module.BODY

    @property
    def name(self) -> str:
        """Its name for users."""
        return str(self.module.NAME)

    @property
    def motions(self) -> tuple[str, ...]:
        """The names of its motions (orders of phases); empty if there is only one."""
        return tuple(self.module.MOTIONS)

    @property
    def motion(self) -> str | None:
        """Its name among several motions of a scene; None if there is only one."""
        name: str | None = self.module.MOTION
        return name

    @property
    def label(self) -> str:
        """Its name, and that of its motion if there are several."""
        return f"{self.name}, {in_short(self.motion)}" if self.motion else self.name

    @property
    def title(self) -> str:
        """Its description in one line."""
        return str(self.module.TITLE)

    @property
    def k(self) -> int:
        """Class C^k of its motion: the least over its switches, of any of its motions."""
        return int(self.module.CLASS)

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """Its parameters, in order."""
        return tuple(Parameter(*row) for row in self.module.PARAMETERS)

    @property
    def powers(self) -> tuple[tuple[float, float, float], ...]:
        """Powers of mass, length and time in the unit of each parameter."""
        return tuple(self.module.POWERS)

    @property
    def kinds(self) -> tuple[tuple[str, bool], ...]:
        """Name of each phase of its cell, and whether a constraint holds its velocity."""
        return tuple(self.module.PHASES)

    @property
    def classes(self) -> tuple[int, ...]:
        """The k of the switch that begins each phase of its cell; none of several motions."""
        return tuple(k for k, _ in getattr(self.module, "SWITCHES", ()))

    @property
    def class_at_start(self) -> dict[int, int]:
        """The k of the switch that begins each phase, by the phase's index in the module."""
        return dict(enumerate(self.classes))

    @property
    def default_classes(self) -> dict[int, int]:
        """The same for the default parameters."""
        return dict(enumerate(getattr(self.module, "CLASSES_OF_DEFAULTS", ())))

    @property
    def memory(self) -> tuple[tuple[str, Any, int, str], ...]:
        """Name, phases that set it, power of 1/time in its unit, and meaning of each memory."""
        return tuple(self.module.MEMORY)

    @property
    def half_period(self) -> bool:
        """Whether its cell is half a period, and the other half the mirror image."""
        return bool(self.module.HALF_PERIOD)

    @property
    def has_body(self) -> bool:
        """Whether what moves is a body of several degrees of freedom, and not one mass."""
        return hasattr(self.module, "CONTACTS")

    @property
    def has_start(self) -> bool:
        """Whether it states a condition on the state in which its first phase begins."""
        return hasattr(self.module, "start")

    @property
    def phases(self) -> tuple[str, ...]:
        """The names of the phases of its cell, or of all its motions without repetition."""
        if not self.motions:
            return tuple(name for name, _ in self.kinds)
        names = (name for motion in self.each_motion for name in motion.phases)
        return tuple(dict.fromkeys(names))

    @property
    def each_motion(self) -> "tuple[LoadedScene, ...]":
        """Its motions, each as a scene; itself if it has only one."""
        return tuple(map(self.of_motion, self.motions)) or (self,)

    def of_motion(self, name: object) -> "LoadedScene":
        """Return one of its motions as a scene.

        Raises
        ------
        UnknownScene
            If it has no motion of this name; a scene of one motion has none.
        """
        if self.motion is not None and name == self.motion:
            return self
        hyphenated = name.replace("_", "-") if isinstance(name, str) else name
        names = {motion.replace("_", "-"): motion for motion in self.motions}
        if not self.motions:
            raise UnknownScene(f"motion: got {name!r}, but {self.label} has only one")
        if hyphenated not in names:
            order = "; for an order take `phases`" if "," in str(name) else ""
            raise UnknownScene(
                f"motion: got {name!r}, expected {one_of(name, self.motions)}{order}"
            )
        folder = names[str(hyphenated)].replace("-", "_")
        content = None if self.kept is None else sealed.below(self.kept, folder)
        return load_folder(self.folder / folder, content)

    @property
    def orders(self) -> tuple[tuple[tuple[int, bool], ...], ...]:
        """The order in which each of several motions has all their phases; see `Cell`."""
        return tuple(getattr(self.module, "ORDERS", ()))

    @property
    def to(self) -> tuple[tuple[tuple[int, bool], ...], ...]:
        """The phases that events say to follow; see `Cell`."""
        return tuple(getattr(self.module, "TO", ()))

    def called(self, name: str) -> list[int]:
        """Return the phases of its cell that have a name."""
        return [p for p, (phase, _) in enumerate(self.kinds) if phase == name]

    @property
    def whole(self) -> "LoadedScene":
        """The scene with all its motions; itself if it has only one."""
        return self if self.motion is None else load_folder(self.folder.parent)

    def cell(
        self, numbers: tuple[float, ...], cycles: int = 1, units: "Units | None" = None
    ) -> "Cell":
        """Return the cell of a scene of one motion for parameters in given units.

        The matrices of a body are in SI units: without `units` its cell has the scene's laws,
        but a stand-in for the body.
        """
        if self.has_body:
            from .bodies.cell import body_cell  # noqa: PLC0415  (SciPy)

            return body_cell(self, numbers, cycles, units)
        from .of_module import cell_of  # noqa: PLC0415  (a list of scenes needs none)

        return cell_of(self, numbers, cycles)

    @property
    def frequency(self) -> str | None:
        """Name of the parameter that is the forcing's angular frequency; None without one."""
        name: str | None = self.module.FREQUENCY
        return name

    def numbers(self, function: str, values: Sequence[float]) -> Any:
        """Return the value of a function of the module for parameters; () without one."""
        evaluate = getattr(self.module, function, None)
        return () if evaluate is None else evaluate(*values)


def load_folder(folder: str | Path, kept: Kept | None = None) -> LoadedScene:
    """Return the scene whose generated modules lie in `folder`.

    Parameters
    ----------
    folder : str or Path
    kept : mapping of str to bytes, optional
        Content of its files; without it, a sealed folder is read and checked here.

    Raises
    ------
    UnknownScene
        If there is no ``scene.py`` in it.
    Damaged, NotPrivate
        See `sealed.read`.
    """
    path = Path(folder).resolve() / f"{SCENE}.py"
    content = sealed.read_any(path.parent) if kept is None else kept
    if not (path.is_file() if content is None else path.name in content):
        raise UnknownScene(f"scene: no {SCENE}.py in {str(folder)!r}")
    return LoadedScene(_module_of(path, content), path.parent, content)


def _module_of(path: Path, kept: Kept | None = None) -> types.ModuleType:
    """Return the module of a file, loaded anew if its text has changed.

    The text is taken from `kept`, if given, and not from the file.
    """
    text = path.read_bytes() if kept is None else kept[path.name]
    key = path, hashlib.sha256(text).hexdigest()
    if key not in _LOADED:
        name = f"nonsmooth_generated_{path.stem}_{key[1][:16]}"
        module = types.ModuleType(name)
        module.__file__ = str(path)
        sys.modules[name] = module  # where numba looks for it
        exec(compile(text, str(path), "exec", dont_inherit=True), vars(module))
        _LOADED[key] = module
    return _LOADED[key]
