"""The arc's quantities, against the paper's tables, ball arithmetic and integrals in SI units; and what it refuses."""

import dataclasses
import math
from typing import Any

import numpy as np
import oracle
import pytest
from flint import arb, ctx

from slipcircle import Arc
from slipcircle.scene.arc import GIVEN

VAIONT = {"radius": 1492.6, "theta_1": np.deg2rad(215.2), "theta_2": np.deg2rad(276.9), "unit_weight": 20e3}
TABLE_4_1 = dict(zip(GIVEN, (0.4376, 0.0870, 0.0387, 0.1523, 0.468), strict=True))


def vaiont(**changes: Any) -> Arc:
    return Arc(**(VAIONT | changes))


def ends(arc: Arc) -> tuple[float, float]:
    return float(np.asarray(arc.theta_1)), float(np.asarray(arc.theta_2))


def random_arcs(count: int, seed: int) -> list[Arc]:
    """Arcs of any opening and any dip, thin and steep ones among them."""
    rng = np.random.default_rng(seed)
    half = np.where(rng.random(count) < 0.5, rng.uniform(0.01, 1.57, count), 10 ** rng.uniform(-8, 0, count))
    steep = 10 ** rng.uniform(-9, 0, count)
    steep = np.sign(rng.uniform(-1, 1, count)) * (1.57 - steep)
    middle = 1.5 * np.pi - np.where(rng.random(count) < 0.6, rng.uniform(-1.4, 1.4, count), steep)
    return [Arc(700.0, float(m - h), float(m + h), 21e3) for m, h in zip(middle, half, strict=True)]


# --- the definitions -----------------------------------------------------------------------------------------------


def references(arc: Arc) -> dict[str, arb]:
    """The dimensionless coefficients of the exact two angles, positive down-slope."""
    with ctx.workprec(oracle.BITS + 40):
        m = oracle.moments(oracle.plain(arc))
        fall, press = m["fall"] * m["dip"].sin(), m["press"] * m["dip"].cos()
        return {
            "moment_of_inertia": m["inertia"],
            "radial_weight": press * m["inertia"],
            "weight_moment": fall * m["inertia"],
            "resistance_factor": m["level"] * m["inertia"],
            "dynamic_coefficient": m["polar"] / m["level"],
            "static_normal_stress": press / m["level"],
            "limit_friction": fall / press,
            "radial_weight_per_inertia": press,
            "polar_moment_per_inertia": m["polar"],
        }


def test_dimensionless_coefficients() -> None:
    """Every coefficient of every arc within 10 ulp of itself; J_r and J_theta within 8 ulp of their amplitudes."""
    for arc in [vaiont(), *random_arcs(120, seed=11)]:
        for name, reference in references(arc).items():
            value = float(getattr(arc.dimensionless, name))
            size = oracle.whole(name, *ends(arc))[1] if name in oracle.WHOLE else None
            error = oracle.ulps(value, reference, size)
            assert error <= (8 if size is not None else 10), f"{name} of {arc} is wrong by {error:.3g} ulp"


@pytest.mark.parametrize("distance", [1e-2, 1e-5, 1e-8])
def test_a_steep_arc_loses_no_digits(distance: float) -> None:
    """Near a vertical chord J_r is small; the drive is made of quotients with it."""
    for shift, half in zip(np.linspace(0.9, 1.1, 9), np.linspace(1.21, 1.37, 9), strict=True):
        for middle in (np.pi + shift * distance, 2 * np.pi - shift * distance):
            arc = Arc(100.0, middle - half, middle + half, 2e4)  # sums of the ends round
            reference = references(arc)
            for name in ("radial_weight_per_inertia", "static_normal_stress", "limit_friction"):
                assert oracle.ulps(float(getattr(arc.dimensionless, name)), reference[name]) <= 10, (name, arc)


