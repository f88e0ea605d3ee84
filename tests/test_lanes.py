"""Ensembles: every lane is the scene solved by itself, whatever its neighbours are."""

import json
import math
from collections import defaultdict
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from slipcircle.arrays import lanes as lanes_module
from slipcircle.arrays import paths as paths_module
from slipcircle.arrays import swings as swings_module
from slipcircle.arrays.block import NAMES, Block, Status
from slipcircle.arrays.lanes import LANES, solve_block
from slipcircle.arrays.motions import Motions, lane
from slipcircle.arrays.panels import turned

from slipcircle import Arc, Motion, Scene, load, solve

VAIONT = load("vaiont").arc
TURNING: Mapping[str, Any] = {"rotation": {}, "centripetal": {}}
SIZES = ("radius", "theta_1", "theta_2", "unit_weight")
STATES = ("time", "rotation", "angular_velocity", "velocity", "displacement", "acceleration", "normal_stress")
EFFECTS: tuple[Mapping[str, Any], ...] = (
    TURNING,
    {"rotation": {}},
    {"centripetal": {}},
    {},
    {"rotation": {}, "pore_pressure": {"ratio": None}},
    {"rotation": {}, "centripetal": {}, "drag": {"xi": None}},
    {"rotation": {}, "centripetal": {}, "cohesion": {"cohesion": None}, "pore_pressure": {"pressure": None}},
    {"centripetal": {}, "cohesion": {"cohesion": None}, "pore_pressure": {"ratio": None}, "drag": {"xi": None}},
    {"rotation": {}, "centripetal": {}, "cohesion": {"cohesion": None}, "pore_pressure": {"ratio": None},
     "drag": {"xi": None}},
)  # fmt: skip


def arcs(rng: np.random.Generator, n: int) -> Arc:
    """Thin ones, half discs and all between, dips of both signs up to upright."""
    alpha = np.minimum(10 ** rng.uniform(-5, 0.25, n), np.pi / 2)
    middle = 1.5 * np.pi - rng.uniform(-1.5, 1.5, n)
    alpha[::11] = np.pi / 2
    return Arc(10 ** rng.uniform(0, 3.5, n), middle - alpha, middle + alpha, rng.uniform(15e3, 27e3, n))


def drawn(effects: Mapping[str, Any], seed: int, n: int, ends: bool) -> Scene:
    """A random ensemble; lanes of which some would swing thousands of times have an end."""
    rng = np.random.default_rng(seed)
    arc = arcs(rng, n)
    half = np.asarray(arc.half_angle)
    sizes = {
        "ratio": rng.uniform(0, 1, n) ** 0.2 * (1 - 1e-9),
        "pressure": arc.reference_stress * 10 ** rng.uniform(-4, -1.5, n),
        "cohesion": arc.reference_stress * 10 ** rng.uniform(-5, -1.5, n),
        "xi": 10 ** rng.uniform(1, 4, n) / half**2,
    }
    given = {e: {k: sizes[k] for k in parameters} for e, parameters in effects.items()}
    mu = np.tan(np.minimum(np.abs(arc.limit_friction_angle), 1.4) * rng.uniform(0.2, 1.05, n))
    mu[::17] = 0.0
    velocity = np.where(rng.random(n) < 0.4, rng.normal(0, 0.3, n) * np.sqrt(arc.radius), 0.0)
    end = arc.time_scale * 10 ** rng.uniform(-2, 1, n)
    return Scene(arc, mu, given, velocity, end if ends or "rotation" not in effects else 300 * arc.time_scale)


LAWS = ("exponential", "linear", "hyperbolic", "tabulated")


def softened(law: str, effects: Mapping[str, Any], seed: int, n: int, ends: bool) -> Scene:
    """The same with friction that falls or grows with slip, over lengths much shorter and longer than the motion."""
    scene = drawn(effects, seed, n, ends)
    rng = np.random.default_rng(seed + 100)
    mu, radius = np.asarray(scene.friction), np.asarray(scene.arc.radius)
    friction: dict[str, Any] = {"peak": mu, "residual": mu * rng.uniform(0, 1.1, n) ** 0.5,
                                "length": radius * 10 ** rng.uniform(-5, 0.5, n)}  # fmt: skip
    if law == "tabulated":
        shares = np.array([1.1, 0.9, 0.95, 0.5, 0.6])  # rises in between
        friction = {"slip": [0.0, 0.4, 1.0, 5.0, 30.0], "coefficient": (shares * np.median(mu)).tolist()}
    return replace(scene, friction={"law": law} | friction)


