"""Arrays of other libraries stay what they are: dask lazy, xarray labelled, pint dimensionless, JAX traced.

Each test is skipped where its library is missing; `pip install '.[peers]'` brings them all.
"""

import pickle
import subprocess
import sys
from importlib.util import find_spec
from typing import Any, assert_type

import numpy as np
import pytest
from numpy.typing import NDArray

from generated import kernels
from tests.support.kernels import ALPHAS, ENDS, NAMES, arguments

each_kernel = pytest.mark.parametrize("name", NAMES)
each_of_ends = pytest.mark.parametrize("name", ENDS)
FIRST, LAST = arguments(ENDS[0])


def same(value: Any, name: str, *args: Any) -> None:
    np.testing.assert_array_equal(np.asarray(value), getattr(kernels, name)(*(args or arguments(name))))


@each_kernel
def test_dask(name: str) -> None:
    """Lazy until asked, the same numbers, the type of the chunks; it travels to other processes."""
    da = pytest.importorskip("dask.array")
    function = getattr(kernels, name)
    lazy = function(*(da.from_array(x, chunks=3) for x in arguments(name)))
    assert isinstance(lazy, da.Array)
    assert lazy.chunks == ((3, 3, 2),)
    single = function(*(da.from_array(x[:-1].astype(np.float32), chunks=3) for x in arguments(name)))
    assert single.dtype == single.compute(scheduler="synchronous").dtype == np.float32
    assert function(*(da.arange(2, chunks=1) for _ in arguments(name))).dtype == np.float64
    travelled = pickle.loads(pytest.importorskip("cloudpickle").dumps(lazy))
    same(travelled.compute(scheduler="synchronous"), name)


@each_kernel
def test_xarray(name: str) -> None:
    """Dimensions, coordinates and attributes stay; so does a lazy inside; a Dataset goes variable by variable."""
    xr, da = pytest.importorskip("xarray"), pytest.importorskip("dask.array")
    function = getattr(kernels, name)
    labelled = [xr.DataArray(x, dims="arc", coords={"arc": np.arange(x.size)}, name="a") for x in arguments(name)]
    value = function(*labelled)
    assert isinstance(value, xr.DataArray)
    assert value.dims == ("arc",)
    xr.testing.assert_equal(value.coords.to_dataset(), labelled[0].coords.to_dataset())
    same(value, name)
    assert isinstance(function(*(x.chunk({"arc": 3}) for x in labelled)).data, da.Array)
    same(function(*(xr.Dataset({"a": x}) for x in labelled)).a, name)


@each_of_ends
def test_dimensions_pair_by_name(name: str) -> None:
    """Dimensions of xarray broadcast by name, in either order; NumPy arrays and numbers beside them by position."""
    xr = pytest.importorskip("xarray")
    function, first, last = getattr(kernels, name), np.array([3.9, 4.0, 4.1]), np.array([4.9, 5.1, 5.0])
    one, two = xr.DataArray(first, dims="a"), xr.DataArray(last, dims="b")
    table = function(first[:, None], last)
    assert function(one, two).dims == ("a", "b")
    np.testing.assert_array_equal(function(one, two), table)
    turned = function(one.expand_dims(b=3, axis=0), two)
    assert turned.dims == ("b", "a")
    np.testing.assert_array_equal(turned, table.T)
    np.testing.assert_array_equal(function(4.0, two), table[1])
    np.testing.assert_array_equal(function(one, last), np.diag(table))


@each_kernel
def test_pandas(name: str) -> None:
    """A Series keeps its index and name; outside the domain NaN and NumPy's flag."""
    pd = pytest.importorskip("pandas")
    function = getattr(kernels, name)
    value = function(*(pd.Series(x, index=list("abcdefgh"), name="alpha") for x in arguments(name)))
    assert isinstance(value, pd.Series)
    assert (value.name, list(value.index)) == ("alpha", list("abcdefgh"))
    same(value, name)
    outside = [pd.Series([x[3], 1e9]) for x in arguments(name)]
    with pytest.warns(RuntimeWarning, match="invalid"):
        assert function(*outside).isna().tolist() == [False, True]


@each_of_ends
def test_indexes_are_aligned(name: str) -> None:
    """Series pair by their labels, whatever their order; a frame beside a series is refused in one line."""
    pd = pytest.importorskip("pandas")
    function = getattr(kernels, name)
    one, two = pd.Series(FIRST, index=list("abcdefgh")), pd.Series(LAST, index=list("abcdefgh"))
    value = function(one, two[::-1])
    same(value.sort_index(), name)
    with pytest.raises(TypeError, match=rf"^{name}: pandas does not support arguments of type DataFrame and Series"):
        function(pd.DataFrame({"a": one}), two)


