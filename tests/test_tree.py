"""Numbers of scenes as leaves of a tree: what a path reads, replaces and selects."""

from typing import Any

import numpy as np
import pytest

from slipcircle import Arc, LayeredSection, Scene, Series, Soil, load
from slipcircle.derivatives import with_parameters
from slipcircle.tree import mapped, numbers, put
from slipcircle.workbench.files.shipped import shipped

GROUND = [(-60, 20), (0, 20), (40, 0), (120, 0)]
LINE = [(-60, 18.0), (10, 18.5), (20, 12)]
LAW = {"law": "linear", "peak": 0.4, "residual": 0.2, "length": 0.5}
LAYERED = Scene(
    LayeredSection(
        GROUND,
        (30, 45),
        48.0,
        layers=[(Soil(18e3, 2e3, LAW, name="sand 1.2"), None), (Soil(19e3, 5e3, LAW, name=""), LINE)],
        surcharge=[(-15, -5, 2e4, 4e4)],
        crack=0.5,
    ),
    effects=["rotation"],
)
RECORD = Series(np.linspace(0.0, 1.0, 5), np.array([0.0, 0.2, -0.1, 0.1, 0.0]))
SHAKEN = Scene(Arc(60.0, 3.8, 5.0, 19e3), 0.4, {"shaking": {"horizontal": RECORD, "scale": 0.5}})
EVERY = {name: load(name) for name in shipped()} | {"layered": LAYERED, "record": SHAKEN}
TOGETHER = {"shaking.scale", "shaking.peak"}


@pytest.mark.parametrize("name", EVERY)
def test_a_number_is_replaced_alone(name: str) -> None:
    """Except for the slip length that soils share, and for the factor and the peak of a record."""
    scene = EVERY[name]
    known = numbers(scene)
    assert mapped(scene.arc, lambda value: value) == scene.arc
    with pytest.raises(ValueError, match="radus: is not a number of this scene"):
        put(scene, {"radus": 1.0})
    for path, value in known.items():
        changed = numbers(put(scene, scene.arc.together({path: value + 0.25})))
        follow = {other for other in known if path.endswith(".length") and other.endswith(".length")}
        follow |= TOGETHER if path in TOGETHER else {path}
        assert changed.keys() == known.keys()
        assert changed[path] == pytest.approx(value + 0.25, rel=1e-14)
        assert {other for other in known if np.any(changed[other] != known[other])} <= follow


def test_lenses_change_what_they_stand_for() -> None:
    """Lenses follow their definitions: a line moves as a whole, pressures stay in proportion, a dip turns both ends."""
    paths = {"layers.2.top": 17.0, "surcharge.1.pressure": 6e4, "soils.sand 1.2.friction.length": 0.7}
    arc: Any = with_parameters(LAYERED, paths).arc
    assert np.asarray(arc.layers[1][1]).tolist() == [[-60, 17.0], [10, 17.5], [20, 11.0]]
    assert arc.surcharge[0] == (-15, -5, 3e4, 6e4)
    assert [soil.friction["length"] for soil, _ in arc.layers] == [0.7, 0.7]
    leftward = with_parameters(Scene(Arc(60.0, 4.4, 5.6, 19e3), 0.4), {"dip": 0.3})
    assert leftward.arc.dip == pytest.approx(0.3, rel=1e-14)
    turned = with_parameters(SHAKEN, {"dip": 0.3, "shaking.peak": 0.4})
    assert turned.arc.dip == pytest.approx(0.3, rel=1e-14)
    assert turned.arc.half_angle == pytest.approx(0.6, rel=1e-14)
    assert turned.numbers["shaking.scale"] == pytest.approx(2.0, rel=1e-14)
