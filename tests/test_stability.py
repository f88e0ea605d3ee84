"""Factors of safety against published and converged values, slices and limits; the search against evolution."""

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from slipcircle import LayeredSection, Scene, Soil, solve
from slipcircle.ground.construction import circle_through
from slipcircle.ground.section import Section
from slipcircle.workbench.stability import family
from slipcircle.workbench.stability.critical import at_circle, circle_of
from slipcircle.workbench.stability.factors import factors_by
from slipcircle.workbench.stability.family import Search
from slipcircle.workbench.stability.search import critical
from slipcircle.workbench.stability.stability import Slope, factors_of_safety
from tests.campaigns import peers_slopes
from tests.support.along_the_arc import AlongTheArc, random_section
from tests.support.layered import CRACKED


def tangent(degrees: float) -> float:
    return math.tan(math.radians(degrees))


ACADS = Slope([(0, 25), (30, 25), (50, 35), (90, 35)], 3e3, tangent(19.6), 20e3, base=20)
YAMAGAMI_UEDA = Slope([(0, 5), (5, 5), (15, 10), (25, 10)], 9.8e3, tangent(10), 17.64e3)
LI_LUMB = Slope([(0, 5), (5, 5), (15, 15), (20, 15)], 18e3, tangent(30), 18e3, pore_ratio=0.2)
LOUKIDIS = Slope([(-50, 0), (0, 0), (75, 25), (150, 25)], 25e3, tangent(30), 20e3, k_h=0.432, base=-25)
ARAI_TAGYO = Slope([(0, 15), (18, 15), (48, 35), (80, 35)], 41.65e3, tangent(15), 18.82e3, base=0)  # 1985, example 1


@pytest.mark.parametrize(
    ("slope", "method", "expected", "circle"),
    [
        (ACADS, "bishop", 0.985, (29.5, 53.6, 28.6)),
        (ACADS, "ordinary", 0.942, None),
        (YAMAGAMI_UEDA, "ordinary", 1.2752, None),
        (YAMAGAMI_UEDA, "bishop", 1.3426, (8.65, 14.10, 9.81)),
        (LI_LUMB, "bishop", 1.3335, (4.07, 19.40, 14.43)),
        (LOUKIDIS, "bishop", 0.991, None),
        (ARAI_TAGYO, "bishop", 1.404, None),  # published: 1.451 (1985), 1.409 (Slide2)
    ],
)
def test_published_searches(slope: Slope, method: str, expected: float, circle: tuple[float, ...] | None) -> None:
    found = critical(slope, method)
    assert found.factors_of_safety[method] == pytest.approx(expected, rel=1e-3)
    _, toe, brow, _ = np.asarray(
        slope.ground
    ).tolist()  # given to three digits; it leaves at the toe and enters the level crest
    if circle is not None:
        assert (*found.centre, found.radius) == pytest.approx(circle, abs=0.01 * (brow[1] - toe[1]))
        assert found.exit == pytest.approx(toe, abs=0.02 * (brow[1] - toe[1]))
        assert found.entry[1] == pytest.approx(brow[1])
    assert 0 < found.refused < found.tried


@pytest.mark.parametrize(("angle", "number"), [(90, 3.8313), (75, 4.5645), (60, 5.2474), (45, 5.8701)])
@pytest.mark.parametrize("method", ["bishop", "paper"])
def test_taylor_s_numbers_of_toe_circles(angle: float, number: float, method: str) -> None:
    run = 0.0 if angle == 90 else 10.0 / tangent(angle)
    slope = Slope([(0, 0), (40, 0), (40 + run, 10), (90, 10)], 20e3, 0.0, 20e3)
    factor = critical(slope, method, exit=(40.0, 40.0)).factors_of_safety[method]
    assert factor is not None
    # F = 1 where gamma H/c is Taylor's number, and F is proportional to c: N = F gamma H/c.
    assert factor * 20e3 * 10.0 / 20e3 == pytest.approx(number, rel=1e-4)


