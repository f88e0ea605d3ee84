"""Key results of a single motion by label, shown by `run`, live pages and notebooks."""

from typing import Any

import numpy as np

from slipcircle.base.kinds import TextDict
from slipcircle.base.text import number_text, output_unit
from slipcircle.core import Motion, Status
from slipcircle.messages import range_words, swings_back
from slipcircle.workbench.common.quantities import (
    OBSERVABLE,
    OUTCOMES,
    RESULTS,
    Interval,
    factor_label,
    factor_text,
    factors_of,
    observable,
)
from slipcircle.workbench.common.starting import method_of, start_words, starts
from slipcircle.workbench.stability.starting import OF_CLOSURE


def key_results(motion: Motion) -> TextDict:
    """Return the key results of a single motion in words, by label.

    These are the factor of safety by the method that starts the motion, the outcomes with their observed values, the
    range of validity, and the run-out from the factor of safety of another method.
    """
    scene = motion.plan.scene
    by_method = factors_of(motion)
    method = next(name for name in (method_of(scene), OF_CLOSURE) if name in by_method)
    column = {factor_label(method): factor_text(by_method[method])}
    observed = scene.observed
    ends = end_words(motion)
    for quantity in dict.fromkeys((*RESULTS, *OBSERVABLE.values())):
        name = quantity.name
        if quantity.key or name in observed:
            column[quantity.label] = ends.get(quantity.label) or quantity.text(motion)
        if name in observed:
            column[quantity.label] += f", {_observation(motion, name, observed[name])}"
    if motion.moves:
        left = range_words(motion)
        column["range of validity"] = f"left {left}" if left else "kept throughout"
    if both := starts(motion):
        column["alternative start"] = start_words(motion, both[1:])
    return column


def end_words(motion: Motion) -> TextDict:
    """Return texts, by label, that replace outcomes of a motion that does not simply come to rest."""
    run_out = "run-out along the arc"
    if not motion.moves:
        return {"comes to rest": "does not move", "duration": "does not move"}
    words = {}
    if swings_back(motion):
        places = (OUTCOMES["run_out"], OBSERVABLE["end_displacement"])
        words[run_out] = ", then back to ".join(quantity.text(motion) for quantity in places)
    if motion.arrested:
        return words
    if motion.status is Status.CREEPS:
        arrival = f"infinite, 99 % of the run-out in {number_text(motion.settling_time)} s"
        return words | {"comes to rest": "no, it creeps to its equilibrium", "duration": arrival}
    time = OUTCOMES["duration"].text(motion)
    if motion.plan.scene.end_time is None:
        return words | {"comes to rest": "no, nothing holds it", "duration": f"first standstill at {time}"}
    return words | {"comes to rest": "no", "duration": f"still moving at {time}"}


def _observation(motion: Motion, name: str, seen: Any) -> str:
    """Return an observed value with its error in words, or whether the outcome is in the observed interval.

    ``name`` is that of the outcome, and ``seen`` a number, a pair or an interval in SI units.
    """
    factor, unit = output_unit(OBSERVABLE[name].unit)
    if isinstance(seen, Interval):
        side = "inside" if seen.low <= observable(motion, name) <= seen.high else "outside"
        return f"{side} the observed {seen.times(factor)} {unit}"
    return f"observed {' +- '.join(map(number_text, np.multiply(factor, np.ravel(seen)).tolist()))} {unit}"
