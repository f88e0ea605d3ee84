"""Lanes of scenes that share their effects and laws: bound, walked to their end, and asked for what they passed."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from generated import layout as ix
from slipcircle.base.checks import EPS, choose, plain
from slipcircle.core.flow.bind import Bound, bind
from slipcircle.core.flow.columns import Columns
from slipcircle.core.flow.compiled import engine
from slipcircle.core.flow.program import Log, Samples
from slipcircle.core.scene.arc import Arc
from slipcircle.core.scene.coordinates import by_lanes
from slipcircle.core.scene.section import Section

Floats = NDArray[np.float64]
# Lanes at once, so that what they need stays in the cache; rows a power of two apart would share its lines.
BLOCK = 16000
ASKED = ("pressing", "normal", "mu")  # what a program is asked for beside its states


def walked(
    bound: Bound, samples: Samples | None = None, log: Log | None = None, walker: Any = None, cells: Any = None
) -> Floats:
    """The cells of lanes at their end, by default a copy's; from the start again where a Python function goes on."""
    walker = walker or engine().walk
    while True:
        cells = bound.start() if cells is None else cells
        walker(bound.program, bound.tables, cells, samples, log)
        if cells[ix.STATUS].max(initial=0.0) < ix.TOO_LONG:
            return cells
        many = (cells[ix.STATUS] == ix.TOO_LONG) & (cells[ix.STEPS] > ix.MOST_STEPS)
        long = np.flatnonzero(many & (cells[ix.OMEGA] > 0.0))
        while long.size:
            from slipcircle.core.flow import stiff  # only here

            stiff.walk(bound.program, bound.tables, cells, samples, log, long)
            long = long[cells[ix.STATUS, long] == ix.NEED]
            if long.size:
                bound.lengthen(cells[:, long])
        needs = np.flatnonzero(cells[ix.STATUS] == ix.NEED)
        if not needs.size:
            return cells
        one = cells[:, needs[:1]]  # walks on from where it is, to find out how far the function is asked for
        while one[ix.STATUS, 0] == ix.NEED:
            bound.lengthen(one)
            one[ix.OMEGA], one[ix.STATUS] = one[ix.DIRECTION] * one[ix.OMEGA], ix.START
            engine().walk(bound.program, [t.lanes(needs[:1]) for t in bound.tables], one)
        cells = None
        if log is not None:
            log.clear()


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
    count: int
    invalid: Any = False

    def taken(self, which: Any) -> "Lanes":
        """Some of the lanes, by an index of them in their order."""

        def cut(value: Any, axes: int = 0) -> Any:
            if isinstance(value, Mapping):
                return {n: cut(v) for n, v in value.items()}
            by_lane = isinstance(value, np.ndarray) and value.ndim == axes + 1 and len(value) == self.count
            return value[which] if by_lane else value

        given = {f.name: cut(getattr(self, f.name)) for f in fields(Lanes)}
        arc = by_lanes(self.arc, cut)
        given["called"] = arc.section_effects(given["called"])
        return Lanes(**given | {"arc": arc, "count": np.arange(self.count)[which].size})

    def parts(self) -> Iterator[tuple[slice, "Lanes"]]:
        """The lanes in blocks."""
        for first in range(0, self.count, BLOCK):
            which = slice(first, first + BLOCK)
            yield which, self.taken(which)

    @cached_property
    def bound(self) -> Bound:
        """What programs are asked with, again and again."""
        return self._bind()

    def _bind(self) -> Bound:
        found = bind(self.arc, self.called, self.friction, self.velocity, self.end_time, self.accuracy, self.count)
        if self.invalid is not False:
            found.cells[ix.STATUS, np.broadcast_to(self.invalid, self.count)] = ix.FAILED
        return found

    @cached_property
    def time_scale(self) -> Any:
        """s for one of the dimensionless time, without binding what only walking needs."""
        return plain(self.arc.time_scale)

    @cached_property
    def radius(self) -> Any:
        return plain(self.arc.radius)

    @property
    def stress_unit(self) -> Any:
        """Pa for one of normal force over Theta*: sigma_ref over lambda/Theta*."""
        return plain(self.arc.reference_stress / self.arc.weights.level)

    @property
    def energy_unit(self) -> Any:
        """J for one of omega*^2/2."""
        arc = self.arc
        weight = np.multiply(arc.width, arc.unit_weight) * np.power(arc.radius, 3.0)
        return weight * arc.dimensionless.moment_of_inertia

    def solve(self, log: Log | None = None) -> Floats:
        """The cells of all lanes at their end."""
        if self.count == 1:
            return walked(self.bound, None, log)
        bound = self._bind()  # of many lanes copies and what is kept cost as much as the walk
        return walked(bound, None, log, cells=None if bound.functions else bound.cells)

    def _sampled(self, bound: Bound, times: Floats) -> tuple[Floats, Floats]:
        """As `read`, of any bound lanes; and their last cells."""
        order = np.argsort(times, kind="stable")
        at = times[order][:, None] / np.broadcast_to(bound.time_scale, (1, self.count))
        rows = np.zeros((2 + len(bound.program.states), times.size, self.count))
        found = np.full((2 + len(bound.program.states), times.size, self.count), np.nan)
        cells = walked(bound, Samples(np.ascontiguousarray(at), rows))
        found[:, order] = rows
        return found, cells

    def read(self, times: Floats) -> Floats:
        """Rotation, omega, its rate, slip and further states at times in s, (rows, times, lanes)."""
        return self._sampled(self.bound, times)[0]

    def stress(self, time: Any, rotation: Any, omega: Any) -> Any:
        """The mean normal stress, Pa, of each lane in one state; dimensionless numbers."""
        if self.count > BLOCK:
            return np.concatenate([part.stress(time[k], rotation[k], omega[k]) for k, part in self.parts()])
        return self._probe(time, rotation, omega)["pressing"] * self.stress_unit

    def outputs(self, times: Floats, rows: Floats) -> dict[str, Floats]:
        """What presses, water included and without it, and friction at times in s, of states as `read` gives them."""
        time, rotation, omega, further, each = self._spread(times, rows)
        return {n: v.reshape(rows.shape[1:]).T for n, v in self._probe(time, rotation, omega, further, each).items()}

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
            c, _ = self._begun(bound, time, rotation, 0.0, further, each, side)
            roles = bound.program.roles
            driving, resisting, normal = (c[roles[f"cell_{n}"]] for n in ("driving", "resisting", "normal0"))
            may = Columns(bound.program, (), c, None, each).may_start(side)
            with np.errstate(all="ignore"):
                held = np.where((normal > 0.0) & may, (driving - resisting) / normal, np.nan)
            found = np.fmax(found, np.maximum(held, 0.0).reshape(found.shape))
        return found.T

    @cached_property
    def _asking(self) -> Bound:
        return self.bound.asking(ASKED)

    def _probe(
        self, time: Any, rotation: Any, omega: Any, further: Any = None, each: Any = slice(None)
    ) -> dict[str, Floats]:
        """Registers of the program in given states: what a phase would begin with there."""
        bound, side = self._asking, choose(omega < 0.0, -1.0, 1.0)
        r = self._begun(bound, time, rotation, omega, further, each, side)[1]
        return {n: r[bound.program.roles[n]] for n in ASKED}

    def _begun(
        self, bound: Bound, time: Any, rotation: Any, omega: Any, further: Any, each: Any, side: Any
    ) -> tuple[Floats, Floats]:
        """Cells and registers at the start of a phase in given states."""
        cells = bound.cells[:, each].copy()
        cells[ix.TIME], cells[ix.ROTATION], cells[ix.OMEGA] = time, rotation, abs(omega)
        cells[ix.DIRECTION], cells[ix.LIFTED] = side, 0.0
        if further is not None:
            cells[ix.SLIP] = further[0]
            bound.lengthen(cells)
            for (cell, _, _), value in zip(bound.program.states[2:], further[1:], strict=True):
                cells[cell] = value
        parts = [t.lanes(each) if t.coefficients.ndim == 3 else t for t in bound.tables]
        return cells, engine().begin(bound.program, parts, cells)

    @property
    def brake(self) -> Floats:
        """q = 2 (lambda A mu + d)/Theta* at the start, read off the program."""
        bound, roles = self.bound, self.bound.program.roles
        cells = bound.cells.copy()
        cells[ix.DIRECTION] = 1.0
        engine().begin(bound.program, bound.tables, cells)
        cells[roles["cell_drive"]], cells[ix.OMEGA] = 0.0, 1.0
        net = engine().registers(bound.program, bound.tables, cells)[roles["net"]]
        return np.asarray(-2.0 * net)

    @cached_property
    def statics(self) -> dict[str, Floats]:
        """Limit friction, factor of safety, yield coefficient and friction at the start, without shaking.

        k_y is where the drive, linear in k_h, is zero; both are read off the program itself.
        """
        bound = self.bound.shaken()
        roles, at = bound.program.roles, bound.program.places
        c = bound.cells
        c[ix.OMEGA], c[ix.DIRECTION] = 0.0, np.where(c[at["fall"]] < 0.0, -1.0, 1.0)
        c[at["k_h"]], shaken = 0.0, c.copy()
        shaken[at["k_h"]] = c[ix.DIRECTION]
        engine().begin(bound.program, bound.tables, c)
        engine().begin(bound.program, bound.tables, shaken)
        driving, resisting, normal, mu, limit = (
            c[roles[f"cell_{n}"]] for n in ("driving", "resisting", "normal0", "mu", "limit")
        )
        pressed = normal > 0.0
        with np.errstate(all="ignore"):
            free, freed = driving - resisting, shaken[roles["cell_driving"]] - shaken[roles["cell_resisting"]]
            limit = np.where(pressed, limit, np.where(free > 0.0, np.inf, -np.inf))
            held = resisting + np.where(pressed, mu * normal, 0.0)
            drive, driven = free - mu * normal, freed - mu * shaken[roles["cell_normal0"]]
            exact = np.where(pressed, normal * (limit - mu), drive)
            yields = -exact / (driven - drive)
            lifted = normal + yields * (shaken[roles["cell_normal0"]] - normal) < 0.0
            return {
                "limit_friction": limit,
                "friction": mu,
                "factor_of_safety": np.where(driving > 8 * EPS * abs(normal), held / driving, np.inf),
                "yield_coefficient": np.where(lifted, -free / (freed - free), yields) + 0.0,
            }

    def energies(self, times: Floats) -> tuple[dict[str, Floats], Floats]:
        """Kinetic energy, work and dissipation at times in s, (times, lanes), and the first kinetic energy."""
        bound = self.bound.asking(("energy",))
        rows, _ = self._sampled(bound, times)
        names = [bound.program.cells[cell] for cell, _, _ in bound.program.states[2:]]
        work, lost = (rows[4 + names.index(n)] for n in ("work", "dissipation"))
        found = {"kinetic": rows[1] ** 2 / 2, "work": work, "dissipation": np.maximum(lost, 0.0)}
        return found, bound.cells[ix.OMEGA] ** 2 / 2
