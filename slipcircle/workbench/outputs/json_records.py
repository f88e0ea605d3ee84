"""Conversion of a motion and the stretches of its arc to JSON."""

from collections.abc import Mapping
from dataclasses import asdict
from typing import Any

from slipcircle.base.kinds import ValueDict
from slipcircle.layers import LayeredSection, stretches
from slipcircle.workbench.common.quantities import RESULTS, factors_of, json_values, results
from slipcircle.workbench.common.starting import method_of, starts
from slipcircle.workbench.files.loaded import stability_of, warnings_of
from slipcircle.workbench.stability.starting import OF_CLOSURE


def record(motion: Any) -> ValueDict:
    """Return a motion as values of JSON, in SI units; infinite and unknown values become None."""
    scene, law = motion.plan.scene, motion.plan.scene.friction
    stability = stability_of(scene)
    factors = motion.further_factors
    further = {"residual": factors.residual_method, "final": factors.at_rest_method}
    states = {name: asdict(getattr(motion, name)) for name in ("farthest", "peak", "end")}
    return json_values(
        {
            "scene": scene.name,
            "note": scene.note,
            "effects": motion.plan.effects,
            "left_out": motion.plan.left_out,
            "method": motion.plan.method,
            "law": law if isinstance(law, Mapping) else {"law": motion.plan.law},
            "dimensionless": scene.arc.dimensionless,
        }
        | {q.name: q.read(motion) for q in results(motion) if "." not in q.path or q not in RESULTS}
        | {"factors_of_safety": factors_of(motion), "factor_of_safety_method": method_of(scene)}
        | {"strength_factor": scene.strength_factor}
        | {f"{name}_factor_of_safety_method": method or OF_CLOSURE for name, method in further.items()}
        | {"starts": [start.record() for start in starts(motion) or ()]}
        | states
        | {"range_end": motion.range_end}
        | ({"observed": scene.observed} if scene.observed else {})
        | ({"stability": stability.record()} if stability else {})
        | ({"stretches": stretch_records(motion)} if isinstance(scene.arc, LayeredSection) else {})
        | {
            "energy": asdict(motion.energy) | {"residual": motion.energy.residual},
            "error_estimate": motion.error_estimate,
            "warnings": warnings_of(motion),
        }
    )


def stretch_records(motion: Any) -> list[ValueDict]:
    """Return the stretches of a layered arc from entry to exit with their soils; empty for another arc."""
    arc = motion.plan.scene.arc
    if not isinstance(arc, LayeredSection):
        return []
    return [stretch._asdict() | {"soil": stretch.soil.name} for stretch in stretches(arc)]


def foreland_words(arc: Any) -> str:
    """Return in words which soil's strength continues beyond the exit of a layered arc; "" for another arc."""
    if not isinstance(arc, LayeredSection) or arc.lanes_shape or arc.strength == "mass":
        return ""
    (layer,) = arc.arc_strength.stretches.last
    why = "as given" if arc.foreland else "the lowest of the soils that meet there"
    return f"the strength of {arc.soils[layer].name}, {why}"
