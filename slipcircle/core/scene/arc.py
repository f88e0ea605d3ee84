"""Circular arc with the mass between arc and chord."""

from __future__ import annotations  # so that a signature says ArrayLike

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import partial
from typing import TYPE_CHECKING, Any, Generic, overload

import numpy as np
from numpy.typing import ArrayLike

from generated import kernels
from generated.effects import Parameter
from slipcircle.base.arrays import FLOATS, choose, float_or_array, freeze, two_sum
from slipcircle.base.errors import Fault, complaint, mistakes, raise_all, shape_mistakes
from slipcircle.base.kinds import Array, Numbers, Values, cached_property
from slipcircle.base.units import take_units
from slipcircle.core.lazy import lazy_import, lazy_message
from slipcircle.core.scene.declarations import Parts, declared, number
from slipcircle.core.scene.mass import Mass, MomentCoefficients

if TYPE_CHECKING:
    from slipcircle.core.scene.dimensionless import Dimensionless

GRAVITY = 9.81  # default
WIDTH = 1.0
DIP = Parameter("dip", "rad", -5e-324, np.pi / 2, "dip of the chord", "arc.dip_deg", np.pi / 180, kind="derived")
_ANGLE = partial(number, "rad", -1e3, 1e3, "a finite angle in rad", per_unit=np.pi / 180)


