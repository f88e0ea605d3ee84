"""Flow programs: operations on the cells and registers of a lane, and those that the integrator reads.

`slipcircle.core.program.build` makes the program of a scene from the fragments in `generated.flow`.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from slipcircle.base.kinds import Floats

Log = list[tuple[int, float, float, float]]  # events: kind, time, rotation, direction


class Samples(NamedTuple):
    """States at sample times, filled during the integration: (states, times, lanes)."""

    times: Floats  # dimensionless, increasing, (times, lanes)
    states: Floats  # rotation, angular velocity, its rate, slip, then the further states


@dataclass(frozen=True)
class Table:
    """A piecewise function as a program knows it: what of, the register of its argument (or, of time, of its
    increment), the first of its cells, and the degree of its pieces.
    """

    name: str
    kind: str
    register: int
    cells: int
    degree: int


@dataclass(frozen=True, eq=False)
class Program:
    """Cells and registers by name, operations on cells and on series by their indices, and who plays which role.

    The first ``given`` cells are set at the start of a lane, the next ones computed where a phase begins; then follow
    ``constants``, by name.
    ``states`` are (cell, register, register of the rate).
    """

    cells: tuple[str, ...]
    given: int
    registers: tuple[str, ...]
    scalar: tuple[tuple[Any, ...], ...]
    series: tuple[tuple[Any, ...], ...]
    states: tuple[tuple[int, int, int], ...]
    tables: tuple[Table, ...]
    roles: Mapping[str, int]
    constants: Mapping[str, float]

    @cached_property
    def places(self) -> Mapping[str, int]:
        """Where the cells are, by name."""
        return {name: k for k, name in enumerate(self.cells)}

    @cached_property
    def autonomous(self) -> bool:
        """Whether d(omega)/dt depends on omega alone between breaks in time: frozen geometry, friction without slip."""
        arguments = set[int]()
        for kind, *names in self.series:
            if kind != "ramp":
                arguments |= {r for _, r in names[2]} if kind == "lin" else {*names[1:]}
        return len(self.states) == 2 and self.roles["x"] not in arguments

    def blank(self, lanes: int) -> NDArray[np.float64]:
        """Cells of lanes with the constants of the program, otherwise zero."""
        cells = np.zeros((len(self.cells), lanes))
        for name, value in self.constants.items():
            cells[self.places[name]] = value
        return cells


# Cells that the integrator reads, by role: drive, size of its terms, normal force, components of the weight.
OUTPUT_CELLS = {
    "cell_drive": "drive",
    "cell_drive_scale": "drive_scale",
    "cell_normal0": "normal_0",
    "cell_driving_moment": "driving_moment_0",
    "cell_normal_load": "normal_load_0",
    "cell_normal_load_slope": "normal_load_slope_0",
    "cell_driving": "driving_0",
    "cell_resisting": "resisting_0",
    "cell_mu": "mu_0",
    "cell_limit": "limit",
}
READ_REGISTERS = ("net", "normal", "upright")  # by the integrator, as events
