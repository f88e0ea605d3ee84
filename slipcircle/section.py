"""The failed section of a real slope: a ground, a circle, a water level, and the mass between ground and arc."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from slipcircle import circles
from slipcircle.checks import INFINITY, mistakes, raise_all, shape_mistakes
from slipcircle.circles import Cut, Floats
from slipcircle.stability import FAR, line_mistakes, pond_mistakes


class Weights(NamedTuple):
    """What the balance of momentum needs of the position, all over Theta*, positive down-slope.

    After a rotation phi the first pair becomes fall cos(phi) - fall_slope sin(phi), and so does the second: the slopes
    are the derivatives by the dip, which a rotation lowers.
    """

    fall: Any
    fall_slope: Any
    press: Any
    press_slope: Any
    level: Any
    polar: Any
    static_limit: Any  # J_theta/J_r


class Journey(NamedTuple):
    """Where a rotation brings the mass, m and rad."""

    toe: Any
    run_out: Any
    fall: Any
    travel_angle: Any


@dataclass(frozen=True)
class Section:
    """A slip circle through a ground of straight edges, with the mass between ground and arc.

    Parameters
    ----------
    ground : array_like
        Points from left to right, (..., V, 2), x and y in m; equal x is a vertical scarp.
    centre : array_like
        Of the circle, (..., 2), m.
    radius : float or array_like
        m.
    unit_weight : float or array_like
        N/m^3.
    gravity, width : float or array_like, optional
        m/s^2; length across the section, m.
    between : pair of float, optional
        x between which the stretch lies that is meant, where the circle cuts off several.
    level : array_like, optional
        Points of the water level from left to right, (W, 2), m; beyond its ends it goes on horizontally.
    water_unit_weight : float
        N/m^3.
    base : float, optional
        y of a firm layer below which no circle goes, m.

    Raises
    ------
    ValueError
        Lists every mistake, one sentence each: a circle that misses the ground, several stretches and none chosen,
        points out of order, a centre below the ground, a pond, ...

    Notes
    -----
    Ground, centre and radius may be arrays with leading axes; results have their broadcast shape. Angles are measured
    from straight below the centre. Either facing: the mass faces the way in which gravity turns it, ``entry`` is its
    upper end, and positive means down-slope throughout. Moments to about 1e-14 (of J_r, J_theta: of their vector's
    length) for the coordinates as they are given, however thin the mass.
    """

    ground: ArrayLike
    centre: ArrayLike
    radius: ArrayLike
    unit_weight: ArrayLike
    gravity: ArrayLike = 9.81
    width: ArrayLike = 1.0
    between: tuple[float, float] | None = None
    level: ArrayLike | None = None
    water_unit_weight: float = 9810.0
    base: float | None = None

    def __post_init__(self) -> None:
        length, weight = "a positive length below 1e9 m", "a positive unit weight in N/m^3"
        found = mistakes(vars(self), {
            "radius": (0.0, FAR, length), "unit_weight": (0.0, INFINITY, weight), "width": (0.0, INFINITY, length),
            "gravity": (0.0, INFINITY, "a positive acceleration in m/s^2"),
            "water_unit_weight": (0.0, INFINITY, weight),
            "centre": (-FAR, FAR, "two finite numbers [x, y] within 1e9 m"),
            **({} if self.base is None else {"base": (-INFINITY, INFINITY, "a finite number in m")}),
        })  # fmt: skip
        found += [f"{n}: must be one number" for n in ("base", "water_unit_weight") if np.ndim(getattr(self, n))]
        if np.shape(self.centre)[-1:] != (2,) and not any(m.startswith("centre") for m in found):
            found.append(f"centre = {self.centre!r}: must be two numbers [x, y] in m")
        found += _grounds_mistakes(self.ground)
        found += [] if self.level is None else line_mistakes("level", self.level)
        if self.between is not None and not (np.shape(self.between) == (2,) and self.between[0] < self.between[1]):
            found.append(f"between = {self.between!r}: must be two x in m, from left to right")
        if not found:
            shaped = {"radius": self.radius, "centre": np.asarray(self.centre)[..., 0]}
            shaped |= {"ground": np.asarray(self.ground)[..., 0, 0], "unit_weight": self.unit_weight}
            found = shape_mistakes(shaped) or [f"{n}: is empty" for n, v in shaped.items() if not np.size(v)]
        if not found and self.level is not None and np.ndim(self.ground) == 2:
            found = pond_mistakes(np.asarray(self.ground, dtype=np.float64), np.asarray(self.level, dtype=np.float64))
        raise_all("Section", found or self._geometry_mistakes())

    # --- the stretch -------------------------------------------------------------------------------------------------

    @cached_property
    def shape(self) -> tuple[int, ...]:
        """Of the results."""
        return np.broadcast_shapes(np.shape(self.radius), np.shape(self.centre)[:-1], np.shape(self.ground)[:-2])

    @cached_property
    def _circle(self) -> tuple[Floats, Floats, Floats]:
        """Ground, centre and radius with one axis of lanes."""
        ground, centre = np.asarray(self.ground, dtype=np.float64), np.asarray(self.centre, dtype=np.float64)
        if ground.ndim > 2:
            ground = np.broadcast_to(ground, (*self.shape, *ground.shape[-2:]))
        return (
            ground.reshape(-1, *ground.shape[-2:]),
            np.broadcast_to(centre, (*self.shape, 2)).reshape(-1, 2),
            np.broadcast_to(np.asarray(self.radius, dtype=np.float64), self.shape).reshape(-1),
        )

    @cached_property
    def _cut(self) -> Cut:
        return circles.cut(*self._circle)

    @cached_property
    def _candidates(self) -> tuple[Any, Any, Any, Any, Any]:
        """Lane, number and both x of the stretches that may be meant; and which circles hold an end of the ground."""
        _, centre, radius = self._circle
        lane, number, held = circles.stretches(self._cut)
        left, right = (centre[lane, 0] + radius[lane] * end[0] for end in circles.ends(self._cut.only(lane), number))
        if self.between is not None:
            blur = 1e-9 * radius[lane]
            keep = (left >= self.between[0] - blur) & (right <= self.between[1] + blur)
            lane, number, left, right = lane[keep], number[keep], left[keep], right[keep]
            held = np.zeros(len(held), dtype=bool)
        return lane, number, left, right, held

    def _geometry_mistakes(self) -> list[str]:
        """What is wrong with the first circle that has no one stretch, or a centre or base where it must not be."""
        ground, centre, radius = self._circle
        lane, _, left, right, held = self._candidates
        count = np.bincount(lane, minlength=len(radius))
        if np.any(bad := (count != 1) | held):
            k = int(np.argmax(bad))
            (x, y), line = centre[k].tolist(), ground[min(k, len(ground) - 1)]
            which = f"centre = [{x:.10g}, {y:.10g}], radius = {radius[k]:.10g}"
            if count[k] > 1 or (count[k] == 1 and held[k]):
                ends = zip(left[lane == k], right[lane == k], strict=True)
                shown = ", ".join(f"[{a:.6g}, {b:.6g}]" for a, b in ends)
                more = " besides one that an end of the ground cuts short" if held[k] else ""
                return [f"{which}: cuts off several stretches of the ground; choose one by between = {shown}{more}"]
            if held[k]:
                return [f"{which}: an end of the ground lies inside the circle; the ground must go on beyond "
                        f"x = {x - radius[k]:.6g} or {x + radius[k]:.6g}"]  # fmt: skip
            if self.between is not None and circles.stretches(self._cut.only([k]))[0].size:
                return [f"between = {self.between!r}: no stretch of the ground inside the circle lies there"]
            return [f"{which}: misses the ground, which reaches from [{line[0, 0]:.6g}, {line[0, 1]:.6g}] to "
                    f"[{line[-1, 0]:.6g}, {line[-1, 1]:.6g}]"]  # fmt: skip
        (x1, y1), (x2, y2) = self._ends
        winding = np.arctan2(x2, -y2) <= np.arctan2(x1, -y1)
        below = np.array([(left[k] < centre[k, 0] < right[k])
                          and np.interp(centre[k, 0], *ground[min(k, len(ground) - 1)].T) >= centre[k, 1]
                          for k in np.nonzero((left < centre[:, 0]) & (centre[:, 0] < right))[0]])  # fmt: skip
        if np.any(winding) or below.any():
            k = int(np.argmax(winding)) if np.any(winding) else int(np.nonzero((left < centre[:, 0])
                                                                               & (centre[:, 0] < right))[0][np.argmax(below)])  # fmt: skip
            return [f"centre = {centre[k].tolist()}: lies below the ground; the centre of a slip circle lies above it"]
        if self.base is not None:
            lowest = centre[:, 1] + radius * np.where((x1 < 0.0) & (x2 > 0.0), -1.0, np.minimum(y1, y2))
            if np.any(deep := lowest < self.base - 1e-9 * radius):
                k = int(np.argmax(deep))
                return [f"radius = {radius[k]:.10g}: the circle goes down to y = {lowest[k]:.6g}, below base = "
                        f"{self.base:.10g}"]  # fmt: skip
        return []

    @cached_property
    def _ends(self) -> tuple[Floats, Floats]:
        """The left and the right end of the arc from the centre, over R."""
        return circles.ends(self._cut, self._candidates[1])

    @cached_property
    def _mine(self) -> Any:
        return self._cut.stretch == self._candidates[1][:, None]

    @cached_property
    def _moments(self) -> dict[str, Floats]:
        return circles.moments(self._cut, self._mine)

    def _shaped(self, values: Any) -> Any:
        """Values by lane in the shape of the results; a number where there are no arrays."""
        values = np.asarray(values)
        return values.reshape((*self.shape, *values.shape[1:]))[()]

    # --- geometry ----------------------------------------------------------------------------------------------------

    @cached_property
    def _facing(self) -> Floats:
        (_, y1), (_, y2) = self._ends
        by_weight = -np.sign(self._moments["moment_x"])
        return np.where(by_weight != 0.0, by_weight, np.where(y1 < y2, -1.0, 1.0))

    @cached_property
    def facing(self) -> Any:
        """1 where gravity turns the mass to the right, -1 to the left."""
        return self._shaped(self._facing)

    @cached_property
    def _angles(self) -> tuple[Floats, Floats]:
        """Of both ends from straight below the centre, left to right."""
        (x1, y1), (x2, y2) = self._ends
        return np.arctan2(x1, -y1), np.arctan2(x2, -y2)

    @cached_property
    def _chord(self) -> Floats:
        """From the left to the right end, over R, (2, n)."""
        return np.stack([np.where(self._mine, e, 0.0).sum(axis=1) for e in (self._cut.e_x, self._cut.e_y)])

    @cached_property
    def chord(self) -> Any:
        """Its length, m."""
        return self._shaped(np.hypot(*self._chord)) * self.radius

    @cached_property
    def half_angle(self) -> Any:
        """alpha, half the opening angle of the arc, rad."""
        sine = np.minimum(np.hypot(*self._chord) / 2, 1.0)
        whole = self._angles[1] - self._angles[0]
        small = np.where(whole <= np.pi, np.arcsin(sine), np.pi - np.arcsin(sine))
        return self._shaped(np.where(sine > 0.7, whole / 2, small))  # each where it keeps its digits

    @cached_property
    def dip(self) -> Any:
        """psi, the dip of the chord, rad, positive down-slope."""
        return self._shaped(np.arctan2(-self._facing * self._chord[1], self._chord[0]))

    def _upper(self, upper: bool) -> Any:
        _, centre, radius = self._circle
        left, right = (centre + radius[:, None] * end.T for end in self._ends)
        return self._shaped(np.where(((self._facing > 0.0) == upper)[:, None], left, right))

    @cached_property
    def entry(self) -> Any:
        """Upper end of the slip surface, x and y in m."""
        return self._upper(True)

    @cached_property
    def exit(self) -> Any:
        """Lower end of the slip surface: the toe at the start, x and y in m."""
        return self._upper(False)

    @cached_property
    def area(self) -> Any:
        """Of the section, m^2."""
        return self._shaped(self._moments["area"]) * np.square(self.radius)

    @cached_property
    def mass_per_metre(self) -> Any:
        """kg/m."""
        return self.area * np.divide(self.unit_weight, self.gravity)

    @cached_property
    def centroid(self) -> Any:
        """Of the mass, x and y in m."""
        _, centre, radius = self._circle
        m = self._moments
        return self._shaped(centre + np.stack([m["moment_x"], m["moment_y"]], 1) * (radius / m["area"])[:, None])

    @cached_property
    def arc_length(self) -> Any:
        """m."""
        return 2 * self.half_angle * self.radius

    @cached_property
    def depth(self) -> Any:
        """The greatest thickness of the mass, from the arc towards the centre, m."""
        return self._shaped(circles.thickness(self._cut, self._mine)) * self.radius

    @cached_property
    def sagitta(self) -> Any:
        """f, the depth of the arc below its chord (2.12), by which stresses are scaled, m."""
        return np.multiply(self.radius, 2 * np.sin(self.half_angle / 2) ** 2)

    @cached_property
    def mean_cover(self) -> Any:
        """Mean over the arc of the height of the ground above it, m: times r_u and the unit weight, a mean pressure."""
        integral, _ = circles.heads(self._cut, self._mine)
        first, last = self._angles
        return self._shaped((integral(last) - integral(first)) / (last - first)) * self.radius

    # --- mechanics ---------------------------------------------------------------------------------------------------

    @cached_property
    def no_motion(self) -> str | None:
        """Why the method gives no motion, if it does not."""
        if np.any(np.asarray(self.half_angle) > np.pi / 2 * (1 + 8e-16)):
            return ("the arc is longer than half a circle: parts of it carry negative normal stress, and the mean normal "
                    "stress of the method (2.9) loses its sense")  # fmt: skip
        if np.any(np.asarray(self.weights.press) <= 0.0):
            return "the mass presses on nothing: its weight has no component towards the arc"
        return None

    @cached_property
    def dimensionless_moments(self) -> dict[str, Any]:
        """Theta*, I_p*, J_r, J_theta (3.12), (2.17), (2.23), (3.13), and the derivatives of the last two by the dip."""
        m, way = self._moments, self._facing
        found = {"moment_of_inertia": m["inertia"], "polar_moment": m["polar"],
                 "radial_weight": -m["radial_y"], "weight_moment": -way * m["moment_x"],
                 "radial_weight_slope": way * m["radial_x"], "weight_moment_slope": -m["moment_y"]}  # fmt: skip
        return {name: self._shaped(value) for name, value in found.items()}

    @cached_property
    def weights(self) -> Weights:
        """What the balance needs; level is lambda/Theta*, with lambda = 2 alpha f/R (3.14)."""
        m, alpha = self.dimensionless_moments, self.half_angle
        theta = m["moment_of_inertia"]
        return Weights(
            m["weight_moment"] / theta, m["weight_moment_slope"] / theta,
            m["radial_weight"] / theta, m["radial_weight_slope"] / theta,
            4 * alpha * np.sin(alpha / 2) ** 2 / theta, m["polar_moment"] / theta,
            m["weight_moment"] / m["radial_weight"],
        )  # fmt: skip

    @cached_property
    def time_scale(self) -> Any:
        """sqrt(R/g) (3.9), s."""
        return np.sqrt(np.divide(self.radius, self.gravity))

    @cached_property
    def reference_stress(self) -> Any:
        """sigma_ref (2.13), Pa."""
        return np.multiply(self.unit_weight, self.sagitta)

    # --- water -------------------------------------------------------------------------------------------------------

    @cached_property
    def _water(self) -> tuple[Callable[[Any], Any], Floats]:
        _, centre, radius = self._circle
        level, reach = np.asarray(self.level, dtype=np.float64), 4 * float(radius.max())
        far = [np.min(centre[:, 0]) - reach, np.max(centre[:, 0]) + reach]
        before = [[min(far[0], level[0, 0] - reach), level[0, 1]]]
        after = [[max(far[1], level[-1, 0] + reach), level[-1, 1]]]
        wet = circles.cut(np.concatenate([before, level, after])[None], centre, radius)
        return circles.heads(wet, (wet.e_x != 0.0) | (wet.e_y != 0.0))

    def mean_pressure(self, rotation: Any = 0.0) -> Any:
        """Mean pore pressure on the arc under the mass after a rotation, Pa.

        The level stays in space while the mass turns through it; elementary between the ``pressure_kinks``.

        Parameters
        ----------
        rotation : float or array_like
            rad, positive down-slope, (...,) in front of the shape of the section.
        """
        if self.level is None:
            return 0.0 * np.add(rotation, np.zeros(self.shape))
        integral, _ = self._water
        first, last = self._angles
        turn = np.asarray(rotation, dtype=np.float64)
        turn = np.broadcast_to(turn, np.broadcast_shapes(turn.shape, self.shape))
        turned = turn.reshape(*turn.shape[: turn.ndim - len(self.shape)], -1) * self._facing
        mean = (integral(last + turned) - integral(first + turned)) / (last - first)
        return (mean.reshape(turn.shape) * np.multiply(self.radius, self.water_unit_weight))[()]

    @cached_property
    def pressure_kinks(self) -> Any:
        """Rotations at which the mean pressure is not smooth, rad, sorted, on a last axis."""
        if self.level is None:
            return self._shaped(np.empty((len(self._facing), 0)))
        _, kinks = self._water
        turns = np.concatenate([kinks - end[:, None] for end in self._angles], axis=1) * self._facing[:, None]
        return self._shaped(np.sort(turns, axis=1))

    # --- where it goes -----------------------------------------------------------------------------------------------

    def placed(self, points: Any, rotation: Any) -> Any:
        """Points (..., 2) of the mass after a rotation, m."""
        turn = np.multiply(rotation, self.facing)
        x, y = np.moveaxis(np.subtract(points, self.centre), -1, 0)
        turned = np.stack(np.broadcast_arrays(x * np.cos(turn) - y * np.sin(turn), x * np.sin(turn) + y * np.cos(turn)), -1)
        return np.asarray(self.centre) + turned

    def journey(self, rotation: Any) -> Journey:
        """Toe, its horizontal run-out, fall of the centroid, and travel angle: fall over length of the centroid's path."""
        toe, centroid = self.placed(self.exit, rotation), self.placed(self.centroid, rotation)
        way = centroid - self.centroid
        return Journey(
            toe, (toe - self.exit)[..., 0] * self.facing, -way[..., 1],
            np.arctan2(-way[..., 1], way[..., 0] * self.facing),
        )  # fmt: skip


