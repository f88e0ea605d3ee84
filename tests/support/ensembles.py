"""Scenes of arrays: arcs of every law and effect, circles, grounds, levels, soils, loads and cracks."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from slipcircle import Arc, Scene, Section, solve
from slipcircle.derivatives import with_parameter_arrays
from slipcircle.layers import LayeredSection
from tests.support import golden
from tests.support.grounds import GROUND, LEVEL
from tests.support.layered import BELOW_GROUND, CRACKED, TURNING, of_each_soil, profile, tangent

ARCS: dict[str, Any] = {"radius": np.array([60.0, 45.0, 80.0, 60.0]),
                        "theta_1": np.radians([220.0, 223.0, 220.0, 250.0]),
                        "theta_2": np.radians([290.0, 289.0, 287.0, 320.0])}  # fmt: skip


def of_arcs(law: str, effects: str) -> Scene:
    """Larger, thinner, mirrored, pushed both ways, cut short."""
    scene = golden.built("", golden.scene(golden.LAWS[law], golden.EFFECTS[effects]))
    pushed, until = np.array([0.0, 2.0, -2.5, 1.0]), np.array([20.0, 15.0, 4.0, 0.8])
    return replace(scene, arc=Arc(**golden.SLOPE | ARCS), initial_velocity=pushed, end_time=until)


def of_sections(**changed: Any) -> Scene:
    slope: dict[str, Any] = {"ground": GROUND, "centre": [30.5, 53.6], "radius": 28.4, "unit_weight": 20e3}
    effects: Any = {"rotation": {}, "centripetal": {}, "cohesion": {"cohesion": 3e3}}
    return Scene(Section(**slope | changed), 0.25, effects)


def of_layers(section: LayeredSection, values: Mapping[str, Sequence[Any]]) -> Scene:
    arrays = {name: np.array(numbers) for name, numbers in values.items()}
    return with_parameter_arrays(Scene(section, effects=TURNING), arrays)[0]


RAISED = np.array(GROUND) + np.array([0.0, 0.2, -0.1])[:, None, None] * [[0, 0], [0, 0], [0, 1], [0, 1], [0, 1]]
LOWERED = np.array(LEVEL) - np.array([0.5, 1.0, 2.0])[:, None, None] * [0, 1]
SOILS = {"soils.soil 2.friction.peak": tangent([9.0, 8.0]), "soils.soil 1.unit_weight": [19e3, 18e3]}
CUT = {"crack": [4.0, 3.5], "surcharge.1.pressure": [3e4, 5e4], "layers.3.top": [3.0, 5.0]}
COLUMN: dict[str, Any] = {"radius": np.array([[60.0], [45.0]])}
TWO = Arc(**golden.SLOPE | COLUMN)
LINEAR = {"law": "linear", "peak": np.array([0.2, 0.22, 0.24]), "residual": 0.17, "length": 2.0}
PAIRS = [*zip(2 * [*golden.LAWS], 2 * [*golden.EFFECTS], strict=False)]
DAM = [(-40, 0), (0, 0), (40, 16), (50, 16), (90, 0), (130, 0)]
POOLS = np.array([[(-40, y), (0, y), (90 - 2.5 * y, y), (130, y)] for y in (3.0, -1.0, 1.0)])  # one leaves the toe dry
SCENES: dict[str, Scene] = {
    **{f"{law}, {effects}": of_arcs(law, effects) for law, effects in PAIRS},
    "rows and columns": replace(golden.built("", golden.scene(LINEAR, {"rotation": {}})), arc=TWO),
    "radius": of_sections(radius=np.array([28.3, 28.5, 28.4])),
    "circles": of_sections(centre=[[30.5, 53.6], [30.4, 53.5], [30.6, 53.4]], radius=np.array([28.4, 28.35, 28.3])),
    "grounds": of_sections(ground=RAISED),
    "a grid of circles": of_sections(centre=[[[30.5, 53.6]], [[30.4, 53.7]]], radius=np.array([28.3, 28.5, 28.4])),
    "levels": of_sections(level=LOWERED, centre=[33.0, 56.0], radius=28.0),
    "circles under a level": of_sections(level=LEVEL, centre=[[33.0, 56.0], [33.05, 55.97], [32.94, 56.02]],
                                         radius=np.array([28.0, 28.03, 27.96])),
    "standing water": replace(
        of_sections(ground=DAM, centre=[82, 44], radius=np.array([44.0, 43.0, 44.0]), level=POOLS), friction=0.1),
    "one soil": replace(of_sections(unit_weight=np.array([19e3, 20e3])), friction=np.array([0.2, 0.25]),
                        effects={"rotation": {}, "cohesion": {"cohesion": np.array([2e3, 3e3])}}),
    "soils, the base": of_layers(profile("softening", "base"), SOILS),
    "soils, the mass": of_layers(profile("softening", "mass"), SOILS),
    "laws of soils": of_layers(of_each_soil(level=BELOW_GROUND), {"soils.a.friction.length": [0.3, 0.302]}),
    "rows of circles, columns of soils": of_layers(
        profile("softening", "base"), {"radius": [[48.0], [47.5]], "soils.soil 1.unit_weight": [19e3, 18e3, 18.5e3]}),
    "circles and boundaries": of_layers(
        profile("constant friction"), {"radius": [48.0, 47.5], "layers.3.top": [2.0, 2.4]}),
    "cracks, loads and cohesion": of_layers(CRACKED, CUT),
}  # fmt: skip


def stacked(values: Sequence[Any]) -> Any:
    """Return values that differ between lanes as arrays, and others as they are."""
    first = values[0]
    if isinstance(first, dict):
        return {k: stacked([v[k] for v in values]) for k in first}
    return first if all(v == first for v in values) else np.array(values)


def together(rows: Sequence[golden.Data], accuracy: float = 1e-9) -> Any:
    """Return the ensemble of these scenes, solved."""
    given = stacked(rows)
    return solve(Scene(Arc(**given["arc"]), given["friction"], given["effects"], given["initial_velocity"],
                       given["end_time"]), accuracy)  # fmt: skip
