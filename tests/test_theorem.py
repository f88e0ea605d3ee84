"""Theorems on motions: against quadrature of the definitions, Taylor series of other code, and the package itself."""

import json
import math
from typing import Any

import mpmath as mp
import pytest
from flint import arb
from mpmath import mpf

from derive.__main__ import main
from derive.check.truth import as_ball, working
from derive.theorem import swing
from derive.theorem.motion import Slide, first_swing, theorem
from derive.theorem.report import pair
from derive.theorem.swing import next_standstill
from tests.campaigns.theorems import Case, compared, errors
from tests.support import taylor, vaiont

VAIONT = ["--radius-m", "1492.6", "--theta-1-deg", "215.2", "--theta-2-deg", "276.9", "--friction-deg", "10"]
KEYS = ("rotation_rad", "run_out_m", "peak_velocity_m_s", "duration_s")


def stated(capsys: Any, *options: str) -> Any:
    """Return the JSON of the command."""
    assert main(["theorem", *options, "--json"]) == 0
    return json.loads(capsys.readouterr().out)


# The slide of Vaiont to 24 digits, with and without centripetal stress: by mpmath, moments as double integrals, the
# textbook form of E = omega^2, its zeros, and the integral of E^-1/2 by Gauss's rule. 677.30785128136000588 m and
# 27.97207129143170264 m/s are also those of an enclosure by another program.
KNOWN = {
    "": "0.453777201716039130296451 677.307851281360005880482 27.9720712914317026413995 38.0793495288471774425801 "
        "333.973816922226491729017",
    "--no-centripetal": "0.466612876442828040135832 696.466379378565132706743 28.7657275954639714081594 "
                        "38.0749036198903434292676 348.233189689282566353371",
}  # fmt: skip


@pytest.mark.parametrize("switch", KNOWN)
def test_quadrature_of_the_definitions_lies_between_the_decimals(switch: str, capsys: Any) -> None:
    found = stated(capsys, *VAIONT, *switch.split())
    assert found["status"] == "rests"
    with mp.workdps(30):
        for name, known in zip((*KEYS, "peak_displacement_m"), KNOWN[switch].split(), strict=True):
            low, high = map(mpf, found[name])
            assert low <= mpf(known) <= high, name
            assert high - low < mpf("1e-18") * high


ARC = {"radius": 60.0, "theta_1": 3.7, "theta_2": 5.0}
SCENES: list[tuple[dict[str, Any], float, float]] = [  # friction, cohesion and pore pressure
    ({"law": "exponential", "peak": 0.25, "residual": 0.11, "length": 1.5}, 0.0, 0.0),
    ({"law": "exponential", "peak": 0.25, "residual": 0.06, "length": 0.02}, 0.0, 0.0),  # and swings back twice
    ({"law": "exponential", "peak": 0.11, "residual": 0.11, "length": 1.0}, 5e3, 2e4),
    ({"law": "exponential", "peak": 0.04, "residual": 0.04, "length": 1.0}, 0.0, 0.0),  # swings back five times
]


def made(friction: dict[str, Any], cohesion: float, pressure: float) -> Slide:
    """Return the slide of doubles, which are exact."""
    radius, theta_1, theta_2 = (as_ball(ARC[name]) for name in ("radius", "theta_1", "theta_2"))
    residual, peak, length = (as_ball(friction[name]) for name in ("residual", "peak", "length"))
    softens = peak if friction["peak"] > friction["residual"] else None
    loads = as_ball(cohesion) / 19000, as_ball(pressure) / 19000
    return Slide(radius, theta_1, theta_2, residual, as_ball(9.81), softens, length, loads[0], loads[1])