def _grounds_mistakes(ground: Any) -> list[str]:
    """What is wrong with one ground, or with the first of many that is."""
    try:
        points = np.asarray(ground)
    except ValueError:
        points = np.asarray(None)
    if points.dtype.kind not in "iuf" or points.ndim <= 2 or points.shape[-1] != 2:
        return line_mistakes("ground", ground)
    many = points.reshape(-1, *points.shape[-2:]).astype(np.float64)
    with np.errstate(invalid="ignore"):
        step = np.diff(many, axis=1)
    bad = ~(np.abs(many) < FAR).all(axis=(1, 2)) | (step[..., 0] < 0.0).any(axis=1) | ~step.any(axis=2).all(axis=1)
    bad |= many[:, 0, 0] == many[:, -1, 0]
    return line_mistakes("ground", many[int(np.argmax(bad))]) if bad.any() else []


# --- circles and grounds as people give them -------------------------------------------------------------------------


def simple_slope(height: float, *, angle: float | None = None, run: float | None = None, flat: float | None = None) -> Floats:
    """Points of a straight slope that falls to the right between level ground, its toe at the origin, m.

    Parameters
    ----------
    height : float
        m.
    angle, run : float
        Of the slope in rad, up to upright, or its horizontal length in m; one of them.
    flat : float, optional
        Length of the level ground on either side, by default four heights and the run.
    """
    found = mistakes({"height": height}, {"height": (0.0, INFINITY, "a positive length in m")})
    if (angle is None) == (run is None):
        found.append("angle or run: give one of them")
    elif angle is not None:
        found += mistakes({"angle": angle}, {"angle": (0.0, 1.5707963267948968, "above 0 and at most pi/2 (rad)")})
    else:
        found += mistakes({"run": run}, {"run": (-5e-324, INFINITY, "a length of at least 0 in m")})
    raise_all("simple_slope", found)
    if angle is not None:
        run = 0.0 if angle > 1.5707963 else height / float(np.tan(angle))
    assert run is not None
    flat = 4 * height + run if flat is None else flat
    return np.array([[-run - flat, height], [-run, height], [0.0, 0.0], [flat, 0.0]])


