# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: d0c3b29844a49538a0e7600621c1dd973a2052c5f23a08704e70b38ed2df2e5d
"""Proved error bounds of the kernels, and the digest of the C source that they speak of."""

DIGEST = "0926378a030668ec9f81476563cf13fa07eedf9fd6b79a1c865c125873c24079"

# kernel -> tier -> form of the program -> (relative error, error in ulp where that is the measure).
# What is not here is sampled only.
BOUNDS: dict[str, dict[str, dict[str, tuple[float, float | None]]]] = {
    'polar_moment': {
        'best': {'fused': (1.8429702208777598e-16, 0.83), 'plain': (8.260059303211165e-16, 3.72),
            'numpy': (8.260059303211165e-16, 3.72)},
        '1e-10': {'fused': (6.69e-11, None), 'plain': (6.69e-11, None)},
        '1e-6': {'fused': (6.63e-07, None), 'plain': (6.63e-07, None)},
        'float32': {'fused': (5.996227264404297e-08, 0.503), 'plain': (5.996227264404297e-08, 0.503)},
    },
    'moment_of_inertia': {
        'best': {'fused': (1.7386092565629952e-16, 0.783), 'plain': (8.659739592076221e-16, 3.9)},
        '1e-10': {'fused': (3.57e-12, None), 'plain': (3.57e-12, None)},
        '1e-6': {'fused': (2.42e-07, None), 'plain': (2.42e-07, None)},
        'float32': {'fused': (5.996227264404297e-08, 0.503), 'plain': (5.996227264404297e-08, 0.503)},
    },
    'radial_weight_amplitude': {
        'best': {'fused': (1.9739765377835284e-16, 0.889), 'plain': (8.726352973553731e-16, 3.93),
            'numpy': (8.726352973553731e-16, 3.93)},
        '1e-10': {'fused': (5.86e-11, None), 'plain': (5.86e-11, None)},
        '1e-6': {'fused': (3.41e-07, None), 'plain': (3.41e-07, None)},
        'float32': {'fused': (6.020069122314453e-08, 0.505), 'plain': (6.020069122314453e-08, 0.505)},
    },
    'weight_moment_amplitude': {
        'best': {'fused': (1.829647544582258e-16, 0.824), 'plain': (1.092459456231154e-15, 4.92)},
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
        'best': {'fused': (2.0516921495072894e-16, 0.924), 'plain': (1.0258460747536447e-15, 4.62),
            'numpy': (1.0880185641326535e-15, 4.9)},
    },
    'weight_moment_per_inertia': {
        'best': {'fused': (2.2870594307278225e-16, 1.03), 'plain': (7.993605777301127e-16, 3.6)},
    },
    'radial_weight_per_inertia': {
        'best': {'fused': (2.5091040356528535e-16, 1.13), 'plain': (7.01660951563099e-16, 3.16),
            'numpy': (7.038813976123492e-16, 3.17)},
    },
    'polar_moment_per_inertia': {
        'best': {'fused': (1.965094753586527e-16, 0.885), 'plain': (6.683542608243442e-16, 3.01),
            'numpy': (6.683542608243442e-16, 3.01)},
    },
    'weight_moment_per_radial_weight': {
        'best': {'fused': (2.55351295663786e-16, 1.15), 'plain': (1.1080025785759063e-15, 4.99),
            'numpy': (1.0769163338864018e-15, 4.85)},
    },
}
