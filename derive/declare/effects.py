"""Content of scenes, declared as data: friction laws, and effects as terms of the balance of momentum.

A new effect is one more `Effect` here. From it follow its part of the flow programs (`derive.flow.fragments`), the
runtime half (names, units, bounds, help, conversions) in `generated/effects.py`, and with that scenes, plans, schema
and help.
"""

import re
from dataclasses import dataclass, replace

import sympy as sp

from derive.declare.limits import LIMITS, PREFIXES
from derive.kinds import Names, Pair

# The balance (3.11), any effect included: Theta* d(omega*)/dt* = J_theta - resistance - lambda mu (sigma* - u*).
THETA, J_R, J_THETA, LAMBDA, A, MU, OMEGA, OMEGA_2 = sp.symbols(
    "Theta J_r J_theta lambda A mu omega omega_2", real=True
)
# The same over Theta*, as the functions take it: driving_moment = J_theta/Theta*, normal_load = J_r/Theta*,
# resistance_factor = lambda/Theta*, polar_moment = I_p*/Theta*; slopes are derivatives by psi.
DRIVING_MOMENT, NORMAL_LOAD, RESISTANCE_FACTOR, POLAR_MOMENT = sp.symbols(
    "driving_moment normal_load resistance_factor polar_moment", real=True
)
DRIVING_MOMENT_SLOPE, NORMAL_LOAD_SLOPE = sp.symbols("driving_moment_slope normal_load_slope", real=True)
# What parameters are converted with: half angle, gravity, radius, density, Theta*, the reference stress (2.13).
# cover is the stress of which r_u is a share, over the static normal stress.
ALPHA, GRAVITY, RADIUS, DENSITY, REFERENCE, COVER, VALUE = sp.symbols(
    "half_angle gravity radius density reference_stress cover value", real=True
)
STRENGTH = sp.Symbol("strength_factor", real=True)  # multiplies friction and cohesion of every law
SLIP, SPEED = sp.symbols("slip speed", real=True)
DEGREE = 7  # of the pieces of tabulated functions

_ZERO = sp.Integer(0)
_INFINITY = float("inf")
_BELOW_0 = -5e-324  # bounds are open, and zero is allowed


@dataclass(frozen=True)
class Parameter:
    """Parameter of an effect or a law: SI unit, open bounds, and key in scene files.

    ``key`` names it in a scene file, and ends in its ``unit``, which may have a prefix: suction_kPa of Pa. ``symbol``
    stands for it in the balance, and ``dimensionless`` is its conversion: a formula of the value, of the arc's scales
    and of the effect's other parameters, by their names. An ``optional`` one may be omitted. ``kind`` is "number",
    "list" (of numbers), "series" (a number, or a function of time), "rotation" (the same of the rotation, which the
    section gives), "fixed" (a number that does not vary), "text", "name" (a text or a number), "flag" or one of several
    words, "this|that". A parameter without ``key`` cannot be written in a file.
    """

    name: str
    unit: str
    help: str
    key: str
    symbol: sp.Symbol | None = None
    dimensionless: sp.Expr = VALUE
    lower: float = _BELOW_0
    upper: float = _INFINITY
    optional: bool = False
    kind: str = "number"

    @property
    def bounds(self) -> Pair:
        """Open bounds, from `LIMITS` of the unit where the declared bounds only state the sign."""
        if not self.key or self.kind not in ("number", "list", "series", "fixed"):
            return self.lower, self.upper
        least, most = LIMITS[self.unit]
        return least if self.lower == 0.0 else max(self.lower, -most), min(self.upper, most)

    @property
    def per_unit(self) -> float:
        """SI units in one unit of the key, 0 if the key does not end in the unit."""
        if not self.unit or not self.key:
            return 1.0
        unit = "Pa" if self.unit == "Pa/m" else re.sub("[/ ]", "_", self.unit).replace("^", "")  # per_m_kPa
        written = re.search(f"_([kM]?){unit}$", self.key)
        return PREFIXES[written[1]] if written else 0.0


