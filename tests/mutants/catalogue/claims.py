"""Mistakes in the checks of the claims: thresholds never false, wrong measures, no alpha."""

from ..mutant import Mutant

REPORT = "src/nonsmooth/report/"

CHECKS = tuple(f"tests/report/test_report_checks{part}.py" for part in ("", "_c1", "_orbit"))
VERDICTS = ("tests/report/test_verdicts.py",)


def fourier(what: str, old: str, new: str) -> Mutant:
    """Return a mistake in a check of a Fourier series."""
    return Mutant(what, REPORT + "checks/fourier.py", old, new, CHECKS[:1])


def c1(what: str, old: str, new: str) -> Mutant:
    """Return a mistake in a check of the C1 series."""
    return Mutant(what, REPORT + "checks/c1.py", old, new, CHECKS[1:2])


def orbit(what: str, old: str, new: str) -> Mutant:
    """Return a mistake in a check of the exact orbit or g1."""
    return Mutant(what, REPORT + "checks/orbit.py", old, new, CHECKS[2:])


def measure(what: str, old: str, new: str) -> Mutant:
    """Return a mistake in what a case measures."""
    return Mutant(what, REPORT + "case.py", old, new, VERDICTS)


MUTANTS: tuple[Mutant, ...] = (
    fourier("Gibbs is never false", "abs(over / GIBBS - 1) < 1 / 3", "abs(over) >= 0"),
    fourier(
        "Gibbs without a lower end", "abs(over / GIBBS - 1) < 1 / 3", "over < GIBBS * 4 / 3"
    ),
    fourier("not uniform is never false", "min(errors) >= 0.4", "min(errors) >= 0"),
    fourier("not uniform by the largest", "min(errors) >= 0.4", "max(errors) >= 0.4"),
    fourier("the mean square falls at any rate", "coarse * 2**-0.4", "coarse * 2**0.4"),
    fourier("away from the jumps is never false", "errors[2] > errors[0] / 2", "errors[2] > 0"),
    fourier("the ripple stays if it vanishes", "max(over[1] / 2, UNSEEN)", "over[1] / 2"),
    fourier("the mean at any height", "abs(level - 0.5) < 0.1", "level - 0.5 < 0.1"),
    fourier("the mean at the wrong end", "_level(case, t1 / T)", "_level(case, 0.5)"),
    fourier("slow without an upper end", "0.8 <= rate <= 1.2", "0.8 <= rate"),
    fourier("visible if any order is", "bool(errors) and not inside", "bool(errors)"),
    fourier("steady without an orbit", 'bool(case.orders("hb")) and not found', "not found"),
    fourier("rises by rounding", 'errors[N] > FLOORS["acceleration"]', "errors[N] > 0"),
    fourier("rises of the other method", 'rises(case, "hb-c1")', 'rises(case, "hb")'),
    fourier(
        "one power too few",
        '_two_rates(case, "period", 1.0)',
        '_two_rates(case, "period", 0.0)',
    ),
    fourier("the ripple need not vanish", "over[2] < UNSEEN < without", "over[2] < without"),
    fourier(
        "a ripple at N = 3 is not seen",
        "Finding(over < UNSEEN, words)",
        "Finding(over < without, words)",
    ),
    fourier("uniform at any rate", "fine < 0.7 * coarse", "fine < coarse"),
    c1(
        "overtakes at any order",
        "Finding(first <= MOST // 2, words)",
        "Finding(first <= MOST, words)",
    ),
    c1(
        "overtakes in the wrong error",
        '_overtakes(case, "acceleration")',
        '_overtakes(case, "period")',
    ),
    c1("beyond three counts from three", "if N > THREE]", "if N >= THREE]"),
    c1("behind is ahead", "Finding(ours > theirs,", "Finding(ours < theirs,"),
    c1("in the band from below", "Finding(abs(worst) <= BAND,", "Finding(worst <= BAND,"),
    c1("the size grows if the error does", "if abs(b) >= abs(a)]", "if b >= a]"),
    c1("it never crosses", "if a * b < 0]", "if a * b < -1]"),
    c1("the poorest is another", '== "hb", words)', '!= "c1", words)'),
    c1("stick is nearly exact", "Finding(largest == 0,", "Finding(largest < 1e-9,"),
    c1("no ripple at N = 5 or 10", "errors[-1] < UNSEEN", "min(errors) < UNSEEN"),
    c1(
        "all derivatives but the jerk",
        "for row in rows for a, b in",
        "for row in rows[:3] for a, b in",
    ),
    c1("all derivatives, however slowly", "b * GAIN < max(a, 1e-11)", "b < max(a, 1e-11)"),
    c1("stairs of any height", "min(odd) > 2 > max(even)", "min(odd) > max(even)"),
    c1(
        "even orders may add",
        "max(map(abs, even.values())) < 0.01",
        "max(even.values()) < 0.01",
    ),
    orbit(
        "C1 is never false", "max(map(abs, x + v)) <= size and", "max(map(abs, x + v)) >= 0 and"
    ),
    orbit("C1 without a jump of the acceleration", "and max(a) <= -case.alpha + size", ""),
    orbit(
        "one jump of the acceleration is enough", "and max(a) <= -case", "and min(a) <= -case"
    ),
    orbit(
        "faster than the belt", "Finding(fastest <= 1 + ROUNDING,", "Finding(fastest <= 1.1,"
    ),
    orbit("friction in slip for that in stick", "(2 * belt.mu_k - belt.mu_s)", "belt.mu_k"),
    orbit(
        "about any centre",
        "Finding(abs(mean) <= ROUNDING * (1 + case.alpha)",
        "Finding(abs(mean) <= 1",
    ),
    orbit("g1 is only continuous", "        for d in (0, 1)\n", "        for d in (0,)\n"),
    orbit(
        "any part of g1 may be left",
        "Finding(left < ROUNDING, words)",
        "Finding(left < 1, words)",
    ),
    measure(
        "overshoot without alpha",
        "/ (self.alpha * self.belt.acceleration_unit)",
        "/ self.belt.acceleration_unit",
    ),
    measure(
        "overshoot without its unit",
        "/ (self.alpha * self.belt.acceleration_unit)",
        "/ self.alpha",
    ),
    measure(
        "the largest error in other units",
        "size = self.alpha if derivative == 2 else",
        "size = 1.0 if derivative == 2 else",
    ),
    measure(
        "the amplitude without stick",
        "float(np.hypot(1, self.alpha))",
        "1.0",
    ),
    measure(
        "inside a phase are its ends",
        "reshape(2, 4, -1)[:, 1:3]",
        "reshape(2, 4, -1)[:, 0:3]",
    ),
    measure(
        "inside without alpha",
        "float(inside.max()) / self.alpha",
        "float(inside.max())",
    ),
    Mutant(
        "an orbit that is missing counts for a claim",
        REPORT + "finding.py",
        "return Finding(False, missing.reason)",
        "return Finding(True, missing.reason)",
        VERDICTS,
    ),
    Mutant(
        "one part is enough for a verdict",
        REPORT + "finding.py",
        "VERDICTS[0] if all(counted)",
        "VERDICTS[0] if any(counted)",
        VERDICTS,
    ),
    Mutant(
        "parts that do not count do",
        REPORT + "finding.py",
        "strict=True) if part.counts]",
        "strict=True)]",
        VERDICTS,
    ),
)
