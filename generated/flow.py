# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: 936e5b363d0291d8bc0da944ebb9395559b7ee925e589f9c9914d19619311973
"""The balance of momentum, as fragments of flow programs: what each effect and each law adds, as operations.

In dimensionless numbers, time t sqrt(g/R), angular velocity omega sqrt(R/g), stresses over sigma_ref:

    Theta domega/dt = M - s (T + lambda mu max(0, sigma - u)),  s = sgn(omega)
    M            += J_theta                                  gravity
    sigma        += J_r/lambda                               gravity
    J_theta      =  J_theta0 cos(phi) - J_theta0' sin(phi)   rotation
    J_r          =  J_r0 cos(phi) - J_r0' sin(phi)           rotation
    J_theta'     =  J_theta0 sin(phi) + J_theta0' cos(phi)   rotation
    J_r'         =  J_r0 sin(phi) + J_r0' cos(phi)           rotation
    sigma        += A omega^2                                centripetal
    u            += pore_pressure                            pore_pressure
    u            += water                                    pore_pressure
    u            += J_r pore_ratio/lambda                    pore_pressure
    T            += cohesion lambda                          cohesion
    T            += Theta drag omega^2                       drag
    T            += Theta omega viscosity                    viscosity
    M            += -J_theta k_v                             shaking
    M            += J_theta' k_h                             shaking
    sigma        += -J_r k_v/lambda                          shaking
    sigma        += J_r' k_h/lambda                          shaking
    u            += excess                                   thermal_pressurisation
    dexcess/dphi =  kappa max(0, sigma - u) mu               thermal_pressurisation

Fragments are joined to a scene's program by the names of what they make and take. ``..._0`` is a number where the phase
began and ``d...`` the series of its increment since; ``=1.0`` is a constant.
"""

from collections.abc import Callable
from typing import Any, NamedTuple


class Fragment(NamedTuple):
    """Formulas in words; operations on numbers where a phase begins, operations on series, and what they add.

    ``adds`` gives for each quantity of the balance its base, the size of the base's terms, and its increment as a sum
    of (number, series). ``inputs`` are what a scene gives, over the scales of the arc; ``optional`` ones may be
    omitted. ``states`` are series with those of their rates. Each of ``tables`` has its name, is of slip, speed,
    rotation or time, with the series of its argument (of time, its own) and the degree of its pieces.
    """

    words: tuple[str, ...]
    inputs: tuple[str, ...]
    optional: tuple[str, ...]
    scalar: tuple[tuple[str, ...], ...]
    series: tuple[tuple[object, ...], ...]
    adds: dict[str, tuple[str, str, tuple[tuple[str, str], ...]]]
    states: tuple[tuple[str, str], ...] = ()
    tables: tuple[tuple[str, str, str, int], ...] = ()


# The names of an operation's results and arguments, and the operations that make the tangents of its results: a prime
# marks a tangent, other names are for what is made on the way.
Tangents = tuple[tuple[str, ...], tuple[tuple[object, ...], ...]]

# Numbers that every scene gives.
INPUTS = {
    'driving_moment': 'J_theta/Theta* of the weight at the start',
    'driving_moment_slope': 'its derivative by psi',
    'normal_load': 'J_r/Theta* of the weight at the start',
    'normal_load_slope': 'its derivative by psi',
    'resistance_factor': 'lambda/Theta*',
    'polar_moment': 'I_p*/Theta*',
}

# Laws of slip in pieces: their scale, where pieces begin over it, and their polynomials in what is beyond.
PIECES: dict[str, tuple[str, tuple[float, ...], Callable[..., Any]]] = {
    'linear': ('length', (0.0, 1.0), lambda peak, residual, **_: ((peak, -peak + residual), (residual, 0.0))),
}

# Operations that make the tangent of a cell.
CELL_TANGENTS: dict[str, Tangents] = {
    'add': (('d', 'a', 'b', 'e'), (('add', "d'", "a'", "b'"),)),
    'sub': (('d', 'a', 'b', 'e'), (('sub', "d'", "a'", "b'"),)),
    'mul': (('d', 'a', 'b', 'e'), (('mul', '*.t4', 'a', "b'"), ('mul', '*.t5', "a'", 'b'), ('add', "d'", '*.t4',
        '*.t5'))),
    'div': (('d', 'a', 'b', 'e'), (('div', '*.t4', "a'", 'b'), ('mul', '*.t5', 'b', 'b'), ('div', '*.t6', 'a', '*.t5'),
        ('mul', '*.t7', '*.t6', "b'"), ('sub', "d'", '*.t4', '*.t7'))),
    'neg': (('d', 'a', 'b', 'e'), (('neg', "d'", "a'"),)),
    'sin': (('d', 'a', 'b', 'e'), (('cos', '*.t2', 'a'), ('mul', "d'", '*.t2', "a'"))),
    'cos': (('d', 'a', 'b', 'e'), (('sin', '*.t2', 'a'), ('mul', '*.t3', '*.t2', "a'"), ('neg', "d'", '*.t3'))),
    'tan': (('d', 'a', 'b', 'e'), (('tan', '*.t3', 'a'), ('mul', '*.t4', '*.t3', '*.t3'), ('add', '*.t5', '=1.0',
        '*.t4'), ('mul', "d'", '*.t5', "a'"))),
    'exp': (('d', 'a', 'b', 'e'), (('exp', '*.t2', 'a'), ('mul', "d'", '*.t2', "a'"))),
    'expm1': (('d', 'a', 'b', 'e'), (('exp', '*.t2', 'a'), ('mul', "d'", '*.t2', "a'"))),
    'log': (('d', 'a', 'b', 'e'), (('div', "d'", "a'", 'a'),)),
    'log1p': (('d', 'a', 'b', 'e'), (('add', '*.t3', '=1.0', 'a'), ('div', "d'", "a'", '*.t3'))),
    'sqrt': (('d', 'a', 'b', 'e'), (('sqrt', '*.t3', 'a'), ('div', '*.t4', '=0.5', '*.t3'), ('mul', "d'", '*.t4',
        "a'"))),
    'abs': (('d', 'a', 'b', 'e'), (('neg', '*.t3', "a'"), ('less', '*.t4', 'a', '=0.0'), ('select', "d'", '*.t4',
        '*.t3', "a'"))),
    'min': (('d', 'a', 'b', 'e'), (('less', '*.t4', 'a', 'b'), ('select', "d'", '*.t4', "a'", "b'"))),
    'max': (('d', 'a', 'b', 'e'), (('less', '*.t4', 'a', 'b'), ('select', "d'", '*.t4', "b'", "a'"))),
    'less': (('d', 'a', 'b', 'e'), (('less', '*.t3', 'a', 'b'), ('select', "d'", '*.t3', '=0.0', '=0.0'))),
    'select': (('d', 'a', 'b', 'e'), (('less', '*.t4', '=0.0', 'a'), ('select', "d'", '*.t4', "b'", "e'"))),
}

