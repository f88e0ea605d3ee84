"""The package `generated`: written reproducibly and atomically, and called like NumPy's own functions."""

import doctest
import os
from collections.abc import Callable, Iterator, Mapping
from functools import cache
from inspect import signature
from pathlib import Path
from types import SimpleNamespace
from typing import Any, get_overloads

import numpy as np
import pytest

import generated
from derive import stages
from derive.__main__ import main
from derive.code import emit
from derive.generate import write
from generated import _compiled, kernels, printed, slopes
from tests.support.kernels import FITTED

Function = Callable[..., Any]

FOLDER = Path(generated.__file__).parent
FUNCTIONS: dict[str, Function] = {name: getattr(kernels, name) for name in kernels.__all__}
ARGUMENTS = {
    name: [x for x, p in signature(function).parameters.items() if p.default is p.empty]
    for name, function in FUNCTIONS.items()
}
for level in _compiled.LEVELS:  # kernels as every level of the processor computes them
    for name in kernels.TEXTS:
        of_level = _compiled.kernel(name, kernels.TEXTS[name], level, both_ends=name not in FITTED)
        FUNCTIONS[f"{name}, {level}"] = of_level
        ARGUMENTS[f"{name}, {level}"] = ARGUMENTS[name]
each_function = pytest.mark.parametrize("name", list(FUNCTIONS))
# A point inside every domain, by argument, and its float32 and integer.
INSIDE = {"alpha": 1.0, "theta_1": 4.0, "theta_2": 5.0}
WHOLE = {"theta_1": 4, "theta_2": 5, "alpha": 1}


@cache
def texts() -> dict[str, str]:
    """Return the package as it is."""
    return write.present_files(FOLDER)


def inside(name: str, values: Mapping[str, float] = INSIDE) -> list[float]:
    """Arguments inside the domain of a function."""
    return [values.get(n, values["alpha"]) for n in ARGUMENTS[name]]


def check_examples(module: Any) -> None:
    done = doctest.testmod(module)
    assert (done.failed, done.attempted) == (0, 2 * len(module.__all__))


@pytest.mark.parametrize("module", [printed, slopes])
def test_examples_of_bare_formulas(module: Any) -> None:
    check_examples(module)


def test_examples_of_the_docstrings() -> None:
    """They print what they say, in every function; its signature fits one line, and the stub has its types."""
    check_examples(kernels)
    stub: dict[str, Any] = {"__name__": "stub"}
    exec((FOLDER / "kernels.pyi").read_text("utf-8"), stub)
    for name in kernels.__all__:
        shown = signature(getattr(kernels, name))
        assert len(f"{name}{shown}") <= 88
        named: Any = SimpleNamespace(__module__="stub", __qualname__=name)
        overloads = get_overloads(named)
        assert len(overloads) == 2 + len(ARGUMENTS[name])
        for one in overloads:
            typed = signature(one).parameters
            assert [(p.name, p.kind, p.default) for p in typed.values()] == [
                (p.name, p.kind, p.default) for p in shown.parameters.values()
            ]
        assert typed[ARGUMENTS[name][0]].annotation == "ArrayLike"


# --- the text ------------------------------------------------------------------------------------------------------


def check_up_to_date(folder: Path, wanted: dict[str, str]) -> None:
    """Contents and set of files are those that are wanted."""
    diff = write.difference(wanted, folder)
    assert not diff, f"{diff}generated/ is stale: run `{write.MEND}`"


@pytest.fixture
def copy(tmp_path: Path) -> Path:
    """Return the package elsewhere."""
    write.write(texts(), tmp_path / "generated")
    return tmp_path / "generated"


def test_generated_is_up_to_date() -> None:
    """It is what is derived from sources that have changed since they were recorded."""
    assert main(["--check"]) == 0


def bytes_of(folder: Path) -> dict[str, bytes]:
    return {str(p.relative_to(folder)): p.read_bytes() for p in sorted(folder.rglob("*")) if p.is_file()}