def circle_through(
    first: ArrayLike, second: ArrayLike, *, radius: ArrayLike | None = None, depth: ArrayLike | None = None
) -> tuple[Any, Any]:
    """Centre and radius of the circle through two points, its centre above, by its radius or its depth below the chord.

    Raises
    ------
    ValueError
        For points above each other, a radius below half their distance, or a depth above it (beyond a half disc).
    """
    p, q = np.asarray(first, dtype=np.float64), np.asarray(second, dtype=np.float64)
    p, q = np.where(p[..., :1] <= q[..., :1], p, q), np.where(p[..., :1] <= q[..., :1], q, p)
    half = np.hypot(*np.moveaxis(q - p, -1, 0)) / 2
    found = ["radius or depth: give one of them"] if (radius is None) == (depth is None) else []
    if np.any(p[..., 0] == q[..., 0]):
        found.append("the two points lie above each other; a slip circle leads from one side to the other")
    elif radius is not None and np.any(np.asarray(radius) < half):
        found.append(f"radius = {np.min(radius):.10g}: must be at least half the distance of the points, {np.max(half):.10g}")
    elif depth is not None and np.any((np.asarray(depth) <= 0.0) | (np.asarray(depth) > half)):
        found.append(f"depth = {np.max(depth):.10g}: must be above 0 and at most half the distance of the points, "
                     f"{np.min(half):.10g}")  # fmt: skip
    raise_all("circle_through", found)
    if depth is not None:
        radius = (half**2 + np.square(depth)) / (2 * np.asarray(depth))
    rise = np.sqrt((np.asarray(radius) - half) * (np.asarray(radius) + half))
    up = np.stack([-(q - p)[..., 1], (q - p)[..., 0]], axis=-1) / (2 * half)[..., None]
    return (p + q) / 2 + up * rise[..., None], np.asarray(radius)[()]


def circle_touching(first: ArrayLike, second: ArrayLike, level: ArrayLike) -> tuple[Any, Any]:
    """Centre and radius of the circle through two points (entry and exit) that touches a level between them from above.

    Raises
    ------
    ValueError
        For a level that is not below both points.
    """
    p, q = np.asarray(first, dtype=np.float64), np.asarray(second, dtype=np.float64)
    p, q = np.where(p[..., :1] <= q[..., :1], p, q), np.where(p[..., :1] <= q[..., :1], q, p)
    a, b, run = p[..., 1] - level, q[..., 1] - level, (q - p)[..., 0]
    if np.any((a <= 0.0) | (b <= 0.0)) or np.any(run == 0.0):
        raise ValueError(f"circle_touching: level = {np.max(level):.10g}: must lie below both points, which must not lie "
                         "above each other")  # fmt: skip
    u = a * (run**2 + b * (b - a)) / (a * run + np.sqrt(a * b * (run**2 + (b - a) ** 2)))
    radius = (u * u + a * a) / (2 * a)
    return np.stack([p[..., 0] + u, level + radius], axis=-1), radius[()]
