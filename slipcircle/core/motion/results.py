"""What a motion says of itself: a line, its lanes, warnings."""

from collections.abc import Mapping
from dataclasses import replace
from math import prod
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from slipcircle.base.text import digits_left, shown
from slipcircle.core.flow.lanes import Lanes
from slipcircle.core.motion.forms import Forms
from slipcircle.core.motion.plan import Plan
from slipcircle.core.motion.states import Status
from slipcircle.core.scene.section import Section
from slipcircle.workbench.files.variation import scene_with

_SURE = 1e-11  # an estimated error below which only the format limits what is known
BALANCED = 1e-12  # of all energy on the way, to which it is balanced at least, or a warning says so


class Results(Forms):
    """What `Motion` and its lanes are shown as."""

    plan: Plan
    _lanes: Lanes
    _cells: Mapping[int, NDArray[np.float64]]
    shape: Any
    status: Any
    outcomes: Any
    count: Any
    error_estimate: Any
    moves: Any
    arrested: Any
    factor_of_safety: Any
    run_out: Any

    def __repr__(self) -> str:
        name = f"{self.plan.scene.name}: " if self.plan.scene.name else ""
        if not self.shape:
            return f"<Motion {name}{self._summary()}>"
        counts = ", ".join(f"{count} {status.lower()}" for status, count in self.count().items())
        run_outs = self.run_out[~np.isnan(self.run_out)]
        span = f"{shown(run_outs.min())} to {shown(run_outs.max())} m" if run_outs.size else "not known"
        return f"<{prod(self.shape)} motions {name}{counts}; run-out {span}>"

    def _summary(self) -> str:
        """What became of a single motion, in half a line."""
        digits = digits_left(self.error_estimate)
        if not self.moves:
            return f"does not move, factor of safety {shown(self.factor_of_safety)}"
        velocity, run_out, duration = (
            shown(self.outcomes[n], digits) for n in ("peak_velocity", "run_out", "duration")
        )
        end = "comes to rest after" if self.arrested else "still moving at"
        return f"{velocity} m/s at most; run-out {run_out} m; {end} {duration} s"

    @property
    def reason(self) -> Any:
        """Why there is no answer, of each lane; empty where there is one."""
        return np.array([s.reason for s in Status])[self.status] if self.shape else self.status.reason

    def __len__(self) -> int:
        if not self.shape:
            raise TypeError("a single motion has no len(): it is not of a scene of arrays")
        return int(self.shape[0])

    def __bool__(self) -> bool:
        return True

    def __getitem__(self, index: Any) -> Self:
        """The motion of one lane, or of some, by NumPy's indices of the scene's shape."""
        if not self.shape:
            raise TypeError("a single motion has no lanes: it is not of a scene of arrays")
        scene = self.plan.scene
        which = np.arange(prod(self.shape)).reshape(self.shape)[index]
        varied = {n: np.broadcast_to(v, self.shape)[index] for n, v in scene.numbers.items() if np.ndim(v)}
        plan = replace(self.plan, scene=scene_with(scene, varied))
        lanes = self._lanes.taken(np.ravel(which))
        made: Any = type(self)
        if np.ndim(which):
            return made(plan, lanes, {k: v[np.ravel(which)] for k, v in self._cells.items()}, [])
        log: list[Any] = []  # which many lanes do not keep
        last = lanes.solve(log)[[*self._cells], 0].tolist()
        return made(plan, lanes, dict(zip(self._cells, last, strict=True)), log)

    @property
    def warnings(self) -> tuple[str, ...]:
        return cautions(self)


def cautions(motion: Any) -> tuple[str, ...]:
    """What a user should know of a single motion; empty where all is well."""
    stability = motion.plan.scene.stability
    found = [stability.warning] if stability and stability.warning else list[str]()
    times = motion.lift_off
    if times:
        more = f", and {len(times) - 1} times more until {times[-1]:.6g} s" if len(times) > 3 else ""
        said = times[:1] if more else times
        found += [f"nothing presses on the slip surface from {t:.6g} s{more} (lift-off)" for t in said]
    if motion.error_estimate > motion.plan.accuracy:
        cause = "its numbers lie far apart"
        if motion.error_estimate < _SURE:
            cause = "no result in float64 is sure to less"
        elif len(motion.phases) > 100:
            cause = "the mass turns back many times"
        elif abs(motion.friction - motion.limit_friction) < 1e-3 * abs(motion.limit_friction):
            cause = "the friction is next to its limit"
        found.append(
            f"ill-conditioned: the estimated error {motion.error_estimate:.1e} is above the accuracy asked for, "
            f"{motion.plan.accuracy:.1e}; {cause}"
        )
    elif motion.moves and motion.energy_error_estimate > BALANCED:
        found.append(
            f"ill-conditioned: the energy is balanced to {motion.energy_error_estimate:.1e} only, as what drives and "
            "what resists are all but equal"
        )
    section = motion.plan.scene.arc
    depth = section.drowned(motion.reach.rotation, motion.end.rotation) if isinstance(section, Section) else 0.0
    if depth > 1e-6 * motion._lanes.radius:
        found.append(
            f"turning brings ground down to {depth:.3g} m below the water level; the weight of the water "
            "above it is left out"
        )
    if motion.swings_back:
        found.append(
            f"the mass swings back: it reaches {abs(motion.reach.displacement):.4g} m after {motion.reach.time:.4g} s, "
            f"farther than its run-out of {abs(motion.run_out):.4g} m at the end"
        )
    return tuple(found)
