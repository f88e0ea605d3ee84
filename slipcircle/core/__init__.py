"""Core: motion of a mass that slides along a circular arc, from its scene to the result.

    Scene -> Plan -> Problem -> Motion

The names listed here are public and sufficient for the workbench and other programs built on the core. Modules that
only some scenes need are imported lazily. `slipcircle.core.lazy` lists them.
"""

from slipcircle.core.integrator.compiled import numpy_only
from slipcircle.core.integrator.neighbours import ROUNDED, RUNS, perturbed_runs
from slipcircle.core.lazy import lazy_import
from slipcircle.core.motion.motion import Motion
from slipcircle.core.motion.solver import solve
from slipcircle.core.motion.states import ANSWERED, STATUS_OF_END, Status
from slipcircle.core.problem.plan import Plan, plan
from slipcircle.core.problem.problem import Problem, problem_of
from slipcircle.core.scene.arc import DIP, Arc
from slipcircle.core.scene.declarations import STORED, Parts, declared, number
from slipcircle.core.scene.friction import law_parts
from slipcircle.core.scene.mass import Mass
from slipcircle.core.scene.scene import AS_ENTERED, Scene, checked_scene

__all__ = [
    "ANSWERED",
    "AS_ENTERED",
    "DIP",
    "ROUNDED",
    "RUNS",
    "STATUS_OF_END",
    "STORED",
    "Arc",
    "Mass",
    "Motion",
    "Parts",
    "Plan",
    "Problem",
    "Scene",
    "Status",
    "checked_scene",
    "declared",
    "law_parts",
    "lazy_import",
    "number",
    "numpy_only",
    "perturbed_runs",
    "plan",
    "problem_of",
    "solve",
]