# Operations that make the tangents of a register.
SERIES_TANGENTS: dict[str, Tangents] = {
    'mul': (('d', 'a', 'b'), (('mul', "a*b'", 'a', "b'"), ('mul', "a'*b", "a'", 'b'), ('lin', "d'", '', (('=1.0',
        "a*b'"), ('=1.0', "a'*b"))))),
    'sqr': (('d', 'a'), (('mul', "a*a'", 'a', "a'"), ('lin', "d'", '', (('=2.0', "a*a'"),)))),
    'tim': (('q', 'a'), (('tim', "q'", "a'"),)),
    'turn': (('s', 'v', 'q', 'x'), (('mul', "v*x'", 'v', "x'"), ('lin', "s'", '', (('=-1.0', "v*x'"), ('=1.0', "x'"))),
        ('mul', "s*x'", 's', "x'"), ('lin', "v'", '', (('=1.0', "s*x'"),)))),
    'exp': (('e', 'm', 'q', 'z'), (('mul', "e*z'", 'e', "z'"), ('lin', "e'", '', (('=1.0', "e*z'"),)), ('lin', "m'", '',
        (('=1.0', "e*z'"),)))),
    'rec': (('h', 'm', 'z'), (('sqr', 'h*h', 'h'), ('mul', "h*h*z'", 'h*h', "z'"), ('lin', "h'", '', (('=-1.0',
        "h*h*z'"),)), ('lin', "m'", '', (('=-1.0', "h*h*z'"),)))),
    'log': (('l', 'z'), (('rec', 'h', '*.h_less_1', 'z'), ('mul', "h*z'", 'h', "z'"), ('lin', "l'", '', (('=1.0',
        "h*z'"),)))),
    'pow': (('p', 'm', 'z', 'power'), (('rec', 'h', '*.h_less_1', 'z'), ('log', 'l', 'z'), ('mul', 'h*p', 'h', 'p'),
        ('mul', "h*p*z'", 'h*p', "z'"), ('mul', 'l*p', 'l', 'p'), ('lin', "p'", '', (('power', "h*p*z'"), ("power'",
        'l*p'))), ('lin', "m'", '', (('power', "h*p*z'"), ("power'", 'l*p'))))),
}

