"""Mistakes in the map of the claims, the heat maps, and the pictures of the command line."""

from ..mutant import Mutant

REPORT, CLI = "src/nonsmooth/report/", "src/nonsmooth/cli/shortcuts/"
PLOTS = "src/nonsmooth/plots/shortcuts/"

PICTURES = ("tests/cli/test_pictures.py",)
MAP = ("tests/report/test_claim_map.py",)
HEAT = ("tests/cli/test_heat_maps.py",)

MUTANTS: tuple[Mutant, ...] = (
    Mutant(
        "the shades of the claims map swapped",
        REPORT + "claim_map.py",
        '("#0072B2", "#A9CCE3", "none")',
        '("#A9CCE3", "#0072B2", "none")',
        MAP,
    ),
    Mutant(
        "the key of the claims map swapped",
        REPORT + "page.html.jinja",
        '<span class="key" style="background:#fff"></span> does not hold.',
        '<span class="key" style="background:#fff"></span> holds.',
        MAP,
    ),
    Mutant(
        "the claims map in alpha under the label of a force",
        REPORT + "claim_map.py",
        "left, right = force(belt, low), force(belt, high)",
        "left, right = low, high",
        MAP,
    ),
    Mutant(
        "the claims in the opposite order",
        REPORT + "claim_map.py",
        "for n, claim in enumerate(claims, 1)]",
        "for n, claim in enumerate(reversed(claims), 1)]",
        MAP,
    ),
    Mutant(
        "the stable form drawn twice",
        CLI + "heat_maps.py",
        "image = _draw(place, cells, form)",
        'image = _draw(place, cells, "stable")',
        HEAT,
    ),
    Mutant(
        "a heat map with rows and columns swapped",
        "src/nonsmooth/cli/scenes/shown/heat_map.py",
        "k + 0.5, i + 0.5, word,",
        "i + 0.5, k + 0.5, word,",
        HEAT,
    ),
    Mutant(
        "a heat map of all methods in each row",
        CLI + "heat_maps.py",
        "cells = [cell for cell in found if cell.method == method]",
        "cells = found",
        HEAT,
    ),
    Mutant(
        "no convergence in the colour of what was not measured",
        CLI + "heat_maps.py",
        'digits[place], words[place] = 0, "×"',
        'words[place] = "×"',
        HEAT,
    ),
    Mutant(
        "the picture of a sweep draws the error of t1",
        PLOTS + "sweeps.py",
        "[e.period for e in errors]",
        "[e.t1 for e in errors]",
        PICTURES,
    ),
    Mutant(
        "the picture of a sweep draws the aligned error",
        PLOTS + "sweeps.py",
        "above_floor(e.acceleration) for e in errors]",
        "above_floor(e.acceleration_aligned) for e in errors]",
        PICTURES,
    ),
    Mutant(
        "several C1 functions called one",
        PLOTS + "sweeps.py",
        '"label": label(method, result.c1_terms)}',
        '"label": label(method)}',
        PICTURES,
    ),
    Mutant(
        "the orbit's histories in another order",
        "src/nonsmooth/plots/orbits.py",
        "zip(panels, (PLANE, *HISTORIES), strict=True)",
        "zip(panels, (PLANE, *reversed(HISTORIES)), strict=True)",
        PICTURES,
    ),
    Mutant(
        "the front of the points that are not on it",
        PLOTS + "trade.py",
        "for p in points if p.front)",
        "for p in points if not p.front)",
        PICTURES,
    ),
    Mutant(
        "estimates for errors in time against error",
        PLOTS + "trade.py",
        "[p.seconds for p in chosen], [p.error for p in chosen]",
        "[p.seconds for p in chosen], [p.estimate or p.error for p in chosen]",
        PICTURES,
    ),
    Mutant(
        "amplitude and stick fraction of a family swapped",
        PLOTS + "families.py",
        '"amplitude": "amplitude [m]",\n    "stick_fraction": "stick fraction $t_1/T$",',
        '"stick_fraction": "amplitude [m]",\n    "amplitude": "stick fraction $t_1/T$",',
        PICTURES,
    ),
    Mutant(
        "a family over alpha under the label of its parameter",
        PLOTS + "families.py",
        'axes.plot(family["value"],',
        'axes.plot(family["alpha"],',
        PICTURES,
    ),
)
