"""Numbers of a scene as leaves of a tree, named by paths such as ``soils.clay.friction.peak`` and ``ground.3.y``.

The parts of a node are listed by name, each with its value and its declaration: a `Parameter` for a number or points,
the laws of friction or cohesion, the parameters of an effect, or None for nodes by name. Parameters of kind "number"
and "series" are stored in the node. Those of kind "lens" and "derived" follow from other parts, which `with_parts` of
the node changes. Those of kind "derived" and "set" are not listed as inputs. Values of kind "stored" only have lanes.
"""

from collections.abc import Callable, Mapping
from dataclasses import fields, replace
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np

from generated.effects import COHESION_LAWS, EFFECTS, LAWS, Parameter
from slipcircle.base.arrays import EMPTY
from slipcircle.base.errors import raise_all
from slipcircle.base.inputerror import InputError
from slipcircle.base.kinds import MAPPING, Parameters, Shape, ValueDict, Values
from slipcircle.core.lazy import lazy_import
from slipcircle.core.scene.declarations import Parts, declared
from slipcircle.core.scene.effects import OF_GROWTH

__all__ = ["Leaf", "leaves", "mapped", "numbers", "parts_of_fields", "path_of_part", "put", "replace_unchecked"]
_LISTED = ("number", "series", "lens")
_POSSIBLE = (*_LISTED, "derived", "set")
_STORED = ("number", "series", "set", "stored")
_DETERMINED = {"peak": "scale", "scale": "peak"}  # two factors of shaking, of which one is stored


class Leaf(NamedTuple):
    """Number of a tree: its path, its key in scene files, its declaration, and its value or None."""

    path: str
    key: str
    number: Parameter
    value: Any


def parts_of_fields(node: Any) -> Parts:
    """Return the parts of a dataclass that its fields declare: value and declaration by the name of the field.

    A field that may contain laws is declared by the known laws instead of a number.
    """
    kind: Any = type(node)
    by_field: Parts = {}
    for name, what in _declared_fields(kind).items():
        by_field[name] = getattr(node, name), what
    return by_field


@lru_cache
def _declared_fields(kind: Any) -> ValueDict:
    """Return the declarations of the fields of a dataclass that are numbers or laws, by the name of the field."""
    numbers = declared(kind)
    declarations: ValueDict = {}
    for field in fields(kind):
        what = field.metadata.get("laws", numbers.get(field.name))
        if what:
            declarations[field.name] = what
    return declarations


def declared_parameters(name: str, parameters: Parameters) -> tuple[Parameter, ...]:
    """Return the declarations of the parameters that an effect may have.

    For cohesion they depend on its law, which ``parameters``, its parameters by name, contains.
    """
    if name != "cohesion" or "law" not in parameters:
        return EFFECTS[name].parameters
    law = COHESION_LAWS.get(parameters["law"])
    if law is None:
        return ()
    return (*law.parameters, *OF_GROWTH)


def parts(node: Any, kind: Any = None) -> Parts:
    """Return the parts of a node by name, each with its value and its declaration.

    ``kind`` is the declaration of the node itself, None for an object or a mapping of nodes.
    """
    if hasattr(type(node), "parts"):
        of_node: Parts = node.parts()
        return of_node
    if kind is None:
        return {name: (one, None) for name, one in node.items()}
    if node is None:
        return {}
    if isinstance(kind, Parameter):
        return _of_points(node, kind)
    if isinstance(kind, tuple):
        return _of_effect(node, kind)
    return _of_law(node, kind)


def _of_points(points: Any, p: Parameter) -> Parts:
    """Return the coordinates of points by place, such as ``3.y``, each with its declaration.

    ``points`` have axes of lanes first, and ``p`` declares them.
    """
    lanes: Any = np.asarray(points)
    declarations = [replace(p, axes=0, key=axis) for axis in "xy"]
    coordinates: Parts = {}
    shape_of_points = lanes.shape[lanes.ndim - p.axes :]
    for place, index in _places(shape_of_points).items():
        *_, axis = index
        coordinates[place] = lanes[(..., *index)], declarations[axis]
    return coordinates


def _of_effect(values: Values, parameters: tuple[Parameter, ...]) -> Parts:
    """Return the parts of an effect from its values by name and the declarations of its parameters.

    For shaking by a record they contain both scale and peak, of which one determines the other.
    """
    by_name: Parts = {p.name: (values.get(p.name), p) for p in parameters}
    if callable(values.get("horizontal")):
        of_record = lazy_import("forcing").record_numbers(values)
        for name, value in of_record.items():
            _, p = by_name[name]
            kind = p.kind if name in values else "lens"
            by_name[name] = value, replace(p, kind=kind)
    return by_name


def _of_law(law: Any, laws: Mapping[str, Any]) -> Parts:
    """Return the parts of a law, or of a constant, whose only part has the name "".

    ``laws`` are the known laws by name.
    """
    if callable(law):
        return {}
    if not isinstance(law, MAPPING):
        return {"": (law, *laws["constant"].parameters)}
    name = law["law"]
    by_name: Parts = {}
    for p in laws[name].parameters:
        of_constant = name == "constant"
        by_name["" if of_constant else p.name] = law[p.name], p
    if "rate" in law:
        by_name["rate"] = law["rate"], LAWS
    return by_name


