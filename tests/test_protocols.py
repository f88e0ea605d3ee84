"""Arrays of other libraries stay what they are: dask lazy, xarray labelled, pint dimensionless, JAX traced.

Each test is skipped where its library is missing; `pip install '.[peers]'` brings them all.
"""

import pickle
from itertools import pairwise
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
    same(lazy.compute(scheduler="synchronous"), name)
    single = function(da.from_array(ALPHAS[:-1].astype(np.float32), chunks=3))
    assert single.dtype == single.compute(scheduler="synchronous").dtype == np.float32
    assert function(da.arange(2, chunks=1)).dtype == np.float64
    cloudpickle = pytest.importorskip("cloudpickle")
    same(pickle.loads(cloudpickle.dumps(lazy)).compute(scheduler="synchronous"), name)


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
    lazy = function(labelled.chunk({"arc": 3}))
    assert isinstance(lazy.data, da.Array)
    same(lazy.compute(scheduler="synchronous"), name)
    same(function(xr.Dataset({"a": labelled})).a, name)


@each_kernel
def test_pandas(name: str) -> None:
    """A Series keeps its index and name, a frame its columns; outside the domain NaN and NumPy's flag."""
    pd = pytest.importorskip("pandas")
    function = getattr(kernels, name)
    series = pd.Series(ALPHAS, index=list("abcdefgh"), name="alpha")
    value = function(series)
    assert isinstance(value, pd.Series)
    assert (value.name, list(value.index)) == ("alpha", list(series.index))
    same(value, name)
    assert function(series[:-1].astype(np.float32)).dtype == np.float32
    frame = function(pd.DataFrame({"a": ALPHAS, "b": ALPHAS[::-1]}))
    assert list(frame.columns) == ["a", "b"]
    same(frame["b"], name, ALPHAS[::-1])
    with pytest.warns(RuntimeWarning, match="invalid"):
        assert function(pd.Series([0.5, 2.0])).isna().tolist() == [False, True]


@each_kernel
def test_pint(name: str) -> None:
    """Dimensionless in, dimensionless out; degrees are radians; a length is an error."""
    pint = pytest.importorskip("pint")
    units, function = pint.UnitRegistry(), getattr(kernels, name)
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
    """`out` and `where` are NumPy's; nothing is proved in JAX's arithmetic."""
    da = pytest.importorskip("dask.array")
    lazy = da.from_array(ALPHAS, chunks=3)
    with pytest.raises(TypeError, match="out"):
        kernels.polar_moment(lazy, out=np.zeros(8))
    with pytest.raises(TypeError, match="where"):
        kernels.polar_moment(lazy, where=ALPHAS > 0)
    jnp = pytest.importorskip("jax.numpy")
    with pytest.raises(ValueError, match=r"nothing is proved.*jax"):
        kernels.polar_moment(jnp.ones(3), accuracy=1e-3)


def slope(name: str, alpha: float) -> float:
    """A central difference of the kernel, for comparison: good to ten digits."""
    function = getattr(kernels, name)
    h = 2.0**-10
    rows = [(function(alpha + k * h) - function(alpha - k * h)) / (2 * k * h) for k in (1, 2, 4)]
    once = [(4 * a - b) / 3 for a, b in pairwise(rows)]
    return float((16 * once[0] - once[1]) / 15)


@each_kernel
@pytest.mark.parametrize("double", [True, False], ids=["float64", "float32"])
def test_jax(name: str, double: bool) -> None:
    """Alone, under `jit`, `vmap` and `grad`, in either of its float types; NaN outside, the limits at both ends."""
    jax = pytest.importorskip("jax")
    function = getattr(kernels, name)
    with jax.enable_x64(double):
        alphas, tolerance = jax.numpy.asarray(ALPHAS), 1e-14 if double else 1e-5
        assert alphas.dtype == (np.float64 if double else np.float32)
        for way in (function, jax.jit(function), jax.vmap(function)):
            value = way(alphas)
            assert isinstance(value, jax.Array)
            assert value.dtype == alphas.dtype
            np.testing.assert_allclose(value, function(np.asarray(alphas)), rtol=tolerance)
        outside = np.asarray(jax.jit(function)(jax.numpy.asarray([-0.1, 1.6, np.nan, np.inf, 0.5])))
        np.testing.assert_array_equal(np.isnan(outside), [True, True, True, True, False])
        rises = jax.grad(function)
        for alpha in (0.3, float(np.pi / 4), 0.9, 1.1, 1.3, 1.5):
            expected = slope(name, alpha)
            assert float(rises(alpha)) == pytest.approx(expected, rel=1e-8 if double else 1e-4, abs=1e-8)
            assert float(jax.jit(rises)(alpha)) == pytest.approx(expected, rel=1e-8 if double else 1e-4, abs=1e-8)
        assert np.isfinite(float(rises(0.0)))
        assert np.isfinite(float(rises(float(np.pi / 2))))
