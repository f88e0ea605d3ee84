"""Arrays of every kind wherever numbers are accepted: an answer as for plain numbers, or an error of one line.

``python -m tests.campaigns.odd_arrays 20000 --seed 1`` draws so many pairs of a place and a value: numbers of all of
NumPy's types, masked, pint, xarray, pandas, dask and JAX arrays, lists of them, and what is no number at all. A value
is read as the numbers that it contains, or refused with ValueError, TypeError or OverflowError; nothing else is raised,
no warning appears, and no result is NaN.
"""

import contextlib
import math
import sys
import time
import warnings
from collections.abc import Callable, Iterable
from dataclasses import replace
from decimal import Decimal
from fractions import Fraction
from functools import partial
from importlib import import_module
from random import Random
from typing import Any

import numpy as np

from generated import kernels
from slipcircle import (
    Arc,
    Interval,
    LayeredSection,
    Record,
    Scene,
    Section,
    Series,
    Slope,
    Soil,
    backanalyse,
    ensemble,
    grid,
    solve,
)
from slipcircle.base.errors import UnusualInput
from slipcircle.derivatives import with_parameters
from tests.campaigns import options

Place = tuple[str, float, Callable[[Any], Any]]  # name, a number that it takes, what is computed

ARC = Arc(100.0, 3.8, 4.8, 20e3)
PLAIN = Scene(ARC, 0.2, ["rotation"])
GROUND = ((-60.0, 20.0), (0.0, 20.0), (40.0, 0.0), (120.0, 0.0))
SOIL = Soil(19e3, 5e3, 0.2, name="clay")
MOTION = solve(PLAIN)
SERIES: Any = Series
TABLE: dict[str, Any] = {"law": "tabulated", "slip": [0.0, 1.0], "coefficient": [0.25, 0.2]}
EXPONENTIAL = {"law": "exponential", "peak": 0.25, "residual": 0.2, "length": 2.0}


def _moved(scene: Scene) -> Any:
    return solve(scene).run_out


def _with(effect: str, name: str, **more: Any) -> Callable[[Any], Any]:
    return lambda x: _moved(Scene(ARC, 0.2, {"rotation": {}, effect: {name: x, **more}}))


def _layered(**changes: Any) -> Any:
    fields: dict[str, Any] = {"layers": [(SOIL, None)]} | changes
    return LayeredSection(GROUND, (30.0, 45.0), 48.0, **fields)


def _points(x: Any) -> list[Any]:
    return [[-60.0, x], [0.0, x], [40.0, 0.0], [120.0, 0.0]]


def _of_alpha(name: str) -> Place:
    return name, 0.5, getattr(kernels, name)


def _soil(x: float, **name: Any) -> Any:
    return _factor(_layered(layers=[(replace(SOIL, **name), None)]))


def _factor(section: Any) -> Any:
    friction = None if isinstance(section, LayeredSection) else 0.3
    return solve(Scene(section, friction, end_time=0.5)).factor_of_safety


_SAMPLED: dict[str, Any] = {"radius": {"distribution": "normal", "mean": 100.0, "std": 1.0}}


def _sampled(mean: Any) -> Any:
    uncertain = {"radius": {**_SAMPLED["radius"], "mean": mean}}
    return ensemble(replace(PLAIN, uncertain=uncertain), 8, rng=1)


