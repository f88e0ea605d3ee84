"""The package `generated`: written reproducibly and atomically, and called like NumPy's own functions."""

import hashlib
import os
import re
import shutil
from collections.abc import Callable, Iterator, Mapping
from functools import cache
from inspect import signature
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import generated
from derive.__main__ import derive_all, main
from derive.generate import write
from generated import kernels, motion

Function = Callable[..., Any]

FOLDER = Path(generated.__file__).parent
FUNCTIONS = {f"{m.__name__.partition('.')[2]}.{n}": getattr(m, n) for m in (kernels, motion) for n in m.__all__}
each_function = pytest.mark.parametrize("name", list(FUNCTIONS))
# A point inside every domain, by argument, and its float32 and integer.
INSIDE = {"alpha": 1.0, "theta_1": 4.0, "theta_2": 5.0, "a": -1.0, "t": 0.5}
WHOLE = {"theta_1": 4, "theta_2": 5, "alpha": 1, "a": -1, "t": 0}


@cache
def texts() -> dict[str, str]:
    """The package as it is."""
    return write.present(FOLDER)


def names(function: Function) -> list[str]:
    """A function's positional arguments."""
    return [n for n, p in signature(function).parameters.items() if p.kind is p.POSITIONAL_ONLY]


def inside(function: Function, values: Mapping[str, float] = INSIDE) -> list[float]:
    """Arguments inside the domain."""
    return [values.get(n, values["alpha"]) for n in names(function)]


# --- the text ------------------------------------------------------------------------------------------------------


def check_up_to_date(folder: Path, wanted: dict[str, str]) -> None:
    """Contents and set of files are those that are wanted."""
    diff = write.difference(wanted, folder)
    assert not diff, f"{diff}generated/ is stale: run `{write.MEND}`"


@pytest.fixture
def copy(tmp_path: Path) -> Path:
    """The package elsewhere."""
    write.write(texts(), tmp_path / "generated")
    return tmp_path / "generated"


def test_generated_is_up_to_date() -> None:
    """It is what is derived now, in whichever order this process iterates over sets: another in each run."""
    check_up_to_date(FOLDER, derive_all())


def test_headers() -> None:
    """Every source names its writer, and the digest of the text below its header is that text's."""
    for name, text in texts().items():
        if name.endswith((".py", ".c")):
            first, second, rest = text.split("\n", 2)
            assert "`python -m derive`" in first, f"{name} does not name its writer"
            assert "do not edit" in first
            digest = hashlib.sha256(rest.encode()).hexdigest()
            assert second.rstrip('"').endswith(digest), f"{name} was edited by hand: its digest is not its text's"


def bytes_of(folder: Path) -> dict[str, bytes]:
    return {str(p.relative_to(folder)): p.read_bytes() for p in sorted(folder.rglob("*")) if p.is_file()}


