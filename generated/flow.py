# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: 9efdeabf77658ccc548f9869216ecb1976760c7a9dd94987716727f3c91c61e7
"""Fragments of flow programs: what the balance, each effect and each friction law adds, as operations.

A fragment is joined with others to a scene's program by name: ``d...`` is a series, the increment since the phase
began, ``..._0`` a number where it began, ``=1.0`` a constant.
"""

from typing import NamedTuple


class Fragment(NamedTuple):
    """Operations on numbers where a phase begins, operations on series, and what they add.

    ``adds`` gives for each quantity of the balance its base, the size of the base's terms, and its increment as a sum
    of (number, series). ``states`` are series with those of their rates.
    """

    words: tuple[str, ...]
    inputs: tuple[str, ...]
    optional: tuple[str, ...]
    scalar: tuple[tuple[str, ...], ...]
    series: tuple[tuple[object, ...], ...]
    adds: dict[str, tuple[str, str, tuple[tuple[str, str], ...]]]
    states: tuple[tuple[str, str], ...] = ()


# Cells that every program has, first and in this order.
CELLS = {
    'TIME': 't* at the start of the next step',
    'ROTATION': 'rotation where the phase began, signed',
    'SLIP': 'slip over the radius where the phase began',
    'DIRECTION': 'of travel, 1 or -1; 0 at rest',
    'LIFTED': '1 where nothing presses on the slip surface, else 0',
    'STATUS': 'what the lane is doing',
    'STEPS': 'steps taken',
    'PHASES': 'phases ended',
    'ORDER': 'of its series',
    'FACTOR': 'step over radius of convergence',
    'END_TIME': 't* at which it ends at the latest',
    'ONE_WAY': '1 where shaking may start it down-slope only',
    'FIRST_ONLY': '1 where the first standstill ends it',
    'LIMIT': 'limit friction at the start',
    'LIMIT_LOW': 'what rounding took from it',
    'PEAK_TIME': 't* of the greatest speed',
    'PEAK_ROTATION': 'rotation then',
    'PEAK_OMEGA': 'omega* then, signed',
    'PEAK_RATE': 'd omega*/dt* then, signed',
    'REACH_TIME': 't* of the greatest rotation from the start',
    'REACH_ROTATION': 'that rotation',
    'END_ROTATION': 'rotation at the end',
    'END_OMEGA': 'omega* then, signed',
    'END_RATE': 'd omega*/dt* then, signed',
    'FIRST_STOP': 't* of the first standstill',
    'CLOSE': 'least margin of a decision at rest, over its terms',
    'LIFT_TIME': 't* of the first lift-off',
}

STATES = ('x', 'omega')
QUANTITIES = ('driving', 'resisting', 'pressing', 'lifting')