PLACES: list[Place] = [
    *map(_of_alpha, ("polar_moment", "radial_weight_amplitude", "dynamic_coefficient", "weight_moment_per_inertia")),
    ("limit_friction, first", 4.0, lambda x: kernels.limit_friction(x, 5.0)),
    ("weight_moment, second", 5.0, lambda x: kernels.weight_moment(4.0, x)),
    ("radial_weight, both", 4.0, lambda x: kernels.radial_weight(x, 5.0)),
    ("radius", 100.0, lambda x: _moved(Scene(Arc(x, 3.8, 4.8, 20e3), 0.2, ["rotation"]))),
    ("theta_1", 3.8, lambda x: Arc(100.0, x, 4.8, 20e3).limit_friction_angle),
    ("theta_2", 4.8, lambda x: Arc(100.0, 3.8, x, 20e3).limit_friction_angle),
    ("unit_weight", 20e3, lambda x: Arc(100.0, 3.8, 4.8, x).weight_moment),
    ("friction", 0.2, lambda x: _moved(Scene(ARC, x, ["rotation"]))),
    ("peak", 0.25, lambda x: _moved(Scene(ARC, {**EXPONENTIAL, "peak": x}, ["rotation"]))),
    ("length", 2.0, lambda x: _moved(Scene(ARC, {**EXPONENTIAL, "length": x}, ["rotation"]))),
    ("slip", 1.0, lambda x: _moved(Scene(ARC, TABLE | {"slip": [0.0, x]}, ["rotation"]))),
    ("coefficient", 0.2, lambda x: _moved(Scene(ARC, TABLE | {"coefficient": [0.25, x]}, ["rotation"]))),
    ("friction function", 0.2, lambda x: _moved(Scene(ARC, lambda s: x + 0.0 * s, ["rotation"]))),
    ("cohesion", 1e3, _with("cohesion", "cohesion")),
    ("ratio", 0.1, _with("pore_pressure", "ratio")),
    ("pressure", 2e3, _with("pore_pressure", "pressure")),
    ("xi", 500.0, _with("drag", "xi")),
    ("amplitude", 0.1, _with("shaking", "amplitude", pulse="sine", duration=2.0)),
    ("duration", 2.0, _with("shaking", "duration", pulse="sine", amplitude=0.1)),
    ("initial_velocity", 1.0, lambda x: _moved(replace(PLAIN, initial_velocity=x))),
    ("end_time", 3.0, lambda x: _moved(replace(PLAIN, end_time=x))),
    ("accuracy", 1e-6, lambda x: solve(PLAIN, x).run_out),
    ("at", 1.0, lambda x: MOTION.at(x).velocity),
    ("with_parameters", 0.2, lambda x: _moved(with_parameters(PLAIN, {"friction": x}))),
    ("ground", 20.0, lambda x: _factor(Section(_points(x), (30.0, 45.0), 48.0, 19e3))),
    ("centre", 45.0, lambda x: _factor(Section(GROUND, (30.0, x), 48.0, 19e3))),
    ("section radius", 48.0, lambda x: _factor(Section(GROUND, (30.0, 45.0), x, 19e3))),
    ("level", -2.0, lambda x: Section(GROUND, (30.0, 45.0), 48.0, 19e3, level=_points(x)).mean_pressure()),
    ("soil cohesion", 5e3, lambda x: _soil(x, cohesion=x)),
    ("soil friction", 0.2, lambda x: _soil(x, friction=x)),
    ("soil weight", 19e3, lambda x: _soil(x, unit_weight=x)),
    ("top", 5.0, lambda x: _factor(_layered(layers=[(SOIL, None), (replace(SOIL, name="b"), x)]))),
    ("surcharge", 1e4, lambda x: _factor(_layered(surcharge=[(-20.0, -5.0, x, 1e4)]))),
    ("crack", 1.0, lambda x: _factor(_layered(crack=x))),
    ("slope cohesion", 5e3, lambda x: Slope(GROUND, cohesion=x, friction=0.3, unit_weight=19e3).cohesion),
    ("slope ground", 20.0, lambda x: Slope(_points(x), 5e3, 0.3, 19e3).ground),
    ("series time", 1.0, lambda x: SERIES([0.0, x], [1.0, 2.0])(0.5)),
    ("series values", 1.0, lambda x: SERIES([0.0, 1.0], [0.0, x])(0.5)),
    ("record", 0.1, lambda x: Record([0.0, x, 0.0], dt=0.1)(0.1)),
    ("record dt", 0.1, lambda x: Record([0.0, 0.1, 0.0], dt=x)(0.1)),
    ("grid", 100.0, lambda x: grid(PLAIN, {"radius": x}).mean("run_out").value),
    ("ensemble mean", 100.0, lambda x: _sampled(x).mean("run_out").value),
    ("ensemble n", 8, lambda x: ensemble(replace(PLAIN, uncertain=_SAMPLED), x, rng=1).n),
    ("ensemble size", 8, lambda x: ensemble(replace(PLAIN, uncertain=_SAMPLED), 8, rng=1, size=x).n),
    ("backanalyse", 5.0, lambda x: backanalyse(PLAIN, run_out=x).solutions[0].values["friction.angle_deg"]),
    ("interval", 5.0, lambda x: backanalyse(PLAIN, run_out=Interval(4.0, x)).solutions[0].values["friction.angle_deg"]),
]  # fmt: skip


