"""Mistakes in the report: what its figures draw, and what is written beside them."""

from ..mutant import Mutant

REPORT = "src/nonsmooth/report/"

FIGURES = ("tests/report/test_figures.py", "tests/report/test_figures_of_motion.py")
CAPTIONS = ("tests/report/test_captions.py",)

#: What is drawn in the report.
_FIGURES = (
    Mutant(
        "the axes of Fig. 2(a) swapped",
        "src/nonsmooth/plots/orbits.py",
        "x, v = motion.displacement(times), motion.velocity(times)",
        "v, x = motion.displacement(times), motion.velocity(times)",
        FIGURES,
    ),
    Mutant(
        "the labels of Fig. 2(a) swapped",
        REPORT + "figures.py",
        'axes.set(xlabel="displacement x [m]", ylabel="velocity [m/s]")',
        'axes.set(xlabel="velocity [m/s]", ylabel="displacement x [m]")',
        FIGURES,
    ),
    Mutant(
        "A and B of Fig. 2(a) swapped",
        REPORT + "figures.py",
        'for name, x, v in zip("AB",',
        'for name, x, v in zip("BA",',
        FIGURES,
    ),
    Mutant(
        "a wrong unit in Fig. 2(d)",
        "src/nonsmooth/plots/orbits.py",
        '"acceleration [m/s²]"',
        '"acceleration [m/s]"',
        FIGURES,
    ),
    Mutant(
        "Fig. 2(b) marks the end of stick as the centre",
        REPORT + "figures.py",
        "centre = case.belt.slip_centre",
        "centre = case.belt.slip_centre + case.alpha * case.belt.length_unit",
        FIGURES,
    ),
    Mutant(
        "Fig. 1(b) has friction along the velocity",
        REPORT + "sketch.py",
        "axes.plot([0, -sign * belt.belt_speed], [sign * kinetic] * 2",
        "axes.plot([0, sign * belt.belt_speed], [sign * kinetic] * 2",
        FIGURES,
    ),
    Mutant(
        "Fig. 5 names a method after another",
        REPORT + "figures.py",
        'draw_motion(orbit, axes, "acceleration", label=NAMES[method])',
        'draw_motion(orbit, axes, "acceleration", '
        'label=NAMES[{"hb": "c1", "c1": "hb"}.get(method, method)])',
        FIGURES,
    ),
    Mutant(
        "Fig. 5 at another order",
        REPORT + "figures.py",
        "SMALL, LAST = 3, 12",
        "SMALL, LAST = 4, 12",
        FIGURES,
    ),
    Mutant(
        "the overshoot in the units of the acceleration",
        REPORT + "figures.py",
        'words = f"overshoot {percent(size / jump)} of the jump"',
        'words = f"overshoot {percent(size)} of the jump"',
        FIGURES,
    ),
    Mutant(
        "the band of Fig. 4 a tenth as wide",
        REPORT + "figures.py",
        "axes.axhspan(1 - BAND, 1 + BAND,",
        "axes.axhspan(1 - BAND / 10, 1 + BAND / 10,",
        FIGURES,
    ),
    Mutant(
        "Fig. 4 has the periods mirrored at the exact one",
        REPORT + "figures.py",
        "lambda method, N: 1 + case.period_error(method, N), LAST)",
        "lambda method, N: 1 - case.period_error(method, N), LAST)",
        FIGURES,
    ),
    Mutant(
        "Fig. 6 labelled as the error of the period",
        REPORT + "figures.py",
        'axes.set(yscale="log", ylabel="error (22) of the acceleration")',
        'axes.set(yscale="log", ylabel="|T / T exact − 1|")',
        FIGURES,
    ),
    Mutant(
        "Fig. 6 draws the error of the period",
        REPORT + "figures.py",
        "lambda method, N: above_floor(case.acceleration_error(method, N)), MOST",
        "lambda method, N: above_floor(abs(case.period_error(method, N))), MOST",
        FIGURES,
    ),
    Mutant(
        "the markers of the methods swapped",
        "src/nonsmooth/style.py",
        '"c1": {"color": "#009E73", "marker": "o"',
        '"c1": {"color": "#009E73", "marker": "s"',
        FIGURES,
    ),
)

