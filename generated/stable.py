# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: d1e89ebfb0d633555ba7c54bc9fe3662a9b67d48c773f8435c1cd3005d4aca6d
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
    t1 = np.minimum(1.5707963267948966, alpha)
    t2 = np.cos(t1)
    t3 = t1 * t1
    p1 = horner(t3, SERIES_1)
    t4 = p1 * (p1 * p1)
    t5 = 1.0 + t2
    t6 = p1 / t5 * t1
    t7 = np.maximum(-0.4, np.minimum(0.4, t6))
    t8 = t7 * t7
    p2 = horner(t8, SERIES_2)
    t9 = np.abs(t6) < 0.4
    t10 = np.minimum(0.9999999999999999, np.where(t9, 0.4, t6))
    t11 = np.where(t9, p2, (np.arctanh(t10) - t10) / (t10 * (t10 * t10)))
    t12 = -(0.6666666666666666 * (t2 * (t2 * t2)) * t4 * t11 / (t5 * (t5 * t5)))
    t13 = 4.0 * t1 * t1
    p3 = horner(t13, SERIES_3)
    t14 = t12 - (1.0 * (t6 * t6) + -3.0) * t2 * t4 / (6.0 * t5) - 2.6666666666666665 * p3
    return t14 * t1 * t1 * t1


@np.errstate(all="ignore")
def moment_of_inertia(alpha: Any) -> Any:
    """the stable form: float64 arrays, no domain check.

    Operations: 35 mul, 25 add, 1 sub, 1 div, 1 min, 1 cos.

    >>> from generated.stable import moment_of_inertia
    >>> print(f"{moment_of_inertia(0.5):.6f}")
    0.071867
    """
    t1 = np.minimum(1.5707963267948966, alpha)
    t2 = t1 * t1
    p1 = horner(t2, SERIES_1)
    t3 = 4.0 * t1 * t1
    p2 = horner(t3, SERIES_4)
    return (np.cos(t1) * (p1 * (p1 * p1)) / 3.0 - 2.0 * p2) * t1 * t1 * t1


@np.errstate(all="ignore")
def radial_weight_amplitude(alpha: Any) -> Any:
    """the stable form: float64 arrays, no domain check.

    Operations: 52 mul, 34 add, 2 sub, 4 div, 1 neg, 3 min, 1 max, 1 less, 2 select, 1 abs, 1 arctanh, 1 cos.

    >>> from generated.stable import radial_weight_amplitude
    >>> print(f"{radial_weight_amplitude(0.5):.6f}")
    0.077223
    """
    t1 = np.minimum(1.5707963267948966, alpha)
    t2 = t1 * t1
    p1 = horner(t2, SERIES_1)
    t3 = np.cos(t1)
    t4 = 1.0 + t3
    t5 = p1 / t4 * t1
    t6 = p1 * (p1 * p1)
    t7 = np.maximum(-0.4, np.minimum(0.4, t5))
    t8 = t7 * t7
    p2 = horner(t8, SERIES_2)
    t9 = np.abs(t5) < 0.4
    t10 = np.minimum(0.9999999999999999, np.where(t9, 0.4, t5))
    t11 = 2.0 * (t3 * t3) * t6 * np.where(t9, p2, (np.arctanh(t10) - t10) / (t10 * (t10 * t10)))
    t12 = (-(0.5 * (1.0 * (t5 * t5) + -3.0) * t6 / t4) - t11 / (t4 * (t4 * t4))) * t1
    return t12 * t1 * t1


@np.errstate(all="ignore")
def weight_moment_amplitude(alpha: Any) -> Any:
    """the stable form: float64 arrays, no domain check.

    Operations: 20 mul, 13 add, 1 min.

    >>> from generated.stable import weight_moment_amplitude
    >>> print(f"{weight_moment_amplitude(0.5):.6f}")
    0.073464
    """
    t1 = np.minimum(1.5707963267948966, alpha)
    t2 = t1 * t1
    p1 = horner(t2, SERIES_1)
    return 0.6666666666666666 * (p1 * (p1 * p1)) * t1 * t1 * t1


