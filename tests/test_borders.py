"""Between one kind of motion and another: what is given and does nothing, peaks cut short, restarts, workers."""

import concurrent.futures
import os
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
    """In every number, the estimate and warnings included."""
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
    times = np.linspace(0.0, whole.duration, 20001)
    speed = np.abs(whole.at(times).velocity)
    tops = [k for k in range(1, 20000) if speed[k - 1] < speed[k] > speed[k + 1]]
    assert len(tops) >= 2
    low = tops[0] + int(np.argmin(speed[tops[0] : tops[1]]))
    again = tops[0] + next(k for k, s in enumerate(speed[tops[0] :]) if k > low - tops[0] and s > speed[tops[0]])
    for cut in (tops[0] - 800, low, (low + again) // 2, again + 200, tops[1] + 100):
        ends = given | {"end_time": float(times[cut])}
        found, wanted = motion(ends), taylor.solve(ends, [0.5])
        assert max(accuracy.true_error(found, wanted)) <= found.error_estimate, cut
        assert found.peak.time == pytest.approx(float(wanted["peak_time"]), rel=1e-6, abs=1e-9)
        assert found.peak.acceleration == pytest.approx(found.at(float(found.peak.time)).acceleration, abs=1e-6)
        if found.peak.time == found.duration:
            assert found.peak == found.end
            assert abs(found.peak.acceleration) > 1e-3


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


def test_as_many_workers_as_asked_for(monkeypatch: pytest.MonkeyPatch, records: Any, refused: Any) -> None:
    """And one for each processor where nothing is said; the answer does not depend on it."""
    seen, kind = [], concurrent.futures.ThreadPoolExecutor
    begin = kind.__init__

    def started(self: Any, max_workers: int | None = None, *more: Any, **rest: Any) -> None:
        seen.append(max_workers or os.cpu_count())
        begin(self, max_workers, *more, **rest)

    monkeypatch.setattr(kind, "__init__", started)
    line = "sweep vaiont --samples 256 --block 64 --seed 3 --uncertain friction.angle_deg=uniform:8:14"
    alone = records(line, "--workers 1")
    assert seen.pop() == 1
    for count, more in ((2, "--workers 2"), (os.cpu_count(), ""), (os.cpu_count(), "--engine threads")):
        assert records(line, more) == alone
        assert seen.pop() == count
    assert "--workers 0: must be 1 at least" in refused(line, "--workers 0")
