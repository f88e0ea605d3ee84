"""Stored numbers of 196 scenes that cover every law and effect.

``scenes.json`` holds the scenes as plain data, in SI units and radians; every law meets every effect, from rest, pushed
either way, mirrored and cut short. ``golden.json`` holds their numbers. Run-out, peak velocity, duration and states on
the way were within the estimated error of Taylor series in ball arithmetic, which share no code with the package;
`test_golden` repeats some of these comparisons. ``python -m tests.support.golden`` writes ``golden.json``. Numbers that
agree with the stored ones to within rounding are not replaced, so that every processor writes the same file. Stored
derivatives, which an earlier program computed by another method, are never replaced.
"""

import json
import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import asdict
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from slipcircle import Arc, Motion, Scene, load, parameters, solve
from slipcircle.tables import Series

FILE = Path(__file__).with_name("golden.json")
SHARES = (0.18, 0.47, 0.76)  # of the duration, at which states are taken
STATE = ("time", "rotation", "angular_velocity", "velocity", "displacement", "acceleration", "normal_stress")
Data = dict[str, Any]

# --- the scenes ------------------------------------------------------------------------------------------------------

SLOPE = {"radius": 60.0, "theta_1": math.radians(220.0), "theta_2": math.radians(290.0), "unit_weight": 19e3,
         "gravity": 9.81}  # limit friction 0.249  # fmt: skip
_STORED: Data = json.loads(FILE.with_name("scenes.json").read_text("utf-8"))
LAWS, EFFECTS = _STORED["laws"], _STORED["effects"]
TURNING: Data = {"rotation": {}, "centripetal": {}}
KINDS = ("rectangular", "triangular", "half-sine", "sine")


def scene(friction: Any, effects: Mapping[str, Any], velocity: float = 0.0, end: float | None = None, **arc: float
          ) -> Data:  # fmt: skip
    """Return the data of a scene of the slope `SLOPE`, of which ``arc`` replaces some fields."""
    return {"arc": SLOPE | arc, "friction": friction, "effects": dict(effects), "initial_velocity": velocity,
            "end_time": end}  # fmt: skip


def mirrored(given: Data) -> Data:
    """Return the scene mirrored in a vertical line: only the angles change, since positive is down-slope."""
    first, second = given["arc"]["theta_1"], given["arc"]["theta_2"]
    return given | {"arc": given["arc"] | {"theta_1": 3 * math.pi - second, "theta_2": 3 * math.pi - first}}


def to_the_right(given: Data) -> Data:
    """Return the scene or its mirror image, the one in which counterclockwise is down-slope, as the oracles require."""
    return mirrored(given) if given["arc"]["theta_1"] + given["arc"]["theta_2"] > 3 * math.pi else given


SHIPPED = ("newmark-pulse", "vaiont-as-printed", "vaiont-frozen", "vaiont-heated", "vaiont-rate", "vaiont-shaken",
           "vaiont-softening", "vaiont", "wet-slope")  # fmt: skip


def rows() -> dict[str, Data | None]:
    """Return the data of all scenes by name; shipped scenes have none."""
    return _STORED["scenes"] | dict.fromkeys(SHIPPED)


def built(name: str, given: Data | None) -> Scene:
    """Return the scene of its data, or the shipped scene of this name where there are none."""
    if given is None:
        return load(name)
    effects = {e: dict(parameters) for e, parameters in given["effects"].items()}
    shaking = effects.get("shaking", {})
    if "time" in shaking:
        time = shaking.pop("time")
        shaking |= {
            k: Series(np.array(time), np.array(shaking[k]), held=False)
            for k in ("horizontal", "vertical")
            if k in shaking
        }
    return Scene(Arc(**given["arc"]), given["friction"], effects, given["initial_velocity"], given["end_time"],
                 name=name)  # fmt: skip


@cache
def solved(name: str) -> Motion:
    """Return the motion of the scene of this name."""
    found = solve(built(name, rows()[name]))
    assert isinstance(found, Motion)
    return found


# --- its numbers -----------------------------------------------------------------------------------------------------


def times(motion: Motion) -> list[float]:
    return [share * motion.duration for share in SHARES]


def numbers(motion: Motion, at: list[float]) -> Data:
    """Return every public number of a motion, with states at times in s."""
    energy = motion.energy_at(np.array([*at, motion.duration]))
    found: Data = {
        "moves": motion.moves, "arrested": motion.arrested, "lifts": len(motion.lift_off),
        "ill": any("ill-conditioned" in w for w in motion.warnings),
        "duration": motion.duration, "run_out": motion.run_out, "limit_friction": motion.limit_friction,
        "yield_coefficient": motion.yield_coefficient, "factor_of_safety": motion.factor_of_safety,
        "lift_off": list(motion.lift_off), "estimate": motion.error_estimate,
        "pore_pressure": motion.pore_pressure_at(np.array(at)).tolist(), "times": at,
        "energy": {k: np.asarray(v).tolist() for k, v in asdict(energy).items()},
    }  # fmt: skip
    for what, state in (("peak", motion.peak), ("end", motion.end), ("at", motion.at(np.array(at)))):
        found[what] = {k: np.asarray(getattr(state, k)).tolist() for k in STATE}
    return found


