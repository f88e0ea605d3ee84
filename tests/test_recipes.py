"""The recipes of the book against closed forms, limits and other methods; tests/test_readme.py runs them as printed."""

import re
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from scipy.integrate import dblquad
from scipy.stats import norm

from slipcircle import Arc, Scene, load, solve
from tests.support.outputs import blocks

PAGE = Path(__file__).parents[1] / "notebooks/recipes.md"
EXPOSED, INFERRED, WAVE, FLOW, ENDS, WALL = blocks(PAGE.read_text("utf-8"), "python")
ARC = Arc(radius=40.0, theta_1=np.deg2rad(210), theta_2=np.deg2rad(290), unit_weight=19e3)


def functions(code: str) -> dict[str, Any]:
    """Return the definitions of a recipe before its example, which follows the last two empty lines."""
    names: dict[str, Any] = {}
    exec(code.rpartition("\n\n\n")[0], names)
    return names


def test_annual_rates_of_a_power_law_and_a_lognormal_response() -> None:
    """k_0 theta^-k exp(k^2 beta^2/2), and the displacement that has this rate where theta is a power of it."""
    recipe, k, beta = functions(EXPOSED), 2.5, 0.4
    pga = np.array([5e-3, 0.1, 20.0])
    thresholds = np.array([0.01, 0.04, 0.3])
    medians = 0.5 * thresholds**0.3

    def rate(theta: float) -> Any:
        curve = SimpleNamespace(probability=lambda a: (norm.cdf(np.log(a / theta) / beta),))
        return recipe["annual_rate"](curve, pga, 2e-5 * pga**-k)

    rates = np.array([rate(theta) for theta in medians])
    assert rates == pytest.approx(2e-5 * medians**-k * np.exp((k * beta) ** 2 / 2), rel=1e-5)
    between = 2e-5 * (0.5 * 0.1**0.3) ** -k * np.exp((k * beta) ** 2 / 2)
    assert recipe["displacement"](between, thresholds, rates) == pytest.approx(0.1, rel=1e-4)
    with pytest.raises(ValueError, match=r"hazard curve: rate = \[0.1, 0.2\]: must fall .*; sort both"):
        recipe["annual_rate"](None, [0.1, 0.2], [0.1, 0.2])


def test_sampled_frictions_against_quadrature() -> None:
    pytest.importorskip("emcee", reason="the extra 'book' is not installed")
    recipe = functions(INFERRED.replace("rng =", "\n\nrng ="))
    angle, log_error = (np.linspace(*ends, 200) for ends in zip(recipe["lowest"], recipe["highest"], strict=True))
    every = np.stack(np.meshgrid(angle, log_error), axis=-1).reshape(-1, 2)
    weight = np.exp(recipe["log_probability"](every))
    mean = np.average(every[:, 0], weights=weight)
    deviation = np.sqrt(np.average((every[:, 0] - mean) ** 2, weights=weight))
    ((shown, spread),) = re.findall(r"# (\S+) degrees, standard deviation (\S+)", INFERRED)
    assert (float(shown), float(spread)) == pytest.approx((mean, deviation), abs=0.1)


def test_wave_of_lake_askja() -> None:
    """The slide of 2014 as the impulse wave manual computes it: it prints P = 0.49, 43.3 m and 531 m."""
    wave = functions(WAVE)["wave"]
    height, distance, outside = wave(30.1, 35.5, 2e10 / 550, np.deg2rad(10.4), 138.0)
    assert (height, distance) == pytest.approx((43.3, 531.0), rel=0.015)  # printed from a rounded P
    assert outside == ["F"]  # 0.82


def test_columns_have_the_mass_momentum_and_energy_of_the_slide() -> None:
    motion = solve(load("real-slope"))
    section: Any = motion.plan.scene.arc
    state = motion.peak
    x, base, top, u, v = functions(FLOW)["columns"](motion, state.time, 4000).T
    height, width = top - base, x[1] - x[0]
    assert height.sum() * width == pytest.approx(section.area, rel=1e-5)
    before, after = (section.placed(section.centroid, state.rotation + turn) for turn in (-1e-6, 1e-6))
    of_centroid = (after - before) / 2e-6 * state.angular_velocity
    assert [(c * height).sum() * width / section.area for c in (u, v)] == pytest.approx(of_centroid, rel=1e-5)
    squares = u**2 + v**2 + (state.angular_velocity * height) ** 2 / 12  # u is linear over the height
    energy = section.unit_weight / section.gravity * (height * squares).sum() * width / 2
    assert energy == pytest.approx(motion.energy_at(state.time).kinetic_end, rel=1e-5)


def test_ends_of_a_cohesive_slide() -> None:
    """The moment of the ends is the quadrature of c r over both faces; also of a shallow arc."""
    recipe, alpha = functions(ENDS), ARC.half_angle
    chord = np.cos(alpha)
    moment, _ = dblquad(lambda r, a: r * r, -alpha, alpha, lambda a: chord / np.cos(a), 1.0)
    ends, base = 2 * 40.0**3 * moment, 2 * alpha * 40.0**2 * 30.0
    assert recipe["share_of_ends"](ARC, 30.0) == pytest.approx(ends / (ends + base), rel=1e-9)
    shallow = replace(ARC, theta_2=ARC.theta_1 + 0.02)
    assert recipe["share_of_ends"](shallow, 12 * shallow.depth) == pytest.approx(0.1, rel=1e-3)
    cohesion = {"cohesion": recipe["with_ends"](ARC, 25e3, 30.0)}
    factor = solve(Scene(ARC, friction=0.0, effects={"cohesion": cohesion})).factor_of_safety
    assert factor == pytest.approx(25e3 * (ends + base) / (30.0 * ARC.weight_moment), rel=1e-9)


def test_a_wall_adds_its_moment() -> None:
    """The wall adds to the factor of safety and to the work beyond friction."""
    cohesion = functions(WALL)["cohesion_of_wall"](ARC, 300e3, 35.0)
    bare = Scene(ARC, friction=np.tan(np.deg2rad(14)), effects=["rotation"])
    motion = solve(replace(bare, effects={"rotation": {}, "cohesion": {"cohesion": cohesion}}))
    gained = motion.factor_of_safety - solve(bare).factor_of_safety
    assert gained == pytest.approx(300e3 * 35.0 / ARC.weight_moment, rel=1e-9)
    turn = np.linspace(0.0, float(motion.end.rotation), 2001)
    # Without centripetal stress friction takes J_r of the position, whatever the speed.
    dip, d = ARC.dip, ARC.dimensionless
    friction = np.tan(np.deg2rad(14)) * d.radial_weight * np.cos(dip - turn) / np.cos(dip)
    taken = np.trapezoid(friction, turn) * ARC.unit_weight * 40.0**3 + 300e3 * 35.0 * turn[-1]
    assert motion.energy.dissipation == pytest.approx(taken, rel=1e-6)
