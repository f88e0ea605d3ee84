# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: a65f4329875f7204f8c9a58340d9dc60337d5c06861323c09ff6d8d10addac85
"""Proved error bounds of the kernels, and the digest of the C source that they speak of."""

DIGEST = "e6b592ac3a4486ce4582755731e4e7c5f2614cc4dd575c3c5bff5288acdc962b"

# kernel -> tier -> form of the program -> (relative error, error in ulp where that is the measure).
# What is not here is sampled only.
BOUNDS: dict[str, dict[str, dict[str, tuple[float, float | None]]]] = {
    'polar_moment': {
        'best': {'fused': (1.3988810110276973e-16, 0.63), 'plain': (9.259260025373805e-16, 4.17),
            'numpy': (9.259260025373805e-16, 4.17)},
        '1e-10': {'fused': (6.69e-11, None), 'plain': (6.69e-11, None)},
        '1e-6': {'fused': (6.63e-07, None), 'plain': (6.63e-07, None)},
        'float32': {'fused': (5.996227264404297e-08, 0.503), 'plain': (5.996227264404297e-08, 0.503)},
    },
    'moment_of_inertia': {
        'best': {'fused': (1.9184653865522705e-16, 0.864), 'plain': (8.748557434046233e-16, 3.94)},
        '1e-10': {'fused': (3.57e-12, None), 'plain': (3.57e-12, None)},
        '1e-6': {'fused': (2.42e-07, None), 'plain': (2.42e-07, None)},
        'float32': {'fused': (5.996227264404297e-08, 0.503), 'plain': (5.996227264404297e-08, 0.503)},
    },
    'radial_weight_amplitude': {
        'best': {'fused': (1.5920598173124744e-16, 0.717), 'plain': (8.704148513061227e-16, 3.92),
            'numpy': (8.704148513061227e-16, 3.92)},
        '1e-10': {'fused': (5.86e-11, None), 'plain': (5.86e-11, None)},
        '1e-6': {'fused': (4.53e-07, None), 'plain': (4.53e-07, None)},
        'float32': {'fused': (6.020069122314453e-08, 0.505), 'plain': (6.020069122314453e-08, 0.505)},
    },
    'weight_moment_amplitude': {
        'best': {'fused': (1.6275869541004795e-16, 0.733), 'plain': (8.437694987151189e-16, 3.8)},
        '1e-10': {'fused': (2.07e-12, None), 'plain': (2.07e-12, None)},
        '1e-6': {'fused': (4.38e-07, None), 'plain': (4.38e-07, None)},
        'float32': {'fused': (5.996227264404297e-08, 0.503), 'plain': (5.996227264404297e-08, 0.503)},
    },
    'resistance_factor': {
        'best': {'fused': (1.4432899320127036e-16, 0.65), 'plain': (6.683542608243442e-16, 3.01)},
        '1e-10': {'fused': (2.74e-12, None), 'plain': (2.74e-12, None)},
        '1e-6': {'fused': (1.71e-07, None), 'plain': (1.71e-07, None)},
        'float32': {'fused': (5.97238540649414e-08, 0.501), 'plain': (5.97238540649414e-08, 0.501)},
    },
    'dynamic_coefficient': {
        'best': {'fused': (1.829647544582258e-16, 0.824), 'plain': (8.85957973650875e-16, 3.99),
            'numpy': (8.85957973650875e-16, 3.99)},
    },
    'weight_moment_per_inertia': {
        'best': {'fused': (1.9806378759312793e-16, 0.892), 'plain': (7.038813976123492e-16, 3.17)},
    },
    'radial_weight_per_inertia': {
        'best': {'fused': (2.3980817331903383e-16, 1.08), 'plain': (8.326672684688674e-16, 3.75),
            'numpy': (8.326672684688674e-16, 3.75)},
    },
    'polar_moment_per_inertia': {
        'best': {'fused': (1.8074430840897547e-16, 0.814), 'plain': (6.683542608243442e-16, 3.01),
            'numpy': (6.683542608243442e-16, 3.01)},
    },
    'weight_moment_per_radial_weight': {
        'best': {'fused': (2.2870594307278225e-16, 1.03), 'plain': (8.881784197001252e-16, 4.0),
            'numpy': (8.881784197001252e-16, 4.0)},
    },
}