@pytest.mark.parametrize("changes", [{}, {"gravity": 1.62, "width": 350.0}, {"radius": 33.0, "unit_weight": 17e3}])
def test_si_quantities(changes: dict[str, float]) -> None:
    """From the dimensionless ones, which are those of the definitions."""
    arc = vaiont(**changes)
    d, radius, gamma, g, width = arc.dimensionless, arc.radius, arc.unit_weight, arc.gravity, arc.width
    depth = radius * (1 - math.cos(arc.half_angle))
    expected = {
        "polar_moment": radius**3 * d.resistance_factor * d.dynamic_coefficient,
        "moment_of_inertia": width * gamma / g * radius**4 * d.moment_of_inertia,
        "weight_moment": width * gamma * radius**3 * d.weight_moment,
        "depth": depth,
        "reference_stress": gamma * depth,
        "static_normal_stress": gamma * depth * d.static_normal_stress,
        "limit_friction_angle": math.atan(d.limit_friction),
        "time_scale": math.sqrt(radius / g),
        "half_angle": (arc.theta_2 - arc.theta_1) / 2,
        "dip": abs(1.5 * math.pi - (arc.theta_1 + arc.theta_2) / 2),
    }
    for name, value in expected.items():
        assert getattr(arc, name) == pytest.approx(value, rel=2e-15), name


def test_integers_do_not_overflow() -> None:
    """R**4 of a large radius exceeds what integers hold."""
    for kind in (int, np.int32, np.int64):
        whole, real = vaiont(radius=kind(100_000)), vaiont(radius=1e5)
        assert whole.moment_of_inertia == real.moment_of_inertia > 0
        assert (whole.polar_moment, whole.weight_moment) == (real.polar_moment, real.weight_moment)


def test_arrays_broadcast() -> None:
    """Each field may be an array; a lane is what the scalars give."""
    radius, theta_1, unit_weight = np.array([[200.0], [1500.0]]), np.array([3.6, 3.8, 4.0]), [[18e3], [22e3]]
    arc = Arc(radius, theta_1, 5.0, unit_weight)
    for name in ("polar_moment", "moment_of_inertia", "weight_moment", "depth", "static_normal_stress"):
        values = getattr(arc, name)
        assert values.shape == (2, 3)
        for i, j in np.ndindex(2, 3):
            lane = Arc(float(radius[i, 0]), float(theta_1[j]), 5.0, unit_weight[i][0])
            np.testing.assert_allclose(values[i, j], getattr(lane, name), rtol=4e-16)
    assert arc.dimensionless.limit_friction.shape == (3,)


def test_half_discs_given_in_degrees() -> None:
    """180 degrees are allowed, though radians round; the integrals of a half disc are 1/3, 1/4, ..."""
    for first in (180.0, 187.3, 200.0, 123.4, -180.0):
        disc = Arc(50.0, np.deg2rad(first), np.deg2rad(first + 180.0), 2e4)
        d = disc.dimensionless
        np.testing.assert_allclose(d.moment_of_inertia, np.pi / 4, rtol=1e-15)
        np.testing.assert_allclose(disc.polar_moment, np.pi / 3 * 50.0**3, rtol=1e-15)
        np.testing.assert_allclose(
            d.limit_friction, 2 / 3 * abs(np.tan(np.deg2rad(180.0 - first))), rtol=1e-14, atol=3e-16
        )
        assert disc.depth == pytest.approx(50.0, rel=1e-15)


# --- coefficients as given -----------------------------------------------------------------------------------------


def test_given_coefficients_are_taken_as_they_are() -> None:
    d = vaiont(given=TABLE_4_1).dimensionless
    assert {n: getattr(d, n) for n in GIVEN} == TABLE_4_1
    assert d.limit_friction == 0.0387 / 0.0870
    assert d.static_normal_stress == 0.0870 / 0.1523
    assert d.radial_weight_per_inertia == 0.0870 / 0.4376
    assert d.polar_moment_per_inertia == pytest.approx(0.1523 * 0.468 / 0.4376, rel=3e-16)


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"weight_moment": np.nan}, "given: weight_moment = nan"),
        ({"radial_weight": 0.0}, "given: radial_weight = 0: must be a positive number"),
        ({"moment_of_inertia": "0.4"}, "given: moment_of_inertia = '0.4'"),
        ({"Theta": 0.4}, "given: 'Theta' is unknown; known are moment_of_inertia, radial_weight"),
    ],
)
def test_given_is_checked(changes: dict[str, Any], said: str) -> None:
    with pytest.raises(ValueError, match=r"^Arc: ") as caught:
        vaiont(given=TABLE_4_1 | changes)
    assert said in str(caught.value)


