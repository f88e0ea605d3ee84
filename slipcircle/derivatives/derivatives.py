"""The result of `Motion.sensitivity`: derivatives of outputs by the parameters of a scene, and their table."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from slipcircle.base.kinds import Floats
from slipcircle.core.scene.scene import Scene


@dataclass(frozen=True)
class Sensitivity:
    """Derivatives of a motion by the parameters of its scene.

    Attributes
    ----------
    outputs : mapping
        Unit of each row: peak_velocity, run_out, duration; signed as `Motion` gives them.
    parameters : mapping
        Unit of each column: friction, theta_1, ``ground.3.y``, ..., of effects ``effect.parameter``.
    at : dict of float
        Value of each output and each parameter.
    kinds : ndarray of str
        "smooth"; "kink", where slopes differ; "jump", where the output is another at once on one side; "one side",
        beyond which there is no scene; "unresolved".
    values : ndarray
        d(output)/d(parameter), SI units and radians: of a kink the mean of both slopes, of a jump that of the side that
        goes on from the motion; NaN where it is not known.
    errors : ndarray
        What each of the values is off at most.
    slopes, slope_errors, jumps : ndarray
        Below and above the parameter's value, (outputs, parameters, 2): derivatives of each side, what they are off at
        most (infinite where nothing is known), and by how much the output jumps.
    scene : Scene
        Whose parameters they are.
    warnings : tuple of str
        Warnings about the results.
    elasticities : ndarray
        (parameter/output) d(output)/d(parameter): per cent for a per cent; NaN where the output is zero.
    """

    outputs: Mapping[str, str]
    parameters: Mapping[str, str]
    at: Mapping[str, float]
    kinds: Any
    values: Floats
    errors: Floats
    slopes: Floats
    slope_errors: Floats
    jumps: Floats
    scene: Scene = field(repr=False, compare=False)
    warnings: tuple[str, ...] = ()

    @property
    def elasticities(self) -> Floats:
        outputs = [self.at[name] or np.nan for name in self.outputs]
        parameters = [self.at[name] for name in self.parameters]
        changes = self.values * parameters
        elasticities = changes.T / outputs
        return np.asarray(elasticities.T)

    def derivative(self, output: str, parameter: str) -> float:
        """One of the values."""
        return float(self.values[self._place(output, parameter)])

    def error(self, output: str, parameter: str) -> float:
        """What a derivative is off at most."""
        return float(self.errors[self._place(output, parameter)])

    def kind(self, output: str, parameter: str) -> str:
        """Whether an output is smooth there, or what else it is."""
        return str(self.kinds[self._place(output, parameter)])

    def _place(self, output: str, parameter: str) -> tuple[int, int]:
        outputs = list(self.outputs)
        parameters = list(self.parameters)
        return outputs.index(output), parameters.index(parameter)

    def __str__(self) -> str:
        head = ["by", "value"]
        for name, unit in self.outputs.items():
            head.append(f"d {name} [{unit}] (elasticity)")
        rows = [head]
        for name, unit in self.parameters.items():
            title = f"{name} [{unit}]" if unit else name
            value = f"{self.at[name]:.6g}"
            rows.append([title, value, *self._row(name)])
        widths = []
        for cells in zip(*rows, strict=True):
            longest = max(map(len, cells))
            widths.append(longest)
        lines = []
        for row in rows:
            padded = map(str.ljust, row, widths)
            line = "  ".join(padded)
            lines.append(line.rstrip())
        return "\n".join(lines)

    def _row(self, parameter: str) -> list[str]:
        """The derivatives of the outputs by a parameter, with elasticities."""
        column = list(self.parameters).index(parameter)
        elasticities = self.elasticities[:, column]
        cells = []
        for output, elasticity in zip(self.outputs, elasticities, strict=True):
            value = self.derivative(output, parameter)
            kind = self.kind(output, parameter)
            note = "" if kind == "smooth" else f" {kind}"
            cells.append(f"{value:.6g} ({elasticity:+.3g}){note}")
        return cells