def test_the_course_of_a_search_does_not_depend_on_last_bits(monkeypatch: pytest.MonkeyPatch) -> None:
    """Circles of a dam are as critical as their mirror images; factors are rounded as on another processor."""
    dam = Slope([(-40, 0), (-20, 0), (0, 10), (20, 0), (40, 0)], 5e3, 0.4, 20e3)
    here = critical(dam)
    exact, rng = factors_by, np.random.default_rng(1)

    def rounded(*arguments: Any) -> Any:
        factors, facing = exact(*arguments)
        return factors * (1.0 + 2.0**-52 * rng.integers(-2, 3, factors.shape)), facing

    monkeypatch.setattr(family, "factors_by", rounded)
    there = critical(dam)
    assert (there.tried, there.refused, there.facing) == (here.tried, here.refused, here.facing)
    assert (*there.centre, there.radius) == pytest.approx((*here.centre, here.radius), rel=1e-12)


def test_ever_deeper_circles_below_gentle_slopes_without_friction() -> None:
    """F gamma H/c tends to 5.52 (Taylor): here by 1000 slopes' heights of soil."""
    deep = Slope([(-6e4, 0), (0, 0), (10 / tangent(40), 10), (6e4, 10)], 20e3, 0.0, 20e3, base=-1e4)
    assert critical(deep).factors_of_safety["bishop"] == pytest.approx(0.552, abs=2e-4)
    steep = replace(deep, ground=[(-60, 0), (0, 0), (10 / tangent(60), 10), (60, 10)], base=None)
    assert critical(steep).exit == pytest.approx((0.0, 0.0), abs=0.01)  # toe circles above 53 deg, without a base


GROUND = [(-60.0, 14.0), (-25.0, 12.0), (-14.0, 7.0), (-6.0, 5.5), (0.0, 0.0), (60.0, -1.0)]
LEVEL = [(-60.0, 9.0), (-20.0, 6.0), (-5.0, 1.0), (1.0, -0.5), (60.0, -1.5)]


@pytest.mark.parametrize("pressure", [0.0, 3e3])
@pytest.mark.parametrize("on_surcharge", [False, True])
def test_factors_are_those_of_slices_along_the_arc(pressure: float, on_surcharge: bool) -> None:
    """Random layers with water and loads; with the yield coefficient as k_h the paper's factor is 1."""
    rng, compared = np.random.default_rng(1), []
    for k_h in (0.0, 0.15, -0.05, 0.3):
        section = random_section(rng)
        slope = Slope(section.ground, layers=section.layers, level=section.level, surcharge=section.surcharge, k_h=k_h,
                      k_h_on_surcharge=on_surcharge, pressure=pressure)  # fmt: skip
        found = at_circle(slope, section)
        bishop = found.factors_of_safety["bishop"]
        expected = AlongTheArc(slope, found).factors(k_h, bishop or math.nan)
        assert found.negative == pytest.approx(expected.pop("negative"), abs=3e-3)  # counted at 10 points of each piece
        compared += [(found.factors_of_safety[method], factor) for method, factor in expected.items() if factor > 0.0]
        shaken = AlongTheArc(replace(slope, k_h_on_surcharge=True), found)
        assert shaken.factors(found.yield_coefficient or math.nan, 1.0)["paper"] == pytest.approx(1.0, rel=1e-12)
    computed, factors = zip(*compared, strict=True)
    assert len(factors) > 10
    assert computed == pytest.approx(factors, rel=1e-12)


@pytest.mark.parametrize(("cohesion", "friction"), [(3e3, ACADS.friction), (30e3, 0.0)])
def test_a_base_may_lie_at_the_height_of_the_toe(cohesion: float, friction: float) -> None:
    rock, above = (critical(replace(ACADS, cohesion=cohesion, friction=friction, base=y)) for y in (25.0, 25.0 - 1e-6))
    assert rock.factors_of_safety["bishop"] == pytest.approx(above.factors_of_safety["bishop"], rel=1e-6)
    Section(ACADS.ground, rock.centre, rock.radius, 20e3, between=rock.between, base=25.0)  # is not refused


