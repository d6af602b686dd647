"""Kernels as text: only what is used, names that are nobody's, the same text every time."""

import ast
import hashlib
import math
import os
import re
import subprocess
import sys
import types
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import sympy as sp
from every_run import tried
from galerkin.derived import OF_ANY_SCENE, REFERENCES, conditions, module, pairs, source
from galerkin.oscillators import SCENES, case_of

from nonsmooth.codegen.emission.kernel import RUNTIME, module_source
from nonsmooth.codegen.emission.orthogonal import with_known
from nonsmooth.codegen.emission.terms import terms
from nonsmooth.codegen.emission.used import with_used
from nonsmooth.codegen.galerkin import Block, Condition
from nonsmooth.codegen.galerkin.condition import N
from nonsmooth.codegen.galerkin.tables import Table, by_time
from nonsmooth.codegen.galerkin.weights import weights
from nonsmooth.codegen.python_text import floating, math_names, python
from nonsmooth.codegen.scene.names import reserved


def of_a_scene(names):
    """Return oscillators and kernels, of which each scene has its own."""
    return [pair for pair in pairs(names) if pair[1] not in OF_ANY_SCENE]


PAIRS = tried(
    of_a_scene(("S1", "S2b", "S3b", "S5a")), every_run=set(of_a_scene(("S1", "S3b")))
)

p, q, s = sp.symbols("p q s")
d, table = sp.IndexedBase("d"), sp.IndexedBase("C")
n = sp.Symbol("n", integer=True, positive=True)


def assigned(function):
    """Return the names that a function assigns, but for its arguments."""
    names = [node for node in ast.walk(function) if isinstance(node, ast.Name)]
    return {node.id for node in names if isinstance(node.ctx, ast.Store)}


def used(tree):
    names = [node for node in ast.walk(tree) if isinstance(node, ast.Name)]
    return {node.id for node in names if isinstance(node.ctx, ast.Load)}


@pytest.mark.parametrize(("name", "kernel"), PAIRS)
def test_a_kernel_has_nothing_that_it_does_not_use(name, kernel):
    tree = ast.parse(source(name, kernel))
    parameters = {"cycles", *(symbol.name for symbol in SCENES[name][0].symbols)}
    names = used(tree)
    for node in tree.body:
        if isinstance(node, ast.Import | ast.ImportFrom):
            assert {alias.asname or alias.name for alias in node.names} <= names
        if isinstance(node, ast.FunctionDef):
            unused = assigned(node) - used(node) - parameters
            assert unused <= {"_"}, f"{node.name}: {unused}"
    offered = {"size", "residual", "jacobian", "motion", "coefficients"}
    functions = {node.name for node in tree.body if isinstance(node, ast.FunctionDef)}
    calls = [node.func for node in ast.walk(tree) if isinstance(node, ast.Call)]
    called = {function.id for function in calls if isinstance(function, ast.Name)}
    assert functions - called == offered


@pytest.mark.parametrize(("name", "kernel"), PAIRS)
def test_no_parameter_may_have_a_name_that_a_kernel_uses(name, kernel):
    scene = SCENES[name][0]
    parameters, phases = {q.name for q in scene.symbols}, [q.name for q in scene.phases]
    tree = ast.parse(source(name, kernel))
    runtime = {"break_series", *(function.__name__ for function in RUNTIME)}
    theirs: set[str] = set()
    for node in tree.body:
        if not isinstance(node, ast.FunctionDef) or node.name in runtime:
            continue
        own = assigned(node) | {argument.arg for argument in node.args.args}
        if own & parameters:  # parameters and its own names meet in this function
            theirs |= (own | used(node) | {node.name}) - parameters
    assert {"N", "z", "R", "row", "residual"} <= theirs
    missing = {word for word in theirs - {"_"} if not reserved(word, phases)}
    assert not missing
    assert not any(reserved(word, phases) for word in parameters)


