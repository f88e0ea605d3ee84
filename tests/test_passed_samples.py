"""Samples that are passed without series, beside the exact block, roots by hand, and the same motions by series.

By series goes what has a second function of time: vertical shaking of zero.
"""

import math
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq

from derive.algebra import pieces
from derive.check.proof import ProofError
from derive.flow import sliding
from derive.flow.integrator import records
from generated import integrator, layout
from slipcircle import Arc, Motion, Scene, solve
from slipcircle.tables import LaneSeries, Series
from tests.campaigns import long_records
from tests.support import oracle, taylor
from tests.support.blocks import ARC, GRAVITY, MU, exactly, factor, of_block, quake, series
from tests.support.lanes import BACKENDS, backend

STILL = Series(np.array([0.0, 1000.0]), np.zeros(2))


TURNING: dict[str, Any] = {"rotation": {}, "centripetal": {}}


def shaken(
    horizontal: Series | LaneSeries,
    vertical: Series | None = None,
    mu: Any = MU,
    arc: Arc = ARC,
    effects: dict[str, Any] | None = None,
    **more: Any,
) -> Motion:
    given: dict[str, Any] = {"horizontal": horizontal, **more}
    if vertical is not None:
        given["vertical"] = vertical
    return solve(Scene(arc, mu, {"shaking": given, **(effects or {})}))


@pytest.mark.parametrize("name", BACKENDS)
def test_a_suite_is_that_of_the_exact_block(name: str) -> None:
    """Records at scales in one ensemble: displacements, greatest speeds, last stops, and how often it slides."""
    record = quake(11, 400)
    scales = np.array([0.2, 0.35, 0.5, 0.8, 1.0, 1.7, 2.6])
    with backend(name):
        motion = shaken(record, scale=scales)
        by_series = shaken(record, STILL, scale=scales)
    for k, scale in enumerate(scales):
        places, speeds, stop = of_block(replace(record, values=scale * record.values))
        assert motion.run_out[k] == pytest.approx(places[-1], rel=1e-13)
        assert motion.duration[k] == pytest.approx(stop, rel=1e-13)
        assert motion.peak.velocity[k] >= speeds.max() * (1 - 1e-13)
    assert motion.slips.tolist() == by_series.slips.tolist()
    assert motion.farthest.displacement == pytest.approx(by_series.farthest.displacement, rel=1e-13)
    assert motion.peak.velocity == pytest.approx(by_series.peak.velocity, rel=1e-13)
    assert motion.peak.time == pytest.approx(by_series.peak.time, rel=1e-7)  # where the speed is level


