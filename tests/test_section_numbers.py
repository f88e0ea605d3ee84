"""The numbers of a section: lanes of circles, grounds and levels, derivatives, studies and back-analyses by them."""

import json
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from flint import arb, ctx

from slipcircle import Scene, Section, backanalyse, load, solve
from slipcircle.core.motion.states import Status
from slipcircle.layers import LayeredSection, Soil
from slipcircle.tree import numbers
from slipcircle.workbench.studies.ensemble import grid
from tests.support import section_references, taylor
from tests.support.grounds import GROUND, LEVEL

TURNING: Any = {"rotation": {}, "centripetal": {}, "cohesion": {"cohesion": 3e3}}
SLOPE: dict[str, Any] = {"ground": GROUND, "centre": [30.5, 53.6], "radius": 28.4, "unit_weight": 20e3}
VALLEY = load("valley-side")


def body(**more: Any) -> Section:
    return Section(**SLOPE | more)


# --- lanes -----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"radius": np.array([28.4, 5.0, 28.0])}, r"lane \[1\]: centre = .* misses the ground"),
        ({"level": [[[0, 20], [90, 20]], [[0, 27], [90, 22]]]}, r"lane \[1\]: level: varies by 1\.\d+ m from x = 0"),
        ({"radius": [28.4, 28.3], "level": np.tile(np.array(LEVEL), (3, 1, 1))}, "shapes do not fit"),
    ],
)
def test_a_lane_that_is_none_is_named(given: dict[str, Any], said: str) -> None:
    with pytest.raises(ValueError, match=said):
        body(**given)


def test_a_circle_that_only_touches_a_scarp_is_none() -> None:
    """Entry and exit would be one point, with half an angle of 6e-17."""
    x, height = 39.93594546227666, 19.304500093424398
    ground = [[-160.0, 0.0], [x, 0.0], [x, height], [240.0, height]]
    given: dict[str, Any] = {"ground": ground, "centre": [33.49550289007233, 8.148909736444072], "unit_weight": 2e4}
    with pytest.raises(ValueError, match=r"radius = 6\.44.* only touches the ground, at \[39.9359, 8.14891\]"):
        Section(**given, radius=6.440442572204333)
    assert Section(**given, radius=6.440442572204333 * (1 + 1e-13)).half_angle > 1e-8
    with pytest.raises(ValueError, match=r"lane \[1\]: radius = .*only touches the ground"):
        Section(**given, radius=np.array([6.5, 6.440442572204333]))


def test_a_lane_beyond_half_a_circle_is_named() -> None:
    with pytest.raises(ValueError, match=r"arc: lane \[1\]: the arc is longer than half a circle"):
        Scene(Section([[-40, 20], [0, 0], [40, 20]], [[2.0, 9.9], [0.2, 0.5]], [10.2, 4.0], 20e3), 0.3)


def test_lanes_of_a_study_that_are_none_stop_no_other() -> None:
    radii = [5.0, 28.3, 28.5, 40.0, 28.4]
    found = grid(Scene(body(base=20.0), 0.25, TURNING), {"circle.radius_m": radii}).samples
    assert [status == Status.INVALID for status in found["status"]] == [True, False, False, True, False]
    alone = [solve(Scene(body(radius=radii[k], base=20.0), 0.25, TURNING)).run_out for k in (1, 2, 4)]
    assert found["run_out"][[1, 2, 4]] == pytest.approx(alone, rel=1e-9)
    wet_ones = grid(VALLEY, {"water.level_m.3.y": [69.0, 90.0]}).samples["status"].tolist()  # a pond
    assert wet_ones == [Status.RESTS, Status.INVALID]


# --- derivatives -----------------------------------------------------------------------------------------------------


def outputs(given: Any, name: str, to: float) -> list[arb]:
    """Peak velocity, run-out and duration at 30 digits with one number of the section changed."""
    arc = json.loads(json.dumps(given["arc"]))
    field, *at = name.split(".")
    box = {"centre": lambda: arc["centre"], "radius": lambda: arc}.get(field, lambda: arc[field][int(at[0])])()
    box["xy".index(at[-1]) if at else field] = to
    found = taylor.solve(given | {"arc": arc}, digits=34, problem=section_references.Section)
    return [abs(arb(found["peak_velocity"])), arb(found["run_out"]), arb(found["duration"])]


