"""Numbers of a scene as leaves of a tree, named by paths such as ``soils.clay.friction.peak`` and ``ground.3.y``.

The parts of a node are listed by name, each with its value and its declaration: a `Parameter` for a number or points,
the laws of friction or cohesion, the parameters of an effect, or None for nodes by name. Parameters of kind "number"
and "series" are stored in the node. Those of kind "lens" and "derived" follow from other parts, which `with_parts` of
the node changes. Those of kind "derived" and "set" are not listed as inputs. Values of kind "stored" only have lanes.
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import fields, replace
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np

from generated.effects import INFINITY, LAWS, Parameter
from slipcircle.base.checks import Bounds, InputError
from slipcircle.base.kinds import MAPPING, Shape, ValueDict, Values
from slipcircle.core.lazy import lazy_import

Parts = dict[str, tuple[Any, Any]]  # value and declaration by name
_LISTED = ("number", "series", "lens")
_POSSIBLE = (*_LISTED, "derived", "set")
_STORED = ("number", "series", "set", "stored")
STORED = Parameter("", kind="stored")
_DETERMINED = {"peak": "scale", "scale": "peak"}  # two factors of shaking, of which one is stored


class Leaf(NamedTuple):
    """Number of a tree: its path, its key in scene files, its declaration, and its value or None."""

    path: str
    key: str
    number: Parameter
    value: Any


def number(
    unit: str, lower: float = -INFINITY, upper: float = INFINITY, allowed: str = "", **more: Any
) -> dict[str, Parameter]:
    """Return the metadata of a dataclass field that is a number, with its SI unit and open bounds."""
    return {"number": Parameter("", unit, lower, upper, allowed=allowed, **more)}


@lru_cache
def declared(kind: Any) -> dict[str, Parameter]:
    """Return the numbers that the fields of a dataclass declare, by name. The name is also the key of one without."""
    found = {}
    for field in fields(kind):
        p = field.metadata.get("number")
        if p:
            key = p.key or field.name
            found[field.name] = replace(p, name=field.name, key=key)
    return found


@lru_cache
def bounds(kind: Any) -> dict[str, Bounds]:
    """Return the open bounds and the allowed values in words of the numbers of `declared`."""
    return {name: (one.lower, one.upper, one.allowed) for name, one in declared(kind).items()}


def parts_of_fields(node: Any) -> Parts:
    """Return the parts of a dataclass that its fields declare, laws in place of the number that they replace."""
    kind: Any = type(node)
    numbers = declared(kind)
    found: Parts = {}
    for field in fields(node):
        what = field.metadata.get("laws", numbers.get(field.name))
        if what:
            found[field.name] = getattr(node, field.name), what
    return found


def parts(node: Any, kind: Any = None) -> Parts:
    """Return the parts of a node by name, each with its value and its declaration."""
    if hasattr(type(node), "parts"):
        found: Parts = node.parts()
        return found
    if isinstance(kind, tuple):
        return _of_effect(node, kind)
    return {name: (one, None) for name, one in node.items()} if kind is None else _of_law(node, kind)


def _of_effect(given: Values, parameters: tuple[Parameter, ...]) -> Parts:
    """Return the parts of an effect, with scale and peak of shaking by a record, of which one determines the other."""
    found: Parts = {p.name: (given.get(p.name), p) for p in parameters}
    if callable(given.get("horizontal")):
        of_record = lazy_import("forcing").record_numbers(given)
        for name, value in of_record.items():
            _, p = found[name]
            kind = p.kind if name in given else "lens"
            found[name] = value, replace(p, kind=kind)
    return found


def _of_law(law: Any, laws: Mapping[str, Any]) -> Parts:
    """Return the parts of a law, or of a constant, which has no name of its own."""
    if law is None or callable(law):
        return {}
    if not isinstance(law, MAPPING):
        return {"": (law, *laws["constant"].parameters)}
    name = law["law"]
    found: Parts = {}
    for p in laws[name].parameters:
        of_constant = name == "constant"
        found["" if of_constant else p.name] = law[p.name], p
    if "rate" in law:
        found["rate"] = law["rate"], LAWS
    return found


def leaves(node: Any, kind: Any = None, path: str = "", key: str = "") -> Iterator[Leaf]:
    """Yield the numbers below a node, including those without a value."""
    for name, (value, what) in parts(node, kind).items():
        at = path
        if name or kind is None:
            at = _joined(path, name)
        if not isinstance(what, Parameter):
            yield from leaves(value, what, at, _joined(key, name))
        elif what.kind not in _POSSIBLE:
            continue
        elif not what.axes:
            inside = [one for one in (key, *name.split(".")[:-1]) if one]
            full = ".".join([*inside, what.key])
            known = None if callable(value) else value
            yield Leaf(at, full, what, known)
        elif value is not None:
            lanes: Any = np.asarray(value)
            own = lanes.shape[lanes.ndim - what.axes :]
            for place, index in _places(own).items():
                yield Leaf(f"{at}.{place}", f"{what.key}.{place}", what, lanes[(..., *index)])


def numbers(node: Any) -> ValueDict:
    """Return the values of the numbers below a node by path, without unlisted ones."""
    found: ValueDict = {}
    for path, _, p, value in leaves(node):
        if value is not None and p.kind in _LISTED:
            found[path] = value
    return found


def put(node: Any, values: Values, kind: Any = None) -> Any:
    """Return a node with other values of its numbers, by path. Nothing is checked."""
    known = parts(node, kind)
    below: dict[str, ValueDict] = {}
    for path, value in values.items():
        name = max((one for one in known if f"{path}.".startswith(f"{one}.")), key=len)  # names of soils may have dots
        below.setdefault(name, {})[path[len(name) + 1 :]] = value
    changed: ValueDict = {}
    for name, new in below.items():
        value, what = known[name]
        if not isinstance(what, Parameter):
            changed[name] = put(value, new, what)
        elif what.axes:
            changed[name] = _with_coordinates(value, what.axes, new)
        else:
            changed[name] = new[""]
    return _with_changes(node, known, changed)


def mapped(node: Any, change: Callable[[Any, int], Any], kind: Any = None) -> Any:
    """Return a node with every stored number changed by a function of the value and its number of axes."""
    if isinstance(kind, Parameter):
        if kind.kind == "stored" and isinstance(node, tuple):
            return tuple(mapped(one, change, kind) for one in node)
        return change(node, kind.axes) if kind.kind in _STORED else node
    known = parts(node, kind)
    changed: ValueDict = {}
    for name, (value, what) in known.items():
        if value is not None and not callable(value):
            changed[name] = mapped(value, change, what)
    return _with_changes(node, known, changed)


def _with_changes(node: Any, known: Parts, changed: ValueDict) -> Any:
    """Return a node with those parts replaced that have changed; the node itself without a change."""
    new = {name: value for name, value in changed.items() if value is not known[name][0]}
    if not new:
        return node
    if hasattr(node, "with_parts"):
        return node.with_parts(new)
    if hasattr(type(node), "parts"):
        return replace_unchecked(node, new)
    if not isinstance(node, MAPPING):  # a constant in place of a law
        return new[""]
    if new.keys() >= _DETERMINED.keys():
        both = " and ".join(f"{{shaking.{name}}}" for name in new if name in _DETERMINED)
        raise InputError("", [f"{both} exclude each other: one is the other times the record's peak; vary one"])
    kept = {name: value for name, value in node.items() if _DETERMINED.get(name) not in new}
    return kept | {name or known[""][1].name: value for name, value in new.items()}


def replace_unchecked(instance: Any, values: Values) -> Any:
    """Return a frozen dataclass with other field values, without the checks of its constructor."""
    if all(values[name] is getattr(instance, name) for name in values):
        return instance
    other = object.__new__(type(instance))
    for field in fields(instance):
        known = getattr(instance, field.name)
        value = values.get(field.name, known)
        object.__setattr__(other, field.name, value)
    if hasattr(other, "takes_geometry") and other.takes_geometry(instance):
        other.take_geometry(instance)
    return other


def _with_coordinates(points: Any, axes: int, new: Values) -> Any:
    """Return points in which coordinates, by their places, are replaced by numbers or by arrays over lanes."""
    points = np.asarray(points, float)
    own = points.shape[points.ndim - axes :]
    lanes = points.shape[: points.ndim - axes]
    shape = np.broadcast_shapes(lanes, *map(np.shape, new.values()))
    changed: Any = np.array(np.broadcast_to(points, (*shape, *own)))
    places = _places(own)
    for place, value in new.items():
        changed[(..., *places[place])] = value
    return changed


@lru_cache(maxsize=256)
def _places(shape: Shape) -> dict[str, Shape]:
    """Return the index of each coordinate in points of this shape by its place, such as ``3.y``."""
    places = {}
    for *point, axis in np.ndindex(shape):
        place = [*map(str, point), "xy"[axis]]
        places[".".join(place)] = (*point, axis)
    return places


def _joined(path: str, name: str) -> str:
    return f"{path}.{name}" if path else name
