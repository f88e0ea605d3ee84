"""Lanes of scenes that share their effects and laws: bound, walked to their end, and asked for what they passed."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from slipcircle.base.checks import EPS
from slipcircle.flow import compiled, frozen, stiff, tables, walk
from slipcircle.flow.bind import Bound, Grown, bind
from slipcircle.scene.arc import Arc
from slipcircle.scene.section import Section

Floats = NDArray[np.float64]


def walked(bound: Bound, closed: bool = False, samples: walk.Samples | None = None, log: walk.Log | None = None,
           walker: Any = None) -> Floats:  # fmt: skip
    """The cells of lanes at their end; tables of Python functions grow as the motion reaches them."""
    cells, data = bound.cells.copy(), list(bound.tables)
    if closed:
        frozen.walk(bound.program, data, cells, samples, log)
    while True:
        (walker or (compiled.run if compiled.module() else walk.walk))(bound.program, data, cells, samples, log)
        asking = cells[walk.STATUS] == walk.NEED
        if not np.any(asking):
            break
        for k, grown in bound.functions.items():
            data[k] = _longer(data[k], grown)
        lanes = walk.Lanes(bound.program, data, cells[:, asking], None, np.flatnonzero(asking))
        lanes.base()
        cells[:, asking] = lanes.c
        cells[walk.STATUS, asking] = walk.MOVING
    long = (cells[walk.STATUS] == walk.TOO_LONG) & (cells[walk.STEPS] > walk.MOST_STEPS)
    if np.any(long):
        stiff.walk(bound.program, data, cells, samples, log, np.flatnonzero(long))
    return cells


def _longer(data: tables.Data, grown: Grown) -> tables.Data:
    """A Python function's table, twice as long."""
    end = float(data.breaks[-1])
    breaks, pieces = tables.sampled(grown.function, end, end, grown.name)
    return tables.Data(
        np.array([*data.breaks[:-1], *breaks, 2 * end]),
        np.array([*data.coefficients[:-1], *pieces, pieces[-1]]),
        np.zeros(len(data.breaks) + len(breaks)),
        open=True,
    )


