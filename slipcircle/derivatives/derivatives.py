"""Result of `Motion.sensitivity`: derivatives of outputs with respect to the inputs of a scene."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from slipcircle.base.conversions import Pictured
from slipcircle.base.kinds import Floats, Names, NumberMap, TextMap
from slipcircle.core.scene.scene import Scene


@dataclass(frozen=True)
class Sensitivity(Pictured):
    """Derivatives of a motion with respect to the inputs of its scene.

    Attributes
    ----------
    outputs : mapping
        Unit of each row: peak_velocity, run_out, duration, with the signs of `Motion`.
    parameters : mapping
        Unit of each column: friction, theta_1, ``ground.3.y``, ..., and ``effect.parameter`` for effects.
    at : dict of float
        Value of each output and each parameter.
    kinds : ndarray of str
        "smooth", "kink" (the slopes of both sides differ), "jump" (the output is discontinuous), "one side" (there is
        no scene on the other side) or "unresolved".
    values : ndarray
        d(output)/d(parameter) in SI units and radians. At a kink it is the mean of both slopes, at a jump the slope on
        the continuous side, and NaN if it is unknown.
    errors : ndarray
        Error bound of each value.
    slopes, slope_errors, jumps : ndarray
        One-sided derivatives below and above the parameter's value, (outputs, parameters, 2), their error bounds
        (infinite if unknown), and the jumps of the output.
    scene : Scene
        Scene of the motion.
    warnings : tuple of str
        Warnings about the results.
    elasticities : ndarray
        (parameter/output) d(output)/d(parameter), the change in per cent for a change of one per cent; NaN where the
        output is zero.
    """

    outputs: TextMap
    parameters: TextMap
    at: NumberMap
    kinds: Any
    values: Floats
    errors: Floats
    slopes: Floats
    slope_errors: Floats
    jumps: Floats
    scene: Scene = field(repr=False, compare=False)
    warnings: Names = ()

    @property
    def elasticities(self) -> Floats:
        """Relative changes of outputs over relative changes of parameters."""
        outputs = [self.at[name] or np.nan for name in self.outputs]
        parameters = [self.at[name] for name in self.parameters]
        return np.asarray(((self.values * parameters).T / outputs).T)

    def derivative(self, output: str, parameter: str) -> float:
        """Return the derivative of an output with respect to a parameter, in SI units; NaN if it is unknown.

        The names are keys of `outputs` and `parameters`, such as "run_out" and "friction".
        """
        return float(self.values[self._place(output, parameter)])

    def error(self, output: str, parameter: str) -> float:
        """Return the error bound of a derivative, in SI units. The names are keys of `outputs` and `parameters`."""
        return float(self.errors[self._place(output, parameter)])

    def kind(self, output: str, parameter: str) -> str:
        """Return the kind of a derivative, such as "smooth" or "kink".

        The names are keys of `outputs` and `parameters`.
        """
        return str(self.kinds[self._place(output, parameter)])

    def _place(self, output: str, parameter: str) -> tuple[int, int]:
        """Return the row of an output and the column of a parameter, from their names."""
        row = list(self.outputs).index(output)
        return row, list(self.parameters).index(parameter)

    def __str__(self) -> str:
        """Return the table of `slipcircle sensitivity` as text."""
        return str(self._convert("text"))
