"""Why there is no orbit is said once, not for each method again."""


def test_a_reason_that_holds_for_all_methods_is_said_once(run) -> None:
    status, _, err = run("solve", "impact", "--gap", 5)
    (line,) = err.splitlines()
    assert status == 1
    assert line.startswith("nonsmooth: impact: no such orbit exists")


def test_methods_without_an_orbit_for_the_same_reasons_are_named(run) -> None:
    status, _, err = run("solve", "clearance", "--gap", 5)
    first, *others = err.splitlines()
    assert status == 1
    assert "a scan of the durations of contact" in first
    assert others == [
        f"nonsmooth: clearance, {method}, N = 10: no orbit, for the same reasons"
        for method in ("hb-ck", "ck", "ck-tau")
    ]
