"""Arrays and numbers as scenes, ensembles and records take them: masks, units, copies, and what is no number."""

import pickle
from collections.abc import Callable
from dataclasses import FrozenInstanceError, replace
from typing import Any

import numpy as np
import pytest

from slipcircle import (
    Arc,
    Interval,
    LayeredSection,
    Scene,
    Section,
    Series,
    Soil,
    backanalyse,
    ensemble,
    grid,
    load,
    parameters,
    solve,
)
from slipcircle.derivatives import with_parameter_arrays
from slipcircle.workbench.files.shipped import shipped
from tests.campaigns import odd_arrays

ARC = Arc(100.0, 3.8, 4.8, 20e3)
GROUND = [[-60.0, 20.0], [0.0, 20.0], [40.0, 0.0], [120.0, 0.0]]
SAMPLED = {"radius": {"distribution": "normal", "mean": 100.0, "std": 1.0}}
SCENE = Scene(ARC, 0.2, ["rotation"], uncertain=SAMPLED)


def test_odd_arrays_everywhere() -> None:
    """A sample of all places and values: an answer as for plain numbers, or an error of one line."""
    assert odd_arrays.faults(500, 57) == []


MASKED = np.ma.array([0.2, 999.0], mask=[False, True])


@pytest.mark.parametrize("value", [np.ma.masked, MASKED, [0.2, np.ma.masked]], ids=["masked", "array", "list"])
@pytest.mark.parametrize(
    ("make", "field"),
    [
        (lambda x: Scene(ARC, x), "friction"),
        (lambda x: Scene(ARC, 0.2, {"cohesion": {"cohesion": x}}), "effects.cohesion.cohesion"),
        (lambda x: Arc(x, 3.8, 4.8, 20e3), "radius"),
        (lambda x: Soil(19e3, cohesion=x), "cohesion"),
        (lambda x: grid(SCENE, {"radius": x}), "radius"),
        (lambda x: backanalyse(SCENE, run_out=x), "run_out"),
        (lambda x: Series(x, x), "time"),
    ],
)
def test_masks_are_refused(make: Callable[[Any], Any], field: str, value: Any) -> None:
    """Masks are refused by the name of the field; NumPy would read the numbers below the mask, or NaN."""
    with pytest.raises(ValueError, match=rf"{field}\b.*must be"):
        make(value)


def test_inputs_are_copied() -> None:
    """A caller's changes of arrays and mappings affect neither scene nor motion, and a scene's own are read-only."""
    radius, cohesion = np.array([100.0, 120.0]), {"cohesion": np.array([1e3, 2e3])}
    law: dict[str, Any] = {"law": "linear", "peak": 0.25, "residual": 0.2, "length": 2.0}
    effects: dict[str, Any] = {"rotation": {}, "cohesion": cohesion}
    scene: Any = Scene(Arc(radius, 3.8, 4.8, 20e3), law, effects, uncertain={}, observed={"run_out": 3.0})
    before = solve(scene).run_out
    motion = solve(scene)
    radius[:] = 1e3
    law["peak"] = np.nan
    cohesion["cohesion"][0] = np.nan
    effects["drag"] = {"xi": 1.0}
    np.testing.assert_array_equal(motion.run_out, before)
    np.testing.assert_array_equal(solve(scene).run_out, before)
    changes: tuple[Callable[[], Any], ...] = (
        lambda: scene.arc.radius.__setitem__(0, 1.0),
        lambda: scene.friction.__setitem__("peak", 1.0),
        lambda: scene.effects["cohesion"].update(cohesion=1.0),
        lambda: scene.effects["cohesion"]["cohesion"].__setitem__(0, 1.0),
        lambda: scene.effects.pop("rotation"),
        lambda: scene.uncertain.setdefault("radius", 1.0),
        lambda: scene.observed.clear(),
    )
    for change in changes:
        with pytest.raises((TypeError, ValueError), match="read-only"):
            change()
    again = pickle.loads(pickle.dumps(scene))
    np.testing.assert_array_equal(solve(again).run_out, before)


def test_sections_and_records_are_copied() -> None:
    ground, centre, samples = np.array(GROUND), np.array([30.0, 45.0]), np.linspace(0.0, 1.0, 5)
    soils = [(Soil(np.array([19e3, 20e3]), 5e3, 0.2, name="clay"), None)]
    section, layered = Section(ground, centre, 48.0, 19e3), LayeredSection(ground, centre, 48.0, layers=soils)
    series = Series(samples, samples)
    factor = section.dimensionless.limit_friction
    ground[:], centre[:], samples[:] = 0.0, 0.0, 7.0
    soils.clear()
    assert replace(section).dimensionless.limit_friction == factor
    assert len(layered.layers) == 1
    np.testing.assert_array_equal(layered.ground, GROUND)
    assert series(0.25) == 0.25
    kept: list[Any] = [section.ground, section.centre, layered.layers[0][0].unit_weight, series.values]
    for array in kept:
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 1.0
    with pytest.raises(FrozenInstanceError):
        section.radius = 1.0  # type: ignore[misc]


