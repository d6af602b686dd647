"""Bad input: one line that names the argument, the value and what was expected; status 2."""

import os
from pathlib import Path

import pytest
from refusals import refused

from nonsmooth.kim_perkins import SECTION_4 as GOOD

POSITIVE = ("mass", "stiffness", "belt_speed", "mu_s", "normal_force")


@pytest.mark.parametrize("name", POSITIVE)
@pytest.mark.parametrize("value", ["abc", "0", "-1", "inf", "-inf", "nan", "1e400", ""])
@pytest.mark.parametrize("command", [("solve", "--method", "c1"), ("sweep",)])
def test_parameters_that_are_no_positive_number(run, name: str, value: str, command) -> None:
    flag = f"--{name.replace('_', '-')}"
    error = refused(run, *command, f"{flag}={value}")
    assert flag in error or f"{name}: got" in error
    assert "positive number" in error or "valid float" in error


@pytest.mark.parametrize("value", ["-0.1", "nan", "inf", "x"])
def test_kinetic_friction_that_is_no_coefficient(run, value: str) -> None:
    error = refused(run, "solve", f"--mu-k={value}")
    assert "mu_k" in error or "--mu-k" in error


@pytest.mark.parametrize(
    ("value", "words"),
    [("0.5", "less than mu_s = 0.5"), ("0.6", "that mu_k is at most mu_s"), ("1e9", "at most")],
)
@pytest.mark.parametrize("command", [("solve",), ("roots", "--order", 5)])
def test_kinetic_friction_not_below_static(run, command, value: str, words: str) -> None:
    error = refused(run, *command, "--mu-k", value)
    assert f"expected {words}" in error or ("expected that" in error and words in error)


def test_several_wrong_flags_are_named_at_once(run) -> None:
    error = refused(run, "solve", "--mass", 0, "--stiffness", "nan", "--mu-k", -1, below=2)
    assert all(
        name in error for name in ("mass: got 0.0", "stiffness: got nan", "mu_k: got -1")
    )


def test_parameters_beyond_float64_together(run) -> None:
    flags = ("--mass", 1e300, "--belt-speed", 1e300, "--normal-force", 1e-300)
    assert "beyond float64" in refused(run, "solve", *flags)


@pytest.mark.parametrize("command", ["solve", "equations"])
def test_an_unknown_method(run, command: str) -> None:
    error = refused(run, command, "--method", "galerkin")
    assert "'galerkin'" in error
    assert "hb-c1" in error


@pytest.mark.parametrize("methods", ["galerkin", "hb,", "", "hb,c2"])
def test_an_unknown_method_in_a_list(run, methods: str) -> None:
    wrong = methods.removeprefix("hb,")
    error = refused(run, "sweep", "--methods", methods)
    assert f"--methods: got {wrong!r}, expected one of ck, ck-tau, hb, hb-c1, hb-ck" in error


@pytest.mark.parametrize("order", ["0", "-3", "1000001", "2.5", "many", ""])
@pytest.mark.parametrize("method", ["hb", "hb-c1", "c1"])
def test_an_order_that_the_method_cannot(run, method: str, order: str) -> None:
    error = refused(run, "solve", "--method", method, f"--order={order}")
    assert "order" in error
    assert "expected a whole number from 1" in error or "valid integer" in error


@pytest.mark.parametrize(
    "orders", ["5-2", "0", "0-4", "-3", "1-", "a", "", "1,,2", "1.5", "1-2-3", "1-99999999"]
)
def test_orders_that_are_no_list(run, orders: str) -> None:
    assert repr(orders) in refused(run, "sweep", f"--orders={orders}")


def test_an_order_of_a_sweep_that_a_method_cannot_is_named_before_the_work(run) -> None:
    error = refused(run, "sweep", "--orders", "3,1000001")
    assert "got 1000001" in error
    assert "for hb" in error
    assert "got 500" in refused(run, "sweep", "--methods", "hb,c1", "--orders", "3,500")


def case_file(folder: Path, text: str | bytes) -> Path:
    path = folder / "belt.toml"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return path


def table(**changes: object) -> str:
    values = {name: value for name, value in (GOOD | changes).items() if value is not None}
    return "[stick_slip]\n" + "".join(f"{name} = {value}\n" for name, value in values.items())


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("", "no table [stick_slip]"),
        ("stick_slip = 3\n", "no table [stick_slip]"),
        ("[belt]\nmass = 1\n", "no table [stick_slip]"),
        (b"\x00\xff\xfe\x80binary", "not a text file"),
        (b"\x00\x01\x02", "is not TOML"),
        ("[stick_slip\n", "is not TOML"),
        ("mass = \n", "is not TOML"),
        (table(mass=None), "mass: missing"),
        (table(mas=1.0), "mas: not a parameter of stick-slip; did you mean mass?"),
        (table(colour='"red"'), "colour: not a parameter of stick-slip"),
        (table(cycles=2), "cycles: not a parameter of stick-slip"),
        (table(mass='"10"'), "mass: got '10', expected a positive number"),
        (table(mass="true"), "mass: got True, expected a positive number"),
        (table(mass="[1.0]"), "mass: got [1.0], expected a positive number"),
        (table(mass="nan"), "mass: got nan"),
        (table(mass="inf"), "mass: got inf"),
        (table(mass="-2"), "mass: got -2"),
        (table(mu_k="0.5"), "expected less than mu_s"),
        (table(mass="1" + "0" * 400), "mass: got 1000"),
        (table() + "[other]\nx = 1\n", "unknown 'other'"),
    ],
)
def test_a_wrong_case_file(run, tmp_path: Path, text: str | bytes, expected: str) -> None:
    path = case_file(tmp_path, text)
    error = refused(run, "solve", "--case", path)
    assert expected in error
    assert str(path) in error


