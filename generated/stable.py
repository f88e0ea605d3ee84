# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: a70f1e1656bef7e5b3e2f4d929abc9ffde301cc67a8cd1ffbc083084c0e368bd
"""The kernels' forms without cancellation, each proved equal to its closed form, for comparison only."""

from __future__ import annotations

from typing import Any

import numpy as np

from generated._evaluate import horner

__all__ = [
    "polar_moment",
    "moment_of_inertia",
    "radial_weight_amplitude",
    "weight_moment_amplitude",
    "resistance_factor",
    "dynamic_coefficient",
    "weight_moment_per_inertia",
    "radial_weight_per_inertia",
    "polar_moment_per_inertia",
    "weight_moment_per_radial_weight",
]

SERIES_1 = (1.0, -0.16666666666666666, 0.008333333333333333, -0.0001984126984126984,
        2.7557319223985893e-06, -2.505210838544172e-08, 1.6059043836821613e-10, -7.647163731819816e-13,
        2.8114572543455206e-15, -8.22063524662433e-18, 1.9572941063391263e-20, -3.868170170630684e-23,
        6.446950284384474e-26, -9.183689863795546e-29)
SERIES_2 = (0.3333333333333333, 0.2, 0.14285714285714285, 0.1111111111111111, 0.09090909090909091,
        0.07692307692307693, 0.06666666666666667, 0.058823529411764705, 0.05263157894736842,
        0.047619047619047616, 0.043478260869565216, 0.04, 0.037037037037037035, 0.034482758620689655,
        0.03225806451612903, 0.030303030303030304, 0.02857142857142857, 0.02702702702702703,
        0.02564102564102564, 0.024390243902439025)
SERIES_3 = (-0.16666666666666666, 0.008333333333333333, -0.0001984126984126984,
        2.7557319223985893e-06, -2.505210838544172e-08, 1.6059043836821613e-10, -7.647163731819816e-13,
        2.8114572543455206e-15, -8.22063524662433e-18, 1.9572941063391263e-20, -3.868170170630684e-23,
        6.446950284384474e-26, -9.183689863795546e-29)
SERIES_4 = (-0.16666666666666666, 0.008333333333333333, -0.0001984126984126984, 2.7557319223985893e-06,
        -2.505210838544172e-08, 1.6059043836821613e-10, -7.647163731819816e-13, 2.8114572543455206e-15,
        -8.22063524662433e-18, 1.9572941063391263e-20, -3.868170170630684e-23, 6.446950284384474e-26,
        -9.183689863795546e-29)


@np.errstate(all="ignore")
def polar_moment(alpha: Any) -> Any:
    """the stable form: float64 arrays, no domain check.

    Operations: 69 mul, 46 add, 3 sub, 4 div, 1 neg, 3 min, 1 max, 1 less, 2 select, 1 abs, 1 arctanh, 1 cos.

    >>> from generated.stable import polar_moment
    >>> print(f"{polar_moment(0.5):.6f}")
    0.075433
    """
    alpha_2 = np.minimum(1.5707963267948966, alpha)
    t1 = np.cos(alpha_2)
    alpha_2_2 = alpha_2 * alpha_2
    p1 = horner(alpha_2_2, SERIES_1)
    t2 = p1 * (p1 * p1)
    t3 = 1.0 + t1
    t4 = p1 / t3 * alpha_2
    t5 = np.maximum(-0.4, np.minimum(0.4, t4))
    t6 = t5 * t5
    p2 = horner(t6, SERIES_2)
    t7 = np.abs(t4) < 0.4
    t8 = np.minimum(0.9999999999999999, np.where(t7, 0.4, t4))
    t9 = np.where(t7, p2, (np.arctanh(t8) - t8) / (t8 * (t8 * t8)))
    t10 = -(0.6666666666666666 * (t1 * (t1 * t1)) * t2 * t9 / (t3 * (t3 * t3)))
    t11 = 4.0 * alpha_2 * alpha_2
    p3 = horner(t11, SERIES_3)
    t12 = t10 - (1.0 * (t4 * t4) + -3.0) * t1 * t2 / (6.0 * t3) - 2.6666666666666665 * p3
    return t12 * alpha_2 * alpha_2 * alpha_2