def alone(scene: Scene, k: int, accuracy: float) -> Motion | None:
    try:
        return solve(lane(scene, k), accuracy)
    except ValueError:
        return None


def compare(scene: Scene, lanes: Any, accuracy: float = 1e-13, bound: float = 4e-13) -> Motions:
    """Lanes against the scalar solver: what is decided exactly, numbers within rounding, grown as both know."""
    found: Motions = solve(scene, accuracy)
    for k in lanes:
        single = alone(scene, k, accuracy)
        if single is None:
            assert found.status[k] == Status.FAILED
            assert math.isnan(found.duration[k])
            continue
        assert (found.moves[k], found.arrested[k]) == (single.moves, single.arrested), k
        error = bound + 4 * single.error_estimate + 2 * float(found.error_estimate[k])
        if error > 1e-3:  # rounding decides it
            continue
        peak = abs(single.peak.velocity)
        law = lane(scene, k).friction
        frictionless = law == 0.0 or (isinstance(law, dict) and law.get("peak") == 0.0)  # all swings are as fast
        assert found.duration[k] == pytest.approx(single.duration, rel=error, abs=0.0), k
        assert found.run_out[k] == pytest.approx(single.run_out, rel=error, abs=1e-300), k
        assert abs(found.peak.velocity[k]) == pytest.approx(peak, rel=error, abs=1e-300), k
        assert found.end.velocity[k] == pytest.approx(single.end.velocity, rel=error, abs=error * peak), k
        if not frictionless:
            # The peak is flat: its place is as good as the root of that of the speed, unless it is a root itself.
            assert found.peak.time[k] == pytest.approx(
                single.peak.time, rel=100 * error, abs=error * single.duration
            ), k
            assert found.peak.normal_stress[k] == pytest.approx(single.peak.normal_stress, rel=100 * error), k
    return found


# --- agreement -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("ends", [False, True], ids=["long", "ends"])
@pytest.mark.parametrize("effects", EFFECTS, ids=lambda e: "-".join(e) or "none")
def test_lanes_are_scenes(effects: Mapping[str, Any], ends: bool) -> None:
    """Random scenes, hard ones among them, whose numbers are drawn together."""
    scene = drawn(effects, 20 + len(effects), 700, ends)
    found = compare(scene, range(0, 700, 9))
    assert not np.any(found.status == Status.INVALID)
    answered = found.status != Status.FAILED
    for name in STATES:
        for state in (found.end, found.peak):
            assert np.all(np.isfinite(getattr(state, name)) == answered)
    assert np.all(np.isfinite(found.error_estimate) == answered)


@pytest.mark.parametrize("effects", EFFECTS, ids=lambda e: "-".join(e) or "none")
@pytest.mark.parametrize("law", LAWS)
def test_softening_lanes_are_scenes(law: str, effects: Mapping[str, Any]) -> None:
    """Random scenes with every law of slip, by another method: collocation or a closed form, one by one."""
    ends = (LAWS.index(law) + len(effects)) % 2 == 0
    found = compare(softened(law, effects, 40 + len(effects), 200, ends), range(0, 200, 41))
    assert np.all((found.status == Status.FAILED) == np.isnan(found.duration))


@pytest.mark.parametrize("law", LAWS)
def test_ordinary_softening_needs_no_scalar_solver(law: str, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: Any) -> None:
        raise AssertionError("a lane went to the scalar solver")

    monkeypatch.setattr(lanes_module, "_alone", refuse)
    for effects in EFFECTS[:2]:
        found = solve(softened(law, effects, 7, 300, True))
        assert np.count_nonzero(found.moves) > 200
        assert np.count_nonzero(found.status == Status.ILL_CONDITIONED) < 10


