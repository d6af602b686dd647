"""What commands refuse: one line that says why."""

import pytest
from refusals import refused

#: More figures than Python reads.
FIGURES = "9" * 5000

#: Lists of orders that are none.
NO_ORDERS = ("5-2", "0", "0-4", "-3", "1-", "a", "", "1,,2", "1.5", "1-2-3", "1-99999999")

#: By the command: its arguments, and what is said of them.
REFUSED = {
    "": [("fly", "--help"), ("solve --colour", "--help"), ("solve extra", "--help")],
    "roots": [
        ("--mu-k 0.5 --order 5", "expected less than mu_s = 0.5"),
        ("--order=0", "order"),
        ("--order=401", "order"),
        ("--order=x", "order"),
        ("", "--order"),
    ],
    "equations": [
        ("imapct", "SCENE: got 'imapct', expected one of absorber-friction, backlash, "),
        ("imapct", "did you mean impact?"),
        ("impact --method c1", "impact is C0"),
        ("impact --method hbc0", "did you mean hb-c0?"),
        ("impact --method hb --functions 2", "--functions: got 2"),
        ("impact --method hb-ck --functions 0", "--functions: got 0"),
        ("impact --method hb-ck --functions 99999", "expected for hb-ck: 1, 2, 3"),
        ("impact --method=", "--method: got '', expected one of hb, hb-ck"),
        ("none.py", "none.py: there is no such file"),
        ("string-spring --method hb", "--method: got 'hb', expected one of ritz, ritz-ck, ck"),
        ("string-spring --functions 2", "--functions: got 2"),
        ("--method galerkin", "--method: got 'galerkin', expected one of hb, hb-c1"),
        ("--format word", "--help"),
        ("--format latex -o a.html", "a.html with --format latex"),
        ("--format text -o a.PDF", "expected .txt"),
        ("-o a.docx", "expected a name that ends in one of .txt, .tex, .html, .pdf"),
        ("--format pdf", "expected -o FILE.pdf"),
        ("--fragment", "--fragment: got format text, expected latex"),
        ("--fragment -o a.html", "--fragment: got format html"),
        (
            "dry-friction --phases slide,halt",
            "--phases: got 'halt', expected one of slide, stop",
        ),
        ("dry-friction --phases slide --motion sliding", "--phases: got slide beside --motion"),
        ("beam-crack --phases slide", "--phases: got 'slide', expected a SCENE that has"),
    ],
    "solve": [
        ("impakt", "did you mean impact?"),
        ("42", "expected one of absorber-friction, backlash"),
        ("impact --method c1-tau", "--method: got 'c1-tau', expected one of"),
        ("impact --method c0-tao", "did you mean ck-tau?"),
        ("impact --gab 1", "impact has no --gab. Did you mean --gap?"),
        ("impact --belt-speed 1", "has no --belt-speed. It has --mass, --damping,"),
        ("impact --motion xx", "--motion: impact has one motion, which needs no name"),
        ("dry-friction --motion xx", "expected one of sliding, two-stops"),
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
        ("--order 3 impact", "argument (impact); what a command is about comes first"),
        ("beam-mass", "; beam-mass is a structure, of `nonsmooth modes`"),
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
        *(
            (f"--tol={tol}", f"--tol: got {float(tol)}, expected a number between 0 and 1")
            for tol in ("0", "-1e-3", "1", "nan", "inf")
        ),
        ("--mu-k=-0.1", "mu_k"),
        ("--mu-k=nan", "mu_k"),
        ("--mu-k=inf", "mu_k"),
        ("--mu-k=x", "--mu-k"),
        ("--mass=", "valid float"),
        ("--mass=0", "mass: got 0.0, expected a positive number"),
        ("--mass=1e400", "mass: got inf, expected a positive number"),
        ("--order=2.5", "'2.5' is not a valid integer"),
        ("--order=", "'' is not a valid integer"),
        ("--method hb-c1 --order=-3", "--order: got -3, expected a whole number from 1"),
        ("--method c1 --order 1000001", "--order: got 1000001, expected a whole number from 1"),
        ("--mu-k 0.5", "expected less than mu_s = 0.5"),
        ("--mu-k 0.6", "expected that mu_k is at most mu_s"),
        ("--mu-k 1e9", "expected that mu_k is at most mu_s"),
        ("--mass 1e300 --belt-speed 1e300 --normal-force 1e-300", "beyond float64"),
        ("--method galerkin", "--method: got 'galerkin', expected one of ck, ck-tau, hb,"),
        ("beam-mass", "scene: got 'beam-mass'"),
    ],
    "sweep": [
        ("--methods galerkin", "--methods: got 'galerkin', expected one of ck, ck-tau, hb,"),
        ("--methods hb,", "--methods: got '', expected one of ck, ck-tau, hb, hb-c1, hb-ck"),
        ("--methods hb,c2", "--methods: got 'c2', expected one of ck, ck-tau, hb, hb-c1"),
        ("--methods=", "--methods: got '', expected one of ck, ck-tau, hb, hb-c1, hb-ck"),
        *((f"--orders={orders}", repr(orders)) for orders in NO_ORDERS),
        ("--orders 3,1000001", "got 1000001, expected a whole number from 1 to"),
        ("--methods hb,c1 --orders 3,500", "got 500"),
        (f"--orders {FIGURES}", "--orders: got "),
        (f"--orders 1-{FIGURES}", "--orders: got "),
        (f"--orders 1,2,...,{FIGURES}", "--orders: got "),
        (f"--vary mass=1:2:{FIGURES}", "--vary: got "),
        (f"--vary mass=1:2:3 --orders {FIGURES}", "--orders: got "),
        ("impact --methods hb,galerkin", "--methods: got 'galerkin'"),
        ("impact --methods ck --orders 1,3", "--orders: got 1"),
        ("impact --orders 3-", "'3-'"),
        ("impact --log", "--log: expected beside --vary"),
        ("-o x", "-o: got x, expected a name that ends in one of .json, .csv, .nc"),
    ],
    "branch dry-friction": [
        ("--vary mu_s=0.1:0.2", "nonsmooth: parameters: got mu_s = 0.1, mu_k = 0.3, expected"),
    ],
    "sweep impact --vary": [
        ("gap=0.1", "expected NAME=FROM:TO:POINTS, such as restitution=0.3:0.6:20"),
        ("gape=0:1:3", "unknown parameter 'gape', expected one of mass"),
        ("gape=0:1:3", "restitution; did you mean gap?"),
        ("gap=1:1:3", "two different numbers"),
        ("gap=0:1:1", "expected a whole number from 2 to 100000"),
        ("gap=0:1:3 --log", "--log: got an end"),
        ("gap=0:1:3 --gap 0.1", "--gap: given beside --vary gap"),
        ("gap=0:1:3 --orders 1-3", "expected one order"),
        ("gap=0:1:3 --methods hb,ck", "expected one method"),
        ("restitution=0.5:2:3", "--vary: restitution: got 1.25"),
        ("gap=0:1:3 --vary mass=1:2:3", "--vary: got gap=0:1:3 and mass=1:2:3, expected one"),
    ],
    "branch impact": [
        ("--vary gap=0:1 --vary mass=1:2", "--vary: got gap=0:1 and mass=1:2, expected one"),
    ],
    "branch clearance": [
        ("--vary frequency=1:2:10", "--vary: got 'frequency=1:2:10', expected NAME=FROM:TO"),
        ("--vary speed=1:2", "--vary: unknown parameter 'speed'"),
        ("--vary frequency=1:1", "--vary: got 'frequency=1:1', expected two different"),
        ("--vary frequency=-1:2", "frequency: got -1.0"),
        ("--vary frequency=1:2 --from-orbit none.json", "cannot read none.json"),
        ("", "Missing option '--vary'"),
        ("--vary frequency=1:2 --attractors", "--attractors: expected beside --output"),
        ("--vary frequency=1:2 --all -o all.csv", "beside --all, expected .json"),
    ],
    "map impact --vary gap=0:1:5": [
        ("", "--vary: got gap=0:1:5, expected two parameters"),
        ("--vary gap=1:2:5", "--vary: got gap=0:1:5 and gap=1:2:5, expected two"),
        ("--vary mass=1:2:1", "--vary: got '1' points, expected a whole number from 2"),
        ("--vary speed=1:2:5", "--vary: unknown parameter 'speed'"),
        ("--vary mass=-1:2:5", "mass: got -1.0"),
        ("--vary damping=1:2:5 --damping 0", "--damping: given beside --vary damping"),
    ],
    "map impact --vary gap=0:1:5000": [
        ("--vary mass=1:2:5000", "axes: got 5000 by 5000 points"),
    ],
    "modes": [
        ("beam-mas", "did you mean beam-mass?"),
        ("--position 1/3 beam-mass", "--position: expected STRUCTURE before it"),
        ("--case none.toml", "or a case file with a table of one"),
        ("beam-mass --position 0", "--position: got '0', expected a fraction"),
        ("beam-mass --position 1", "above 0 and below 1"),
        ("beam-mass --position 7/5", "--position: got '7/5'"),
        ("beam-mass --position 1/0", "--position: got '1/0'"),
        ("beam-mass --position 1e-5", "--position: got 1e-05, expected 1/10000 from an end"),
        ("beam-mass --position middle", "--position: got 'middle'"),
        ("beam-mass --mass 0", "--mass: got 0.0, expected a number above 0 in kg (without"),
        ("beam-mass --mass -5", "--mass: got -5.0, expected a number above 0 in kg"),
        ("beam-mass --mass nan", "--mass: got nan"),
        ("beam-mass --mass 1e40", "--mass: got 1e+40, a dimensionless strength of 1e+40"),
        ("beam-mass --stiffness 3", "beam-mass has no --stiffness. Did you mean --bending-st"),
        ("beam-mass --xyz 3", "beam-mass has no --xyz. It has --position, --length, --bending"),
        ("beam-mass --method hb", "one of ritz, ritz-ck, ck: beam-mass is C2; or all"),
        ("beam-mass --method ritz --forced 2", "--forced: got 2, ritz has no forced"),
        ("beam-mass --forced 4", "--forced: got 4, expected a whole number from 1 to 3"),
        ("beam-mass --order 0", "--order: got 0, expected a whole number from 1 to 512"),
        ("beam-mass --order 2 --count 7", "--count: got 7, ritz-ck at order 2 has 3"),
        ("beam-mass --count 0", "--count: got 0, expected a whole number from 1"),
        ("beam-mass --order 2 --tol 1e-3", "--tol: got 0.001 with order 2"),
        ("beam-mass --tol 2", "--tol: got 2.0, expected a number above 0 and below 1"),
        ("beam-mass --log", "--log: expected --vary with it"),
        ("beam-mass --vary mass=1:2", "--vary: got 'mass=1:2', expected NAME=FROM:TO:POINTS"),
        ("beam-mass --vary gap=1:2:3", "--vary: unknown parameter 'gap'"),
        ("beam-mass --vary position=0:1/2:3", "--vary: position: got 0, expected"),
        ("beam-mass --vary mass=1:1:3", "two different numbers"),
        ("beam-mass --vary mass=1:2:3 --mass 3", "--mass: given beside --vary mass"),
        ("beam-mass --vary mass=1:2:1", "--vary: got '1' points"),
        ("beam-mass --vary mass=1:2:3 --vary mass=2:3:3", "and mass=2:3:3, expected one"),
        ("beam-mass --vary mass=1:2:3 --method all", "expected one method"),
        ("beam-mass -o modes.txt", "-o: got modes.txt, expected a name that ends in"),
    ],
    "modes beam-mass --shapes": [
        ("5", "--shapes: expected -o FILE that ends in one of .json, .csv, .nc"),
        ("5 -o a.png", "--shapes: expected -o FILE that ends in one of .json, .csv, .nc"),
        ("1 --json", "--shapes: got 1, expected a whole number from 2 to 1000000"),
        ("5 --json --method all", "--shapes: got --method all with it, expected one method"),
        ("5 --json --vary mass=1:2:2", "--shapes: got --vary with it, expected one structure"),
    ],
    "modes beam-spring --position 1/2": [
        ("--stiffness -48", "--stiffness: got -48.0, expected more than the critical"),
        ("--vary stiffness=-50:-40:3", "critical stiffness -48 N/m, at which the beam"),
        ("--stiffness 0", "expected a number other than 0 in N/m (without"),
        ("--stiffness -1e40", "got -1e+40, expected more than the critical"),
        ("--stiffness -1e-40", "expected one of a size from 1e-09 to 1e+09"),
        ("--stiffness -1e300 --length 1e100", "beyond float64"),
        ("--stiffness 1e240 --length 1e-80", "unit of the highest derivative"),
        ("--shapes 1000000000000 --json", "--shapes: got 1000000000000, expected a whole"),
        ("--length -1", "--length: got -1.0, expected a number above 0 in m"),
    ],
    "sweep beam-mass": [
        ("--methods hb", "--methods: got 'hb'"),
        ("--methods ritz --forced 1", "--forced: got '1', ritz has no forced modes"),
        ("--forced 1,x", "--forced: got 'x'"),
        ("--orders 0-3", "--orders: got '0-3'"),
        ("--orders 200", "--orders: got 200"),
        ("--mode 0", "--mode: got 0"),
    ],
    "simulate": [
        ("impact --state 1", "--state: got '1', expected displacement and velocity as X,V"),
        ("impact --state a,b", "--state: got 'a,b'"),
        ("impact --state nan,0", "--state: got nan, expected a finite displacement in m"),
        ("impact --state 1,2", "flight not true that the mass stays before the stop"),
        ("impact --cycles 0", "--cycles: got 0.0, expected a positive number"),
        ("impact --vary gap=0:1:3 --gap 1", "--gap: given beside --vary gap, which sets it"),
        ("impact --vary gap=1:2:3 --grid x=0:1:2", "--grid: got x=0:1:2 beside --vary"),
        ("impact --grid x=0:1:2", "expected one for x and one for v"),
        ("impact --grid y=0:1:2 --grid v=0:1:2", "--grid: unknown parameter 'y'"),
        ("impact --vary gap=1:2:3 --state 0,0", "--state: got 0,0 beside --vary"),
        ("impact --vary gap=1:2:3 --cycles 1.5", "--cycles: got 1.5 beside --vary"),
        ("impact --transient 5", "--transient: got 5, expected beside --vary"),
        ("impact --vary gap=0:1:3 --vary mass=1:2:3", "mass=1:2:3, expected one of them"),
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
    ids=lambda text: f"{text:.60}",
)
def test_what_is_refused_is_one_line(
    run, command: str, arguments: str, words: str, tmp_path, monkeypatch
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("nonsmooth.cli.progress.QUIET", 600.0)  # however slow the machine is
    if command == "digits":
        pytest.importorskip("flint")
    assert words in refused(run, *command.split(), *arguments.split())
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("impact", "--tol", 1e-15), "no estimate in float64 goes below 2e-15"),
        (("--tol", 1e-16), "no estimate in float64 goes below"),
        (("--tol", 1e-15, "--method", "c1"), "no estimate in float64 goes below"),
        (("--tol", 1e-9, "--method", "hb"), "it would need N of about"),
        (("impact", "--tol", 1e-7, "--method", "hb"), "it would need N of about"),
        (("clearance", "--gap", 1.35605, "--tol", 1e-14), "do not fall any more"),  # grazes
    ],
)
def test_a_tolerance_that_cannot_be_met_is_status_1(run, arguments, words: str) -> None:
    status, out, err = run("solve", *arguments)
    assert (status, out) == (1, "")
    assert words in err
