"""Result of `Motion.sensitivity`: derivatives of outputs with respect to the inputs of a scene, and their table."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from slipcircle.base.kinds import Floats, Names, NumberMap, Texts
from slipcircle.core.scene.scene import Scene


@dataclass(frozen=True)
class Sensitivity:
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

    outputs: Mapping[str, str]
    parameters: Mapping[str, str]
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
        place = self._place(output, parameter)
        return float(self.errors[place])

    def kind(self, output: str, parameter: str) -> str:
        """Return the kind of a derivative, such as "smooth" or "kink".

        The names are keys of `outputs` and `parameters`.
        """
        place = self._place(output, parameter)
        return str(self.kinds[place])

    def _place(self, output: str, parameter: str) -> tuple[int, int]:
        """Return the row of an output and the column of a parameter, from their names."""
        row = list(self.outputs).index(output)
        column = list(self.parameters).index(parameter)
        return row, column

    def __str__(self) -> str:
        """Return the table of derivatives and elasticities as text."""
        heads = [f"d {name} [{unit}] (elasticity)" for name, unit in self.outputs.items()]
        rows = [["by", "value", *heads]]
        for name, unit in self.parameters.items():
            title = f"{name} [{unit}]" if unit else name
            value = f"{self.at[name]:.6g}"
            rows.append([title, value, *self._row(name)])
        widths = [max(map(len, cells)) for cells in zip(*rows, strict=True)]
        lines = []
        for row in rows:
            line = "  ".join(map(str.ljust, row, widths))
            lines.append(line.rstrip())
        return "\n".join(lines)

    def _row(self, parameter: str) -> Texts:
        """Return the derivatives of the outputs with respect to a parameter, with elasticities, as text."""
        elasticities = self.elasticities[:, list(self.parameters).index(parameter)]
        cells = []
        for output, elasticity in zip(self.outputs, elasticities, strict=True):
            value = self.derivative(output, parameter)
            kind = self.kind(output, parameter)
            note = "" if kind == "smooth" else f" {kind}"
            cells.append(f"{value:.6g} ({elasticity:+.3g}){note}")
        return cells
