"""The dynamic slip circle method: how fast, how far, and when a mass that failed along a circle comes to rest.

`Arc` holds the failed section, `Scene` adds friction, effects and the start, `plan` says how it will be solved and
`solve` returns the `Motion`; `ensemble` draws uncertain numbers, `backanalyse` looks for what explains an observation.
Units are SI, angles radians. `slipcircle schema --text` is the guide to effects and friction laws: formulas, parameters
and bounds. The numbers come from the package `generated`, which `python -m derive` writes.
"""

from typing import TYPE_CHECKING, Any

import generated

if getattr(generated, "__project__", None) != "slipcircle":
    raise ImportError(
        f"the package 'generated' found at {getattr(generated, '__file__', None) or list(generated.__path__)} is not "
        "the one that slipcircle needs: remove it from sys.path, or put slipcircle's folder before it"
    )

from slipcircle.arc import Arc, Dimensionless
from slipcircle.motion import Energy, Motion, State
from slipcircle.plan import Plan, plan
from slipcircle.scene import Scene
from slipcircle.solver import solve

if TYPE_CHECKING:
    from slipcircle.backanalysis import BackAnalysis, Unattainable, backanalyse
    from slipcircle.studies.ensembles import Ensemble, ensemble

__version__ = "0.1.0"
__all__ = [
    "Arc",
    "BackAnalysis",
    "Dimensionless",
    "Energy",
    "Ensemble",
    "Motion",
    "Plan",
    "Scene",
    "State",
    "Unattainable",
    "backanalyse",
    "ensemble",
    "plan",
    "solve",
]


def __getattr__(name: str) -> Any:
    """Ensembles and back-analysis, when they are asked for: one motion needs nothing of them."""
    if name in ("Ensemble", "ensemble"):
        from slipcircle.studies import ensembles

        return getattr(ensembles, name)
    if name in ("BackAnalysis", "Unattainable", "backanalyse"):
        from slipcircle import backanalysis

        return getattr(backanalysis, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
