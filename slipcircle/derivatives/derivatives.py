"""The result of `Motion.sensitivity`: derivatives of outputs by the parameters of a scene, and their table."""

from collections.abc import Mapping
from dataclasses import dataclass, field

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
    values : ndarray
        d(output)/d(parameter), SI units and radians.
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
    values: Floats
    scene: Scene = field(repr=False, compare=False)
    warnings: tuple[str, ...] = ()

    @property
    def elasticities(self) -> Floats:
        outputs = [self.at[name] or np.nan for name in self.outputs]
        parameters = [self.at[name] for name in self.parameters]
        changes = self.values * parameters
        elasticities = changes.T / outputs
        return np.asarray(elasticities.T)

    @property
    def distinct(self) -> dict[str, str]:
        """The outputs, without the reach where that is the run-out."""
        distinct = dict(self.outputs)
        if self.at["reach"] == self.at["run_out"]:
            distinct.pop("reach")
        return distinct

    def derivative(self, output: str, parameter: str) -> float:
        """One of the values."""
        row = list(self.outputs).index(output)
        column = list(self.parameters).index(parameter)
        return float(self.values[row, column])

    def __str__(self) -> str:
        head = ["by", "value"]
        for name, unit in self.distinct.items():
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
        """The derivatives of the distinct outputs by a parameter, with elasticities."""
        column = list(self.parameters).index(parameter)
        elasticities = self.elasticities[:, column]
        cells = []
        for output, elasticity in zip(self.outputs, elasticities, strict=True):
            if output in self.distinct:
                value = self.derivative(output, parameter)
                cells.append(f"{value:.6g} ({elasticity:+.3g})")
        return cells