FRAGMENTS: dict[str, Fragment] = {
    'gravity': Fragment(
        words=(),
        inputs=('fall', 'press', 'fall_slope', 'press_slope'),
        optional=(),
        scalar=(
            ('mul', 'fall_0', 'DIRECTION', 'fall'),
            ('mul', 'press_slope_0', 'DIRECTION', 'press_slope'),
            ('abs', 'gravity.driving_size', 'fall_0'),
            ('neg', 'gravity.6', 'fall_slope_0'),
            ('neg', 'gravity.7', 'fall_0'),
            ('abs', 'gravity.pressing_size', 'press_0'),
            ('neg', 'gravity.10', 'press_slope_0'),
            ('neg', 'gravity.11', 'press_0'),
            ('set', 'press_0', 'press'),
            ('set', 'fall_slope_0', 'fall_slope'),
            ('set', 'gravity.driving', 'fall_0'),
            ('set', 'gravity.pressing', 'press_0'),
        ),
        series=(),
        adds={
            'driving': ('gravity.driving', 'gravity.driving_size', (('gravity.6', 'sin(x)'), ('gravity.7', 'vers(x)'))),
            'pressing': ('gravity.pressing', 'gravity.pressing_size', (('gravity.10', 'sin(x)'), ('gravity.11', 'vers(x)'))),
        },
        states=(),
    ),
    'rotation': Fragment(
        words=(),
        inputs=(),
        optional=(),
        scalar=(
            ('cos', 'rotation.t8', 'ROTATION'),
            ('mul', 'rotation.t9', 'rotation.t8', 'fall'),
            ('sin', 'rotation.t10', 'ROTATION'),
            ('mul', 'rotation.t11', 'rotation.t10', 'fall_slope'),
            ('sub', 'rotation.t12', 'rotation.t9', 'rotation.t11'),
            ('mul', 'fall_0', 'rotation.t12', 'DIRECTION'),
            ('mul', 'rotation.t14', 'rotation.t8', 'press'),
            ('mul', 'rotation.t15', 'rotation.t10', 'press_slope'),
            ('sub', 'press_0', 'rotation.t14', 'rotation.t15'),
            ('mul', 'rotation.t17', 'rotation.t10', 'fall'),
            ('mul', 'rotation.t18', 'rotation.t8', 'fall_slope'),
            ('add', 'fall_slope_0', 'rotation.t17', 'rotation.t18'),
            ('mul', 'rotation.t20', 'rotation.t10', 'press'),
            ('mul', 'rotation.t21', 'rotation.t8', 'press_slope'),
            ('add', 'rotation.t22', 'rotation.t20', 'rotation.t21'),
            ('mul', 'press_slope_0', 'rotation.t22', 'DIRECTION'),
            ('neg', 'rotation.4', 'press_slope_0'),
            ('neg', 'rotation.5', 'press_0'),
        ),
        series=(
            ('tim', 'x.times', 'x'),
            ('turn', 'sin(x)', 'vers(x)', 'x.times', 'x'),
            ('lin', 'upright', 'press_0', (('rotation.4', 'sin(x)'), ('rotation.5', 'vers(x)'))),
        ),
        adds={},
        states=(),
    ),
    'centripetal': Fragment(
        words=(),
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
            'pressing': ('centripetal.pressing', 'centripetal.pressing_size', (('polar', 'omega*omega'),)),
        },
        states=(),
    ),
    'pore_pressure': Fragment(
        words=(),
        inputs=('pore_ratio', 'pore_pressure'),
        optional=('pore_ratio', 'pore_pressure'),
        scalar=(
            ('mul', 'pore_pressure.t5', 'level', 'pore_pressure'),
            ('mul', 'pore_pressure.t6', 'pore_ratio', 'press_0'),
            ('add', 'pore_pressure.lifting', 'pore_pressure.t5', 'pore_pressure.t6'),
            ('abs', 'pore_pressure.t8', 'pore_pressure.t5'),
            ('abs', 'pore_pressure.t9', 'pore_pressure.t6'),
            ('add', 'pore_pressure.lifting_size', 'pore_pressure.t8', 'pore_pressure.t9'),
            ('neg', 'pore_pressure.2', 'press_slope_0'),
            ('neg', 'pore_pressure.3', 'press_0'),
            ('mul', 'pore_pressure.t13', 'pore_ratio', 'press_slope_0'),
            ('neg', 'pore_pressure.4', 'pore_pressure.t13'),
            ('neg', 'pore_pressure.5', 'pore_pressure.t6'),
        ),
        series=(
            ('mul', 'dpore_ratio*sin(x)', 'dpore_ratio', 'sin(x)'),
            ('mul', 'dpore_ratio*vers(x)', 'dpore_ratio', 'vers(x)'),
        ),
        adds={
            'lifting': ('pore_pressure.lifting', 'pore_pressure.lifting_size', (('level', 'dpore_pressure'), ('press_0', 'dpore_ratio'), ('pore_pressure.2', 'dpore_ratio*sin(x)'), ('pore_pressure.3', 'dpore_ratio*vers(x)'), ('pore_pressure.4', 'sin(x)'), ('pore_pressure.5', 'vers(x)'))),
        },
        states=(),
    ),
    'cohesion': Fragment(
        words=(),
        inputs=('cohesion',),
        optional=(),
        scalar=(
            ('mul', 'cohesion.resisting', 'cohesion', 'level'),
            ('abs', 'cohesion.resisting_size', 'cohesion.resisting'),
        ),
        series=(),
        adds={
            'resisting': ('cohesion.resisting', 'cohesion.resisting_size', ()),
        },
        states=(),
    ),
    'drag': Fragment(
        words=(),
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
    ),
    'viscosity': Fragment(
        words=(),
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
    ),
    'shaking': Fragment(
        words=(),
        inputs=('k_h', 'k_v'),
        optional=('k_h', 'k_v'),
        scalar=(
            ('mul', 'shaking.2', 'DIRECTION', 'fall_slope_0'),
            ('mul', 'shaking.t8', 'shaking.2', 'k_h'),
            ('mul', 'shaking.t9', 'fall_0', 'k_v'),
            ('sub', 'shaking.driving', 'shaking.t8', 'shaking.t9'),
            ('abs', 'shaking.t11', 'shaking.t9'),
            ('abs', 'shaking.t12', 'shaking.t8'),
            ('add', 'shaking.driving_size', 'shaking.t11', 'shaking.t12'),
            ('mul', 'shaking.3', 'DIRECTION', 'fall_0'),
            ('neg', 'shaking.4', 'shaking.2'),
            ('neg', 'shaking.5', 'fall_0'),
            ('mul', 'shaking.t17', 'fall_slope_0', 'k_v'),
            ('mul', 'shaking.t18', 'shaking.3', 'k_h'),
            ('add', 'shaking.6', 'shaking.t17', 'shaking.t18'),
            ('sub', 'shaking.7', 'shaking.t9', 'shaking.t8'),
            ('mul', 'shaking.t21', 'DIRECTION', 'k_h'),
            ('mul', 'shaking.t22', 'shaking.t21', 'press_slope_0'),
            ('mul', 'shaking.t23', 'k_v', 'press_0'),
            ('sub', 'shaking.pressing', 'shaking.t22', 'shaking.t23'),
            ('abs', 'shaking.t25', 'shaking.t23'),
            ('abs', 'shaking.t26', 'shaking.t22'),
            ('add', 'shaking.pressing_size', 'shaking.t25', 'shaking.t26'),
            ('mul', 'shaking.10', 'DIRECTION', 'press_slope_0'),
            ('mul', 'shaking.11', 'DIRECTION', 'press_0'),
            ('neg', 'shaking.12', 'shaking.10'),
            ('neg', 'shaking.13', 'press_0'),
            ('mul', 'shaking.t32', 'k_v', 'press_slope_0'),
            ('mul', 'shaking.t33', 'shaking.t21', 'press_0'),
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
            'driving': ('shaking.driving', 'shaking.driving_size', (('shaking.2', 'dk_h'), ('shaking.3', 'dk_h*sin(x)'), ('shaking.4', 'dk_h*vers(x)'), ('shaking.5', 'dk_v'), ('fall_slope_0', 'dk_v*sin(x)'), ('fall_0', 'dk_v*vers(x)'), ('shaking.6', 'sin(x)'), ('shaking.7', 'vers(x)'))),
            'pressing': ('shaking.pressing', 'shaking.pressing_size', (('shaking.10', 'dk_h'), ('shaking.11', 'dk_h*sin(x)'), ('shaking.12', 'dk_h*vers(x)'), ('shaking.13', 'dk_v'), ('press_slope_0', 'dk_v*sin(x)'), ('press_0', 'dk_v*vers(x)'), ('shaking.14', 'sin(x)'), ('shaking.15', 'vers(x)'))),
        },
        states=(),
    ),
    'thermal_pressurisation': Fragment(
        words=(),
        inputs=('kappa',),
        optional=(),
        scalar=(
            ('mul', 'thermal_pressurisation.lifting', 'excess', 'level'),
            ('abs', 'thermal_pressurisation.lifting_size', 'thermal_pressurisation.lifting'),
            ('div', 'thermal_pressurisation.2', 'kappa', 'level'),
        ),
        series=(
            ('mul', 'friction*omega', 'friction', 'omega'),
            ('lin', 'thermal_pressurisation.sum1', '', (('thermal_pressurisation.2', 'friction*omega'),)),
        ),
        adds={
            'lifting': ('thermal_pressurisation.lifting', 'thermal_pressurisation.lifting_size', (('level', 'dexcess'),)),
        },
        states=(('dexcess', 'thermal_pressurisation.sum1'),),
    ),
    'constant': Fragment(
        words=(),
        inputs=('coefficient',),
        optional=(),
        scalar=(
            ('abs', 'constant.mu_size', 'coefficient'),
            ('set', 'constant.mu', 'coefficient'),
        ),
        series=(),
        adds={
            'mu': ('constant.mu', 'constant.mu_size', ()),
        },
        states=(),
    ),
    'exponential': Fragment(
        words=(),
        inputs=('peak', 'residual', 'length'),
        optional=(),
        scalar=(
            ('div', 'exponential.t5', '=1.0', 'length'),
            ('neg', 'exponential.0', 'exponential.t5'),
            ('div', 'exponential.t8', 'SLIP', 'length'),
            ('neg', 'exponential.t9', 'exponential.t8'),
            ('exp', 'exponential.t10', 'exponential.t9'),
            ('sub', 'exponential.t11', 'peak', 'residual'),
            ('abs', 'exponential.t12', 'exponential.t11'),
            ('mul', 'exponential.t13', '=1.0000000000009095', 'exponential.t10'),
            ('mul', 'exponential.t14', 'exponential.t13', 'exponential.t12'),
            ('abs', 'exponential.t15', 'residual'),
            ('mul', 'exponential.t16', '=1.0000000000009095', 'exponential.t15'),
            ('add', 'exponential.t17', 'exponential.t14', 'exponential.t16'),
            ('abs', 'exponential.t18', 'peak'),
            ('expm1', 'exponential.t19', 'exponential.t9'),
            ('mul', 'exponential.t20', 'exponential.t11', 'exponential.t19'),
            ('abs', 'exponential.t21', 'exponential.t20'),
            ('add', 'exponential.t22', 'exponential.t18', 'exponential.t21'),
            ('mul', 'exponential.3', 'exponential.t11', 'exponential.t10'),
            ('add', 'exponential.t24', 'residual', 'exponential.3'),
            ('add', 'exponential.t25', 'peak', 'exponential.t20'),
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
    ),
    'linear': Fragment(
        words=(),
        inputs=(),
        optional=(),
        scalar=(
            ('abs', 'linear.mu_size', 'VALUE'),
            ('set', 'linear.mu', 'VALUE'),
        ),
        series=(),
        adds={
            'mu': ('linear.mu', 'linear.mu_size', (('=1.0', 'table(x)'),)),
        },
        states=(),
    ),
    'hyperbolic': Fragment(
        words=(),
        inputs=('peak', 'residual', 'length'),
        optional=(),
        scalar=(
            ('div', 'hyperbolic.t5', 'SLIP', 'length'),
            ('add', 'hyperbolic.t6', '=1.0', 'hyperbolic.t5'),
            ('mul', 'hyperbolic.t7', 'length', 'hyperbolic.t6'),
            ('div', 'hyperbolic.0', '=1.0', 'hyperbolic.t7'),
            ('abs', 'hyperbolic.t10', 'residual'),
            ('mul', 'hyperbolic.t11', '=1.0000000000009095', 'hyperbolic.t10'),
            ('sub', 'hyperbolic.t12', 'peak', 'residual'),
            ('div', 'hyperbolic.3', 'hyperbolic.t12', 'hyperbolic.t6'),
            ('abs', 'hyperbolic.t14', 'hyperbolic.3'),
            ('mul', 'hyperbolic.t15', '=1.0000000000009095', 'hyperbolic.t14'),
            ('add', 'hyperbolic.t16', 'hyperbolic.t11', 'hyperbolic.t15'),
            ('abs', 'hyperbolic.t17', 'peak'),
            ('div', 'hyperbolic.t18', 'hyperbolic.t12', 'hyperbolic.t7'),
            ('mul', 'hyperbolic.t19', 'hyperbolic.t18', 'SLIP'),
            ('abs', 'hyperbolic.t20', 'hyperbolic.t19'),
            ('add', 'hyperbolic.t21', 'hyperbolic.t17', 'hyperbolic.t20'),
            ('add', 'hyperbolic.t22', 'residual', 'hyperbolic.3'),
            ('sub', 'hyperbolic.t23', 'peak', 'hyperbolic.t19'),
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
    ),
    'tabulated': Fragment(
        words=(),
        inputs=(),
        optional=(),
        scalar=(
            ('abs', 'tabulated.mu_size', 'VALUE'),
            ('set', 'tabulated.mu', 'VALUE'),
        ),
        series=(),
        adds={
            'mu': ('tabulated.mu', 'tabulated.mu_size', (('=1.0', 'table(x)'),)),
        },
        states=(),
    ),
    'rate_weakening': Fragment(
        words=(),
        inputs=('peak', 'residual', 'velocity'),
        optional=(),
        scalar=(
            ('div', 'rate_weakening.0', '=1.0', 'velocity'),
            ('abs', 'rate_weakening.mu_size', 'peak'),
            ('sub', 'rate_weakening.3', 'peak', 'residual'),
            ('set', 'rate_weakening.mu', 'peak'),
        ),
        series=(
            ('lin', 'rate_weakening.sum1', '', (('rate_weakening.0', 'omega'),)),
            ('rec', 'rate_weakening.rec2', 'rate_weakening.rec2_less_1', 'rate_weakening.sum1'),
        ),
        adds={
            'mu': ('rate_weakening.mu', 'rate_weakening.mu_size', (('rate_weakening.3', 'rate_weakening.rec2_less_1'),)),
        },
        states=(),
    ),
    'rate_tabulated': Fragment(
        words=(),
        inputs=(),
        optional=(),
        scalar=(
            ('less', 'rate_tabulated.t7', '=0.0', 'PIECE'),
            ('select', 'beyond', 'rate_tabulated.t7', '=1.0', '=0.0'),
            ('less', 'rate_tabulated.t9', '=0.0', 'beyond'),
            ('select', 'start_speed', 'rate_tabulated.t9', 'omega', '=1.0'),
            ('neg', 'rate_tabulated.2', 'beyond'),
            ('div', 'rate_tabulated.3', 'beyond', 'start_speed'),
            ('abs', 'rate_tabulated.mu_size', 'VALUE'),
            ('set', 'rate_tabulated.mu', 'VALUE'),
        ),
        series=(
            ('lin', 'relative_speed', 'rate_tabulated.2', (('rate_tabulated.3', 'omega'),)),
            ('log', 'argument', 'relative_speed'),
        ),
        adds={
            'mu': ('rate_tabulated.mu', 'rate_tabulated.mu_size', (('=1.0', 'table(argument)'),)),
        },
        states=(),
    ),
    'prescribed': Fragment(
        words=(),
        inputs=(),
        optional=(),
        scalar=(
            ('abs', 'prescribed.mu_size', 'VALUE'),
            ('set', 'prescribed.mu', 'VALUE'),
        ),
        series=(),
        adds={
            'mu': ('prescribed.mu', 'prescribed.mu_size', (('=1.0', 'table(time)'),)),
        },
        states=(),
    ),
    'product': Fragment(
        words=(),
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
            'mu': ('product.mu', 'product.mu_size', (('slip_mu_0', 'drate_mu'), ('=1.0', 'drate_mu*dslip_mu'), ('rate_mu_0', 'dslip_mu'))),
        },
        states=(),
    ),
    'balance': Fragment(
        words=(),
        inputs=(),
        optional=(),
        scalar=(
            ('sub', 'grip', '=1.0', 'LIFTED'),
            ('sub', 'normal_0', 'pressing_0', 'lifting_0'),
            ('mul', 'balance.4', 'grip', 'mu_0'),
            ('mul', 'friction_0', 'balance.4', 'normal_0'),
            ('mul', 'balance.3', 'grip', 'normal_0'),
            ('sub', 'gap', 'LIMIT', 'mu_0'),
            ('sub', 'balance.t27', 'driving_0', 'resisting_0'),
            ('less', 'balance.t28', '=0.0', 'balance.t27'),
            ('select', 'balance.t29', 'balance.t28', '=1.0', '=0.0'),
            ('mul', 'balance.t30', 'balance.t29', 'grip'),
            ('less', 'balance.t31', '=0.0', 'TIME'),
            ('select', 'first', 'balance.t31', '=0.0', 'balance.t30'),
            ('add', 'balance.t33', 'LIMIT_LOW', 'gap'),
            ('mul', 'balance.t34', 'balance.t33', 'normal_0'),
            ('sub', 'balance.t35', 'driving_0', 'friction_0'),
            ('sub', 'balance.t36', 'balance.t35', 'resisting_0'),
            ('less', 'balance.t37', '=0.0', 'first'),
            ('select', 'drive', 'balance.t37', 'balance.t34', 'balance.t36'),
            ('abs', 'balance.t40', 'drive'),
            ('add', 'balance.t41', 'driving_size', 'resisting_size'),
            ('add', 'balance.t42', 'lifting_size', 'pressing_size'),
            ('mul', 'balance.t43', 'balance.t42', 'grip'),
            ('mul', 'balance.t44', 'balance.t43', 'mu_0'),
            ('add', 'balance.t45', 'balance.t41', 'balance.t44'),
            ('select', 'balance.t46', 'balance.t37', 'balance.t40', 'balance.t45'),
            ('mul', 'drive_scale', '=2.220446049250313e-16', 'balance.t46'),
        ),
        series=(
            ('lin', 'dnormal', '', (('=-1.0', 'dlifting'), ('=1.0', 'dpressing'))),
            ('lin', 'normal', 'normal_0', (('=1.0', 'dnormal'),)),
            ('mul', 'dmu*dnormal', 'dmu', 'dnormal'),
            ('lin', 'dfriction', '', (('balance.3', 'dmu'), ('grip', 'dmu*dnormal'), ('balance.4', 'dnormal'))),
            ('lin', 'friction', 'friction_0', (('=1.0', 'dfriction'),)),
            ('lin', 'dnet', '', (('=1.0', 'ddriving'), ('=-1.0', 'dfriction'), ('=-1.0', 'dresisting'))),
            ('lin', 'net', 'drive', (('=1.0', 'dnet'),)),
            ('lin', 'mu', 'mu_0', (('=1.0', 'dmu'),)),
        ),
        adds={},
        states=(),
    ),
}