@dataclass(frozen=True)
class Effect:
    """Term of the balance that a scene may contain.

    ``stress`` is its contribution to the mean normal stress and ``pressure`` to the pore pressure, over sigma_ref;
    ``resistance`` is a moment that opposes the motion. ``driving_moment`` and ``normal_load`` are its contributions to
    J_theta and J_r, ``friction`` to the friction coefficient. Slip is over R here, and speed over sqrt(g R). ``turns``
    lets the geometry move with the mass. ``states`` are symbols that change with time, and ``growth`` is their
    derivative by the rotation. At least one parameter of ``any_of`` is needed. ``equation`` is its number in the paper,
    ``source`` that of an effect which is not there.
    """

    name: str
    help: str
    parameters: tuple[Parameter, ...] = ()
    equation: str = ""
    source: str = ""
    stress: sp.Expr = _ZERO
    pressure: sp.Expr = _ZERO
    resistance: sp.Expr = _ZERO
    turns: bool = False
    driving_moment: sp.Expr = _ZERO
    normal_load: sp.Expr = _ZERO
    friction: sp.Expr = _ZERO
    states: tuple[sp.Symbol, ...] = ()
    growth: sp.Expr = _ZERO
    any_of: Names = ()

    @property
    def symbols(self) -> dict[sp.Symbol, Parameter]:
        """Parameters in the balance by their symbols."""
        return {p.symbol: p for p in self.parameters if p.symbol is not None}

    @property
    def terms(self) -> dict[str, sp.Expr]:
        """Terms by the quantity of the balance."""
        return {
            "sigma": self.stress,
            "u": self.pressure,
            "resistance": self.resistance,
            "J_theta": self.driving_moment,
            "J_r": self.normal_load,
            "mu": self.friction,
        }

    @property
    def depends_on(self) -> Names:
        """Variables by which the effect changes during a motion, except for its quadratic terms in the speed."""
        free = set().union(*(e.free_symbols for e in self.terms.values()))
        every = {
            "slip": self.turns or SLIP in free,
            "speed": {OMEGA, SPEED} & free,
            "time": "series" in (p.kind for p in self.parameters),
            "history": self.states,
        }
        return tuple(variable for variable, depends in every.items() if depends)


@dataclass(frozen=True)
class Law:
    """Friction law: the friction coefficient as a function of the accumulated slip, of the speed, or of time.

    ``coefficient`` is in `SLIP` or `SPEED` and the parameters' names; a minimum or maximum changes its branch at a slip
    that is a parameter. A law without formula (a table: a list of its argument, and one of coefficients) is computed by
    the runtime, in pieces that are polynomials of this ``degree`` in the slip or in the logarithm of the speed.
    ``equation`` is its number in the paper, ``source`` that of a law which is not there.
    """

    name: str
    help: str
    parameters: tuple[Parameter, ...]
    coefficient: sp.Expr | None = None
    degree: int = 0
    equation: str = ""
    source: str = ""

    @property
    def depends_on(self) -> Names:
        """Variables of the law: slip, speed or time."""
        if self.coefficient is None:
            return (self.parameters[0].name,)
        return tuple(str(x) for x in (SLIP, SPEED) if x in self.coefficient.free_symbols)

    @property
    def kinks(self) -> tuple[sp.Symbol, ...]:
        """Slips at which the law is not smooth."""
        branches = (self.coefficient or _ZERO).atoms(sp.Min, sp.Max)
        places: list[sp.Symbol] = []
        for branch in sorted(branches, key=str):
            places += sp.solve(sp.Eq(*branch.args), SLIP)
        return tuple(dict.fromkeys(places))


def _friction(name: str, help: str, key: str = "", kind: str = "number") -> Parameter:
    """Declare a friction coefficient. A key in degrees contains its angle, and a file may give the number instead."""
    return Parameter(name, "", help, key or f"{name}_deg", kind=kind)


_SOFTENING = (
    _friction("peak", "friction coefficient at the start"),
    _friction("residual", "friction coefficient after much slip"),
    Parameter("length", "m", "slip over which friction falls", "length_m", lower=0.0),
)
_WEAKENING = (
    _friction("peak", "friction coefficient at rest"),
    _friction("residual", "friction coefficient at great speed"),
    Parameter("velocity", "m/s", "speed at which half of the change has happened", "velocity_m_s", lower=0.0),
)
_P, _R, _L, _V, _C = sp.symbols("peak residual length velocity coefficient", real=True)

