# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: 97c4467bbbc2ebb865a5001608b1770029575af4f4f7ab9213ec2110ad4d34ed
"""Proved error bounds of the kernels, and the digest of the C source that they speak of."""

DIGEST = "a74cb39bf07c99a0b7b41b393cf5ac2b64e87ed250f3bb19e0cf2c804e35b3db"
LIMIT = 65536.0  # of an end of an arc, rad

# kernel -> tier -> form of the program -> (relative error, error in ulp where that is the measure).
BOUNDS: dict[str, dict[str, dict[str, tuple[float, float | None]]]] = {
    'polar_moment': {
        'best': {'fused': (1.4055423491754482e-16, 0.633), 'plain': (9.259260025373805e-16, 4.17),
            'numpy': (9.259260025373805e-16, 4.17)},
        '1e-10': {'fused': (6.69e-11, None), 'plain': (6.69e-11, None)},
        '1e-6': {'fused': (6.63e-07, None), 'plain': (6.63e-07, None)},
        'float32': {'fused': (5.960464477539063e-08, 0.5), 'plain': (5.960464477539063e-08, 0.5)},
    },
    'moment_of_inertia': {
        'best': {'fused': (1.7408297026122455e-16, 0.784), 'plain': (8.704148513061227e-16, 3.92)},
        '1e-10': {'fused': (3.56e-12, None), 'plain': (3.56e-12, None)},
        '1e-6': {'fused': (2.42e-07, None), 'plain': (2.42e-07, None)},
        'float32': {'fused': (5.960464477539063e-08, 0.5), 'plain': (5.960464477539063e-08, 0.5)},
    },
    'radial_weight_amplitude': {
        'best': {'fused': (1.5787371410169725e-16, 0.711), 'plain': (8.992806499463768e-16, 4.05),
            'numpy': (8.992806499463768e-16, 4.05)},
        '1e-10': {'fused': (5.86e-11, None), 'plain': (5.86e-11, None)},
        '1e-6': {'fused': (3.41e-07, None), 'plain': (3.41e-07, None)},
        'float32': {'fused': (5.960464477539063e-08, 0.5), 'plain': (5.960464477539063e-08, 0.5)},
    },
    'weight_moment_amplitude': {
        'best': {'fused': (1.6564527527407336e-16, 0.746), 'plain': (8.482103908136196e-16, 3.82)},
        '1e-10': {'fused': (2.07e-12, None), 'plain': (2.07e-12, None)},
        '1e-6': {'fused': (4.38e-07, None), 'plain': (4.38e-07, None)},
        'float32': {'fused': (5.960464477539063e-08, 0.5), 'plain': (5.960464477539063e-08, 0.5)},
    },
    'resistance_factor': {
        'best': {'fused': (1.4432899320127036e-16, 0.65), 'plain': (6.683542608243442e-16, 3.01)},
        '1e-10': {'fused': (2.74e-12, None), 'plain': (2.74e-12, None)},
        '1e-6': {'fused': (1.71e-07, None), 'plain': (1.71e-07, None)},
        'float32': {'fused': (5.960464477539063e-08, 0.5), 'plain': (5.960464477539063e-08, 0.5)},
    },
    'dynamic_coefficient': {
        'best': {'fused': (1.7563728249569977e-16, 0.791), 'plain': (8.837375276016246e-16, 3.98),
            'numpy': (8.837375276016246e-16, 3.98)},
    },
    'weight_moment_per_inertia': {
        'best': {'fused': (1.8851586958135158e-16, 0.849), 'plain': (7.216449660063518e-16, 3.25)},
    },
    'radial_weight_per_inertia': {
        'best': {'fused': (2.353672812205332e-16, 1.06), 'plain': (8.171241461241152e-16, 3.68),
            'numpy': (8.171241461241152e-16, 3.68)},
    },
    'polar_moment_per_inertia': {
        'best': {'fused': (1.907363156306019e-16, 0.859), 'plain': (7.105427357601002e-16, 3.2),
            'numpy': (7.105427357601002e-16, 3.2)},
    },
    'weight_moment_per_radial_weight': {
        'best': {'fused': (2.1094237467877973e-16, 0.95), 'plain': (8.881784197001252e-16, 4.0),
            'numpy': (8.881784197001252e-16, 4.0)},
    },
    'radial_weight': {
        'best': {'fused': (8.56e-16, None), 'plain': (1.6e-15, None), 'numpy': (1.6e-15, None)},
        '1e-10': {'fused': (6.47e-11, None), 'plain': (6.47e-11, None)},
        'float32': {'fused': (5.984306335449219e-08, 0.502), 'plain': (5.984306335449219e-08, 0.502)},
        '1e-6': {'fused': (3.99e-07, None), 'plain': (3.99e-07, None)},
    },
    'weight_moment': {
        'best': {'fused': (8.47e-16, None), 'plain': (1.53e-15, None)},
        '1e-10': {'fused': (8.17e-12, None), 'plain': (8.17e-12, None)},
        'float32': {'fused': (5.97238540649414e-08, 0.501), 'plain': (5.97238540649414e-08, 0.501)},
        '1e-6': {'fused': (4.96e-07, None), 'plain': (4.96e-07, None)},
    },
    'limit_friction': {
        'best': {'fused': (1.59e-15, None), 'plain': (2.27e-15, None), 'numpy': (2.27e-15, None)},
    },
}