def test_extreme_lanes_among_ordinary_ones() -> None:
    """Softening within micrometres or never, at the limit and beyond, at great speed: each its own, none in the way."""
    limit = float(VAIONT.dimensionless.limit_friction)
    rows = [(0.4, 0.18, 1.0, 0.0), (0.4, 0.18, 1e-6, 0.0), (0.4, 0.18, 1e9, 0.0), (0.4, 0.4, 1.0, 0.0),
            (limit, 0.18, 1.0, 0.0), (limit * (1 - 1e-9), 0.18, 1.0, 0.0), (0.6, 0.18, 1.0, 0.0),
            (0.6, 0.18, 1.0, 1e-3), (0.6, 0.18, 1.0, 20.0), (0.1, 0.4, 30.0, 0.0), (0.4, 0.05, 0.1, -5.0),
            (0.4, 0.18, 1.0, 120.0), (0.4, 0.18, 1.0, 1e4)]  # fmt: skip
    peak, residual, length, velocity = np.array(rows).T
    for law in LAWS[:3]:
        friction = {"law": law, "peak": peak, "residual": residual, "length": length}
        found = compare(Scene(VAIONT, friction, TURNING, velocity), range(len(rows)))
        assert {Status(s).name for s in found.status} >= {"RESTS", "STAYS", "FAILED"}
        near = found.error_estimate[5]
        assert 1e-10 < near < 1e-5, "next to the limit rounding of the drive counts"


def test_at_the_limit_and_one_ulp_to_either_side() -> None:
    """Whether a mass moves is decided as by the scalar solver, to the last bit."""
    arc = arcs(np.random.default_rng(3), 150)
    limit = np.abs(arc.dimensionless.limit_friction)
    mu = np.array([np.nextafter(limit, 0), limit, np.nextafter(limit, 9), limit * (1 - 1e-9), 0 * limit])
    scene = Scene(arc, mu, TURNING, end_time=1.0)
    found = solve(scene)
    assert found.shape == (5, 150)
    np.testing.assert_array_equal(found.moves, mu < limit)
    for k in range(0, 150, 10):
        for row in range(5):
            assert found.moves[row, k] == solve(lane(scene, row, k)).moves
    for effects in ({"rotation": {}, "pore_pressure": {"ratio": 0.4}}, {"cohesion": {"cohesion": 1e3}}):
        called = {e: dict(given) for e, given in effects.items()}
        limits = np.array([solve(Scene(a, 9.0, called, end_time=1.0)).limit_friction for a in singles(arc, 30)])
        ulps = np.array([np.nextafter(limits, -9), limits, np.nextafter(limits, 9)])
        mu = np.maximum(ulps, 0.0)
        found = solve(Scene(first(arc, 30), mu, called, end_time=1.0))
        np.testing.assert_array_equal(found.moves, mu < limits)


def first(arc: Arc, n: int) -> Arc:
    radius, theta_1, theta_2, unit_weight = (np.asarray(getattr(arc, f))[:n] for f in SIZES)
    return Arc(radius, theta_1, theta_2, unit_weight)


def singles(arc: Arc, n: int) -> list[Arc]:
    columns = (np.asarray(getattr(arc, f))[:n].tolist() for f in SIZES)
    return [Arc(*row) for row in zip(*columns, strict=True)]


@pytest.mark.parametrize("accuracy", [1e-3, 1e-5, 1e-9, 1e-12])
def test_the_accuracy_asked_for(accuracy: float) -> None:
    """Times are off by less, also for swings through the half circle; peak and run-out do not depend on it."""
    dips, friction = np.radians(np.linspace(5, 80, 40)), np.tan(np.radians(np.linspace(0.5, 30, 30)))[:, None]
    middle = 1.5 * np.pi - dips
    scene = Scene(Arc(100.0, middle - 0.6, middle + 0.6, 2e4), friction, TURNING, end_time=1e4)
    found, exact = solve(scene, accuracy), solve(scene, 1e-14)
    well = exact.moves & (exact.error_estimate < max(accuracy / 10, 4e-13))
    assert np.count_nonzero(well) > 500
    for name, rounding in (("duration", 0.0), ("peak", 1e-12)):  # the peak is flat, and so its place rounded more
        one, two = (x.duration if name == "duration" else x.peak.time for x in (found, exact))
        np.testing.assert_allclose(one[well], two[well], rtol=accuracy + rounding)
    np.testing.assert_allclose(found.run_out[well], exact.run_out[well], rtol=1e-12)
    np.testing.assert_allclose(found.peak.velocity[well], exact.peak.velocity[well], rtol=1e-12)