@pytest.mark.parametrize(
    ("points", "centre", "slides"),
    [
        ([(-90, 0), (-10, 0), (10, 10), (90, 10)], (-4.0, 13.0), True),
        ([(-90, 0), (-10, 0), (10, 10), (90, 10)], (-1.0, 7.0), False),  # overhangs at its right end
        ([(-90, 10), (-10, 10), (10, 0), (90, 0)], (1.0, 7.0), False),  # at its left end
        ([(-90, 0), (-10, 0), (2, 30), (10, 0), (90, 0)], (0.0, 12.0), False),  # its centre lies in a hill
    ],
)
def test_arcs_that_overhang_and_buried_centres_have_no_factor(points: Any, centre: Any, slides: bool) -> None:
    slope = Slope(points, 3e3, 0.3, 20e3)
    left, right = np.array([points[1]]), np.array([points[-2]])
    factors, _ = factors_by(slope.arrays(), (np.array([centre]), np.hypot(*(left - centre).T), left, right), "paper")
    assert np.isfinite(factors).tolist() == [slides]


def test_a_lifted_toe_is_refused_by_bishop_alone() -> None:
    # The arc leaves the ground at about 73 deg: m_alpha = cos(73) - sin(73) mu/F is negative for factors below 2.2.
    slope = Slope([(-60, 3), (-20, 3), (0, 0), (60, 0)], 1e2, tangent(35), 2e4, k_h=0.9)
    centre, radius = circle_through((-22.0, 3.0), (30.0, 0.0), depth=20.0)
    found = at_circle(slope, Section(slope.ground, centre, float(radius), 1.0))
    assert [method for method, factor in found.factors_of_safety.items() if factor is None] == ["bishop"]


@pytest.mark.parametrize("length", [1e-3, 1e-4])
def test_thin_masses_have_the_factors_of_an_infinite_slope(length: float) -> None:
    """Stresses of thin masses are small differences, of which no digits are lost; both methods have a closed form."""
    tangent, k_h, radius = 0.78, 0.15, 166.0
    slope = Slope(np.array([[0.0, 25], [30, 25], [50, 35], [90, 35]]), 0.0, tangent, 19500.0, k_h=k_h, base=20.0)
    sine, cosine = np.array([1.0, 2.0]) / math.sqrt(5)
    middle, along = np.array([44.0, 32.0]), length / 2 * np.array([cosine, sine])
    centre = middle + math.sqrt(radius**2 - (length / 2) ** 2) * np.array([-sine, cosine])
    ends = (middle - along)[None], (middle + along)[None]
    found = circle_of(slope, centre[None], np.array([radius]), *ends).factors_of_safety
    driving = sine + k_h * cosine
    assert found["ordinary"] == pytest.approx(tangent * (cosine - k_h * sine) / driving, rel=1e-9)
    assert found["bishop"] == pytest.approx(tangent * (1 - driving * sine) / (driving * cosine), rel=1e-9)


@pytest.mark.parametrize(
    ("name", "limit", "reached", "words"),
    [
        ("entry", (-40.0, -35.0), -35.0, "the entry is at a limit of the search"),
        ("exit", (5.0, 8.0), 5.0, "the exit is at a limit of the search"),
        ("depth", 6.0, 6.0, "as thin as the search allows"),
    ],
)
def test_where_the_least_factor_lies_beyond_a_limit_the_circle_is_at_it(
    name: str, limit: Any, reached: float, words: str
) -> None:
    slope = Slope([(-50, 10), (-20, 10), (0, 0), (50, 0)], 5e3, tangent(20), 19e3, base=-2.0)
    free, found = critical(slope), critical(slope, **{name: limit})
    assert free.centre[1] - free.radius >= -2.0 - 1e-6
    assert (found.factors_of_safety["bishop"] or 0.0) > (free.factors_of_safety["bishop"] or 9.0)
    section = Section(slope.ground, found.centre, found.radius, 19e3, between=found.between)
    at = {"entry": found.entry[0], "exit": found.exit[0], "depth": float(section.depth)}
    assert at[name] == pytest.approx(reached, abs=1e-6)
    assert words in found.warning
    assert words not in free.warning


def test_a_search_gives_the_same_bits_again() -> None:
    one, other = critical(ACADS), critical(ACADS)
    assert one == other
    assert np.array_equal(one.values, other.values, equal_nan=True)