def walked(
    node: Any, visit: Callable[[Leaf], Any], absent: bool = True, kind: Any = None, path: str = "", key: str = ""
) -> Any:
    """Return a node whose leaves have the values that a function returns; the node itself if none has changed.

    Unless ``absent``, numbers and effects without a value are not visited. ``kind``, ``path`` and ``key`` are the
    declaration, the path and the key in scene files of the node itself.
    """
    every_part = parts(node, kind)
    new: ValueDict = {}
    for name, (value, what) in every_part.items():
        if not absent and (value is None or value is EMPTY):
            continue
        is_anonymous = not name and kind is not None
        at = path if is_anonymous else path_of_part(path, name)
        is_declared = isinstance(what, Parameter)
        inside = _key_of_number(key, name, what.key) if is_declared else path_of_part(key, name)
        if is_declared and not what.axes:
            changed = visit(Leaf(at, inside, what, value))
        else:
            changed = walked(value, visit, absent, what, at, inside)
        if changed is not value:
            new[name] = changed
    return _with_parts(node, new, every_part) if new else node


@lru_cache(maxsize=2048)
def _key_of_number(key: str, name: str, own: str) -> str:
    """Return the key of a number in scene files.

    ``key`` is the key of its node, ``name`` may contain names of further nodes, and ``own`` is its last part.
    """
    *within, _ = name.split(".")
    parts_of_key = filter(None, (key, *within, own))
    return ".".join(parts_of_key)


def leaves(node: Any, absent: bool = True) -> list[Leaf]:
    """Return the numbers below a node, with each coordinate of points; if ``absent``, also numbers without a value."""
    visited: list[Leaf] = []

    def visit(leaf: Leaf) -> Any:
        if leaf.number.kind in _POSSIBLE:
            visited.append(leaf._replace(value=None) if callable(leaf.value) else leaf)
        return leaf.value

    walked(node, visit, absent)
    return visited


def numbers(node: Any) -> ValueDict:
    """Return the values of the numbers below a node by path, such as ``friction.peak``.

    Kinds that are not inputs are left out.
    """
    by_path: ValueDict = {}
    for path, _, p, value in leaves(node, absent=False):
        if value is not None and p.kind in _LISTED:
            by_path[path] = value
    return by_path


def put(node: Any, values: Values) -> Any:
    """Return a node with other values of its numbers, by path such as ``friction.peak``. Values are not checked."""
    remaining = dict(values)
    changed = walked(node, lambda leaf: remaining.pop(leaf.path, leaf.value))
    unknown = [f"{path}: is not a number of this scene" for path in remaining]
    raise_all("", unknown)
    return changed


def mapped(node: Any, change: Callable[[Any], Any]) -> Any:
    """Return a node in which every stored number, also within points, is replaced by the value of a function of it."""

    def visit(leaf: Leaf) -> Any:
        value = leaf.value
        if callable(value) or leaf.number.kind not in _STORED:
            return value
        return change(value)

    return walked(node, visit, absent=False)


def _with_parts(node: Any, new: Values, every_part: Parts) -> Any:
    """Return a node with other parts.

    ``new`` contains the changed parts by name, and ``every_part`` all parts of the node.
    """
    if hasattr(node, "with_parts"):
        return node.with_parts(new)
    if hasattr(type(node), "parts"):
        return replace_unchecked(node, new)
    if not isinstance(node, MAPPING):
        if "" in new:  # a constant in place of a law
            return new[""]
        points = np.asarray(node, float)
        is_whole = len(new) == len(every_part)
        return _with_coordinates(points, new, is_whole)
    if new.keys() >= _DETERMINED.keys():
        both = " and ".join(f"{{shaking.{name}}}" for name in new if name in _DETERMINED)
        raise InputError("", [f"{both} exclude each other: one is the other times the record's peak; vary one"])
    kept = {name: value for name, value in node.items() if _DETERMINED.get(name) not in new}
    _, anonymous = every_part.get("", (None, None))
    own_name = getattr(anonymous, "name", "")  # of the constant in a law; a soil may have no name
    replaced = {name or own_name: value for name, value in new.items()}
    return kept | replaced


def replace_unchecked(instance: Any, values: Values) -> Any:
    """Return a frozen dataclass with other field values, without the checks of its constructor."""
    if all(values[name] is getattr(instance, name) for name in values):
        return instance
    other = object.__new__(type(instance))
    for field in fields(instance):
        present = getattr(instance, field.name)
        value = values.get(field.name, present)
        object.__setattr__(other, field.name, value)
    if hasattr(other, "takes_geometry") and other.takes_geometry(instance):
        other.take_geometry(instance)
    return other


def _with_coordinates(points: Any, new: Values, whole: bool) -> Any:
    """Return points with other coordinates, numbers or arrays over lanes, by places such as ``3.y``.

    ``whole`` is true if all coordinates change.
    """
    axes = 1 + max(place.count(".") for place in new)
    shape_of_points = points.shape[points.ndim - axes :]
    lanes = () if whole else points.shape[: points.ndim - axes]
    shape = np.broadcast_shapes(lanes, *map(np.shape, new.values()))
    changed: Any = np.empty((*shape, *shape_of_points))
    if not whole:
        changed[...] = points
    for place, value in new.items():
        index = _places(shape_of_points)[place]
        changed[(..., *index)] = value
    return changed


@lru_cache(maxsize=256)
def _places(shape: Shape) -> dict[str, Shape]:
    """Return the index of each coordinate by its place, such as ``3.y``, in points of this shape, (V, 2) or (2,)."""
    places = {}
    for *point, axis in np.ndindex(shape):
        place = [*map(str, point), "xy"[axis]]
        places[".".join(place)] = (*point, axis)
    return places


def path_of_part(path: str, name: str) -> str:
    """Return the path of a part of a node, or of a key or a table inside a table, such as "friction.peak"."""
    return f"{path}.{name}" if path else name
