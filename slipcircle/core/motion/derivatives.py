"""Derivatives of a motion's outputs by the parameters of its scene, as they are told."""

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
        of = np.array([self.at[n] for n in self.outputs])[:, None]
        by = np.array([self.at[n] for n in self.parameters])
        return np.asarray(self.values * by / np.where(of == 0.0, np.nan, of))

    @property
    def distinct(self) -> dict[str, str]:
        """The outputs, without the reach where that is the run-out."""
        return {n: unit for n, unit in self.outputs.items() if n != "reach" or self.at[n] != self.at["run_out"]}

    def derivative(self, output: str, parameter: str) -> float:
        """One of the values."""
        return float(self.values[list(self.outputs).index(output), list(self.parameters).index(parameter)])

    def __str__(self) -> str:
        lines = [["by", "value", *(f"d {n} [{unit}] (elasticity)" for n, unit in self.distinct.items())]]
        pairs = np.stack([self.values, self.elasticities])[:, [n in self.distinct for n in self.outputs]]
        for k, (name, unit) in enumerate(self.parameters.items()):
            cells = [f"{v:.6g} ({e:+.3g})" for v, e in pairs[:, :, k].T]
            lines.append([f"{name} [{unit}]" if unit else name, f"{self.at[name]:.6g}", *cells])
        widths = [max(map(len, column)) for column in zip(*lines, strict=True)]
        return "\n".join("  ".join(c.ljust(w) for c, w in zip(line, widths, strict=True)).rstrip() for line in lines)
