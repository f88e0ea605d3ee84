# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: 6174f3fd7073f2788626f9c8497345291d1efafa2ffc15a5d0843bd4b05a75e6
"""The paper's own forms, as printed, for comparison only: they cancel and overflow."""

import numpy as np

from generated._evaluate import Array

__all__ = [
    "polar_moment",
    "moment_of_inertia",
    "radial_weight_amplitude",
    "weight_moment_amplitude",
    "resistance_factor",
    "dynamic_coefficient",
    "appendix_I",
    "appendix_II",
    "angular_velocity",
    "rotation",
]


def _polar_moment(alpha: Array) -> Array:
    v10 = np.cos(alpha)
    v16 = 0.6666666666666666 * alpha - np.log(np.abs(np.tan(0.7853981633974483 + 0.5 * alpha))) * (v10 * (v10 * v10)) / 3.0
    v22 = v16 - np.sin(2.0 * alpha) / 6.0
    return v22


def polar_moment(alpha: Array) -> Array:
    """(2.19), as printed: float64 arrays, no domain check.

    Operations: 6 mul, 1 add, 2 sub, 2 div, 1 abs, 1 cos, 1 log, 1 sin, 1 tan.
    """
    with np.errstate(all="ignore"):
        return _polar_moment(alpha)


def _moment_of_inertia(alpha: Array) -> Array:
    v5 = np.cos(alpha)
    v14 = 0.5 * alpha - (1.0 + 2.0 * (v5 * v5)) * np.sin(2.0 * alpha) / 12.0
    return v14


def moment_of_inertia(alpha: Array) -> Array:
    """(3.15), as printed: float64 arrays, no domain check.

    Operations: 5 mul, 1 add, 1 sub, 1 div, 1 cos, 1 sin.
    """
    with np.errstate(all="ignore"):
        return _moment_of_inertia(alpha)


def _radial_weight_amplitude(alpha: Array) -> Array:
    v1 = np.sin(alpha)
    v2 = np.cos(alpha)
    v6 = v1 - v2 * v2 * np.arctanh(v1)
    return v6


def radial_weight_amplitude(alpha: Array) -> Array:
    """Appendix I in one line, as printed: float64 arrays, no domain check.

    Operations: 2 mul, 1 sub, 1 arctanh, 1 cos, 1 sin.
    """
    with np.errstate(all="ignore"):
        return _radial_weight_amplitude(alpha)


def _weight_moment_amplitude(alpha: Array) -> Array:
    v3 = 0.6666666666666666 * np.sin(alpha)
    v4 = np.cos(alpha)
    v7 = v3 - v3 * (v4 * v4)
    return v7


def weight_moment_amplitude(alpha: Array) -> Array:
    """(3.13), integrated, as printed: float64 arrays, no domain check.

    Operations: 3 mul, 1 sub, 1 cos, 1 sin.
    """
    with np.errstate(all="ignore"):
        return _weight_moment_amplitude(alpha)


def _resistance_factor(alpha: Array) -> Array:
    v6 = 2.0 * (1.0 - np.cos(alpha)) * alpha
    return v6


def resistance_factor(alpha: Array) -> Array:
    """(3.14), as printed: float64 arrays, no domain check.

    Operations: 2 mul, 1 sub, 1 cos.
    """
    with np.errstate(all="ignore"):
        return _resistance_factor(alpha)


def _dynamic_coefficient(alpha: Array) -> Array:
    v10 = np.cos(alpha)
    v16 = 0.6666666666666666 * alpha - np.log(np.abs(np.tan(0.7853981633974483 + 0.5 * alpha))) * (v10 * (v10 * v10)) / 3.0
    v27 = 0.5 * (v16 - np.sin(2.0 * alpha) / 6.0) / (alpha * (1.0 - v10))
    return v27


def dynamic_coefficient(alpha: Array) -> Array:
    """(2.24) with (2.19), as printed: float64 arrays, no domain check.

    Operations: 8 mul, 1 add, 3 sub, 3 div, 1 abs, 1 cos, 1 log, 1 sin, 1 tan.
    """
    with np.errstate(all="ignore"):
        return _dynamic_coefficient(alpha)


def _appendix_I(theta_1: Array, theta_2: Array, alpha: Array) -> Array:
    v4 = np.cos(alpha)
    v5 = np.cos(theta_2)
    v6 = 0.5 * v4
    v8 = np.sin(alpha)
    v9 = np.sin(theta_1)
    v10 = v4 * v4
    v11 = 0.5 * v8
    v12 = v11 * v9
    v15 = v5 * v5
    v18 = np.sin(theta_2)
    v19 = np.cos(theta_1)
    v20 = v19 * v19
    v21 = v11 * v18
    v24 = v4 * v10
    v28 = v8 * v18
    v32 = v8 * v9
    v34 = v4 * v19
    v37 = np.arctanh((v32 + v4 - v34) / v9)
    v39 = v8 * v24 * v5
    v42 = v32 * v5
    v45 = v28 * v19
    v47 = v9 * v18
    v48 = v47 * v4
    v50 = v34 * v5
    v53 = np.arctanh((v34 + v42 - v32 - v45 - v48 - v50) / v18)
    v55 = v6 * v5 + v12 * v10 + v12 * v15 + v21 * v20 + v24 * v20 * v5 + v28 * v10 * v20 + v39 * v37 + v39 * v53
    v60 = v10 * v10
    v63 = 2.0 * v18 * v60 * v20
    v70 = v9 * v10 * v19 * v5
    v75 = 0.5 * v24
    v81 = v55 + v47 * v24 * v19 + v63 * v37 + v63 * v53 + v70 * v37 + v70 * v53 - v75 * v19 - v75 * v5 - v21 * v10
    v82 = v18 * v60
    v100 = v81 - v82 * v37 - v82 * v53 - v6 * v19 * v15 - v12 * v19 * v5 - v21 * v19 * v5 - 0.5 * v9 * v18 * v4 * v5
    v102 = v18 * v10 * v20
    v111 = 2.0 * v8
    v114 = v111 * v24 * v20 * v5
    v122 = 2.0 * v9 * v60 * v19 * v5
    v126 = v100 - v102 * v37 - v102 * v53 - v32 * v10 * v19 * v5 - v114 * v37 - v114 * v53 - v122 * v37 - v122 * v53
    v130 = v111 * v9 * v18 * v24 * v19
    v138 = (v126 - v130 * v37 - v130 * v53) / (v42 - v45 - v48 - v50)
    return v138


