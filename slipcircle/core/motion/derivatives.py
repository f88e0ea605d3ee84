"""The result of `Motion.sensitivity`: derivatives of outputs by the parameters of a scene, and their table."""

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from slipcircle.core.scene.scene import Scene

Floats = NDArray[np.float64]


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
        outputs = np.array([self.at[name] for name in self.outputs])
        parameters = np.array([self.at[name] for name in self.parameters])
        nonzero = np.where(outputs == 0.0, np.nan, outputs)
        per_cent = self.values * parameters
        return np.asarray(per_cent / nonzero[:, None])

    @property
    def distinct(self) -> dict[str, str]:
        """The outputs, without the reach where that is the run-out."""
        distinct = dict(self.outputs)
        if "reach" in distinct and self.at["reach"] == self.at["run_out"]:
            del distinct["reach"]
        return distinct

    def derivative(self, output: str, parameter: str) -> float:
        """One of the values."""
        row = list(self.outputs).index(output)
        column = list(self.parameters).index(parameter)
        return float(self.values[row, column])

    def __str__(self) -> str:
        titles = [f"d {name} [{unit}] (elasticity)" for name, unit in self.distinct.items()]
        rows = [["by", "value", *titles]]
        rows += [self._row(k, name, unit) for k, (name, unit) in enumerate(self.parameters.items())]
        widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
        lines = []
        for row in rows:
            padded = [cell.ljust(width) for cell, width in zip(row, widths, strict=True)]
            lines.append("  ".join(padded).rstrip())
        return "\n".join(lines)

    def _row(self, column: int, name: str, unit: str) -> list[str]:
        """A parameter with its value, and the derivatives of the distinct outputs by it."""
        elasticities = self.elasticities[:, column]
        cells = []
        for row, output in enumerate(self.outputs):
            if output in self.distinct:
                cells.append(f"{self.values[row, column]:.6g} ({elasticities[row]:+.3g})")
        title = f"{name} [{unit}]" if unit else name
        return [title, f"{self.at[name]:.6g}", *cells]