# Parts of programs.
FRAGMENTS: dict[str, Fragment] = {
    'gravity': Fragment(
        words=(
            '(3.11) driving = J_theta/Theta*, pressing = J_r/Theta*, in the direction of travel',
        ),
        inputs=(),
        optional=(),
        scalar=(
            ('mul', 'driving_moment_0', 'DIRECTION', 'driving_moment'),
            ('mul', 'normal_load_slope_0', 'DIRECTION', 'normal_load_slope'),
            ('mul', 'turning_slope_0', 'DIRECTION', 'turning_slope'),
            ('mul', 'remaining_slope_0', 'DIRECTION', 'remaining_slope'),
            ('abs', 'gravity.driving_size', 'driving_moment_0'),
            ('neg', 'gravity.10', 'driving_moment_slope_0'),
            ('neg', 'gravity.11', 'driving_moment_0'),
            ('abs', 'gravity.pressing_size', 'normal_load_0'),
            ('neg', 'gravity.14', 'normal_load_slope_0'),
            ('neg', 'gravity.15', 'normal_load_0'),
            ('set', 'driving_moment_slope_0', 'driving_moment_slope'),
            ('set', 'normal_load_0', 'normal_load'),
            ('set', 'turning_0', 'turning'),
            ('set', 'remaining_0', 'remaining'),
            ('set', 'gravity.driving', 'driving_moment_0'),
            ('set', 'gravity.pressing', 'normal_load_0'),
        ),
        series=(),
        adds={
            'driving': ('gravity.driving', 'gravity.driving_size', (('gravity.10', 'sin(x)'), ('gravity.11',
                'vers(x)'))),
            'pressing': ('gravity.pressing', 'gravity.pressing_size', (('gravity.14', 'sin(x)'), ('gravity.15',
                'vers(x)'))),
        },
        states=(),
        tables=(),
    ),
    'rotation': Fragment(
        words=(
            '(1.2) the mass turns as it slides, and its weight acts in its new position',
            'psi = psi_0 - phi',
            "q(psi - x) = q - q vers x - q' sin x, of J_theta, J_r and their slopes",
        ),
        inputs=(),
        optional=(),
        scalar=(
            ('cos', 'rotation.t12', 'ROTATION'),
            ('mul', 'rotation.t13', 'rotation.t12', 'driving_moment'),
            ('sin', 'rotation.t14', 'ROTATION'),
            ('mul', 'rotation.t15', 'rotation.t14', 'driving_moment_slope'),
            ('sub', 'rotation.t16', 'rotation.t13', 'rotation.t15'),
            ('mul', 'driving_moment_0', 'rotation.t16', 'DIRECTION'),
            ('mul', 'rotation.t18', 'rotation.t14', 'driving_moment'),
            ('mul', 'rotation.t19', 'rotation.t12', 'driving_moment_slope'),
            ('add', 'driving_moment_slope_0', 'rotation.t18', 'rotation.t19'),
            ('mul', 'rotation.t21', 'rotation.t12', 'normal_load'),
            ('mul', 'rotation.t22', 'rotation.t14', 'normal_load_slope'),
            ('sub', 'normal_load_0', 'rotation.t21', 'rotation.t22'),
            ('mul', 'rotation.t24', 'rotation.t14', 'normal_load'),
            ('mul', 'rotation.t25', 'rotation.t12', 'normal_load_slope'),
            ('add', 'rotation.t26', 'rotation.t24', 'rotation.t25'),
            ('mul', 'normal_load_slope_0', 'rotation.t26', 'DIRECTION'),
            ('mul', 'rotation.t28', 'rotation.t12', 'turning'),
            ('mul', 'rotation.t29', 'rotation.t14', 'turning_slope'),
            ('sub', 'turning_0', 'rotation.t28', 'rotation.t29'),
            ('mul', 'rotation.t31', 'rotation.t14', 'turning'),
            ('mul', 'rotation.t32', 'rotation.t12', 'turning_slope'),
            ('add', 'rotation.t33', 'rotation.t31', 'rotation.t32'),
            ('mul', 'turning_slope_0', 'rotation.t33', 'DIRECTION'),
            ('mul', 'rotation.t35', 'rotation.t12', 'remaining'),
            ('mul', 'rotation.t36', 'rotation.t14', 'remaining_slope'),
            ('sub', 'remaining_0', 'rotation.t35', 'rotation.t36'),
            ('mul', 'rotation.t38', 'rotation.t14', 'remaining'),
            ('mul', 'rotation.t39', 'rotation.t12', 'remaining_slope'),
            ('add', 'rotation.t40', 'rotation.t38', 'rotation.t39'),
            ('mul', 'remaining_slope_0', 'rotation.t40', 'DIRECTION'),
            ('neg', 'rotation.8', 'normal_load_slope_0'),
            ('neg', 'rotation.9', 'normal_load_0'),
        ),
        series=(
            ('tim', 'x.times', 'x'),
            ('turn', 'sin(x)', 'vers(x)', 'x.times', 'x'),
            ('lin', 'upright', 'normal_load_0', (('rotation.8', 'sin(x)'), ('rotation.9', 'vers(x)'))),
        ),
        adds={},
        states=(),
        tables=(),
    ),
    'centripetal': Fragment(
        words=(
            '(2.20) the mass presses harder on the slip surface the faster it turns',
            'adds A omega^2 to sigma',
        ),
        inputs=(),
        optional=(),
        scalar=(
            ('set', 'centripetal.pressing', '=0.0'),
            ('set', 'centripetal.pressing_size', '=0.0'),
        ),
        series=(
            ('sqr', 'omega*omega', 'omega'),
        ),
        adds={
            'pressing': ('centripetal.pressing', 'centripetal.pressing_size', (('polar_moment', 'omega*omega'),)),
        },
        states=(),
        tables=(),
    ),
    'pore_pressure': Fragment(
        words=(
            '(2.20) water pressure on the slip surface relieves friction',
            'adds J_r pore_ratio*/lambda + pore_pressure* + water* to u',
            'pore_ratio* = cover ratio',
            'pore_pressure* = pressure/sigma_ref',
            'water* = level/sigma_ref',
        ),
        inputs=('pore_ratio', 'pore_pressure'),
        optional=('pore_ratio', 'pore_pressure'),
        scalar=(
            ('mul', 'pore_pressure.t13', 'normal_load_0', 'pore_ratio'),
            ('mul', 'pore_pressure.t14', 'pore_pressure', 'resistance_factor'),
            ('add', 'pore_pressure.t15', 'pore_pressure.t13', 'pore_pressure.t14'),
            ('mul', 'pore_pressure.t16', 'resistance_factor', 'water'),
            ('add', 'pore_pressure.lifting', 'pore_pressure.t15', 'pore_pressure.t16'),
            ('abs', 'pore_pressure.t18', 'pore_pressure.t13'),
            ('abs', 'pore_pressure.t19', 'pore_pressure.t14'),
            ('add', 'pore_pressure.t20', 'pore_pressure.t18', 'pore_pressure.t19'),
            ('abs', 'pore_pressure.t21', 'pore_pressure.t16'),
            ('add', 'pore_pressure.lifting_size', 'pore_pressure.t20', 'pore_pressure.t21'),
            ('neg', 'pore_pressure.2', 'normal_load_slope_0'),
            ('neg', 'pore_pressure.3', 'normal_load_0'),
            ('mul', 'pore_pressure.t25', 'normal_load_slope_0', 'pore_ratio'),
            ('neg', 'pore_pressure.4', 'pore_pressure.t25'),
            ('neg', 'pore_pressure.5', 'pore_pressure.t13'),
            ('mul', 'pore_pressure.6', 'resistance_factor', 'water.Q1'),
            ('mul', 'pore_pressure.7', 'resistance_factor', 'water.Q2'),
            ('mul', 'pore_pressure.8', 'resistance_factor', 'water.Q3'),
            ('mul', 'pore_pressure.9', 'resistance_factor', 'water.Q4'),
            ('mul', 'pore_pressure.10', 'resistance_factor', 'water.Q5'),
            ('mul', 'pore_pressure.11', 'resistance_factor', 'water.Q6'),
            ('mul', 'pore_pressure.12', 'resistance_factor', 'water.Q7'),
        ),
        series=(
            ('mul', 'dpore_ratio*sin(x)', 'dpore_ratio', 'sin(x)'),
            ('mul', 'dpore_ratio*vers(x)', 'dpore_ratio', 'vers(x)'),
            ('sqr', 'x*x', 'x'),
            ('mul', 'x*x*x', 'x*x', 'x'),
            ('mul', 'x*x*x*x', 'x*x*x', 'x'),
            ('mul', 'x*x*x*x*x', 'x*x*x*x', 'x'),
            ('mul', 'x*x*x*x*x*x', 'x*x*x*x*x', 'x'),
            ('mul', 'x*x*x*x*x*x*x', 'x*x*x*x*x*x', 'x'),
        ),
        adds={
            'lifting': ('pore_pressure.lifting', 'pore_pressure.lifting_size', (('resistance_factor', 'dpore_pressure'),
                ('normal_load_0', 'dpore_ratio'), ('pore_pressure.2', 'dpore_ratio*sin(x)'), ('pore_pressure.3',
                'dpore_ratio*vers(x)'), ('pore_pressure.4', 'sin(x)'), ('pore_pressure.5', 'vers(x)'),
                ('pore_pressure.6', 'x'), ('pore_pressure.7', 'x*x'), ('pore_pressure.8', 'x*x*x'), ('pore_pressure.9',
                'x*x*x*x'), ('pore_pressure.10', 'x*x*x*x*x'), ('pore_pressure.11', 'x*x*x*x*x*x'), ('pore_pressure.12',
                'x*x*x*x*x*x*x'))),
        },
        states=(),
        tables=(('water', 'rotation', 'x', 7),),
    ),
    'cohesion': Fragment(
        words=(
            '(3.11) the slip surface has strength without normal stress',
            'adds cohesion* lambda to resistance',
            'cohesion* = cohesion/sigma_ref',
        ),
        inputs=('cohesion',),
        optional=(),
        scalar=(
            ('mul', 'cohesion.resisting', 'cohesion', 'resistance_factor'),
            ('abs', 'cohesion.resisting_size', 'cohesion.resisting'),
        ),
        series=(),
        adds={
            'resisting': ('cohesion.resisting', 'cohesion.resisting_size', ()),
        },
        states=(),
        tables=(),
    ),
    'drag': Fragment(
        words=(
            '(3.11) turbulent resistance, which grows with the square of the speed',
            'adds Theta drag* omega^2 to resistance',
            'drag* = 2 alpha g/(Theta xi)',
        ),
        inputs=('drag',),
        optional=(),
        scalar=(
            ('set', 'drag.resisting', '=0.0'),
            ('set', 'drag.resisting_size', '=0.0'),
        ),
        series=(
            ('sqr', 'omega*omega', 'omega'),
        ),
        adds={
            'resisting': ('drag.resisting', 'drag.resisting_size', (('drag', 'omega*omega'),)),
        },
        states=(),
        tables=(),
    ),
    'viscosity': Fragment(
        words=(
            '(3.11) viscous resistance of a sheared layer, which grows with the speed',
            'adds Theta omega viscosity* to resistance',
            'viscosity* = 2 alpha viscosity/(Theta rho thickness sqrt(R g))',
        ),
        inputs=('viscosity',),
        optional=(),
        scalar=(
            ('set', 'viscosity.resisting', '=0.0'),
            ('set', 'viscosity.resisting_size', '=0.0'),
        ),
        series=(),
        adds={
            'resisting': ('viscosity.resisting', 'viscosity.resisting_size', (('viscosity', 'omega'),)),
        },
        states=(),
        tables=(),
    ),
    'shaking': Fragment(
        words=(
            '(3.11) ground motion tilts and scales gravity',
            'adds -J_theta k_v + dJ_theta/dpsi k_h to J_theta',
            'adds -J_r k_v + dJ_r/dpsi k_h to J_r',
        ),
        inputs=('k_h', 'k_v'),
        optional=('k_h', 'k_v'),
        scalar=(
            ('mul', 'shaking.2', 'DIRECTION', 'driving_moment_slope_0'),
            ('mul', 'shaking.t8', 'shaking.2', 'k_h'),
            ('mul', 'shaking.t9', 'driving_moment_0', 'k_v'),
            ('sub', 'shaking.driving', 'shaking.t8', 'shaking.t9'),
            ('abs', 'shaking.t11', 'shaking.t9'),
            ('abs', 'shaking.t12', 'shaking.t8'),
            ('add', 'shaking.driving_size', 'shaking.t11', 'shaking.t12'),
            ('mul', 'shaking.3', 'DIRECTION', 'driving_moment_0'),
            ('neg', 'shaking.4', 'shaking.2'),
            ('neg', 'shaking.5', 'driving_moment_0'),
            ('mul', 'shaking.t17', 'driving_moment_slope_0', 'k_v'),
            ('mul', 'shaking.t18', 'shaking.3', 'k_h'),
            ('add', 'shaking.6', 'shaking.t17', 'shaking.t18'),
            ('sub', 'shaking.7', 'shaking.t9', 'shaking.t8'),
            ('mul', 'shaking.t21', 'DIRECTION', 'k_h'),
            ('mul', 'shaking.t22', 'shaking.t21', 'normal_load_slope_0'),
            ('mul', 'shaking.t23', 'k_v', 'normal_load_0'),
            ('sub', 'shaking.pressing', 'shaking.t22', 'shaking.t23'),
            ('abs', 'shaking.t25', 'shaking.t23'),
            ('abs', 'shaking.t26', 'shaking.t22'),
            ('add', 'shaking.pressing_size', 'shaking.t25', 'shaking.t26'),
            ('mul', 'shaking.10', 'DIRECTION', 'normal_load_slope_0'),
            ('mul', 'shaking.11', 'DIRECTION', 'normal_load_0'),
            ('neg', 'shaking.12', 'shaking.10'),
            ('neg', 'shaking.13', 'normal_load_0'),
            ('mul', 'shaking.t32', 'k_v', 'normal_load_slope_0'),
            ('mul', 'shaking.t33', 'shaking.t21', 'normal_load_0'),
            ('add', 'shaking.14', 'shaking.t32', 'shaking.t33'),
            ('sub', 'shaking.15', 'shaking.t23', 'shaking.t22'),
        ),
        series=(
            ('mul', 'dk_h*sin(x)', 'dk_h', 'sin(x)'),
            ('mul', 'dk_h*vers(x)', 'dk_h', 'vers(x)'),
            ('mul', 'dk_v*sin(x)', 'dk_v', 'sin(x)'),
            ('mul', 'dk_v*vers(x)', 'dk_v', 'vers(x)'),
        ),
        adds={
            'driving': ('shaking.driving', 'shaking.driving_size', (('shaking.2', 'dk_h'), ('shaking.3', 'dk_h*sin(x)'),
                ('shaking.4', 'dk_h*vers(x)'), ('shaking.5', 'dk_v'), ('driving_moment_slope_0', 'dk_v*sin(x)'),
                ('driving_moment_0', 'dk_v*vers(x)'), ('shaking.6', 'sin(x)'), ('shaking.7', 'vers(x)'))),
            'pressing': ('shaking.pressing', 'shaking.pressing_size', (('shaking.10', 'dk_h'), ('shaking.11',
                'dk_h*sin(x)'), ('shaking.12', 'dk_h*vers(x)'), ('shaking.13', 'dk_v'), ('normal_load_slope_0',
                'dk_v*sin(x)'), ('normal_load_0', 'dk_v*vers(x)'), ('shaking.14', 'sin(x)'), ('shaking.15',
                'vers(x)'))),
        },
        states=(),
        tables=(),
    ),
    'thermal_pressurisation': Fragment(
        words=(
            '(3.11) friction heats a thin layer, whose pore water expands and relieves it; undrained (no water leaves '
                'the layer) and adiabatic (no heat does), as in a slide of seconds to minutes on millimetres of clay '
                'or more; one mean pressure and temperature, constant Lambda, and all work of friction is heat',
            'adds excess to u',
            "dexcess/dphi = kappa* mu sigma'",
            'kappa* = R pressurisation/(heat_capacity thickness)',
        ),
        inputs=('kappa',),
        optional=(),
        scalar=(
            ('neg', 'excess_less', 'excess'),
            ('neg', 'excess_0', 'excess_less'),
            ('mul', 'thermal_pressurisation.lifting', 'excess_0', 'resistance_factor'),
            ('abs', 'thermal_pressurisation.lifting_size', 'thermal_pressurisation.lifting'),
            ('div', 'thermal_pressurisation.4', 'kappa', 'resistance_factor'),
        ),
        series=(
            ('lin', 'dexcess', 'excess_less', (('=1.0', 'excess'),)),
            ('mul', 'friction*omega', 'friction', 'omega'),
            ('lin', 'thermal_pressurisation.sum1', '', (('thermal_pressurisation.4', 'friction*omega'),)),
        ),
        adds={
            'lifting': ('thermal_pressurisation.lifting', 'thermal_pressurisation.lifting_size', (('resistance_factor',
                'dexcess'),)),
        },
        states=(('excess', 'thermal_pressurisation.sum1'),),
        tables=(),
    ),
    'layered_strength': Fragment(
        words=(
            '(2.23) soils along the arc have strengths of their own, by the weights of (2.23) straight above each',
            'adds Theta layered_lift/lambda to u',
            'adds Theta (layered_cohesion + layered_remaining + layered_remaining_inertia omega^2 + remaining) to '
                'resistance',
            'adds Theta (layered_inertia omega^2 + layered_normal + turning) to J_r',
        ),
        inputs=('turning', 'turning_slope', 'remaining', 'remaining_slope'),
        optional=('turning', 'turning_slope', 'remaining', 'remaining_slope'),
        scalar=(
            ('add', 'layered_strength.t22', 'layered_cohesion', 'layered_remaining'),
            ('add', 'layered_strength.resisting', 'layered_strength.t22', 'remaining_0'),
            ('abs', 'layered_strength.t24', 'layered_cohesion'),
            ('abs', 'layered_strength.t25', 'layered_remaining'),
            ('add', 'layered_strength.t26', 'layered_strength.t24', 'layered_strength.t25'),
            ('abs', 'layered_strength.t27', 'remaining_0'),
            ('add', 'layered_strength.resisting_size', 'layered_strength.t26', 'layered_strength.t27'),
            ('neg', 'layered_strength.2', 'remaining_slope_0'),
            ('neg', 'layered_strength.3', 'remaining_0'),
            ('add', 'layered_strength.4', 'layered_cohesion.Q1', 'layered_remaining.Q1'),
            ('add', 'layered_strength.5', 'layered_cohesion.Q2', 'layered_remaining.Q2'),
            ('add', 'layered_strength.6', 'layered_cohesion.Q3', 'layered_remaining.Q3'),
            ('add', 'layered_strength.7', 'layered_cohesion.Q4', 'layered_remaining.Q4'),
            ('add', 'layered_strength.8', 'layered_cohesion.Q5', 'layered_remaining.Q5'),
            ('add', 'layered_strength.9', 'layered_cohesion.Q6', 'layered_remaining.Q6'),
            ('add', 'layered_strength.10', 'layered_cohesion.Q7', 'layered_remaining.Q7'),
            ('add', 'layered_strength.pressing', 'layered_normal', 'turning_0'),
            ('abs', 'layered_strength.t39', 'layered_normal'),
            ('abs', 'layered_strength.t40', 'turning_0'),
            ('add', 'layered_strength.pressing_size', 'layered_strength.t39', 'layered_strength.t40'),
            ('neg', 'layered_strength.13', 'turning_slope_0'),
            ('neg', 'layered_strength.14', 'turning_0'),
            ('abs', 'layered_strength.lifting_size', 'layered_lift'),
            ('set', 'layered_strength.lifting', 'layered_lift'),
        ),
        series=(
            ('sqr', 'omega*omega', 'omega'),
            ('mul', 'omega*omega*x', 'omega*omega', 'x'),
            ('mul', 'omega*omega*x*x', 'omega*omega*x', 'x'),
            ('mul', 'omega*omega*x*x*x', 'omega*omega*x*x', 'x'),
            ('mul', 'omega*omega*x*x*x*x', 'omega*omega*x*x*x', 'x'),
            ('mul', 'omega*omega*x*x*x*x*x', 'omega*omega*x*x*x*x', 'x'),
            ('mul', 'omega*omega*x*x*x*x*x*x', 'omega*omega*x*x*x*x*x', 'x'),
            ('mul', 'omega*omega*x*x*x*x*x*x*x', 'omega*omega*x*x*x*x*x*x', 'x'),
            ('sqr', 'x*x', 'x'),
            ('mul', 'x*x*x', 'x*x', 'x'),
            ('mul', 'x*x*x*x', 'x*x*x', 'x'),
            ('mul', 'x*x*x*x*x', 'x*x*x*x', 'x'),
            ('mul', 'x*x*x*x*x*x', 'x*x*x*x*x', 'x'),
            ('mul', 'x*x*x*x*x*x*x', 'x*x*x*x*x*x', 'x'),
        ),
        adds={
            'resisting': ('layered_strength.resisting', 'layered_strength.resisting_size',
                (('layered_remaining_inertia', 'omega*omega'), ('layered_remaining_inertia.Q1', 'omega*omega*x'),
                ('layered_remaining_inertia.Q2', 'omega*omega*x*x'), ('layered_remaining_inertia.Q3',
                'omega*omega*x*x*x'), ('layered_remaining_inertia.Q4', 'omega*omega*x*x*x*x'),
                ('layered_remaining_inertia.Q5', 'omega*omega*x*x*x*x*x'), ('layered_remaining_inertia.Q6',
                'omega*omega*x*x*x*x*x*x'), ('layered_remaining_inertia.Q7', 'omega*omega*x*x*x*x*x*x*x'),
                ('layered_strength.2', 'sin(x)'), ('layered_strength.3', 'vers(x)'), ('layered_strength.4', 'x'),
                ('layered_strength.5', 'x*x'), ('layered_strength.6', 'x*x*x'), ('layered_strength.7', 'x*x*x*x'),
                ('layered_strength.8', 'x*x*x*x*x'), ('layered_strength.9', 'x*x*x*x*x*x'), ('layered_strength.10',
                'x*x*x*x*x*x*x'))),
            'pressing': ('layered_strength.pressing', 'layered_strength.pressing_size', (('layered_inertia',
                'omega*omega'), ('layered_inertia.Q1', 'omega*omega*x'), ('layered_inertia.Q2', 'omega*omega*x*x'),
                ('layered_inertia.Q3', 'omega*omega*x*x*x'), ('layered_inertia.Q4', 'omega*omega*x*x*x*x'),
                ('layered_inertia.Q5', 'omega*omega*x*x*x*x*x'), ('layered_inertia.Q6', 'omega*omega*x*x*x*x*x*x'),
                ('layered_inertia.Q7', 'omega*omega*x*x*x*x*x*x*x'), ('layered_strength.13', 'sin(x)'),
                ('layered_strength.14', 'vers(x)'), ('layered_normal.Q1', 'x'), ('layered_normal.Q2', 'x*x'),
                ('layered_normal.Q3', 'x*x*x'), ('layered_normal.Q4', 'x*x*x*x'), ('layered_normal.Q5', 'x*x*x*x*x'),
                ('layered_normal.Q6', 'x*x*x*x*x*x'), ('layered_normal.Q7', 'x*x*x*x*x*x*x'))),
            'lifting': ('layered_strength.lifting', 'layered_strength.lifting_size', (('layered_lift.Q1', 'x'),
                ('layered_lift.Q2', 'x*x'), ('layered_lift.Q3', 'x*x*x'), ('layered_lift.Q4', 'x*x*x*x'),
                ('layered_lift.Q5', 'x*x*x*x*x'), ('layered_lift.Q6', 'x*x*x*x*x*x'), ('layered_lift.Q7',
                'x*x*x*x*x*x*x'))),
        },
        states=(),
        tables=(('layered_normal', 'rotation', 'x', 7), ('layered_inertia', 'rotation', 'x', 7), ('layered_lift',
            'rotation', 'x', 7), ('layered_remaining', 'rotation', 'x', 7), ('layered_remaining_inertia', 'rotation',
            'x', 7), ('layered_cohesion', 'rotation', 'x', 7)),
    ),
    'constant': Fragment(
        words=(
            '(1.14) friction does not change',
            'mu = coefficient',
        ),
        inputs=('constant.coefficient',),
        optional=(),
        scalar=(
            ('abs', 'constant.mu_size', 'constant.coefficient'),
            ('set', 'constant.mu', 'constant.coefficient'),
        ),
        series=(),
        adds={
            'mu': ('constant.mu', 'constant.mu_size', ()),
        },
        states=(),
        tables=(),
    ),
    'exponential': Fragment(
        words=(
            '(Fig. 4-1) residual + (peak - residual) exp(-slip/length)',
            'mu = residual + (peak - residual)*exp(-slip/length)',
        ),
        inputs=('exponential.peak', 'exponential.residual', 'exponential.length'),
        optional=(),
        scalar=(
            ('div', 'exponential.t5', '=1.0', 'exponential.length'),
            ('neg', 'exponential.0', 'exponential.t5'),
            ('div', 'exponential.t8', 'SLIP', 'exponential.length'),
            ('neg', 'exponential.t9', 'exponential.t8'),
            ('exp', 'exponential.t10', 'exponential.t9'),
            ('sub', 'exponential.t11', 'exponential.peak', 'exponential.residual'),
            ('abs', 'exponential.t12', 'exponential.t11'),
            ('mul', 'exponential.t13', '=1.0000000000009095', 'exponential.t10'),
            ('mul', 'exponential.t14', 'exponential.t13', 'exponential.t12'),
            ('abs', 'exponential.t15', 'exponential.residual'),
            ('mul', 'exponential.t16', '=1.0000000000009095', 'exponential.t15'),
            ('add', 'exponential.t17', 'exponential.t14', 'exponential.t16'),
            ('abs', 'exponential.t18', 'exponential.peak'),
            ('expm1', 'exponential.t19', 'exponential.t9'),
            ('mul', 'exponential.t20', 'exponential.t11', 'exponential.t19'),
            ('abs', 'exponential.t21', 'exponential.t20'),
            ('add', 'exponential.t22', 'exponential.t18', 'exponential.t21'),
            ('mul', 'exponential.3', 'exponential.t11', 'exponential.t10'),
            ('add', 'exponential.t24', 'exponential.residual', 'exponential.3'),
            ('add', 'exponential.t25', 'exponential.peak', 'exponential.t20'),
            ('less', 'exponential.t26', 'exponential.t17', 'exponential.t22'),
            ('select', 'exponential.mu', 'exponential.t26', 'exponential.t24', 'exponential.t25'),
            ('mul', 'exponential.t28', 'exponential.t10', 'exponential.t12'),
            ('add', 'exponential.t29', 'exponential.t28', 'exponential.t15'),
            ('min', 'exponential.mu_size', 'exponential.t22', 'exponential.t29'),
        ),
        series=(
            ('lin', 'exponential.sum1', '', (('exponential.0', 'x'),)),
            ('tim', 'exponential.sum1.times', 'exponential.sum1'),
            ('exp', 'exponential.exp2', 'exponential.exp2_less_1', 'exponential.sum1.times', 'exponential.sum1'),
        ),
        adds={
            'mu': ('exponential.mu', 'exponential.mu_size', (('exponential.3', 'exponential.exp2_less_1'),)),
        },
        states=(),
        tables=(),
    ),
    'linear': Fragment(
        words=(
            '(Fig. 4-1) falls from peak to residual over the length, then stays',
            'mu = VALUE + Q1 y + Q2 y^2 + ..., y = x',
        ),
        inputs=(),
        optional=(),
        scalar=(
            ('abs', 'linear.mu_size', 'linear.VALUE'),
            ('set', 'linear.mu', 'linear.VALUE'),
        ),
        series=(),
        adds={
            'mu': ('linear.mu', 'linear.mu_size', (('linear.Q1', 'x'),)),
        },
        states=(),
        tables=(('linear', 'slip', 'x', 1),),
    ),
    'hyperbolic': Fragment(
        words=(
            '(Fig. 4-1) residual + (peak - residual)/(1 + slip/length)',
            'mu = residual + (peak - residual)/(1 + slip/length)',
        ),
        inputs=('hyperbolic.peak', 'hyperbolic.residual', 'hyperbolic.length'),
        optional=(),
        scalar=(
            ('div', 'hyperbolic.t5', 'SLIP', 'hyperbolic.length'),
            ('add', 'hyperbolic.t6', '=1.0', 'hyperbolic.t5'),
            ('mul', 'hyperbolic.t7', 'hyperbolic.length', 'hyperbolic.t6'),
            ('div', 'hyperbolic.0', '=1.0', 'hyperbolic.t7'),
            ('abs', 'hyperbolic.t10', 'hyperbolic.residual'),
            ('mul', 'hyperbolic.t11', '=1.0000000000009095', 'hyperbolic.t10'),
            ('sub', 'hyperbolic.t12', 'hyperbolic.peak', 'hyperbolic.residual'),
            ('div', 'hyperbolic.3', 'hyperbolic.t12', 'hyperbolic.t6'),
            ('abs', 'hyperbolic.t14', 'hyperbolic.3'),
            ('mul', 'hyperbolic.t15', '=1.0000000000009095', 'hyperbolic.t14'),
            ('add', 'hyperbolic.t16', 'hyperbolic.t11', 'hyperbolic.t15'),
            ('abs', 'hyperbolic.t17', 'hyperbolic.peak'),
            ('div', 'hyperbolic.t18', 'hyperbolic.t12', 'hyperbolic.t7'),
            ('mul', 'hyperbolic.t19', 'hyperbolic.t18', 'SLIP'),
            ('abs', 'hyperbolic.t20', 'hyperbolic.t19'),
            ('add', 'hyperbolic.t21', 'hyperbolic.t17', 'hyperbolic.t20'),
            ('add', 'hyperbolic.t22', 'hyperbolic.residual', 'hyperbolic.3'),
            ('sub', 'hyperbolic.t23', 'hyperbolic.peak', 'hyperbolic.t19'),
            ('less', 'hyperbolic.t24', 'hyperbolic.t16', 'hyperbolic.t21'),
            ('select', 'hyperbolic.mu', 'hyperbolic.t24', 'hyperbolic.t22', 'hyperbolic.t23'),
            ('add', 'hyperbolic.t26', 'hyperbolic.t10', 'hyperbolic.t14'),
            ('min', 'hyperbolic.mu_size', 'hyperbolic.t21', 'hyperbolic.t26'),
        ),
        series=(
            ('lin', 'hyperbolic.sum1', '', (('hyperbolic.0', 'x'),)),
            ('rec', 'hyperbolic.rec2', 'hyperbolic.rec2_less_1', 'hyperbolic.sum1'),
        ),
        adds={
            'mu': ('hyperbolic.mu', 'hyperbolic.mu_size', (('hyperbolic.3', 'hyperbolic.rec2_less_1'),)),
        },
        states=(),
        tables=(),
    ),
    'tabulated': Fragment(
        words=(
            '(Fig. 4-1) monotone cubic interpolation in a table, its last value beyond',
            'mu = VALUE + Q1 y + Q2 y^2 + ..., y = x',
        ),
        inputs=(),
        optional=(),
        scalar=(
            ('abs', 'tabulated.mu_size', 'tabulated.VALUE'),
            ('set', 'tabulated.mu', 'tabulated.VALUE'),
        ),
        series=(
            ('sqr', 'x*x', 'x'),
            ('mul', 'x*x*x', 'x*x', 'x'),
        ),
        adds={
            'mu': ('tabulated.mu', 'tabulated.mu_size', (('tabulated.Q1', 'x'), ('tabulated.Q2', 'x*x'),
                ('tabulated.Q3', 'x*x*x'))),
        },
        states=(),
        tables=(('tabulated', 'slip', 'x', 3),),
    ),
    'rate_weakening': Fragment(
        words=(
            '(1.14) residual + (peak - residual)/(1 + speed/velocity)',
            'mu = residual + (peak - residual)/(speed/velocity + 1)',
        ),
        inputs=('rate_weakening.peak', 'rate_weakening.residual', 'rate_weakening.velocity'),
        optional=(),
        scalar=(
            ('div', 'rate_weakening.0', '=1.0', 'rate_weakening.velocity'),
            ('abs', 'rate_weakening.mu_size', 'rate_weakening.peak'),
            ('sub', 'rate_weakening.3', 'rate_weakening.peak', 'rate_weakening.residual'),
            ('set', 'rate_weakening.mu', 'rate_weakening.peak'),
        ),
        series=(
            ('lin', 'rate_weakening.sum1', '', (('rate_weakening.0', 'omega'),)),
            ('rec', 'rate_weakening.rec2', 'rate_weakening.rec2_less_1', 'rate_weakening.sum1'),
        ),
        adds={
            'mu': ('rate_weakening.mu', 'rate_weakening.mu_size', (('rate_weakening.3',
                'rate_weakening.rec2_less_1'),)),
        },
        states=(),
        tables=(),
    ),
    'rate_tabulated': Fragment(
        words=(
            '(1.14) monotone cubic interpolation in the logarithm of the speed, the end values beyond',
            'mu = VALUE + Q1 y + Q2 y^2 + ..., y = log(omega/omega_0)',
        ),
        inputs=(),
        optional=(),
        scalar=(
            ('less', 'rate_tabulated.t7', '=0.0', 'rate_tabulated.PIECE'),
            ('select', 'beyond', 'rate_tabulated.t7', '=1.0', '=0.0'),
            ('less', 'rate_tabulated.t9', '=0.0', 'beyond'),
            ('select', 'start_speed', 'rate_tabulated.t9', 'omega', '=1.0'),
            ('neg', 'rate_tabulated.2', 'beyond'),
            ('div', 'rate_tabulated.3', 'beyond', 'start_speed'),
            ('abs', 'rate_tabulated.mu_size', 'rate_tabulated.VALUE'),
            ('set', 'rate_tabulated.mu', 'rate_tabulated.VALUE'),
        ),
        series=(
            ('lin', 'relative_speed', 'rate_tabulated.2', (('rate_tabulated.3', 'omega'),)),
            ('log', 'log_speed', 'relative_speed'),
            ('sqr', 'log_speed*log_speed', 'log_speed'),
            ('mul', 'log_speed*log_speed*log_speed', 'log_speed*log_speed', 'log_speed'),
        ),
        adds={
            'mu': ('rate_tabulated.mu', 'rate_tabulated.mu_size', (('rate_tabulated.Q1', 'log_speed'),
                ('rate_tabulated.Q2', 'log_speed*log_speed'), ('rate_tabulated.Q3', 'log_speed*log_speed*log_speed'))),
        },
        states=(),
        tables=(('rate_tabulated', 'speed', 'log_speed', 3),),
    ),
    'prescribed': Fragment(
        words=(
            '(1.14) straight lines between the times of a table, the end values beyond',
        ),
        inputs=(),
        optional=(),
        scalar=(
            ('abs', 'prescribed.mu_size', 'prescribed.VALUE'),
            ('set', 'prescribed.mu', 'prescribed.VALUE'),
        ),
        series=(),
        adds={
            'mu': ('prescribed.mu', 'prescribed.mu_size', (('=1.0', 'dprescribed'),)),
        },
        states=(),
        tables=(('prescribed', 'time', 'dprescribed', 0),),
    ),
    'callable': Fragment(
        words=(
            '(1.14) a function of the slip, in pieces',
            'mu = VALUE + Q1 y + Q2 y^2 + ..., y = x',
        ),
        inputs=(),
        optional=(),
        scalar=(
            ('abs', 'callable.mu_size', 'callable.VALUE'),
            ('set', 'callable.mu', 'callable.VALUE'),
        ),
        series=(
            ('sqr', 'x*x', 'x'),
            ('mul', 'x*x*x', 'x*x', 'x'),
            ('mul', 'x*x*x*x', 'x*x*x', 'x'),
            ('mul', 'x*x*x*x*x', 'x*x*x*x', 'x'),
            ('mul', 'x*x*x*x*x*x', 'x*x*x*x*x', 'x'),
            ('mul', 'x*x*x*x*x*x*x', 'x*x*x*x*x*x', 'x'),
        ),
        adds={
            'mu': ('callable.mu', 'callable.mu_size', (('callable.Q1', 'x'), ('callable.Q2', 'x*x'), ('callable.Q3',
                'x*x*x'), ('callable.Q4', 'x*x*x*x'), ('callable.Q5', 'x*x*x*x*x'), ('callable.Q6', 'x*x*x*x*x*x'),
                ('callable.Q7', 'x*x*x*x*x*x*x'))),
        },
        states=(),
        tables=(('callable', 'slip', 'x', 7),),
    ),
    'product': Fragment(
        words=(
            'mu = mu(slip) mu(speed)',
        ),
        inputs=(),
        optional=(),
        scalar=(
            ('mul', 'product.mu', 'rate_mu_0', 'slip_mu_0'),
            ('abs', 'product.mu_size', 'product.mu'),
        ),
        series=(
            ('mul', 'drate_mu*dslip_mu', 'drate_mu', 'dslip_mu'),
        ),
        adds={
            'mu': ('product.mu', 'product.mu_size', (('slip_mu_0', 'drate_mu'), ('=1.0', 'drate_mu*dslip_mu'),
                ('rate_mu_0', 'dslip_mu'))),
        },
        states=(),
        tables=(),
    ),
    'balance': Fragment(
        words=(
            '(3.11) d omega*/dt* = net = driving - resisting - friction, friction = mu normal unless the mass is '
                'lifted',
            'normal = pressing - lifting; net = drive + dnet, where drive is net where the phase began, at no speed',
            'drive = normal (limit - mu) as at the start; drive_scale is the rounding of its terms',
        ),
        inputs=(),
        optional=(),
        scalar=(
            ('sub', 'grip', '=1.0', 'LIFTED'),
            ('sub', 'normal_0', 'pressing_0', 'lifting_0'),
            ('mul', 'balance.4', 'grip', 'mu_0'),
            ('mul', 'friction_0', 'balance.4', 'normal_0'),
            ('mul', 'balance.3', 'grip', 'normal_0'),
            ('sub', 'balance.t29', 'driving_0', 'resisting_0'),
            ('div', 'limit_0', 'balance.t29', 'normal_0'),
            ('sub', 'balance.t31', 'driving_0', 'driving_moment_0'),
            ('abs', 'balance.t32', 'balance.t31'),
            ('add', 'balance.t33', 'resisting_0', 'balance.t32'),
            ('sub', 'balance.t34', 'normal_0', 'normal_load_0'),
            ('abs', 'balance.t35', 'balance.t34'),
            ('add', 'others', 'balance.t33', 'balance.t35'),
            ('less', 'balance.t38', '=0.0', 'others'),
            ('select', 'limit', 'balance.t38', 'limit_0', 'LIMIT'),
            ('sub', 'gap', 'limit', 'mu_0'),
            ('less', 'balance.t41', '=0.0', 'balance.t29'),
            ('select', 'balance.t42', 'balance.t41', '=1.0', '=0.0'),
            ('mul', 'balance.t43', 'balance.t42', 'grip'),
            ('less', 'balance.t44', '=0.0', 'departed'),
            ('select', 'first', 'balance.t44', '=0.0', 'balance.t43'),
            ('mul', 'balance.t46', 'gap', 'normal_0'),
            ('sub', 'balance.t47', 'driving_0', 'friction_0'),
            ('sub', 'balance.t48', 'balance.t47', 'resisting_0'),
            ('less', 'balance.t49', '=0.0', 'first'),
            ('select', 'drive', 'balance.t49', 'balance.t46', 'balance.t48'),
            ('abs', 'balance.t52', 'drive'),
            ('add', 'balance.t53', 'driving_size', 'resisting_size'),
            ('add', 'balance.t54', 'lifting_size', 'pressing_size'),
            ('mul', 'balance.t55', 'balance.t54', 'grip'),
            ('mul', 'balance.t56', 'balance.t55', 'mu_0'),
            ('add', 'balance.t57', 'balance.t53', 'balance.t56'),
            ('select', 'balance.t58', 'balance.t49', 'balance.t52', 'balance.t57'),
            ('mul', 'drive_scale', '=2.220446049250313e-16', 'balance.t58'),
        ),
        series=(
            ('lin', 'dnormal', '', (('=-1.0', 'dlifting'), ('=1.0', 'dpressing'))),
            ('lin', 'normal', 'normal_0', (('=1.0', 'dnormal'),)),
            ('mul', 'dmu*dnormal', 'dmu', 'dnormal'),
            ('lin', 'dfriction', '', (('balance.3', 'dmu'), ('grip', 'dmu*dnormal'), ('balance.4', 'dnormal'))),
            ('lin', 'friction', 'friction_0', (('=1.0', 'dfriction'),)),
            ('lin', 'driving', 'driving_0', (('=1.0', 'ddriving'),)),
            ('lin', 'resisting', 'resisting_0', (('=1.0', 'dresisting'),)),
            ('lin', 'pressing', 'pressing_0', (('=1.0', 'dpressing'),)),
            ('lin', 'lifting', 'lifting_0', (('=1.0', 'dlifting'),)),
            ('lin', 'mu', 'mu_0', (('=1.0', 'dmu'),)),
            ('lin', 'dnet', '', (('=1.0', 'ddriving'), ('=-1.0', 'dfriction'), ('=-1.0', 'dresisting'))),
            ('lin', 'net', 'drive', (('=1.0', 'dnet'),)),
        ),
        adds={},
        states=(),
        tables=(),
    ),
    'energy': Fragment(
        words=(
            'dwork/dt* = driving omega*, ddissipation/dt* = (resisting + friction) omega*, over Theta*',
        ),
        inputs=(),
        optional=(),
        scalar=(),
        series=(
            ('lin', 'brakes', '', (('=1.0', 'friction'), ('=1.0', 'resisting'))),
            ('mul', 'driving*omega', 'driving', 'omega'),
            ('mul', 'brakes*omega', 'brakes', 'omega'),
        ),
        adds={},
        states=(('work', 'driving*omega'), ('dissipation', 'brakes*omega')),
        tables=(),
    ),
}