def test_a_mass_is_one_piece() -> None:
    # From crest to toe below the bench, and so flat that the bench stands out below the arc.
    slope = Slope([(-60, 20), (-30, 20), (-20, 12), (-12, 12), (10, 0), (60, 0)], 10e3, 0.5, 19e3)
    search = Search(slope, "bishop", None, None, 0.0)
    crest, toe = search.along[1], search.along[4]
    flat, deep = search.evaluate(np.array([[crest, toe, 0.05, -1.0], [crest, toe, 0.9, -1.0]])).tolist()
    assert math.isnan(flat)
    assert deep > 0.0


def test_a_circle_at_the_end_of_the_ground_is_told() -> None:
    # Without friction and deep soil the least factor lies ever deeper: the ground is what ends it.
    slope = Slope([(-20, 5), (-15, 5), (0, 0), (8, 0)], 20e3, 0.0, 19e3, base=-30.0)
    found = critical(slope)
    assert found.warning.startswith("the circle reaches the end of the ground at x = ")
    assert critical(replace(ACADS)).warning == ""
    assert "42 % of the arc is under negative" in critical(
        Slope([(-40, 0), (0, 0), (10, 10), (60, 10)], 10e3, tangent(30), 20e3, pore_ratio=0.5, base=-20)
    ).warning  # fmt: skip


@pytest.mark.parametrize("scale", [1e-6, 1e-3, 1e3, 1e6])
def test_a_search_knows_no_unit(scale: float) -> None:
    ground = scale * np.asarray(ACADS.ground)
    found = critical(replace(ACADS, ground=ground, cohesion=3e3 * scale, base=20 * scale))
    assert found.factors_of_safety["bishop"] == pytest.approx(0.98504, rel=1e-5)
    assert found.centre == pytest.approx((29.54 * scale, 53.64 * scale), rel=1e-3)


@pytest.mark.parametrize(
    ("slope", "angle", "number", "share", "least"),
    [(90, 10, 0.218, 0.453, 0.936), (90, 25, 0.166, 0.479, 0.911), (75, 15, 0.152, 0.346, 0.951),
     (60, 10, 0.138, 0.246, 0.977), (45, 10, 0.108, 0.125, 0.996)],
)  # fmt: skip
def test_bishop_s_method_is_too_low_where_its_slices_hang_on_the_base(
    slope: float, angle: float, number: float, share: float, least: float
) -> None:
    """Taylor's friction circles give 1."""
    run = 0.0 if slope == 90 else 10 / tangent(slope)
    cut = Slope([(-40, 0), (0, 0), (run, 10), (run + 60, 10)], number * 2e5, tangent(angle), 2e4, base=-20)
    found = critical(cut, exit=(0.0, 0.0))
    assert found.factors_of_safety["bishop"] == pytest.approx(least, abs=6e-3)
    assert found.negative == pytest.approx(share, abs=4e-3)
    assert ("of the arc is under negative effective normal stress" in found.warning) == (share > 0.2)


@pytest.mark.parametrize("seed", [0, 40, 160])
def test_the_least_factor_is_that_of_differential_evolution(seed: int) -> None:
    assert peers_slopes.compared(seed).excess < 5e-4


SAND = Soil(19e3, friction=tangent(30.0), name="sand")
CLAY = Soil(19e3, cohesion=40e3, name="clay")


