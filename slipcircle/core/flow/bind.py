"""A scene's numbers as the flow takes them: its program, the tables of its functions, and the cells of its lanes."""

import math
from collections.abc import Callable, Iterable, Mapping
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from generated import layout as ix
from generated.effects import EFFECTS, LAWS
from generated.flow import PIECES
from slipcircle.base.checks import choose, plain
from slipcircle.base.series import Pulse, Series
from slipcircle.core.flow import tables
from slipcircle.core.flow.program import Program, join
from slipcircle.core.scene.arc import Arc
from slipcircle.core.scene.forcing import factor as factor_of
from slipcircle.core.scene.friction import law_parts
from slipcircle.core.scene.layers import LayeredSection, OfRotation
from slipcircle.core.scene.section import Section

Floats = NDArray[np.float64]
FINEST = 1e-14
LOWEST = 5  # order, as the radius of convergence is told by the last coefficients against the first five
STEP = math.exp(-2.0)  # of the radius of convergence, so that a series of order n leaves exp(-2 n)


class Bound(NamedTuple):
    """What `walk.walk` takes, and what turns its numbers back into seconds and metres."""

    program: Program
    tables: list[tables.Data]
    cells: Floats
    time_scale: Any
    functions: Mapping[int, Callable[[Any], Any]]  # of slip, given in Python, by the place of their table
    joined: tuple[tuple[str, ...], ...]  # what `join` made the program of

    def asking(self, asked: tuple[str, ...] = (), directions: int = 0) -> "Bound":
        """The same lanes with further outputs, or with derivatives in so many directions."""
        return self._of(join(*self.joined, asked, directions))

    def shaken(self) -> "Bound":
        """The same lanes under a steady horizontal coefficient, nothing at first, in the place of their shaking."""
        effects, laws, moving, absent = self.joined
        ours = {p.symbol for p in EFFECTS["shaking"].parameters}
        effects = tuple(e for e in EFFECTS if e in (*effects, "shaking"))
        moving, absent = (tuple(s for s in symbols if s not in ours) for symbols in (moving, absent))
        return self._of(join(effects, laws, moving, (*absent, "k_v")))

    def _of(self, program: Program) -> "Bound":
        """The same numbers for another program."""
        cells = program.blank(self.cells.shape[1])
        to, of = _shared(program, self.program)
        cells[to] = self.cells[of]
        data = {slot.name: t for slot, t in zip(self.program.tables, self.tables, strict=True)}
        return self._replace(program=program, cells=cells, tables=[data[slot.name] for slot in program.tables])

    def lengthen(self, cells: Floats) -> None:
        """Sample Python functions of slip on, as far as lanes are."""
        for k, function in self.functions.items():
            slip = float(np.max(cells[ix.SLIP] * cells[self.program.tables[k].cells + ix.SCALE]))
            while (end := float(self.tables[k].breaks[-1])) <= slip * (1.0 + 1e-12):
                self.tables[k] = tables.sampled(function, 2 * end, self.tables[k])

    def start(self) -> Floats:
        """The cells to walk with."""
        cells = self.program.blank(self.cells.shape[1])
        cells[: self.program.given] = self.cells[: self.program.given]
        return cells


@lru_cache(maxsize=256)
def _shared(program: Program, other: Program) -> tuple[Any, Any]:
    """Where two programs hold the same numbers."""
    names = [x for x in program.cells[: program.given] if x in other.places]
    return np.array([program.places[x] for x in names]), np.array([other.places[x] for x in names])


def order(accuracy: float) -> int:
    """Order of the series that leaves less than an accuracy at steps of exp(-2) of the radius of convergence."""
    return max(math.ceil(3.0 - math.log(max(accuracy, 1e-16)) / 2.0), LOWEST)