@pytest.mark.parametrize(("friction", "cohesion", "pressure"), SCENES)
def test_taylor_series_in_time_of_other_code(friction: dict[str, Any], cohesion: float, pressure: float) -> None:
    effects: dict[str, Any] = {"rotation": {}, "centripetal": {}}
    effects |= {"cohesion": {"cohesion": cohesion}, "pore_pressure": {"pressure": pressure}} if cohesion else {}
    scene = {"arc": ARC | {"unit_weight": 19e3, "gravity": 9.81}, "friction": friction, "effects": effects}
    found = taylor.solve(scene | {"initial_velocity": 0.0, "end_time": None}, digits=24)
    proof = theorem(lambda: made(friction, cohesion, pressure))
    assert proof.status == "rests"
    with mp.workdps(40):
        for name, key in zip(KEYS[1:], ("run_out", "peak_velocity", "duration"), strict=True):
            low, high = map(mpf, pair(proof.numbers[name], 30))
            assert high - low < 1e-18 * high
            assert abs(mpf(found[key]) - low) < 1e-20 * high + (high - low), name
        swings = "end_displacement_m" in proof.numbers
        low, high = map(mpf, pair(proof.numbers["end_displacement_m" if swings else "run_out_m"], 30))
        assert abs(mpf(found["end_displacement"]) - low) < 1e-20 * abs(high) + (high - low)
        assert swings == (found["phases"] > 1)


def test_remainders_are_counted() -> None:
    """Enclosures with coarse steps are wide, and contain the results of fine steps."""
    with working(200):
        start = first_swing(made(*SCENES[0]))
        *fine, _ = next_standstill(start, arb(10) ** -20)
        for exponent in (2, 4, 8):
            *rough, _ = next_standstill(start, arb(10) ** -exponent)
            for close, coarse in zip(fine, rough, strict=True):
                assert coarse.contains(close), exponent
                assert coarse.rad() > close.rad(), exponent


def test_extreme_swings_enclose_the_others_closely() -> None:
    """Coefficients prolong or shorten a swing, as declared."""
    small = arb(10) ** -8
    with working(120, 20):
        middle = first_swing(made(SCENES[0][0], 2e3, 1e4))
        exact = next_standstill(middle, small)
        for names, sign in ((swing.GREATER, 1), (swing.LESS, -1)):
            for name in names:
                other = next_standstill(middle._replace(**{name: getattr(middle, name) * arb(1.001)}), small)
                assert sign * (other.rest - exact.rest) > 0, name
                assert sign * (other.peak - exact.peak) > 0, name
        box = swing.Swing(*(x * arb(1, 1e-4) for x in middle))
        enclosed = swing.between(box, small)
        assert enclosed.rest.contains(exact.rest)
        assert enclosed.rest.rad() < next_standstill(box, small).rest.rad() / 2


def test_an_interval_holds_what_its_numbers_give(capsys: Any) -> None:
    wide = stated(capsys, *VAIONT[:-1], "10+-0.01", "--digits", "8")
    for angle in ("9.99", "9.995", "10.01"):
        narrow = stated(capsys, *VAIONT[:-1], angle)
        for name in KEYS:
            ends = [mpf(x) for x in (wide[name][0], *narrow[name], wide[name][1])]
            assert ends == sorted(ends)
    assert mpf(wide["run_out_m"][1]) - mpf(wide["run_out_m"][0]) < 20


def test_without_a_quantity_it_is_vaiont(capsys: Any) -> None:
    found = {row["name"]: row for row in stated(capsys)}
    assert [row["status"] for row in found.values()] == ["rests", "never rests", "rests"]
    assert "run_out_m" not in found["vaiont-frozen"]
    assert found["vaiont-softening"]["run_out_m"][0].startswith("676.43174278014566956")
    assert main(["theorem", *VAIONT]) == 0
    text = capsys.readouterr().out
    assert "677.30785128136000588 to 677.30785128136000589" in text


def test_above_the_limit_it_does_not_move(capsys: Any) -> None:
    """Limit friction of (3.21), by quadrature elsewhere in the tests: 0.41921443125219915..."""
    found = stated(capsys, *VAIONT[:-1], "22.75")
    assert found["status"] == "does not move"
    assert found["run_out_m"] == ["0", "0"]
    gap = mp.tan(mp.radians(mpf("22.75"))) - mpf("0.41921443125219915141")
    assert mpf(found["margin"][0]) == pytest.approx(float(gap), rel=1e-12) == float(found["margin"][1])


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--friction-deg", "22.7+-0.1", "--parts", "1"], "whether friction is above its limit"),
        (
            ["--radius-m", "10+-1", "--friction-deg", "20+-2", "--parts", "3"],
            "narrower radius_m, friction_deg or more --p",
        ),
        (["--theta-1-deg", "100", "--theta-2-deg", "190"], "dip by less than 90 degrees"),
        (["--theta-1-deg", "100", "--theta-2-deg", "190", "--friction-deg", "1"], "more --digits may decide"),
        (["--pore-pressure-kPa", "9e4", "--unit-weight-kN-m3", "20"], "does not certainly press"),
    ],
)
def test_undecided(options: list[str], words: str, capsys: Any) -> None:
    """No number of the motion is given."""
    assert main(["theorem", *options, "--json"]) == 1
    found = json.loads(capsys.readouterr().out)
    assert found["status"] == "undecided"
    assert words in found["reason"]
    assert not found.keys() & set(KEYS)
    assert found["undecided_share"] == 1.0