@np.errstate(all="ignore")
def resistance_factor(alpha: Any) -> Any:
    """the stable form: float64 arrays, no domain check.

    Operations: 19 mul, 14 add, 1 div, 1 min, 1 cos.

    >>> from generated.stable import resistance_factor
    >>> print(f"{resistance_factor(0.5):.6f}")
    0.122417
    """
    t1 = np.minimum(1.5707963267948966, alpha)
    t2 = t1 * t1
    p1 = horner(t2, SERIES_1)
    return 2.0 * (p1 * p1) / (1.0 + np.cos(t1)) * t1 * t1 * t1


@np.errstate(all="ignore")
def dynamic_coefficient(alpha: Any) -> Any:
    """the stable form: float64 arrays, no domain check.

    Operations: 68 mul, 47 add, 3 sub, 5 div, 1 neg, 3 min, 1 max, 1 less, 2 select, 1 abs, 1 arctanh, 1 cos.

    >>> from generated.stable import dynamic_coefficient
    >>> print(f"{dynamic_coefficient(0.5):.6f}")
    0.616194
    """
    t1 = np.minimum(1.5707963267948966, alpha)
    t2 = np.cos(t1)
    t3 = t1 * t1
    p1 = horner(t3, SERIES_1)
    t4 = p1 * p1
    t5 = p1 * t4
    t6 = 1.0 + t2
    t7 = p1 / t6 * t1
    t8 = np.maximum(-0.4, np.minimum(0.4, t7))
    t9 = t8 * t8
    p2 = horner(t9, SERIES_2)
    t10 = np.abs(t7) < 0.4
    t11 = np.minimum(0.9999999999999999, np.where(t10, 0.4, t7))
    t12 = np.where(t10, p2, (np.arctanh(t11) - t11) / (t11 * (t11 * t11)))
    t13 = -(0.6666666666666666 * (t2 * (t2 * t2)) * t5 * t12 / (t6 * (t6 * t6)))
    t14 = 4.0 * t1 * t1
    p3 = horner(t14, SERIES_3)
    t15 = t13 - (1.0 * (t7 * t7) + -3.0) * t2 * t5 / (6.0 * t6) - 2.6666666666666665 * p3
    return (0.5 + 0.5 * t2) * t15 / t4


@np.errstate(all="ignore")
def weight_moment_per_inertia(alpha: Any) -> Any:
    """the stable form: float64 arrays, no domain check.

    Operations: 33 mul, 25 add, 1 sub, 2 div, 1 min, 1 cos.

    >>> from generated.stable import weight_moment_per_inertia
    >>> print(f"{weight_moment_per_inertia(0.5):.6f}")
    1.022210
    """
    t1 = np.minimum(1.5707963267948966, alpha)
    t2 = t1 * t1
    p1 = horner(t2, SERIES_1)
    t3 = p1 * (p1 * p1)
    t4 = 4.0 * t1 * t1
    p2 = horner(t4, SERIES_4)
    return 0.6666666666666666 * t3 / (np.cos(t1) * t3 / 3.0 - 2.0 * p2)


