"""A scene's numbers as the flow takes them: its program, the tables of its functions, and the cells of its lanes."""

import math
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from generated.effects import EFFECTS, LAWS
from generated.flow import PIECES
from slipcircle.base.series import Pulse, Series
from slipcircle.flow import tables, walk
from slipcircle.flow.program import Program, join
from slipcircle.records.given import factor as factor_of
from slipcircle.scene.arc import Arc
from slipcircle.scene.section import Section

Floats = NDArray[np.float64]
FINEST = 1e-14
STEP = math.exp(-2.0)  # of the radius of convergence, so that a series of order n leaves exp(-2 n)


class Bound(NamedTuple):
    """What `walk.walk` takes, and what turns its numbers back into seconds and metres."""

    program: Program
    tables: list[tables.Data]
    cells: Floats
    time_scale: Any
    functions: Mapping[int, "Grown"]  # tables of Python functions, by their place


class Grown(NamedTuple):
    """A Python function whose table grows as the motion reaches further, in its own unit."""

    function: Callable[[Any], Any]
    name: str


def order(accuracy: float) -> int:
    """Order of the series that leaves less than an accuracy at steps of exp(-2) of the radius of convergence."""
    return math.ceil(3.0 - math.log(max(accuracy, 1e-16)) / 2.0)


def law_parts(friction: Any) -> tuple[tuple[str, Mapping[str, Any]], ...]:
    """The laws that a scene's friction is a product of: each by name, with its parameters."""
    if callable(friction):
        return (("callable", {"function": friction}),)
    if not isinstance(friction, Mapping):
        return (("constant", {"coefficient": friction}),)
    own = {n: v for n, v in friction.items() if n not in ("law", "rate")}
    return ((friction["law"], own), *(law_parts(friction["rate"]) if "rate" in friction else ()))


def bind(arc: Arc | Section, called: Mapping[str, Mapping[str, Any]], friction: Any, velocity: Any, end_time: Any,
         accuracy: float, lanes: int, asked: tuple[str, ...] = (), directions: int = 0) -> Bound:  # fmt: skip
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
    program = join(effects, tuple(name for name, _ in parts), moving, absent, asked, directions)
    time_scale, radius = arc.time_scale, np.asarray(arc.radius, dtype=np.float64)
    weights = arc.weights
    limit = weights.static_limit
    given: dict[str, Any] = weights._asdict() | {"limit": limit}
    scales = {
        "half_angle": arc.half_angle, "gravity": arc.gravity, "reference_stress": arc.reference_stress,
        "Theta": arc.dimensionless.moment_of_inertia, "radius": radius,
        "density": np.divide(arc.unit_weight, arc.gravity),
    }  # fmt: skip
    pieces: dict[str, tuple[tables.Data, Any, Any]] = {}  # by name: data, scale, factor
    grown: dict[str, Grown] = {}
    for effect in effects:
        own = {p.name: called[effect].get(p.name, 0.0) for p in EFFECTS[effect].parameters if p.kind == "number"}
        for p in EFFECTS[effect].parameters:
            if not p.symbol:
                continue
            value = called[effect].get(p.name, 0.0)
            share = weights.cover if p.name == "ratio" else factor_of(effect, called[effect], p.name)
            if callable(value):
                pieces[p.symbol] = in_time(value), time_scale, p.dimensionless(share, scales | own)
            else:
                given[p.symbol] = p.dimensionless(value * share, scales | own)
    for name, parameters in parts:
        _law(name, parameters, radius, time_scale, given, pieces, grown)
    cells = np.zeros((len(program.cells), lanes))
    at = {name: k for k, name in enumerate(program.cells)}
    for name, value in program.constants.items():
        cells[at[name]] = value
    for name, value in given.items():
        if name in at:
            cells[at[name]] = value
    data, functions = list[tables.Data](), dict[int, Grown]()
    for k, slot in enumerate(program.tables):
        piece, scale, factor = pieces[slot.name]
        data.append(piece)
        cells[slot.cells + walk.SCALE], cells[slot.cells + walk.SCALED_BY] = scale, factor
        if slot.name in grown:
            functions[k] = grown[slot.name]
    with np.errstate(over="ignore"):
        cells[walk.OMEGA] = np.asarray(velocity, dtype=np.float64) / radius * time_scale
        cells[walk.END_TIME] = np.asarray(end_time, dtype=np.float64) / time_scale
    # The steps of one scene cost next to nothing, whatever their order.
    cells[walk.ORDER], cells[walk.FACTOR] = order(min(accuracy, FINEST) if lanes == 1 else accuracy), STEP
    cells[[walk.FIRST_STOP, walk.LIFT_TIME]] = np.nan
    cells[walk.CLOSE] = np.inf
    shaken = called.get("shaking", {})
    cells[walk.ONE_WAY] = float(callable(shaken.get("horizontal")) and not shaken.get("two_way", False))
    cells[walk.FIRST_ONLY] = np.where(np.isinf(cells[walk.END_TIME]), _first_only(effects, parts, given), 0.0)
    cells[walk.LIMIT] = _limit(program, data, cells, limit)
    return Bound(program, data, cells, time_scale, functions)


def _limit(program: Program, data: list[tables.Data], cells: Floats, limit: Any) -> Any:
    """The limit friction at the start, in the direction in which the mass is driven, of which its drive is made."""
    probe = walk.Lanes(program, data, cells.copy(), None, np.arange(cells.shape[1]))
    c, roles = probe.c, program.roles
    c[walk.DIRECTION] = 1.0
    c[walk.OMEGA] = np.abs(c[walk.OMEGA])
    with np.errstate(all="ignore"):
        probe.base()
        c[walk.DIRECTION] = np.where(c[roles["cell_driving"]] < 0.0, -1.0, 1.0)
        probe.base()
        driving, resisting, normal = (c[roles[f"cell_{n}"]] for n in ("driving", "resisting", "normal0"))
        alone = (driving == c[roles["cell_f0"]]) & (normal == c[roles["cell_p0"]]) & (resisting == 0.0)
        return np.where(alone, np.abs(limit), (driving - resisting) / normal)


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


def _law(name: str, parameters: Mapping[str, Any], radius: Any, time_scale: Any, given: dict[str, Any],
         pieces: dict[str, tuple[tables.Data, Any, Any]], grown: dict[str, Grown]) -> None:  # fmt: skip
    """What a law gives the program: dimensionless numbers under its own name, or a table."""
    if name == "callable":
        function = parameters["function"]
        first = float(np.max(radius)) / 256
        breaks, found = tables.sampled(function, 0.0, first, "friction")
        data = tables.Data(np.array([*breaks, first]), np.array([*found, found[-1]]), np.zeros(len(breaks) + 1),
                           open=True)  # fmt: skip
        pieces[name], grown[name] = (data, radius, 1.0), Grown(function, "friction")
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
    if not any(EFFECTS[e].turns for e in effects):
        return 0.0
    name, parameters = parts[0]
    free = np.asarray(parameters["coefficient"]) == 0.0 if (name, len(parts)) == ("constant", 1) else False
    carried = 2.0 if {"pore_pressure", "thermal_pressurisation"} & {*effects} else 0.0
    held = np.asarray(given.get("cohesion", 0.0)) > 0.0
    return np.where(held, 0.0, np.where(free, 1.0, carried))