@pytest.mark.parametrize("fault", ["contents", "missing", "extra", "empty extra", "folder"])
def test_check_finds_it_stale(
    copy: Path, fault: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """A diff, the command that mends it, exit code 1, and nothing written."""
    match fault:
        case "contents":
            path = copy / "kernels.py"
            path.write_text(path.read_text("utf-8").replace("1.5707963267948966", "1.5707963267948968", 1), "utf-8")
            shown = ["--- generated/kernels.py", "+++ derived/kernels.py", "1.5707963267948968", "1.5707963267948966"]
        case "missing":
            (copy / "motion.py").unlink()
            shown = ["--- /dev/null", "+++ derived/motion.py"]
        case "extra":
            (copy / "late.py").write_text("x = 1\n", "utf-8")
            shown = ["--- generated/late.py", "+++ /dev/null", "-x = 1"]
        case "empty extra":
            (copy / "late.py").touch()
            shown = ["generated/late.py"]
        case "folder":
            shutil.rmtree(copy)
            shown = ["+++ derived/kernels.py", "+++ derived/motion.py"]
    before = bytes_of(copy) if copy.exists() else {}
    assert run_main(["--check"], copy, monkeypatch) == 1
    said = capsys.readouterr().out
    assert all(x in said for x in shown), said
    assert said.rstrip().endswith("generated/ is stale: run `python -m derive`")
    assert (bytes_of(copy) if copy.exists() else {}) == before
    assert run_main([], copy, monkeypatch) == 0
    assert run_main(["--check"], copy, monkeypatch) == 0
    assert "up to date" in capsys.readouterr().out


def run_main(argv: list[str], folder: Path, monkeypatch: pytest.MonkeyPatch) -> int:
    """The command, on another folder and with what was derived already."""
    difference, write_files = write.difference, write.write
    with monkeypatch.context() as m:
        m.setattr("derive.__main__.derive_all", lambda *_: texts())
        m.setattr(write, "difference", lambda texts, other=folder: difference(texts, other))
        m.setattr(write, "write", lambda texts, other=folder: write_files(texts, other))
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


@pytest.mark.parametrize("step", ["fdopen", "replace"])
def test_a_write_that_fails_leaves_whole_files(copy: Path, step: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Every file is the old one or the new one, and nothing else is left behind."""
    wanted = {name: text + "# later\n" for name, text in texts().items()}
    before, calls, real = bytes_of(copy), iter(range(99)), getattr(os, step)

    def fails(*args: Any, **options: Any) -> Any:
        if next(calls) == 2:
            raise OSError("disk full")
        return real(*args, **options)

    with monkeypatch.context() as m:
        m.setattr(os, step, fails)
        with pytest.raises(OSError, match="disk full"):
            write.write(wanted, copy)
    after = bytes_of(copy)
    assert set(after) == set(before)
    new = {name for name in after if after[name] != before[name]}
    assert len(new) == 2
    assert all(after[name] == wanted[name].encode() for name in new)


# --- the functions -------------------------------------------------------------------------------------------------


@each_function
def test_docstring(name: str) -> None:
    """Formula, equation, domain, shapes, error bound, source and cost, in every one."""
    function = FUNCTIONS[name]
    text = function.__doc__ or ""
    for part in ("Parameters\n", "Returns\n", "Domain: ", "Accuracy: ", "Source: eq. (", "Operations: ", "shape"):
        assert part in text, f"{part!r} is missing"
    assert re.search(r"Accuracy: .*ulp", text)
    assert " = " in text.partition("Parameters")[0], "the formula is missing"
    assert all(f"\n    {n} : array_like\n" in text for n in names(function))
    assert max(map(len, text.splitlines())) <= 120


@each_function
def test_scalars(name: str) -> None:
    """Scalars in, scalar out, of the arguments' type; integers and lists are accepted."""
    function = FUNCTIONS[name]
    args = inside(function)
    value = function(*args)
    assert type(value) is np.float64
    assert np.isfinite(value)
    assert type(function(*map(np.float32, args))) is np.float32
    assert type(function(*map(np.float16, args))) is np.float16
    assert type(function(*map(np.array, args))) is np.float64
    whole = inside(function, WHOLE)
    assert type(function(*map(int, whole))) is np.float64
    np.testing.assert_array_equal(function(*([x] for x in whole)), [function(*map(float, whole))])
    np.testing.assert_array_equal(function(*(np.array([x, x]) for x in whole)), [function(*map(float, whole))] * 2)


@each_function
def test_float32(name: str) -> None:
    """float32 stays float32, also beside Python's numbers; the float64 result, rounded (kernels: within 1 ulp)."""
    function = FUNCTIONS[name]
    args = inside(function)
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
    """Every argument broadcasts, also one that the result does not depend on; empty arrays too; no input is aliased."""
    function = FUNCTIONS[name]
    args = inside(function)
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
    """As NumPy's ufuncs take them: `out` is returned, lanes not asked for keep what it holds and raise nothing."""
    function = FUNCTIONS[name]
    arrays = [np.full(3, x) for x in inside(function)]
    expected = function(*arrays)
    out = np.full(3, 7.0)
    assert function(*arrays, out=out) is out
    assert function(*arrays, out) is out
    np.testing.assert_array_equal(out, expected)
    arrays[0][1] = np.nan
    lanes = [True, False, True]
    out = np.full(3, 7.0)
    with np.errstate(all="raise"):
        function(*arrays, out=out, where=lanes)
        without = function(*arrays, where=lanes)
    np.testing.assert_array_equal(out, [expected[0], 7.0, expected[2]])
    np.testing.assert_array_equal(np.isnan(without), [False, True, False])
    spread = function(*inside(function), where=np.ones((2, 1), dtype=bool))
    assert spread.shape == (2, 1)
    single = np.zeros(3, dtype=np.float32)
    with pytest.raises(TypeError):
        function(*arrays, out=np.zeros(3, dtype=np.int64), where=lanes)
    assert function(*arrays, out=single, where=lanes) is single


@each_function
def test_types_that_are_refused(name: str) -> None:
    """Complex numbers, extended precision, text, dates and objects: a TypeError, never a guess."""
    function = FUNCTIONS[name]
    args = inside(function)
    for bad in (1j, np.complex64(1), np.longdouble(1), "1", ["a"], None, np.datetime64("2024-01-01"), object()):
        for i in range(len(args)):
            with pytest.raises(TypeError):
                function(*[*args[:i], bad, *args[i + 1 :]])


def outside(name: str) -> Iterator[tuple[float, ...]]:
    """Arguments outside the domain of one function."""
    args, of = inside(FUNCTIONS[name]), names(FUNCTIONS[name])
    for i, x in enumerate(of):
        bad = [np.nan, np.inf, -np.inf]
        if x == "alpha":
            bad += [-5e-324, -1e-300, -1.0, float(np.pi / 2 * (1 + 1e-14)), 1.6, np.pi, 1e308]
        elif x in ("t", "mu"):
            bad += [-5e-324, -1.0]
        elif x == "theta_2":
            bad += [args[0] - 1e-15, args[0] - 1.0, args[0] + 3.1416, 1e308]
        elif "arrest" in name:
            bad += [0.0, 1.0] if x == "a" else [-1.0]
        yield from ((*args[:i], v, *args[i + 1 :]) for v in bad)


@each_function
def test_domain(name: str) -> None:
    """Outside the domain NaN and the `invalid` flag, scalar or array, float32 too; the lanes inside are untouched."""
    function = FUNCTIONS[name]
    args = inside(function)
    for bad in outside(name):
        with np.errstate(all="raise", invalid="ignore"):
            value = function(*bad)
        assert np.isnan(value), f"{name}{bad} is {value}"
        with np.errstate(invalid="raise"), pytest.raises(FloatingPointError, match="invalid"):
            function(*bad)
        with pytest.warns(RuntimeWarning, match="invalid"):
            mixed = function(*(np.array(x) for x in zip(args, bad, args, strict=True)))
        np.testing.assert_array_equal(mixed, [function(*args), np.nan, function(*args)])
        if max(abs(x) for x in bad) < 1e30 and min(abs(x) for x in bad if x) > 1e-30:
            with np.errstate(invalid="ignore"):
                small = function(*map(np.float32, bad))
            assert small.dtype == np.float32
            assert np.isnan(small) or "alpha" in names(function) or "theta_2" in names(function)


def test_promised_imports() -> None:
    assert set(generated.__all__) == set(kernels.__all__)
    assert generated.polar_moment is kernels.polar_moment