@np.errstate(all="ignore")
def moment_of_inertia(alpha: Any) -> Any:
    """the stable form: float64 arrays, no domain check.

    Operations: 35 mul, 25 add, 1 sub, 1 div, 1 min, 1 cos.

    >>> from generated.stable import moment_of_inertia
    >>> print(f"{moment_of_inertia(0.5):.6f}")
    0.071867
    """
    alpha_2 = np.minimum(1.5707963267948966, alpha)
    alpha_2_2 = alpha_2 * alpha_2
    p1 = horner(alpha_2_2, SERIES_1)
    t1 = 4.0 * alpha_2 * alpha_2
    p2 = horner(t1, SERIES_4)
    t2 = (np.cos(alpha_2) * (p1 * (p1 * p1)) / 3.0 - 2.0 * p2) * alpha_2 * alpha_2
    return t2 * alpha_2


@np.errstate(all="ignore")
def radial_weight_amplitude(alpha: Any) -> Any:
    """the stable form: float64 arrays, no domain check.

    Operations: 52 mul, 34 add, 2 sub, 4 div, 1 neg, 3 min, 1 max, 1 less, 2 select, 1 abs, 1 arctanh, 1 cos.

    >>> from generated.stable import radial_weight_amplitude
    >>> print(f"{radial_weight_amplitude(0.5):.6f}")
    0.077223
    """
    alpha_2 = np.minimum(1.5707963267948966, alpha)
    alpha_2_2 = alpha_2 * alpha_2
    p1 = horner(alpha_2_2, SERIES_1)
    t1 = np.cos(alpha_2)
    t2 = 1.0 + t1
    t3 = p1 / t2 * alpha_2
    t4 = p1 * (p1 * p1)
    t5 = np.maximum(-0.4, np.minimum(0.4, t3))
    t6 = t5 * t5
    p2 = horner(t6, SERIES_2)
    t7 = np.abs(t3) < 0.4
    t8 = np.minimum(0.9999999999999999, np.where(t7, 0.4, t3))
    t9 = 2.0 * (t1 * t1) * t4 * np.where(t7, p2, (np.arctanh(t8) - t8) / (t8 * (t8 * t8)))
    t10 = (-(0.5 * (1.0 * (t3 * t3) + -3.0) * t4 / t2) - t9 / (t2 * (t2 * t2))) * alpha_2
    return t10 * alpha_2 * alpha_2


@np.errstate(all="ignore")
def weight_moment_amplitude(alpha: Any) -> Any:
    """the stable form: float64 arrays, no domain check.

    Operations: 20 mul, 13 add, 1 min.

    >>> from generated.stable import weight_moment_amplitude
    >>> print(f"{weight_moment_amplitude(0.5):.6f}")
    0.073464
    """
    alpha_2 = np.minimum(1.5707963267948966, alpha)
    alpha_2_2 = alpha_2 * alpha_2
    p1 = horner(alpha_2_2, SERIES_1)
    return 0.6666666666666666 * (p1 * (p1 * p1)) * alpha_2 * alpha_2 * alpha_2


@np.errstate(all="ignore")
def resistance_factor(alpha: Any) -> Any:
    """the stable form: float64 arrays, no domain check.

    Operations: 19 mul, 14 add, 1 div, 1 min, 1 cos.

    >>> from generated.stable import resistance_factor
    >>> print(f"{resistance_factor(0.5):.6f}")
    0.122417
    """
    alpha_2 = np.minimum(1.5707963267948966, alpha)
    alpha_2_2 = alpha_2 * alpha_2
    p1 = horner(alpha_2_2, SERIES_1)
    return 2.0 * (p1 * p1) / (1.0 + np.cos(alpha_2)) * alpha_2 * alpha_2 * alpha_2


