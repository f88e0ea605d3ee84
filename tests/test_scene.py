"""What a scene accepts, and what it says when it does not."""

import dataclasses
import math
from typing import Any

import numpy as np
import pytest

from slipcircle import Arc, Scene, load, plan
from slipcircle.base.series import Pulse
from slipcircle.files.scenefile import shipped

ARC = Arc(800.0, 3.8, 5.0, 21e3)


def test_effects_by_name_or_as_a_mapping() -> None:
    mapping = Scene(ARC, 0.2, {"centripetal": {}})
    assert mapping.effects == {"centripetal": {}}
    for names in (("centripetal",), ["centripetal"], {"centripetal"}, iter(["centripetal"])):
        assert Scene(ARC, 0.2, names) == mapping
    assert Scene(ARC, 0.2) == Scene(ARC, 0.2, {}) == Scene(ARC, 0.2, ())
    assert Scene(ARC, 0.2) != mapping


def test_a_scene_is_frozen_and_keeps_its_own_effects() -> None:
    effects: dict[str, dict[str, float]] = {}
    scene = Scene(ARC, 0.2, effects)
    effects["centripetal"] = {}
    assert scene.effects == {}
    with pytest.raises(dataclasses.FrozenInstanceError):
        scene.friction = 0.5  # type: ignore[misc]


@pytest.mark.parametrize("friction", [0, 0.0, -0.0, 5e-324, 0.2, 7, np.float32(0.5), [0.1, 0.2], np.arange(3)])
def test_friction_that_is_accepted(friction: Any) -> None:
    assert Scene(ARC, friction).friction is friction


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"arc": None}, "arc = None: must be an Arc"),
        ({"friction": -0.1}, "friction = -0.1: must be a friction coefficient, tan(phi)"),
        ({"friction": -5e-324}, "friction = -4.940656458e-324:"),  # the smallest of all
        ({"friction": np.nan}, "friction = nan:"),
        ({"friction": np.inf}, "friction = inf:"),
        ({"friction": [0.1, -0.2]}, "friction = -0.2:"),
        ({"friction": "0.1"}, "friction = '0.1':"),
        ({"friction": None}, "friction = None:"),
        ({"friction": True}, "friction = True:"),
        ({"initial_velocity": np.nan}, "initial_velocity = nan: must be a velocity in m/s"),
        ({"initial_velocity": -np.inf}, "initial_velocity = -inf:"),
        ({"initial_velocity": 1j}, "initial_velocity = 1j:"),
        *(({"end_time": x}, f"end_time = {x:.10g}: must be a positive time in s") for x in (0.0, -1.0, np.nan, np.inf)),
        ({"end_time": "30 s"}, "end_time = '30 s':"),
        *(({"accuracy": x}, f"accuracy = {x:.10g}: must be a relative error betw") for x in (0.0, 1.0, -1e-9, np.nan)),
        ({"effects": "centripetal"}, "effects = 'centripetal': must be a list of names"),
        ({"effects": None}, "effects = None:"),
        ({"effects": 5}, "effects = 5:"),
        ({"effects": ["sinking"]}, "effects: 'sinking' is unknown; known are "),
        ({"effects": {"centripetal": {"mass": 1.0}}}, "effects.centripetal: 'mass' is unknown; known are none"),
        ({"effects": {"centripetal": None}}, "effects.centripetal = None: must be a mapping of parameters"),
    ],
)
def test_what_is_refused(changes: dict[str, Any], said: str) -> None:
    slope: dict[str, Any] = {"arc": ARC, "friction": 0.2, "name": "slope"}
    with pytest.raises(ValueError, match=r"^Scene slope: ") as caught:
        Scene(**(slope | changes))
    assert said in str(caught.value)


