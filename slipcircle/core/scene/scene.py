"""Scene: arc, friction, effects, initial velocity and end time."""

from __future__ import annotations  # so that a signature says ArrayLike

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any, Generic, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from generated.effects import EFFECTS, LAWS, LEAST, LIMITS, QUESTIONED_FRICTION
from slipcircle.base.arrays import EMPTY, INFINITY, Frozen, float_or_array, freeze
from slipcircle.base.errors import mistakes, one_number, raise_all, shape_mistakes
from slipcircle.base.kinds import MAPPING, Array, Effects, Function, Numbers, Parameters, Shape, Values, cached_property
from slipcircle.base.units import take_units
from slipcircle.core.lazy import lazy_import
from slipcircle.core.scene.arc import Arc
from slipcircle.core.scene.declarations import Parts, declared, number
from slipcircle.core.scene.effects import named, resolved
from slipcircle.core.scene.friction import law_parts
from slipcircle.core.scene.mass import Mass

One = float | str | Function | Mapping[str, float | str]  # parameter of a single scene
AS_ENTERED = 1.0  # strength factor
ACCURACY = one_number(0.0, 1.0, "a relative error between 0 and 1, such as 1e-9")
PLAIN = frozenset((float, str, type(None)))
_, _FASTEST = LIMITS["m/s"]
MAPS = {"uncertain": "from numbers to their distributions", "observed": "from outcomes to observed values"}