def bind(
    arc: Arc | Section,
    called: Mapping[str, Mapping[str, Any]],
    friction: Any,
    velocity: Any,
    end_time: Any,
    accuracy: float,
    lanes: int,
) -> Bound:
    """Lanes of scenes that share their effects and laws.

    Parameters
    ----------
    arc : Arc or Section
        Its fields, like all numbers here, are numbers or arrays of one value a lane.
    called : mapping
        Effects by name, each with its parameters; functions of time are `Series` or `Pulse`.
    friction : float, array, mapping or callable
        As a `Scene` takes it.
    velocity, end_time : float or ndarray
        m/s and s; infinite where there is no end.
    accuracy : float
    lanes : int
    """
    effects = tuple(e for e in EFFECTS if e in called)
    parts = law_parts(friction)
    known = [(p.symbol, called[e].get(p.name)) for e in effects for p in EFFECTS[e].parameters if p.symbol]
    moving = tuple(symbol for symbol, value in known if callable(value))
    absent = tuple(symbol for symbol, value in known if value is None)
    joined = (effects, tuple(name for name, _ in parts), moving, absent)
    program = join(*joined)
    time_scale, radius, weights = plain(arc.time_scale), plain(arc.radius), arc.weights
    given: dict[str, Any] = weights._asdict()
    scales = scales_of(arc)
    pieces: dict[str, tuple[tables.Data, Any, Any]] = {}  # by name: data, scale, factor
    functions: dict[str, Callable[[Any], Any]] = {}
    terms = called.get("layered_strength", {})
    functions_of_rotation = {n: v for n, v in terms.items() if isinstance(v, OfRotation)}
    layered = dict[str, tables.Data]()
    if functions_of_rotation:
        assert isinstance(arc, LayeredSection)
        layered = of_rotation(
            arc,
            functions_of_rotation,
            turns(effects),
            "shaking" in effects or bool(np.any(velocity < 0.0)),
            min(accuracy, 1e-9) if lanes > 1 else 1e-11,
        )
    for effect in effects:
        own = {p.name: called[effect].get(p.name, 0.0) for p in EFFECTS[effect].parameters if p.kind == "number"}
        for p in EFFECTS[effect].parameters:
            if not p.symbol:
                continue
            value = called[effect].get(p.name, 0.0)
            if effect == "layered_strength" and p.name in layered:
                pieces[p.symbol] = layered[p.name], 1.0, 1.0
            elif callable(value) and p.kind == "rotation":
                assert isinstance(arc, Section)
                pieces[p.symbol] = under_water(arc, turns(effects)), 1.0, p.dimensionless(1.0, scales | own)
            elif callable(value):
                factor = factor_of(effect, called[effect], p.name)
                pieces[p.symbol] = in_time(value), time_scale, p.dimensionless(factor, scales | own)
            else:
                given[p.symbol] = p.dimensionless(value, scales | own)
    for name, parameters in parts:
        _law(name, parameters, radius, time_scale, given, pieces, functions)
    with np.errstate(over="ignore"):
        first = {
            "omega": velocity / radius * time_scale,
            "END_TIME": end_time / time_scale,
            "LIMIT": abs(weights.static_limit),
            # The steps of one scene cost next to nothing, whatever their order.
            "ORDER": order(min(accuracy, FINEST) if lanes == 1 else accuracy),
            "FACTOR": STEP,
            "CLOSE": np.inf,
            "LIFT_TIME": np.nan,
        }
    shaken = called.get("shaking", {})
    first["ONE_WAY"] = float(callable(shaken.get("horizontal")) and not shaken.get("two_way", False))
    first["FIRST_ONLY"] = choose(end_time == np.inf, _first_only(effects, parts, given), 0.0)
    cells, at = program.blank(lanes), program.places
    for name, value in (given | first).items():
        if name in at:
            cells[at[name]] = value
    data = list[tables.Data]()
    for slot in program.tables:
        piece, scale, factor = pieces[slot.name]
        data.append(piece)
        cells[slot.cells + ix.SCALE], cells[slot.cells + ix.SCALED_BY] = scale, factor
    places = {k: functions[slot.name] for k, slot in enumerate(program.tables) if slot.name in functions}
    return Bound(program, data, cells, time_scale, places, joined)


def scales_of(arc: Arc | Section) -> dict[str, Any]:
    """The numbers of an arc by which parameters of effects are made dimensionless, SI."""
    return {
        "half_angle": arc.half_angle,
        "gravity": arc.gravity,
        "reference_stress": arc.reference_stress,
        "Theta": arc.dimensionless.moment_of_inertia,
        "radius": plain(arc.radius),
        "density": plain(arc.mean_unit_weight) / plain(arc.gravity),
        "cover": arc.weights.cover,
    }


def turns(effects: Iterable[str]) -> bool:
    """Whether an effect lets the mass turn."""
    return any(EFFECTS[e].turns for e in effects)


def under_water(section: Section, turning: bool, others: Any = None, count: int = 1) -> tables.Data:
    """The mean pore pressure under a section's water level, Pa, at all rotations until its weight presses no more.

    Or, of a single section, so many other functions of the rotation that have their kinks where it has its.
    """
    shape = section.shape or (count,)

    def pressure(turn: Any) -> Any:
        return section.mean_pressure(turn) if section.shape else section.mean_pressure(turn[..., 0])[..., None]

    function = others or pressure
    if turning:
        kinks, weights = np.moveaxis(section.pressure_kinks, -1, 0), section.weights
        most = np.broadcast_to(np.arctan2(weights.press, weights.press_slope), shape)  # J_r cos - J_r' sin falls to 0
        kinks = np.broadcast_to(kinks if section.shape else kinks[:, None], (len(kinks), *shape))
        found = tables.turning(function, kinks, most - np.pi, most)
    else:
        still = np.zeros((1, tables.TERMS, *shape))
        still[0, 0] = function(np.zeros(shape))
        found = tables.Data(np.zeros((1, *shape)), still, np.zeros(1))
    if section.shape or others:
        return found
    return found._replace(breaks=found.breaks[:, 0], coefficients=found.coefficients[..., 0])