def test_references() -> None:
    """The 30-digit references whose friction is constant or changes with slip, one ensemble for each combination."""
    records = json.loads(Path(__file__).with_name("references.json").read_text("utf-8"))
    groups: dict[str, list[Any]] = defaultdict(list)
    for record in records:
        given = record["scene"]
        law: Any = given["friction"] if isinstance(given["friction"], dict) else {"law": "constant"}
        law = law if law["law"] == "tabulated" else law["law"]  # tables are no axis
        names = [(e, *sorted(p)) for e, p in sorted(given["effects"].items())]
        groups[json.dumps([names, law, given.get("end_time") is None])].append(record)
    seen = 0
    for members in groups.values():
        scenes = [r["scene"] for r in members]
        sizes: dict[str, Any] = {n: np.array([s["arc"][n] for s in scenes]) for n in scenes[0]["arc"]}
        arc = Arc(**sizes)
        effects = {
            e: {n: np.array([s["effects"][e][n] for s in scenes]) for n in given}
            for e, given in scenes[0]["effects"].items()
        }
        end = None if scenes[0].get("end_time") is None else np.array([s["end_time"] for s in scenes])
        friction: Any = scenes[0]["friction"]
        if not isinstance(friction, dict):
            friction = np.array([s["friction"] for s in scenes])
        elif friction["law"] != "tabulated":
            numbers = {n: np.array([s["friction"][n] for s in scenes]) for n in friction if n != "law"}
            friction = friction | numbers
        velocity = np.array([s["initial_velocity"] for s in scenes])
        found = solve(Scene(arc, friction, effects, velocity, end), 1e-13)
        for k, record in enumerate(members):
            wanted = record["reference"]
            bound = 1e-14 + float(found.error_estimate[k])
            assert found.moves[k] == wanted["moves"]
            assert found.arrested[k] == wanted["arrested"]
            assert found.duration[k] == pytest.approx(float(wanted["duration"]), rel=bound)
            assert found.run_out[k] == pytest.approx(float(wanted["run_out"]), rel=bound)
            assert abs(found.peak.velocity[k]) == pytest.approx(abs(float(wanted["peak_velocity"])), rel=bound)
            seen += bound < 1e-11
    assert seen > 160


# --- shapes ----------------------------------------------------------------------------------------------------------


def test_broadcast() -> None:
    scene = Scene(
        replace(VAIONT, radius=np.array([[300.0], [400.0], [500.0]])), np.array([0.1, 0.2, 0.3, 0.9]), TURNING
    )
    found = solve(scene)
    for values in (found.status, found.moves, found.arrested, found.duration, found.run_out, found.peak.velocity,
                   found.end.time, found.peak.normal_stress, found.error_estimate):  # fmt: skip
        assert np.shape(values) == (3, 4)
    for i, j in np.ndindex(3, 4):
        single = solve(lane(scene, i, j))
        assert found.duration[i, j] == pytest.approx(single.duration, rel=1e-13)
        assert found.run_out[i, j] == pytest.approx(single.run_out, rel=1e-13)
    assert found.count() == {"RESTS": 6, "STAYS": 3, "TURNED": 3}
    with pytest.raises(ValueError, match="shapes do not fit together"):
        Scene(replace(VAIONT, radius=np.ones(3)), np.array([0.1, 0.2]), TURNING)


def test_one_scene_and_none() -> None:
    """Arrays without a dimension are numbers; an ensemble of none is one too."""
    assert isinstance(solve(Scene(VAIONT, np.array(0.2), TURNING)), Motion)
    found = solve(Scene(VAIONT, np.zeros((0, 3)), TURNING))
    assert found.duration.shape == found.peak.velocity.shape == (0, 3)
    assert found.count() == {}