@dataclass(frozen=True)
class Lanes:
    """What lanes are made of: numbers, or arrays of one value a lane, and what they share.

    Attributes
    ----------
    arc : Arc or Section
        May be unchecked: what is no arc is invalid.
    called : mapping
        Effects by name, each with its parameters.
    friction : float, ndarray, mapping or callable
    velocity, end_time : float or ndarray
        m/s, and s or infinity.
    accuracy : float
    closed : bool
        Whether the paper's closed form in time holds.
    count : int
        How many there are.
    invalid : ndarray of bool
        Which are no scenes.
    """

    arc: Arc | Section
    called: Mapping[str, Mapping[str, Any]]
    friction: Any
    velocity: Any
    end_time: Any
    accuracy: float
    closed: bool
    count: int
    invalid: Any = False

    @cached_property
    def bound(self) -> Bound:
        return self.bind()

    def bind(self, asked: tuple[str, ...] = (), directions: int = 0) -> Bound:
        """Bound numbers, with further outputs, or derivatives in so many directions."""
        found = bind(self.arc, self.called, self.friction, self.velocity, self.end_time, self.accuracy, self.count,
                     asked, directions)  # fmt: skip
        found.cells[walk.STATUS, np.broadcast_to(self.invalid, self.count)] = walk.FAILED
        return found

    @property
    def time_scale(self) -> Any:
        """s for one of the dimensionless time, without binding what only walking needs."""
        return self.arc.time_scale

    @property
    def radius(self) -> Any:
        return np.asarray(self.arc.radius, dtype=np.float64)

    @property
    def stress_unit(self) -> Any:
        """Pa for one of normal force over Theta*: sigma_ref over lambda/Theta*."""
        return np.asarray(self.arc.reference_stress / self.arc.weights.level)

    @property
    def energy_unit(self) -> Any:
        """J for one of omega*^2/2."""
        arc = self.arc
        weight = np.multiply(arc.width, arc.unit_weight) * np.power(arc.radius, 3.0)
        return weight * arc.dimensionless.moment_of_inertia

    def solve(self, log: walk.Log | None = None) -> Floats:
        """The cells of all lanes at their end."""
        return walked(self.bound, self.closed, None, log)

    def _sampled(self, bound: Bound, times: Floats, closed: bool) -> tuple[Floats, Floats]:
        """As `read`, of any bound lanes; and their last cells."""
        order = np.argsort(times, kind="stable")
        at = times[order][:, None] / np.broadcast_to(bound.time_scale, (1, self.count))
        rows = np.zeros((2 + len(bound.program.states), times.size, self.count))
        found = np.full((2 + len(bound.program.states), times.size, self.count), np.nan)
        cells = walked(bound, closed, walk.Samples(np.ascontiguousarray(at), rows))
        found[:, order] = rows
        return found, cells

    def read(self, times: Floats) -> Floats:
        """Rotation, omega, its rate, slip and further states at times in s, (rows, times, lanes)."""
        return self._sampled(self.bound, times, self.closed)[0]

    def stress(self, time: Any, rotation: Any, omega: Any) -> Any:
        """The mean normal stress, Pa, of each lane in one state; dimensionless numbers."""
        return self._probe(self._asking, time, rotation, omega, None, ("pressing",))["pressing"] * self.stress_unit

    def stress_along(self, times: Floats, rows: Floats) -> Any:
        """The same at times in s of states as `read` gives them, (lanes, times)."""
        return self.outputs(times, rows, ("pressing",))["pressing"] * np.reshape(self.stress_unit, (-1, 1))

    def outputs(self, times: Floats, rows: Floats, names: tuple[str, ...]) -> dict[str, Floats]:
        """Registers of the program at times in s, of states as `read` gives them; by name, (lanes, times)."""
        time, rotation, omega, further, each = self._spread(times, rows)
        found = self._probe(self._asking, time, rotation, omega, further, names, each)
        return {n: v.reshape(rows.shape[1:]).T for n, v in found.items()}

    def _spread(self, times: Floats, rows: Floats) -> tuple[Any, ...]:
        """States at many times as lanes of their own: time, rotation, omega, slip and further states, and whose."""
        each = np.tile(np.arange(self.count), times.size)
        time = (times[:, None] / np.broadcast_to(self.time_scale, self.count)).ravel()
        return time, rows[0].ravel(), rows[1].ravel(), rows[3:].reshape(len(rows) - 3, -1), each

    def holding_friction(self, times: Floats, rows: Floats) -> Floats:
        """The friction that just holds the mass at rest where it is at times in s, (lanes, times).

        The greater one of both ways, where both are open to it; NaN where nothing presses.
        """
        bound, found = self._asking, np.full(rows.shape[1:], np.nan)
        time, rotation, _, further, each = self._spread(times, rows)
        for side in (1.0, -1.0):
            lanes = self._placed(bound, time, rotation, 0.0, further, each, side)
            driving, resisting, normal = (
                lanes.c[bound.program.roles[f"cell_{n}"]] for n in ("driving", "resisting", "normal0")
            )
            with np.errstate(all="ignore"):
                held = np.where((normal > 0.0) & lanes.may_start(side), (driving - resisting) / normal, np.nan)
            found = np.fmax(found, np.maximum(held, 0.0).reshape(found.shape))
        return found.T

    @cached_property
    def _asking(self) -> Bound:
        return self.bind(("pressing", "normal", "mu"))

    def _probe(self, bound: Bound, time: Any, rotation: Any, omega: Any, further: Any, names: tuple[str, ...],
               each: Any = slice(None)) -> dict[str, Floats]:  # fmt: skip
        """Registers of the program in given states: what a phase would begin with there."""
        lanes = self._placed(bound, time, rotation, omega, further, each, np.where(omega < 0.0, -1.0, 1.0))
        with np.errstate(all="ignore"):
            r = lanes._series(0)[0]
        return {n: r[bound.program.roles[n], 0] for n in names}

    def _placed(self, bound: Bound, time: Any, rotation: Any, omega: Any, further: Any, each: Any,
                side: Any) -> walk.Lanes:  # fmt: skip
        """Lanes at the start of a phase in given states."""
        cells = bound.cells[:, each].copy()
        cells[walk.TIME], cells[walk.ROTATION], cells[walk.OMEGA] = time, rotation, np.abs(omega)
        cells[walk.DIRECTION], cells[walk.LIFTED] = side, 0.0
        if further is not None:
            cells[walk.SLIP] = further[0]
            for (cell, _, _), value in zip(bound.program.states[2:], further[1:], strict=True):
                cells[cell] = value
        which = np.arange(cells.shape[1])
        parts = [t.lanes(each) if t.coefficients.ndim == 3 else t for t in bound.tables]
        lanes = walk.Lanes(bound.program, parts, cells, None, which)
        with np.errstate(all="ignore"):
            lanes.find_pieces()
            lanes.base()
        return lanes

    @property
    def brake(self) -> Floats:
        """q = 2 (lambda A mu + d)/Theta* at the start, read off the program."""
        bound = self.bound
        lanes = walk.Lanes(bound.program, bound.tables, bound.cells.copy(), None, np.arange(self.count))
        lanes.c[walk.DIRECTION] = 1.0
        with np.errstate(all="ignore"):
            lanes.base()
            return 2 * frozen.brake(lanes)

    @cached_property
    def statics(self) -> dict[str, Floats]:
        """Limit friction, factor of safety, yield coefficient and friction at the start, without shaking.

        k_y is where the drive, linear in k_h, is zero; both are read off the program itself.
        """
        kept = {e: given for e, given in self.called.items() if e != "shaking"}
        free, normals = [], []
        found: dict[str, Any] = {}
        for k_h in (0.0, 1.0):
            bound = bind(self.arc, kept | {"shaking": {"horizontal": k_h}}, self.friction, 0.0, math.inf,
                         self.accuracy, self.count)  # fmt: skip
            roles, c = bound.program.roles, bound.cells.copy()
            down = np.where(c[[*bound.program.cells].index("fall")] < 0.0, -1.0, 1.0)
            c[walk.DIRECTION] = down
            c[[*bound.program.cells].index("k_h")] *= down
            lanes = walk.Lanes(bound.program, bound.tables, c, None, np.arange(self.count))
            with np.errstate(all="ignore"):
                lanes.base()
                if k_h == 0.0:
                    driving, resisting, normal, mu = (
                        c[roles[f"cell_{n}"]].copy() for n in ("driving", "resisting", "normal0", "mu")
                    )
                    pressed = normal > 0.0
                    held = resisting + np.where(pressed, mu * normal, 0.0)
                    none = np.where(driving > resisting, np.inf, -np.inf)
                    found = {
                        "limit_friction": np.where(pressed, bound.cells[walk.LIMIT], none),
                        "factor_of_safety": np.where(driving > 8 * EPS * abs(normal), held / driving, np.inf),
                        "friction": mu,
                    }  # fmt: skip
                free.append(c[roles["cell_driving"]] - c[roles["cell_resisting"]])
                normals.append(c[roles["cell_normal0"]].copy())
        with np.errstate(all="ignore"):
            mu = found["friction"]
            drive, shaken = (f - mu * n for f, n in zip(free, normals, strict=True))
            exact = np.where(normals[0] > 0.0, normals[0] * (found["limit_friction"] - mu), drive)
            yields = -exact / (shaken - drive)
            lifted = normals[0] + yields * (normals[1] - normals[0]) < 0.0
            found["yield_coefficient"] = np.where(lifted, -free[0] / (free[1] - free[0]), yields) + 0.0
        return found

    def energies(self, times: Floats) -> tuple[dict[str, Floats], Floats]:
        """Kinetic energy, work and dissipation at times in s, (times, lanes), and the first kinetic energy."""
        bound = self.bind(("energy",))
        rows, _ = self._sampled(bound, times, False)
        names = [bound.program.cells[cell] for cell, _, _ in bound.program.states[2:]]
        work, lost = (rows[4 + names.index(n)] for n in ("work", "dissipation"))
        found = {"kinetic": rows[1] ** 2 / 2, "work": work, "dissipation": np.maximum(lost, 0.0)}
        return found, bound.cells[walk.OMEGA] ** 2 / 2