RATE = {"law": "rate_weakening", "peak": 0.41, "residual": 0.2, "velocity": 0.5}
REFUSED: list[tuple[Any, Any, str]] = [
    (0.3, {"shaking": {}}, "one of horizontal, pulse, record is missing"),
    (0.3, {"shaking": {"pulse": "sine"}}, "amplitude is missing"),
    (0.3, {"shaking": {"pulse": "saw", "amplitude": 0.1, "duration": 1.0}}, "must be one of rectangular, half-sine"),
    (0.3, {"shaking": {"pulse": "sine", "amplitude": 0.1, "duration": 0.0}}, "duration = 0"),
    (0.3, {"shaking": {"pulse": "sine", "amplitude": math.nan, "duration": 1.0}}, "amplitude = nan"),
    (0.3, {"shaking": {"pulse": "sine", "amplitude": 0.1, "duration": 1.0, "scale": 2.0}}, "scale does not belong"),
    (0.3, {"shaking": {"pulse": "sine", "record": "x.csv"}}, "exclude each other"),
    (0.3, {"shaking": {"record": "x.csv"}}, 'must say whether it holds "ground" or "driving"'),
    (0.3, {"shaking": {"record": "nowhere.csv", "holds": "ground"}}, "nowhere.csv"),
    (0.3, {"shaking": {"horizontal": Pulse("sine", 0.1, 0.0, 1.0), "two_way": 1}}, "two_way = 1: must be True"),
    (0.3, {"shaking": {"horizontal": 0.1}}, "horizontal = 0.1: must be a function of time"),
    (0.3, {"shaking": {"horizontal": math.sin}}, "must be a function of time"),
    (0.3, {"pore_pressure": {"pressure": 1.0, "time": [1.0, 2.0]}}, "time and ratio or pressure: must be lists"),
    (0.3, {"pore_pressure": {"record": "x.csv", "time": [1.0, 2.0]}}, "x.csv"),
    (0.3, {"pore_pressure": {"pressure": [1.0, 2.0], "time": [1.0, 1.0]}}, "repeats"),
    (0.3, {"viscosity": {"viscosity": -1.0, "thickness": 1.0}}, "viscosity = -1"),
    (0.3, {"viscosity": {"viscosity": 1.0}}, "'thickness' is missing"),
    (RATE | {"velocity": 0.0}, {}, "friction.velocity = 0"),
    ({"law": "rate_tabulated", "speed": [0.0, 1.0], "coefficient": [1, 1]}, {}, "friction.speed = 0"),
    ({"law": "prescribed", "time": [1.0, 0.5], "coefficient": [1, 1]}, {}, "friction.time: must increase"),
    (RATE | {"rate": RATE}, {}, "rate_weakening is no law of slip"),
    ({"law": "constant", "coefficient": 0.3, "rate": {"law": "linear"}}, {}, "friction.rate.law = 'linear'"),
    ({"law": "constant", "coefficient": 0.3, "rate": 2.0}, {}, "friction.rate = 2.0: must be a law of speed"),
]  # fmt: skip


@pytest.mark.parametrize(("friction", "effects", "said"), REFUSED, ids=[r[2][:30] for r in REFUSED])
def test_laws_and_effects_that_are_refused(friction: Any, effects: Any, said: str) -> None:
    with pytest.raises(ValueError, match=r"^Scene: ") as caught:
        Scene(ARC, friction, effects)
    assert said in str(caught.value)
    assert str(caught.value).count("\n") == 0


def test_all_mistakes_are_listed_at_once() -> None:
    with pytest.raises(ValueError, match=r"^Scene: ") as caught:
        Scene(ARC, -1.0, ("sinking", "flying"), np.nan, -2.0, 3.0)
    for part in ("friction = -1:", "'sinking'", "'flying'", "initial_velocity = nan", "end_time = -2:", "accuracy = 3"):
        assert part in str(caught.value)


def test_scenes_that_ship() -> None:
    for name in shipped():
        scene = load(name)
        assert scene.name == name
        assert scene.note
    with pytest.raises(ValueError, match=r"'viaont' is unknown; known are .*; did you mean vaiont\?$") as caught:
        load("viaont")
    assert all(name in str(caught.value) for name in shipped())


# --- plans ---------------------------------------------------------------------------------------------------------


def test_accuracy_of_the_call_wins() -> None:
    scene = Scene(ARC, 0.2, accuracy=1e-6)
    assert plan(Scene(ARC, 0.2)).accuracy == 1e-9
    assert plan(scene).accuracy == 1e-6
    assert plan(scene, 1e-3).accuracy == 1e-3


@pytest.mark.parametrize("accuracy", [0.0, 1.0, -1.0, np.nan, np.inf, "high"])
def test_accuracy_that_is_refused(accuracy: Any) -> None:
    with pytest.raises(ValueError, match=r"accuracy = .*: must be a relative error between 0 and 1"):
        plan(Scene(ARC, 0.2), accuracy)
