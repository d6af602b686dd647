"""What commands of scenes refuse: one line that says why."""

import pytest
from refusals import refused

#: By the command: its arguments, and what is said of them.
REFUSED = {
    "solve": [
        ("impakt", "did you mean impact?"),
        ("42", "expected one of backlash"),
        ("impact --method c1-tau", "--method: got 'c1-tau', expected one of"),
        ("impact --method c0-tao", "did you mean ck-tau?"),
        ("impact --gab 1", "impact has no --gab. Did you mean --gap?"),
        ("impact --belt-speed 1", "has no --belt-speed. It has --mass, --damping,"),
        ("impact --ordre 1", "Did you mean --order?"),
        ("impact --gap x", "'--gap': 'x' is not a valid float"),
        ("impact --restitution 2", "restitution: got 2.0, expected a"),
        ("impact --gap nan", "gap: got nan"),
        ("impact --order 1", "--order: got 1, expected a whole number from 2 to 400 for ck"),
        ("impact --method hb --functions 2", "--functions: got 2, expected for hb"),
        ("impact --functions 9", "--functions: got 9, expected for hb-ck: 1, 2, 3"),
        ("impact --tol 2", "--tol: got 2.0, expected a number between 0 and 1"),
        ("impact --tol 0.1 --order 3", "--order: got 3 beside --tol"),
        ("impact -o x.txt", "expected a name that ends in one of .json, .csv, .nc"),
        ("impact extra", "unexpected extra argument (extra)"),
        ("stick-slip-damped --mu-k 0.6", "expected that mu_k is at most mu_s"),
        ("impact --budget 1ms --tol 1e-3", "--budget"),
        ("impact --budget 1ms --order 3", "--order: got 3 beside --budget"),
        ("impact --budget 1", "--budget: got '1'"),
        ("impact --budget 1ms --method c1", "--method: got 'c1'"),
        ("impact --freq 3", "impact has no --freq. Did you mean --frequency? (see"),
        ("impact --fre=3", "impact has no --fre. Did you mean --frequency? (see"),
        ("dry-friction --mu 3", "Did you mean --mu-s or --mu-k? (see"),
        ("impact --farce 3", "Did you mean --force? (see"),
        ("impact --Gap 3", "Did you mean --gap? (see"),
        ("impact --tol_ 3", "Did you mean --tol? (see"),
        ("impact --xyz 3", "It has --mass, --damping, --stiffness, --force, --freq"),
        ("--norm 3", "stick-slip has no --norm. Did you mean --normal-force? (see"),
        ("--c1-terms 3", "--functions K, with --method hb-ck"),
        ("--xyz 3", "--mu-k, --normal-force. (see nonsmooth solve --help)"),
    ],
    "sweep": [
        ("impact --methods hb,galerkin", "--methods: got 'galerkin'"),
        ("impact --methods ck --orders 1,3", "--orders: got 1"),
        ("impact --orders 3-", "'3-'"),
        ("impact --log", "--log: expected beside --vary"),
    ],
    "sweep impact --vary": [
        ("gap=0.1", "expected NAME=FROM:TO:POINTS, such as restitution=0.3:0.6:20"),
        ("gape=0:1:3", "unknown parameter 'gape', expected one of mass"),
        ("gap=1:1:3", "two different numbers"),
        ("gap=0:1:1", "expected a whole number from 2 to 100000"),
        ("gap=0:1:3 --log", "--log: got an end"),
        ("gap=0:1:3 --gap 0.1", "--gap: given beside --vary gap"),
        ("gap=0:1:3 --orders 1-3", "expected one order"),
        ("gap=0:1:3 --methods hb,ck", "expected one method"),
        ("restitution=0.5:2:3", "--vary: restitution: got 1.25"),
    ],
    "simulate": [
        ("impact --state 1", "--state: got '1', expected displacement and velocity as X,V"),
        ("impact --state a,b", "--state: got 'a,b'"),
        ("impact --state nan,0", "--state: got nan, expected a finite displacement in m"),
        ("impact --state 1,2", "flight not true that the mass stays before the stop"),
        ("impact --cycles 0", "--cycles: got 0.0, expected a positive number"),
        ("impact --time -1", "--time: got -1.0, expected a positive number"),
        ("impact --time 1 --cycles 2", "--time: got 1.0 beside cycles"),
        (
            "impact --state 1e308,0",
            "--state: got (1e+308, 0.0), expected numbers within float64",
        ),
        (
            "impact --cycles 1000000000.0",
            "--cycles: got 1000000000.0, expected at most 100000 cycles",
        ),
        ("impact --forcing-phase inf", "--forcing-phase: got inf, expected a finite number"),
        (
            "stick-slip --forcing-phase 1",
            "--forcing-phase: got 1.0, expected 0: nothing forces",
        ),
        ("impact --restitution 2", "restitution: got 2.0"),
        ("impact --mass-of 2", "impact has no --mass-of. Did you mean --mass?"),
        ("impact -o m.txt", "-o: got m.txt, expected a name that ends in one of .json, .csv"),
    ],
    "digits": [
        ("impact --quick --orders 5", "--quick: got --orders 5 beside it"),
        ("impact --methods c1", "--methods: got 'c1'"),
        ("impact --orders x", "--orders: "),
        ("impact --orders 10,1000000", "--orders: got 1000000, expected at most 400"),
        ("impact --gap nan", "gap: got nan"),
        ("impact -o digits.csv", "digits.csv"),
        ("stick-slip-damped --mu-k 0.5", "extremes: no numbers for these parameters"),
        ("impact --damping 0 --frequency 1", "extremes: no numbers for these"),
    ],
}


@pytest.mark.parametrize(
    ("command", "arguments", "words"),
    [(command, *each) for command, every in REFUSED.items() for each in every],
)
def test_what_is_refused_is_one_line(run, command: str, arguments: str, words: str) -> None:
    if command == "digits":
        pytest.importorskip("flint")
    assert words in refused(run, *command.split(), *arguments.split())


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("impact", "--tol", 1e-15), "no estimate in float64 goes below 2e-15"),
        (("impact", "--tol", 1e-7, "--method", "hb"), "it would need N of about"),
        (("clearance", "--gap", 1.35605, "--tol", 1e-14), "do not fall any more"),  # grazes
    ],
)
def test_a_tolerance_that_cannot_be_met_is_status_1(run, arguments, words: str) -> None:
    status, out, err = run("solve", *arguments)
    assert (status, out) == (1, "")
    assert words in err