@np.errstate(all="ignore")
def radial_weight_per_inertia(alpha: Any) -> Any:
    """the stable form: float64 arrays, no domain check.

    Operations: 65 mul, 46 add, 3 sub, 6 div, 1 neg, 3 min, 1 max, 1 less, 2 select, 1 abs, 1 arctanh, 1 cos.

    >>> from generated.stable import radial_weight_per_inertia
    >>> print(f"{radial_weight_per_inertia(0.5):.6f}")
    1.074524
    """
    t1 = np.minimum(1.5707963267948966, alpha)
    t2 = t1 * t1
    p1 = horner(t2, SERIES_1)
    t3 = np.cos(t1)
    t4 = 1.0 + t3
    t5 = p1 / t4 * t1
    t6 = p1 * (p1 * p1)
    t7 = np.maximum(-0.4, np.minimum(0.4, t5))
    t8 = t7 * t7
    p2 = horner(t8, SERIES_2)
    t9 = np.abs(t5) < 0.4
    t10 = np.minimum(0.9999999999999999, np.where(t9, 0.4, t5))
    t11 = 2.0 * (t3 * t3) * t6 * np.where(t9, p2, (np.arctanh(t10) - t10) / (t10 * (t10 * t10)))
    t12 = 4.0 * t1 * t1
    p3 = horner(t12, SERIES_3)
    t13 = -(0.5 * (1.0 * (t5 * t5) + -3.0) * t6 / t4) - t11 / (t4 * (t4 * t4))
    return t13 / (t3 * t6 / 3.0 - 2.0 * p3)


@np.errstate(all="ignore")
def polar_moment_per_inertia(alpha: Any) -> Any:
    """the stable form: float64 arrays, no domain check.

    Operations: 68 mul, 46 add, 4 sub, 6 div, 1 neg, 3 min, 1 max, 1 less, 2 select, 1 abs, 1 arctanh, 1 cos.

    >>> from generated.stable import polar_moment_per_inertia
    >>> print(f"{polar_moment_per_inertia(0.5):.6f}")
    1.049612
    """
    t1 = np.minimum(1.5707963267948966, alpha)
    t2 = np.cos(t1)
    t3 = t1 * t1
    p1 = horner(t3, SERIES_1)
    t4 = p1 * (p1 * p1)
    t5 = 1.0 + t2
    t6 = p1 / t5 * t1
    t7 = np.maximum(-0.4, np.minimum(0.4, t6))
    t8 = t7 * t7
    p2 = horner(t8, SERIES_2)
    t9 = np.abs(t6) < 0.4
    t10 = np.minimum(0.9999999999999999, np.where(t9, 0.4, t6))
    t11 = np.where(t9, p2, (np.arctanh(t10) - t10) / (t10 * (t10 * t10)))
    t12 = -(0.6666666666666666 * (t2 * (t2 * t2)) * t4 * t11 / (t5 * (t5 * t5)))
    t13 = 4.0 * t1 * t1
    p3 = horner(t13, SERIES_3)
    t14 = t12 - (1.0 * (t6 * t6) + -3.0) * t2 * t4 / (6.0 * t5) - 2.6666666666666665 * p3
    return t14 / (t2 * t4 / 3.0 - 2.0 * p3)


@np.errstate(all="ignore")
def weight_moment_per_radial_weight(alpha: Any) -> Any:
    """the stable form: float64 arrays, no domain check.

    Operations: 50 mul, 34 add, 2 sub, 5 div, 1 neg, 3 min, 1 max, 1 less, 2 select, 1 abs, 1 arctanh, 1 cos.

    >>> from generated.stable import weight_moment_per_radial_weight
    >>> print(f"{weight_moment_per_radial_weight(0.5):.6f}")
    0.951314
    """
    t1 = np.minimum(1.5707963267948966, alpha)
    t2 = t1 * t1
    p1 = horner(t2, SERIES_1)
    t3 = p1 * (p1 * p1)
    t4 = np.cos(t1)
    t5 = 1.0 + t4
    t6 = p1 / t5 * t1
    t7 = np.maximum(-0.4, np.minimum(0.4, t6))
    t8 = t7 * t7
    p2 = horner(t8, SERIES_2)
    t9 = np.abs(t6) < 0.4
    t10 = np.minimum(0.9999999999999999, np.where(t9, 0.4, t6))
    t11 = 2.0 * (t4 * t4) * t3 * np.where(t9, p2, (np.arctanh(t10) - t10) / (t10 * (t10 * t10)))
    t12 = -(0.5 * (1.0 * (t6 * t6) + -3.0) * t3 / t5) - t11 / (t5 * (t5 * t5))
    return 0.6666666666666666 * t3 / t12
