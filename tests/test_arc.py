"""The arc's quantities, against the paper's tables, ball arithmetic and integrals in SI units; and what it refuses."""

import math
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from flint import arb, ctx

from slipcircle import Arc
from slipcircle.tabulated import GIVEN
from tests.support import oracle
from tests.support.vaiont import FIELDS as VAIONT

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


@pytest.mark.parametrize(
    ("quantity", "printed", "place"),
    [
        (lambda a: a.polar_moment / 1e9, 0.308, 1e-3),  # km^3
        (lambda a: a.reference_stress / 1e6, 4.223, 1e-3),  # MPa
        (lambda a: a.static_normal_stress / 1e6, 2.413, 1e-3),
        (lambda a: np.degrees(2 * a.half_angle), 61.7, 0.1),
        (lambda a: a.dimensionless.resistance_factor, 0.1523, 1e-4),
        (lambda a: a.dimensionless.radial_weight, 0.0870, 1e-4),
        (lambda a: a.dimensionless.static_normal_stress, 0.5713, 1e-4),
    ],
    ids=["I_p", "sigma_ref", "sigma_n0", "2 alpha", "lambda", "J_r", "sigma_n0*"],
)
def test_right_numbers_of_tables_2_1_and_4_1(quantity: Callable[[Arc], float], printed: float, place: float) -> None:
    """Less than a unit of the last printed place."""
    assert abs(quantity(vaiont()) - printed) < place


# --- the definitions -----------------------------------------------------------------------------------------------


def references(arc: Arc) -> dict[str, arb]:
    """Return the dimensionless coefficients of the exact two angles."""
    theta_1, theta_2 = ends(arc)
    half = (Fraction(theta_2) - Fraction(theta_1)) / 2
    pressing, _ = oracle.whole("radial_weight", theta_1, theta_2)
    turning = abs(oracle.whole("weight_moment", theta_1, theta_2)[0])  # positive down-slope
    names = ("moment_of_inertia", "resistance_factor", "polar_moment")
    inertia, factor, polar = (oracle.kernel(name, half) for name in names)
    with ctx.workprec(oracle.BITS + 40):
        return {
            "moment_of_inertia": inertia,
            "radial_weight": pressing,
            "weight_moment": turning,
            "resistance_factor": factor,
            "dynamic_coefficient": polar / factor,
            "static_normal_stress": pressing / factor,
            "limit_friction": turning / pressing,
            "radial_weight_per_inertia": pressing / inertia,
            "polar_moment_per_inertia": polar / inertia,
        }


def test_dimensionless_coefficients() -> None:
    """Coefficients of every arc are within 10 ulp; J_r and J_theta are within 8 ulp of their amplitudes."""
    for arc in [vaiont(), *random_arcs(120, seed=11)]:
        for name, reference in references(arc).items():
            value = float(getattr(arc.dimensionless, name))
            size = oracle.whole(name, *ends(arc))[1] if name in oracle.WHOLE else None
            error = oracle.ulps(value, reference, size)
            assert error <= (8 if size is not None else 10), f"{name} of {arc} is wrong by {error:.3g} ulp"


@pytest.mark.parametrize("arc", [vaiont(), vaiont(gravity=1.62, width=350.0), *random_arcs(2, seed=5)])
def test_si_quantities(arc: Arc) -> None:
    """Integrals over the unit section times lengths, unit weight, gravity and width."""
    fields = (arc.radius, arc.unit_weight, arc.gravity, arc.width, *ends(arc))
    radius, gamma, g, width, first, second = (float(np.asarray(x)) for x in fields)
    opening, unit = second - first, {name: float(value) for name, value in references(arc).items()}
    depth = 2 * radius * math.sin(opening / 4) ** 2
    expected = {
        "polar_moment": radius**3 * float(oracle.kernel("polar_moment", opening / 2)),
        "moment_of_inertia": width * gamma / g * radius**4 * unit["moment_of_inertia"],
        "weight_moment": width * gamma * radius**3 * unit["weight_moment"],
        "depth": depth,
        "reference_stress": gamma * depth,
        "static_normal_stress": gamma * radius * unit["radial_weight"] / opening,
        "limit_friction_angle": math.atan(unit["limit_friction"]),
        "time_scale": math.sqrt(radius / g),
        "half_angle": opening / 2,
        "dip": abs(3 * math.pi / 2 - (first + second) / 2),
    }
    for name, value in expected.items():
        assert getattr(arc, name) == pytest.approx(value, rel=1e-14, abs=1e-15 * (name == "dip")), name