@pytest.mark.parametrize("effects", [{}, TURNING], ids=["frozen", "turning"])
@pytest.mark.parametrize("law", [MU, {"law": "exponential", "peak": MU, "residual": 0.9 * MU, "length": 0.2}])
@pytest.mark.parametrize("name", BACKENDS)
def test_records_side_by_side_are_each_alone(name: str, law: Any, effects: dict[str, Any]) -> None:
    """Bit for bit, in any order: of any length, that end at a jump or not, that start late, and that are held."""
    count = 700 if name == "C" else 200  # NumPy takes a hundred times as long
    short = quake(12, 90)
    late = Series(1.0 + quake(13, count // 2).time, quake(13, count // 2).values)
    cut = Series(short.time, np.where(short.time == short.time[-1], 0.2, short.values), held=False)
    records = quake(11, count), short, late, cut, quake(14, 120)
    which = np.array([3, 0, 1, 4, 2, 0, 3, 1, 2, 4, 4])
    scales = np.linspace(1.0, 3.0, which.size)
    frozen = isinstance(law, float) and not effects
    with backend(name):
        together = shaken(LaneSeries(records, which), mu=law, effects=effects, scale=scales)
        for k, record in enumerate(records):
            lanes = which == k
            alone = shaken(record, mu=law, effects=effects, scale=scales[lanes])
            for outcome in ("run_out", "peak_velocity", "duration"):
                np.testing.assert_array_equal(together.outcomes[outcome][lanes], alone.outcomes[outcome])
            for run_out, scale in zip(alone.run_out, scales[lanes], strict=True):
                if frozen and not record.held:
                    places, _, _ = of_block(replace(record, values=scale * record.values))
                    assert run_out == pytest.approx(places[-1], rel=1e-12)
    assert np.count_nonzero(together.moves) > 5


@pytest.mark.parametrize("radius", [2.0, 9.0, 60.0, 900.0])
@pytest.mark.parametrize("effects", [{"rotation": {}}, TURNING], ids=["turning", "centripetal"])
@pytest.mark.parametrize("name", BACKENDS)
def test_turning_masses_pass_samples_as_by_series(name: str, effects: dict[str, Any], radius: float) -> None:
    """Results agree also where a mass turns back, and where pieces are too long for a few orders.

    Series in NumPy take a second; they serve for one radius, elsewhere those of the default integrator do.
    """
    arc = replace(ARC, radius=radius)
    records = quake(11, 300), quake(14, 120)
    scales = np.array([0.3, 0.5, 1.0, 2.0, 12.0, 0.3, 0.7, 1.5, 4.0])
    suite = LaneSeries(records, np.repeat([0, 1], [5, 4]))
    with backend(name):
        motion = shaken(suite, arc=arc, effects=effects, scale=scales)
    with backend(name if radius == 9.0 else BACKENDS[0]):
        by_series = shaken(suite, STILL, arc=arc, effects=effects, scale=scales)
    assert by_series.slips.max() > 4
    assert motion.slips.tolist() == by_series.slips.tolist()
    assert motion.run_out == pytest.approx(by_series.run_out, rel=1e-11)
    assert motion.duration == pytest.approx(by_series.duration, rel=1e-12)
    assert motion.peak.velocity == pytest.approx(by_series.peak.velocity, rel=1e-11)
    assert motion.peak.displacement == pytest.approx(by_series.peak.displacement, rel=1e-6)  # where the speed is level


@pytest.mark.parametrize("ulps", [-1000, -1, 0, 1, 1000])
@pytest.mark.parametrize("place", [40, 41, 78])
def test_a_sample_at_the_yield_coefficient(ulps: int, place: int) -> None:
    """Among quiet ones, the last but one and one of two: whatever rounding decides, what moves is nothing."""
    gamma, n = factor()
    values = 0.5 * n * np.sin(1.7 * np.arange(80.0))
    values[place] = n * (1.0 + ulps * 2.0**-53)
    alone = shaken(series(0.02 * np.arange(80.0), values))
    assert abs(alone.run_out) < 1e-12 * gamma * GRAVITY
    assert alone.moves == (ulps > 0) or abs(ulps) < 100
    values[45] = 2.0 * n
    record = series(0.02 * np.arange(80.0), values)
    places, _, _ = of_block(record)
    assert shaken(record).run_out == pytest.approx(places[-1], rel=1e-12)


@pytest.mark.parametrize("last", [1.0, 2.0])
@pytest.mark.parametrize("name", BACKENDS)
def test_the_last_samples_count(last: float, name: str) -> None:
    """Nothing happens before the last sample, at which the record ends above the yield coefficient, or is cut off."""
    _, n = factor()
    time = 0.02 * np.arange(200.0)
    record = series(time, np.where(time < time[-1], 0.3 * n, last * 1.5 * n))
    with backend(name):
        motion = shaken(record)
    places, _, stop = of_block(record)
    assert motion.run_out == pytest.approx(places[-1], rel=1e-13)
    assert motion.duration == pytest.approx(stop, rel=1e-13)


@pytest.mark.parametrize("sign", [1.0, -1.0])
@pytest.mark.parametrize("two_way", [False, True])
def test_both_polarities_slide_as_by_series(sign: float, two_way: bool) -> None:
    """Shaken up-slope it starts only if it may, and then as by series."""
    _, n = factor()
    record = quake(5, 400)
    record = replace(record, values=np.where(record.values > 0.9 * n, 0.9 * n, 9.0 * record.values) * sign)
    motion, by_series = (shaken(record, v, two_way=two_way) for v in (None, STILL))
    assert by_series.slips == motion.slips > (0 if two_way or sign < 0 else -1)
    assert motion.run_out == pytest.approx(by_series.run_out, rel=1e-12)
    assert motion.duration == pytest.approx(by_series.duration, rel=1e-12)
    assert (motion.run_out < 0.0) == (two_way and sign > 0.0)


@pytest.mark.parametrize("k", [0.0, 0.03])
def test_friction_that_falls_with_time_starts_it(k: float) -> None:
    """The start in 500 pieces, alone and under a record, is where friction is W (sin + k cos)/(R (cos - k sin))."""
    weight, radial = (float(x) for x in ARC.amplitudes_per_inertia)
    psi = abs(float(ARC.dip))
    time = np.linspace(0.0, 10.0, 501)
    shaking = k * np.sin(11.0 * time)
    limit = weight * math.sin(psi) / (radial * math.cos(psi))
    falls = limit * (1.5 - 0.06 * time + 0.01 * np.sin(7.0 * time))

    def lacking(t: float) -> float:
        now = float(np.interp(t, time, shaking))
        needed = weight * (math.sin(psi) + now * math.cos(psi)) / (radial * (math.cos(psi) - now * math.sin(psi)))
        return float(np.interp(t, time, falls)) - needed

    first = next(j for j in range(500) if lacking(time[j + 1]) < 0.0)
    start = brentq(lacking, time[first], time[first + 1], xtol=1e-15, rtol=1e-15)
    law = {"law": "prescribed", "time": time, "coefficient": falls}
    effects = {"shaking": {"horizontal": series(time, shaking)}} if k else {}
    motion = solve(Scene(ARC, law, effects, end_time=10.0))
    assert motion.phases[0].start == pytest.approx(start, rel=1e-12)


@pytest.mark.parametrize("name", BACKENDS)
def test_friction_of_time_under_a_record(name: str) -> None:
    """It starts while the record is zero, and a pulse slows it while its friction grows: Gauss's rule is exact."""
    weight, radial = (float(x) for x in ARC.amplitudes_per_inertia)
    psi = abs(float(ARC.dip))
    time = 0.02 * np.arange(200.0)
    mu = weight * math.tan(psi) / radial * np.interp(time, [0.0, 2.0, 4.0], [1.5, 0.8, 0.95])
    k = np.where((time > 2.21) & (time < 2.29), -0.02, 0.0)

    def acceleration(t: Any) -> Any:
        shaking, friction = np.interp(t, time, k), np.interp(t, time, mu)
        normal = math.cos(psi) - shaking * math.sin(psi)
        return GRAVITY * (weight * (math.sin(psi) + shaking * math.cos(psi)) - friction * radial * normal)

    start = brentq(acceleration, 1.0, 2.0, xtol=1e-14)
    knots = np.array([start, *time[time > start]])
    places, weights = np.polynomial.legendre.leggauss(3)
    half = np.diff(knots)[:, None] / 2.0
    t = knots[:-1, None] + half * (1.0 + places)
    changes = half * weights * acceleration(t)
    law = {"law": "prescribed", "time": time, "coefficient": mu}
    with backend(name):
        motion = solve(Scene(ARC, law, {"shaking": {"horizontal": series(time, k)}}, end_time=time[-1]))
    assert motion.end.velocity == pytest.approx(np.sum(changes), rel=1e-12)
    assert motion.run_out == pytest.approx(np.sum(changes * (time[-1] - t)), rel=1e-12)


@pytest.mark.parametrize("name", BACKENDS)
def test_water_that_rises_while_a_record_is_zero(name: str) -> None:
    """Both are zero at first; it starts where the water leaves as much friction as it needs."""
    at_rest = solve(Scene(ARC, MU))
    rises = 1.0 - 1.0 / at_rest.factor_of_safety
    water = {"time": [0.0, 1.5, 2.5], "pressure": [0.0, 0.0, at_rest.effective_stress_at(0.0)]}
    zero = series(0.02 * np.arange(200.0), np.zeros(200))
    with backend(name):
        motion = solve(Scene(ARC, MU, {"shaking": {"horizontal": zero}, "pore_pressure": water}, end_time=2.0))
    assert motion.phases[0].start == pytest.approx(1.5 + rises, rel=1e-12)


@pytest.mark.parametrize("name", BACKENDS)
def test_it_moves_at_its_end_time_between_samples(name: str) -> None:
    _, n = factor()
    time, end = 0.02 * np.arange(200.0), 2.013
    record = series(time, n * np.where(time < 1.0, 0.3, 3.0 + 0.1 * np.sin(time)))
    until = np.append(time[time < end], end)
    places, speeds, _ = of_block(series(until, record(until)))
    with backend(name):
        motion = solve(Scene(ARC, MU, {"shaking": {"horizontal": record}}, end_time=end))
    assert motion.run_out == pytest.approx(places[-2], rel=1e-12)
    assert motion.end.velocity == pytest.approx(speeds[-1], rel=1e-12)


@pytest.mark.parametrize("name", BACKENDS)
def test_shaking_lifts_what_moves(name: str) -> None:
    """The normal load is zero beyond k = cot psi, and friction is absent until the mass lands."""
    arc = replace(ARC, theta_1=math.radians(180.0), theta_2=math.radians(250.0))
    weight, radial = (float(x) for x in arc.amplitudes_per_inertia)
    psi = abs(float(arc.dip))
    lifts = 1.0 / math.tan(psi)
    time = 0.02 * np.arange(200.0)
    k = lifts * np.where(time < 3.3, 1.2 * np.sin(1.9 * time) ** 2, 0.0)
    (change,) = np.nonzero(np.diff(np.sign(k - lifts)))
    crossings = time[change] + 0.02 * (lifts - k[change]) / np.diff(k)[change]
    knots = np.union1d(time, crossings)
    shaking = np.interp(knots, time, k)
    friction = 1.5 * weight * math.tan(psi)
    normal = np.maximum(math.cos(psi) - shaking * math.sin(psi), 0.0)
    rates = GRAVITY * (weight * (math.sin(psi) + shaking * math.cos(psi)) - friction * normal)
    places, _, stop = exactly(knots, rates.tolist(), rates[-1])
    with backend(name):
        motion = solve(Scene(arc, friction / radial, {"shaking": {"horizontal": series(time, k)}}))
    assert motion.lift_off == pytest.approx(crossings[::2], rel=1e-12)
    assert motion.run_out == pytest.approx(float(places[-1]), rel=1e-12)
    assert motion.duration == pytest.approx(float(stop), rel=1e-12)


@pytest.mark.parametrize("effects", [{}, {"rotation": {}}], ids=["frozen", "turning"])
@pytest.mark.parametrize("name", BACKENDS)
def test_cohesion_holds_what_shaking_lifts(name: str, effects: dict[str, Any]) -> None:
    """The normal force is zero beyond k = cot psi, and cohesion alone balances the weight up to k = 2 cot psi."""
    arc = replace(ARC, theta_1=math.radians(180.0), theta_2=math.radians(250.0))
    psi = abs(float(arc.dip))
    pull = math.sin(psi) + 2.0 / math.tan(psi) * math.cos(psi)
    alpha, radius = float(arc.half_angle), float(arc.radius)
    moment_of_weight = arc.unit_weight * 2.0 / 3.0 * (radius * math.sin(alpha)) ** 3  # of a segment about its centre
    cohesion = pull * moment_of_weight / (2.0 * alpha * radius**2)
    steep = np.resize([0.0, -1.0, 0.5, 1.0, 0.3], 200) / math.tan(psi)
    holds = {"cohesion": {"cohesion": cohesion}, **effects}
    with backend(name):
        motion = shaken(
            series(0.02 * np.arange(200.0), steep), mu=3.0, arc=arc, effects=holds, scale=np.array([1.1, 1.9, 2.1])
        )
    assert all(motion.lift_off)
    assert motion.moves.tolist() == [False, False, True]


@pytest.mark.parametrize("grows", [0.1, 0.3])
def test_water_that_lifts_what_cohesion_holds(grows: float) -> None:
    """Contact is lost, in 400 pieces, where the pressure's straight line reaches the mean normal stress."""
    normal = float(solve(Scene(ARC, 1.0)).effective_stress_at(0.0))
    time = np.linspace(0.0, 8.0, 401)
    share = 0.5 + grows * time + 0.05 * np.sin(9.0 * time)
    water = {"time": time, "pressure": normal * share}
    motion = solve(Scene(ARC, MU, {"cohesion": {"cohesion": 1e9}, "pore_pressure": water}))
    k = int(np.argmax(share > 1.0))
    lifts = time[k - 1] + 0.02 * (1.0 - share[k - 1]) / (share[k] - share[k - 1])
    assert motion.lift_off == pytest.approx((lifts,), rel=1e-12)
    assert motion.slips == 0


def test_it_rests_at_its_end_time_between_samples() -> None:
    """A mass at rest at its end time does not move, though the piece would start it later."""
    _, n = factor()
    time = 0.02 * np.arange(200.0)
    record = series(time, np.where(time < 3.0, 0.3 * n, 5.0 * n))
    motion = solve(Scene(ARC, MU, {"shaking": {"horizontal": record}}, end_time=2.9829))
    assert (motion.run_out, motion.slips) == (0.0, 0)
    assert solve(Scene(ARC, MU, {"shaking": {"horizontal": record}}, end_time=2.9831)).slips == 1


def test_states_on_the_way_are_read_where_samples_are_passed() -> None:
    record = quake(3, 300)
    motion = shaken(record)
    places, speeds, _ = of_block(record)
    read = motion.at(record.time)
    assert np.abs(read.displacement - places[:-1]).max() < 1e-13 * places[-1]
    assert np.abs(read.velocity - speeds).max() < 1e-13 * speeds.max()


@pytest.mark.parametrize("step", [0.02, 0.1])
@pytest.mark.parametrize("name", BACKENDS)
def test_orders_between_samples_keep_the_accuracy(name: str, step: float) -> None:
    """Turning under a record, by steps that its samples cut short, beside a series in ball arithmetic."""
    record = quake(7, 120, step)
    shaking = {"time": record.time.tolist(), "horizontal": record.values.tolist()}
    given = {"arc": oracle.plain(ARC), "friction": MU, "initial_velocity": 0.0, "end_time": None}
    exact = taylor.solve(given | {"effects": TURNING | {"shaking": shaking}}, digits=16)
    lanes = Scene(ARC, np.full(2, MU), TURNING | {"shaking": {"horizontal": record}})
    for accuracy in (1e-3, 1e-6, 1e-9, 1e-12):
        with backend(name):
            motion = solve(lanes, accuracy)
        assert motion.run_out == pytest.approx(float(exact["run_out"]), rel=accuracy)
        assert motion.duration == pytest.approx(float(exact["duration"]), rel=accuracy)


@pytest.mark.parametrize("effects", [{}, {"rotation": {}}], ids=["frozen", "turning"])
def test_steps_are_counted_since_the_last_break(effects: dict[str, Any]) -> None:
    """Thousands of starts and arrests under a long record do not use up the explicit steps of a lane."""
    shaking = {"horizontal": long_records.record(4_000)}
    scene = Scene(Arc(100.0, 3.8, 4.8, 20e3), 0.5, {"shaking": shaking, **effects})
    motion = solve(scene)
    assert motion.slips > 500
    assert motion._final[layout.STEPS] < 20
    assert long_records.nanoseconds(1_000, 1) > 0.0


def test_a_push_that_ends_within_a_piece() -> None:
    """Protect the speed, path and time of a stop where a mass at rest is driven at first: v = 0.3 t - 0.3 t^2."""
    lane: Any = SimpleNamespace(cells=np.zeros((len(layout.CELLS), 1)))
    lane.cells[layout.DIRECTION] = 1.0
    now, length, x, omega, net, after = (np.array([x]) for x in (5.0, 2.0, 0.0, 0.0, 2.0 * 0.3, 2.0 * -0.9))
    with np.errstate(all="ignore"):
        speed, path = integrator.pass_piece(lane, np.array([True]), now, length, x, omega, net, after)
    found = [speed[0], 2.0 * path[0], lane.cells[layout.REST_SINCE, 0], lane.cells[layout.PHASES, 0]]
    assert found == pytest.approx([0.0, 0.05, 6.0, 1.0], abs=1e-15)
    peak = [lane.cells[cell, 0] for cell in (layout.PEAK_OMEGA, layout.PEAK_TIME)]
    assert peak == pytest.approx([0.075, 5.5], abs=1e-15)


def test_a_peak_at_a_sample_is_recorded() -> None:
    """The net moment is zero at a sample exactly, after which the speed falls."""
    lane: Any = SimpleNamespace(cells=np.zeros((len(layout.CELLS), 1)))
    lane.cells[[layout.DIRECTION, layout.PEAK_OMEGA], 0] = 1.0
    given = (np.array([x]) for x in (5.0, 2.0, 0.0, 1.0, 0.5, 0.0))
    with np.errstate(all="ignore"):
        speed, _ = integrator.pass_piece(lane, np.array([True]), *given)
    assert (speed[0], lane.cells[layout.PEAK_OMEGA, 0], lane.cells[layout.PEAK_TIME, 0]) == (1.25, 1.25, 7.0)


# --- proofs ----------------------------------------------------------------------------------------------------------


def early(s: Any, here: Any, speed: Any, time: Any, x: Any, rate: Any) -> None:
    s.peak_omega, s.peak_time, s.peak_rotation = speed, 0.5 * time, x


FAULTS: dict[str, tuple[Any, str, Any, str]] = {
    "the path lacks a term": (records, "path", lambda t, v, net, rise: t * (v + 0.5 * t * net), "path in"),
    "the other root": (records, "standstill", lambda v, net, rise: ((net * net - 2 * rise * v) ** 0.5 - net) / rise,
                       "path in a piece in which a mass stops"),
    "a constant": (records, "SIXTH", 0.166, "path in a piece in which a mass speeds up"),
    "the peak is early": (records, "keep_faster", early, "time of the peak"),
    "the net moment is not linear": (pieces, "press_slope", pieces.time, "the net moment is linear"),
}  # fmt: skip


@pytest.mark.parametrize("fault", FAULTS)
def test_a_fault_of_a_piece_is_not_proved(fault: str, monkeypatch: pytest.MonkeyPatch) -> None:
    module, name, wrong, claim = FAULTS[fault]
    monkeypatch.setattr(module, name, wrong)
    pieces.motion.cache_clear()
    with pytest.raises(ProofError, match=claim):
        assert [pieces.prove(), sliding.prove()]
    monkeypatch.undo()
    pieces.motion.cache_clear()