@pytest.mark.parametrize(
    ("slope", "more", "words"),
    [
        (replace(ACADS, cohesion=0.0), {}, "ever thinner masses"),
        (Slope(ACADS.ground, layers=[(SAND, None)]), {}, "ever thinner masses; give a least depth"),
        (Slope(ACADS.ground, layers=[(SAND, None), (CLAY, 22.0)], base=20.0), {}, "where the soil has no cohesion"),
        (replace(ACADS, friction=0.0, base=None), {}, "infinitely deep, where the factor tends to 0.0828;"),
        (replace(ACADS, friction=0.0, base=None, k_h=0.1), {}, "infinitely deep"),
        (Slope([(0, 0), (50, 0)], 1e3, 0.5, 2e4), {}, "level"),
        (replace(ACADS, pressure=5e3), {}, "uniform along every circle, and lifts thin masses"),
        (replace(ACADS, k_h=-0.9), {}, "no circle within these limits can slide"),
        (ACADS, {"method": "janbu"}, "must be one of"),
        (ACADS, {"entry": 3.0}, "entry = 3.0: must be two numbers"),
        (ACADS, {"depth": "1"}, "depth = '1': must be at least 0"),
        ("a", {}, "slope = 'a': must be a Slope"),
        (ACADS, {"entry": (5.0, 1.0)}, "least and the greatest"),
        (ACADS, {"exit": (200.0, 300.0)}, "beside the ground"),
        (ACADS, {"entry": (0.0, 1.0), "exit": (2.0, 3.0)}, "no circle within these limits"),
        (Slope(GROUND, 8e3, tangent(25), 19e3, level=LEVEL), {"depth": 50.0}, "no circle within these limits"),
    ],
)
def test_a_search_without_an_answer_says_why(slope: Slope, more: dict[str, object], words: str) -> None:
    with pytest.raises(ValueError, match=words):
        critical(slope, **more)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("more", "words"),
    [
        ({"cohesion": -1.0}, "cohesion"),
        ({"cohesion": [3e3, 4e3]}, "cohesion = .*: must be one number"),
        ({"pressure": -1.0}, "pressure"),
        ({"friction": 10.0}, "arctangent"),
        ({"unit_weight": math.nan}, "unit_weight"),
        ({"pore_ratio": 1.2}, "pore_ratio"),
        ({"k_h": 3.0}, "k_h"),
        ({"base": 35.0}, "below the highest point of the ground"),
        (
            {"level": [(0, 30), (90, 29)]},
            r"level: varies by 0\.4\d* m from x = 0 to 39\..* horizontal level there, or confined",
        ),
        ({"level": [(0, 20), (60, 20)], "confined": 1}, "confined = 1: must be True or False"),
        ({"confined": True}, "confined: has no level; give the level"),
        ({"ponds": [(0, 20)]}, r"pond\.1 = \(0, 20\): must be x of its left"),
        ({"ponds": [(20, 25, 27)]}, r"pond\.1\.level: water at this level reaches from x = 0 to 34"),
        ({"ponds": [(0, 32, 27)]}, r"pond\.1\.level: .* to 34; extend the pond to both shores"),
        ({"ponds": [(0, 90, 27)], "level": [(0, 26), (90, 26)]}, "ponds: lies in other free water"),
        ({"ponds": [(0, 90, 24)]}, r"pond\.1\.level: the ground from x = 0 to 90 lies above it"),
        ({"level": [(0, 20), (90, 30)], "pore_ratio": 0.2}, "level gives the pore pressure, too; remove one of them"),
        ({"level": [(200, 20), (300, 20)]}, "beside the ground"),
        ({"cohesion": 0.0, "friction": 0.0}, "no strength"),
        ({"crack": 1.0, "crack_water": 2.0}, "crack_water = 2.0: must be at most the depth of the crack"),
        ({"ground": [(30, 25), (0, 25), (50, 35)]}, "order them by x"),
    ],
)
def test_slopes_that_are_refused(more: dict[str, object], words: str) -> None:
    given = {"ground": ACADS.ground, "cohesion": 3e3, "friction": 0.35, "unit_weight": 2e4}
    with pytest.raises(ValueError, match=words):
        Slope(**(given | more))  # type: ignore[arg-type]


@pytest.mark.parametrize("way", [1.0, -1.0])
@pytest.mark.parametrize("up", [-0.07, 0.07, 0.11])
def test_free_water_is_horizontal_to_a_hundredth_of_the_height(way: float, up: float) -> None:
    """ACADS' slope is 10 m high, and 27.5 m above the datum at x = 35, where the level enters the ground."""
    lines: Any = ACADS.ground, [(0, 27.5), (34.9, 27.5 + up), (40, 28), (90, 30)]
    ground, level = ([(way * x, y) for x, y in line][:: int(way)] for line in lines)
    given: Any = {"ground": ground, "cohesion": 3e3, "friction": 0.35, "unit_weight": 2e4}
    if up < 0.1:
        ((first, last, height),) = Slope(**given, level=level).free_water.of_one
        assert height == pytest.approx(27.5 + up / 2, abs=0.02)
        assert max(way * first, way * last) == pytest.approx(35.0, abs=0.3)
    else:
        with pytest.raises(ValueError, match=r"level: varies by 0\.1389 m from x = .* free water is horizontal"):
            Slope(**given, level=level)