@np.errstate(all="ignore")
def dynamic_coefficient(alpha: Any) -> Any:
    """the stable form: float64 arrays, no domain check.

    Operations: 68 mul, 47 add, 3 sub, 5 div, 1 neg, 3 min, 1 max, 1 less, 2 select, 1 abs, 1 arctanh, 1 cos.

    >>> from generated.stable import dynamic_coefficient
    >>> print(f"{dynamic_coefficient(0.5):.6f}")
    0.616194
    """
    alpha_2 = np.minimum(1.5707963267948966, alpha)
    t1 = np.cos(alpha_2)
    alpha_2_2 = alpha_2 * alpha_2
    p1 = horner(alpha_2_2, SERIES_1)
    t2 = p1 * p1
    t3 = p1 * t2
    t4 = 1.0 + t1
    t5 = p1 / t4 * alpha_2
    t6 = np.maximum(-0.4, np.minimum(0.4, t5))
    t7 = t6 * t6
    p2 = horner(t7, SERIES_2)
    t8 = np.abs(t5) < 0.4
    t9 = np.minimum(0.9999999999999999, np.where(t8, 0.4, t5))
    t10 = np.where(t8, p2, (np.arctanh(t9) - t9) / (t9 * (t9 * t9)))
    t11 = -(0.6666666666666666 * (t1 * (t1 * t1)) * t3 * t10 / (t4 * (t4 * t4)))
    t12 = 4.0 * alpha_2 * alpha_2
    p3 = horner(t12, SERIES_3)
    t13 = t11 - (1.0 * (t5 * t5) + -3.0) * t1 * t3 / (6.0 * t4) - 2.6666666666666665 * p3
    return (0.5 + 0.5 * t1) * t13 / t2


@np.errstate(all="ignore")
def weight_moment_per_inertia(alpha: Any) -> Any:
    """the stable form: float64 arrays, no domain check.

    Operations: 33 mul, 25 add, 1 sub, 2 div, 1 min, 1 cos.

    >>> from generated.stable import weight_moment_per_inertia
    >>> print(f"{weight_moment_per_inertia(0.5):.6f}")
    1.022210
    """
    alpha_2 = np.minimum(1.5707963267948966, alpha)
    alpha_2_2 = alpha_2 * alpha_2
    p1 = horner(alpha_2_2, SERIES_1)
    t1 = p1 * (p1 * p1)
    t2 = 4.0 * alpha_2 * alpha_2
    p2 = horner(t2, SERIES_4)
    return 0.6666666666666666 * t1 / (np.cos(alpha_2) * t1 / 3.0 - 2.0 * p2)


@np.errstate(all="ignore")
def radial_weight_per_inertia(alpha: Any) -> Any:
    """the stable form: float64 arrays, no domain check.

    Operations: 65 mul, 46 add, 3 sub, 6 div, 1 neg, 3 min, 1 max, 1 less, 2 select, 1 abs, 1 arctanh, 1 cos.

    >>> from generated.stable import radial_weight_per_inertia
    >>> print(f"{radial_weight_per_inertia(0.5):.6f}")
    1.074524
    """
    alpha_2 = np.minimum(1.5707963267948966, alpha)
    alpha_2_2 = alpha_2 * alpha_2
    p1 = horner(alpha_2_2, SERIES_1)
    t1 = np.cos(alpha_2)
    t2 = 1.0 + t1
    t3 = p1 / t2 * alpha_2
    t4 = p1 * (p1 * p1)
    t5 = np.maximum(-0.4, np.minimum(0.4, t3))
    t6 = t5 * t5
    p2 = horner(t6, SERIES_2)
    t7 = np.abs(t3) < 0.4
    t8 = np.minimum(0.9999999999999999, np.where(t7, 0.4, t3))
    t9 = 2.0 * (t1 * t1) * t4 * np.where(t7, p2, (np.arctanh(t8) - t8) / (t8 * (t8 * t8)))
    t10 = 4.0 * alpha_2 * alpha_2
    p3 = horner(t10, SERIES_3)
    t11 = -(0.5 * (1.0 * (t3 * t3) + -3.0) * t4 / t2) - t9 / (t2 * (t2 * t2))
    return t11 / (t1 * t4 / 3.0 - 2.0 * p3)