def differences(name: str, motion: Motion, kept: Data) -> list[str]:
    """Return a line for each number that differs from the stored one by more than both error estimates allow."""
    found, arc = numbers(motion, kept["times"]), motion.plan.scene.arc
    error = motion.error_estimate + kept["estimate"] + 4e-15
    run_out, peak, duration = abs(kept["run_out"]), abs(kept["peak"]["velocity"]), max(kept["duration"], 1e-300)
    radius, gravity, stress = float(arc.radius), float(arc.gravity), float(arc.static_normal_stress)
    # A place of greatest speed or of no pressure is a root of what is known with an error of this size.
    flat = 30 * math.sqrt(error)
    # A mass that approaches its terminal velocity is as fast from some time on to the end, which only rounding finds.
    uniform = 0.0 < peak <= abs(kept["end"]["velocity"]) * (1.0 + error) and abs(kept["end"]["acceleration"]) < error
    place = duration if uniform else flat * duration
    near = {"time": error * duration, "rotation": error * run_out / radius, "displacement": error * run_out,
            "velocity": error * peak, "angular_velocity": error * peak / radius,
            "acceleration": 300 * error * gravity, "normal_stress": 300 * error * stress}  # fmt: skip
    loose = near | {"time": place, "rotation": place * peak / radius, "displacement": place * peak,
                    "acceleration": flat * gravity, "normal_stress": flat * stress}  # fmt: skip
    energy = max(np.max(np.abs(v)) for v in kept["energy"].values())
    statics = ("limit_friction", "yield_coefficient", "factor_of_safety")
    bounds: Data = dict.fromkeys(("moves", "arrested", "lifts", "ill", "times"), 0.0)
    bounds |= {k: 1e-13 * max(1.0, abs(kept[k])) for k in statics}
    bounds |= {"duration": error * duration, "run_out": error * run_out, "lift_off": place,
               "pore_pressure": 300 * error * stress, "energy": dict.fromkeys(kept["energy"], 100 * error * energy),
               "peak": loose, "end": near, "at": near}  # fmt: skip
    faults = [f"{name}:{fault}" for fault in compared(found, kept, bounds)]
    faults += slope_faults(name, motion, kept["sensitivity"] or {})
    # As fast at the time at which it was fastest: sharper than that time itself.
    if kept["moves"] and abs(motion.at(kept["peak"]["time"]).velocity - kept["peak"]["velocity"]) > error * peak:
        faults.append(f"{name}: not as fast at the time of the peak")
    if not (2e-16 if kept["moves"] else 0.0) <= motion.error_estimate <= max(1e3 * kept["estimate"], 1e-11):
        faults.append(f"{name}: the estimate is {motion.error_estimate}, was {kept['estimate']}")
    return faults


def slope_faults(name: str, motion: Motion, kept: Data) -> Iterator[str]:
    """Yield a line for each derivative farther from the stored one than its error bound.

    A bound above a small part of the outcome, in the scale of the number, is a fault, too. Stored derivatives are by
    the equation of variations; at a kink one of the two slopes is stored.
    """
    if not kept:
        return
    found, free = motion.sensitivity(), parameters(motion.plan.scene)
    for number, values in kept.items():
        largest = np.max(np.abs(values))
        for output, value in zip(("peak_velocity", "run_out", "duration"), values, strict=True):
            place = list(found.outputs).index(output), list(found.parameters).index(number)
            kind, slope, error = found.kinds[place], found.values[place], found.errors[place]
            if kind == "kink":
                side = np.argmin(np.abs(found.slopes[place] - value))
                slope, error = found.slopes[place][side], found.slope_errors[place][side]
            cap = 1e-7 * max(largest, abs(found.at[output]) / free[number].scale)
            known = abs(slope - value) <= error + 1e-13 * largest and error <= cap
            if not known:
                yield f"{name}: {output} by {number}: {slope!r} to {error:.2g} ({kind}), was {value!r}"


def compared(one: Any, other: Any, bound: Any) -> Iterator[str]:
    """Yield a line for each number that differs by more than its bound; infinities may be equal."""
    if isinstance(bound, dict):
        for key in bound:
            yield from (f" {key}{fault}" for fault in compared(one[key], other[key], bound[key]))
        return
    with np.errstate(invalid="ignore"):
        near = np.shape(one) == np.shape(other) and (
            np.equal(one, other) | (np.abs(np.subtract(one, other, dtype=float)) <= bound)
        )
    if not np.all(near):
        yield f" is {one!r}, was {other!r}, bound {bound:.2g}"


# --- the file --------------------------------------------------------------------------------------------------------


def read(file: Path) -> list[Data]:
    """Return the rows of a stored reference."""
    return list(json.loads(file.read_text("utf-8")))


def write(file: Path, stored: Iterable[Data]) -> None:
    """Store rows in a JSON file, one line for each."""
    file.write_text("[\n" + ",\n".join(map(json.dumps, stored)) + "\n]\n", "utf-8")


def main() -> None:
    kept = {row["name"]: row["numbers"] for row in read(FILE)}
    found: list[Data] = []
    for name in rows():
        motion, before = solved(name), kept.get(name)
        if before is None or differences(name, motion, before):
            before = numbers(motion, times(motion)) | {"sensitivity": (before or {}).get("sensitivity")}
        found.append({"name": name, "numbers": before})
    write(FILE, found)


if __name__ == "__main__":
    main()
