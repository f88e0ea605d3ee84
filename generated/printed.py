# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: 5edcba83120e8ece816dd359c9d36453fd6dd62a3c73bfefb4375bb5d29d4201
"""The paper's own forms, as printed, for comparison only: they cancel and overflow."""

from __future__ import annotations

from typing import Any

import numpy as np

__all__ = [
    "polar_moment",
    "moment_of_inertia",
    "radial_weight_amplitude",
    "weight_moment_amplitude",
    "resistance_factor",
    "dynamic_coefficient",
    "appendix_I",
    "appendix_II",
]


@np.errstate(all="ignore")
def polar_moment(alpha: Any) -> Any:
    """Return (2.19), as printed; float64 arrays, no domain check.

    >>> from generated.printed import polar_moment
    >>> print(f"{polar_moment(0.5):.6f}")
    0.075433
    """
    t1 = np.cos(alpha)
    t2 = np.log(np.abs(np.tan(0.7853981633974483 + 0.5 * alpha))) * (t1 * (t1 * t1))
    return 0.6666666666666666 * alpha - t2 / 3.0 - np.sin(2.0 * alpha) / 6.0


@np.errstate(all="ignore")
def moment_of_inertia(alpha: Any) -> Any:
    """Return (3.15), as printed; float64 arrays, no domain check.

    >>> from generated.printed import moment_of_inertia
    >>> print(f"{moment_of_inertia(0.5):.6f}")
    0.071867
    """
    t1 = np.cos(alpha)
    return 0.5 * alpha - (1.0 + 2.0 * (t1 * t1)) * np.sin(2.0 * alpha) / 12.0


@np.errstate(all="ignore")
def radial_weight_amplitude(alpha: Any) -> Any:
    """Return Appendix I in one line, as printed; float64 arrays, no domain check.

    >>> from generated.printed import radial_weight_amplitude
    >>> print(f"{radial_weight_amplitude(0.5):.6f}")
    0.077223
    """
    t1 = np.sin(alpha)
    t2 = np.cos(alpha)
    return t1 - t2 * t2 * np.arctanh(t1)


@np.errstate(all="ignore")
def weight_moment_amplitude(alpha: Any) -> Any:
    """Return (3.13), integrated, as printed; float64 arrays, no domain check.

    >>> from generated.printed import weight_moment_amplitude
    >>> print(f"{weight_moment_amplitude(0.5):.6f}")
    0.073464
    """
    t1 = 0.6666666666666666 * np.sin(alpha)
    t2 = np.cos(alpha)
    return t1 - t1 * (t2 * t2)


@np.errstate(all="ignore")
def resistance_factor(alpha: Any) -> Any:
    """Return (3.14), as printed; float64 arrays, no domain check.

    >>> from generated.printed import resistance_factor
    >>> print(f"{resistance_factor(0.5):.6f}")
    0.122417
    """
    return 2.0 * (1.0 - np.cos(alpha)) * alpha


@np.errstate(all="ignore")
def dynamic_coefficient(alpha: Any) -> Any:
    """Return (2.24) with (2.19), as printed; float64 arrays, no domain check.

    >>> from generated.printed import dynamic_coefficient
    >>> print(f"{dynamic_coefficient(0.5):.6f}")
    0.616194
    """
    return 0.5 * polar_moment(alpha) / (alpha * (1.0 - np.cos(alpha)))


