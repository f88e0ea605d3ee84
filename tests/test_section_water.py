"""A mass that turns through a water level: random sections against 30 digits, energy, both walks, ensembles, words."""

import dataclasses
import math
from functools import cached_property
from itertools import pairwise
from typing import Any

import mpmath as mp
import numpy as np
import pytest
from scipy.integrate import solve_ivp
from strips import integrals
from test_slopes import bumpy

from slipcircle import Motion, Scene, Section, solve
from slipcircle.flow import cells as its
from slipcircle.flow import compiled, tables, walk
from slipcircle.flow.bind import bind

GAMMA, WATER = 20e3, 9810.0
GROUND = [[0.0, 25.0], [30.0, 25.0], [38.0, 30.0], [50.0, 35.0], [90.0, 35.0]]
LEVEL = [[0.0, 25.0], [30.0, 25.0], [45.0, 32.0], [90.0, 32.0]]


class Exact:
    """A section under water at 30 digits: moments by strips in ball arithmetic, pressure and energy by quadrature."""

    def __init__(self, ground: Any, centre: Any, radius: float, level: Any, way: int, mu: float) -> None:
        found = {k: mp.mpf(v.mid().str(40, radius=False)) for k, v in integrals(ground, centre, radius).items()}
        self.found, self.way, self.mu, self.radius = found, way, mp.mpf(mu), mp.mpf(radius)
        self.centre = [mp.mpf(x) for x in centre]
        points = [[mp.mpf(x) - self.centre[0], mp.mpf(y) - self.centre[1]] for x, y in ground]
        roots = sorted(b for p, q in pairwise(points) for b, x in self._crossings(p, q) if p[0] <= x <= q[0])
        self.first, self.last = roots[0], roots[-1]
        line = [[mp.mpf(x) - self.centre[0], mp.mpf(y) - self.centre[1]] for x, y in level]
        far = 3 * self.radius
        self.line = [[-far, line[0][1]], *(p for p in line if abs(p[0]) < far), [far, line[-1][1]]]
        self.drag = self.mu * found["polar"] / found["inertia"]

    def _crossings(self, p: Any, q: Any) -> list[tuple[Any, Any]]:
        """Where an edge's line meets the circle below its centre: angle from straight below, and x."""
        slope = (q[1] - p[1]) / (q[0] - p[0])
        a, b, c = 1 + slope**2, p[1] - slope * p[0], self.radius**2
        disc = c * a - b * b
        xs = [] if disc <= 0 else [(-slope * b + s * mp.sqrt(disc)) / a for s in (-1, 1)]
        return [(mp.atan2(x, -(b + slope * x)), x) for x in xs if b + slope * x < 0]

    @cached_property
    def borders(self) -> list[Any]:
        """Angles of the arc between which its depth below the level is one formula."""
        found = [mp.asin(x / self.radius) for x, _ in self.line if abs(x) < self.radius]
        return sorted(
            [*found, *(b for p, q in pairwise(self.line) for b, x in self._crossings(p, q) if p[0] < x < q[0])]
        )

    def pressure(self, rotation: Any) -> Any:
        """Mean over the arc, Pa."""
        low, high = self.first + self.way * rotation, self.last + self.way * rotation
        total, edges = mp.mpf(0), [low, *(b for b in self.borders if low < b < high), high]
        for a, b in pairwise(edges):
            x = self.radius * mp.sin((a + b) / 2)
            p, q = next((p, q) for p, q in pairwise(self.line) if p[0] <= x <= q[0])
            slope = (q[1] - p[1]) / (q[0] - p[0])
            if p[1] + slope * (x - p[0]) > -mp.sqrt(self.radius**2 - x * x):
                total += (p[1] - slope * p[0]) * (b - a) + self.radius * (
                    slope * (mp.cos(a) - mp.cos(b)) + mp.sin(b) - mp.sin(a))  # fmt: skip
        return WATER * total / (high - low)

    def net(self, rotation: Any) -> Any:
        """d(omega*^2/2)/dphi at no speed, (3.11)."""
        m, cos, sin = self.found, mp.cos(self.way * rotation), mp.sin(self.way * rotation)
        fall = -self.way * (m["moment_x"] * cos - m["moment_y"] * sin)
        press = -(m["radial_x"] * sin + m["radial_y"] * cos)
        lifted = (self.last - self.first) * self.pressure(rotation) / (GAMMA * self.radius)
        return (fall - self.mu * (press - lifted)) / m["inertia"]

    def _to(self, begin: Any, energy: Any, end: Any) -> Any:
        """omega*^2/2 after a stretch without kinks, by the integrating factor of what the speed presses."""
        grown = mp.quad(lambda s: mp.exp(2 * self.drag * (s - end)) * self.net(s), [begin, end])
        return energy * mp.exp(2 * self.drag * (begin - end)) + grown

    def rest(self) -> tuple[Any, Any]:
        """Rotation at rest, and the greatest omega*^2/2."""
        ends = (self.first, self.last)
        kinks = sorted(t for b in self.borders for e in ends if 0 < (t := self.way * (b - e)) < 2)
        energy, peak = mp.mpf(0), mp.mpf(0)
        for begin, end in pairwise([mp.mpf(0), *kinks, mp.mpf(2)]):

            def then(turn: Any, begin: Any = begin, energy: Any = energy) -> Any:
                return self._to(begin, energy, turn)

            after = then(end)
            if self.net(begin) > 2 * self.drag * energy and self.net(end) < 2 * self.drag * after:
                peak = then(mp.findroot(lambda t: self.net(t) - 2 * self.drag * then(t), (begin, end), tol=1e-20,
                                        solver="ridder"))  # fmt: skip
            if after < 0:
                return mp.findroot(then, (begin, end), solver="anderson", tol=1e-25), peak
            energy = after
        raise AssertionError("it does not rest")


