"""Kernels are compiled once they have cost about as much as that takes, and not before."""

import itertools
import time
from pathlib import Path
from types import SimpleNamespace

import pytest

import nonsmooth as ns
from nonsmooth.solver.kernels import account as accounts
from nonsmooth.solver.kernels import polynomials, registry
from nonsmooth.solver.kernels.account import COMPILE, LOAD, PLAIN_ORDER, START, Account
from nonsmooth.solver.kernels.compiling import Entries
from nonsmooth.solver.kernels.family import Family
from nonsmooth.solver.kernels.kernel import for_others


@pytest.fixture
def account(tmp_path: Path, monkeypatch) -> Account:
    """Return an account of nothing, of a kernel that is not cached; numba is not loaded."""
    monkeypatch.setattr(Account, "total", 0.0)
    monkeypatch.delenv("NUMBA_CACHE_DIR", raising=False)
    monkeypatch.setattr(accounts, "sys", SimpleNamespace(modules={}))
    return Account(str(tmp_path / "driver.py"), "iterate_0123")


def cached(account: Account, tmp_path: Path) -> None:
    (tmp_path / "__pycache__").mkdir()
    (tmp_path / "__pycache__" / "driver.iterate_0123-7.py311.1.nbc").touch()


def spend(account: Account, seconds: float, others: float = 0.0) -> None:
    account.seconds, Account.total = seconds, seconds + others


def test_a_kernel_that_is_not_cached_is_compiled_for_what_that_costs(account) -> None:
    for seconds, expected in ((0.0, False), (0.9 * COMPILE, False), (1.1 * COMPILE, True)):
        spend(account, seconds, others=100.0)
        assert account.pays() is expected


def test_what_earlier_processes_have_taken_counts(account, tmp_path: Path, monkeypatch) -> None:
    later = [Account(str(tmp_path / "driver.py"), "iterate_0123") for _ in range(3)]
    clock = itertools.count(step=0.3 * COMPILE)
    monkeypatch.setattr(time, "thread_time", lambda: next(clock))
    for before, process in enumerate([account, *later]):
        with process.spending():
            pass
        assert process.pays() is (before == 3)
    for name in ("iterate_0123", "iterate_4567"):  # what was compiled may not be kept
        other = Account(str(tmp_path / "driver.py"), name)
        with other.spending():
            pass
        assert not other.pays()


@pytest.mark.parametrize("content", [None, "", "much", "nan"])
def test_what_was_kept_may_be_gone_or_damaged(account, tmp_path: Path, content) -> None:
    if content is not None:
        (tmp_path / "__pycache__").mkdir()
        (tmp_path / "__pycache__" / "driver.iterate_0123.spent").write_text(content)
    for seconds, expected in ((0.9 * COMPILE, False), (1.1 * COMPILE, True)):
        spend(account, seconds)
        assert account.pays() is expected


def test_nothing_is_kept_where_nothing_can_be_written(account, tmp_path: Path) -> None:
    (tmp_path / "__pycache__").touch()  # no folder
    spend(account, 0.9 * COMPILE)
    with account.spending():
        pass
    assert not account.pays()
    assert (tmp_path / "__pycache__").is_file()


def test_a_cached_kernel_is_loaded_when_all_have_cost_as_much_as_numba(
    account, tmp_path: Path
) -> None:
    cached(account, tmp_path)
    spend(account, 2 * LOAD)
    assert not account.pays()
    spend(account, 2 * LOAD, others=START)
    assert account.pays()
    spend(account, LOAD / 2, others=START)
    assert not account.pays()


def test_with_numba_there_a_cached_kernel_needs_little(
    account, tmp_path: Path, monkeypatch
) -> None:
    cached(account, tmp_path)
    monkeypatch.setattr(accounts, "sys", SimpleNamespace(modules={"numba": None}))
    spend(account, 2 * LOAD)
    assert account.pays()


def test_what_another_process_has_compiled_is_found(account, tmp_path: Path) -> None:
    spend(account, 2 * LOAD, others=START)
    assert not account.pays()
    cached(account, tmp_path)
    assert not account.pays()  # looking takes time
    spend(account, 5 * LOAD, others=START)
    assert account.pays()


def test_what_is_compiled_stays_so(account) -> None:
    account.is_compiled = True
    assert account.pays()


def test_the_cache_may_be_elsewhere(account, tmp_path: Path, monkeypatch) -> None:
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path / "elsewhere"))
    (tmp_path / "elsewhere" / "solver_1").mkdir(parents=True)
    (tmp_path / "elsewhere" / "solver_1" / "driver.iterate_0123-7.py311.1.nbc").touch()
    assert account.is_cached()
    assert not Account(str(tmp_path / "driver.py"), "iterate_4567").is_cached()


