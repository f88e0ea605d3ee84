# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: a196eae2480eccdf1b8e9f62be193fda199abbe9730389517fb3d72eeb3652a0
"""Effects and friction laws that a scene may ask for, and the functions that serve them."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

INFINITY = float("inf")


@dataclass(frozen=True, slots=True)
class Parameter:
    """A number that an effect or a law needs: SI unit, open bounds, and how a scene file and the balance write it."""

    name: str
    unit: str
    lower: float
    upper: float
    help: str
    key: str
    per_unit: float
    symbol: str
    dimensionless: Callable[[float, Mapping[str, float]], float]
    optional: bool


@dataclass(frozen=True, slots=True)
class Law:
    """A friction law: equation, parameters, what it depends on, help; its length scale, and the slips of its kinks."""

    name: str
    equation: str
    parameters: tuple[Parameter, ...]
    depends_on: tuple[str, ...]
    help: str
    scale: str
    kinks: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Effect:
    """A term of the equation of motion: equation, parameters, what it depends on, help, whether the mass turns."""

    name: str
    equation: str
    parameters: tuple[Parameter, ...]
    depends_on: tuple[str, ...]
    help: str
    turns: bool


@dataclass(frozen=True, slots=True)
class Combination:
    """Functions in `generated.balance` of a combination of effects, by what they give, and their operations."""

    functions: Mapping[str, str]
    count: int
    operations: str


LAWS = {
    'constant': Law('constant', '1.14', (
        Parameter('coefficient', '', -5e-324, INFINITY, 'friction coefficient, tan(phi)', 'angle_deg', 1.0, '', lambda value, scales: value, False),
    ), (), 'friction does not change', '', ()),
    'exponential': Law('exponential', 'Fig. 4-1', (
        Parameter('peak', '', -5e-324, INFINITY, 'friction coefficient at the start', 'peak_deg', 1.0, '', lambda value, scales: value, False),
        Parameter('residual', '', -5e-324, INFINITY, 'friction coefficient after much slip', 'residual_deg', 1.0, '', lambda value, scales: value, False),
        Parameter('length', 'm', 0.0, INFINITY, 'slip over which friction falls', 'length_m', 1.0, '', lambda value, scales: value, False),
    ), ('slip',), 'residual + (peak - residual) exp(-slip/length)', 'length', ()),
    'linear': Law('linear', 'Fig. 4-1', (
        Parameter('peak', '', -5e-324, INFINITY, 'friction coefficient at the start', 'peak_deg', 1.0, '', lambda value, scales: value, False),
        Parameter('residual', '', -5e-324, INFINITY, 'friction coefficient after much slip', 'residual_deg', 1.0, '', lambda value, scales: value, False),
        Parameter('length', 'm', 0.0, INFINITY, 'slip over which friction falls', 'length_m', 1.0, '', lambda value, scales: value, False),
    ), ('slip',), 'falls from peak to residual over the length, then stays', 'length', ('length',)),
    'hyperbolic': Law('hyperbolic', 'Fig. 4-1', (
        Parameter('peak', '', -5e-324, INFINITY, 'friction coefficient at the start', 'peak_deg', 1.0, '', lambda value, scales: value, False),
        Parameter('residual', '', -5e-324, INFINITY, 'friction coefficient after much slip', 'residual_deg', 1.0, '', lambda value, scales: value, False),
        Parameter('length', 'm', 0.0, INFINITY, 'slip over which friction falls', 'length_m', 1.0, '', lambda value, scales: value, False),
    ), ('slip',), 'residual + (peak - residual)/(1 + slip/length)', 'length', ()),
    'tabulated': Law('tabulated', 'Fig. 4-1', (
        Parameter('slip', 'm', -5e-324, INFINITY, 'slips of the table, increasing, from 0', 'slip_m', 1.0, '', lambda value, scales: value, False),
        Parameter('coefficient', '', -5e-324, INFINITY, 'friction coefficients at these slips', 'angle_deg', 1.0, '', lambda value, scales: value, False),
    ), ('slip',), 'monotone cubic interpolation in a table, its last value beyond', '', ()),
}

EFFECTS = {
    'rotation': Effect('rotation', '1.2', (), ('slip',), 'the mass turns as it slides, and its weight acts in its new position', True),
    'centripetal': Effect('centripetal', '2.20', (), ('speed',), 'the mass presses harder on the slip surface the faster it turns', False),
    'pore_pressure': Effect('pore_pressure', '2.20', (
        Parameter('ratio', '', -5e-324, 1.0, 'r_u, pore pressure over the static normal stress at the position', 'ratio', 1.0, 'pore_ratio', lambda value, scales: value, True),
        Parameter('pressure', 'Pa', -5e-324, INFINITY, 'constant mean pore pressure on the slip surface', 'pressure_kPa', 1000.0, 'pore_pressure', lambda value, scales: value/scales['reference_stress'], True),
    ), (), 'water pressure on the slip surface relieves friction', False),
    'cohesion': Effect('cohesion', '3.11', (
        Parameter('cohesion', 'Pa', -5e-324, INFINITY, 'shear strength without normal stress', 'cohesion_kPa', 1000.0, 'cohesion', lambda value, scales: value/scales['reference_stress'], False),
    ), (), 'the slip surface has strength without normal stress', False),
    'drag': Effect('drag', '3.11', (
        Parameter('xi', 'm/s^2', 0.0, INFINITY, 'turbulence coefficient of Voellmy', 'xi_m_s2', 1.0, 'drag', lambda value, scales: 2*scales['gravity']*scales['half_angle']/(scales['Theta']*value), False),
    ), ('speed',), 'turbulent resistance, which grows with the square of the speed', False),
}

# Arguments of the functions in `generated.balance`.
ARGUMENTS: dict[str, tuple[str, ...]] = {
    'brake_centripetal': ('polar', 'mu'),
    'brake_centripetal_drag': ('polar', 'mu', 'drag'),
    'brake_drag': ('drag',),
    'constant_cohesion': ('level', 'cohesion'),
    'constant_pore_pressure': ('level', 'mu', 'pore_pressure'),
    'constant_pore_pressure_cohesion': ('level', 'mu', 'pore_pressure', 'cohesion'),
    'drive': ('press', 'mu', 'limit_friction'),
    'drive_pore_pressure': ('press', 'level', 'mu', 'pore_ratio', 'pore_pressure', 'limit_friction'),
    'drop_exponential': ('slip', 'more', 'peak', 'residual', 'length'),
    'drop_hyperbolic': ('slip', 'more', 'peak', 'residual', 'length'),
    'drop_linear': ('slip', 'more', 'peak', 'residual', 'length'),
    'effective_stress': ('press', 'level'),
    'effective_stress_centripetal': ('press', 'level', 'polar', 'omega_2'),
    'effective_stress_centripetal_pore_pressure': ('press', 'level', 'polar', 'omega_2', 'pore_ratio', 'pore_pressure'),
    'effective_stress_pore_pressure': ('press', 'level', 'pore_ratio', 'pore_pressure'),
    'energy': ('x', 'start', 'drive', 'tilt'),
    'energy_braked': ('x', 'start', 'drive', 'tilt', 'brake'),
    'energy_braked_constant': ('x', 'start', 'drive', 'tilt', 'constant', 'brake'),
    'energy_constant': ('x', 'start', 'drive', 'tilt', 'constant'),
    'energy_softening': ('x', 'start', 'drive', 'tilt', 'drop', 'decay', 'press', 'press_rise'),
    'energy_softening_constant': ('x', 'start', 'drive', 'tilt', 'constant', 'drop', 'decay', 'press', 'press_rise'),
    'energy_softening_constant_water': ('x', 'start', 'drive', 'tilt', 'constant', 'drop', 'decay', 'press', 'press_rise', 'water'),
    'friction_exponential': ('slip', 'peak', 'residual', 'length'),
    'friction_hyperbolic': ('slip', 'peak', 'residual', 'length'),
    'friction_linear': ('slip', 'peak', 'residual', 'length'),
    'frozen_braked_state': ('a', 'b', 'omega_0', 't'),
    'frozen_state': ('a', 'omega_0', 't'),
    'limit_friction': ('static_limit',),
    'limit_friction_cohesion': ('static_limit', 'press', 'level', 'cohesion'),
    'limit_friction_pore_pressure': ('static_limit', 'press', 'level', 'pore_ratio', 'pore_pressure'),
    'limit_friction_pore_pressure_cohesion': ('static_limit', 'press', 'level', 'pore_ratio', 'pore_pressure', 'cohesion'),
    'normal': ('press',),
    'normal_pore_pressure': ('press', 'level', 'pore_ratio', 'pore_pressure'),
    'normal_stress': ('press', 'level'),
    'normal_stress_centripetal': ('press', 'level', 'polar', 'omega_2'),
    'resistance': ('press', 'mu'),
    'resistance_centripetal': ('press', 'polar', 'mu', 'omega_2'),
    'resistance_centripetal_cohesion': ('press', 'level', 'polar', 'mu', 'omega_2', 'cohesion'),
    'resistance_centripetal_cohesion_drag': ('press', 'level', 'polar', 'mu', 'omega_2', 'cohesion', 'drag'),
    'resistance_centripetal_drag': ('press', 'polar', 'mu', 'omega_2', 'drag'),
    'resistance_centripetal_pore_pressure': ('press', 'level', 'polar', 'mu', 'omega_2', 'pore_ratio', 'pore_pressure'),
    'resistance_centripetal_pore_pressure_cohesion': ('press', 'level', 'polar', 'mu', 'omega_2', 'pore_ratio', 'pore_pressure', 'cohesion'),
    'resistance_centripetal_pore_pressure_cohesion_drag': ('press', 'level', 'polar', 'mu', 'omega_2', 'pore_ratio', 'pore_pressure', 'cohesion', 'drag'),
    'resistance_centripetal_pore_pressure_drag': ('press', 'level', 'polar', 'mu', 'omega_2', 'pore_ratio', 'pore_pressure', 'drag'),
    'resistance_cohesion': ('press', 'level', 'mu', 'cohesion'),
    'resistance_cohesion_drag': ('press', 'level', 'mu', 'omega_2', 'cohesion', 'drag'),
    'resistance_drag': ('press', 'mu', 'omega_2', 'drag'),
    'resistance_pore_pressure': ('press', 'level', 'mu', 'pore_ratio', 'pore_pressure'),
    'resistance_pore_pressure_cohesion': ('press', 'level', 'mu', 'pore_ratio', 'pore_pressure', 'cohesion'),
    'resistance_pore_pressure_cohesion_drag': ('press', 'level', 'mu', 'omega_2', 'pore_ratio', 'pore_pressure', 'cohesion', 'drag'),
    'resistance_pore_pressure_drag': ('press', 'level', 'mu', 'omega_2', 'pore_ratio', 'pore_pressure', 'drag'),
    'tilt': ('fall_slope', 'press_slope', 'mu'),
    'tilt_pore_pressure': ('fall_slope', 'press_slope', 'mu', 'pore_ratio'),
}

# Functions of each combination of effects, and the operations of one evaluation of all of them.
COMBINATIONS = {
    (): Combination({'normal': 'normal', 'limit_friction': 'limit_friction', 'drive': 'drive', 'resistance': 'resistance', 'effective_stress': 'effective_stress', 'normal_stress': 'normal_stress'}, 5, '2 mul, 1 sub, 2 div'),
    ('rotation',): Combination({'normal': 'normal', 'limit_friction': 'limit_friction', 'drive': 'drive', 'tilt': 'tilt', 'resistance': 'resistance', 'effective_stress': 'effective_stress', 'normal_stress': 'normal_stress', 'energy': 'energy', 'energy_softening': 'energy_softening'}, 17, '9 mul, 1 add, 3 sub, 2 div, 2 sin'),
    ('centripetal',): Combination({'normal': 'normal', 'limit_friction': 'limit_friction', 'drive': 'drive', 'brake': 'brake_centripetal', 'resistance': 'resistance_centripetal', 'effective_stress': 'effective_stress_centripetal', 'normal_stress': 'normal_stress_centripetal'}, 12, '6 mul, 3 add, 1 sub, 2 div'),
    ('pore_pressure',): Combination({'normal': 'normal_pore_pressure', 'limit_friction': 'limit_friction_pore_pressure', 'drive': 'drive_pore_pressure', 'constant': 'constant_pore_pressure', 'resistance': 'resistance_pore_pressure', 'effective_stress': 'effective_stress_pore_pressure', 'normal_stress': 'normal_stress'}, 30, '15 mul, 11 sub, 3 div, 1 neg'),
    ('cohesion',): Combination({'normal': 'normal', 'limit_friction': 'limit_friction_cohesion', 'drive': 'drive', 'constant': 'constant_cohesion', 'resistance': 'resistance_cohesion', 'effective_stress': 'effective_stress', 'normal_stress': 'normal_stress'}, 12, '6 mul, 1 add, 2 sub, 3 div'),
    ('drag',): Combination({'normal': 'normal', 'limit_friction': 'limit_friction', 'drive': 'drive', 'brake': 'brake_drag', 'resistance': 'resistance_drag', 'effective_stress': 'effective_stress', 'normal_stress': 'normal_stress'}, 7, '3 mul, 1 add, 1 sub, 2 div'),
    ('rotation', 'centripetal'): Combination({'normal': 'normal', 'limit_friction': 'limit_friction', 'drive': 'drive', 'brake': 'brake_centripetal', 'tilt': 'tilt', 'resistance': 'resistance_centripetal', 'effective_stress': 'effective_stress_centripetal', 'normal_stress': 'normal_stress_centripetal', 'energy': 'energy_braked'}, 130, '66 mul, 37 add, 5 sub, 5 div, 4 neg, 1 min, 1 max, 2 less, 3 select, 1 abs, 1 exp, 2 expm1, 2 sin'),
    ('rotation', 'pore_pressure'): Combination({'normal': 'normal_pore_pressure', 'limit_friction': 'limit_friction_pore_pressure', 'drive': 'drive_pore_pressure', 'tilt': 'tilt_pore_pressure', 'constant': 'constant_pore_pressure', 'resistance': 'resistance_pore_pressure', 'effective_stress': 'effective_stress_pore_pressure', 'normal_stress': 'normal_stress', 'energy': 'energy_constant', 'energy_softening': 'energy_softening_constant_water'}, 75, '41 mul, 13 add, 15 sub, 3 div, 1 neg, 2 sin'),
    ('rotation', 'cohesion'): Combination({'normal': 'normal', 'limit_friction': 'limit_friction_cohesion', 'drive': 'drive', 'tilt': 'tilt', 'constant': 'constant_cohesion', 'resistance': 'resistance_cohesion', 'effective_stress': 'effective_stress', 'normal_stress': 'normal_stress', 'energy': 'energy_constant', 'energy_softening': 'energy_softening_constant'}, 55, '31 mul, 14 add, 5 sub, 3 div, 2 sin'),
    ('rotation', 'drag'): Combination({'normal': 'normal', 'limit_friction': 'limit_friction', 'drive': 'drive', 'brake': 'brake_drag', 'tilt': 'tilt', 'resistance': 'resistance_drag', 'effective_stress': 'effective_stress', 'normal_stress': 'normal_stress', 'energy': 'energy_braked'}, 125, '63 mul, 35 add, 5 sub, 5 div, 4 neg, 1 min, 1 max, 2 less, 3 select, 1 abs, 1 exp, 2 expm1, 2 sin'),
    ('centripetal', 'pore_pressure'): Combination({'normal': 'normal_pore_pressure', 'limit_friction': 'limit_friction_pore_pressure', 'drive': 'drive_pore_pressure', 'brake': 'brake_centripetal', 'constant': 'constant_pore_pressure', 'resistance': 'resistance_centripetal_pore_pressure', 'effective_stress': 'effective_stress_centripetal_pore_pressure', 'normal_stress': 'normal_stress_centripetal'}, 37, '19 mul, 3 add, 11 sub, 3 div, 1 neg'),
    ('centripetal', 'cohesion'): Combination({'normal': 'normal', 'limit_friction': 'limit_friction_cohesion', 'drive': 'drive', 'brake': 'brake_centripetal', 'constant': 'constant_cohesion', 'resistance': 'resistance_centripetal_cohesion', 'effective_stress': 'effective_stress_centripetal', 'normal_stress': 'normal_stress_centripetal'}, 19, '10 mul, 4 add, 2 sub, 3 div'),
    ('centripetal', 'drag'): Combination({'normal': 'normal', 'limit_friction': 'limit_friction', 'drive': 'drive', 'brake': 'brake_centripetal_drag', 'resistance': 'resistance_centripetal_drag', 'effective_stress': 'effective_stress_centripetal', 'normal_stress': 'normal_stress_centripetal'}, 15, '7 mul, 5 add, 1 sub, 2 div'),
    ('pore_pressure', 'cohesion'): Combination({'normal': 'normal_pore_pressure', 'limit_friction': 'limit_friction_pore_pressure_cohesion', 'drive': 'drive_pore_pressure', 'constant': 'constant_pore_pressure_cohesion', 'resistance': 'resistance_pore_pressure_cohesion', 'effective_stress': 'effective_stress_pore_pressure', 'normal_stress': 'normal_stress'}, 34, '17 mul, 1 add, 13 sub, 3 div'),
    ('pore_pressure', 'drag'): Combination({'normal': 'normal_pore_pressure', 'limit_friction': 'limit_friction_pore_pressure', 'drive': 'drive_pore_pressure', 'brake': 'brake_drag', 'constant': 'constant_pore_pressure', 'resistance': 'resistance_pore_pressure_drag', 'effective_stress': 'effective_stress_pore_pressure', 'normal_stress': 'normal_stress'}, 32, '16 mul, 1 add, 11 sub, 3 div, 1 neg'),
    ('cohesion', 'drag'): Combination({'normal': 'normal', 'limit_friction': 'limit_friction_cohesion', 'drive': 'drive', 'brake': 'brake_drag', 'constant': 'constant_cohesion', 'resistance': 'resistance_cohesion_drag', 'effective_stress': 'effective_stress', 'normal_stress': 'normal_stress'}, 14, '7 mul, 2 add, 2 sub, 3 div'),
    ('rotation', 'centripetal', 'pore_pressure'): Combination({'normal': 'normal_pore_pressure', 'limit_friction': 'limit_friction_pore_pressure', 'drive': 'drive_pore_pressure', 'brake': 'brake_centripetal', 'tilt': 'tilt_pore_pressure', 'constant': 'constant_pore_pressure', 'resistance': 'resistance_centripetal_pore_pressure', 'effective_stress': 'effective_stress_centripetal_pore_pressure', 'normal_stress': 'normal_stress_centripetal', 'energy': 'energy_braked_constant'}, 170, '90 mul, 38 add, 18 sub, 6 div, 5 neg, 1 min, 1 max, 2 less, 3 select, 1 abs, 1 exp, 2 expm1, 2 sin'),
    ('rotation', 'centripetal', 'cohesion'): Combination({'normal': 'normal', 'limit_friction': 'limit_friction_cohesion', 'drive': 'drive', 'brake': 'brake_centripetal', 'tilt': 'tilt', 'constant': 'constant_cohesion', 'resistance': 'resistance_centripetal_cohesion', 'effective_stress': 'effective_stress_centripetal', 'normal_stress': 'normal_stress_centripetal', 'energy': 'energy_braked_constant'}, 150, '80 mul, 39 add, 8 sub, 6 div, 4 neg, 1 min, 1 max, 2 less, 3 select, 1 abs, 1 exp, 2 expm1, 2 sin'),
    ('rotation', 'centripetal', 'drag'): Combination({'normal': 'normal', 'limit_friction': 'limit_friction', 'drive': 'drive', 'brake': 'brake_centripetal_drag', 'tilt': 'tilt', 'resistance': 'resistance_centripetal_drag', 'effective_stress': 'effective_stress_centripetal', 'normal_stress': 'normal_stress_centripetal', 'energy': 'energy_braked'}, 133, '67 mul, 39 add, 5 sub, 5 div, 4 neg, 1 min, 1 max, 2 less, 3 select, 1 abs, 1 exp, 2 expm1, 2 sin'),
    ('rotation', 'pore_pressure', 'cohesion'): Combination({'normal': 'normal_pore_pressure', 'limit_friction': 'limit_friction_pore_pressure_cohesion', 'drive': 'drive_pore_pressure', 'tilt': 'tilt_pore_pressure', 'constant': 'constant_pore_pressure_cohesion', 'resistance': 'resistance_pore_pressure_cohesion', 'effective_stress': 'effective_stress_pore_pressure', 'normal_stress': 'normal_stress', 'energy': 'energy_constant', 'energy_softening': 'energy_softening_constant_water'}, 79, '43 mul, 14 add, 17 sub, 3 div, 2 sin'),
    ('rotation', 'pore_pressure', 'drag'): Combination({'normal': 'normal_pore_pressure', 'limit_friction': 'limit_friction_pore_pressure', 'drive': 'drive_pore_pressure', 'brake': 'brake_drag', 'tilt': 'tilt_pore_pressure', 'constant': 'constant_pore_pressure', 'resistance': 'resistance_pore_pressure_drag', 'effective_stress': 'effective_stress_pore_pressure', 'normal_stress': 'normal_stress', 'energy': 'energy_braked_constant'}, 165, '87 mul, 36 add, 18 sub, 6 div, 5 neg, 1 min, 1 max, 2 less, 3 select, 1 abs, 1 exp, 2 expm1, 2 sin'),
    ('rotation', 'cohesion', 'drag'): Combination({'normal': 'normal', 'limit_friction': 'limit_friction_cohesion', 'drive': 'drive', 'brake': 'brake_drag', 'tilt': 'tilt', 'constant': 'constant_cohesion', 'resistance': 'resistance_cohesion_drag', 'effective_stress': 'effective_stress', 'normal_stress': 'normal_stress', 'energy': 'energy_braked_constant'}, 145, '77 mul, 37 add, 8 sub, 6 div, 4 neg, 1 min, 1 max, 2 less, 3 select, 1 abs, 1 exp, 2 expm1, 2 sin'),
    ('centripetal', 'pore_pressure', 'cohesion'): Combination({'normal': 'normal_pore_pressure', 'limit_friction': 'limit_friction_pore_pressure_cohesion', 'drive': 'drive_pore_pressure', 'brake': 'brake_centripetal', 'constant': 'constant_pore_pressure_cohesion', 'resistance': 'resistance_centripetal_pore_pressure_cohesion', 'effective_stress': 'effective_stress_centripetal_pore_pressure', 'normal_stress': 'normal_stress_centripetal'}, 41, '21 mul, 4 add, 13 sub, 3 div'),
    ('centripetal', 'pore_pressure', 'drag'): Combination({'normal': 'normal_pore_pressure', 'limit_friction': 'limit_friction_pore_pressure', 'drive': 'drive_pore_pressure', 'brake': 'brake_centripetal_drag', 'constant': 'constant_pore_pressure', 'resistance': 'resistance_centripetal_pore_pressure_drag', 'effective_stress': 'effective_stress_centripetal_pore_pressure', 'normal_stress': 'normal_stress_centripetal'}, 40, '20 mul, 5 add, 11 sub, 3 div, 1 neg'),
    ('centripetal', 'cohesion', 'drag'): Combination({'normal': 'normal', 'limit_friction': 'limit_friction_cohesion', 'drive': 'drive', 'brake': 'brake_centripetal_drag', 'constant': 'constant_cohesion', 'resistance': 'resistance_centripetal_cohesion_drag', 'effective_stress': 'effective_stress_centripetal', 'normal_stress': 'normal_stress_centripetal'}, 22, '11 mul, 6 add, 2 sub, 3 div'),
    ('pore_pressure', 'cohesion', 'drag'): Combination({'normal': 'normal_pore_pressure', 'limit_friction': 'limit_friction_pore_pressure_cohesion', 'drive': 'drive_pore_pressure', 'brake': 'brake_drag', 'constant': 'constant_pore_pressure_cohesion', 'resistance': 'resistance_pore_pressure_cohesion_drag', 'effective_stress': 'effective_stress_pore_pressure', 'normal_stress': 'normal_stress'}, 36, '18 mul, 2 add, 13 sub, 3 div'),
    ('rotation', 'centripetal', 'pore_pressure', 'cohesion'): Combination({'normal': 'normal_pore_pressure', 'limit_friction': 'limit_friction_pore_pressure_cohesion', 'drive': 'drive_pore_pressure', 'brake': 'brake_centripetal', 'tilt': 'tilt_pore_pressure', 'constant': 'constant_pore_pressure_cohesion', 'resistance': 'resistance_centripetal_pore_pressure_cohesion', 'effective_stress': 'effective_stress_centripetal_pore_pressure', 'normal_stress': 'normal_stress_centripetal', 'energy': 'energy_braked_constant'}, 174, '92 mul, 39 add, 20 sub, 6 div, 4 neg, 1 min, 1 max, 2 less, 3 select, 1 abs, 1 exp, 2 expm1, 2 sin'),
    ('rotation', 'centripetal', 'pore_pressure', 'drag'): Combination({'normal': 'normal_pore_pressure', 'limit_friction': 'limit_friction_pore_pressure', 'drive': 'drive_pore_pressure', 'brake': 'brake_centripetal_drag', 'tilt': 'tilt_pore_pressure', 'constant': 'constant_pore_pressure', 'resistance': 'resistance_centripetal_pore_pressure_drag', 'effective_stress': 'effective_stress_centripetal_pore_pressure', 'normal_stress': 'normal_stress_centripetal', 'energy': 'energy_braked_constant'}, 173, '91 mul, 40 add, 18 sub, 6 div, 5 neg, 1 min, 1 max, 2 less, 3 select, 1 abs, 1 exp, 2 expm1, 2 sin'),
    ('rotation', 'centripetal', 'cohesion', 'drag'): Combination({'normal': 'normal', 'limit_friction': 'limit_friction_cohesion', 'drive': 'drive', 'brake': 'brake_centripetal_drag', 'tilt': 'tilt', 'constant': 'constant_cohesion', 'resistance': 'resistance_centripetal_cohesion_drag', 'effective_stress': 'effective_stress_centripetal', 'normal_stress': 'normal_stress_centripetal', 'energy': 'energy_braked_constant'}, 153, '81 mul, 41 add, 8 sub, 6 div, 4 neg, 1 min, 1 max, 2 less, 3 select, 1 abs, 1 exp, 2 expm1, 2 sin'),
    ('rotation', 'pore_pressure', 'cohesion', 'drag'): Combination({'normal': 'normal_pore_pressure', 'limit_friction': 'limit_friction_pore_pressure_cohesion', 'drive': 'drive_pore_pressure', 'brake': 'brake_drag', 'tilt': 'tilt_pore_pressure', 'constant': 'constant_pore_pressure_cohesion', 'resistance': 'resistance_pore_pressure_cohesion_drag', 'effective_stress': 'effective_stress_pore_pressure', 'normal_stress': 'normal_stress', 'energy': 'energy_braked_constant'}, 169, '89 mul, 37 add, 20 sub, 6 div, 4 neg, 1 min, 1 max, 2 less, 3 select, 1 abs, 1 exp, 2 expm1, 2 sin'),
    ('centripetal', 'pore_pressure', 'cohesion', 'drag'): Combination({'normal': 'normal_pore_pressure', 'limit_friction': 'limit_friction_pore_pressure_cohesion', 'drive': 'drive_pore_pressure', 'brake': 'brake_centripetal_drag', 'constant': 'constant_pore_pressure_cohesion', 'resistance': 'resistance_centripetal_pore_pressure_cohesion_drag', 'effective_stress': 'effective_stress_centripetal_pore_pressure', 'normal_stress': 'normal_stress_centripetal'}, 44, '22 mul, 6 add, 13 sub, 3 div'),
    ('rotation', 'centripetal', 'pore_pressure', 'cohesion', 'drag'): Combination({'normal': 'normal_pore_pressure', 'limit_friction': 'limit_friction_pore_pressure_cohesion', 'drive': 'drive_pore_pressure', 'brake': 'brake_centripetal_drag', 'tilt': 'tilt_pore_pressure', 'constant': 'constant_pore_pressure_cohesion', 'resistance': 'resistance_centripetal_pore_pressure_cohesion_drag', 'effective_stress': 'effective_stress_centripetal_pore_pressure', 'normal_stress': 'normal_stress_centripetal', 'energy': 'energy_braked_constant'}, 177, '93 mul, 41 add, 20 sub, 6 div, 4 neg, 1 min, 1 max, 2 less, 3 select, 1 abs, 1 exp, 2 expm1, 2 sin'),
}