def of_rotation(
    section: LayeredSection, terms: Mapping[str, OfRotation], turning: bool, back: bool, accuracy: float
) -> dict[str, tables.Data]:
    """Functions of the rotation that a layered section gives, in the same pieces, until its weight presses no more.

    ``back`` says whether the mass may move up-slope beyond where it began.
    """
    kinks = section.rotation_kinks
    circles, lanes = kinks.shape[1], max(f.coefficients.shape[1] for f in terms.values())

    def values(rotation: Floats) -> Floats:
        """Of one circle the parts, which all lanes share."""
        if circles == 1:
            return np.concatenate([f.parts(rotation) for f in terms.values()])
        return np.stack([f(rotation) for f in terms.values()])

    still = np.zeros(circles)
    if turning:
        weights = section.weights
        most = np.broadcast_to(np.arctan2(weights.press, weights.press_slope), (lanes,))
        most = most.max(keepdims=True) if circles == 1 else most
        least = most - np.pi if back else still
        breaks, coefficients = tables.between_kinks(values, kinks, least, most, 1e-2 * accuracy)
    else:
        breaks, coefficients = still[None], np.zeros((1, tables.TERMS, *values(still[None])[:, 0].shape))
        coefficients[0, 0] = values(still[None])[:, 0]
    parts = np.split(coefficients, np.cumsum([len(f.coefficients) for f in terms.values()])[:-1], axis=2)
    found = {}
    for k, (name, f) in enumerate(terms.items()):
        if circles == 1:
            mine = (parts[k][..., 0].reshape(-1, len(f.coefficients)) @ f.coefficients).reshape(
                *coefficients.shape[:2], -1
            )
            starts = breaks[:, 0]
        else:
            mine, starts = np.ascontiguousarray(coefficients[:, :, k]), np.ascontiguousarray(breaks)
        if lanes == 1:
            mine, starts = mine[..., 0], starts if starts.ndim == 1 else starts[:, 0]
        found[name] = tables.Data(starts, mine, np.zeros(len(breaks)))
    return found


def in_time(function: Any) -> tables.Data:
    """A function of time in pieces."""
    if isinstance(function, Series):
        first, last = (function.values[0], function.values[-1]) if function.held else (0.0, 0.0)
        return tables.lines(function.time, function.values, float(first), float(last))
    if isinstance(function, Pulse):
        start, duration, top = function.start, function.duration, function.amplitude
        if function.name == "rectangular":
            return tables.lines(np.array([start, start + duration]), np.array([top, top]), 0.0, 0.0)
        if function.name == "triangular":
            middle = start + duration / 2
            return tables.lines(np.array([start, middle, start + duration]), np.array([0.0, top, 0.0]), 0.0, 0.0)
        waves = 2 * function.cycles if function.name == "sine" else 1.0
        return tables.waves(start, duration, top, math.pi * waves / duration)
    raise TypeError(f"{function!r} is no Series or Pulse")


def _law(
    name: str,
    parameters: Mapping[str, Any],
    radius: Any,
    time_scale: Any,
    given: dict[str, Any],
    pieces: dict[str, tuple[tables.Data, Any, Any]],
    functions: dict[str, Callable[[Any], Any]],
) -> None:
    """What a law gives the program: dimensionless numbers under its own name, or a table."""
    if name == "callable":
        functions[name] = parameters["function"]
        first = tables.sampled(functions[name], float(np.max(radius)) / 256)
        pieces[name] = first, radius, 1.0
        return
    law, speed = LAWS[name], radius / time_scale
    if name in PIECES:
        pieces[name] = tables.of_law(name, parameters), radius / parameters[PIECES[name][0]], 1.0
    elif law.parameters[0].kind == "list":
        place, values = (np.asarray(parameters[p.name], dtype=np.float64) for p in law.parameters)
        match law.depends_on:
            case ("slip",):
                pieces[name] = tables.monotone(place, values), radius, 1.0
            case ("speed",):
                pieces[name] = tables.of_speed(place, values), speed, 1.0
            case _:
                pieces[name] = tables.lines(place, values, float(values[0]), float(values[-1])), time_scale, 1.0
    else:
        unit = {"m": radius, "m/s": speed, "": 1.0}
        given |= {f"{name}.{p.name}": parameters[p.name] / unit[p.unit] for p in law.parameters}


def _first_only(effects: tuple[str, ...], parts: Any, given: Mapping[str, Any]) -> Any:
    """1 where nothing ever brings the mass to rest, 2 where water or heat may carry it: it is followed to its stop."""
    if not turns(effects):
        return 0.0
    name, parameters = parts[0]
    free = parameters["coefficient"] == 0.0 if (name, len(parts)) == ("constant", 1) else False
    carried = 2.0 if {"pore_pressure", "thermal_pressurisation"} & {*effects} else 0.0
    return choose(given.get("cohesion", 0.0) > 0.0, 0.0, choose(free, 1.0, carried))
