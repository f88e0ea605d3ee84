"""What solving scenes costs: this package beside DOP853 and heyoka, each judged by answers to 24 digits.

The answers are the tests' Taylor series in ball arithmetic.
"""

import json
from collections.abc import Iterator, Mapping
from dataclasses import replace
from decimal import Decimal
from functools import cache, partial
from pathlib import Path
from typing import Any

import numpy as np

from slipcircle.base.kinds import Floats
from slipcircle.core import Scene, numpy_only, solve
from slipcircle.tables import Series
from slipcircle.workbench.cost import peers
from slipcircle.workbench.cost.peers import LAYER, SHEARED, Equation
from slipcircle.workbench.cost.reference import reference
from slipcircle.workbench.cost.ways import Subject, Way
from slipcircle.workbench.files.scenefile import load

ACCURACIES = (1e-3, 1e-6, 1e-9, 1e-12, 1e-15)
TOLERANCES = (*ACCURACIES[:-1], 1e-13)  # of SciPy, which grants no less
ANGLES = (10.0, 14.0, 19.5)  # of friction, deg: the first and last of an ensemble, and between them that of one scene
RESIDUAL = float(np.tan(np.radians(8.0)))
RECORD_SAMPLES = 4000
RECORD_END = 20.0  # s
BATCH = 32  # lanes of heyoka at once: as many as still gain
# Run-out, peak velocity and duration by friction, of one scene and then of an ensemble's lanes, to 24 digits;
# ``python -m tests.campaigns.exact_scenes`` writes them.
ANSWERS = Path(__file__).with_name("answers.json")
PATIENCE = 5.0  # of a pass over scenes, as of `Subject`
FROZEN = "frozen geometry"
CLOSED_FORM = "closed form in time"


def _record() -> Series:
    """k_h over time: twelve sines under an envelope, sampled; straight lines between."""
    rng = np.random.default_rng(1963)
    time = np.linspace(0.0, RECORD_END, RECORD_SAMPLES)
    frequencies = rng.uniform(3.0, 40.0, 12)
    phases = rng.uniform(0.0, 6.3, 12)
    angles = time[:, None] * frequencies + phases
    waves = np.sin(angles).sum(axis=1)
    envelope = np.sin(np.pi * time / RECORD_END) ** 2
    return Series(time, 0.01 * waves * envelope)


# A law of friction, to be given its peak, and effects, which Vaiont's scene gets beside its own.
CASES: Mapping[str, tuple[Mapping[str, Any], Mapping[str, Any]]] = {
    FROZEN: ({}, {}),
    "constant friction": ({}, {}),
    "softening": ({"law": "exponential", "residual": RESIDUAL, "length": 1.0}, {}),
    "rate weakening": ({"law": "rate_weakening", "residual": RESIDUAL, "velocity": 5.0}, {}),
    "heat": ({}, {"thermal_pressurisation": LAYER}),
    "viscosity": ({}, {"viscosity": SHEARED}),
    "record": ({}, {"shaking": {"horizontal": _record()}}),
}
_shipped = cache(load)


def scene(name: str, mu: Any) -> Scene:
    """A scene of `CASES` with a friction coefficient, or with many."""
    law, effects = CASES[name]
    whole = _shipped("vaiont-frozen" if name == FROZEN else "vaiont")
    friction = {**law, "peak": mu} if law else mu
    return replace(whole, friction=friction, effects={**whole.called, **effects})


_single_scene = cache(scene)


@cache
def equation(name: str) -> Equation:
    """The equation of motion of a case, written out by hand."""
    return Equation(scene(name, 0.1), CASES[name][0])


def frictions(count: int) -> Floats:
    """Friction coefficients of an ensemble, or that of one scene."""
    first, single, last = ANGLES
    angles = np.linspace(first, last, count) if count > 1 else [single]
    return np.tan(np.radians(angles))


def solved(name: str, accuracy: float, mu: Any) -> Floats:
    """Run-out, peak velocity and duration by this package, (3, scenes)."""
    is_single = np.size(mu) == 1
    chosen = _single_scene(name, float(np.squeeze(mu))) if is_single else scene(name, mu)
    outcomes = solve(chosen, accuracy).outcomes
    rows = [outcomes[key] for key in ("run_out", "peak_velocity", "duration")]
    return np.array(rows).reshape(3, -1)


def solved_in_numpy(name: str, accuracy: float, mu: Any) -> Floats:
    """The same without compiled code."""
    with numpy_only():
        return solved(name, accuracy, mu)


def subject(name: str, many: bool) -> Subject:
    """One scene, or many of one arc: ways from friction coefficients to run-out, peak velocity and duration."""
    known = json.loads(ANSWERS.read_text("utf-8"))[name]
    single, *lanes = known
    which = lanes if many else [single]
    answers = [[Decimal(known[mu][outcome]) for mu in which] for outcome in range(3)]
    points = np.array([which], dtype=np.float64)
    exact = reference(points, answers)
    title = f"{name}, 10000 scenes" if many else name
    sizes = (1,) if many else (0,)
    ways = [*_ways(name, many)]
    return Subject(title, ways, lambda kind: exact, lambda count: frictions(count)[None], sizes, PATIENCE)


def _ways(name: str, many: bool) -> Iterator[Way]:
    shaken = "shaking" in CASES[name][1]
    for accuracy in ACCURACIES:
        yield Way(f"slipcircle, {accuracy:.0e}", partial(solved, name, accuracy), ours=True)
    with numpy_only() as compiled:
        in_numpy: tuple[float, ...] = ACCURACIES[::2]
        if shaken:
            in_numpy = () if many else (1e-9,)
        for accuracy in in_numpy if compiled else ():
            yield Way(f"slipcircle, NumPy, {accuracy:.0e}", partial(solved_in_numpy, name, accuracy), ours=True)
    by_hand = equation(name)
    if name == FROZEN:
        yield Way(CLOSED_FORM, partial(peers.closed_form, by_hand), ours=True)
    for tolerance in TOLERANCES:
        yield Way(f"DOP853, rtol {tolerance:.0e}", partial(peers.dop853, by_hand, tolerance), needs="scipy")
    if not shaken:  # heyoka has no tables
        lanes = BATCH if many else 1
        for tolerance in ACCURACIES:
            yield Way(f"heyoka, tol {tolerance:.0e}", partial(peers.heyoka, by_hand, tolerance, lanes), needs="heyoka")