def mistyped(folder: Path) -> None:
    path = folder / "kernels.py"
    path.write_text(path.read_text("utf-8").replace("1.5707963267948966", "1.5707963267948968", 1), "utf-8")


FAULTS: dict[str, tuple[Callable[[Path], object], list[str]]] = {
    "contents": (mistyped, ["--- generated/kernels.py", "+++ derived/kernels.py", "1.5707963267948968"]),
    "missing": (lambda folder: (folder / "printed.py").unlink(), ["--- /dev/null", "+++ derived/printed.py"]),
    "empty extra": (lambda folder: (folder / "late.py").touch(), ["generated/late.py"]),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_check_finds_it_stale(copy: Path, fault: str, monkeypatch: pytest.MonkeyPatch, capsys: Any) -> None:
    """A diff, the command that mends it, exit code 1, and nothing written."""
    spoil, shown = FAULTS[fault]
    spoil(copy)
    before = bytes_of(copy)
    assert run_main(["--check"], copy, monkeypatch) == 1
    printed = capsys.readouterr().out
    assert all(x in printed for x in shown), printed
    assert printed.rstrip().endswith("generated/ is stale: run `python -m derive`")
    assert bytes_of(copy) == before
    assert run_main([], copy, monkeypatch) == 0
    assert run_main(["--check"], copy, monkeypatch) == 0
    assert "up to date" in capsys.readouterr().out


def run_main(argv: list[str], folder: Path, monkeypatch: pytest.MonkeyPatch) -> int:
    """Return the command, on another folder and with what was derived already."""
    difference, write_files = write.difference, write.write
    with monkeypatch.context() as m:
        m.setattr("derive.__main__.derive_all", texts)
        m.setattr("derive.__main__.declare", lambda: None)
        m.setattr(stages, "save", lambda _: None)
        m.setattr(write, "difference", lambda texts, other=folder: difference(texts, other))
        m.setattr(write, "write", lambda texts, other=folder, **_: write_files(texts, other))
        return main(argv)


def test_binaries_and_caches_do_not_count(copy: Path) -> None:
    """Neither for the check, nor does a write remove them."""
    kept = [copy / "_kernels.cpython-311-x86_64-linux-gnu.so", copy / "__pycache__" / "kernels.cpython-311.pyc"]
    kept[1].parent.mkdir()
    for path in kept:
        path.write_bytes(b"\xff\x00")
    check_up_to_date(copy, texts())
    assert write.write(texts(), copy) == []
    assert all(path.exists() for path in kept)


@pytest.mark.parametrize(("module", "step", "replaced"), [(Path, "write_text", 0), (os, "replace", 2)])
def test_a_write_that_fails_leaves_whole_files(
    copy: Path, module: Any, step: str, replaced: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Files are either old or new, all of them old until the last is written, and nothing else is left."""
    wanted = {name: text + "# later\n" for name, text in texts().items()}
    before, calls, real = bytes_of(copy), iter(range(99)), getattr(module, step)

    def fails(*args: Any, **options: Any) -> Any:
        if next(calls) == 2:
            raise OSError("disk full")
        return real(*args, **options)

    with monkeypatch.context() as m:
        m.setattr(module, step, fails)
        with pytest.raises(OSError, match="disk full"):
            write.write(wanted, copy)
    after = bytes_of(copy)
    assert set(after) == set(before)
    new = {name for name in after if after[name] != before[name]}
    assert len(new) == replaced
    assert [*copy.parent.iterdir()] == [copy]
    assert all(after[name] == wanted[name].encode() for name in new)


# --- the functions -------------------------------------------------------------------------------------------------


@each_function
def test_scalars(name: str) -> None:
    """Scalars in, scalar out, of the arguments' type; integers and lists are accepted."""
    function = FUNCTIONS[name]
    args = inside(name)
    value = function(*args)
    assert type(value) is np.float64
    assert np.isfinite(value)
    assert type(function(*map(np.float32, args))) is np.float32
    assert type(function(*map(np.float16, args))) is np.float16
    assert type(function(*map(np.array, args))) is np.float64
    whole = inside(name, WHOLE)
    assert type(function(*map(int, whole))) is np.float64
    np.testing.assert_array_equal(function(*([x] for x in whole)), [function(*map(float, whole))])
    np.testing.assert_array_equal(function(*(np.array([x, x]) for x in whole)), [function(*map(float, whole))] * 2)


@each_function
def test_float32(name: str) -> None:
    """float32 stays float32, also beside Python's numbers; the float64 result, rounded (kernels: within 1 ulp)."""
    function = FUNCTIONS[name]
    args = inside(name)
    arrays = [np.array([x, x], dtype=np.float32) for x in args]
    value = function(*arrays)
    assert value.dtype == np.float32
    expected = np.full(2, function(*args), np.float32)
    np.testing.assert_array_max_ulp(value, expected, maxulp=1 if len(args) == 1 else 0)
    assert function(arrays[0], *args[1:]).dtype == np.float32
    if len(args) > 1:
        assert function(arrays[0], *(np.array([x]) for x in args[1:])).dtype == np.float64


@each_function
def test_broadcasting(name: str) -> None:
    """Arguments broadcast, also one without effect; empty arrays too; no input is aliased."""
    function = FUNCTIONS[name]
    args = inside(name)
    expected = function(*args)
    for i, x in enumerate(args):
        column = [*args[:i], np.full((3, 1), x), *args[i + 1 :]]
        assert function(*column).shape == (3, 1)
        assert np.all(function(*column) == expected)
        for j, y in enumerate(args):
            if i != j:
                both = [np.full((2,), y) if k == j else v for k, v in enumerate(column)]
                assert function(*both).shape == (3, 2)
        given = [*args[:i], np.full(3, x), *args[i + 1 :]]
        assert not np.shares_memory(function(*given), given[i])
        assert function(*[*args[:i], np.empty((0, 2)), *args[i + 1 :]]).shape == (0, 2)
    strided = [np.full(6, x)[::-2] for x in args]
    assert np.all(function(*strided) == expected)


@each_function
def test_out_and_where(name: str) -> None:
    """`out` is returned, and lanes left out by `where` keep their values and raise nothing, as in NumPy."""
    function = FUNCTIONS[name]
    arrays = [np.full(3, x) for x in inside(name)]
    expected = function(*arrays)
    out = np.full(3, 7.0)
    assert function(*arrays, out=out) is out
    assert function(*arrays, out) is out
    names = signature(function).parameters
    np.testing.assert_array_equal(function(**dict(zip(names, arrays, strict=False))), expected)
    for unlike in ({"dtype": float}, {"casting": "safe"}, {"out": (out,)}):  # ufuncs take these
        with pytest.raises(TypeError):
            function(*arrays, **unlike)
        assert next(iter(unlike)) in emit.ARRAYS.split("Unlike NumPy's ufuncs")[1]
    np.testing.assert_array_equal(out, expected)
    with pytest.raises(ValueError, match=r"shape|broadcast"):
        function(*arrays, out=np.zeros(2))
    arrays[0][1] = np.nan
    lanes = [True, False, True]
    out = np.full(3, 7.0)
    with np.errstate(all="raise"):
        function(*arrays, out=out, where=lanes)
        without = function(*arrays, where=lanes)
    np.testing.assert_array_equal(out, [expected[0], 7.0, expected[2]])
    np.testing.assert_array_equal(np.isnan(without), [False, True, False])
    spread = function(*inside(name), where=np.ones((2, 1), dtype=bool))
    assert spread.shape == (2, 1)
    single = np.zeros(3, dtype=np.float32)
    with pytest.raises(TypeError):
        function(*arrays, out=np.zeros(3, dtype=np.int64), where=lanes)
    assert function(*arrays, out=single, where=lanes) is single


@each_function
def test_types_that_are_refused(name: str) -> None:
    """Complex numbers, extended precision, text, dates and objects: a TypeError, never a guess."""
    function = FUNCTIONS[name]
    args = inside(name)
    for bad in (1j, np.complex64(1), np.longdouble(1), "1", ["a"], None, np.datetime64("2024-01-01"), object()):
        for i in range(len(args)):
            numeric = isinstance(bad, complex | np.number)  # NumPy itself refuses to join the others
            with pytest.raises(TypeError, match=rf"^{name.split(',')[0]}: arguments of type " if numeric else None):
                function(*[*args[:i], bad, *args[i + 1 :]])


# Numbers outside each argument's domain, beside those that are not finite.
OUTSIDE = {
    "alpha": [-5e-324, -1e-300, -1.0, float(np.pi / 2 * (1 + 1e-14)), 1.6, np.pi, 1e308],
    "theta_2": [INSIDE["theta_1"] + x for x in (-1e-15, -1.0, 3.1416, 1e308)],
}


def outside(name: str) -> Iterator[tuple[float, ...]]:
    """Arguments outside the domain of one function."""
    args = inside(name)
    for i, x in enumerate(ARGUMENTS[name]):
        bad = [np.inf, -np.inf, *OUTSIDE.get(x, [])]
        yield from ((*args[:i], v, *args[i + 1 :]) for v in bad)


@pytest.mark.parametrize("accuracy", ["fast", np.array([1e-6, 1e-10]), [1e-6], 1j])
def test_an_accuracy_that_is_no_number_is_named(accuracy: Any) -> None:
    with pytest.raises(TypeError, match="polar_moment: accuracy is one number, a relative error above 0, not "):
        generated.polar_moment(0.5, accuracy=accuracy)
    small: Any = np.float32(1e-6)
    assert generated.polar_moment(0.5, accuracy=small) == generated.polar_moment(0.5, accuracy=1e-6)


@each_function
def test_nan_is_nan_without_a_flag(name: str) -> None:
    """NaN gives NaN without a flag, beside valid arguments; beside arguments outside the domain the flag is set."""
    function = FUNCTIONS[name]
    args = inside(name)
    wrong = next(outside(name))
    for i in range(len(args)):
        lost = (*args[:i], np.nan, *args[i + 1 :])
        with np.errstate(all="raise"):
            assert np.isnan(function(*lost))
            assert np.isnan(function(*map(np.float32, lost)))
            mixed = function(*(np.array([x, y] * 40) for x, y in zip(args, lost, strict=True)))
        np.testing.assert_array_equal(mixed, [function(*args), np.nan] * 40)
        with np.errstate(invalid="raise"), pytest.raises(FloatingPointError, match="invalid"):
            function(*(np.array(x) for x in zip(lost, wrong, strict=True)))


@each_function
def test_domain(name: str) -> None:
    """Outside the domain NaN and the `invalid` flag, scalar or array, float32 too; the lanes inside are untouched."""
    function = FUNCTIONS[name]
    args = inside(name)
    for bad in outside(name):
        with np.errstate(all="raise", invalid="ignore"):
            value = function(*bad)
        assert np.isnan(value), f"{name}{bad} is {value}"
        said = f"invalid value encountered in {name.partition(',')[0]}$"
        with np.errstate(invalid="raise"), pytest.raises(FloatingPointError, match=said):
            function(*bad)
        with pytest.warns(RuntimeWarning, match=said):
            mixed = function(*(np.array(x) for x in zip(args, bad, args, strict=True)))
        np.testing.assert_array_equal(mixed, [function(*args), np.nan, function(*args)])
        if max(abs(x) for x in bad) < 1e30 and min(abs(x) for x in bad if x) > 1e-30:
            with np.errstate(invalid="ignore"):
                small = function(*map(np.float32, bad))
            assert small.dtype == np.float32
            assert np.isnan(small) or "alpha" in ARGUMENTS[name] or "theta_2" in ARGUMENTS[name]
