"""The core: scenes (`scene`), their integration (`flow`), and the resulting motion (`motion`).

The names listed here are public: all that the workbench, or any program built on the core, needs. Each is loaded on
first use, so that importing the core loads nothing.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from slipcircle.base.series import Pulse as Pulse
    from slipcircle.base.series import Series as Series
    from slipcircle.core.flow.compiled import numpy_only as numpy_only
    from slipcircle.core.motion.derivatives import Sensitivity as Sensitivity
    from slipcircle.core.motion.forms import Pictured as Pictured
    from slipcircle.core.motion.motion import Motion as Motion
    from slipcircle.core.motion.plan import Plan as Plan
    from slipcircle.core.motion.plan import plan as plan
    from slipcircle.core.motion.plan import step_operations as step_operations
    from slipcircle.core.motion.solver import solve as solve
    from slipcircle.core.motion.states import ANSWERED as ANSWERED
    from slipcircle.core.motion.states import Energy as Energy
    from slipcircle.core.motion.states import State as State
    from slipcircle.core.motion.states import Status as Status
    from slipcircle.core.scene.arc import ARC_BOUNDS as ARC_BOUNDS
    from slipcircle.core.scene.arc import GIVEN as GIVEN
    from slipcircle.core.scene.arc import GRAVITY as GRAVITY
    from slipcircle.core.scene.arc import WIDTH as WIDTH
    from slipcircle.core.scene.arc import Arc as Arc
    from slipcircle.core.scene.coordinates import arc_numbers as arc_numbers
    from slipcircle.core.scene.forcing import STRONGEST as STRONGEST
    from slipcircle.core.scene.forcing import in_time as in_time
    from slipcircle.core.scene.friction import RATE_LAWS as RATE_LAWS
    from slipcircle.core.scene.friction import friction_at_rest as friction_at_rest
    from slipcircle.core.scene.friction import law_depends as law_depends
    from slipcircle.core.scene.friction import law_mistakes as law_mistakes
    from slipcircle.core.scene.friction import law_names as law_names
    from slipcircle.core.scene.friction import law_parts as law_parts
    from slipcircle.core.scene.friction import may_have_rate as may_have_rate
    from slipcircle.core.scene.ground import circle_through as circle_through
    from slipcircle.core.scene.ground import circle_touching as circle_touching
    from slipcircle.core.scene.ground import continued as continued
    from slipcircle.core.scene.ground import pond_errors as pond_errors
    from slipcircle.core.scene.ground import simple_slope as simple_slope
    from slipcircle.core.scene.ground import slope_errors as slope_errors
    from slipcircle.core.scene.layers import LayeredSection as LayeredSection
    from slipcircle.core.scene.parameters import DIP as DIP
    from slipcircle.core.scene.parameters import SOIL_BOUNDS as SOIL_BOUNDS
    from slipcircle.core.scene.parameters import Parameter as Parameter
    from slipcircle.core.scene.parameters import parameter_value as parameter_value
    from slipcircle.core.scene.parameters import parameters as parameters
    from slipcircle.core.scene.parameters import with_parameter_arrays as with_parameter_arrays
    from slipcircle.core.scene.parameters import with_parameters as with_parameters
    from slipcircle.core.scene.scene import Scene as Scene
    from slipcircle.core.scene.scene import checked as checked
    from slipcircle.core.scene.section import Section as Section
    from slipcircle.core.scene.soils import Soil as Soil
    from slipcircle.core.scene.soils import datum_of as datum_of
    from slipcircle.core.scene.soils import layer_mistakes as layer_mistakes
    from slipcircle.core.scene.soils_along import Stretch as Stretch
    from slipcircle.core.scene.soils_along import mean_normal_stress as mean_normal_stress
    from slipcircle.core.scene.soils_along import stretches as stretches
    from slipcircle.core.scene.strips import arc_crossings as arc_crossings
    from slipcircle.core.scene.strips import edge_below as edge_below
    from slipcircle.core.scene.strips import line_crossings as line_crossings
    from slipcircle.core.scene.strips import meets_circle as meets_circle
    from slipcircle.core.scene.weights import Dimensionless as Dimensionless

# Public names by the module that defines them.
_PUBLIC = {
    "base.series": "Pulse Series",
    "core.flow.compiled": "numpy_only",
    "core.motion.derivatives": "Sensitivity",
    "core.motion.forms": "Pictured",
    "core.motion.motion": "Motion",
    "core.motion.plan": "Plan plan step_operations",
    "core.motion.solver": "solve",
    "core.motion.states": "ANSWERED Energy State Status",
    "core.scene.arc": "ARC_BOUNDS GIVEN GRAVITY WIDTH Arc",
    "core.scene.coordinates": "arc_numbers",
    "core.scene.forcing": "STRONGEST in_time",
    "core.scene.friction": "RATE_LAWS friction_at_rest law_depends law_mistakes law_names law_parts may_have_rate",
    "core.scene.ground": "circle_through circle_touching continued pond_errors simple_slope slope_errors",
    "core.scene.layers": "LayeredSection",
    "core.scene.parameters": (
        "DIP SOIL_BOUNDS Parameter parameter_value parameters with_parameter_arrays with_parameters"
    ),
    "core.scene.scene": "Scene checked",
    "core.scene.section": "Section",
    "core.scene.soils": "Soil datum_of layer_mistakes",
    "core.scene.soils_along": "Stretch mean_normal_stress stretches",
    "core.scene.strips": "arc_crossings edge_below line_crossings meets_circle",
    "core.scene.weights": "Dimensionless",
}
_MODULES = {name: f"slipcircle.{module}" for module, names in _PUBLIC.items() for name in names.split()}


def __getattr__(name: str) -> Any:
    if name not in _MODULES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(import_module(_MODULES[name]), name)
    globals()[name] = value  # asked for once
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *_MODULES})