@pytest.mark.parametrize(("name", "kernel"), PAIRS)
def test_what_a_kernel_says_of_itself(name, kernel):
    made, scene = module(name, kernel), SCENES[name][0]
    text = source(name, kernel)
    body = text.partition("of the text below\n\n\n")[2]
    assert hashlib.sha256(body.encode()).hexdigest() == made.BODY
    assert scene.name == made.SCENE
    assert kernel.partition("_")[0] in made.METHOD
    assert len(scene.phases) == made.DURATIONS
    assert (scene.frequency is not None) == made.FORCED
    for order in (made.LOWEST, 7):
        z = np.arange(float(made.size(order)))
        found = made.coefficients(z)
        count = sum(np.size(value) for value, _ in found.values())
        assert count + made.DURATIONS + made.FORCED == made.size(order)
        assert [b.name for b in conditions(name, kernel).blocks] == list(found)
        assert {power for _, power in found.values()} <= {0, 1, 2}


@pytest.mark.parametrize("kernel", ["hb", "hb_ck_1"])
def test_the_order_of_a_series_is_its_highest_harmonic(kernel):
    """Half a period has odd harmonics alone: orders 5 and 6 have three."""
    half, whole = module("S6", kernel), module("S1", kernel)
    sizes = [half.size(order) for order in range(1, 8)]
    assert np.diff(sizes).tolist() == [0, 2, 0, 2, 0, 2]
    assert np.diff([whole.size(order) for order in range(1, 8)]).tolist() == [2] * 6
    z = np.zeros(half.size(5))
    sines = half.coefficients(z)["a"][0]
    assert len(sines) == 3
    sines[2], z[-2], u = 1.0, 1.0, np.linspace(0, 1, 5)
    got = half.motion(case_of("S6"), z, 0, u, 0)
    np.testing.assert_allclose(got, np.sin(5 * np.pi * u), atol=1e-14)


@pytest.mark.parametrize("name", ["S1", "S3b"])
def test_a_residual_forms_no_derivatives_of_its_tables(name):
    text = source(name, "hb")
    residual, jacobian = text.partition("def residual(")[2].split("def jacobian(")
    assert ("rates = False" in residual, "rates = True" in residual) == (True, False)
    assert "rates = True" in jacobian
    assert not re.search(r"^ +[CS]_\w+_by_", residual, flags=re.MULTILINE)


def test_a_known_entry_stands_in_its_place():
    whole = Table(table, lambda indices, time: sp.S.Zero, "", known=lambda index: None)
    j = sp.Symbol("j", integer=True, positive=True)

    def known(index):
        return p * sp.KroneckerDelta(j, n) if index == j - n else sp.S.Zero

    tables = (replace(whole, known=known),)
    sum_ = sp.Sum((q * table[j - n] + table[j + n] + s) * d[n], (n, 1, N))
    found = with_known(Condition("row", "", sum_ + table[j], index=j), tables)
    assert found.expression == p * q * d[j] + sp.Sum(s * d[n], (n, 1, N))
    row = Condition("row", "", sum_ + table[j], index=j)
    assert with_known(row, (whole,)) is row
    with pytest.raises(ValueError, match="more than one term"):
        with_known(replace(row, index=None), tables)


def test_a_parameter_may_not_be_called_like_a_function_of_a_kernel():
    system = conditions("S1", "ck_tau")
    (first, *others) = system.conditions
    twice = replace(system, conditions=(first, replace(first, name="m"), *others))
    with pytest.raises(ValueError, match="impact: m is there twice in ck-tau"):
        module_source(twice)


def test_there_are_as_many_conditions_as_unknowns():
    system = conditions("S1", "ck_tau")
    with pytest.raises(ValueError, match=r"ck-tau: N \+ 3 conditions for N \+ 4 unknowns"):
        replace(system, conditions=system.conditions[:-1]).check_count()


@pytest.mark.long
def test_the_text_is_the_same_in_every_process():
    """Sets have another sequence where the seed of the hash is another."""
    script = (
        "from galerkin.derived import source\n"
        "for kernel in ('ck_tau', 'hb_ck_1'): print(source('S1', kernel))"
    )
    environment = os.environ | {"PYTHONHASHSEED": "4711"}
    done = subprocess.run(
        [sys.executable, "-c", script],
        cwd=Path(__file__).resolve().parents[1],
        env=environment,
        capture_output=True,
        text=True,
        check=True,
    )
    assert done.stdout == "".join(source("S1", k) + "\n" for k in ("ck_tau", "hb_ck_1"))