LAYERS: Any = load("layered-slope").arc
BIG = 10**400
BETWEEN: Any = Interval
TEXT: Any = bytearray(b"1")
ENSEMBLE: Any = ensemble
NUMBERS: Any = parameters
REFUSED: list[tuple[Callable[[], Any], str]] = [
    *((lambda x=x: backanalyse(SCENE, run_out=x), "run_out = .*: must be a number other than 0") for x in
      (True, b"12", "5", BIG, (5.0, BIG), BETWEEN(4.0, BIG), BETWEEN(True, 5.0), BETWEEN(b"4", 5.0))),
    (lambda: replace(SCENE, friction=TEXT), "friction = bytearray.*: must be a friction coefficient"),
    (lambda: replace(LAYERS, layers=0.1), "layers: must be pairs of a Soil and its top"),
    (lambda: replace(LAYERS, surcharge=0.1), "surcharge = 0.1: must be a list"),
    (lambda: ENSEMBLE(SCENE, 8, rng=1, folder=1), "folder = 1: must be a path"),
    (lambda: ENSEMBLE(SCENE, 8, rng=1, folder=b"x"), "folder = b'x': must be a path"),
    (lambda: ENSEMBLE(SCENE, 8, rng=1, size=np.uint64(2**63)), "size = .*: must be a power of two from 4"),
    (lambda: ENSEMBLE(SCENE, BIG, rng=1), "n = an integer of 1329 bits: must be a whole number"),
    (lambda: NUMBERS("x"), "parameters: scene = 'x': must be a Scene"),
    (lambda: NUMBERS(3.0), "parameters: scene = 3.0: must be a Scene"),
]  # fmt: skip


@pytest.mark.parametrize(("make", "said"), REFUSED)
def test_what_is_no_number_has_one_line(make: Callable[[], Any], said: str) -> None:
    with pytest.raises(ValueError, match=said) as caught:
        make()
    assert len(str(caught.value)) < 250
    assert "\n" not in str(caught.value)


def test_long_doubles_are_numbers(tmp_path: Any) -> None:
    """Read as float64, also where a folder identifies the study, as are functions without a name there."""
    expected = ensemble(SCENE, 8, rng=1).mean("run_out").value
    scene: Any = SCENE
    of_long = replace(scene, friction=np.longdouble(0.2))
    found = ENSEMBLE(of_long, 8, rng=1, folder=tmp_path, accuracy=np.longdouble(1e-9)).mean("run_out").value
    assert found == expected
    unnamed = replace(SCENE, friction=lambda s: 0.2 + 0.0 * s)
    assert ensemble(unnamed, 8, rng=1).mean("run_out").value == pytest.approx(expected, rel=1e-9)
    assert grid(unnamed, {"radius": [99.0, 101.0]}).mean("run_out").value > 0.0


@pytest.mark.parametrize("shape", [(0,), (0, 3)])
@pytest.mark.parametrize("name", shipped())
def test_an_ensemble_may_have_no_members(name: str, shape: tuple[int, ...]) -> None:
    """Arrays of length 0 in the first and last numbers of each kind give motions without lanes."""
    scene = load(name)
    kinds = {number.partition(".")[0]: number for number in parameters(scene)}
    for number in {*kinds.values(), "radius"} - {kinds.get("layers")}:
        empty, invalid = with_parameter_arrays(scene, {number: np.zeros(shape)})
        motion = solve(empty, invalid=invalid)
        assert motion.run_out.shape == motion.slow_run_out.shape == motion.error_estimate.shape == shape
        assert motion.factor_of_safety.shape == motion.end.normal_stress.shape == shape
        assert motion.at(1.0).displacement.shape == shape


def test_a_water_level_with_arrays_of_several_axes() -> None:
    """Lanes on two axes equal the same lanes on one axis: each has its own geometry."""
    scene = load("valley-side")
    radii = scene.arc.radius * np.linspace(1.0, 1.01, 6)
    flat, of_two_axes = (
        solve(with_parameter_arrays(scene, {"radius": values})[0]).run_out for values in (radii, radii.reshape(2, 3))
    )
    assert np.array_equal(flat, of_two_axes.ravel())