FUNCTIONS = [where for where, *_ in PLACES[:7]]
OUTSIDE = ("range", "true", "truths", "infinite", "negative", "pint degrees")


def _libraries(x: float) -> dict[str, Callable[[], Any]]:
    """Return arrays of other libraries with a number, those that are installed."""
    made: dict[str, Callable[[], Any]] = {}
    with contextlib.suppress(ImportError):
        pint = import_module("pint")
        units = pint.get_application_registry()
        made |= {"pint": lambda: units.Quantity(x, ""), "pint degrees": lambda: units.Quantity([x], "degree")}
        made |= {"pint in a list": lambda: [units.Quantity(x, "degree"), x]}
    with contextlib.suppress(ImportError):
        xarray = import_module("xarray")
        made |= {"xarray": lambda: xarray.DataArray([x, x], dims="a"), "0-d xarray": lambda: xarray.DataArray(x)}
        made |= {"xarray of NaN": lambda: xarray.DataArray([x, math.nan], dims="a")}
    with contextlib.suppress(ImportError):
        pandas = import_module("pandas")
        made |= {"pandas": lambda: pandas.Series([x, x]), "frame": lambda: pandas.DataFrame({"a": [x]})}
        made |= {"missing": lambda: pandas.Series([x, None], dtype="Float64"), "NA": lambda: pandas.NA}
    with contextlib.suppress(ImportError):
        dask = import_module("dask.array")
        made |= {"dask": lambda: dask.from_array(np.array([x, x]), chunks=1)}
    if "jax" in sys.modules:  # whose threads a process of the tests cannot have
        made |= {"jax": lambda: sys.modules["jax"].numpy.asarray([x, x])}
    return made


def values(x: float) -> dict[str, Callable[[], Any]]:
    """Return what a number may be given as, by name."""
    kinds: list[Any] = [np.float64, np.float32, np.float16, np.longdouble, np.int8, np.int64, np.uint64, np.complex128]
    made: dict[str, Callable[[], Any]] = {}
    for kind in kinds:
        made[kind.__name__] = partial(kind, x)
        made[f"array of {kind.__name__}"] = partial(np.array([x, x]).astype, kind)
    made |= {
        "number": lambda: x,
        "0-d": lambda: np.array(x),
        "swapped bytes": lambda: np.array([x, x], ">f8"),
        "strided": lambda: np.array([x, 7.0, x])[::-2],
        "read-only": lambda: np.broadcast_to(x, 3),
        "empty": lambda: np.empty(0),
        "list": lambda: [x, x],
        "tuple": lambda: (x, x),
        "range": lambda: range(2),
        "ragged": lambda: [[x], [x, x]],
        "nested": lambda: [[[x]]],
        "masked": lambda: np.ma.masked,
        "masked in a list": lambda: [x, np.ma.masked],
        "masked array": lambda: np.ma.array([x, 7.0], mask=[False, True]),
        "unmasked array": lambda: np.ma.array([x, x]),
        "masked number": lambda: np.ma.array(x, mask=True),
        "recarray": lambda: np.array([x]).view(np.recarray),
        "structured": lambda: np.zeros(2, [("a", float)]),
        "object array": lambda: np.array([x, None]),
        "dates": lambda: np.array(["2024-01-01"], "M8[D]"),
        "memoryview": lambda: np.array([x]).data,
        "bytes": lambda: b"12",
        "text": lambda: str(x),
        "texts": lambda: [str(x)],
        "text array": lambda: np.array([str(x)]),
        "huge": lambda: 10**400,
        "huge in a list": lambda: [10**400, x],
        "fraction": lambda: Fraction(x),
        "decimal": lambda: Decimal(x),
        "complex": lambda: complex(x, 1.0),
        "true": lambda: True,
        "truths": lambda: np.array([True, False]),
        "none": lambda: None,
        "nan": lambda: math.nan,
        "nans": lambda: np.array([x, math.nan]),
        "infinite": lambda: math.inf,
        "negative": lambda: -x,
        "set": lambda: {x},
        "mapping": lambda: {"a": x},
        "generator": lambda: (y for y in (x, x)),
        "function": lambda: lambda: x,
        "type": lambda: float,
        "interval": lambda: Interval(x, x),
    }
    return made | _libraries(x)