LAWS = (
    Law("constant", "friction does not change", (_friction("coefficient", "friction coefficient, tan(phi)",
        "angle_deg"),), _C, equation="1.14"),
    Law("exponential", "residual + (peak - residual) exp(-slip/length)", _SOFTENING,
        _R + (_P - _R) * sp.exp(-SLIP / _L), equation="Fig. 4-1"),
    Law("linear", "falls from peak to residual over the length, then stays", _SOFTENING,
        _P + (_R - _P) * sp.Min(SLIP / _L, 1), equation="Fig. 4-1"),
    Law("hyperbolic", "residual + (peak - residual)/(1 + slip/length)", _SOFTENING,
        _R + (_P - _R) / (1 + SLIP / _L), equation="Fig. 4-1"),
    Law("tabulated", "monotone cubic interpolation in a table, its last value beyond", (
        Parameter("slip", "m", "slips of the table, increasing, from 0", "slip_m", kind="list"),
        _friction("coefficient", "friction coefficients at these slips", "angle_deg", kind="list")),
        degree=3, equation="Fig. 4-1"),
    Law("rate_weakening", "residual + (peak - residual)/(1 + speed/velocity)", _WEAKENING,
        _R + (_P - _R) / (1 + SPEED / _V), equation="1.14"),
    Law("rate_tabulated", "monotone cubic interpolation in the logarithm of the speed, the end values beyond", (
        Parameter("speed", "m/s", "speeds of the table, increasing", "speed_m_s", lower=0.0, kind="list"),
        _friction("coefficient", "friction coefficients at these speeds", "angle_deg", kind="list")),
        degree=3, equation="1.14"),
    Law("prescribed", "straight lines between the times of a table, the end values beyond", (
        Parameter("time", "s", "times of the table, increasing", "time_s", kind="list"),
        _friction("coefficient", "friction coefficients at these times", "angle_deg", kind="list")),
        equation="1.14"),
)  # fmt: skip

_COHESION, _DEPTH, _RATIO, _PRESSURE, WATER, _DRAG, _VISCOSITY = sp.symbols(
    "cohesion growing_cohesion pore_ratio pore_pressure water drag viscosity", real=True
)
K_H, K_V, _EXCESS, _KAPPA, _STANDING = sp.symbols("k_h k_v excess kappa standing_water", real=True)
# Of the soils along an arc, over Theta*. What turns with the mass are numbers, the others functions of the rotation.
SLIP_MU, TURNING, TURNING_SLOPE, REMAINING, REMAINING_SLOPE = sp.symbols(
    "slip_mu turning turning_slope remaining remaining_slope", real=True
)
_NORMAL, _NORMAL_SLOPE, _INERTIA, _LIFT, _COHESIVE = sp.symbols(
    "layered_normal layered_normal_slope layered_inertia layered_lift layered_cohesion", real=True
)
_REMAINING, _REMAINING_SLOPE, _REMAINING_INERTIA, _REMAINING_LIFT = sp.symbols(
    "layered_remaining layered_remaining_slope layered_remaining_inertia layered_remaining_lift", real=True
)
# Of one soil with a law of slip of its own: its coefficient, its share of the normal force at the start, and the
# excess of the normal force on its stretches over this share, over Theta*.
SOIL_MU, COHESION_LAW, SOIL_TURNING, SOIL_SLOPE = sp.symbols("soil_mu cohesion_law soil_turning soil_slope", real=True)
_SHARE, _SOIL_INERTIA, _SOIL_LIFT = sp.symbols("soil_share soil_inertia soil_lift", real=True)
_SOFTENED, _SOFTENED_DEPTH, _GRADIENT = sp.symbols("soft_share soft_depth gradient", real=True)
_THICKNESS, _CAPACITY, EFFECTIVE = sp.symbols("thickness heat_capacity effective_stress", real=True)