def test_what_is_spent_is_counted_also_where_it_failed(account, monkeypatch) -> None:
    def failing() -> None:
        with account.spending():
            raise ZeroDivisionError

    clock = iter((3.0, 3.25))
    monkeypatch.setattr(time, "thread_time", lambda: next(clock))
    with pytest.raises(ZeroDivisionError):
        failing()
    assert account.seconds == 0.25
    assert Account.total == account.seconds


def test_a_scene_is_counted_and_switches(monkeypatch) -> None:
    case = ns.scene("impact")()
    of_scene = polynomials.FAMILY.account("ck-tau")
    used = []

    def compiled(family, name):
        used.extend([1] if family is polynomials.FAMILY else [])
        return family.plain(name)

    monkeypatch.setattr(of_scene, "is_compiled", False)
    monkeypatch.setattr(of_scene, "seconds", 0.0)
    Family.kernel.cache_clear()  # an earlier test may have compiled it
    first = ns.solve(case, order=7)
    assert of_scene.seconds > 0
    monkeypatch.setattr(of_scene, "pays", lambda: True)
    monkeypatch.setattr(Family, "compiled", compiled)
    Family.kernel.cache_clear()
    assert ns.solve(case, order=7) == first
    assert used
    for order in (7, 60):  # a high order takes what is cached, and compiles nothing
        used.clear()
        Family.kernel.cache_clear()
        monkeypatch.setattr(of_scene, "pays", lambda: False)
        for is_cached in (False, True):
            monkeypatch.setattr(of_scene, "is_cached", lambda found=is_cached: found)
            registry.quicker_kernel(case.scene, "ck-tau", None, order)
        assert len(used) == (order > PLAIN_ORDER)
    Family.kernel.cache_clear()


def test_a_function_that_is_called_now_and_then_is_not_compiled(monkeypatch) -> None:
    family = Family(lambda module, make: {"double": double, "fourfold": fourfold}, ())
    compiled = []

    def entries(self, name):
        compiled.append(name)
        return dict.fromkeys(("double", "fourfold"), lambda x: "compiled")

    monkeypatch.setattr(Family, "compiled", entries)
    monkeypatch.setattr(Account, "total", 2 * COMPILE)
    monkeypatch.setattr(family.account_of(__name__, "double"), "seconds", 2 * COMPILE)
    assert family.call(__name__, "fourfold", 3.0) == 12.0
    assert not compiled
    assert family.call(__name__, "double", 3.0) == "compiled"
    assert family.account_of(__name__, "double").is_compiled
    assert not family.account_of(__name__, "fourfold").is_compiled


def test_what_may_take_long_is_taken_from_the_cache_at_once(
    account, monkeypatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(Family, "account_of", lambda *_: account)
    monkeypatch.setattr(Family, "compiled", lambda *_: {"double": lambda x: "compiled"})
    short, long = (
        Family(lambda module, make: {"double": double}, (), long_calls=long_calls)
        for long_calls in (False, True)
    )
    assert long.call(__name__, "double", 3.0) == 6.0
    account.seconds = 0.0
    cached(account, tmp_path)
    monkeypatch.setattr(account, "_looked", -1.0)
    assert short.call(__name__, "double", 3.0) == 6.0
    assert long.call(__name__, "double", 3.0) == "compiled"


def double(x):
    return 2 * x


def fourfold(x):
    return double(double(x))


def test_what_others_call_has_no_machine_code_until_python_calls_it() -> None:
    names: dict[str, object] = {"TWO": 2}
    for function in (double, fourfold):
        names[function.__name__] = for_others("0123")(function, names, True)
    entries = Entries(names)
    assert (entries["fourfold"](3.0), entries["TWO"]) == (12.0, 2)
    with pytest.raises(KeyError):
        names["double"](3.0)
    assert entries["double"](3.0) == 6.0


def test_ctrl_c_within_a_call_is_ctrl_c(monkeypatch) -> None:
    """Python then calls it an error that a result is returned with an exception set."""

    def interrupted() -> None:
        cause = KeyboardInterrupt()
        raise SystemError("returned a result with an exception set") from cause

    family = Family(lambda module, make: {"double": double}, ())
    monkeypatch.setattr(Family, "compiled", lambda *_: {"double": interrupted})
    monkeypatch.setattr(Account, "pays", lambda _: True)
    with pytest.raises(KeyboardInterrupt):
        family.call(__name__, "double")
