"""Error estimates are upper bounds: ``python -m tests.campaigns.estimates 2000 --seed 1``.

Random scenes of every kind, each alone and with a neighbour as an ensemble at accuracies from 1e-3 to 1e-12, against
the ensemble at 1e-16; then the scenes of `references` and `section_references` as ensembles, against their 20 to 30
digits. Prints what is too low and, for each kind, the estimates below their error and the median of the ratio; the exit
status is 1 if more than 1 in 1,000 are, or if that median is above 30.
"""

import contextlib
import json
import sys
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from functools import partial
from itertools import chain
from typing import Any, NamedTuple

import numpy as np

from slipcircle import Arc, Motion, Scene, Section, solve
from slipcircle.derivatives.parameters import parameter_value, parameters, with_parameter_arrays
from tests.campaigns import options
from tests.campaigns.lanes import random_profile
from tests.support import accuracy, combinations, section_references
from tests.support.along_the_arc import random_section
from tests.support.taylor import Unfit

ACCURACIES = [10.0**-digits for digits in range(3, 13)]
ALONE = 0.0  # in their place
REFERENCE = 1e-16
ROUNDING = 1e-16  # what an error counts as, at least, where ratios to it are taken
STORED = [*accuracy.ROWS, *json.loads(section_references.FILE.read_text("utf-8"))]
ONE_IN = 1000
MOST = 30.0
Rng = np.random.Generator


class Case(NamedTuple):
    """The true error of a lane at an accuracy, and its estimate."""

    kind: str
    number: int
    accuracy: float
    error: float
    estimate: float


# --- random scenes ---------------------------------------------------------------------------------------------------


def of_arc(rng: Rng) -> Scene:
    """Any effects and any law, pushed either way or not, until some time, or until it rests."""
    law = str(rng.choice([law for law in combinations.LAWS if law != "callable"]))
    effects = combinations.ALL[rng.integers(len(combinations.ALL))]
    scene = combinations.built(combinations.drawn(effects, law, int(rng.integers(2**31))), law)
    return replace(scene, end_time=None) if rng.random() < 0.5 else scene


def of_section(rng: Rng) -> Scene:
    """Return a mass under any ground, dry or under a level, with every kind of time, rate, heat and record."""
    return section_references.scene(section_references.drawn(rng))


def of_layers(rng: Rng) -> Scene:
    """Soils with strengths of their own along the base, carried with the mass, or in profiles that coincide."""
    if rng.random() < 0.3:
        return random_profile(rng)
    section = random_section(rng, 0.25, strength=rng.choice(["base", "mass"]), crack=rng.choice([0.0, 2.0]))
    effects: dict[str, Any] = {"rotation": {}, "centripetal": {}} if rng.random() < 0.5 else {"rotation": {}}
    if rng.random() < 0.3:
        length = float(rng.uniform(1.0, 5.0))
        effects["shaking"] = {"pulse": "sine", "amplitude": 0.4, "duration": length, "cycles": 3.0}
    return Scene(section, effects=effects)


def of_creep(rng: Rng) -> Scene:
    """Return a viscous layer, from one that hardly brakes to one that implicit steps follow."""
    dip, half, radius = rng.uniform(0.3, 1.0), rng.uniform(0.3, 1.4), 10 ** rng.uniform(0.5, 3.5)
    middle = 1.5 * np.pi - dip
    arc = Arc(radius, middle - half, middle + half, 2e4)
    low, high = float(arc.dimensionless.limit_friction) * np.array([rng.uniform(0.3, 0.9), rng.uniform(0.9, 1.0)])
    friction = low
    if rng.random() < 0.6:
        law = str(rng.choice(["exponential", "linear", "hyperbolic"]))
        friction = combinations.softening(law, high, low, radius * 10 ** rng.uniform(-3, -1))
    brake = 10 ** rng.uniform(-1, 6) * float(arc.dimensionless.moment_of_inertia) / (2 * half)
    viscosity = brake * 2e4 / 9.81 * 0.1 * np.sqrt(radius * 9.81)
    end_time = None if rng.random() < 0.7 else 10 ** rng.uniform(0, 3) * np.sqrt(radius / 9.81)
    return Scene(
        arc, friction, {"rotation": {}, "viscosity": {"viscosity": viscosity, "thickness": 0.1}}, end_time=end_time
    )


def on_far_shore(rng: Rng) -> Scene:
    """Return a thin mass in a bowl with water above its middle: it floats, and lands where it leaves the water."""
    radius, thin, dip = 10 ** rng.uniform(1, 4.5), 10 ** rng.uniform(-8, -1), rng.uniform(0.2, 0.6)
    depth = thin * radius
    chord = np.sqrt(2 * depth * radius) * np.array([np.cos(dip), -np.sin(dip)])
    wide = rng.uniform(2.0, 1.0 / np.sqrt(2 * thin))
    ground = np.outer([-wide, -1.5, 1.5, wide], chord)
    centre = (radius - depth) * np.array([np.sin(dip), np.cos(dip)])
    section = Section(ground, centre, radius, 2e4, level=ground - [0.0, depth * rng.uniform(0.1, 0.9)])
    return Scene(section, np.tan(dip) * rng.uniform(0.5, 1.0), {"rotation": {}})