@pytest.mark.parametrize(
    ("field", "scene"),
    [
        ("velocity", Scene(VAIONT, 0.2, TURNING, initial_velocity=np.array([0.0, 1.0, -3.0]))),
        ("end", Scene(VAIONT, 0.2, TURNING, end_time=np.array([0.05, 10.0, 900.0]))),
        ("water", Scene(VAIONT, 0.2, {"rotation": {}, "pore_pressure": {"ratio": np.array([0.0, 0.2, 0.4])}})),
        ("law", Scene(VAIONT, {"law": "constant", "coefficient": np.array([0.1, 0.2, 0.3])}, TURNING)),
        ("softening", Scene(VAIONT, {"law": "linear", "peak": 0.3, "residual": np.array([0.1, 0.2, 0.3]),
                                     "length": 5.0}, TURNING)),
    ],
    ids=lambda x: x if isinstance(x, str) else "",
)  # fmt: skip
def test_any_field_may_be_an_array(field: str, scene: Scene) -> None:
    compare(scene, range(3))


def test_given_coefficients_are_no_axis() -> None:
    printed = load("vaiont-as-printed")
    scene = replace(printed, friction=np.array([0.1, 0.3]))
    found = solve(scene)
    for k in range(2):
        assert found.run_out[k] == pytest.approx(solve(lane(scene, k)).run_out, rel=1e-14)
    given: dict[str, Any] = dict(printed.arc.given or {}) | {"radial_weight": np.array([0.1, 0.2])}
    with pytest.raises(ValueError, match=r"given.radial_weight: must be one number"):
        replace(printed.arc, given=given)


# --- lanes do not know of each other ---------------------------------------------------------------------------------


def block(**values: Any) -> Block:
    names = ("radius", "theta_1", "theta_2", "unit_weight", "gravity")
    known = {n: float(getattr(VAIONT, n)) for n in names} | {"initial_velocity": 0.0, "end_time": np.inf}
    return solve_block(("rotation", "centripetal"), known | values, 1e-9)


def test_a_bad_lane_spoils_no_other() -> None:
    n = 700
    mu = np.tan(np.radians(np.linspace(9, 20, n)))
    good = block(friction=mu, theta_1=np.full(n, VAIONT.theta_1))
    bad = {"friction": mu.copy(), "theta_1": np.full(n, VAIONT.theta_1)}
    spoilt = {3: np.nan, 77: -1.0, 78: np.inf}
    for k, value in spoilt.items():
        bad["friction"][k] = value
    turned = {5: 7.0, 400: 0.0, 401: np.nan, 402: -9.0}
    for k, value in turned.items():
        bad["theta_1"][k] = value
    mixed = block(**bad)
    wrong = np.zeros(n, bool)
    wrong[[*spoilt, *turned]] = True
    assert np.all(mixed.status[wrong] == Status.INVALID)
    for name in NAMES:
        np.testing.assert_array_equal(getattr(mixed, name)[~wrong], getattr(good, name)[~wrong])
        if getattr(good, name).dtype == np.float64:
            assert np.all(np.isnan(getattr(mixed, name)[wrong]))


def test_a_bad_softening_lane_spoils_no_other() -> None:
    n = 300
    law = {"law": "exponential", "peak": 0.4, "residual": 0.2, "length": 1.0}
    known = {n: getattr(VAIONT, n) for n in ("radius", "theta_1", "theta_2", "unit_weight", "gravity")}
    known |= {"initial_velocity": 0.0, "end_time": np.inf}

    def solved(peak: Any, length: Any) -> Block:
        values = known | {"friction.peak": peak, "friction.residual": 0.2, "friction.length": length}
        return solve_block(("rotation", "centripetal"), values, 1e-9, law)

    peak, length = np.linspace(0.3, 0.45, n), np.geomspace(0.01, 100.0, n)
    good, wrong = solved(peak, length), {3: np.nan, 77: -1.0, 78: np.inf, 200: 0.0}
    for k, value in wrong.items():
        peak[k], length[k] = (value, 1.0) if k < 200 else (0.4, value)
    mixed, bad = solved(peak, length), np.isin(np.arange(n), list(wrong))
    assert np.all(mixed.status[bad] == Status.INVALID)
    for name in NAMES[1:]:
        np.testing.assert_allclose(getattr(mixed, name)[~bad], getattr(good, name)[~bad], rtol=1e-13, atol=1e-300)