@each_kernel
def test_pint(name: str) -> None:
    """Dimensionless in, dimensionless out; degrees are radians, in every argument; a length is an error."""
    pint = pytest.importorskip("pint")
    units, function, args = pint.get_application_registry(), getattr(kernels, name), arguments(name)
    for unit in ("dimensionless", "radian"):
        value = function(*(units.Quantity(x, unit) for x in args))
        assert isinstance(value, units.Quantity)
        assert value.dimensionless
        same(value.magnitude, name)
    expected = function(*(np.deg2rad(x) for x in (30.0, 90.0)[: len(args)]))
    degrees = [units.Quantity(x, "degree") for x in (30.0, 90.0)[: len(args)]]
    for given in (degrees, [*degrees[:-1], np.deg2rad((30.0, 90.0)[len(args) - 1])]):
        assert np.asarray(function(*given)) == pytest.approx(expected, rel=1e-13)
    for k in range(len(args)):
        wrong = [1.0 if i != k else units.Quantity(1.0, "m") for i in range(len(args))]
        with pytest.raises(pint.DimensionalityError):
            function(*wrong)


def test_libraries_within_one_another() -> None:
    """Labels around units around lazy arrays: each keeps its part."""
    xr, da, pint = (pytest.importorskip(x) for x in ("xarray", "dask.array", "pint"))
    units = pint.get_application_registry()
    lazy = units.Quantity(da.from_array(FIRST, chunks=3), "radian")
    for value in (
        kernels.limit_friction(xr.DataArray(lazy, dims="arc"), LAST),
        kernels.limit_friction(FIRST, xr.DataArray(units.Quantity(da.from_array(LAST, chunks=3), ""), dims="arc")),
        kernels.limit_friction(lazy, xr.DataArray(LAST, dims="arc")),
    ):
        assert isinstance(value, xr.DataArray)
        assert isinstance(value.data.magnitude, da.Array)
        same(value.data.magnitude.compute(scheduler="synchronous"), "limit_friction", FIRST, LAST)


@each_kernel
def test_types_that_would_lose_something(name: str) -> None:
    """Masks, units within lists, and other subclasses of arrays: refused in one line, in each argument."""
    pint = pytest.importorskip("pint")
    function, args = getattr(kernels, name), [float(x[3]) for x in arguments(name)]
    angle = pint.get_application_registry().Quantity(30.0, "degree")
    masked = "masked arrays are not supported"
    other = r"arguments of type \S+ are not supported"
    for bad, said in (
        (np.ma.masked, masked),
        (np.ma.array([1.0], mask=[True]), masked),
        ([1.0, np.ma.masked], masked),
        ([[1.0, angle]], other),
        (np.zeros(1).view(np.recarray), other),
        (memoryview(b"12"), other),
        (b"12", other),
    ):
        for k in range(len(args)):
            with pytest.raises(TypeError, match=rf"^{name}: {said}"):
                function(*[*args[:k], bad, *args[k + 1 :]])
    with pytest.raises(OverflowError, match=rf"^{name}: an integer of 1329 bits"):
        function(*[*args[1:], 10**400])


def test_what_another_library_cannot_ask_for() -> None:
    """`out` and `where` are NumPy's."""
    da = pytest.importorskip("dask.array")
    lazy, anything = da.from_array(ALPHAS, chunks=3), pytest.raises(TypeError, match="`out` and `where`")
    calls: list[tuple[Any, Any]] = [(lazy, np.zeros(8)), (ALPHAS, lazy)]
    for argument, out in calls:
        with anything:
            kernels.polar_moment(argument, out=out)
    for argument, where in ((lazy, ALPHAS > 0), (ALPHAS, lazy > 0), (ALPHAS, np.ma.masked)):
        with anything:
            kernels.polar_moment(argument, where=where)


def test_types_as_a_checker_sees_them() -> None:
    """A number gives a number, arrays keep their type; mypy reads these lines."""
    single: NDArray[np.float32] = np.ones(1, np.float32)
    both: NDArray[np.float64] = np.array([4.0])
    assert_type(kernels.polar_moment(0.5), np.float64)
    assert_type(kernels.polar_moment(single), NDArray[np.float32])
    assert_type(kernels.limit_friction(4.0, 5), np.float64)
    assert_type(kernels.limit_friction(4.0, both + 1), NDArray[np.float64])
    assert_type(kernels.limit_friction(both, 5.0), NDArray[np.float64])
    assert kernels.limit_friction(both, 5.0).dtype == np.float64


@pytest.mark.skipif(find_spec("jax") is None, reason="no JAX")
def test_jax() -> None:
    """JAX traces the kernels; in a process of its own, as a process with JAX's threads must not be forked."""
    done = subprocess.run([sys.executable, "-m", "tests.support.traced"], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