KINDS: dict[str, Callable[[Rng], Scene]] = {
    "arc": of_arc, "section": of_section, "far shore": on_far_shore, "layers": of_layers, "creep": of_creep
}  # fmt: skip
TURNS = list(KINDS)[:-1] * 10  # of the kinds, one after the other
TURNS[-1] = "creep"  # a hundred times slower than others


def drawn(kind: str, rng: Rng) -> Scene:
    """Return the first scene of a kind that is one and has a motion."""
    while True:
        with contextlib.suppress(Unfit, ValueError):
            scene = KINDS[kind](rng)
            solve(scene)
            return scene


def with_neighbour(scene: Scene, rng: Rng) -> tuple[Scene, Any]:
    """Return an ensemble of a scene and a neighbour that differs by about a percent in a number, and invalid lanes."""
    every = {name: parameter_value(scene, name) for name in parameters(scene) if not name.endswith("gradient")}
    values = {name: value for name, value in every.items() if value}
    name = str(rng.choice(list(values)))
    return with_parameter_arrays(scene, {name: values[name] * (1.0 + rng.normal(0.0, 0.01) * np.arange(2.0))})


# --- errors ----------------------------------------------------------------------------------------------------------


def results(motion: Motion, lanes: int) -> Any:
    """Peak velocity, run-out and duration, of a mass that creeps the time to nearly all of it; NaN without any."""
    outcomes = motion.outcomes
    return np.array([outcomes["peak_velocity"], outcomes["run_out"], motion.settling_time]).reshape(3, lanes)


def errors(motion: Motion, exact: Any) -> Any:
    """Return the true relative error of each lane; 1 where one has no result, and NaN where neither has."""
    found = results(motion, exact.shape[1])
    with np.errstate(invalid="ignore", divide="ignore"):
        relative = np.where(found == exact, 0.0, np.abs(found - exact) / np.abs(exact)).max(axis=0)
    lost, none = np.isnan(found).any(axis=0), np.isnan(exact).any(axis=0)
    return np.where(lost & none, np.nan, np.where(lost | none, 1.0, np.minimum(relative, 1.0)))


def compared(number: int, seed: int) -> list[Case]:
    """Return a random scene, alone and with its neighbour at each accuracy."""
    kind, rng = TURNS[number % len(TURNS)], np.random.default_rng([seed, number])
    scene = drawn(kind, rng)
    lanes, invalid = with_neighbour(scene, rng)
    exact = results(solve(lanes, REFERENCE, invalid=invalid), 2)
    alone = solve(scene)
    rows = [(ALONE, errors(alone, exact[:, :1]), [alone.error_estimate])]
    for requested in ACCURACIES:
        motion = solve(lanes, requested, invalid=invalid)
        rows.append((requested, errors(motion, exact), motion.error_estimate))
    return [
        Case(kind, number, requested, error, estimate)
        for requested, of_lanes, estimates in rows
        for error, estimate in zip(of_lanes.tolist(), map(float, estimates), strict=True)
        if not np.isnan(error)
    ]


def stored(number: int) -> list[Case]:
    """Return a scene of the references twice, as an ensemble: against digits of another method."""
    row = STORED[number]
    scene = section_references.scene(row["scene"]) if "ground" in row["scene"]["arc"] else accuracy.scene(row)
    name = next(name for name in ("radius", "gravity") if parameter_value(scene, name))
    twice, _ = with_parameter_arrays(scene, {name: np.full(2, parameter_value(scene, name))})
    exact = [row["reference"][key] for key in ("peak_velocity", "run_out", "duration")]
    cases = []
    for requested in ACCURACIES:
        motion = solve(twice, requested)
        found = results(motion, 2)[:, 0]
        error = max(accuracy.off(value, digits, digits) for value, digits in zip(found, exact, strict=True))
        cases.append(Case("stored", number, requested, error, float(motion.error_estimate[0])))
    return cases


def said(kind: str, cases: list[Case]) -> tuple[int, float]:
    """Print and return the number of estimates below their error, and the median ratio of estimate to error."""
    low = sum(case.estimate < case.error for case in cases)
    ratios = [case.estimate / max(case.error, ROUNDING) for case in cases if case.estimate > 0.0]
    median = float(np.median(ratios)) if ratios else 0.0
    print(f"{kind:10} {len(cases):6} estimates, {low:3} below the error; median ratio {median:.3g}")
    return low, median


def main() -> int:
    chosen = options(__doc__, 2000)
    numbers = range(chosen.count)
    cases: list[Case] = []
    with ProcessPoolExecutor(2) as pool:
        drawn_cases = pool.map(partial(compared, seed=chosen.seed), numbers, chunksize=4)
        stored_cases = pool.map(stored, range(len(STORED)), chunksize=4)
        for case in chain.from_iterable(chain(stored_cases, drawn_cases)):
            cases.append(case)
            if case.estimate < case.error:
                kind, number, requested, error, estimate = case
                print(f"{kind} {number} at {requested:g}: estimate {estimate:.2g}, error {error:.2g}", flush=True)
    for kind in [*KINDS, "stored"]:
        said(kind, [case for case in cases if case.kind == kind])
    low, median = said("all", cases)
    return int(low * ONE_IN > len(cases) or median > MOST)


if __name__ == "__main__":
    sys.exit(main())