def wet(seed: int) -> tuple[Exact, Section, float]:
    """A random section with a random level below its ground, and a friction that lets it go."""
    rng = np.random.default_rng(seed)
    while True:
        ground, centre, radius = bumpy(rng, int(rng.integers(2, 8)))
        depth = np.cumsum(rng.uniform(0.0, 0.08, len(ground)))
        level = [(x, y - float(d)) for (x, y), d in zip(ground, depth, strict=True)]
        section = Section(ground, centre, radius, GAMMA, level=level)
        limit = float(section.dimensionless.limit_friction)
        if section.no_motion is None and limit > 0.1 and float(section.mean_pressure()) > 100.0:
            return Exact(ground, centre, radius, level, int(section.facing), 0.7 * limit), section, 0.7 * limit


@pytest.mark.parametrize("seed", range(5))
def test_random_sections_against_thirty_digits(seed: int) -> None:
    with mp.workdps(30):
        exact, section, mu = wet(seed)
        for turn in (0.0, 0.1, -0.2):
            size = WATER * float(np.asarray(section.radius))
            assert float(section.mean_pressure(turn)) == pytest.approx(float(exact.pressure(turn)), abs=1e-13 * size)
        motion = solve(Scene(section, mu, ["rotation", "centripetal"]))
        rest, peak = exact.rest()
    unit = math.sqrt(9.81 * exact.radius)
    assert motion.end.rotation == pytest.approx(float(rest), rel=max(1e-12, 3 * motion.error_estimate))
    assert motion.peak.velocity == pytest.approx(unit * math.sqrt(2 * peak), rel=max(1e-12, 3 * motion.error_estimate))
    assert motion.error_estimate < 1e-11
    assert abs(motion.energy.residual) < 1e-11 * motion.energy.work


def body(level: Any = LEVEL, **more: Any) -> Section:
    return Section(GROUND, [33.0, 56.0], 28.0, GAMMA, level=level, **more)


def test_time_as_another_integrator_has_it() -> None:
    section, mu = body(), 0.3
    w = section.weights
    scale = section.radius / section.time_scale

    def rates(_: float, y: Any) -> list[float]:
        fall = w.fall * math.cos(y[0]) - w.fall_slope * math.sin(y[0])
        press = w.press * math.cos(y[0]) - w.press_slope * math.sin(y[0])
        lifted = w.level * float(section.mean_pressure(y[0])) / section.reference_stress
        return [y[1], fall - mu * (press + w.polar * y[1] ** 2 - lifted)]

    def stops(t: float, y: Any) -> float:
        return float(y[1]) if t > 0.0 else 1.0

    stops.terminal = True  # type: ignore[attr-defined]
    found = solve_ivp(rates, (0.0, 50.0), [0.0, 0.0], "DOP853", events=stops, rtol=1e-12, atol=1e-14)
    motion = solve(Scene(section, mu, ["rotation", "centripetal"]))
    assert motion.duration == pytest.approx(found.t_events[0][0] * section.time_scale, rel=1e-8)
    assert motion.run_out == pytest.approx(found.y_events[0][0][0] * section.radius, rel=1e-8)
    assert motion.peak.velocity == pytest.approx(scale * found.y[1].max(), rel=1e-2)