def appendix_I(theta_1: Array, theta_2: Array, alpha: Array) -> Array:
    """Appendix I, brackets repaired, as printed: float64 arrays, no domain check.

    Operations: 83 mul, 14 add, 26 sub, 3 div, 2 arctanh, 3 cos, 3 sin.
    """
    with np.errstate(all="ignore"):
        return _appendix_I(theta_1, theta_2, alpha)


def _appendix_II(theta_1: Array, theta_2: Array, alpha: Array) -> Array:
    v4 = np.sin(alpha)
    v5 = np.cos(theta_1)
    v6 = 0.5 * v4
    v7 = v6 * v5
    v8 = np.cos(theta_2)
    v11 = np.sin(theta_1)
    v12 = np.cos(alpha)
    v13 = 0.5 * v11
    v14 = v13 * v12
    v16 = v12 * v12
    v17 = v12 * v16
    v20 = v6 * v16
    v25 = np.sin(theta_2)
    v26 = v5 * v5
    v30 = v16 * v16
    v31 = v4 * v11
    v33 = v12 * v5
    v36 = np.arctanh((v31 + v12 - v33) / v11)
    v37 = v30 * v8
    v40 = v31 * v8
    v43 = v4 * v25
    v44 = v43 * v5
    v46 = v11 * v25
    v47 = v46 * v12
    v49 = v33 * v8
    v52 = np.arctanh((v33 + v40 - v31 - v44 - v47 - v49) / v25)
    v55 = v43 * v17
    v57 = v7 + v6 * v8 + v14 + v13 * v17 + v20 * v5 + v20 * v8 + v25 * v17 * v26 + v37 * v36 + v37 * v52 + v55 * v36
    v60 = 0.5 * v25
    v61 = v60 * v12
    v66 = v16 * v26 * v8
    v72 = v46 * v16 * v5
    v78 = 2.0 * v4
    v82 = v78 * v11 * v17 * v5 * v8
    v86 = v57 + v55 * v52 + v61 * v5 * v8 + v66 * v36 + v66 * v52 + v72 * v36 + v72 * v52 + v82 * v36 + v82 * v52
    v90 = v8 * v8
    v98 = v16 * v8
    v104 = v6 * v11 * v25
    v106 = v86 - v61 - v60 * v17 - v7 * v90 - v6 * v26 * v8 - v14 * v90 - v98 * v36 - v98 * v52 - v104 * v5
    v119 = 2.0 * v30 * v26 * v8
    v127 = v106 - v104 * v8 - v4 * v16 * v26 * v8 - v11 * v17 * v5 * v8 - v119 * v36 - v119 * v52 - v31 * v25 * v16 * v5
    v130 = v78 * v25 * v17 * v26
    v138 = 2.0 * v11 * v25 * v30 * v5
    v146 = (v127 - v130 * v36 - v130 * v52 - v138 * v36 - v138 * v52) / (v40 - v44 - v47 - v49)
    return v146


def appendix_II(theta_1: Array, theta_2: Array, alpha: Array) -> Array:
    """Appendix II, brackets repaired, as printed: float64 arrays, no domain check.

    Operations: 86 mul, 19 add, 26 sub, 3 div, 2 arctanh, 3 cos, 3 sin.
    """
    with np.errstate(all="ignore"):
        return _appendix_II(theta_1, theta_2, alpha)


def _angular_velocity(a: Array, b: Array, t: Array) -> Array:
    v9 = np.sqrt(a / b) * np.tanh(np.sqrt(a * b) * t)
    return v9


def angular_velocity(a: Array, b: Array, t: Array) -> Array:
    """(3.20), misprint mended, from rest, as printed: float64 arrays, no domain check.

    Operations: 3 mul, 1 div, 2 sqrt, 1 tanh.
    """
    with np.errstate(all="ignore"):
        return _angular_velocity(a, b, t)


def _rotation(a: Array, b: Array, t: Array) -> Array:
    v8 = np.log(np.cosh(np.sqrt(a * b) * t)) / b
    return v8


def rotation(a: Array, b: Array, t: Array) -> Array:
    """(4.3), from rest, as printed: float64 arrays, no domain check.

    Operations: 2 mul, 1 div, 1 cosh, 1 log, 1 sqrt.
    """
    with np.errstate(all="ignore"):
        return _rotation(a, b, t)