# What is read as another number than the one given, or as none, though it is finite and real.
_CONVERTED = ("float16", "float32", "int8", "int64", "uint64", "complex128")
_OTHERS = {f"{kind}{name}" for kind in ("", "array of ") for name in _CONVERTED}
_OTHERS |= {"jax", "range", "huge", "true", "truths", "negative"}


def fault(place: Place, name: str) -> str:
    """Return what is wrong with the answer to a value; empty for an answer or an error of one line."""
    where, number, computed = place
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            warnings.simplefilter("ignore", UnusualInput)
            warnings.filterwarnings("ignore" if where in FUNCTIONS else "error", "invalid value encountered in")
            result = computed(values(number)[name]())
            expected = computed(number)
    except (ValueError, TypeError, OverflowError) as error:
        said = str(error)
        return "" if said and "\n" not in said and said[0] != "'" else f"says {said!r}"
    except Exception as error:
        return f"{type(error).__name__}: {error}"
    if where in FUNCTIONS and name in OUTSIDE:  # NaN and NumPy's flag
        return ""
    found = np.asarray(getattr(result, "magnitude", result), dtype=np.float64)
    if "missing" not in name and name not in ("nan", "nans", "NA", "xarray of NaN") and np.isnan(found).any():
        return f"is {result!r}"
    if (
        name in _OTHERS
        or "degree" in name
        or not found.size
        or where in ("at", "accuracy")
        or (where, name) == ("end_time", "none")
    ):
        return ""
    wanted = np.broadcast_to(expected, found.shape) if np.ndim(expected) <= found.ndim else expected
    known = np.isfinite(found)
    close = np.allclose(found[known], np.asarray(wanted)[known], rtol=1e-9, atol=0.0)
    return "" if close else f"is {result!r} instead of {expected!r}"


def faults(count: int, seed: int) -> list[tuple[str, str, str]]:
    """Return place, value and fault of so many random pairs."""
    rng = Random(seed)
    names = [*values(1.0)]
    pairs = ((rng.choice(PLACES), rng.choice(names)) for _ in range(count))
    return [(place[0], name, said) for place, name in pairs if (said := fault(place, name))]


def every() -> Iterable[tuple[str, str, str]]:
    """Yield place, value and fault of all pairs that are answered badly."""
    for place in PLACES:
        for name in values(1.0):
            if said := fault(place, name):
                yield place[0], name, said


if __name__ == "__main__":
    asked = options(__doc__)  # without a count every pair once
    with contextlib.suppress(ImportError):
        import_module("jax.numpy")
    begun = time.monotonic()
    bad = [*every()] if asked.count is None else faults(asked.count, asked.seed)
    for row in bad:
        print(*row, sep=" | ")
    number_of = asked.count or len(PLACES) * len(values(1.0))
    print(f"{number_of} pairs, {len(bad)} answered badly, {time.monotonic() - begun:.0f} s")
    sys.exit(bool(bad))
