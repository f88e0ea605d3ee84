"""Accepted and refused arguments of scenes and of calls from Python."""

import math
import re
import warnings
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import slipcircle
from slipcircle import Arc, Scene, load, plan, solve
from slipcircle.base.errors import UnusualInput
from slipcircle.tables import Pulse
from slipcircle.workbench.files.scenefile import load as read
from slipcircle.workbench.files.shipped import shipped
from tests.support import vaiont
from tests.support.motions import from_method

FOLDER = Path(slipcircle.__file__).parent / "scenes"
ARC = Arc(800.0, 3.8, 5.0, 21e3)


def test_effects_by_name_or_as_a_mapping() -> None:
    mapping = Scene(ARC, 0.2, {"centripetal": {}})
    assert mapping.effects == {"centripetal": {}}
    for names in (("centripetal",), ["centripetal"], {"centripetal"}, iter(["centripetal"])):
        assert Scene(ARC, 0.2, names) == mapping
    assert Scene(ARC, 0.2) == Scene(ARC, 0.2, {}) == Scene(ARC, 0.2, ())
    assert Scene(ARC, 0.2) != mapping


@pytest.mark.parametrize("friction", [0, 0.0, -0.0, 5e-324, 0.2, 7, np.float32(0.5), [0.1, 0.2], np.arange(3)])
def test_friction_that_is_accepted(friction: Any) -> None:
    """One number stays what it is; of several the scene has a copy of its own, which cannot be changed."""
    own: Any = Scene(ARC, friction).friction
    if np.ndim(friction) == 0:
        assert own == friction
        return
    np.testing.assert_array_equal(own, friction)
    with pytest.raises((TypeError, ValueError)):
        own[0] = 9.0


RATE = {"law": "rate_weakening", "peak": 0.41, "residual": 0.2, "velocity": 0.5}
REFUSED: list[tuple[Any, Any, str]] = [
    (0.3, {"shaking": {}}, "one of horizontal, pulse, record is missing"),
    (0.3, {"shaking": {"pulse": "sine"}}, "amplitude is missing"),
    (0.3, {"shaking": {"pulse": "saw", "amplitude": 0.1, "duration": 1.0}}, "must be one of rectangular, half-sine"),
    (0.3, {"shaking": {"pulse": "sine", "amplitude": 0.1, "duration": 0.0}}, "duration = 0"),
    (0.3, {"shaking": {"pulse": "sine", "amplitude": math.nan, "duration": 1.0}}, "amplitude = nan"),
    (0.3, {"shaking": {"pulse": "sine", "amplitude": 0.1, "duration": 1.0, "scale": 2.0}}, "scale does not belong"),
    (0.3, {"shaking": {"record": "x.csv"}}, "file names are for scene files; in Python use horizontal"),
    (0.3, {"shaking": {"horizontal": Pulse("sine", 0.1, 0.0, 1.0), "two_way": 1}}, "two_way = 1: must be True"),
    (0.3, {"shaking": {"horizontal": 0.1}}, "horizontal = 0.1: must be a function of time"),
    (0.3, {"shaking": {"horizontal": math.sin}}, "must be a function of time"),
    (0.3, {"pore_pressure": {"pressure": 1.0, "time": [1.0, 2.0]}}, "time and ratio or pressure: must be lists"),
    (0.3, {"pore_pressure": {"record": "x.csv"}}, "record: file names are for scene files"),
    (0.3, {"pore_pressure": {"pressure": [1.0, 2.0], "time": [1.0, 1.0]}}, "repeats"),
    (0.3, {"viscosity": {"viscosity": -1.0, "thickness": 1.0}}, "viscosity = -1"),
    (0.3, {"viscosity": {"viscosity": 1.0}}, "'thickness' is missing"),
    (RATE | {"velocity": 0.0}, {}, "friction.velocity = 0"),
    ({"law": "rate_tabulated", "speed": [0.0, 1.0], "coefficient": [1, 1]}, {}, "friction.speed = 0"),
    ({"law": "prescribed", "time": [1.0, 0.5], "coefficient": [1, 1]}, {}, "friction.time: must increase"),
    (RATE | {"rate": RATE}, {}, "rate_weakening is not a law of slip"),
    ({"law": "constant", "coefficient": 0.3, "rate": {"law": "linear"}}, {}, "friction.rate.law = 'linear'"),
    ({"law": "constant", "coefficient": 0.3, "rate": 2.0}, {}, "friction.rate = 2.0: must be a law of speed"),
]  # fmt: skip


# --- plans ---------------------------------------------------------------------------------------------------------


