"""Arrays of other libraries stay what they are: dask lazy, xarray labelled, pint dimensionless, JAX traced.

Each test is skipped where its library is missing; `pip install '.[peers]'` brings them all.
"""

import pickle
import subprocess
import sys
from importlib.util import find_spec
from typing import Any

import numpy as np
import pytest

from generated import kernels
from tests.support import oracle

NAMES = (*oracle.BASE, *oracle.QUOTIENTS)
each_kernel = pytest.mark.parametrize("name", NAMES)
ALPHAS = np.array([0.0, 1e-8, 0.3, np.pi / 4, 0.9, 1.1, 1.5, np.pi / 2])


def same(value: Any, name: str, alphas: Any = ALPHAS) -> None:
    np.testing.assert_array_equal(np.asarray(value), getattr(kernels, name)(alphas))


@each_kernel
def test_dask(name: str) -> None:
    """Lazy until asked, the same numbers, the type of the chunks; it travels to other processes."""
    da = pytest.importorskip("dask.array")
    function = getattr(kernels, name)
    lazy = function(da.from_array(ALPHAS, chunks=3))
    assert isinstance(lazy, da.Array)
    assert lazy.chunks == ((3, 3, 2),)
    single = function(da.from_array(ALPHAS[:-1].astype(np.float32), chunks=3))
    assert single.dtype == single.compute(scheduler="synchronous").dtype == np.float32
    assert function(da.arange(2, chunks=1)).dtype == np.float64
    travelled = pickle.loads(pytest.importorskip("cloudpickle").dumps(lazy))
    same(travelled.compute(scheduler="synchronous"), name)


@each_kernel
def test_xarray(name: str) -> None:
    """Dimensions, coordinates and attributes stay; so does a lazy inside; a Dataset goes variable by variable."""
    xr, da = pytest.importorskip("xarray"), pytest.importorskip("dask.array")
    function = getattr(kernels, name)
    labelled = xr.DataArray(ALPHAS, dims="arc", coords={"arc": np.arange(ALPHAS.size)}, name="alpha")
    value = function(labelled)
    assert isinstance(value, xr.DataArray)
    assert value.dims == ("arc",)
    xr.testing.assert_equal(value.coords.to_dataset(), labelled.coords.to_dataset())
    same(value, name)
    assert isinstance(function(labelled.chunk({"arc": 3})).data, da.Array)
    same(function(xr.Dataset({"a": labelled})).a, name)


@each_kernel
def test_pandas(name: str) -> None:
    """A Series keeps its index and name; outside the domain NaN and NumPy's flag."""
    pd = pytest.importorskip("pandas")
    function = getattr(kernels, name)
    series = pd.Series(ALPHAS, index=list("abcdefgh"), name="alpha")
    value = function(series)
    assert isinstance(value, pd.Series)
    assert (value.name, list(value.index)) == ("alpha", list(series.index))
    same(value, name)
    with pytest.warns(RuntimeWarning, match="invalid"):
        assert function(pd.Series([0.5, 2.0])).isna().tolist() == [False, True]


@each_kernel
def test_pint(name: str) -> None:
    """Dimensionless in, dimensionless out; degrees are radians; a length is an error."""
    pint = pytest.importorskip("pint")
    units, function = pint.get_application_registry(), getattr(kernels, name)
    for unit in ("dimensionless", "radian"):
        value = function(units.Quantity(ALPHAS, unit))
        assert isinstance(value, units.Quantity)
        assert value.dimensionless
        same(value.magnitude, name)
    degrees = function(units.Quantity(30.0, "degree")).to("dimensionless").magnitude
    assert degrees == pytest.approx(function(np.pi / 6), rel=1e-14)
    for wrong in (units.Quantity(1.0, "m"), units.Quantity(ALPHAS, "s")):
        with pytest.raises(pint.DimensionalityError):
            function(wrong)


def test_what_another_library_cannot_ask_for() -> None:
    """`out` and `where` are NumPy's."""
    da = pytest.importorskip("dask.array")
    lazy = da.from_array(ALPHAS, chunks=3)
    with pytest.raises(TypeError, match="out"):
        kernels.polar_moment(lazy, out=np.zeros(8))
    with pytest.raises(TypeError, match="where"):
        kernels.polar_moment(lazy, where=ALPHAS > 0)


@pytest.mark.skipif(find_spec("jax") is None, reason="no JAX")
def test_jax() -> None:
    """In a process of its own: a process with JAX's threads in it must not be forked."""
    done = subprocess.run([sys.executable, "-m", "tests.support.traced"], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