@np.errstate(all="ignore")
def appendix_I(theta_1: Any, theta_2: Any, alpha: Any) -> Any:
    """Return Appendix I, brackets repaired, as printed; float64 arrays, no domain check.

    >>> from generated.printed import appendix_I
    >>> print(f"{appendix_I(5.0, 6.0, 0.5):.6f}")
    0.054484
    """
    t1 = np.cos(alpha)
    t2 = np.cos(theta_2)
    t3 = 0.5 * t1
    t4 = np.sin(alpha)
    t5 = np.sin(theta_1)
    t6 = t1 * t1
    t7 = 0.5 * t4
    t8 = t7 * t5
    t9 = t2 * t2
    t10 = np.sin(theta_2)
    t11 = np.cos(theta_1)
    t12 = t11 * t11
    t13 = t7 * t10
    t14 = t1 * t6
    t15 = t4 * t10
    t16 = t3 * t2 + t8 * t6 + t8 * t9 + t13 * t12 + t14 * t12 * t2 + t15 * t6 * t12
    t17 = t4 * t5
    t18 = t1 * t11
    t19 = np.arctanh((t17 + t1 - t18) / t5)
    t20 = t4 * t14 * t2
    t21 = t17 * t2
    t22 = t15 * t11
    t23 = t5 * t10
    t24 = t23 * t1
    t25 = t18 * t2
    t26 = np.arctanh((t18 + t21 - t17 - t22 - t24 - t25) / t10)
    t27 = t6 * t6
    t28 = 2.0 * t10 * t27 * t12
    t29 = t5 * t6 * t11 * t2
    t30 = t16 + t20 * t19 + t20 * t26 + t23 * t14 * t11 + t28 * t19 + t28 * t26 + t29 * t19
    t31 = 0.5 * t14
    t32 = t10 * t27
    t33 = t30 + t29 * t26 - t31 * t11 - t31 * t2 - t13 * t6 - t32 * t19 - t32 * t26
    t34 = t33 - t3 * t11 * t9 - t8 * t11 * t2 - t13 * t11 * t2 - 0.5 * t5 * t10 * t1 * t2
    t35 = t10 * t6 * t12
    t36 = 2.0 * t4
    t37 = t36 * t14 * t12 * t2
    t38 = t34 - t35 * t19 - t35 * t26 - t17 * t6 * t11 * t2 - t37 * t19 - t37 * t26
    t39 = 2.0 * t5 * t27 * t11 * t2
    t40 = t36 * t5 * t10 * t14 * t11
    return (t38 - t39 * t19 - t39 * t26 - t40 * t19 - t40 * t26) / (t21 - t22 - t24 - t25)


@np.errstate(all="ignore")
def appendix_II(theta_1: Any, theta_2: Any, alpha: Any) -> Any:
    """Return Appendix II, brackets repaired, as printed; float64 arrays, no domain check.

    >>> from generated.printed import appendix_II
    >>> print(f"{appendix_II(5.0, 6.0, 0.5):.6f}")
    -0.054726
    """
    t1 = np.sin(alpha)
    t2 = np.cos(theta_1)
    t3 = 0.5 * t1
    t4 = t3 * t2
    t5 = np.cos(theta_2)
    t6 = np.sin(theta_1)
    t7 = np.cos(alpha)
    t8 = 0.5 * t6
    t9 = t8 * t7
    t10 = t7 * t7
    t11 = t7 * t10
    t12 = t3 * t10
    t13 = np.sin(theta_2)
    t14 = t2 * t2
    t15 = t10 * t10
    t16 = t1 * t6
    t17 = t7 * t2
    t18 = np.arctanh((t16 + t7 - t17) / t6)
    t19 = t15 * t5
    t20 = t4 + t3 * t5 + t9 + t8 * t11 + t12 * t2 + t12 * t5 + t13 * t11 * t14 + t19 * t18
    t21 = t16 * t5
    t22 = t1 * t13
    t23 = t22 * t2
    t24 = t6 * t13
    t25 = t24 * t7
    t26 = t17 * t5
    t27 = np.arctanh((t17 + t21 - t16 - t23 - t25 - t26) / t13)
    t28 = t22 * t11
    t29 = 0.5 * t13
    t30 = t29 * t7
    t31 = t10 * t14 * t5
    t32 = t20 + t19 * t27 + t28 * t18 + t28 * t27 + t30 * t2 * t5 + t31 * t18 + t31 * t27
    t33 = t24 * t10 * t2
    t34 = 2.0 * t1
    t35 = t34 * t6 * t11 * t2 * t5
    t36 = t5 * t5
    t37 = t32 + t33 * t18 + t33 * t27 + t35 * t18 + t35 * t27 - t30 - t29 * t11 - t4 * t36
    t38 = t10 * t5
    t39 = t3 * t6 * t13
    t40 = t37 - t3 * t14 * t5 - t9 * t36 - t38 * t18 - t38 * t27 - t39 * t2 - t39 * t5
    t41 = 2.0 * t15 * t14 * t5
    t42 = t40 - t1 * t10 * t14 * t5 - t6 * t11 * t2 * t5 - t41 * t18 - t41 * t27
    t43 = t34 * t13 * t11 * t14
    t44 = 2.0 * t6 * t13 * t15 * t2
    t45 = t42 - t16 * t13 * t10 * t2 - t43 * t18 - t43 * t27 - t44 * t18 - t44 * t27
    return t45 / (t21 - t23 - t25 - t26)