def test_a_kink_that_is_forgotten_shows(monkeypatch: pytest.MonkeyPatch) -> None:
    """With the borders of its pieces elsewhere the table does not follow the pressure."""
    section = body()
    right = solve(Scene(section, 0.3, ["rotation"])).end.rotation
    turning = tables.turning
    monkeypatch.setattr(tables, "turning", lambda f, kinks, *ends: turning(f, kinks[:0], *ends))
    wrong = solve(Scene(section, 0.3, ["rotation"])).end.rotation
    assert 1e-12 < abs(wrong / right - 1.0) < 1e-3


@pytest.mark.parametrize("velocity", [0.0, 1.5, -2.0])
@pytest.mark.parametrize("effects", [{"rotation": {}}, {"centripetal": {}}, {"rotation": {}, "drag": {"xi": 400.0}}])
def test_energy_is_kept_and_both_walks_agree(velocity: float, effects: Any) -> None:
    motion = solve(Scene(body(), 0.3, effects, velocity, None if "rotation" in effects else 1.0))
    assert abs(motion.energy.residual) < 1e-11 * motion.energy.work
    if compiled.module() is None:
        return
    bound = motion._lanes.bound
    one, other = bound.cells.copy(), bound.cells.copy()
    walk.walk(bound.program, bound.tables, one)
    compiled.run(bound.program, bound.tables, other)
    for cell in (its.STATUS, its.PHASES, its.TIME, its.PEAK_OMEGA, its.END_ROTATION, its.REST_SINCE):
        assert one[cell] == pytest.approx(other[cell], rel=1e-12, nan_ok=True)


def test_many_sections_walk_together() -> None:
    rng = np.random.default_rng(4)
    count = 30
    centre, radius = [33.0, 56.0] + rng.normal(size=(count, 2)) * 0.05, 28.0 + rng.normal(size=count) * 0.05
    many = Section(GROUND, centre, radius, GAMMA, level=LEVEL)
    called, push = {"rotation": {}, "pore_pressure": {"level": many.mean_pressure}}, rng.normal(size=count)
    bound = bind(many, called, 0.3, push, math.inf, 1e-12, count)
    cells = bound.cells.copy()
    (walk.walk if compiled.module() is None else compiled.run)(bound.program, bound.tables, cells)
    for k in range(0, count, 7):
        one = Section(GROUND, centre[k], radius[k], GAMMA, level=LEVEL)
        alone = solve(Scene(one, 0.3, ["rotation"], float(push[k]), accuracy=1e-12))
        assert cells[its.END_ROTATION, k] == pytest.approx(alone.end.rotation, rel=1e-11)


def test_a_level_of_the_section_is_an_effect_of_its_own() -> None:
    section = body()
    motion = solve(Scene(section, 0.3, ["rotation"]))
    assert motion.plan.effects == ("rotation", "pore_pressure")
    assert motion.pore_pressure_at(0.0) == pytest.approx(section.mean_pressure(), rel=1e-12)
    end = motion.end.rotation
    assert motion.pore_pressure_at(motion.duration) == pytest.approx(section.mean_pressure(end), rel=1e-11)
    assert section.mean_pressure(end) < 0.9 * section.mean_pressure()
    frozen = solve(Scene(section, 0.3, end_time=2.0))
    assert frozen.pore_pressure_at(2.0) == pytest.approx(section.mean_pressure(), rel=1e-12)
    dry = solve(Scene(dataclasses.replace(section, level=None), 0.3, ["rotation"]))
    assert dry.run_out < 0.9 * motion.run_out
    low = dataclasses.replace(section, level=[[0.0, 20.0], [90.0, 21.0]])
    assert solve(Scene(low, 0.3, ["rotation"])).run_out == pytest.approx(dry.run_out, rel=1e-14)
    with pytest.raises(ValueError, match=r"effects\.pore_pressure: 'level' is unknown"):
        Scene(section, 0.3, {"pore_pressure": {"level": section.mean_pressure}})


def test_ground_that_turns_below_the_level_is_told() -> None:
    def said(motion: Motion) -> list[str]:
        return [words for words in motion.warnings if "below the water level" in words]

    filled = body([[0.0, 25.0], [30.0, 25.0], [38.0, 30.0], [50.0, 35.0], [90.0, 35.0]])
    motion = solve(Scene(filled, 0.3, ["rotation"]))
    points = filled.placed(
        np.linspace(filled.surface[:-1], filled.surface[1:], 2001).reshape(-1, 2), motion.end.rotation
    )
    depth = float((np.interp(points[:, 0], *np.array(filled.level).T) - points[:, 1]).max())
    assert filled.drowned(motion.end.rotation) == pytest.approx(depth, rel=1e-3)
    (words,) = said(motion)
    assert words.startswith(f"turning brings ground down to {depth:.3g} m below the water level; the weight of the")
    assert not said(solve(Scene(body([[0.0, 20.0], [90.0, 21.0]]), 0.3, ["rotation"])))