def test_all_mistakes_of_a_case_file_are_named_at_once(run, tmp_path: Path) -> None:
    path = case_file(
        tmp_path, table(mass=-1, stiffness='"x"', belt_speed=None, mu_k=-1, masss=3, nu=1)
    )
    error = refused(run, "sweep", "--case", path, below=5)
    said = "mass: got", "stiffness: got", "belt_speed: missing", "mu_k: got", "masss:", "nu:"
    assert all(words in error for words in said)


def test_a_case_file_that_cannot_be_read(run, tmp_path: Path) -> None:
    assert "cannot read" in refused(run, "solve", "--case", tmp_path / "none.toml")
    assert "cannot read" in refused(run, "solve", "--case", tmp_path)


@pytest.mark.parametrize("command", ["solve", "sweep", "equations"])
def test_an_output_that_cannot_be(run, tmp_path: Path, command: str) -> None:
    assert "does not exist" in refused(run, command, "-o", tmp_path / "none" / "x.json")
    folder = tmp_path / "x.json"
    folder.mkdir()
    assert "is a folder" in refused(run, command, "-o", folder)
    closed = Path("/proc/self")
    if os.name != "posix" or not closed.is_dir():
        closed = tmp_path
        closed.chmod(0o500)
    assert "cannot write" in refused(run, command, "-o", closed / "x.json")


@pytest.mark.parametrize("command", ["solve", "sweep"])
@pytest.mark.parametrize("name", ["x", "x.txt", "x.jpeg"])
def test_an_output_of_unknown_kind(run, tmp_path: Path, command: str, name: str) -> None:
    error = refused(run, command, "-o", tmp_path / name)
    assert ".json" in error
    assert list(tmp_path.iterdir()) == []


def test_a_failed_write_leaves_the_old_file(run, tmp_path: Path, monkeypatch) -> None:
    target = tmp_path / "rows.json"
    target.write_text("old")

    replace = os.replace

    def fail(source, destination):
        if Path(destination) != target.resolve():  # numba caches by the same means
            return replace(source, destination)
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("os.replace", fail)
    status, _, err = run("sweep", "--orders", "1", "-o", target)
    assert status == 2
    assert "No space left" in err
    assert [path.name for path in tmp_path.iterdir()] == ["rows.json"]
    assert target.read_text() == "old"


@pytest.mark.parametrize("order", ["0", "401", "x"])
def test_an_order_of_roots_out_of_range(run, order: str) -> None:
    assert "order" in refused(run, "roots", f"--order={order}")


def test_roots_without_an_order(run) -> None:
    assert "--order" in refused(run, "roots")


@pytest.mark.parametrize(
    "arguments",
    [("fly",), ("solve", "--colour"), ("solve", "extra"), ("equations", "--format", "word")],
)
def test_an_unknown_command_or_flag(run, arguments) -> None:
    assert "--help" in refused(run, *arguments)


@pytest.mark.parametrize(
    ("arguments", "named"),
    [
        (("--format", "latex", "-o", "{}/a.html"), "a.html with --format latex"),
        (("--format", "text", "-o", "{}/a.PDF"), "expected .txt"),
        (("-o", "{}/a.docx"), "expected a name that ends in one of .txt, .tex, .html, .pdf"),
        (("--format", "pdf"), "expected -o FILE.pdf"),
        (("--fragment",), "--fragment: got format text, expected latex"),
        (("--fragment", "-o", "{}/a.html"), "--fragment: got format html"),
    ],
)
def test_equations_in_a_format_or_an_order_that_is_not_there(
    run, tmp_path: Path, arguments: tuple[str, ...], named: str
) -> None:
    assert named in refused(run, "equations", *(a.format(tmp_path) for a in arguments))
    assert list(tmp_path.iterdir()) == []


FIGURES = "9" * 5000


@pytest.mark.parametrize(
    "arguments",
    [
        ("--orders", FIGURES),
        ("--orders", f"1-{FIGURES}"),
        ("--orders", f"1,2,...,{FIGURES}"),
        ("--vary", f"mass=1:2:{FIGURES}"),
        ("--vary", "mass=1:2:3", "--orders", FIGURES),
    ],
    ids=lambda arguments: arguments[-2],
)
def test_whole_numbers_of_any_length(run, arguments) -> None:
    error = refused(run, "sweep", *arguments)
    assert f"{arguments[-2]}: got " in error
    assert "expected" in error


@pytest.mark.parametrize(
    "content", [f"mass = {FIGURES}", "x = " + "[" * 100_000], ids=["figures", "depth"]
)
def test_a_case_file_beyond_what_python_reads(run, content: str, tmp_path: Path) -> None:
    case = tmp_path / "belt.toml"
    case.write_text(f"[stick_slip]\n{content}\n")
    assert f"--case: {case} is not TOML: " in refused(run, "solve", "--case", case)


def test_a_case_file_with_the_mark_of_an_editor(run, tmp_path: Path) -> None:
    case = tmp_path / "belt.toml"
    lines = "".join(f"{name} = {value}\n" for name, value in GOOD.items())
    case.write_text("[stick_slip]\n" + lines, encoding="utf-8-sig")
    assert run("solve", "--method", "c1", "--order", 5, "--case", case)[0] == 0
