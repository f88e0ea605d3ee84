"""A scene's balance of momentum: the specialised functions of its combination of effects, bound to its values."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cache, cached_property
from typing import Any

import numpy as np

from generated import balance as functions
from generated import kernels
from generated.effects import ARGUMENTS, COMBINATIONS, EFFECTS, Parameter
from slipcircle.arc import Arc
from slipcircle.checks import number
from slipcircle.scene import Scene

# Without shaking and heat: what is given anew at each moment comes on top.
STILL: dict[str, Any] = {"k_h": 0.0, "k_v": 0.0, "excess": 0.0, "omega": 0.0, "fall_slope": 0.0, "press_slope": 0.0}
# What time, speed and heat ask for: no lane is solved with it.
LOCAL = {"k_h", "k_v", "excess"} | {
    p.symbol for e in EFFECTS.values() if {"time", "speed", "history"} & {*e.depends_on} for p in e.parameters
}


@dataclass
class Balance:
    """The functions of the balance for one combination of effects, all over Theta*, in the direction of travel.

    Attributes
    ----------
    names : mapping
        Generated function by what it gives: normal, limit_friction, drive, brake, tilt, ...
    values : mapping
        What does not change with position: level, polar, and the effects' dimensionless parameters.
    weight, radial : float
        C_theta/Theta* and C_r/Theta*; the weight acts as weight sin(dip) and presses as radial cos(dip).
    dip : float
        Of the chord at the start, rad.
    fall, press : float
        J_theta/Theta* and J_r/Theta* at the start.
    static_limit : float
        J_theta/J_r at the start.
    turns : bool
        Whether the position changes with the rotation.
    radius : float
        m, from rotation to slip.
    time_scale : float
        s, from dimensionless to real time.
    forcing : mapping
        What changes with time, by its symbol: the function of time in s, and the factor that makes its values
        dimensionless.
    """

    names: Mapping[str, str]
    values: Mapping[str, Any]
    weight: Any
    radial: Any
    dip: Any
    fall: Any
    press: Any
    static_limit: Any
    turns: bool
    radius: Any
    time_scale: Any = 1.0
    forcing: Mapping[str, tuple[Any, float]] = field(default_factory=dict)

    def has(self, what: str) -> bool:
        """Whether this combination has such a term."""
        return what in self.names

    def get(self, what: str, /, **local: Any) -> Any:
        """Evaluate one function; 0 for a term that this combination does not have."""
        name = self.names.get(what)
        if name is None:
            return 0.0
        values = self.values
        return getattr(functions, name)(*[local[a] if a in local else values[a] for a in ARGUMENTS[name]])

    @property
    def lightened(self) -> bool:
        """Whether water or shaking may carry the mass, so that what presses is not J_r/Theta* alone."""
        return self.names["normal"] != "normal"

    def drive(self, at: Mapping[str, float], mu: float) -> float:
        """The drive at a position less the resistance at rest: from the limit friction, unless water carries the mass.

        There friction is a small part, and none where the mass is lifted, mu = 0.
        """
        if self.lightened and (normal := float(self.get("normal", **at))) <= 1e-6 * at["press"]:
            return float(at["fall"] - self.get("constant", mu=0.0) - mu * normal)
        return float(self.get("drive", **at, mu=mu, limit_friction=self.get("limit_friction", **at)))

    def press_at(self, rotation: Any) -> Any:
        """J_r/Theta* after any rotation of the mass."""
        if not self.turns:
            return self.press + 0.0 * rotation
        return self.press * np.cos(rotation) + self.radial * np.sin(self.dip) * np.sin(rotation)

    def press_slope_at(self, rotation: Any) -> Any:
        """The derivative of J_r/Theta* by the dip, after any rotation of the mass."""
        if not self.turns:
            return -self.radial * np.sin(self.dip) + 0.0 * rotation
        return -self.radial * np.sin(self.dip) * np.cos(rotation) + self.press * np.sin(rotation)

    @cached_property
    def kinks(self) -> Any:
        """Dimensionless times at which what changes with time is not smooth."""
        return (
            np.unique(np.concatenate([[], *(np.asarray(f.kinks) for f, _ in self.forcing.values())])) / self.time_scale
        )

    def given(self, t: Any, direction: int = 1) -> dict[str, Any]:
        """What changes with time, at dimensionless times, seen in the direction of travel."""
        found = {name: factor * function(t * self.time_scale) for name, (function, factor) in self.forcing.items()}
        if "k_h" in found and direction < 0:
            found["k_h"] = -found["k_h"]
        return found

    def nudged(self, share: float) -> "Balance":
        """The same with its weights changed against each other by a share of them: what rounding may do."""
        return replace(
            self,
            weight=self.weight * (1.0 + share),
            radial=self.radial * (1.0 - share),
            fall=self.fall * (1.0 + share),
            press=self.press * (1.0 - share),
            static_limit=self.static_limit * (1.0 + 2 * share),
        )

    def position(self, rotation: float, direction: int) -> dict[str, float]:
        """What the balance needs of the position, seen in the direction of travel (a mirror, where it is negative)."""
        dip, fall, press, limit = self.dip, self.fall, self.press, self.static_limit
        slope, rise = self.weight * math.cos(dip), self.radial * math.sin(dip)
        if self.turns and rotation != 0.0:  # from the start, so that the limit falls with every turn, however small
            cos, sin = math.cos(rotation), math.sin(rotation)
            limit = (limit - slope / press * math.tan(rotation)) / (1.0 + rise / press * math.tan(rotation))
            fall, slope = fall * cos - slope * sin, slope * cos + fall * sin
            press, rise, dip = press * cos + rise * sin, rise * cos - press * sin, dip - rotation
        return {
            "fall": direction * fall,
            "press": press,
            "static_limit": direction * limit,
            "fall_slope": slope,
            "press_slope": -direction * rise,
            "dip": direction * dip,
        }


def bind(scene: Scene) -> Balance:
    """The balance of a scene of plain numbers."""
    arc, d, called = scene.arc, scene.arc.dimensionless, scene.called
    names, turns, valued = _combined(tuple(called))
    press = float(d.radial_weight_per_inertia)
    weight, radial = arc.amplitudes_per_inertia
    level = press / float(d.static_normal_stress)  # lambda/Theta* = (J_r/Theta*)/(J_r/lambda)
    values = {"level": level, "polar": float(d.polar_moment_per_inertia), **STILL}
    forcing: dict[str, tuple[Any, float]] = {}
    scales = {
        "half_angle": float(arc.half_angle),
        "gravity": number(arc.gravity),
        "reference_stress": float(arc.reference_stress),
        "Theta": float(d.moment_of_inertia),
        "radius": number(arc.radius),
        "density": float(np.divide(arc.unit_weight, arc.gravity)),
    } if valued else {}  # fmt: skip
    for effect, parameters in valued:
        given = called[effect]
        own = {p.name: float(given.get(p.name, 0.0)) for p in EFFECTS[effect].parameters if p.kind == "number"}
        for p in parameters:
            value = given.get(p.name, 0.0)
            if callable(value):
                forcing[p.symbol] = value, p.dimensionless(1.0, scales | own)
                value = 0.0 if p.symbol in STILL else value(0.0)
            values[p.symbol] = p.dimensionless(float(value), scales | own)
    limit = float(d.limit_friction)
    return Balance(
        names,
        values,
        float(weight),
        float(radial),
        float(arc.dip),
        limit * press,
        press,
        limit,
        turns,
        number(arc.radius),
        float(arc.time_scale),
        forcing,
    )


@cache
def _combined(called: tuple[str, ...]) -> tuple[Mapping[str, str], bool, list[tuple[str, list[Parameter]]]]:
    """What does not depend on values: the functions, whether the mass turns, effects with what the balance asks for."""
    effects = tuple(e for e in EFFECTS if e in called)
    valued = [(e, symbols) for e in effects if (symbols := [p for p in EFFECTS[e].parameters if p.symbol])]
    return COMBINATIONS[effects].functions, any(EFFECTS[e].turns for e in effects), valued


def bind_lanes(effects: tuple[str, ...], arc: Arc, values: Mapping[str, Any], *, stress: bool = False) -> Balance:
    """The balance of lanes, by the same arithmetic: arrays or numbers, and only what their motion asks for."""
    names = COMBINATIONS[effects].functions
    unasked = () if stress else ("effective_stress", "normal_stress")
    asked = {a for what, n in names.items() if what not in unasked for a in ARGUMENTS[n]}
    d, alpha = None if arc.given is None else arc.dimensionless, arc.half_angle
    press, (weight, radial) = arc.press(), arc.amplitudes_per_inertia
    limit = kernels.limit_friction(arc.theta_1, arc.theta_2) if d is None else d.limit_friction
    known: dict[str, Any] = {}
    if asked & {"polar", "level"}:
        known["polar"] = kernels.polar_moment_per_inertia(alpha) if d is None else d.polar_moment_per_inertia
    if "level" in asked:
        dynamic = kernels.dynamic_coefficient(alpha) if d is None else d.dynamic_coefficient
        static = press * dynamic / known["polar"] if d is None else d.static_normal_stress
        known["level"] = press / static
    scales = {"half_angle": alpha, "gravity": arc.gravity, "reference_stress": arc.reference_stress}
    if "drag" in asked:
        scales["Theta"] = kernels.moment_of_inertia(alpha) if d is None else d.moment_of_inertia
    for effect in effects:
        for p in EFFECTS[effect].parameters:
            if p.symbol not in ("", *LOCAL) and f"{effect}.{p.name}" in values:
                known[p.symbol] = p.dimensionless(values[f"{effect}.{p.name}"], scales)
    known = STILL | known if asked & LOCAL else known
    turns = any(EFFECTS[e].turns for e in effects)
    return Balance(names, known, weight, radial, arc.dip, limit * press, press, limit, turns, arc.radius)