QUANTITIES = ('driving', 'resisting', 'pressing', 'lifting')  # what fragments add to

# The equation of motion: quantity, formula, LaTeX, and the symbols of the formula.
BALANCE = ('Theta domega/dt', 'M - s (T + lambda mu max(0, sigma - u))',
    'M - s \\left(T + \\lambda \\mu \\max\\left(0, \\sigma - u\\right)\\right)', ('M', 'T', 'lambda', 'mu', 's',
    'sigma', 'u'))
# Its quantities: what they are, and their LaTeX.
EQUATION_QUANTITIES = {
    'M': ('moment that drives', 'M'),
    'sigma': ('mean normal stress on the slip surface', '\\sigma'),
    'u': ('mean pore pressure on it', 'u'),
    'mu': ('friction coefficient', '\\mu'),
    'T': ('moment that resists beside friction', 'T'),
}
# Its numbers that every scene has.
COEFFICIENTS = {
    'Theta': 'moment of inertia (3.12)',
    'lambda': 'resistance factor (3.14)',
    'A': 'dynamic coefficient (2.24)',
    'J_theta0': 'moment of the weight at the start (3.13)',
    'J_r0': 'weight along the radius at the start (2.23)',
    "J_theta0'": 'derivative of J_theta by the dip, at the start',
    "J_r0'": 'derivative of J_r by the dip, at the start',
}
# What gravity, each effect and each law add to it.
TERMS: dict[str, tuple[tuple[str, str, str, tuple[str, ...]], ...]] = {
    'gravity': (('M', 'J_theta', 'J_\\theta', ('J_theta',)), ('sigma', 'J_r/lambda', '\\frac{J_{r}}{\\lambda}', ('J_r',
        'lambda'))),
    'frozen': (('J_theta', 'J_theta0', 'J_{\\theta 0}', ('J_theta0',)), ('J_r', 'J_r0', 'J_{r0}', ('J_r0',)),
        ("J_theta'", "J_theta0'", "J_{\\theta 0}'", ("J_theta0'",)), ("J_r'", "J_r0'", "J_{r0}'", ("J_r0'",))),
    'rotation': (('J_theta', "J_theta0 cos(phi) - J_theta0' sin(phi)",
        "J_{\\theta 0} \\cos{\\left(\\varphi \\right)} - J_{\\theta 0}' \\sin{\\left(\\varphi \\right)}", ('J_theta0',
        "J_theta0'", 'phi')), ('J_r', "J_r0 cos(phi) - J_r0' sin(phi)",
        "J_{r0} \\cos{\\left(\\varphi \\right)} - J_{r0}' \\sin{\\left(\\varphi \\right)}", ('J_r0', "J_r0'", 'phi')),
        ("J_theta'", "J_theta0 sin(phi) + J_theta0' cos(phi)",
        "J_{\\theta 0} \\sin{\\left(\\varphi \\right)} + J_{\\theta 0}' \\cos{\\left(\\varphi \\right)}", ('J_theta0',
        "J_theta0'", 'phi')), ("J_r'", "J_r0 sin(phi) + J_r0' cos(phi)",
        "J_{r0} \\sin{\\left(\\varphi \\right)} + J_{r0}' \\cos{\\left(\\varphi \\right)}", ('J_r0', "J_r0'", 'phi'))),
    'centripetal': (('sigma', 'A omega^2', 'A \\omega^{2}', ('A', 'omega')),),
    'pore_pressure': (('u', 'pore_pressure', 'p', ('pore_pressure',)), ('u', 'water', 'w', ('water',)), ('u',
        'J_r pore_ratio/lambda', '\\frac{J_{r} r_u}{\\lambda}', ('J_r', 'lambda', 'pore_ratio'))),
    'cohesion': (('T', 'cohesion lambda', 'c \\lambda', ('cohesion', 'lambda')),),
    'drag': (('T', 'Theta drag omega^2', '\\Theta d \\omega^{2}', ('Theta', 'drag', 'omega')),),
    'viscosity': (('T', 'Theta omega viscosity', '\\Theta \\omega e', ('Theta', 'omega', 'viscosity')),),
    'shaking': (('M', '-J_theta k_v', '- J_\\theta k_{v}', ('J_theta', 'k_v')), ('M', "J_theta' k_h",
        "J_\\theta' k_{h}", ("J_theta'", 'k_h')), ('sigma', '-J_r k_v/lambda', '- \\frac{J_{r} k_{v}}{\\lambda}',
        ('J_r', 'k_v', 'lambda')), ('sigma', "J_r' k_h/lambda", "\\frac{J_r' k_{h}}{\\lambda}", ("J_r'", 'k_h',
        'lambda'))),
    'thermal_pressurisation': (('u', 'excess', 'u_T', ('excess',)), ('dexcess/dphi', 'kappa max(0, sigma - u) mu',
        '\\kappa \\max(0, \\sigma - u) \\mu', ('kappa', 'max(0, sigma - u)', 'mu'))),
    'layered_strength': (('sigma', 'Theta layered_normal/lambda', '\\frac{\\Theta layered_{normal}}{\\lambda}',
        ('Theta', 'lambda', 'layered_normal')), ('sigma', 'Theta turning/lambda', '\\frac{\\Theta turning}{\\lambda}',
        ('Theta', 'lambda', 'turning')), ('sigma', 'Theta layered_inertia omega^2/lambda',
        '\\frac{\\Theta layered_{inertia} \\omega^{2}}{\\lambda}', ('Theta', 'lambda', 'layered_inertia', 'omega')),
        ('u', 'Theta layered_lift/lambda', '\\frac{\\Theta layered_{lift}}{\\lambda}', ('Theta', 'lambda',
        'layered_lift')), ('T', 'Theta layered_cohesion', '\\Theta layered_{cohesion}', ('Theta', 'layered_cohesion')),
        ('T', 'Theta layered_remaining', '\\Theta layered_{remaining}', ('Theta', 'layered_remaining')), ('T',
        'Theta remaining', '\\Theta remaining', ('Theta', 'remaining')), ('T',
        'Theta layered_remaining_inertia omega^2', '\\Theta layered_{remaining inertia} \\omega^{2}', ('Theta',
        'layered_remaining_inertia', 'omega'))),
    'constant': (('mu', 'coefficient', '\\mu_0', ('coefficient',)),),
    'exponential': (('mu', 'residual + (peak - residual) exp(-slip/length)',
        '\\mu_r + \\left(\\mu_p - \\mu_r\\right) e^{- \\frac{S}{L}}', ('length', 'peak', 'residual', 'slip')),),
    'linear': (('mu', 'peak + (-peak + residual) min(1, slip/length)',
        '\\mu_p + \\left(- \\mu_p + \\mu_r\\right) \\min\\left(1, \\frac{S}{L}\\right)', ('length', 'peak', 'residual',
        'slip')),),
    'hyperbolic': (('mu', 'residual + (peak - residual)/(1 + slip/length)',
        '\\mu_r + \\frac{\\mu_p - \\mu_r}{1 + \\frac{S}{L}}', ('length', 'peak', 'residual', 'slip')),),
    'tabulated': (('mu', 'mu(slip)', '\\mu(\\mathrm{slip})', ('slip',)),),
    'rate_weakening': (('mu', 'residual + (peak - residual)/(speed/velocity + 1)',
        '\\mu_r + \\frac{\\mu_p - \\mu_r}{\\frac{v}{V} + 1}', ('peak', 'residual', 'speed', 'velocity')),),
    'rate_tabulated': (('mu', 'mu(speed)', '\\mu(\\mathrm{speed})', ('speed',)),),
    'prescribed': (('mu', 'mu(time)', '\\mu(\\mathrm{time})', ('time',)),),
    'callable': (('mu', 'mu(slip)', '\\mu(\\mathrm{slip})', ('slip',)),),
}
LATEX = {
    'J_theta': 'J_\\theta',
    "J_theta'": "J_\\theta'",
    "J_r'": "J_r'",
    'J_theta0': 'J_{\\theta 0}',
    "J_theta0'": "J_{\\theta 0}'",
    'J_r0': 'J_{r0}',
    "J_r0'": "J_{r0}'",
    'phi': '\\varphi',
    'cohesion': 'c',
    'pore_ratio': 'r_u',
    'pore_pressure': 'p',
    'water': 'w',
    'drag': 'd',
    'viscosity': 'e',
    'excess': 'u_T',
    'max(0, sigma - u)': '\\max(0, \\sigma - u)',
    'peak': '\\mu_p',
    'residual': '\\mu_r',
    'length': 'L',
    'velocity': 'V',
    'slip': 'S',
    'speed': 'v',
    'coefficient': '\\mu_0',
}

