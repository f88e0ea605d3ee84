# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: a13a88291ee453f1aa1f81a389c839b25dea285aa0b25014be382f93d8970493
"""Effects and friction laws of scenes."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from numpy import sqrt

INFINITY = float("inf")


def _unscaled(value: float, scales: Mapping[str, float]) -> float:
    """Return the value of a parameter that has no place in the balance."""
    return value


@dataclass(frozen=True, slots=True)
class Parameter:
    """Number of a scene: name, SI unit, open bounds, meaning, key in scene files, and symbol in the balance.

    The key has a unit of ``per_unit`` SI units. ``kind`` is "number" or another kind of `derive.declare.effects`,
    ``allowed`` states the allowed values in messages, and ``axes`` is the number of axes of one value, 2 for points.
    """

    name: str
    unit: str = ""
    lower: float = -INFINITY
    upper: float = INFINITY
    help: str = ""
    key: str = ""
    per_unit: float = 1.0
    symbol: str = ""
    dimensionless: Callable[[float, Mapping[str, float]], float] = _unscaled
    optional: bool = False
    kind: str = "number"
    allowed: str = ""
    axes: int = 0

    def allows(self, values: Any) -> Any:
        """Return whether values in SI units are finite and within the bounds."""
        return (values > self.lower) & (values < self.upper)


@dataclass(frozen=True, slots=True)
class Law:
    """Friction law: source, parameters, variables on which it depends, and help."""

    name: str
    source: str
    parameters: tuple[Parameter, ...]
    depends_on: tuple[str, ...]
    help: str


@dataclass(frozen=True, slots=True)
class Effect:
    """Term of the equation of motion: source, parameters, variables on which it depends, help, and rotation.

    At least one parameter of ``any_of`` is needed. ``formulas`` say what it adds to the balance.
    """

    name: str
    source: str
    parameters: tuple[Parameter, ...]
    depends_on: tuple[str, ...]
    help: str
    turns: bool
    any_of: tuple[str, ...] = ()
    formulas: tuple[str, ...] = ()


LIMITS = {'': (1e-12, 1000000000000.0), 'm': (1e-13, 1e+20), 's': (1e-12, 1e+18), 'm/s': (1e-18, 300000000.0),
    'm/s^2': (1e-13, 1000000000000000.0), 'N/m^3': (0.001, 1000000000.0), 'Pa': (1e-09, 1000000000000000.0),
    'Pa/m': (1e-09, 1000000000000.0), 'Pa s': (1e-12, 1e+20), 'Pa/K': (1e-09, 1000000000000000.0), 'J/m^3 K': (0.001,
    1000000000000000.0)}  # between which what has a unit lies
LEAST = {'N/m^3': 1000.0, 'Pa': 50.0}  # less is questioned, but for 0
USUAL = {'N/m^3': (5000.0, 100000.0), 'Pa': (50.0, 100000000.0)}  # ranges that soils have
OTHER_UNITS = {'N/m^3': {'kN/m^3': 1000.0, 'kg/m^3': 9.81}, 'Pa': {'kPa': 1000.0, 'MPa': 1000000.0}}
USUAL_FRICTION = (0.0174550649282176, 10.0)
QUESTIONED_FRICTION = 2.0

LAWS = {
    'constant': Law('constant', '1.14', (
        Parameter('coefficient', '', -5e-324, 1000000000000.0, 'friction coefficient, tan(phi)', 'angle_deg', 1.0, '',
            lambda value, scales: value, False, 'number'),
    ), (), 'friction does not change'),
    'exponential': Law('exponential', 'Fig. 4-1', (
        Parameter('peak', '', -5e-324, 1000000000000.0, 'friction coefficient at the start', 'peak_deg', 1.0, '',
            lambda value, scales: value, False, 'number'),
        Parameter('residual', '', -5e-324, 1000000000000.0, 'friction coefficient after much slip', 'residual_deg', 1.0,
            '', lambda value, scales: value, False, 'number'),
        Parameter('length', 'm', 1e-13, 1e+20, 'slip over which friction falls', 'length_m', 1.0, '', lambda value,
            scales: value, False, 'number'),
    ), ('slip',), 'residual + (peak - residual) exp(-slip/length)'),
    'linear': Law('linear', 'Fig. 4-1', (
        Parameter('peak', '', -5e-324, 1000000000000.0, 'friction coefficient at the start', 'peak_deg', 1.0, '',
            lambda value, scales: value, False, 'number'),
        Parameter('residual', '', -5e-324, 1000000000000.0, 'friction coefficient after much slip', 'residual_deg', 1.0,
            '', lambda value, scales: value, False, 'number'),
        Parameter('length', 'm', 1e-13, 1e+20, 'slip over which friction falls', 'length_m', 1.0, '', lambda value,
            scales: value, False, 'number'),
    ), ('slip',), 'falls from peak to residual over the length, then stays'),
    'hyperbolic': Law('hyperbolic', 'Fig. 4-1', (
        Parameter('peak', '', -5e-324, 1000000000000.0, 'friction coefficient at the start', 'peak_deg', 1.0, '',
            lambda value, scales: value, False, 'number'),
        Parameter('residual', '', -5e-324, 1000000000000.0, 'friction coefficient after much slip', 'residual_deg', 1.0,
            '', lambda value, scales: value, False, 'number'),
        Parameter('length', 'm', 1e-13, 1e+20, 'slip over which friction falls', 'length_m', 1.0, '', lambda value,
            scales: value, False, 'number'),
    ), ('slip',), 'residual + (peak - residual)/(1 + slip/length)'),
    'tabulated': Law('tabulated', 'Fig. 4-1', (
        Parameter('slip', 'm', -5e-324, 1e+20, 'slips of the table, increasing, from 0', 'slip_m', 1.0, '',
            lambda value, scales: value, False, 'list'),
        Parameter('coefficient', '', -5e-324, 1000000000000.0, 'friction coefficients at these slips', 'angle_deg', 1.0,
            '', lambda value, scales: value, False, 'list'),
    ), ('slip',), 'monotone cubic interpolation in a table, its last value beyond'),
    'rate_weakening': Law('rate_weakening', '1.14', (
        Parameter('peak', '', -5e-324, 1000000000000.0, 'friction coefficient at rest', 'peak_deg', 1.0, '',
            lambda value, scales: value, False, 'number'),
        Parameter('residual', '', -5e-324, 1000000000000.0, 'friction coefficient at great speed', 'residual_deg', 1.0,
            '', lambda value, scales: value, False, 'number'),
        Parameter('velocity', 'm/s', 1e-18, 300000000.0, 'speed at which half of the change has happened',
            'velocity_m_s', 1.0, '', lambda value, scales: value, False, 'number'),
    ), ('speed',), 'residual + (peak - residual)/(1 + speed/velocity)'),
    'rate_tabulated': Law('rate_tabulated', '1.14', (
        Parameter('speed', 'm/s', 1e-18, 300000000.0, 'speeds of the table, increasing', 'speed_m_s', 1.0, '',
            lambda value, scales: value, False, 'list'),
        Parameter('coefficient', '', -5e-324, 1000000000000.0, 'friction coefficients at these speeds', 'angle_deg',
            1.0, '', lambda value, scales: value, False, 'list'),
    ), ('speed',), 'monotone cubic interpolation in the logarithm of the speed, the end values beyond'),
    'prescribed': Law('prescribed', '1.14', (
        Parameter('time', 's', -5e-324, 1e+18, 'times of the table, increasing', 'time_s', 1.0, '', lambda value,
            scales: value, False, 'list'),
        Parameter('coefficient', '', -5e-324, 1000000000000.0, 'friction coefficients at these times', 'angle_deg', 1.0,
            '', lambda value, scales: value, False, 'list'),
    ), ('time',), 'straight lines between the times of a table, the end values beyond'),
}

COHESION_LAWS = {  # of cohesion as a function of slip
    'constant': Law('constant', '1.14', (
        Parameter('cohesion', 'Pa', -5e-324, 1000000000000000.0, 'cohesion', 'cohesion_kPa', 1000.0, '', lambda value,
            scales: value, False, 'number'),
    ), (), 'cohesion does not change'),
    'exponential': Law('exponential', 'Fig. 4-1', (
        Parameter('peak', 'Pa', -5e-324, 1000000000000000.0, 'cohesion at the start', 'peak_kPa', 1000.0, '',
            lambda value, scales: value, False, 'number'),
        Parameter('residual', 'Pa', -5e-324, 1000000000000000.0, 'cohesion after much slip', 'residual_kPa', 1000.0, '',
            lambda value, scales: value, False, 'number'),
        Parameter('length', 'm', 1e-13, 1e+20, 'slip over which cohesion falls', 'length_m', 1.0, '', lambda value,
            scales: value, False, 'number'),
    ), ('slip',), 'residual + (peak - residual) exp(-slip/length)'),
    'linear': Law('linear', 'Fig. 4-1', (
        Parameter('peak', 'Pa', -5e-324, 1000000000000000.0, 'cohesion at the start', 'peak_kPa', 1000.0, '',
            lambda value, scales: value, False, 'number'),
        Parameter('residual', 'Pa', -5e-324, 1000000000000000.0, 'cohesion after much slip', 'residual_kPa', 1000.0, '',
            lambda value, scales: value, False, 'number'),
        Parameter('length', 'm', 1e-13, 1e+20, 'slip over which cohesion falls', 'length_m', 1.0, '', lambda value,
            scales: value, False, 'number'),
    ), ('slip',), 'falls from peak to residual over the length, then stays'),
    'hyperbolic': Law('hyperbolic', 'Fig. 4-1', (
        Parameter('peak', 'Pa', -5e-324, 1000000000000000.0, 'cohesion at the start', 'peak_kPa', 1000.0, '',
            lambda value, scales: value, False, 'number'),
        Parameter('residual', 'Pa', -5e-324, 1000000000000000.0, 'cohesion after much slip', 'residual_kPa', 1000.0, '',
            lambda value, scales: value, False, 'number'),
        Parameter('length', 'm', 1e-13, 1e+20, 'slip over which cohesion falls', 'length_m', 1.0, '', lambda value,
            scales: value, False, 'number'),
    ), ('slip',), 'residual + (peak - residual)/(1 + slip/length)'),
    'tabulated': Law('tabulated', 'Fig. 4-1', (
        Parameter('slip', 'm', -5e-324, 1e+20, 'slips of the table, increasing, from 0', 'slip_m', 1.0, '',
            lambda value, scales: value, False, 'list'),
        Parameter('cohesion', 'Pa', -5e-324, 1000000000000000.0, 'cohesions at these slips', 'cohesion_kPa', 1000.0, '',
            lambda value, scales: value, False, 'list'),
    ), ('slip',), 'monotone cubic interpolation in a table, its last value beyond'),
}

EFFECTS = {
    'rotation': Effect('rotation', '1.2', (), ('slip',),
        'the mass turns as it slides, and its weight acts in its new position', True, (), ('psi = psi_0 - phi',)),
    'centripetal': Effect('centripetal', '2.20', (), (),
        'the normal stress on the slip surface increases with the speed of rotation', False, (),
        ('adds A omega^2 to sigma',)),
    'pore_pressure': Effect('pore_pressure', '2.20', (
        Parameter('ratio', '', -5e-324, 1.0,
            'r_u, pore pressure over the static normal stress at the position (of a real section over the weight of '
            'the soil above), constant or a function of time', 'ratio', 1.0, 'pore_ratio', lambda value,
            scales: scales['cover']*value, True, 'series'),
        Parameter('pressure', 'Pa', -5e-324, 1000000000000000.0,
            'mean pore pressure on the slip surface, constant or a function of time', 'pressure_kPa', 1000.0,
            'pore_pressure', lambda value, scales: value/scales['reference_stress'], True, 'series'),
        Parameter('level', 'Pa', -5e-324, INFINITY,
            'mean pressure on the arc of a real section below its water level, which stays while the mass turns '
            'through it', '', 1.0, 'water', lambda value, scales: value/scales['reference_stress'], True, 'rotation'),
        Parameter('standing', '', -INFINITY, INFINITY, 'moment of the water that the mass displaces, over Theta*', '',
            1.0, 'standing_water', lambda value, scales: value, True, 'rotation'),
        Parameter('time', 's', -5e-324, 1e+18,
            'times of a ratio or pressure given as a list, with linear interpolation', 'time_s', 1.0, '', lambda value,
            scales: value, True, 'list'),
        Parameter('record', '', -INFINITY, INFINITY,
            "file of a record of either, relative to the scene's: a table of times and values", 'record', 1.0, '',
            lambda value, scales: value, True, 'text'),
        Parameter('units', '', -INFINITY, INFINITY,
            "unit of the record's values, if the file does not give it: Pa, kPa, MPa, or ratio for r_u", 'units', 1.0,
            '', lambda value, scales: value, True, 'text'),
        Parameter('start', 's', -1e+18, 1e+18, "time of its first sample, by default the record's own", 'start_s', 1.0,
            '', lambda value, scales: value, True, 'number'),
        Parameter('column', '', -INFINITY, INFINITY, "name or number of the record's column, where there is a choice",
            'column', 1.0, '', lambda value, scales: value, True, 'name'),
        Parameter('columns', '', -INFINITY, INFINITY,
            'roles of all columns of a table in place of its header: time,acceleration,skip', 'columns', 1.0, '',
            lambda value, scales: value, True, 'text'),
        Parameter('step', 's', -1e+18, 1e+18, 'time between samples of a record without times', 'step_s', 1.0, '',
            lambda value, scales: value, True, 'number'),
        Parameter('gaps', '', -INFINITY, INFINITY, 'missing samples: refused, or bridged by straight lines', 'gaps',
            1.0, '', lambda value, scales: value, True, 'refuse|linear'),
    ), ('time',), 'water pressure on the slip surface reduces friction', False, ('ratio', 'pressure', 'record'),
        ('adds J_r pore_ratio*/lambda + pore_pressure* + water* to u', 'adds -Theta standing_water to J_theta',
        'pore_ratio* = cover ratio', 'pore_pressure* = pressure/sigma_ref', 'water* = level/sigma_ref')),
    'cohesion': Effect('cohesion', '3.11', (
        Parameter('cohesion', 'Pa', -5e-324, 1000000000000000.0, 'shear strength without normal stress', 'cohesion_kPa',
            1000.0, 'cohesion', lambda value, scales: scales['strength_factor']*value/scales['reference_stress'], False,
            'number'),
        Parameter('gradient', 'Pa/m', -5e-324, 1000000000000.0,
            'growth of the cohesion per metre below datum_m, by default 0', 'cohesion_per_m_kPa', 1000.0, '',
            lambda value, scales: value, True, 'number'),
        Parameter('datum', 'm', -1e+20, 1e+20,
            'y below which the cohesion grows, by default the ground before the slide', 'datum_m', 1.0, '',
            lambda value, scales: value, True, 'fixed'),
        Parameter('depth', 'm', -5e-324, INFINITY,
            'mean depth of the slip surface below this height, or below the ground', '', 1.0, 'growing_cohesion',
            lambda value, scales: scales['gradient']*scales['strength_factor']*value/scales['reference_stress'], True,
            'rotation'),
    ), (), 'the slip surface has strength without normal stress', False, (),
        ('adds lambda (cohesion* + growing_cohesion*) to resistance', 'cohesion* = cohesion strength_factor/sigma_ref',
        'growing_cohesion* = depth gradient strength_factor/sigma_ref')),
    'drag': Effect('drag', '3.11', (
        Parameter('xi', 'm/s^2', 1e-13, 1000000000000000.0, 'turbulence coefficient of Voellmy', 'xi_m_s2', 1.0, 'drag',
            lambda value, scales: 2*scales['gravity']*scales['half_angle']/(scales['Theta']*value), False, 'number'),
    ), (), 'turbulent resistance, which grows with the square of the speed', False, (),
        ('adds Theta drag* omega^2 to resistance', 'drag* = 2 alpha g/(Theta xi)')),
    'viscosity': Effect('viscosity', '3.11', (
        Parameter('viscosity', 'Pa s', -5e-324, 1e+20, 'dynamic viscosity of the sheared layer', 'viscosity_Pa_s', 1.0,
            'viscosity', lambda value,
            scales: 2*scales['half_angle']*value/(scales['Theta']*scales['density']*scales['thickness']*
            sqrt(scales['gravity']*scales['radius'])), False, 'number'),
        Parameter('thickness', 'm', 1e-13, 1e+20, 'thickness of the sheared layer', 'thickness_m', 1.0, '',
            lambda value, scales: value, False, 'number'),
    ), ('speed',), 'viscous resistance of a sheared layer, which grows with the speed', False, (),
        ('adds Theta omega viscosity* to resistance',
        'viscosity* = 2 alpha viscosity/(Theta rho thickness sqrt(R g))')),
    'shaking': Effect('shaking', '3.11', (
        Parameter('horizontal', '', -INFINITY, INFINITY, 'k_h(t), driving acceleration over g, positive down-slope', '',
            1.0, 'k_h', lambda value, scales: value, True, 'series'),
        Parameter('vertical', '', -INFINITY, INFINITY, 'k_v(t), acceleration over g that reduces the effective weight',
            '', 1.0, 'k_v', lambda value, scales: value, True, 'series'),
        Parameter('pulse', '', -INFINITY, INFINITY, 'name of a pulse', 'pulse', 1.0, '', lambda value, scales: value,
            True, 'rectangular|half-sine|triangular|sine'),
        Parameter('amplitude', '', -1000000000000.0, 1000000000000.0, 'greatest k_h of the pulse, positive down-slope',
            'amplitude_g', 1.0, '', lambda value, scales: value, True, 'number'),
        Parameter('vertical_amplitude', '', -1000000000000.0, 1000000000000.0,
            'greatest k_v of the pulse, by default 0', 'vertical_amplitude_g', 1.0, '', lambda value, scales: value,
            True, 'number'),
        Parameter('start', 's', -1e+18, 1e+18, "time at which the shaking begins, by default 0 or the record's own",
            'start_s', 1.0, '', lambda value, scales: value, True, 'number'),
        Parameter('duration', 's', -1e+18, 1e+18, 'duration of the pulse', 'duration_s', 1.0, '', lambda value,
            scales: value, True, 'number'),
        Parameter('cycles', '', -1000000000000.0, 1000000000000.0, 'waves of a sine, by default 1', 'cycles', 1.0, '',
            lambda value, scales: value, True, 'number'),
        Parameter('record', '', -INFINITY, INFINITY, "file of an acceleration record, relative to the scene's",
            'record', 1.0, '', lambda value, scales: value, True, 'text'),
        Parameter('holds', '', -INFINITY, INFINITY,
            'content of the record, positive down-slope whichever way the slope faces: acceleration of the ground, or '
            'its opposite, which drives the mass', 'holds', 1.0, '', lambda value, scales: value, True,
            'ground|driving'),
        Parameter('units', '', -INFINITY, INFINITY,
            "unit of the record's values, if the file does not state it, such as g, m/s2, gal, ft/s2", 'units', 1.0, '',
            lambda value, scales: value, True, 'text'),
        Parameter('vertical_record', '', -INFINITY, INFINITY,
            'file of the vertical acceleration, positive upwards for that of the ground', 'vertical_record', 1.0, '',
            lambda value, scales: value, True, 'text'),
        Parameter('vertical_column', '', -INFINITY, INFINITY,
            'name or number of its column, by default in the same file', 'vertical_column', 1.0, '', lambda value,
            scales: value, True, 'name'),
        Parameter('scale', '', -1000000000000.0, 1000000000000.0, "factor on the record's values, by default 1",
            'scale', 1.0, '', lambda value, scales: value, True, 'number'),
        Parameter('peak', '', -1000000000000.0, 1000000000000.0,
            'greatest horizontal acceleration to which a record is scaled, in place of a factor', 'peak_g', 1.0, '',
            lambda value, scales: value, True, 'number'),
        Parameter('column', '', -INFINITY, INFINITY, "name or number of the record's column, where there is a choice",
            'column', 1.0, '', lambda value, scales: value, True, 'name'),
        Parameter('columns', '', -INFINITY, INFINITY,
            'roles of all columns of a table in place of its header: time,acceleration,skip', 'columns', 1.0, '',
            lambda value, scales: value, True, 'text'),
        Parameter('step', 's', -1e+18, 1e+18, 'time between samples of a record without times', 'step_s', 1.0, '',
            lambda value, scales: value, True, 'number'),
        Parameter('gaps', '', -INFINITY, INFINITY, 'missing samples: refused, or bridged by straight lines', 'gaps',
            1.0, '', lambda value, scales: value, True, 'refuse|linear'),
        Parameter('two_way', '', -INFINITY, INFINITY,
            'whether shaking may also start the mass up-slope; by default false', 'two_way', 1.0, '', lambda value,
            scales: value, True, 'flag'),
    ), ('time',), 'ground motion tilts and scales gravity', False, ('horizontal', 'pulse', 'record'),
        ('adds -J_theta k_v + dJ_theta/dpsi k_h to J_theta', 'adds -J_r k_v + dJ_r/dpsi k_h to J_r')),
    'thermal_pressurisation': Effect('thermal_pressurisation', '3.11', (
        Parameter('pressurisation', 'Pa/K', -5e-324, 1000000000000000.0,
            'Lambda, rise of the pore pressure in the undrained layer for each kelvin', 'pressurisation_MPa_K',
            1000000.0, 'kappa', lambda value,
            scales: scales['radius']*value/(scales['heat_capacity']*scales['thickness']), False, 'number'),
        Parameter('heat_capacity', 'J/m^3 K', 0.001, 1000000000000000.0, 'rho c, heat capacity of the layer by volume',
            'heat_capacity_MJ_m3_K', 1000000.0, '', lambda value, scales: value, False, 'number'),
        Parameter('thickness', 'm', 1e-13, 1e+20, 'thickness of the sheared layer', 'thickness_m', 1.0, '',
            lambda value, scales: value, False, 'number'),
    ), ('history',),
        'friction heats a thin layer, whose pore water expands and reduces its strength; undrained and adiabatic '
        '(neither water nor heat leaves the layer), as in slides of seconds to minutes on some millimetres of clay; '
        'one mean pressure and temperature, constant Lambda, and all work of friction is heat', False, (),
        ('adds excess to u', 'dexcess/dphi = kappa* max(0, sigma - u) mu',
        'kappa* = R pressurisation/(heat_capacity thickness)')),
}

ALL_EFFECTS = EFFECTS | {  # with what a section adds by itself
    'layered_strength': Effect('layered_strength', '2.23', (
        Parameter('turning', '', -INFINITY, INFINITY,
            "excess of friction's normal force over the mean, of strength with the mass", '', 1.0, 'turning',
            lambda value, scales: value, True, 'number'),
        Parameter('turning_slope', '', -INFINITY, INFINITY, 'its derivative by the dip', '', 1.0, 'turning_slope',
            lambda value, scales: value, True, 'number'),
        Parameter('normal', '', -INFINITY, INFINITY, 'the same of strength with the base', '', 1.0, 'layered_normal',
            lambda value, scales: value, True, 'rotation'),
        Parameter('normal_slope', '', -INFINITY, INFINITY, 'its derivative by the dip', '', 1.0, 'layered_normal_slope',
            lambda value, scales: value, True, 'rotation'),
        Parameter('inertia', '', -INFINITY, INFINITY, 'its increase by the square of the angular velocity', '', 1.0,
            'layered_inertia', lambda value, scales: value, True, 'rotation'),
        Parameter('lift', '', -INFINITY, INFINITY, 'its decrease by water', '', 1.0, 'layered_lift', lambda value,
            scales: value, True, 'rotation'),
        Parameter('remaining', '', -INFINITY, INFINITY,
            'excess of the friction that slip leaves, of strength with the mass', '', 1.0, 'remaining', lambda value,
            scales: scales['strength_factor']*value, True, 'number'),
        Parameter('remaining_slope', '', -INFINITY, INFINITY, 'its derivative by the dip', '', 1.0, 'remaining_slope',
            lambda value, scales: scales['strength_factor']*value, True, 'number'),
        Parameter('remaining_normal', '', -INFINITY, INFINITY, 'the same of strength with the base', '', 1.0,
            'layered_remaining', lambda value, scales: scales['strength_factor']*value, True, 'rotation'),
        Parameter('remaining_normal_slope', '', -INFINITY, INFINITY, 'its derivative by the dip', '', 1.0,
            'layered_remaining_slope', lambda value, scales: scales['strength_factor']*value, True, 'rotation'),
        Parameter('remaining_inertia', '', -INFINITY, INFINITY, 'its increase by the square of the angular velocity',
            '', 1.0, 'layered_remaining_inertia', lambda value, scales: scales['strength_factor']*value, True,
            'rotation'),
        Parameter('remaining_lift', '', -INFINITY, INFINITY, 'its decrease by water', '', 1.0, 'layered_remaining_lift',
            lambda value, scales: scales['strength_factor']*value, True, 'rotation'),
        Parameter('strength', '', -INFINITY, INFINITY, 'strength without normal stress', '', 1.0, 'layered_cohesion',
            lambda value, scales: scales['strength_factor']*value, True, 'rotation'),
    ), (), 'each soil along the arc has its strength, with the normal stress from the weight above it (2.23)', False,
        (), ('adds Theta (layered_lift + layered_remaining_lift*/slip_mu)/lambda to u',
        'adds Theta layered_cohesion* to resistance',
        'adds Theta (k_h (layered_normal_slope + turning_slope) + layered_inertia omega^2 + (1 - k_v) (layered_normal '
        '+ turning) + (k_h (layered_remaining_slope* + remaining_slope*) + layered_remaining_inertia* omega^2 + (1 - '
        'k_v) (layered_remaining* + remaining*))/slip_mu) to J_r', 'remaining* = remaining strength_factor',
        'remaining_slope* = remaining_slope strength_factor', 'layered_remaining* = remaining_normal strength_factor',
        'layered_remaining_slope* = remaining_normal_slope strength_factor',
        'layered_remaining_inertia* = remaining_inertia strength_factor',
        'layered_remaining_lift* = remaining_lift strength_factor', 'layered_cohesion* = strength strength_factor')),
    'soil_friction': Effect('soil_friction', '2.23', (
        Parameter('share', '', -INFINITY, INFINITY, 'share of the normal force at the start', '', 1.0, 'soil_share',
            lambda value, scales: value, True, 'number'),
        Parameter('turning', '', -INFINITY, INFINITY, 'excess of the normal force over this share, at the start 0', '',
            1.0, 'soil_turning', lambda value, scales: value, True, 'number'),
        Parameter('slope', '', -INFINITY, INFINITY, 'its derivative by the dip', '', 1.0, 'soil_slope', lambda value,
            scales: value, True, 'number'),
        Parameter('inertia', '', -INFINITY, INFINITY, 'its increase by the square of the angular velocity', '', 1.0,
            'soil_inertia', lambda value, scales: value, True, 'number'),
        Parameter('lift', '', -INFINITY, INFINITY, 'decrease of the normal force by water', '', 1.0, 'soil_lift',
            lambda value, scales: value, True, 'rotation'),
    ), (), 'a soil has a friction law of its own, and its part of the normal force; strength moves with the mass',
        False, (), ('adds Theta soil_lift soil_mu/(lambda slip_mu) to u',
        'adds Theta soil_mu (k_h soil_slope + omega^2 soil_inertia + soil_turning (1 - k_v))/slip_mu to J_r',
        'adds soil_mu soil_share to mu')),
    'softening_cohesion': Effect('softening_cohesion', '3.11', (
        Parameter('moment', '', -INFINITY, INFINITY, 'moment of 1 Pa', '', 1.0, 'soft_share', lambda value,
            scales: scales['strength_factor']*value, True, 'rotation'),
        Parameter('gradient', '', -INFINITY, INFINITY, 'moment of the growth of 1 Pa per metre', '', 1.0, '',
            lambda value, scales: value, True, 'number'),
        Parameter('depth', '', -INFINITY, INFINITY, 'mean depth, m', '', 1.0, 'soft_depth', lambda value,
            scales: scales['gradient']*scales['strength_factor']*value, True, 'rotation'),
    ), (), 'strength without normal stress changes with slip', False, (),
        ('adds Theta cohesion_law (soft_depth* + soft_share*) to resistance', 'soft_share* = moment strength_factor',
        'soft_depth* = depth gradient strength_factor')),
}