CHANGES: list[tuple[dict[str, Any], str]] = [
    ({"arc": None}, "arc = None: must be an Arc"),
    ({"friction": -0.1}, "friction = -0.1: must be a friction coefficient, tan(phi)"),
    ({"friction": -5e-324}, "friction = -4.940656458e-324:"),  # the smallest of all
    ({"friction": [0.1, -0.2]}, "friction = -0.2:"),
    *(({"friction": x}, f"friction = {x!r}:") for x in (np.nan, np.inf, "0.1", None, True)),
    ({"initial_velocity": np.nan}, "initial_velocity = nan: must be a velocity in m/s"),
    *(({"initial_velocity": x}, f"initial_velocity = {x}:") for x in (-np.inf, 1j)),
    *(({"end_time": x}, f"end_time = {x:.10g}: must be a positive time in s") for x in (0.0, -1.0, np.nan, np.inf)),
    ({"end_time": "30 s"}, "end_time = '30 s':"),
    *(({"accuracy": x}, f"accuracy = {x:.10g}: must be a relative error betw") for x in (0.0, 1.0, -1e-9, np.nan)),
    ({"effects": "centripetal"}, "effects = 'centripetal': must be a list of names"),
    *(({"effects": x}, f"effects = {x}:") for x in (None, 5)),
    ({"effects": ["sinking"]}, "effects: 'sinking' is unknown; known are "),
    ({"effects": {"centripetal": {"mass": 1.0}}}, "effects.centripetal: 'mass' is unknown; known are none"),
    ({"effects": {"centripetal": None}}, "effects.centripetal = None: must be a mapping of parameters"),
    *(
        (change, "<class 'float'>: must be a number, a law or a function of slip")
        for change in ({"friction": float}, {"effects": {"cohesion": {"cohesion": float}}})
    ),
    ({"effects": {"cohesion": {"cohesion": 1e30}}}, "cohesion = 1e+30: must be shear strength without"),
    *(({"friction": friction, "effects": effects}, said) for friction, effects, said in REFUSED),
]


@pytest.mark.parametrize(("changes", "said"), CHANGES, ids=[said[:30] for _, said in CHANGES])
def test_what_is_refused(changes: dict[str, Any], said: str) -> None:
    slope: dict[str, Any] = {"arc": ARC, "friction": 0.2, "name": "slope"}
    with pytest.raises(ValueError, match=r"^Scene slope: ") as caught:
        Scene(**(slope | changes))
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)


def test_all_mistakes_are_listed_at_once() -> None:
    with pytest.raises(ValueError, match=r"^Scene: ") as caught:
        Scene(ARC, -1.0, ("sinking", "flying"), np.nan, -2.0, 3.0)
    for part in ("friction = -1:", "'sinking'", "'flying'", "initial_velocity = nan", "end_time = -2:", "accuracy = 3"):
        assert part in str(caught.value)


@pytest.mark.parametrize("bad", [1e103, 5e-324])
def test_bounds_of_files_hold_in_python_too(bad: float) -> None:
    with pytest.raises(ValueError, match=r"radius = .*: must be a positive length in m, between 1e-06 and 1e\+20"):
        Arc(bad, 3.8, 4.9, 2e4)


def test_accuracy_of_the_call_wins() -> None:
    scene = Scene(ARC, 0.2, accuracy=1e-6)
    plans = plan(Scene(ARC, 0.2)), plan(scene), plan(scene, 1e-3)
    assert [p.accuracy for p in plans] == [1e-9, 1e-6, 1e-3]
    with pytest.raises(ValueError, match=r"accuracy = nan: must be a relative error between 0 and 1"):
        plan(Scene(ARC, 0.2), np.nan)


# --- scenes that ship ----------------------------------------------------------------------------------------------


RUN_OUTS = {  # in m, of those that come to rest
    "layered-slope": 4, "newmark-pulse": 0, "real-slope": 10, "shaken-slope": 1, "vaiont": 677,
    "vaiont-as-printed": None, "vaiont-frozen": None, "vaiont-heated": None, "vaiont-rate": 953, "vaiont-shaken": 675,
    "vaiont-softening": 676, "valley-side": 20, "weak-toe": 4, "wet-slope": 8,
}  # fmt: skip
BY_PAPER = {
    "layered-slope": 5.536,
    "real-slope": 10.41,
    "shaken-slope": 0.8721,
    "valley-side": 26.05,
    "weak-toe": 8.872,
}


def test_these_scenes_ship() -> None:
    assert shipped() == tuple(RUN_OUTS)


