"""Transitions between kinds of motion: effects without action, peaks cut short, restarts, workers."""

from typing import Any

import numpy as np
import pytest

from slipcircle import Motion, solve
from tests.support import accuracy, golden, taylor


def motion(given: golden.Data) -> Motion:
    found = solve(golden.built("", given))
    assert isinstance(found, Motion)
    return found


FLAT = {"time": [0.0, 1.0, 2.5], "horizontal": [0.0, 0.0, 0.0]}
NOTHING: dict[str, Any] = {
    "a record of zeros": {"shaking": FLAT},
    "a record of zeros both ways": {"shaking": FLAT | {"vertical": [0.0, 0.0, 0.0], "two_way": True}},
    "a pulse of no height": {"shaking": {"pulse": "sine", "amplitude": 0.0, "duration": 2.0, "cycles": 2.0}},
    "no viscosity": {"viscosity": {"viscosity": 0.0, "thickness": 0.3}},
    "no heat": {"thermal_pressurisation": {"pressurisation": 0.0, "heat_capacity": 2e6, "thickness": 0.1}},
    "dry": {"pore_pressure": {"time": [0.0, 2.0], "pressure": [0.0, 0.0]}},
    "no cohesion": {"cohesion": {"cohesion": 0.0}},
}  # fmt: skip
STARTS = {
    "from rest": golden.scene(0.16, golden.TURNING),
    "pushed down, frozen": golden.scene(0.4, {"centripetal": {}}, 5.0),
    "pushed up, frozen": golden.scene(0.4, {}, -3.0),
    "pushed up and back": golden.scene(0.16, golden.TURNING, -3.0),
    "pushed and mirrored": golden.mirrored(golden.scene(0.4, {}, -3.0)),
    "pushed, until its end": golden.scene(0.16, {"centripetal": {}}, 2.0, 3.0),
    "softens": golden.scene(golden.LAWS["exponential"], golden.TURNING, 1.0),
    "stays": golden.scene(0.4, golden.TURNING),
}


@pytest.mark.parametrize("start", STARTS)
@pytest.mark.parametrize("nothing", NOTHING)
def test_an_effect_of_zero_is_no_effect(nothing: str, start: str) -> None:
    """Numbers, estimate and warnings are the same."""
    plain = motion(STARTS[start])
    more = STARTS[start] | {"effects": STARTS[start]["effects"] | NOTHING[nothing]}
    kept = golden.numbers(plain, golden.times(plain)) | {"sensitivity": None}
    assert not golden.differences(f"{start} with {nothing}", motion(more), kept)


def test_a_law_that_does_not_change_is_constant_friction() -> None:
    laws: tuple[dict[str, Any], ...] = ({"law": "exponential", "peak": 0.16, "residual": 0.16, "length": 1.0},
                {"law": "tabulated", "slip": [0.0, 3.0], "coefficient": [0.16, 0.16]},
                {"law": "prescribed", "time": [0.0, 3.0], "coefficient": [0.16, 0.16]},
                {"law": "rate_weakening", "peak": 0.16, "residual": 0.16, "velocity": 1.0},
                {"law": "rate_tabulated", "speed": [1e-3, 1.0, 9.0], "coefficient": [0.16, 0.16, 0.16]},
                {"law": "constant", "coefficient": 0.16,
                 "rate": {"law": "rate_weakening", "peak": 1.0, "residual": 1.0, "velocity": 1.0}})  # fmt: skip
    for law in laws:
        for velocity in (0.0, 2.0, -3.0):
            plain = motion(golden.scene(0.16, golden.TURNING, velocity))
            kept = golden.numbers(plain, golden.times(plain)) | {"sensitivity": None}
            assert not golden.differences(law["law"], motion(golden.scene(law, golden.TURNING, velocity)), kept)


@pytest.mark.parametrize(("velocity", "bump"), [(2.0, 0.6), (-2.0, 0.36)])
def test_a_peak_cut_between_two_greatest_speeds(velocity: float, bump: float) -> None:
    """It is the first until the second is faster, the end where speed still grows, each to the estimate."""
    friction = {"law": "tabulated", "slip": [0.0, 0.5, 4.0, 4.4, 4.8, 5.2, 40.0],
                "coefficient": [0.2, 0.15, 0.15, bump, bump, 0.05, 0.05]}  # fmt: skip
    given = golden.scene(friction, golden.TURNING, velocity)
    whole = motion(given)
    kinds = set()
    for cut in (*np.linspace(0.1, 0.9, 5) * whole.duration, 0.995 * whole.peak.time):
        ends = given | {"end_time": float(cut)}
        found, wanted = motion(ends), taylor.solve(ends, [0.5])
        assert max(accuracy.true_error(found, wanted)) <= found.error_estimate, cut
        assert found.peak.time == pytest.approx(float(wanted["peak_time"]), rel=1e-6, abs=1e-9)
        assert found.peak.acceleration == pytest.approx(found.at(float(found.peak.time)).acceleration, abs=1e-6)
        at_end = found.peak.time == found.duration
        assert not at_end or found.peak == found.end
        kinds.add("at the end" if at_end else "second" if found.peak.time == whole.peak.time else "first")
    assert kinds == {"first", "at the end", "second"}


@pytest.mark.parametrize("effects", [{"rotation": {}}, golden.TURNING, golden.TURNING | {"drag": {"xi": 200.0}}])
def test_a_restart_within_rounding_is_no_certainty(effects: dict[str, Any]) -> None:
    """Pushed up-slope it stands where friction just holds it, or slides back: next to that the estimate is 1."""

    def slides(mu: float) -> Motion:
        return motion(golden.scene(mu, effects, -4.0))

    stays, goes = 0.45, 0.1
    assert slides(stays).duration < 2.0 < slides(goes).duration
    while stays > np.nextafter(goes, 1.0):
        middle = (stays + goes) / 2
        stays, goes = (middle, goes) if slides(middle).duration < 2.0 else (stays, middle)
    for mu in (stays, goes):
        found = slides(mu)
        assert found.error_estimate > 0.01
        assert any("ill-conditioned" in w for w in found.warnings)
    for mu in (stays * (1.0 + 1e-6), goes * (1.0 - 1e-6)):
        assert slides(mu).error_estimate < 1e-6
    # Where it stands, it is the limit friction of a mass at rest there.
    up = abs(slides(stays).end.rotation)
    turned = golden.scene(stays, {"rotation": {}}, 0.0, 1.0, theta_1=golden.SLOPE["theta_1"] - up,
                          theta_2=golden.SLOPE["theta_2"] - up)  # fmt: skip
    assert motion(turned).limit_friction == pytest.approx(stays, rel=1e-12)