@np.errstate(all="ignore")
def polar_moment_per_inertia(alpha: Any) -> Any:
    """the stable form: float64 arrays, no domain check.

    Operations: 68 mul, 46 add, 4 sub, 6 div, 1 neg, 3 min, 1 max, 1 less, 2 select, 1 abs, 1 arctanh, 1 cos.

    >>> from generated.stable import polar_moment_per_inertia
    >>> print(f"{polar_moment_per_inertia(0.5):.6f}")
    1.049612
    """
    alpha_2 = np.minimum(1.5707963267948966, alpha)
    t1 = np.cos(alpha_2)
    alpha_2_2 = alpha_2 * alpha_2
    p1 = horner(alpha_2_2, SERIES_1)
    t2 = p1 * (p1 * p1)
    t3 = 1.0 + t1
    t4 = p1 / t3 * alpha_2
    t5 = np.maximum(-0.4, np.minimum(0.4, t4))
    t6 = t5 * t5
    p2 = horner(t6, SERIES_2)
    t7 = np.abs(t4) < 0.4
    t8 = np.minimum(0.9999999999999999, np.where(t7, 0.4, t4))
    t9 = np.where(t7, p2, (np.arctanh(t8) - t8) / (t8 * (t8 * t8)))
    t10 = -(0.6666666666666666 * (t1 * (t1 * t1)) * t2 * t9 / (t3 * (t3 * t3)))
    t11 = 4.0 * alpha_2 * alpha_2
    p3 = horner(t11, SERIES_3)
    t12 = t10 - (1.0 * (t4 * t4) + -3.0) * t1 * t2 / (6.0 * t3) - 2.6666666666666665 * p3
    return t12 / (t1 * t2 / 3.0 - 2.0 * p3)


@np.errstate(all="ignore")
def weight_moment_per_radial_weight(alpha: Any) -> Any:
    """the stable form: float64 arrays, no domain check.

    Operations: 50 mul, 34 add, 2 sub, 5 div, 1 neg, 3 min, 1 max, 1 less, 2 select, 1 abs, 1 arctanh, 1 cos.

    >>> from generated.stable import weight_moment_per_radial_weight
    >>> print(f"{weight_moment_per_radial_weight(0.5):.6f}")
    0.951314
    """
    alpha_2 = np.minimum(1.5707963267948966, alpha)
    alpha_2_2 = alpha_2 * alpha_2
    p1 = horner(alpha_2_2, SERIES_1)
    t1 = p1 * (p1 * p1)
    t2 = np.cos(alpha_2)
    t3 = 1.0 + t2
    t4 = p1 / t3 * alpha_2
    t5 = np.maximum(-0.4, np.minimum(0.4, t4))
    t6 = t5 * t5
    p2 = horner(t6, SERIES_2)
    t7 = np.abs(t4) < 0.4
    t8 = np.minimum(0.9999999999999999, np.where(t7, 0.4, t4))
    t9 = 2.0 * (t2 * t2) * t1 * np.where(t7, p2, (np.arctanh(t8) - t8) / (t8 * (t8 * t8)))
    t10 = -(0.5 * (1.0 * (t4 * t4) + -3.0) * t1 / t3) - t9 / (t3 * (t3 * t3))
    return 0.6666666666666666 * t1 / t10
