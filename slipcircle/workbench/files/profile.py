"""Conversion of soils, layers and loads of a scene file to objects of the core, with checks across tables."""

from collections.abc import Iterator, Mapping
from difflib import get_close_matches
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from slipcircle.base.inputerror import InputError
from slipcircle.base.kinds import Rename, TextMap, Texts, ValueDict, Values
from slipcircle.layers import Soil, layer_mistakes
from slipcircle.workbench.files.document import shown_value
from slipcircle.workbench.stability.critical import Critical

Arguments = Mapping[str, ValueDict]
Surcharges = list[tuple[float, float, float, float]]  # left and right x in m, and the pressures there in Pa


class GroundProfile(NamedTuple):
    """Layers of a file for a `Slope` or a `LayeredSection`, mistakes, and remarks."""

    layers: list[tuple[Soil, Any]]
    foreland: Soil | None
    strength: str
    rate: Values | None  # law of speed of all soils
    mistakes: Texts
    remarks: Texts


def numbered_points(arguments: Arguments, name: str) -> list[ValueDict]:
    """Return the arguments of the tables of a list such as [[layers]], in order.

    `arguments` are the arguments by path of the table, such as "layers.2", and `name` is the name of the list.
    """
    tables = {}
    for path, table in arguments.items():
        of_list, _, number = path.partition(".")
        if of_list == name and number:
            tables[int(number)] = table
    return [tables[number] for number in sorted(tables)]


def surcharges(arguments: Arguments) -> tuple[Surcharges, Texts]:
    """Return surcharges as tuples (left and right x in m, pressures there in Pa), and mistakes in them.

    `arguments` are the arguments by path of the table, in SI units.
    """
    loads = []
    mistakes = []
    for k, load in enumerate(numbered_points(arguments, "surcharge"), 1):
        left = load.get("from")
        right = load.get("to")
        pressure = load.get("pressure")
        if left is None or right is None:
            continue  # it is missing, which is reported
        if not left < right:
            mistakes.append(f"surcharge.{k}.to_m = {right:g}: must lie to the right of from_m = {left:g}")
        elif pressure is not None:
            at_left, at_right = np.broadcast_to(pressure, 2).tolist()
            loads.append((left, right, at_left, at_right))
    return loads, mistakes


def profile(arguments: Arguments, keys: Rename, rate: Values | None, readable: bool) -> GroundProfile:
    """Return the layers of a file; if its tables are not `readable`, only mistakes across them.

    `arguments` are those of each table by path, `keys` maps names of arguments to keys of the file, and `rate` is the
    law of speed.
    """
    layers = numbered_points(arguments, "layers")
    slip = arguments.get("slip", {})
    of_soils = [path.removeprefix("soils.") for path in arguments if path.startswith("soils.")]
    names = [name for name in of_soils if not name.endswith((".friction", ".cohesion"))]
    places = {}
    for number, layer in enumerate(layers, 1):
        if layer.get("soil"):
            places[f"layers.{number}.soil"] = layer["soil"]
    if slip.get("foreland"):
        places["slip.foreland"] = slip["foreland"]
    mistakes = [*_unknown_soils(places, names), *_top_mistakes(layers)]
    soils, wrong = _soils(names if readable else [], arguments, keys)
    mistakes += wrong
    if mistakes or not readable:
        return GroundProfile([], None, "", None, mistakes, [])
    pairs = [(soils[layer["soil"]], layer.get("top")) for layer in layers]
    foreland = soils[slip["foreland"]] if "foreland" in slip else None
    strength = slip.get("strength", "base")
    of_slip = {"foreland": "slip.foreland", "strength": "slip.strength"}
    messages = InputError("", layer_mistakes(pairs, (), strength, foreland)).messages
    mistakes = [message.worded(lambda name: of_slip.get(name, keys(name))) for message in messages]
    remarks = [] if mistakes else list(_cut_off(arguments, pairs))
    return GroundProfile(pairs, foreland, strength, rate, mistakes, remarks)