@pytest.mark.parametrize("name", RUN_OUTS)
def test_every_shipped_scene_is_that_of_its_file_and_moves(name: str) -> None:
    scene, motion = load(name), solve(load(name))
    assert scene == read(FOLDER / f"{name}.toml")
    assert (scene.name, bool(scene.note), motion.moves) == (name, True, True)
    assert motion.arrested == (scene.end_time is None)
    assert (round(motion.run_out) if motion.arrested else None) == RUN_OUTS[name]


@pytest.mark.parametrize("name", BY_PAPER)
def test_shipped_slopes_run_as_far_as_before_from_the_factor_of_the_closure(name: str) -> None:
    """Run-outs of the time when motions had no other start; valley-side with its present strength."""
    assert solve(from_method(load(name), "paper")).run_out == pytest.approx(BY_PAPER[name], rel=5e-4)


def test_the_papers_scenes_hold_the_papers_numbers() -> None:
    arc = vaiont.ARC
    frozen, mu = load("vaiont-frozen"), float(np.tan(np.deg2rad(10.0)))
    assert frozen == Scene(arc, mu, ("centripetal",), 0.0, 30.0, None, "vaiont-frozen", frozen.note)
    assert load("vaiont").called == {"rotation": {}, "centripetal": {}}
    assert load("vaiont-as-printed").arc == Arc(**{f: getattr(arc, f) for f in arc.quantities}, given={
        "moment_of_inertia": 0.4376, "radial_weight": 0.0870, "weight_moment": 0.0387, "resistance_factor": 0.1523,
        "dynamic_coefficient": 0.468,
    })  # fmt: skip


def test_values_that_are_not_the_papers_say_so() -> None:
    """Numbers have a comment, or are in a table whose header has a comment."""
    for path in FOLDER.glob("*.toml"):
        head = ""
        for line in path.read_text("utf-8").splitlines():
            head = line if line.startswith("[") else head
            if re.match(r"\w+ = (?!\")", line):
                assert re.search(r"# .*(Table|section|\(\d|assumed|belongs|integral|estimated)", line + head), (
                    path.name,
                    line,
                )


# --- calls ---------------------------------------------------------------------------------------------------------

VAIONT = load("vaiont")
DRAWN = replace(VAIONT, uncertain={"friction.angle_deg": {"distribution": "normal", "mean": 10, "std": 1}})
ANY: Any = slipcircle  # whose types no checker holds
CHANGED: Any = replace
PRINTED: Any = load("vaiont-as-printed").arc


@pytest.mark.parametrize(
    ("work", "said"),
    [
        *((lambda x=x: ANY.load(x), "scene .*: must be the name of a scene that ships, or the path of a scene file")
          for x in (3, VAIONT)),
        *((lambda f=f, more=more: getattr(ANY, f)("vaiont", *more), r"scene = 'vaiont': must be a Scene; load\('vaiont")
          for f, more in (("solve", ()), ("plan", ()), ("ensemble", (3,)), ("grid", (3,)))),
        (lambda: ANY.solve(None), r"scene = None: must be a Scene; load\(name\)"),
        (lambda: ANY.backanalyse("vaiont", run_out=1.0), r"scene = 'vaiont': must be a Scene; load\('vaiont'\)"),
        *((lambda x=x: ANY.solve(VAIONT, x), "accuracy = .*: must be") for x in ("a", 2, [1e-9])),
        (lambda: CHANGED(VAIONT, accuracy=[1e-9]), "accuracy = .*: must be one number"),
        *((lambda n=n: ANY.ensemble(DRAWN, 3, **{n: "a"}), f"{n} = 'a': must be")
          for n in ("method", "confidence", "size", "sensitivity", "correlation", "rng")),
        (lambda: ANY.grid(VAIONT, 3), "levels = 3: must be a mapping"),
        (lambda: ANY.grid(VAIONT, {"friction.angle": [1.0]}), r"friction\.angle: is not a parameter"),
        (lambda: ANY.grid(VAIONT, {"friction": ["a"]}), "friction: must be a list of numbers"),
        (lambda: ANY.backanalyse(VAIONT, run_out=300.0, field=3), "field = 3, bounds = None: must be a key"),
        (lambda: ANY.backanalyse(VAIONT, run_out=300.0, bounds=3), "bounds = 3: must be a key"),
        (lambda: CHANGED(VAIONT, uncertain=3), "uncertain = 3: must be a mapping"),
        (lambda: CHANGED(VAIONT.arc, given=3), "given = 3: must be a mapping"),
        (lambda: CHANGED(PRINTED, given=PRINTED.given | {"radial_weight": np.ones(2)}), "weight.*: must be one number"),
        (lambda: solve(VAIONT).to_dict("a"), "times = 'a': must be times in s"),
        (lambda: Arc(60.0, 215.0, 276.0, 19e3), "in rad: were they in degrees"),
    ],
)  # fmt: skip
def test_a_call_of_the_wrong_kind_is_one_error(work: Callable[[], Any], said: str) -> None:
    with pytest.raises(ValueError, match=said) as found:
        work()
    assert "\n" not in str(found.value)


