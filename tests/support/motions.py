"""Properties of every motion: finite states, rest after an arrest, energy in balance."""

from dataclasses import asdict, replace
from typing import Any

import numpy as np

from slipcircle import Motion


def size(found: Any) -> float:
    return float(np.max(np.abs(found), initial=0.0))


def residual(motion: Motion, count: int = 21) -> float:
    """Return the worst energy residual at any time, relative to all energy there was until then.

    Until then, not just then: a pendulum at its far standstill has neither speed nor work.
    """
    energy = motion.energy_at(np.linspace(0.0, motion.duration, count))
    total = np.maximum.accumulate(energy.kinetic_start + np.abs(energy.work) + energy.dissipation)
    assert np.all(energy.dissipation >= 0.0)
    return size(np.asarray(energy.residual)[total > 0.0] / total[total > 0.0])


def ill_conditioned(motion: Motion) -> bool:
    """Whether the user is told so."""
    return any("ill-conditioned" in w for w in motion.warnings)


def finite(motion: Motion) -> None:
    """No NaN, no infinity, states at rest after an arrest, phases in order, and the energy balance."""
    times = np.linspace(0.0, motion.duration, 17)
    states = [motion.at(times), motion.peak, motion.end]
    assert all(np.all(np.isfinite(x)) for s in states for x in asdict(s).values())
    assert np.isfinite([motion.run_out, motion.duration, motion.error_estimate]).all()
    assert not np.isnan([motion.factor_of_safety, motion.limit_friction, motion.yield_coefficient]).any()
    said = max(motion.error_estimate, motion.energy_error_estimate) if ill_conditioned(motion) else 0.0
    assert residual(motion, 21) <= max(1e-12, said)
    assert size(states[0].velocity) <= abs(float(motion.peak.velocity)) * (1 + 1e-12)


def from_method(scene: Any, method: str) -> Any:
    """Return a scene on a ground that starts from the factor of safety of a method."""
    return replace(scene, start=method)
