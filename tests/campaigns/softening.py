"""Motions with softening cohesion beside a plain integration: ``python -m tests.campaigns.softening [SCENES] [SEED]``.

Forces are integrals along rays from the centre, by Gauss' rule between kinks (`tests.support.along_the_arc`), with the
strength of each soil at the slip of the moment; SciPy's DOP853 integrates them. Random layers, laws of friction and of
cohesion, strength of the base or with the mass.
"""

import sys
from collections.abc import Iterator
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

from slipcircle import Motion, Scene, solve
from slipcircle.layers import LayeredSection, Soil
from tests.support.along_the_arc import AlongTheArc, random_section

BOUND = 1e-8
TURNING = ["rotation", "centripetal"]


def at_slip(law: Any, slip: float) -> float:
    """A friction coefficient or a cohesion after a slip."""
    if callable(law):
        return float(law(slip))
    if not isinstance(law, dict):
        return float(law)
    share = {
        "exponential": np.exp(-slip / law["length"]),
        "linear": 1.0 - min(slip / law["length"], 1.0),
        "hyperbolic": 1.0 / (1.0 + slip / law["length"]),
    }
    return float(law["residual"] + (law["peak"] - law["residual"]) * share[law["law"]])


class Softened(AlongTheArc):
    """A slope whose soils have the strength of a slip."""

    def __init__(self, section: LayeredSection) -> None:
        numbers = [replace(soil, friction=0.0, cohesion=0.0) for soil, _ in section.layers]
        plain = replace(section, layers=[(soil, top) for soil, (_, top) in zip(numbers, section.layers, strict=True)])
        super().__init__(plain, section)
        self.given: list[Any] = [soil for soil, _ in section.layers]

    def columns(self, rotation: float = 0.0, strength: str = "base") -> Any:  # type: ignore[override]
        slip = rotation * self.radius
        at_this_slip: list[Any] = []
        for soil in self.given:
            cohesion, before = (at_slip(soil.cohesion, s) for s in (slip, 0.0))
            changes = isinstance(soil.cohesion, dict) or callable(soil.cohesion)
            at_this_slip.append(
                SimpleNamespace(
                    friction=at_slip(soil.friction, slip),
                    cohesion=cohesion,
                    cohesion_gradient=soil.cohesion_gradient * (cohesion / before if changes else 1.0),
                    pore_ratio=soil.pore_ratio,
                )
            )
        self.soils = at_this_slip
        return AlongTheArc.columns.__wrapped__(self, rotation, strength)


def farthest(section: Any) -> tuple[float, float]:
    """Greatest displacement down-slope and its time by DOP853, m and s."""
    slope, radius = Softened(section), float(section.radius)

    def rate(_: float, state: Any) -> tuple[float, float]:
        rotation, omega = state
        moment = SimpleNamespace(rotation=rotation, angular_velocity=omega, velocity=1.0)
        return omega, slope.acceleration(moment) / radius

    def stands(time: float, state: Any) -> float:
        return float(state[1]) if time > 1e-3 else 1.0

    stands.terminal, stands.direction = True, -1  # type: ignore[attr-defined]
    done = solve_ivp(rate, (0.0, 1e3), (0.0, 0.0), "DOP853", rtol=1e-11, atol=1e-13, events=stands)
    return float(done.y[0, -1]) * radius, float(done.t[-1])


def random_soils(rng: np.random.Generator, soils: list[Soil], strength: str) -> list[Soil]:
    """Soils with random laws: with the base one of friction and one of cohesion, with the mass each its own."""
    laws = rng.choice(["exponential", "linear", "hyperbolic"], 2)
    lengths = rng.uniform(0.3, 3.0, 2)
    made = []
    for k, soil in enumerate(soils):
        if strength == "mass":
            laws, lengths = rng.choice(["exponential", "linear", "hyperbolic"], 2), rng.uniform(0.3, 3.0, 2)
        peak, residual = rng.uniform(0.0, 0.3, 2) * rng.choice([0.0, 1.0], p=[0.2, 0.8])
        friction = {"law": str(laws[0]), "peak": peak, "residual": residual, "length": float(lengths[0])}
        peak, residual = rng.uniform(1e2, 1.5e4, 2)
        cohesion = {"law": str(laws[1]), "peak": peak, "residual": residual, "length": float(lengths[1])}
        made.append(replace(soil, friction=friction, cohesion=cohesion if k else float(peak), name=f"soil {k}"))
    return made


def scenes(rng: np.random.Generator) -> Iterator[tuple[LayeredSection, Motion]]:
    """Sections that move down-slope, with their motions."""
    while True:
        strength = str(rng.choice(["base", "mass"]))
        section = random_section(rng, strength="base")
        soils = random_soils(rng, [soil for soil, _ in section.layers], strength)
        layers = [(soil, top) for soil, (_, top) in zip(soils, section.layers, strict=True)]
        try:
            section = replace(section, layers=layers, strength=strength)
            motion = solve(Scene(section, None, TURNING, end_time=1e3))
        except ValueError:
            continue
        if motion.moves and motion.arrested and 0.2 < motion.run_out < 40.0:
            yield section, motion


def difference(section: LayeredSection, motion: Motion) -> float:
    """The relative difference of the greatest displacement, or of its time if that is greater."""
    distance, time = farthest(section)
    return max(abs(motion.run_out / distance - 1.0), abs(motion.farthest.time / time - 1.0))


def main() -> int:
    """Compare as many scenes as requested; return 1 where one differs."""
    count, seed = (int(x) for x in (*sys.argv[1:], "200", "1")[:2])
    found = []
    for _, (section, motion) in zip(range(count), scenes(np.random.default_rng(seed)), strict=False):
        found.append(difference(section, motion))
        print(f"{len(found)}: {section.strength}, {motion.run_out:.4g} m, {found[-1]:.1e}", flush=True)
    print(f"{len(found)} motions agree with a plain integration to {max(found):.1e}")
    return int(not max(found) < BOUND)


if __name__ == "__main__":
    sys.exit(main())