@pytest.mark.long  # what is committed is compared in every run, in tests/scenes
def test_plain_and_compiled_kernels_agree():
    """Products that are fused or not differ in the last bits, and nothing else does."""
    numba = pytest.importorskip("numba")
    made, case = module("S1", "ck_tau"), case_of("S1")
    namespace = dict(vars(made))
    for name, value in vars(made).items():
        plain = name in {"phase_motion", "motion", "coefficients", "size"}
        if isinstance(value, types.FunctionType) and not plain:
            namespace[name] = numba.njit(types.FunctionType(value.__code__, namespace))
    z = np.random.default_rng(3).uniform(0.5, 1, made.size(9))
    R, J = np.empty((2, len(z))), np.empty((2, len(z), len(z)))
    for i, functions in enumerate((vars(made), namespace)):
        functions["residual"](case, z, R[i])
        functions["jacobian"](case, z, J[i])
    np.testing.assert_allclose(R[0], R[1], rtol=0, atol=4e-16 * np.abs(R).max())
    np.testing.assert_allclose(J[0], J[1], rtol=0, atol=4e-16 * np.abs(J).max())


def test_expressions_keep_their_digits():
    assert python(p**2 / 3 + sp.sqrt(q) * sp.pi) == "(p*p)/3 + pi*sqrt(q)"
    assert python(sp.exp(1)) == "exp(1)"
    assert python(d[n - 1 + 0]) == "d[n - 1]"
    assert [floating(value) for value in (0, -2, p, sp.Rational(1, 2))] == [
        *("0.0", "-2.0", "p", "1/2")
    ]
    text = '"""Of cos(x) and pi."""\ndef sin(x):\n    return sqrt(x) + np.exp(x) + tan(2)\n'
    assert math_names(text) == ["sqrt", "tan"]
    assert all(hasattr(math, name) for name in math_names("pi*hypot(a, b)"))


def test_assignments_that_nothing_reads_are_left_out():
    lines = ["(k,) = case", "a = k", "b, c = f(a)", "unused = b"]
    assert with_used(lines, ["return c"]) == [*lines[:3], "return c"]
    assert with_used(lines, ["return k"]) == [lines[0], "return k"]
    assert with_used(lines, ["return abc"]) == ["return abc"]


def test_the_weights_of_symbols_in_a_linear_form():
    form = p * (2 * d[n] + q * (d[n - 1] + 1)) - d[n] / s
    found = weights(form, {d[n], d[n - 1], d[n + 1]})
    assert set(found) == {d[n], d[n - 1], sp.S.One}
    expected = {d[n]: 2 * p - 1 / s, d[n - 1]: p * q, sp.S.One: p * q}
    assert all(sp.expand(found[key] - value) == 0 for key, value in expected.items())
    for wrong in (p**2, p * q, sp.sin(p), s / p):
        with pytest.raises(ValueError, match="not linear"):
            weights(wrong + s, {p, q})


def test_a_condition_that_is_not_linear_is_refused():
    blocks = (Block(p, sp.S.One, 0, ""), Block(d, N, 0, "", first=1))
    for wrong in (
        p * d[n],
        sp.cos(p),
        sp.Sum(p * d[n], (n, 1, N)),
        sp.Sum(d[n], (n, 1, N)) ** 2,
    ):
        with pytest.raises(ValueError, match=r"row: .*not linear"):
            terms(Condition("row", "", wrong + q), blocks)


def test_the_derivative_by_a_time_goes_through_the_tables():
    """C[n] and C[p] are two entries, whatever n and p are."""

    def rate(indices, time):
        return 7 * d[indices] if time == s else sp.S.Zero

    tables = (Table(table, rate, ""),)
    expression = s**2 * table[n] - q * table[2] + s * q
    expected = 2 * s * table[n] + 7 * s**2 * d[n] - 7 * q * d[2] + q
    assert sp.expand(by_time(expression, s, tables) - expected) == 0
    assert by_time(expression, q, tables) == s - table[2]
    assert by_time(table[n] + table[2 * n], s, tables) == 7 * d[n] + 7 * d[2 * n]


def test_every_scene_of_the_references_is_there():
    assert set(REFERENCES) == set(SCENES) - {"S0"}  # that one: the paper, and frozen rows
