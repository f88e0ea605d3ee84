"""The run-out is the greatest displacement; where the mass rests is another number if it swings back."""

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq

from slipcircle import Scene, backanalyse, ensemble, load, solve
from tests.support import golden, taylor
from tests.support.outputs import columns

VAIONT: Scene[Any] = load("vaiont")
DEGREES = [4.0, 5.0, 6.0, 7.0, 8.0]
GREATEST, RESTS = [1010, 953, 897, 841, 786], [563, 574, 683, 793, 786]  # m, integrated by others with SciPy


def test_vaiont_with_less_and_less_friction() -> None:
    """Less strength, farther; single scenes, an ensemble and a back-analysis agree."""
    frictions = np.tan(np.deg2rad(DEGREES))
    lanes = solve(replace(VAIONT, friction=frictions))
    alone = [solve(replace(VAIONT, friction=float(mu))) for mu in frictions]
    assert [round(m.run_out) for m in alone] == GREATEST
    assert [round(m.end.displacement) for m in alone] == RESTS
    for m in alone:
        assert m.at(m.farthest.time).displacement == pytest.approx(m.run_out, rel=1e-12)
        toe = math.radians(276.9) + np.array([0.0, m.run_out / 1492.6])
        assert m.journey.rise == pytest.approx(1492.6 * float(np.diff(np.sin(toe))[0]), rel=1e-12)
    assert lanes.run_out == pytest.approx([m.run_out for m in alone], rel=1e-9)
    assert lanes.farthest.time == pytest.approx([m.farthest.time for m in alone], rel=1e-9)
    assert backanalyse(VAIONT, run_out=alone[1].run_out).value == pytest.approx(5.0, rel=1e-9)
    rests = backanalyse(VAIONT, end_displacement=alone[1].end.displacement)
    assert min(abs(s.value - 5.0) for s in rests.solutions) < 1e-8


def shaken(amplitudes: list[float], **more: Any) -> golden.Data:
    """Return a nearly level slope under triangular pulses of 1.5 s, three seconds apart, in both directions."""
    time, values = [0.0], [0.0]
    for k, amplitude in enumerate(amplitudes):
        time += [3.0 * k + 0.5, 3.0 * k + 1.25, 3.0 * k + 2.0]
        values += [0.0, amplitude, 0.0]
    arc = {"radius": 60.0, "theta_1": 4.05, "theta_2": 5.3, "unit_weight": 19e3, "gravity": 9.81}
    effects = {"rotation": {}, "shaking": {"time": time, "horizontal": values, "two_way": True}}
    return {"arc": arc, "friction": 0.3, "effects": effects, "initial_velocity": 0.0, "end_time": None} | more


@pytest.mark.parametrize(
    ("amplitudes", "more"),
    [([0.9, -1.2], {}), ([-1.2, 0.7], {}), ([0.7, -1.8, 0.7], {}), ([-0.6, 1.0, -0.6], {}),
     ([0.4, -0.9, 0.9, -0.5], {"initial_velocity": -1.5}), ([-0.9, 0.8], {"end_time": 4.5})],
)  # fmt: skip
def test_the_run_out_has_the_sign_of_the_greatest_displacement(amplitudes: list[float], more: dict[str, Any]) -> None:
    """Up-slope it is negative. References are Taylor series of 22 digits; an ensemble gives the same for its lanes."""
    given = shaken(amplitudes, **more)
    exact = taylor.solve(given, digits=20)
    greatest, rest = float(exact["run_out"]), float(exact["end_displacement"])
    scene = golden.built("", given)
    motion = solve(scene)
    assert (motion.run_out, motion.end.displacement) == pytest.approx((greatest, rest), rel=1e-12)
    assert motion.farthest.displacement == motion.run_out
    assert abs(motion.run_out - rest) > 1e-3 * abs(greatest)
    lanes = solve(replace(scene, friction=np.array([0.3, 9.0])))
    assert (lanes.run_out[0], lanes.end.displacement[0]) == pytest.approx((greatest, rest), rel=1e-9)


def test_derivatives_where_the_greatest_displacement_changes_its_place() -> None:
    """The run-out has a kink with two slopes between turning points on one side, and jumps between sides."""

    def places(second: float, friction: float = 0.3) -> tuple[float, float]:
        """Return the displacements after the first and after the last of three pulses, m."""
        three = shaken([0.9, second, 0.9], friction=friction)
        first = solve(golden.built("", shaken([0.9, second, 0.9], friction=friction, end_time=3.4)))
        return float(first.end.displacement), float(solve(golden.built("", three)).end.displacement)

    second = brentq(lambda x: float(np.subtract(*places(x))), -1.0, -0.6, xtol=1e-15)
    found = solve(golden.built("", shaken([0.9, second, 0.9]))).sensitivity()
    h = 1e-6
    slopes = np.subtract(places(second, 0.3 + h), places(second, 0.3 - h)) / (2 * h)
    place = list(found.outputs).index("run_out"), list(found.parameters).index("friction")
    assert found.kind("run_out", "friction") == "kink"
    assert sorted(found.slopes[place]) == pytest.approx(sorted(slopes), rel=1e-5)

    def difference(second: float) -> float:
        motion = solve(golden.built("", shaken([0.9, second])))
        turned, rest = 60.0 * motion.phases[-1].rotation, motion.end.displacement
        return float(turned + rest)

    second = brentq(difference, -1.6, -1.1, xtol=1e-15)
    found = solve(golden.built("", shaken([0.9, second]))).sensitivity()
    assert found.kind("run_out", "friction") == "jump"
    assert any("outcomes jump at this value (run_out" in warning for warning in found.warnings)


def test_suites_keep_the_permanent_displacement() -> None:
    """It is what fragility curves and regressions refer to; the run-out of each motion is beside it."""
    exact = taylor.solve(shaken([0.9, -1.2]), digits=20)
    scene = golden.built("", shaken([0.9, -1.2]))
    record = scene.called["shaking"]["horizontal"]
    still = replace(scene, effects={"rotation": {}, "shaking": {"two_way": True, "horizontal": record}})
    study = ensemble(still, records={"one": record})
    assert study.values["run_out"].item() == pytest.approx(float(exact["run_out"]), rel=1e-9)
    permanent = float(exact["end_displacement"])
    assert study.values["end_displacement"].item() == pytest.approx(permanent, rel=1e-9)
    assert study.displacement.item() == pytest.approx(abs(permanent), rel=1e-9)
    assert study.by_record()["displacement_m"] == pytest.approx([abs(permanent)], rel=1e-9)


def test_the_end_is_printed_where_the_mass_swings_back(said: Any, records: Any) -> None:
    cells = columns(said("run vaiont-rate vaiont"))
    swung, onward = cells["run-out along the arc"]
    assert swung == "953 m, then back to 573.8 m"
    assert onward.startswith("677.3 m")
    assert "back" not in onward
    (record,) = records("run vaiont-rate")
    assert "reach" not in record
    assert (record["run_out"], record["end"]["displacement"]) == pytest.approx((952.98673275, 573.80577671), rel=1e-9)
    assert record["farthest"]["displacement"] == record["run_out"]