@dataclass(frozen=True)
class Scene(Generic[Numbers]):
    """Input of a simulation. Effects that are not named are not computed and cost nothing.

    If fields are arrays (including fields of the arc and parameters of effects and laws), the scene is an ensemble of
    their broadcast shape. Tables and given coefficients cannot vary within an ensemble.

    Parameters
    ----------
    arc : Arc or Section
        The failed section.
    friction : float or array_like, mapping, or callable
        Friction coefficient mu = tan(phi) (1.14), a law by name with its parameters, such as
        ``{"law": "exponential", "peak": 0.42, "residual": 0.18, "length": 2.0}`` with lengths in m, or a function of
        the accumulated slip in m. The function accepts and returns arrays, also for slips beyond the run-out.
        ``"rate": {...}`` in a law of slip multiplies it by a law of speed.
    effects : mapping or iterable of str, optional
        Effects by name, each with its parameters: ``{"centripetal": {}}``, or a list of names for effects without
        parameters. A function of time is a `Series` or `Pulse`, the name of a pulse, or a list with its times.
    initial_velocity : float or array_like, optional
        Velocity along the arc at the start, m/s, positive down-slope.
    end_time : float or array_like, optional
        End of the integration, s; by default until the mass rests.
    accuracy : float, optional
        Requested relative error of ensembles. The argument of `solve` takes precedence.
    name, note : str, optional
        Title of the scene, and the source of its numbers.
    uncertain : mapping, optional
        Distributions of numbers, which `ensemble` checks and samples and `solve` ignores. Keys are written as in scene
        files, ``"friction.angle_deg"`` or ``"circle.radius_m"``, or as SI names in ``numbers``, ``"friction"``. Values
        are frozen distributions of scipy.stats, or ``{"distribution": "normal", "mean": 10, "std": 1}``, in the unit
        of the key.
    observed : mapping, optional
        Observations for `backanalyse`, by ``"run_out"``, ``"end_displacement"`` (at the place of rest),
        ``"peak_velocity"``, ``"duration"`` or ``"toe_rise"``. Each is a number, a number with its standard error, or an
        `Interval`, in m, m/s or s. The motion does not depend on them.
    strength_factor : float or array_like, optional
        Factor of all friction and cohesion during the motion, so that it starts from the factor of safety of another
        method than the closure. Scene files with a ground set it from ``[circle] start``. Other scenes have 1.

    Notes
    -----
    For type checkers ``Scene[float]`` is a single scene, whose solution is a ``Motion[float]``, and ``Scene[Array]`` an
    ensemble. ``scene: Scene = load("vaiont")`` may be either, so that ``replace`` may insert arrays.

    Raises
    ------
    ValueError
        If the input is invalid. The message lists every mistake with field, value and allowed values.
    """

    arc: Arc[Numbers] | Any
    friction: Numbers | float | Mapping[str, Numbers | One | Sequence[float]] | Function | None = field(
        default=None, metadata={"laws": LAWS}
    )
    effects: Mapping[str, Mapping[str, Numbers | One | Sequence[float]]] | Iterable[str] = field(default_factory=dict)
    initial_velocity: Numbers | float = field(
        default=0.0,
        metadata=number(
            "m/s",
            -_FASTEST,
            _FASTEST,
            "a velocity in m/s",
            help="velocity along the arc at the start, positive down-slope, by default 0",
            key="initial_velocity_m_s",
            optional=True,
        ),
    )
    end_time: Numbers | float | None = field(
        default=None,
        metadata=number(
            "s",
            *LIMITS["s"],
            "a positive time in s, or None to run until the mass rests",
            help="end time, by default when the mass rests",
            key="end_time_s",
            optional=True,
        ),
    )
    accuracy: float | None = None
    name: str = ""
    note: str = ""
    uncertain: Values = field(default_factory=lambda: EMPTY)
    observed: Values = field(default_factory=lambda: EMPTY)
    strength_factor: Numbers | float = field(default=AS_ENTERED, metadata=number("", *LIMITS[""], "a positive number"))

    if TYPE_CHECKING:  # numbers alone are a single scene, an array an ensemble, and other mappings may be either

        @overload
        def __init__(
            self: Scene[float],
            arc: Arc[float],
            friction: float | Mapping[str, One] | Function,
            effects: Mapping[str, Mapping[str, One]] | Iterable[str] = ...,
            initial_velocity: float = ...,
            end_time: float | None = None,
            accuracy: float | None = None,
            name: str = ...,
            note: str = ...,
            uncertain: Values = ...,
            observed: Values = ...,
            strength_factor: float = ...,
        ) -> None: ...
        @overload
        def __init__(
            self: Scene[Array], arc: Mass, friction: NDArray[Any] | Sequence[float], *more: Any, **named: Any
        ) -> None: ...
        @overload
        def __init__(self: Scene[Array], arc: Arc[Array], *more: Any, **named: Any) -> None: ...
        @overload
        def __init__(
            self: Scene[Any],
            arc: Mass,
            friction: float | Parameters | Function | None = None,
            effects: Effects | Iterable[str] = ...,
            initial_velocity: ArrayLike = ...,
            end_time: ArrayLike | None = None,
            accuracy: float | None = None,
            name: str = ...,
            note: str = ...,
            uncertain: Values = ...,
            observed: Values = ...,
            strength_factor: ArrayLike = ...,
        ) -> None: ...
        def __init__(self, *given: Any, **named: Any) -> None: ...

    def __post_init__(self) -> None:
        """Check mass, friction, effects and times, convert their units and freeze them."""
        take_units(self, ("effects", "friction", *_NUMBERS))
        effects, faults = named(self.effects)
        object.__setattr__(self, "effects", effects)
        mass: Any = self.arc
        is_mass = hasattr(type(mass), "moment_coefficients")
        own_friction = None
        if is_mass:
            faults += mass.mistakes(self.friction, effects)
            own_friction = mass.friction
        else:
            faults.append(f"arc = {mass!r}: must be an Arc or a Section")
        faults += self._field_faults()
        if own_friction is None:
            if type(self.friction) is not float or not 0.0 <= self.friction < INFINITY:
                faults += lazy_import("laws").law_mistakes(self.friction)
                freeze(self, ("friction",))
        else:
            object.__setattr__(self, "friction", own_friction)
        for name, parameters in effects.items():
            effects[name], messages = resolved(name, parameters)
            faults += messages
        object.__setattr__(self, "effects", Frozen(effects))
        if not faults:
            shape = self._simple_shape
            if shape != ():
                freeze(self, _NUMBERS)
            if shape is None:
                faults += shape_mistakes(self.numbers)
            else:
                vars(self)["shape"] = shape
        if faults:
            raise_all(f"Scene {self.name}".rstrip(), faults)
        if self._is_unusual:
            lazy_import("plausible").warn(self)

    @property
    def _is_unusual(self) -> bool:
        """Whether a strength or weight is outside the usual range, by a quick check."""
        arc: Any = self.arc
        if arc.friction is not None:
            return any(map(_is_unusual, lazy_import("tree").numbers(arc).items()))
        friction: Any = self.friction
        weight = arc.unit_weight
        effects: Any = self.effects
        is_plain = type(friction) is float and type(weight) is float
        if is_plain and friction <= _MOST and weight >= _OF_WEIGHT and "cohesion" not in effects:
            return False
        law = friction.items() if isinstance(friction, dict) else (("friction", friction),)
        cohesion = effects.get("cohesion", EMPTY).items()
        return any(map(_is_unusual, (*law, *cohesion, ("unit_weight", weight))))

    def start_anew(self) -> None:
        """Update attributes derived from fields that have changed; a scene of this class has no such attributes."""

    def _field_faults(self) -> list[str]:
        """Return messages about the fields of the start, the end, and the requested accuracy."""
        fields = vars(self)
        limits = _SIGNS if self.end_time is not None else _SIGNS_OF_START
        faults = mistakes(fields, limits)
        faults += accuracy_mistakes(self.accuracy)
        for name, which in MAPS.items():
            value = fields[name]
            if value is EMPTY:
                continue
            freeze(self, (name,))
            if not isinstance(value, MAPPING):
                faults.append(f"{name} = {value!r}: must be a mapping {which}")
        return faults

    @property
    def checked_effects(self) -> dict[str, Parameters]:
        """Effects of the scene by name, each with its parameters by name, after checks."""
        effects: dict[str, Parameters] = self.effects  # type: ignore[assignment]
        return effects

    @cached_property
    def law(self) -> Any:
        """Friction of the scene, or of the soils of its mass, as a number, a law with parameters, or a function."""
        return self.friction if self.arc.friction is None else self.arc.friction

    @cached_property
    def laws(self) -> Effects:
        """Laws of friction by name, whose product is the friction, and laws of cohesion, each with its parameters."""
        effects: Any = self.effects
        return dict((*law_parts(self.law), *self.arc.cohesion_laws(effects.get("cohesion", EMPTY))))

    @property
    def until(self) -> Any:
        """Latest end, s; infinite without an end time."""
        return INFINITY if self.end_time is None else float_or_array(self.end_time)

    @cached_property
    def called(self) -> Effects:
        """Effects by name with their parameters, including effects that the mass adds, such as its water level."""
        effects: Any = self.effects
        return self.arc.effects_with_own(effects)

    def by_start(self, quantity: str, motion: Any, kept: float = 1.0) -> Any:
        """Return a result by the starting method and the name of the method, or None if the closure applies.

        ``quantity`` is the name of the result, such as "factor_of_safety", and ``kept`` is the remaining share of
        cohesion. Only scenes of a subclass have a starting method.
        """

    @cached_property
    def numbers(self) -> Mapping[str, ArrayLike]:
        """Numbers that may be arrays, by name: ``radius``, ``ground.3.y``, ``friction.peak``, ..."""
        by_path: Mapping[str, ArrayLike] = lazy_import("tree").numbers(self)
        return by_path

    def parts(self) -> Parts:
        """Return the parts of the mass, the friction, the start and end, and the effects, each with its declaration."""
        tree = lazy_import("tree")
        by_name: Parts = self.arc.parts() | tree.parts_of_fields(self)
        if self.arc.friction is not None:  # its soils have the numbers of friction
            del by_name["friction"]
        if type(self.strength_factor) is float and self.strength_factor == AS_ENTERED:
            by_name["strength_factor"] = None, declared(Scene)["strength_factor"]
        effects = self.checked_effects
        for name in (*effects, *EFFECTS):
            if name not in self.arc.own_effects:
                one = effects.get(name, EMPTY)
                by_name[name] = one, tree.declared_parameters(name, one)
        return by_name

    def with_parts(self, changed: Values) -> Any:
        """Return the scene with other parts, by the names in `parts`. Nothing is checked."""
        of_mass = {name: changed[name] for name in self.arc.parts() if name in changed}
        effects = {name: changed[name] for name in EFFECTS if name in changed}
        fields = {name: value for name, value in changed.items() if name not in of_mass | effects}
        if of_mass:
            fields["arc"] = self.arc.with_parts(of_mass)
        if effects:
            fields["effects"] = {**self.checked_effects, **effects}
        return lazy_import("tree").replace_unchecked(self, fields)

    @property
    def _simple_shape(self) -> Shape | None:
        """Shape of a scene in which only the friction coefficient and the start may be arrays, otherwise None.

        It does not need `numbers`, which takes a third of the time of a small ensemble.
        """
        friction = self.friction
        values: list[Any] = [self.initial_velocity, self.end_time, self.strength_factor]
        others: list[Any] = []
        if isinstance(friction, dict):
            others += friction.values()
        else:
            values.append(friction)
        for parameters in self.checked_effects.values():
            others += parameters.values()
        if not (self.arc.has_plain_numbers and PLAIN.issuperset(map(type, others))):
            return None
        arrays = [value for value in values if type(value) not in PLAIN]
        shapes = [array.shape for array in arrays if type(array) is np.ndarray and array.shape]
        if len(shapes) < len(arrays) or len(set(shapes)) > 1:
            return None
        return shapes[0] if shapes else ()

    @cached_property
    def shape(self) -> Shape:
        """Broadcast shape of all fields, including fields of the mass and parameters, () for a single scene."""
        simple = self._simple_shape
        if simple is not None:
            return simple
        return np.broadcast_shapes(*map(np.shape, self.numbers.values()))