@dataclass(frozen=True)
class Arc(Mass, Generic[Numbers]):
    """Circular slip surface with the mass above it, closed by its chord.

    Parameters
    ----------
    radius : float or array_like
        Radius of the arc, R, m.
    theta_1, theta_2 : float or array_like
        Polar angles of the arc's ends about its centre, rad, counterclockwise from the horizontal (x axis). The
        angle 3 pi/2 is straight below the centre.
    unit_weight : float or array_like
        Unit weight of the soil, N/m^3.
    gravity : float or array_like, optional
        Acceleration of gravity, m/s^2.
    width : float or array_like, optional
        Length perpendicular to the section, m.
    given : mapping, optional
        Dimensionless coefficients that replace the computed ones, to repeat a calculation from a printed table. All
        names of `slipcircle.tabulated.GIVEN` are required. They are valid in the initial position only.

    Raises
    ------
    ValueError
        If values are out of bounds, theta_2 <= theta_1, the opening exceeds 180 degrees, or the weight of the mass has
        no component towards the arc. The message lists all mistakes.

    Notes
    -----
    Symbols and equation numbers are the paper's. Fields may be arrays; results have their broadcast shape. The slope
    may face either way. Dip, J_theta and its quotients, motions, velocities and shaking are positive down-slope. Only
    J_theta in ``given`` has the sign of the angles, which determines the facing.
    """

    radius: Numbers | float = field(
        metadata=number("m", 1e-6, 1e20, "a positive length in m", help="radius of the slip circle", key="arc.radius_m")
    )
    theta_1: Numbers | float = field(
        metadata=_ANGLE(help="polar angle of the arc's first end; 270 is below the centre", key="arc.theta_1_deg")
    )
    theta_2: Numbers | float = field(
        metadata=_ANGLE(help="polar angle of the arc's second end, above the first", key="arc.theta_2_deg")
    )
    unit_weight: Numbers | float = field(
        metadata=number(  # 1000 kN/m^3 exceeds gold
            "N/m^3",
            1e-3,
            1e6,
            "a positive unit weight in N/m^3",
            help="unit weight",
            key="arc.unit_weight_kN_m3",
            per_unit=1e3,
        )
    )
    gravity: Numbers | float = field(
        default=GRAVITY,
        metadata=number(
            "m/s^2",
            1e-6,
            1e6,
            "a positive acceleration in m/s^2",
            help=f"gravity, by default {GRAVITY}",
            key="arc.gravity_m_s2",
            optional=True,
        ),
    )
    width: Numbers | float = field(
        default=WIDTH,
        metadata=number(
            "m",
            1e-6,
            1e9,
            "a positive length in m",
            help=f"length across the section, by default {WIDTH}",
            key="arc.width_m",
            optional=True,
        ),
    )
    given: Mapping[str, float] | None = None
    centre = (0.0, 0.0)  # origin of coordinates

    if TYPE_CHECKING:  # one array makes an ensemble

        @overload
        def __init__(
            self: Arc[float],
            radius: float,
            theta_1: float,
            theta_2: float,
            unit_weight: float,
            gravity: float = ...,
            width: float = ...,
            given: Mapping[str, float] | None = None,
        ) -> None: ...
        @overload
        def __init__(
            self: Arc[Array],
            radius: ArrayLike,
            theta_1: ArrayLike,
            theta_2: ArrayLike,
            unit_weight: ArrayLike,
            gravity: ArrayLike = ...,
            width: ArrayLike = ...,
            given: Mapping[str, float] | None = None,
        ) -> None: ...
        def __init__(self, *given: Any, **named: Any) -> None: ...

    def __post_init__(self) -> None:
        """Check the numbers and convert their units, or become a `GivenArc` if coefficients are tabulated."""
        if self.given is not None and type(self) is Arc:  # it is another mass
            object.__setattr__(self, "__class__", lazy_import("tabulated").GivenArc)
            self.__post_init__()
            return
        if not self.has_plain_numbers:
            take_units(self, self.quantities)
        raise_all("Arc", self._mistakes())
        if not self.has_plain_numbers:
            freeze(self, self.quantities)
            vars(self).pop("has_plain_numbers")  # NumPy's numbers have become floats

    def _mistakes(self) -> list[str]:
        """Return messages about the fields: numbers out of bounds, shapes that do not broadcast, impossible arcs."""
        values = {name: getattr(self, name) for name in self.quantities}
        kind: Any = type(self)
        messages = mistakes(values, declared(kind)) or shape_mistakes(values)
        if not messages and not self._is_plain_arc:
            angles = np.broadcast(self.theta_1, self.theta_2)
            messages = complaint(self.geometry_errors(), angles.shape)
        return messages

    @property
    def _is_plain_arc(self) -> bool:
        """Whether the ends are two floats of a valid arc with normal load, so that `geometry_errors` is not needed."""
        first: Any = self.theta_1
        last: Any = self.theta_2
        if not FLOATS.issuperset((type(first), type(last))):
            return False
        if not 0.0 < last - first <= np.pi:
            return False
        return bool(self._radial_amplitude * self._cosine_of_dip > 0.0)

    def parts(self) -> Parts:
        """Return the numbers of the fields by name, and the dip, which turns both ends."""
        return super().parts() | {"dip": (self.dip, DIP)}

    def with_parts(self, changed: Values) -> Any:
        """Return the arc with other values of some numbers, by name.

        Another ``dip`` turns both ends. Nothing is checked.
        """
        fields = dict(changed)
        if "dip" in fields:
            turn = self.facing * (self.dip - fields.pop("dip"))
            fields |= {end: np.asarray(getattr(self, end)) + turn for end in ("theta_1", "theta_2")}
        return super().with_parts(fields)

    def geometry_errors(self) -> Iterator[Fault]:
        """Yield the errors of invalid arcs and of arcs without a normal load.

        An error is a mask of lanes (cases of an ensemble) and a function from the index of a lane to its message.
        """
        with np.errstate(invalid="ignore"):  # J_r/Theta* is NaN beyond a half disc, and for ends that are NaN
            normal_load = np.ravel(self._radial_amplitude * self._cosine_of_dip)
        faults = {
            "swapped": np.ravel(np.less_equal(self.theta_2, self.theta_1)),
            "too_wide": np.isnan(normal_load),
            "without_load": normal_load <= 0.0,
        }
        for fault, lanes in faults.items():
            yield lanes, lazy_message("arc", fault, self)

    @cached_property
    def half_angle(self) -> Any:
        """Half the opening angle (1.1), alpha, rad."""
        return np.subtract(self.theta_2, self.theta_1) / 2

    @cached_property
    def dip(self) -> Any:
        """Dip of the chord, psi, rad, positive down-slope."""
        return self.facing * self._lean

    @cached_property
    def _lean(self) -> Any:
        """Dip in the sense of the angles, rad, negative where the chord falls to the left."""
        middle = np.add(self.theta_1, self.theta_2) / 2
        return 1.5 * np.pi - middle

    @cached_property
    def facing(self) -> Any:
        """1 if gravity turns the mass counterclockwise, to the right; -1 if it turns it to the left."""
        return choose(np.less(self._lean, 0.0), -1.0, 1.0)

    @cached_property
    def dimensionless(self) -> Dimensionless:
        """Dimensionless coefficients of the equation of motion at the start, each a number or an array."""
        coefficients: Dimensionless = lazy_import("dimensionless").of_arc(self)
        return coefficients

    @cached_property
    def _quotients(self) -> tuple[Any, Any, Any]:
        """Limit friction J_theta/J_r, static normal stress J_r/lambda and polar moment I_p*/Theta*.

        They follow from reduced functions, so that thin arcs do not underflow.
        """
        polar_per_inertia = kernels.polar_moment_per_inertia(self.half_angle)
        # J_r/lambda = (J_r/Theta*) (A Theta*/I_p*), by lambda A = I_p*
        static = self.normal_load * kernels.dynamic_coefficient(self.half_angle) / polar_per_inertia
        sine, cosine = self._middle
        ratio = kernels.weight_moment_per_radial_weight(self.half_angle)
        limit_friction = self.facing * (cosine / sine * ratio)  # (3.21): tan(psi) C_theta/C_r
        return limit_friction, static, polar_per_inertia

    @cached_property
    def amplitudes_per_inertia(self) -> tuple[Any, Any]:
        """Amplitudes of the moment and the normal load of the weight, C_theta/Theta* and C_r/Theta*.

        At the dip psi, J_theta is C_theta sin(psi) and J_r is C_r cos(psi), all dimensionless.
        """
        return kernels.weight_moment_per_inertia(self.half_angle), self._radial_amplitude

    @cached_property
    def _radial_amplitude(self) -> Any:
        """Amplitude of the normal load J_r/Theta* with the dip, C_r/Theta*; NaN beyond a half disc."""
        return kernels.radial_weight_per_inertia(self.half_angle)

    @cached_property
    def moment_coefficients(self) -> MomentCoefficients:
        """Coefficients of the balance of moments. r_u is relative to the static normal stress."""
        weight, radial = self.amplitudes_per_inertia
        press = self.normal_load
        limit, static_normal_stress, polar_per_inertia = self._quotients
        coefficients = (
            limit * press,
            weight * (press / radial),
            press,
            -radial * (limit * press / weight),
            press / static_normal_stress,
            polar_per_inertia,
            limit,
            1.0,
        )
        return MomentCoefficients(*map(float_or_array, coefficients))

    @cached_property
    def normal_load(self) -> Any:
        """Radial weight over moment of inertia at the start, J_r/Theta*, both dimensionless; a number or an array."""
        return self.amplitudes_per_inertia[1] * self._cosine_of_dip

    @cached_property
    def _middle(self) -> tuple[Any, Any]:
        """Sine and cosine of theta_m, the mean of both angles, including its rounding, which matters for steep dips."""
        total, lost = two_sum(float_or_array(self.theta_1), float_or_array(self.theta_2))
        middle = total / 2
        rounding = lost / 2
        sine = np.sin(middle)
        cosine = np.cos(middle)
        return sine + cosine * rounding, cosine - sine * rounding

    @property
    def _cosine_of_dip(self) -> Any:
        """Cosine of the dip, cos(psi) = -sin(theta_m), where theta_m is the mean of both angles."""
        return -self._middle[0]

    @cached_property
    def polar_moment(self) -> Any:
        """Polar surface moment of inertia (2.16), I_p, m^3."""
        d = self.dimensionless
        dimensionless = d.resistance_factor * d.dynamic_coefficient
        return np.power(self.radius, 3.0) * dimensionless

    @cached_property
    def moment_of_inertia(self) -> Any:
        """Mass moment of inertia about the centre (3.1), Theta, kg m^2."""
        density = np.divide(self.unit_weight, self.gravity)
        scale = np.multiply(self.width, density) * np.power(self.radius, 4.0)
        return scale * self.dimensionless.moment_of_inertia

    @cached_property
    def weight_moment(self) -> Any:
        """Moment of the weight about the centre (3.7), N m."""
        scale = np.multiply(self.width, self.unit_weight) * np.power(self.radius, 3.0)
        return scale * self.dimensionless.weight_moment

    @cached_property
    def depth(self) -> Any:
        """Greatest depth of the mass below its chord (2.12), f, m."""
        return self.sagitta

    @cached_property
    def exit(self) -> Any:
        """Lower end of the slip surface relative to the centre, x and y in m, (..., 2)."""
        return self._end(self.theta_2, self.theta_1)

    @cached_property
    def entry(self) -> Any:
        """Upper end of the slip surface relative to the centre, x and y in m, (..., 2)."""
        return self._end(self.theta_1, self.theta_2)

    def _end(self, rightward: Any, leftward: Any) -> Any:
        """Return an end of the arc, x and y in m.

        Its polar angle in rad is ``rightward`` for a mass that slides to the right and ``leftward`` for a mass that
        slides to the left.
        """
        angle = choose(np.greater(self.facing, 0.0), rightward, leftward)
        return _point(self.radius, np.sin(angle), np.cos(angle))

    @cached_property
    def area(self) -> Any:
        """Area of the segment between arc and chord, m^2: R^2 (x - sin(x))/2 with x = 2 alpha, by its series."""
        x: Any = 2.0 * self.half_angle
        share: Any = 1.0  # sum over the first term, x^3/6
        for k in range(30, 2, -2):  # enough terms for x = pi
            share = 1.0 - x * x * share / (k * (k + 1))
        return np.square(self.radius) * x**3 / 12 * share

    @cached_property
    def centroid(self) -> Any:
        """Centroid of the segment between arc and chord, at the distance C_theta over its area from the centre, m."""
        moment = kernels.weight_moment_amplitude(self.half_angle)
        distance = self.radius * (np.square(self.radius) * moment / self.area)
        return _point(distance, *self._middle)

    @cached_property
    def limit_friction_angle(self) -> Any:
        """Friction angle at limit equilibrium (3.21), rad."""
        return np.arctan(self.dimensionless.limit_friction)


def _point(distance: Any, sine: Any, cosine: Any) -> Any:
    """Return the points at distances from the centre in m in directions given by sine and cosine, (..., 2)."""
    return np.stack([distance * cosine, distance * sine], axis=-1)