def test_arrays_broadcast() -> None:
    """Fields may be arrays; a lane equals the arc of its scalars, and integers do not overflow."""
    radius, theta_1, unit_weight = np.array([[200], [100_000]]), np.array([3.6, 3.8, 4.0]), [[18e3], [22e3]]
    arc = Arc(radius, theta_1, 5.0, unit_weight)
    for name in ("polar_moment", "moment_of_inertia", "weight_moment", "depth", "static_normal_stress"):
        values = getattr(arc, name)
        for i, j in np.ndindex(values.shape):
            lane = Arc(float(radius[i, 0]), float(theta_1[j]), 5.0, unit_weight[i][0])
            np.testing.assert_allclose(values[i, j], getattr(lane, name), rtol=4e-16)
    assert (arc.polar_moment.shape, arc.dimensionless.limit_friction.shape) == ((2, 3), (3,))


@pytest.mark.parametrize("first", [180.0, 187.3, 200.0, 123.4, -180.0])
def test_half_discs_given_in_degrees(first: float) -> None:
    """180 degrees are allowed, though radians round; the integrals of a half disc are 1/3, 1/4, ..."""
    disc = Arc(50.0, np.deg2rad(first), np.deg2rad(first + 180.0), 2e4)
    assert disc.dimensionless.moment_of_inertia == pytest.approx(np.pi / 4, rel=1e-15)
    assert disc.polar_moment == pytest.approx(np.pi / 3 * 50.0**3, rel=1e-15)
    limit = 2 / 3 * abs(np.tan(np.deg2rad(180.0 - first)))
    assert disc.dimensionless.limit_friction == pytest.approx(limit, rel=1e-14, abs=3e-16)


# --- coefficients as given -----------------------------------------------------------------------------------------


def test_given_coefficients_are_taken_as_they_are() -> None:
    d = vaiont(given=TABLE_4_1).dimensionless
    level = 3.0 * np.pi - VAIONT["theta_2"]
    several = vaiont(given=TABLE_4_1, theta_1=np.array([3.7, level])).moment_coefficients
    for lane, theta_1 in enumerate((3.7, level)):
        alone = vaiont(given=TABLE_4_1, theta_1=theta_1).moment_coefficients
        assert [float(np.broadcast_to(x, 2)[lane]) for x in several] == [float(x) for x in alone]
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
    ({"theta_1": -0.5, "theta_2": 0.5}, "no normal load"),  # J_r = 0 exactly
    ({"theta_1": [4.0, 3.8], "theta_2": [3.9, 5.0]}, "theta_2 = 223.4535401 deg: must be above theta_1 = 229.1831181"),
    ({"theta_1": [3.8, 1.0], "theta_2": [5.0, 5.0]}, "theta_2 - theta_1 = 229.1831181 deg"),
    ({"theta_1": [3.8, 3.9], "theta_2": [4.8, 4.9, 5.0]}, "theta_1 (2,), theta_2 (3,)"),
]


@pytest.mark.parametrize(("changes", "said"), BAD)
def test_what_is_refused(changes: dict[str, Any], said: str) -> None:
    """One mistake, one sentence, which names the field, and its value unless that is long."""
    with pytest.raises(ValueError, match=r"^Arc: ") as caught:
        vaiont(**changes)
    message = str(caught.value)
    assert said in message
    assert message.count(";") <= 1
    if said in VAIONT:
        value = changes[said]
        start = f"{said} = {f'{value:.10g}' if isinstance(value, float) else repr(value)}: must be a"
        assert start in message if len(start) < 100 else len(message) < 200, message


def test_all_mistakes_are_listed_at_once() -> None:
    with pytest.raises(ValueError, match=r"^Arc: ") as caught:
        Arc(0.0, 5.0, np.inf, np.nan, -1.0, "a", given={"Theta": 1.0})
    message = str(caught.value)
    for part in ("radius = 0:", "theta_2 = inf:", "unit_weight = nan:", "gravity = -1:", "width = 'a':", "'Theta' is"):
        assert part in message
    assert message.count("is missing") == len(GIVEN)


def test_a_negative_moment_faces_the_other_way() -> None:
    one, other = (vaiont(given=TABLE_4_1 | {"weight_moment": moment}) for moment in (0.0387, -0.0387))
    assert (one.facing, other.facing) == (1, -1)
    assert other.dimensionless == one.dimensionless


def test_area_and_centroid_of_thin_and_thick_segments() -> None:
    """Against ball arithmetic of R^2 (alpha - sin cos) and 2 sin^3/(3 (alpha - sin cos)): no cancellation."""
    with ctx.workprec(400):
        for half in (1e-8, 1e-5, 1e-3, 0.1, 0.5, 1.0, 1.5, math.pi / 2):
            arc = Arc(700.0, 1.5 * math.pi - half, 1.5 * math.pi + half, 21e3)
            alpha = arb(float(arc.half_angle))
            share = alpha - alpha.sin() * alpha.cos()
            below = 700 * 2 * alpha.sin() ** 3 / (3 * share)
            assert float(arc.area) == pytest.approx(float(490_000 * share), rel=1e-15)
            assert float(np.hypot(*arc.centroid)) == pytest.approx(float(below), rel=2e-15)
            assert float(arc.mass_per_metre) == pytest.approx(float(arc.area) * 21e3 / 9.81, rel=1e-15)