_MOST, _OF_WEIGHT, _OF_STRENGTH = QUESTIONED_FRICTION, LEAST["N/m^3"], LEAST["Pa"]


def _is_unusual(number: tuple[str, Any]) -> bool:
    """Return whether a named value is an unusual friction, cohesion or unit weight.

    ``number`` is a pair of name and value in SI units; the last part of the name determines the check.
    """
    name, value = number
    if not isinstance(value, int | float):
        return False
    match name.rpartition(".")[2]:
        case "friction" | "peak" | "residual":
            return value > _MOST
        case "cohesion":
            return 0.0 < value < _OF_STRENGTH
        case "unit_weight":
            return value < _OF_WEIGHT
    return False


_NUMBERS = ("initial_velocity", "strength_factor", "end_time")
_SIGNS = {}  # declarations of a scene in Python, which may have any number of the right sign
for _name in _NUMBERS:
    _p = declared(Scene)[_name]
    _least = 0.0 if _p.lower > 0.0 else -INFINITY
    _SIGNS[_name] = replace(_p, lower=_least, upper=INFINITY)
_SIGNS_OF_START = {name: _SIGNS[name] for name in _NUMBERS[:2]}


def accuracy_mistakes(accuracy: Any) -> list[str]:
    """Return a message if the accuracy is neither None nor a relative error between 0 and 1."""
    if accuracy is None:
        return []
    return mistakes({"accuracy": accuracy}, {"accuracy": ACCURACY})


def checked_scene(scene: Any, what: str) -> Scene:
    """Return the argument if it is a scene, and otherwise raise an error.

    ``what`` names the operation in the message.
    """
    if not isinstance(scene, Scene):
        call = f"load({scene!r})" if isinstance(scene, str) else "load(name)"
        raise ValueError(f"{what}: scene = {scene!r}: must be a Scene; {call} gives that of a file, or one that ships")
    return scene