def _optional(
    name: str, help: str, unit: str = "", key: str | None = None, kind: str = "number", symbol: sp.Symbol | None = None
) -> Parameter:
    """Declare an optional number, function of time, or text."""
    key = name if key is None else key
    return Parameter(name, unit, help, key, symbol, lower=-_INFINITY, optional=True, kind=kind)


def _of_section(
    name: str, help: str, symbol: sp.Symbol, kind: str = "number", dimensionless: sp.Expr = VALUE
) -> Parameter:
    """Declare a parameter that a layered section provides, over Theta*; it cannot be given by a file or a user."""
    return replace(_optional(name, help, "", "", kind, symbol), dimensionless=dimensionless)


_OF_A_RECORD = (
    _optional("column", "name or number of the record's column, where there is a choice", kind="name"),
    _optional("columns", "roles of all columns of a table in place of its header: time,acceleration,skip", kind="text"),
    _optional("step", "time between samples of a record without times", "s", "step_s"),
    _optional("gaps", "missing samples: refused, or bridged by straight lines", kind="refuse|linear"),
)
_LAYER_THICKNESS = Parameter("thickness", "m", "thickness of the sheared layer", "thickness_m", lower=0.0)
EFFECTS = (
    Effect("rotation", "the mass turns as it slides, and its weight acts in its new position", equation="1.2",
           turns=True),
    Effect("centripetal", "the normal stress on the slip surface increases with the speed of rotation",
           equation="2.20", stress=A * OMEGA_2),
    Effect("pore_pressure", "water pressure on the slip surface reduces friction", (
        Parameter("ratio", "", "r_u, pore pressure over the static normal stress at the position (of a "
                  "real section over the weight of the soil above), constant or a function of time", "ratio",
                  _RATIO, COVER * VALUE, upper=1.0, optional=True, kind="series"),
        Parameter("pressure", "Pa", "mean pore pressure on the slip surface, constant or a function of time",
                  "pressure_kPa", _PRESSURE, VALUE / REFERENCE, optional=True, kind="series"),
        Parameter("level", "Pa", "mean pressure on the arc of a real section below its water level, which stays "
                  "while the mass turns through it", "", WATER, VALUE / REFERENCE, optional=True, kind="rotation"),
        _of_section("standing", "moment of the water that the mass displaces, over Theta*", _STANDING, "rotation"),
        Parameter("time", "s", "times of a ratio or pressure given as a list, with linear interpolation", "time_s",
                  optional=True, kind="list"),
        _optional("record", "file of a record of either, relative to the scene's: a table of times and values",
                  kind="text"),
        _optional("units", "unit of the record's values, if the file does not give it: Pa, kPa, MPa, or ratio for r_u",
                  kind="text"),
        _optional("start", "time of its first sample, by default the record's own", "s", "start_s"),
        *_OF_A_RECORD),
           equation="2.20", pressure=_RATIO * J_R / LAMBDA + _PRESSURE + WATER, driving_moment=-THETA * _STANDING,
           any_of=("ratio", "pressure", "record")),
    Effect("cohesion", "the slip surface has strength without normal stress", (
        Parameter("cohesion", "Pa", "shear strength without normal stress", "cohesion_kPa",
                  _COHESION, STRENGTH * VALUE / REFERENCE),
        Parameter("gradient", "Pa/m", "growth of the cohesion per metre below datum_m, by default 0",
                  "cohesion_per_m_kPa", optional=True),
        Parameter("datum", "m", "y below which the cohesion grows, by default the ground before the slide", "datum_m",
                  lower=-_INFINITY, optional=True, kind="fixed"),
        Parameter("depth", "m", "mean depth of the slip surface below this height, or below the ground", "",
                  _DEPTH, STRENGTH * VALUE * _GRADIENT / REFERENCE, optional=True, kind="rotation")),
           equation="3.11", resistance=LAMBDA * (_COHESION + _DEPTH)),
    Effect("drag", "turbulent resistance, which grows with the square of the speed", (
        Parameter("xi", "m/s^2", "turbulence coefficient of Voellmy", "xi_m_s2",
                  _DRAG, 2 * ALPHA * GRAVITY / (VALUE * THETA), lower=0.0),),
           equation="3.11", resistance=THETA * _DRAG * OMEGA_2),
    Effect("viscosity", "viscous resistance of a sheared layer, which grows with the speed", (
        Parameter("viscosity", "Pa s", "dynamic viscosity of the sheared layer", "viscosity_Pa_s",
                  _VISCOSITY, 2 * ALPHA * VALUE / (DENSITY * _THICKNESS * sp.sqrt(GRAVITY * RADIUS) * THETA)),
        _LAYER_THICKNESS),
           equation="3.11", resistance=THETA * _VISCOSITY * OMEGA),
    Effect("shaking", "ground motion tilts and scales gravity", (
        _optional("horizontal", "k_h(t), driving acceleration over g, positive down-slope", "", "", "series", K_H),
        _optional("vertical", "k_v(t), acceleration over g that reduces the effective weight", "", "", "series", K_V),
        _optional("pulse", "name of a pulse", kind="rectangular|half-sine|triangular|sine"),
        _optional("amplitude", "greatest k_h of the pulse, positive down-slope", key="amplitude_g"),
        _optional("vertical_amplitude", "greatest k_v of the pulse, by default 0", key="vertical_amplitude_g"),
        _optional("start", "time at which the shaking begins, by default 0 or the record's own", "s", "start_s"),
        _optional("duration", "duration of the pulse", "s", "duration_s"),
        _optional("cycles", "waves of a sine, by default 1"),
        _optional("record", "file of an acceleration record, relative to the scene's", kind="text"),
        _optional("holds", "content of the record, positive down-slope whichever way the slope faces: acceleration of "
                  "the ground, or its opposite, which drives the mass", kind="ground|driving"),
        _optional("units", "unit of the record's values, if the file does not state it, such as g, m/s2, gal, ft/s2",
                  kind="text"),
        _optional("vertical_record", "file of the vertical acceleration, positive upwards for that of the ground",
                  kind="text"),
        _optional("vertical_column", "name or number of its column, by default in the same file", kind="name"),
        _optional("scale", "factor on the record's values, by default 1"),
        _optional("peak", "greatest horizontal acceleration to which a record is scaled, in place of a factor",
                  key="peak_g"),
        *_OF_A_RECORD,
        _optional("two_way", "whether shaking may also start the mass up-slope; by default false", kind="flag")),
           equation="3.11", any_of=("horizontal", "pulse", "record"),
           driving_moment=K_H * THETA * DRIVING_MOMENT_SLOPE - K_V * J_THETA,
           normal_load=K_H * THETA * NORMAL_LOAD_SLOPE - K_V * J_R),
    Effect("thermal_pressurisation",
           "friction heats a thin layer, whose pore water expands and reduces its strength; undrained and adiabatic "
           "(neither water nor heat leaves the layer), as in slides of seconds to minutes on some millimetres of clay; "
           "one mean pressure and temperature, constant Lambda, and all work of friction is heat", (
        Parameter("pressurisation", "Pa/K", "Lambda, rise of the pore pressure in the undrained "
                  "layer for each kelvin", "pressurisation_MPa_K", _KAPPA, VALUE * RADIUS / (_CAPACITY * _THICKNESS)),
        Parameter("heat_capacity", "J/m^3 K", "rho c, heat capacity of the layer by volume",
                  "heat_capacity_MJ_m3_K", lower=0.0),
        _LAYER_THICKNESS),
           equation="3.11", pressure=_EXCESS, states=(_EXCESS,), growth=_KAPPA * MU * EFFECTIVE),
)  # fmt: skip