def broken(_: Any) -> Any:
    raise KeyError("a")


@pytest.mark.parametrize(
    ("law", "said"),
    [
        (lambda s: np.nan * np.asarray(s), r"\(.*\) = nan: must be a number of at least 0"),
        (lambda s: np.where(np.asarray(s) > 100.0, np.nan, 0.2), r"\(1\d\d.*\) = nan"),
        (lambda s: 0.2 - np.asarray(s) / 100.0, r"\(2.*\) = -0\.\d+: must be a number of at least 0"),
        (lambda s: np.zeros(3), r"returns shape \(3,\) for an argument of shape"),
        (lambda s: 0.2 if s < 10 else 0.1, "must take an array of numbers and return one; it says ValueError"),
        (lambda s: "a", "must take an array of numbers and return one"),
        (lambda s: 1j * np.asarray(s), "it says ValueError: complex numbers"),
        (lambda: 0.2, "it says TypeError"),
        (broken, "it says KeyError"),
        (lambda s: np.inf + np.asarray(s), "= inf: must be"),
        (lambda s: 0.2 + 0.01 * np.random.default_rng().random(np.shape(s)), "changes too sharply"),
    ],
)
def test_a_bad_friction_function_is_one_error(law: Any, said: str) -> None:
    with pytest.raises(ValueError, match=f"^friction.*{said}"):
        solve(Scene(VAIONT.arc, law, ["rotation"]))


@pytest.mark.parametrize(
    ("arc", "friction", "effects", "said"),
    [
        (ARC, 15.0, {}, "friction = 15: is that an angle? The coefficient of 15 deg is 0.2679"),
        (ARC, math.tan(math.radians(0.26)), {}, "an angle of 0.26 deg; was that meant in rad? 0.26 rad are 14.9 deg"),
        (replace(ARC, unit_weight=20.0), 0.3, {}, "unit_weight = 20 N/m^3: is that in kN/m^3? 1 kN/m^3 is 1000 N/m^3"),
        (replace(ARC, unit_weight=2000.0), 0.3, {}, "unit_weight = 2000 N/m^3: is that in kg/m^3?"),
        (ARC, 0.3, {"cohesion": {"cohesion": 2.0}}, "cohesion.cohesion = 2 Pa: is that in kPa? 1 kPa is 1000 Pa"),
        (ARC, 0.3, {"cohesion": {"cohesion": 1e-9}}, "cohesion.cohesion = 1e-09 Pa: soils have at least 50 Pa"),
        (
            replace(ARC, unit_weight=300),
            0.3,
            {},
            "unit_weight = 300 N/m^3: soils have at least 1000 N/m^3; in which unit",
        ),
        (
            ARC,
            {"law": "linear", "peak": 0.5, "residual": 12, "length": 9.0},
            {},
            "friction.residual = 12: is that an an",
        ),
        (ARC, 100, {}, "friction = 100: soils have less than 2"),
        (ARC, 2.0, {"cohesion": {"cohesion": 50.0}}, ""),
        (ARC, 0.3, {"cohesion": {"cohesion": 0.0}}, ""),
    ],
)
def test_numbers_of_an_odd_size_are_questioned(arc: Any, friction: Any, effects: Any, said: str) -> None:
    """The motion warns, and so does Python where the scene is made if the number is far from soils."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        scene = Scene(arc, friction, effects, end_time=1.0)
    in_words = " ".join(solve(scene).warnings)
    assert said in in_words
    assert said or "?" not in in_words
    far = bool(said) and "0.26 deg" not in said and "2000" not in said
    assert {x.filename for x in caught} == ({__file__} if far else set())
    assert all(str(x.message) in in_words for x in caught)
    if far:
        with pytest.warns(UnusualInput, match=re.escape(said)) as of_copy:
            replace(scene, note="a copy")
        assert of_copy[0].filename == __file__


def test_an_ensemble_is_not_questioned() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        Scene(ARC, [1.9, 30.0])