LAYERED = [
    (Soil(18e3, 2e3, 0.7, name="sand"), None),
    (Soil(17e3, 35e3, 0.0, cohesion_gradient=1e3, datum=2.0, name="clay"), 2.0),
    (Soil(19e3, 5e3, 0.4, pore_ratio=0.1, name="till"), [(-60, -4), (0, -3), (60, -5)]),
]
GENTLE = [(-60, 8), (-20, 8), (0, 0), (60, 0)]
LOADED: dict[str, Any] = {"surcharge": [(-40, -22, 10e3, 30e3)], "k_h_on_surcharge": True}
SHAKEN = [Slope(GENTLE, 12e3, 0.4, 19e3, pore_ratio=0.2, base=-10.0, k_h=0.3),
          Slope(GENTLE, layers=LAYERED, base=-10.0, **LOADED)]  # fmt: skip


@pytest.mark.parametrize("slope", SHAKEN, ids=["one soil", "layers"])
def test_the_least_yield_coefficient_is_the_k_h_that_makes_the_least_paper_factor_one(slope: Slope) -> None:
    found = critical(slope, "k_y")
    k_y = found.yield_coefficient
    assert k_y is not None
    assert k_y > 0.0
    shaken = replace(slope, k_h=k_y)
    assert critical(shaken, "paper").factors_of_safety["paper"] == pytest.approx(1.0, rel=1e-4)


CIRCLE: dict[str, Any] = {"centre": (-6.0, 22.0), "radius": 24.0}
LEVEL_BELOW = [(-60, 4), (-20, 4), (0, -1), (60, -1)]
COHESION: Any = {"rotation": {}, "cohesion": {"cohesion": 12e3}}


def cracked(section: LayeredSection) -> tuple[Scene, Slope]:
    slope = Slope(section.ground, layers=section.layers, crack=section.crack, surcharge=section.surcharge)
    return Scene(section, effects=["rotation"]), slope


SLIDES: dict[str, tuple[Scene, Slope]] = {
    "under water": (Scene(Section(GENTLE, **CIRCLE, unit_weight=19e3, level=LEVEL_BELOW), 0.4, COHESION),
                    Slope(GENTLE, 12e3, 0.4, 19e3, level=LEVEL_BELOW)),
    "a pore pressure ratio": (
        Scene(Section(GENTLE, **CIRCLE, unit_weight=19e3), 0.4, COHESION | {"pore_pressure": {"ratio": 0.25}}),
        Slope(GENTLE, 12e3, 0.4, 19e3, pore_ratio=0.25)),
    "layers": (Scene(LayeredSection(GENTLE, **CIRCLE, layers=LAYERED, surcharge=SHAKEN[1].surcharge)),
               replace(SHAKEN[1], k_h_on_surcharge=False)),
    "cracked, to the right": cracked(CRACKED),
    "cracked, to the left": cracked(replace(
        CRACKED, ground=np.asarray(CRACKED.ground)[::-1] * [-1, 1], centre=(-30, 45), surcharge=[(-4.0, 3.0, 3e4, 2e4)]
    )),
}  # fmt: skip


@pytest.mark.parametrize("name", SLIDES)
def test_a_circle_has_the_factors_of_its_motion_and_scene(name: str) -> None:
    scene, slope = SLIDES[name]
    assert isinstance(scene.arc, Section)
    circle = replace(scene.arc, crack=0.0) if isinstance(scene.arc, LayeredSection) else scene.arc  # of the slope
    found, motion = at_circle(slope, circle), solve(scene)
    assert found.yield_coefficient == pytest.approx(motion.yield_coefficient, rel=1e-9)
    assert found.factors_of_safety["paper"] == pytest.approx(motion.factor_of_safety, rel=1e-9)
    by_method = factors_of_safety(scene)
    for method, factor in found.factors_of_safety.items():
        assert by_method[method] == pytest.approx(factor, rel=1e-9)