#: What is quoted and measured: the paper's words, the other reading of (21), multipliers.
_SAID = (
    Mutant(
        "a quotation with a word left out",
        REPORT + "claims/quotations.py",
        'is entirely "\n        "eliminated',
        'is "\n        "eliminated',
        ("tests/report/test_quotations.py",),
    ),
    Mutant(
        "a quotation in another section",
        REPORT + "claims/quotations.py",
        '"Section 3.3", "for t < t₁',
        '"Section 3.2", "for t < t₁',
        ("tests/report/test_quotations.py",),
    ),
    Mutant(
        "a threshold that is ours said to be another",
        REPORT + "claims/one_function.py",
        'ours="a factor of 0.7"',
        'ours="a factor of 0.8"',
        ("tests/report/test_quotations.py",),
    ),
    Mutant(
        "a quotation under the next claim",
        REPORT + "page.py",
        "quotation = QUOTATIONS[claim.name]",
        "quotation = QUOTATIONS[CLAIMS[place % len(CLAIMS)].name]",
        ("tests/report/test_report.py",),
    ),
    Mutant(
        "the other reading is that of normalised time",
        REPORT + "reading.py",
        "np.mod(T * part, z[-1])",
        "z[-1] * part",
        CAPTIONS,
    ),
    Mutant(
        "the other reading without the jumps of the series",
        REPORT + "reading.py",
        "for time in (t1, *z[-2:])",
        "for time in (t1,)",
        CAPTIONS,
    ),
    Mutant(
        "both readings of (21) exchanged",
        REPORT + "reading.py",
        'f"{method} {percent(error_at_equal_times(case, method, order))} instead of "\n'
        '        f"{percent(case.acceleration_error(method, order))}"',
        'f"{method} {percent(case.acceleration_error(method, order))} instead of "\n'
        '        f"{percent(error_at_equal_times(case, method, order))}"',
        CAPTIONS,
    ),
    Mutant(
        "Fig. 2(d) ends with the period",
        REPORT + "figures.py",
        "PERIODS = 1.2",
        "PERIODS = 1.0",
        FIGURES,
    ),
    Mutant(
        "Fig. 2(b) to (d) begin again with slip",
        REPORT + "figures.py",
        "np.append(values, values[again])",
        "np.append(values, values[-again.sum() :])",
        FIGURES,
    ),
    Mutant(
        "--figure draws the figure before",
        "src/nonsmooth/cli/shortcuts/report.py",
        "write_plate(belt, int(figure), target)",
        "write_plate(belt, max(int(figure) - 1, 1), target)",
        ("tests/report/test_one_figure.py",),
    ),
    Mutant(
        "the parts of a figure in another order",
        REPORT + "build.py",
        "FIGURES[name](axes, case)\n",
        "FIGURES[names[-1 - names.index(name)]](axes, case)\n",
        ("tests/report/test_one_figure.py",),
    ),
    Mutant(
        "a multiplier is stable by its real part",
        REPORT + "scenes/multipliers.py",
        "modulus = abs(value)",
        "modulus = value.real",
        ("tests/report/test_report_of_a_scene.py",),
    ),
    Mutant(
        "a multiplier at 1 counted as unstable",
        REPORT + "scenes/multipliers.py",
        "abs(modulus - 1) <= rounding",
        "abs(modulus - 1) < 0",
        ("tests/report/test_report_of_a_scene.py",),
    ),
)

#: What is written beside the figures.
_CAPTIONS = (
    Mutant(
        "the caption of Fig. 4 inverted",
        REPORT + "captions.py",
        'return f"The C¹ series stays ahead from',
        'return f"The C¹ series stays behind from',
        CAPTIONS,
    ),
    Mutant(
        "the caption of Fig. 4 has the last order behind",
        REPORT + "captions.py",
        "N = {behind[-1] + 1}",
        "N = {behind[-1]}",
        CAPTIONS,
    ),
    Mutant(
        "ahead at every order where it is never ahead",
        REPORT + "captions.py",
        "    if not behind:\n",
        "    if behind:\n",
        CAPTIONS,
    ),
    Mutant(
        "the caption of Fig. 4 has those outside of the band",
        REPORT + "captions.py",
        "errors[N] > BAND]",
        "errors[N] < BAND]",
        CAPTIONS,
    ),
    Mutant(
        "the share of slip for that of stick",
        REPORT + "captions.py",
        "share = motion.t1 / motion.period",
        "share = 1 - motion.t1 / motion.period",
        CAPTIONS,
    ),
    Mutant(
        "the jump without its unit",
        REPORT + "captions.py",
        'f"{number(jump)} m/s². That is',
        'f"{number(case.alpha)} m/s². That is',
        CAPTIONS,
    ),
    Mutant(
        "kinetic friction for static",
        REPORT + "captions.py",
        "{number(belt.mu_s * belt.normal_force)}",
        "{number(belt.mu_k * belt.normal_force)}",
        CAPTIONS,
    ),
    Mutant(
        "the time of the ripple for its distance from the end",
        REPORT + "captions.py",
        'end = case.orbit("hb", MOST).t1 - time',
        "end = time",
        CAPTIONS,
    ),
    Mutant(
        "the errors of Fig. 5 are those of the period",
        REPORT + "captions.py",
        'f"{method} {percent(case.acceleration_error(method, THREE))}"',
        'f"{method} {percent(abs(case.period_error(method, THREE)))}"',
        CAPTIONS,
    ),
    Mutant(
        "the rates beside Fig. 6 are those of the period",
        REPORT + "captions.py",
        "rates = [(m, case.rates(m).acceleration) for m",
        "rates = [(m, case.rates(m).period) for m",
        CAPTIONS,
    ),
    Mutant(
        "the table of the page has its errors swapped",
        REPORT + "page.py",
        "(percent(case.period_error(name, N)), _visible_error(case, name, N))",
        "(_visible_error(case, name, N), percent(case.period_error(name, N)))",
        ("tests/report/test_report.py",),
    ),
)

MUTANTS: tuple[Mutant, ...] = _FIGURES + _SAID + _CAPTIONS