def _soils(names: Texts, arguments: Arguments, keys: Rename) -> tuple[dict[str, Soil], Texts]:
    """Return the soils of a file by name, and the mistakes in them.

    `arguments` are the arguments by path of the table, and `keys` maps names of arguments to keys of the file.
    """
    soils = {}
    mistakes = []
    for name in names:
        try:
            soils[name] = _soil(name, arguments)
        except InputError as error:
            messages = [message.within(f"soils.{name}") for message in error.messages]
            mistakes += [message.worded(keys) for message in messages]
    return soils, mistakes


def _unknown_soils(places: TextMap, names: Texts) -> Iterator[str]:
    """Yield a message for each reference to an undefined soil and for each unused soil.

    `places` has the soil referred to by each key, and `names` are the defined soils.
    """
    meant = set()
    for path, soil in places.items():
        if soil not in names:
            near = get_close_matches(soil, names, 1)
            meant.update(near)
            advice = f"did you mean {near[0]}?" if near else f"known are {', '.join(names)}"
            yield f"{path} = {shown_value(soil)}: is not a soil of this file; {advice}"
    for name in names:
        if name not in places.values() and name not in meant:
            yield f"soils.{name}: is not used by any layer; assign it to a layer, or leave it out"


def idle_loads(loads: Surcharges, circle: Critical) -> Iterator[str]:
    """Yield a message for each surcharge that lies wholly or partly beside the ground or the sliding mass.

    Surcharges are tuples (left and right x in m, pressures there in Pa), and `circle` has the range of the mass.
    """
    ground = np.asarray(circle.slope.ground)[[0, -1], 0].tolist()
    for k, (left, right, _, _) in enumerate(loads, 1):
        for (first, last), what in ((ground, "ground"), (circle.between, "mass that slides")):
            if right <= first or left >= last:
                yield f"surcharge.{k}: lies beside the {what} (x = {first:.4g} to {last:.4g} m), and has no effect"
                break
            if what == "ground" and (left < first or right > last):
                yield f"surcharge.{k}: its part beside the {what} (x = {first:.4g} to {last:.4g} m) has no effect"


def _top_mistakes(layers: list[ValueDict]) -> Iterator[str]:
    """Yield a message if the first layer has a top, and for each other layer without one.

    Each layer has the arguments of its table.
    """
    if layers and "top" in layers[0]:
        yield "layers.1.top_m: must be left out, as the top of the first layer is the ground"
    for k, layer in enumerate(layers[1:], 2):
        if "top" not in layer:
            yield f"layers.{k}.top_m: is missing: a height (m), or a list of points"


def _soil(name: str, arguments: Arguments) -> Soil:
    """Return a soil of a file by its name, built from its tables.

    `arguments` are the arguments by path of the table, in SI units.
    """
    numbers = dict(arguments[f"soils.{name}"])
    friction = arguments.get(f"soils.{name}.friction", {"law": "constant", "coefficient": 0.0})
    is_constant = friction.get("law", "constant") == "constant"
    law = arguments.get(f"soils.{name}.cohesion")
    if law is not None:
        if "cohesion" in numbers:
            raise InputError("", ["{cohesion}: excludes a table of cohesion; remove one"])
        numbers["cohesion"] = law["cohesion"] if law.get("law", "constant") == "constant" else law
    return Soil(name=name, friction=friction["coefficient"] if is_constant else friction, **numbers)


def _cut_off(arguments: Arguments, layers: list[tuple[Soil, Any]]) -> Iterator[str]:
    """Yield a message for each layer whose top rises above the top of the previous layer.

    `arguments` are the arguments by path of the table, in SI units.
    """
    points = arguments.get("ground", {}).get("ground")
    ground = np.zeros((2, 2)) if points is None else np.asarray(points)
    left, right = ground[[0, -1], 0]
    lines = []
    for _, top in layers[1:]:
        lines.append(np.asarray(top if np.ndim(top) else [[left, top], [right, top]]))
    tolerance = 1e-9 * np.ptp(ground, axis=0).max()
    for k, (upper, lower) in enumerate(pairwise(lines), 3):
        x = np.unique(np.concatenate([upper[:, 0], lower[:, 0]]))
        excess = np.interp(x, *lower.T) - np.interp(x, *upper.T)
        highest = int(np.argmax(excess))
        if excess[highest] > tolerance:
            place = f"at x = {x[highest]:.6g}"
            yield f"layers.{k}.top_m: rises above the top of layer {k - 1}, {place}; the part above is cut off"