def test_a_lane_is_the_same_in_any_block() -> None:
    n = 2 * LANES + 100
    mu = np.tan(np.radians(np.random.default_rng(1).uniform(3, 24, n)))
    whole = block(friction=mu)
    for part in (slice(0, 10), slice(LANES - 5, LANES + 5), slice(n - 3, n)):
        some = block(friction=mu[part])
        for name in NAMES[3:-1]:
            np.testing.assert_allclose(getattr(some, name), getattr(whole, name)[part], rtol=1e-13, atol=1e-13)


def test_status() -> None:
    limit = float(VAIONT.dimensionless.limit_friction)
    scene = Scene(VAIONT, np.array([0.2, 0.5, 0.02, limit * (1 - 1e-12), 0.0]), TURNING)
    names = [Status(s).name for s in solve(scene).status]
    assert names == ["RESTS", "STAYS", "TURNED", "ILL_CONDITIONED", "MOVING"]
    frozen = solve(Scene(VAIONT, np.array([0.2, 0.5]), ("centripetal",)))
    assert [Status(s).name for s in frozen.status] == ["FAILED", "STAYS"]
    assert np.isnan(frozen.duration[0])
    over = solve(Scene(VAIONT, 0.2, TURNING, initial_velocity=np.array([1.0, 300.0, 1e200])))
    assert [Status(s).name for s in over.status] == ["RESTS", "FAILED", "FAILED"]
    ends = solve(Scene(VAIONT, 0.2, TURNING, end_time=np.array([5.0, 900.0])))
    assert [Status(s).name for s in ends.status] == ["MOVING", "RESTS"]


# --- the tests see ---------------------------------------------------------------------------------------------------


def test_a_planted_bug_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    """A quadrature of too few points that thinks itself exact."""
    terms = swings_module._terms

    def few(rest: Any, points: int) -> Any:
        found, missing = terms(rest, 5)
        return np.concatenate([found, np.zeros((points - 5, found.shape[1]))]), 0.0 * missing

    scene = drawn(TURNING, 5, 300, False)
    compare(scene, range(0, 300, 10))
    monkeypatch.setattr(swings_module, "_terms", few)
    with pytest.raises(AssertionError):
        compare(scene, range(0, 300, 10))


def test_a_planted_start_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    """The brake, forgotten in the series."""
    series = swings_module._series
    monkeypatch.setattr(
        swings_module, "_series", lambda begin, work: series(begin._replace(brake=0.999 * begin.brake), work)
    )
    with pytest.raises(AssertionError):
        compare(drawn(TURNING, 5, 300, False), range(0, 300, 10))


def test_planted_panels_are_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    """Panels that all think themselves resolved; and a mass that weighs a billionth less where it has turned."""
    scene = Scene(
        VAIONT, {"law": "exponential", "peak": np.linspace(0.3, 0.41, 8), "residual": 0.18, "length": 1.0}, TURNING
    )
    compare(scene, range(8))
    with monkeypatch.context() as patch:
        for name in ("LAST", "LAST_FROM_REST", "LAST_TO_REST"):
            patch.setattr(paths_module, name, 0.0 * getattr(paths_module, name))
        patch.setattr(paths_module, "_FIRST", 5.0)
        patch.setattr(paths_module, "_WIDEST", 9.0)
        with pytest.raises(AssertionError):
            compare(scene, range(8))
    monkeypatch.setattr(
        "slipcircle.arrays.paths.turned", lambda angle: (turned(angle)[0], turned(angle)[1] * (1 + 1e-9))
    )
    with pytest.raises(AssertionError):
        compare(scene, range(8))