def test_given_takes_all_coefficients_and_a_negative_moment() -> None:
    with pytest.raises(ValueError, match="given: 'dynamic_coefficient' is missing"):
        vaiont(given={n: v for n, v in TABLE_4_1.items() if n != "dynamic_coefficient"})
    one, other = (vaiont(given=TABLE_4_1 | {"weight_moment": moment}) for moment in (0.0387, -0.0387))
    assert (one.facing, other.facing) == (1, -1)
    assert other.dimensionless == one.dimensionless


# --- what is refused -----------------------------------------------------------------------------------------------

BAD: list[tuple[dict[str, Any], str]] = [
    *(({name: value}, name) for name in ("radius", "unit_weight", "gravity", "width") for value in (0.0, -3.5)),
    *(({name: np.nan}, name) for name in VAIONT),
    *(({name: -np.inf}, name) for name in VAIONT),
    *(({name: value}, name) for name in VAIONT for value in ("1492.6", None, 1j, True, 10**400, [1.0, None])),
    ({"radius": [1.0, -2.0]}, "radius = -2:"),
    ({"theta_2": VAIONT["theta_1"]}, "theta_2 = 215.2 deg"),
    ({"theta_2": np.deg2rad(215.0)}, "theta_2 = 215 deg: must be above theta_1 = 215.2 deg; swap"),
    ({"theta_2": np.deg2rad(395.3)}, "theta_2 - theta_1 = 180.1 deg: must be at most 180"),
    ({"theta_1": np.deg2rad(20.0), "theta_2": np.deg2rad(80.0)}, "theta_1 = 20 deg, theta_2 = 80 deg"),
    ({"theta_1": np.deg2rad(120.0), "theta_2": np.deg2rad(239.999)}, "between 180 and 360 deg"),  # J_r < 0, just
    ({"theta_1": -0.5, "theta_2": 0.5}, "presses on nothing"),  # J_r = 0 exactly
    ({"theta_1": [4.0, 3.8], "theta_2": [3.9, 5.0]}, "theta_2 = 223.4535401 deg: must be above theta_1 = 229.1831181"),
    ({"theta_1": [3.8, 1.0], "theta_2": [5.0, 5.0]}, "theta_2 - theta_1 = 229.1831181 deg"),
    ({"theta_1": [3.8, 3.9], "theta_2": [4.8, 4.9, 5.0]}, "theta_1 (2,), theta_2 (3,)"),
]


@pytest.mark.parametrize(("changes", "said"), BAD)
def test_what_is_refused(changes: dict[str, Any], said: str) -> None:
    """A ValueError that names the field; the value too, unless it is spelled out above."""
    with pytest.raises(ValueError, match=r"^Arc: ") as caught:
        vaiont(**changes)
    message = str(caught.value)
    assert said in message
    assert message.count(";") <= 1, "one mistake, one sentence"
    if said in VAIONT:
        value = changes[said]
        number = isinstance(value, float)
        assert f"{said} = {f'{value:.10g}' if number else repr(value)}: must be a" in message


def test_all_mistakes_are_listed_at_once() -> None:
    with pytest.raises(ValueError, match=r"^Arc: ") as caught:
        Arc(0.0, 5.0, np.inf, np.nan, -1.0, "a", given={"Theta": 1.0})
    message = str(caught.value)
    for part in ("radius = 0:", "theta_2 = inf:", "unit_weight = nan:", "gravity = -1:", "width = 'a':", "'Theta' is"):
        assert part in message
    assert message.count("is missing") == len(GIVEN)


def test_frozen() -> None:
    given = dict(TABLE_4_1)
    arc = vaiont(given=given)
    with pytest.raises(dataclasses.FrozenInstanceError):
        arc.radius = 5.0  # type: ignore[misc]
    with pytest.raises(dataclasses.FrozenInstanceError):
        arc.dimensionless.radial_weight = 1.0  # type: ignore[misc]
    given["radial_weight"] = -1.0  # the caller's own dictionary
    assert arc.dimensionless.radial_weight == 0.0870
    assert dataclasses.replace(arc, width=2.0).width == 2.0