# Contributions of a section to the balance, which no user and no file requests.
_EXCESS_NORMAL, _EXCESS_SLOPE = _NORMAL + TURNING, _NORMAL_SLOPE + TURNING_SLOPE
_LEFT_NORMAL, _LEFT_SLOPE = _REMAINING + REMAINING, _REMAINING_SLOPE + REMAINING_SLOPE
_EXCESS_PRESS = (1 - K_V) * _EXCESS_NORMAL + K_H * _EXCESS_SLOPE + _INERTIA * OMEGA_2
_STRONG = STRENGTH * VALUE
_LEFT_PRESS = (1 - K_V) * _LEFT_NORMAL + K_H * _LEFT_SLOPE + _REMAINING_INERTIA * OMEGA_2
_SOIL_PRESS = (1 - K_V) * SOIL_TURNING + K_H * SOIL_SLOPE + _SOIL_INERTIA * OMEGA_2
SECTION_EFFECTS = (
    Effect("layered_strength",
           "each soil along the arc has its strength, with the normal stress from the weight above it (2.23)", (
        _of_section("turning", "excess of friction's normal force over the mean, of strength with the mass", TURNING),
        _of_section("turning_slope", "its derivative by the dip", TURNING_SLOPE),
        _of_section("normal", "the same of strength with the base", _NORMAL, "rotation"),
        _of_section("normal_slope", "its derivative by the dip", _NORMAL_SLOPE, "rotation"),
        _of_section("inertia", "its increase by the square of the angular velocity", _INERTIA, "rotation"),
        _of_section("lift", "its decrease by water", _LIFT, "rotation"),
        _of_section("remaining", "excess of the friction that slip leaves, of strength with the mass", REMAINING,
                    dimensionless=_STRONG),
        _of_section("remaining_slope", "its derivative by the dip", REMAINING_SLOPE, dimensionless=_STRONG),
        _of_section("remaining_normal", "the same of strength with the base", _REMAINING, "rotation", _STRONG),
        _of_section("remaining_normal_slope", "its derivative by the dip", _REMAINING_SLOPE, "rotation",
                    _STRONG),
        _of_section("remaining_inertia", "its increase by the square of the angular velocity", _REMAINING_INERTIA,
                    "rotation", _STRONG),
        _of_section("remaining_lift", "its decrease by water", _REMAINING_LIFT, "rotation", _STRONG),
        _of_section("strength", "strength without normal stress", _COHESIVE, "rotation", _STRONG)), equation="2.23",
           normal_load=THETA * (_EXCESS_PRESS + _LEFT_PRESS / SLIP_MU),
           pressure=THETA / LAMBDA * (_LIFT + _REMAINING_LIFT / SLIP_MU), resistance=THETA * _COHESIVE),
    Effect("soil_friction",
           "a soil has a friction law of its own, and its part of the normal force; strength moves with the mass", (
        _of_section("share", "share of the normal force at the start", _SHARE),
        _of_section("turning", "excess of the normal force over this share, at the start 0", SOIL_TURNING),
        _of_section("slope", "its derivative by the dip", SOIL_SLOPE),
        _of_section("inertia", "its increase by the square of the angular velocity", _SOIL_INERTIA),
        _of_section("lift", "decrease of the normal force by water", _SOIL_LIFT, "rotation")), equation="2.23",
           normal_load=THETA * _SOIL_PRESS * SOIL_MU / SLIP_MU,
           pressure=THETA / LAMBDA * _SOIL_LIFT * SOIL_MU / SLIP_MU, friction=_SHARE * SOIL_MU),
    Effect("softening_cohesion", "strength without normal stress changes with slip", (
        _of_section("moment", "moment of 1 Pa", _SOFTENED, "rotation", _STRONG),
        _optional("gradient", "moment of the growth of 1 Pa per metre", key=""),
        _of_section("depth", "mean depth, m", _SOFTENED_DEPTH, "rotation", _STRONG * _GRADIENT)), equation="3.11",
           resistance=THETA * (_SOFTENED + _SOFTENED_DEPTH) * COHESION_LAW),
)  # fmt: skip
ALL_EFFECTS = (*EFFECTS, *SECTION_EFFECTS)

# The derivatives by psi of what turns with the mass.
BY_PSI = {DRIVING_MOMENT: DRIVING_MOMENT_SLOPE, DRIVING_MOMENT_SLOPE: -DRIVING_MOMENT,
          NORMAL_LOAD: NORMAL_LOAD_SLOPE, NORMAL_LOAD_SLOPE: -NORMAL_LOAD,
          TURNING: TURNING_SLOPE, TURNING_SLOPE: -TURNING,
          REMAINING: REMAINING_SLOPE, REMAINING_SLOPE: -REMAINING,
          SOIL_TURNING: SOIL_SLOPE, SOIL_SLOPE: -SOIL_TURNING}  # fmt: skip