@pytest.mark.parametrize(
    "uncertain", [{"friction": ("10", "0.1")}, {"friction": ("22.5", "1"), "radius": ("1500", "50")}]
)
def test_uncertain_inputs_are_divided(uncertain: dict[str, tuple[str, str]], capsys: Any) -> None:
    """The proof for a range of inputs contains the proof for each input, and is not much wider."""
    names = {"friction": "--friction-deg", "radius": "--radius-m"}
    options = [x for name, (middle, radius) in uncertain.items() for x in (names[name], f"{middle}+-{radius}")]
    main(["theorem", *options, "--parts", "100", "--json"])
    whole = json.loads(capsys.readouterr().out)
    assert whole["undecided_share"] < (0.5 if "radius" in uncertain else 1e-9)  # friction is at its limit within
    outcomes = []
    for side in (-1, -0.5, 0.25, 1):
        exact = [x for name, (middle, radius) in uncertain.items()
                 for x in (names[name], str(float(middle) + side * float(radius)))]  # fmt: skip
        one = stated(capsys, *exact)
        outcomes.append(float(one["run_out_m"][0]))
        if not whole["undecided_share"] or abs(float(exact[1]) - 22.745) > 0.4:
            assert float(whole["run_out_m"][0]) <= outcomes[-1] <= float(whole["run_out_m"][1])
        assert any(one["status"] in claim for claim in whole["proved"])
    if len(uncertain) == 1:
        assert whole["status"] == "rests"
        low, high = map(float, whole["run_out_m"])
        assert high - low < 2 * (max(outcomes) - min(outcomes))
    else:
        assert "does not move" in str(whole["proved"])


def test_without_friction_it_never_rests(capsys: Any) -> None:
    found = stated(capsys, *VAIONT[:-1], "0")
    assert found["status"] == "never rests"
    assert "never rests" in found["proved"][-1]


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--theta-2-deg", "400"], "beyond a half disc"),
        (["--theta-2-deg", "200"], "has to be above theta_1_deg"),
        (["--friction-deg", "95"], "allowed are 0 to 89"),
        (["--friction-deg", "ten"], "give a decimal"),
        (["--friction-deg", "10+-x"], "give a decimal"),
        (["--radius-m", "1e999999999"], "give a decimal"),
        (["--radius-m", "nan"], "give a decimal"),
        (["--cohesion-kPa", "3"], "cohesion_kPa: add unit_weight_kN_m3"),
        (["--pore-pressure-kPa", "3"], "pore_pressure_kPa: add unit_weight_kN_m3"),
        (["--peak-friction-deg", "9"], "has to be at least friction_deg"),
    ],
)
def test_bad_input_is_named(options: list[str], words: str, capsys: Any) -> None:
    assert main(["theorem", *options]) == 1
    said = capsys.readouterr()
    assert words in said.err
    assert not said.out


def test_vaiont_is_next_to_its_enclosure() -> None:
    case = Case(vaiont.RADIUS, *vaiont.ENDS, math.tan(math.radians(10)), True)
    motion = case.motion()
    assert max(errors(motion, theorem(case.slide))) < min(1e-15, motion.error_estimate)


@pytest.mark.parametrize("index", [0, 2, 3, 4, 12])
def test_the_package_is_within_its_estimate_of_the_enclosure(index: int) -> None:
    """A half disc next to the limit, a mass that swings, others: `tests.campaigns.theorems` does so for hundreds."""
    _, status, error, estimate = compared(index, 1)
    assert status == "rests"
    assert error <= estimate
