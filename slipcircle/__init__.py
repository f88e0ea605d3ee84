"""Dynamic slip circle method: velocity, run-out and duration of a slope failure along a circular slip surface.

An `Arc` describes a failed mass below a plane slope, a `Section` a mass below surveyed ground. A `Scene` adds friction,
effects and the start. `solve` returns its `Motion`, and `plan` describes the method of solution. `ensemble` samples
uncertain inputs, `backanalyse` fits inputs to observations, and `critical` searches the critical circle of a `Slope`.
`slipcircle.kernels` contains the functions of an arc. Units are SI, angles are in radians.

`slipcircle schema --text` prints the guide to effects and friction laws with formulas, parameters and bounds, and
``notebooks/0_the_method.ipynb`` derives the mechanics. The formulas are in the package `generated`, which
`python -m derive` writes.
"""

import sys
from importlib import import_module
from typing import TYPE_CHECKING, Any

if sys.version_info < (3, 11):  # noqa: UP036 (a checkout is imported by any Python)
    raise ImportError(f"slipcircle needs Python 3.11 or later, and this is {sys.version_info[0]}.{sys.version_info[1]}")

from slipcircle.base import loading as loading

try:
    from numpy import __version__ as _numpy
except ModuleNotFoundError:
    raise ImportError("slipcircle needs NumPy: pip install numpy") from None
if tuple(map(int, _numpy.split(".")[:2])) < (2, 1):
    raise ImportError(f"slipcircle needs NumPy 2.1 or later, and this is {_numpy}")
try:
    import generated

    _project = getattr(generated, "__project__", None)
except Exception as error:
    _project = error
if _project != "slipcircle":  # another package, or a dependency is missing
    from importlib.util import find_spec

    _spec = find_spec("generated")
    _place = _spec and (_spec.origin or list(_spec.submodule_search_locations or ()))
    raise ImportError(
        f"slipcircle needs its package 'generated', and Python finds {_place or 'none'}: rename that one or start in "
        "another folder; or install slipcircle again"
    ) from (_project if isinstance(_project, Exception) else None)

from slipcircle.base import VERSION
from slipcircle.base.conversions import Pictured

if TYPE_CHECKING:  # exported for type checkers
    # isort: off
    from slipcircle.core import Arc as Arc, Motion as Motion, Plan as Plan, Scene as Scene, Status as Status
    from slipcircle.core import plan as plan, solve as solve
    from slipcircle.core.motion.state import State as State
    from slipcircle.core.scene.dimensionless import Dimensionless as Dimensionless
    from slipcircle.derivatives.parameters import parameters as parameters
    from slipcircle.ground import Section as Section
    from slipcircle.history import Energy as Energy
    from slipcircle.layers import LayeredSection as LayeredSection, Soil as Soil
    from slipcircle.tables import Pulse as Pulse, Series as Series
    from slipcircle.workbench.common.quantities import Interval as Interval
    from slipcircle.workbench.files.scenefile import load as load
    from slipcircle.workbench.records.records import Record as Record
    from slipcircle.workbench.records.suite import Suite as Suite, read_suite as read_suite
    from slipcircle.workbench.stability.critical import Critical as Critical, SlopeScene as SlopeScene
    from slipcircle.workbench.stability.search import critical as critical
    from slipcircle.workbench.stability.stability import Slope as Slope
    from slipcircle.workbench.studies.backanalysis import BackAnalysis as BackAnalysis, Unattainable as Unattainable
    from slipcircle.workbench.studies.backanalysis import backanalyse as backanalyse
    from slipcircle.workbench.studies.ensemble import ensemble as ensemble, grid as grid
    from slipcircle.workbench.studies.study import Study as Study, SuiteStudy as SuiteStudy
    from slipcircle.workbench.suites.synthetic import synthetic_records as synthetic_records
    # isort: on

__version__ = VERSION
Pictured._conversions = "slipcircle.workbench.outputs.display"  # of `Motion.plot`, `to_dict`, ... and in notebooks
# Module of each public name, imported at the first access.
_PLACES = {
    "core": "Arc Motion Plan Scene Status plan solve",
    "core.motion.state": "State",
    "core.scene.dimensionless": "Dimensionless",
    "derivatives": "parameters",
    "ground": "Section",
    "history": "Energy",
    "layers": "LayeredSection Soil",
    "tables": "Pulse Series",
    "workbench.common.quantities": "Interval",
    "workbench.files.scenefile": "load",
    "workbench.records.records": "Record",
    "workbench.records.suite": "Suite read_suite",
    "workbench.stability.critical": "Critical SlopeScene",
    "workbench.stability.search": "critical",
    "workbench.stability.stability": "Slope",
    "workbench.studies.backanalysis": "BackAnalysis Unattainable backanalyse",
    "workbench.studies.ensemble": "ensemble grid",
    "workbench.studies.study": "Study SuiteStudy",
    "workbench.suites.synthetic": "synthetic_records",
}
_MODULES = {name: f"slipcircle.{place}" for place, names in _PLACES.items() for name in names.split()}
__all__ = sorted(_MODULES)


def __getattr__(name: str) -> Any:
    if name not in _MODULES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(import_module(_MODULES[name]), name)
    globals()[name] = value  # later accesses skip this function
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
