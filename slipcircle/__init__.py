"""The dynamic slip circle method: how fast, how far, and when a mass that failed along a circle comes to rest.

`Arc` holds the failed section, `Section` that of a real slope, `Scene` adds friction, effects and the start, `plan`
describes how it will be solved and `solve` returns the `Motion`; `ensemble` samples uncertain numbers, `backanalyse`
fits parameters to observations, and `critical` searches the circle along which a `Slope` fails. `slipcircle.kernels`
has the functions of an arc. Units are SI, angles are in radians. `slipcircle schema --text` is the guide to effects and
friction laws: formulas, parameters and bounds; ``notebooks/0_the_method.ipynb`` derives the mechanics. The formulas are
those of the package `generated`, which `python -m derive` writes.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

try:
    import generated

    _project = getattr(generated, "__project__", None)
except Exception as error:
    _project = error
if _project != "slipcircle":  # another package, or what it needs is missing
    if isinstance(_project, ModuleNotFoundError) and _project.name == "numpy":
        raise ImportError("slipcircle needs NumPy: pip install numpy") from None
    from importlib.util import find_spec

    _spec = find_spec("generated")
    _place = _spec and (_spec.origin or list(_spec.submodule_search_locations or ()))
    raise ImportError(
        f"slipcircle needs its package 'generated', and Python finds {_place or 'none'}: rename that one or start in "
        "another folder; or install slipcircle again"
    ) from (_project if isinstance(_project, Exception) else None)

from slipcircle.base import VERSION
from slipcircle.base.forms import use_forms

if TYPE_CHECKING:
    from slipcircle.core import Arc, Dimensionless, Energy, Motion, Plan, Scene, State, Status, plan, solve
    from slipcircle.derivatives.parameters import parameters
    from slipcircle.ground import Section
    from slipcircle.layers import LayeredSection, Soil
    from slipcircle.tables import Pulse, Series
    from slipcircle.workbench.common.quantities import Interval
    from slipcircle.workbench.files.scenefile import load
    from slipcircle.workbench.records.records import Record
    from slipcircle.workbench.records.suite import Suite, read_suite
    from slipcircle.workbench.stability.search import Critical, critical
    from slipcircle.workbench.stability.stability import Slope
    from slipcircle.workbench.studies.backanalysis import BackAnalysis, Unattainable, backanalyse
    from slipcircle.workbench.studies.ensemble import ensemble, grid
    from slipcircle.workbench.studies.study import Study
    from slipcircle.workbench.studies.suitestudy import SuiteStudy
    from slipcircle.workbench.suites.synthetic import synthetic_records

__version__ = VERSION
use_forms("slipcircle.workbench.outputs.display")  # by `Motion.plot`, `animate`, `to_dict`, ... and in notebooks
# Each is loaded when it is asked for: where it is.
_PLACES = {
    "Arc": "core",
    "BackAnalysis": "workbench.studies.backanalysis",
    "Critical": "workbench.stability.search",
    "Dimensionless": "core",
    "Energy": "core",
    "Interval": "workbench.common.quantities",
    "LayeredSection": "layers",
    "Motion": "core",
    "Plan": "core",
    "Pulse": "tables",
    "Record": "workbench.records.records",
    "Scene": "core",
    "Section": "ground",
    "Series": "tables",
    "Slope": "workbench.stability.stability",
    "Soil": "layers",
    "State": "core",
    "Status": "core",
    "Study": "workbench.studies.study",
    "Suite": "workbench.records.suite",
    "SuiteStudy": "workbench.studies.suitestudy",
    "Unattainable": "workbench.studies.backanalysis",
    "backanalyse": "workbench.studies.backanalysis",
    "critical": "workbench.stability.search",
    "ensemble": "workbench.studies.ensemble",
    "grid": "workbench.studies.ensemble",
    "load": "workbench.files.scenefile",
    "parameters": "derivatives",
    "plan": "core",
    "read_suite": "workbench.records.suite",
    "solve": "core",
    "synthetic_records": "workbench.suites.synthetic",
}
__all__ = [
    "Arc",
    "BackAnalysis",
    "Critical",
    "Dimensionless",
    "Energy",
    "Interval",
    "LayeredSection",
    "Motion",
    "Plan",
    "Pulse",
    "Record",
    "Scene",
    "Section",
    "Series",
    "Slope",
    "Soil",
    "State",
    "Status",
    "Study",
    "Suite",
    "SuiteStudy",
    "Unattainable",
    "backanalyse",
    "critical",
    "ensemble",
    "grid",
    "load",
    "parameters",
    "plan",
    "read_suite",
    "solve",
    "synthetic_records",
]


def __getattr__(name: str) -> Any:
    if name not in _PLACES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(import_module(f"slipcircle.{_PLACES[name]}"), name)
    globals()[name] = value  # asked for once
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
