"""The core: scenes (`scene`), their integration (`flow`), and the resulting motion (`motion`).

The names listed here are public: all that the workbench, or any program built on the core, needs. Each is loaded on
first use, so that importing the core loads nothing.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
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
    from slipcircle.core.scene.friction import RATE_LAWS as RATE_LAWS
    from slipcircle.core.scene.friction import friction_at_rest as friction_at_rest
    from slipcircle.core.scene.friction import law_depends as law_depends
    from slipcircle.core.scene.friction import law_mistakes as law_mistakes
    from slipcircle.core.scene.friction import law_names as law_names
    from slipcircle.core.scene.friction import law_parts as law_parts
    from slipcircle.core.scene.friction import may_have_rate as may_have_rate
    from slipcircle.core.scene.scene import Scene as Scene
    from slipcircle.core.scene.scene import checked as checked
    from slipcircle.core.scene.weights import Dimensionless as Dimensionless
    from slipcircle.core.walk.compiled import numpy_only as numpy_only
    from slipcircle.derivatives.derivatives import Sensitivity as Sensitivity
    from slipcircle.derivatives.neighbours import neighbour_derivatives as neighbour_derivatives
    from slipcircle.derivatives.parameters import DIP as DIP
    from slipcircle.derivatives.parameters import SOIL_BOUNDS as SOIL_BOUNDS
    from slipcircle.derivatives.parameters import Free as Free
    from slipcircle.derivatives.parameters import Parameter as Parameter
    from slipcircle.derivatives.parameters import free_parameters as free_parameters
    from slipcircle.derivatives.parameters import parameter_value as parameter_value
    from slipcircle.derivatives.parameters import parameters as parameters
    from slipcircle.derivatives.parameters import possible_parameters as possible_parameters
    from slipcircle.derivatives.parameters import with_parameter_arrays as with_parameter_arrays
    from slipcircle.derivatives.parameters import with_parameters as with_parameters
    from slipcircle.ground.ground import circle_through as circle_through
    from slipcircle.ground.ground import circle_touching as circle_touching
    from slipcircle.ground.ground import continued as continued
    from slipcircle.ground.ground import pond_errors as pond_errors
    from slipcircle.ground.ground import simple_slope as simple_slope
    from slipcircle.ground.ground import slope_errors as slope_errors
    from slipcircle.ground.section import Section as Section
    from slipcircle.layers.layers import LayeredSection as LayeredSection
    from slipcircle.layers.soils import Soil as Soil
    from slipcircle.layers.soils import datum_of as datum_of
    from slipcircle.layers.soils import layer_mistakes as layer_mistakes
    from slipcircle.layers.soils_along import Stretch as Stretch
    from slipcircle.layers.soils_along import mean_normal_stress as mean_normal_stress
    from slipcircle.layers.soils_along import stretches as stretches
    from slipcircle.layers.strips import arc_crossings as arc_crossings
    from slipcircle.layers.strips import edge_below as edge_below
    from slipcircle.layers.strips import line_crossings as line_crossings
    from slipcircle.layers.strips import meets_circle as meets_circle
    from slipcircle.tables.forcing import STRONGEST as STRONGEST
    from slipcircle.tables.forcing import in_time as in_time
    from slipcircle.tables.series import Pulse as Pulse
    from slipcircle.tables.series import Series as Series

# Public names by the module that defines them.
_PUBLIC = {
    "tables.series": "Pulse Series",
    "core.walk.compiled": "numpy_only",
    "derivatives.derivatives": "Sensitivity",
    "derivatives.neighbours": "neighbour_derivatives",
    "core.motion.forms": "Pictured",
    "core.motion.motion": "Motion",
    "core.motion.plan": "Plan plan step_operations",
    "core.motion.solver": "solve",
    "core.motion.states": "ANSWERED Energy State Status",
    "core.scene.arc": "ARC_BOUNDS GIVEN GRAVITY WIDTH Arc",
    "core.scene.coordinates": "arc_numbers",
    "tables.forcing": "STRONGEST in_time",
    "core.scene.friction": "RATE_LAWS friction_at_rest law_depends law_mistakes law_names law_parts may_have_rate",
    "ground.ground": "circle_through circle_touching continued pond_errors simple_slope slope_errors",
    "layers.layers": "LayeredSection",
    "derivatives.parameters": (
        "DIP SOIL_BOUNDS Free Parameter free_parameters parameter_value parameters possible_parameters "
        "with_parameter_arrays with_parameters"
    ),
    "core.scene.scene": "Scene checked",
    "ground.section": "Section",
    "layers.soils": "Soil datum_of layer_mistakes",
    "layers.soils_along": "Stretch mean_normal_stress stretches",
    "layers.strips": "arc_crossings edge_below line_crossings meets_circle",
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
