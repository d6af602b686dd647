"""What stands above a table of a scene: what it is, its parameters, what the headings mean."""

from nonsmooth.kim_perkins import CHOICE, SECTION_4, StickSlip
from nonsmooth.solver.results.family import Family
from nonsmooth.solver.scenes.case import Case
from nonsmooth.solver.scenes.classes import HIGHEST, classes
from nonsmooth.solver.scenes.loaded import LoadedScene
from nonsmooth.solver.scenes.methods import shown

from ..columns import filled, filled_parameters
from ..values import Vary


def caption(case: Case, *along: Vary[float]) -> str:
    """Return scene and parameters of a case, those that vary by their ranges, and a choice."""
    scene, varied = case.scene, [vary.parameter for vary in along]
    head = f"{scene.label}: {scene.title} (C{scene.k})"
    lines = [filled(head), filled_parameters(case.described(*varied))]
    lines += [_span(scene, vary.parameter, vary.first, vary.last) for vary in along]
    if not along:
        lines += map(filled, smoother(case))
    if isinstance(case, StickSlip):
        if not along:
            lines.append(f"alpha = omega_n (mu_s - mu_k) F_N / (K V) = {case.alpha:.6g}")
        if case.values == SECTION_4 and "normal_force" not in varied:
            lines.append(CHOICE)
    return "\n".join(lines) + "\n"


def _span(scene: LoadedScene, name: str, first: float, last: float) -> str:
    """Return a parameter and its range."""
    parameter = next(q for q in scene.parameters if q.name == name)
    return f"{parameter.symbol} = {first:g} to {last:g} {parameter.unit}".rstrip()


def caption_of_family(result: Family) -> str:
    """Return the scene, what of its parameters varies, and how the orbits are computed."""
    scene, values = result.case.scene, result["value"]
    head = f"{scene.name}: {scene.title} (C{scene.k})"
    along = _span(scene, result.parameter, values[0], values[-1])
    how = f"{shown(scene, result.method)}, N = {result.order}"
    lines = filled(head), filled_parameters(result.other_parameters), f"{along}; {how}"
    return "\n".join(lines) + "\n"


def smoother(case: Case) -> list[str]:
    """Return at which switches the motion is smoother than in general, for these parameters."""
    scene = case.scene
    if scene.motions:
        return []
    lines = []
    for p, (k, general) in enumerate(zip(classes(case.cell), scene.classes, strict=True)):
        if k > general:
            less = "at least " if k == HIGHEST else ""
            lines.append(
                f"Where {scene.phases[p - 1]} ends and {scene.phases[p]} begins the motion is "
                f"{less}C{k} for these parameters, C{general} in general."
            )
    return list(dict.fromkeys(lines))


def derivative(scene: LoadedScene) -> str:
    """Return the first derivative that jumps somewhere: ``x''`` of a C1 motion."""
    return "x" + "'" * (scene.k + 1)


def estimated(scene: LoadedScene) -> str:
    """Return what an estimate is."""
    return "with that of rounding" if scene.has_body else "without the exact orbit"


def legend(scene: LoadedScene, durations: bool = True) -> str:
    """Return what the headings of a table of orbits mean."""
    jumps, forced = derivative(scene), scene.frequency is not None
    phases = ", ".join(dict.fromkeys(scene.phases))
    one = f"T: period, one phase ({phases})" + " and its mirror image" * scene.half_period
    parts = ["T: period" if len(scene.phases) > 1 else one]
    if forced:
        parts.append("phi: phase of the forcing at the first switch")
    if durations and len(scene.phases) > 1:
        parts.append(f"{phases}: their durations" + ", T/2 in all" * scene.half_period)
    largest = "largest error of a duration" + (" or of phi/Omega" if forced else "")
    parts += [
        f"times: {largest}, as a fraction of T",
        f"{jumps}: L2 error of {jumps}, the first derivative that jumps",
        f"estimate: of times, {estimated(scene)}",
        "it: Jacobians that Newton's method formed",
    ]
    return filled("; ".join(parts) + ".")