def in_two_layers(scene: Scene) -> Scene:
    """Return the same mass divided by a boundary between two equal soils."""
    arc = scene.arc
    assert isinstance(arc, Section)
    soils = [Soil(float(np.asarray(arc.unit_weight)), 0.0, scene.friction, name=name) for name in "ab"]
    layers = list(zip(soils, (None, float(arc.centroid[1])), strict=True))
    return replace(scene, arc=LayeredSection(arc.ground, arc.centre, arc.radius, level=arc.level, layers=layers),
                   friction=None)  # fmt: skip


@pytest.mark.parametrize(("index", "layered"), [(0, False), (1, False), (1, True), (4, False)])
def test_derivatives_against_thirty_digits(index: int, layered: bool) -> None:
    """Differences of series solutions in ball arithmetic of random scenes: softening, a level, pushed up, shaken."""
    given = json.loads(section_references.FILE.read_text("utf-8"))[index]["scene"]
    scene = section_references.scene(given)
    motion = solve(in_two_layers(scene) if layered else scene)
    found, own = motion.sensitivity(), numbers(motion.plan.scene.arc)
    sign = np.array([np.sign(motion.peak.velocity), 1.0, 1.0])
    size = np.abs(found.values).max(axis=1)[:3]
    for field in ("radius", "centre", "ground", "level"):
        names = [n for n in found.parameters if n.startswith(field)]
        if not names:
            continue
        name = max(names, key=lambda n: abs(found.derivative("run_out", n)))
        ends = [float(own[name]) + way * float(own["radius"]) * 2.0**-34 for way in (-1, 1)]
        with ctx.workprec(200):
            low, high = (outputs(given, name, value) for value in ends)
            slopes = [float((b - a) / (arb(ends[1]) - arb(ends[0]))) for a, b in zip(low, high, strict=True)]
        column = list(found.parameters).index(name)
        off, error = np.abs(found.values[:3, column] - sign * slopes), found.errors[:3, column]
        assert np.all(off <= error), (name, off, error)
        assert np.all(error <= 1e-8 * size), (name, error)
    if layered:
        whole = solve(scene).sensitivity()
        of_soils = [found.derivative("run_out", f"soils.{soil}.friction") for soil in "ab"]
        assert sum(of_soils) == pytest.approx(whole.derivative("run_out", "friction"), rel=1e-9)
        assert min(map(abs, of_soils)) > 0.0
        assert abs(found.derivative("run_out", "layers.2.top")) <= found.error("run_out", "layers.2.top") < 1e-9


def test_sensitivity_of_a_circle_through_a_vertex(asked: Any) -> None:
    """Outside of a vertex of the ground another mass is cut off: the derivative is that of circles inside."""
    assert "radius: outcomes jump at this value (peak_velocity" in asked("sensitivity real-slope")[2]
    motion = solve(load("real-slope"))
    radius = float(np.asarray(motion.plan.scene.arc.radius))
    beside = grid(motion.plan.scene, {"radius": [radius - 1e-5, radius + 1e-9]}, accuracy=1e-13).samples["run_out"]
    found = motion.sensitivity()
    place = list(found.outputs).index("run_out"), list(found.parameters).index("radius")
    assert found.kinds[place] == "jump"
    assert found.values[place] == found.slopes[place][0] == pytest.approx((motion.run_out - beside[0]) / 1e-5, rel=1e-4)
    assert found.jumps[place] == pytest.approx([0.0, beside[1] - motion.run_out], rel=1e-6)
    assert found.errors[place] <= 1e-6 * abs(found.values[place])


def test_what_is_no_number_of_a_section_is_told() -> None:
    with pytest.raises(ValueError, match=r"point's coordinate by its number from 0|did you mean"):
        grid(VALLEY, {"ground.points_m.99.y": [1.0]})
    with pytest.raises(ValueError, match=r"arc\.dip_deg: is not a parameter"):
        backanalyse(VALLEY, run_out=20.0, field="arc.dip_deg")
    with pytest.raises(ValueError, match=r"has no value of it to vary; it has circle.radius_m.* ground.points_m.3.y"):
        grid(VALLEY, {"cohesion.cohesion_kPa": [1.0]})
