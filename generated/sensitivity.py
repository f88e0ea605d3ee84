# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: 01315cfa88246250a95ea49dfe872b3b52f8050d7cacb873aee4bda7182aa323
"""Derivatives of the closed forms, of the balance and of the arc: what a small change makes of them."""

from typing import Any

import numpy as np

from generated._evaluate import horner

__all__ = [
    "arc_growth",
    "balance_tangent",
    "cohesion_tangent",
    "drag_tangent",
    "energy_growth",
    "energy_slopes",
    "frozen_slopes",
    "pore_pressure_tangent",
    "pore_ratio_tangent",
    "position_tangent",
]

SERIES_1 = (0.5, 0.3333333333333333, 0.125, 0.03333333333333333, 0.006944444444444444,
        0.0011904761904761906, 0.00017361111111111112, 2.2045855379188714e-05, 2.48015873015873e-06,
        2.505210838544172e-07, 2.296443268665491e-08, 1.9270852604185937e-09, 1.4911969277048643e-10,
        1.0706029224547743e-11, 7.169215998581078e-13, 4.498331606952833e-14, 2.6552651846596585e-15,
        1.4797143443923793e-16, 7.809603484293113e-18)
SERIES_2 = (0.16666666666666666, 0.041666666666666664, 0.008333333333333333, 0.001388888888888889,
        0.0001984126984126984, 2.48015873015873e-05, 2.7557319223985893e-06, 2.755731922398589e-07,
        2.505210838544172e-08, 2.08767569878681e-09, 1.6059043836821613e-10, 1.1470745597729725e-11,
        7.647163731819816e-13, 4.779477332387385e-14, 2.8114572543455206e-15, 1.5619206968586225e-16,
        8.22063524662433e-18)
SERIES_3 = (-0.16666666666666666, 0.008333333333333333, -0.0001984126984126984,
        2.7557319223985893e-06, -2.505210838544172e-08, 1.6059043836821613e-10, -7.647163731819816e-13,
        2.8114572543455206e-15, -8.22063524662433e-18, 1.9572941063391263e-20, -3.868170170630684e-23,
        6.446950284384474e-26, -9.183689863795546e-29)
SERIES_4 = (1.0, 0.16666666666666666, 0.008333333333333333, 0.0001984126984126984,
        2.7557319223985893e-06, 2.505210838544172e-08, 1.6059043836821613e-10, 7.647163731819816e-13,
        2.8114572543455206e-15, 8.22063524662433e-18, 1.9572941063391263e-20, 3.868170170630684e-23,
        6.446950284384474e-26, 9.183689863795546e-29)


def arc_growth(alpha: Any) -> tuple[Any, Any, Any, Any, Any]:
    """Relative slopes of C_theta, C_r, I_p*, lambda, all over Theta*, and of Theta* times alpha. Operations:
    201 mul, 98 add, 27 sub, 35 div, 2 neg, 3 min, 1 max, 1 less, 3 select, 1 abs, 1 arctanh, 1 cos, 1 sin."""
    alpha_2 = np.minimum(1.5707963267948966, alpha)
    alpha_2_2 = alpha_2 * alpha_2
    p1 = horner(alpha_2_2, (1.0, -0.16666666666666666, 0.008333333333333333, -0.0001984126984126984,
        2.7557319223985893e-06, -2.505210838544172e-08, 1.6059043836821613e-10, -7.647163731819816e-13,
        2.8114572543455206e-15, -8.22063524662433e-18, 1.9572941063391263e-20, -3.868170170630684e-23,
        6.446950284384474e-26, -9.183689863795546e-29))
    t1 = p1 * p1
    t2 = p1 * t1
    p2 = horner(alpha_2_2, (-0.3333333333333333, 0.03333333333333333, -0.0011904761904761906,
        2.2045855379188714e-05, -2.505210838544172e-07, 1.9270852604185937e-09, -1.0706029224547743e-11,
        4.498331606952833e-14, -1.4797143443923793e-16, 3.9145882126782523e-19, -8.509974375387505e-22,
        1.5472680682522736e-24, -2.387759364586842e-27, 3.166789608205361e-30))
    t3 = np.cos(alpha_2)
    t4 = t3 * t2
    t5 = 4.0 * alpha_2 * alpha_2
    p3 = horner(t5, (0.016666666666666666, -0.0007936507936507937, 1.6534391534391536e-05,
        -2.0041686708353376e-07, 1.6059043836821615e-09, -9.17659647818378e-12, 3.936040156083729e-14,
        -1.3153016394598927e-16, 3.523129391410427e-19, -7.736340341261368e-22, 1.4183290625645841e-24,
        -2.204085567310931e-27, 2.9405903504764064e-30))
    t6 = np.sin(alpha_2)
    p4 = horner(t5, (-0.16666666666666666, 0.008333333333333333, -0.0001984126984126984, 2.7557319223985893e-06,
        -2.505210838544172e-08, 1.6059043836821613e-10, -7.647163731819816e-13, 2.8114572543455206e-15,
        -8.22063524662433e-18, 1.9572941063391263e-20, -3.868170170630684e-23, 6.446950284384474e-26,
        -9.183689863795546e-29))
    t7 = (t4 * p2 / p1 * alpha_2 - 8.0 * p3 * alpha_2 - t6 * t2 / 3.0) / (t4 / 3.0 - 2.0 * p4)
    t8 = 1.0 + t3
    t9 = p1 / t8 * alpha_2
    t10 = np.maximum(-0.4, np.minimum(0.4, t9))
    t11 = t10 * t10
    p5 = horner(t11, (0.3333333333333333, 0.2, 0.14285714285714285, 0.1111111111111111, 0.09090909090909091,
        0.07692307692307693, 0.06666666666666667, 0.058823529411764705, 0.05263157894736842,
        0.047619047619047616, 0.043478260869565216, 0.04, 0.037037037037037035, 0.034482758620689655,
        0.03225806451612903, 0.030303030303030304, 0.02857142857142857, 0.02702702702702703,
        0.02564102564102564, 0.024390243902439025))
    t12 = np.abs(t9) < 0.4
    t13 = np.minimum(0.9999999999999999, np.where(t12, 0.4, t9))
    t14 = np.arctanh(t13) - t13
    t15 = t13 * t13
    t16 = t13 * t15
    t17 = np.where(t12, p5, t14 / t16)
    t18 = t8 * t8
    t19 = t8 * t18
    t20 = t9 * t9
    t21 = 1.0 * t20 + -3.0
    t22 = 0.5 * t21
    t23 = t3 * t3
    t24 = t18 * t18
    t25 = 4.0 * t6 * t3 * t2 * t17 / t19 - t22 * t6 * t2 / t18 - 6.0 * t6 * t23 * t2 * t17 / t24
    t26 = 1.0 + t20
    t27 = t8 * p1
    t28 = t25 - 0.5 * t26 * 1.0 * t9 * t2 / t8 - 1.5 * t21 * t2 * p2 / t27 * alpha_2
    t29 = 0.5 + 0.5 * t20
    p6 = horner(t11, (0.4, 0.5714285714285714, 0.6666666666666666, 0.7272727272727273, 0.7692307692307693, 0.8,
        0.8235294117647058, 0.8421052631578947, 0.8571428571428571, 0.8695652173913043, 0.88,
        0.8888888888888888, 0.896551724137931, 0.9032258064516129, 0.9090909090909091, 0.9142857142857143,
        0.918918918918919, 0.9230769230769231, 0.926829268292683, 0.9302325581395349, 0.9333333333333333,
        0.9361702127659575))
    t30 = np.where(t12, p6, ((1.0 / (1.0 - t15) - 1.0) / t16 - 3.0 * t14 / (t15 * t15)) / t13)
    t31 = t19 * p1
    t32 = t28 - 2.0 * t29 * t23 * t9 * t2 * t30 / t19 - 6.0 * t23 * t2 * p2 * t17 / t31 * alpha_2
    t33 = t21 * t6
    t34 = 6.0 * t8
    t35 = 2.0 * t6
    t36 = t33 * t2 / t34 + t35 * t23 * t2 * t17 / t19 - 10.666666666666666 * p3 * alpha_2
    t37 = t3 * t23
    t38 = t36 - t35 * t37 * t2 * t17 / t24 - t33 * t3 * t2 / (6.0 * t18)
    t39 = t38 - 0.6666666666666666 * t29 * t37 * t9 * t2 * t30 / t19 - t26 * 1.0 * t3 * t9 * t2 / t34
    t40 = t39 - 2.0 * t37 * t2 * p2 * t17 / t31 * alpha_2 - t22 * t3 * t2 * p2 / t27 * alpha_2
    t41 = -(0.6666666666666666 * t37 * t2 * t17 / t19) - t21 * t3 * t2 / t34 - 2.6666666666666665 * p4
    return (3.0 * t2 * p2 / (t2 * p1) * alpha_2 - t7, t32 / (-(t22 * t2 / t8) - 2.0 * t23 * t2 * t17 / t19) - t7,
        t40 / t41 - t7, (t35 * t1 / t18 + 4.0 * t1 * p2 / t27 * alpha_2) * (0.5 + 0.5 * t3) / t1 - t7,
        3.0 + t7 * alpha_2)


def balance_tangent(fall: Any, press: Any, fall_slope: Any, press_slope: Any, level: Any, polar: Any, mu: Any,
        omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, drag: Any, fall_dot: Any, press_dot: Any,
        fall_slope_dot: Any, press_slope_dot: Any, level_dot: Any, polar_dot: Any, mu_dot: Any, omega_2_dot: Any,
        pore_ratio_dot: Any, pore_pressure_dot: Any, cohesion_dot: Any, drag_dot: Any) -> tuple[Any, Any, Any, Any,
        Any]:
    """Changes of drive, tilt, constant, brake and what presses, lambda sigma/Theta*. Operations: 29 mul, 14
    add, 13 sub."""
    t1 = level * mu * pore_pressure_dot
    t2 = level * mu_dot * pore_pressure
    t3 = level_dot * mu * pore_pressure
    t4 = mu * pore_ratio
    t5 = mu * pore_ratio_dot
    t6 = mu_dot * pore_ratio
    t7 = cohesion * level_dot
    t8 = cohesion_dot * level
    t9 = fall_dot + t1 + t2 + t3 + t4 * press_dot + t5 * press + t6 * press - t7 - t8
    t10 = fall_slope_dot + t4 * press_slope_dot + t5 * press_slope + t6 * press_slope
    t11 = press_dot + omega_2 * polar_dot + omega_2_dot * polar - level * pore_pressure_dot
    return (t9 - mu * press_dot - mu_dot * press, t10 - mu * press_slope_dot - mu_dot * press_slope,
        t7 + t8 - t1 - t2 - t3, drag_dot + mu * polar_dot + mu_dot * polar,
        t11 - level_dot * pore_pressure - pore_ratio * press_dot - pore_ratio_dot * press)


def cohesion_tangent(value: Any, half_angle: Any, gravity: Any, reference_stress: Any, Theta: Any, value_dot: Any,
        half_angle_dot: Any, gravity_dot: Any, reference_stress_dot: Any, Theta_dot: Any) -> Any:
    """Change of a dimensionless parameter. Operations: 2 mul, 1 sub, 2 div."""
    reference_stress_2 = reference_stress * reference_stress
    return value_dot / reference_stress - reference_stress_dot / reference_stress_2 * value


def drag_tangent(value: Any, half_angle: Any, gravity: Any, reference_stress: Any, Theta: Any, value_dot: Any,
        half_angle_dot: Any, gravity_dot: Any, reference_stress_dot: Any, Theta_dot: Any) -> Any:
    """Change of a dimensionless parameter. Operations: 15 mul, 1 add, 2 sub, 3 div."""
    t1 = 2.0 / (Theta * value)
    Theta_2 = Theta * Theta
    t2 = t1 * gravity * half_angle_dot + t1 * gravity_dot * half_angle
    value_2 = value * value
    t3 = t2 - 2.0 / (Theta_2 * value) * Theta_dot * gravity * half_angle
    return t3 - 2.0 / (Theta * value_2) * gravity * half_angle * value_dot


def energy_growth(x: Any, brake: Any) -> tuple[Any, Any, Any]:
    """How the energy of a short motion changes with its length. Operations: 137 mul, 76 add, 12 sub, 6 div, 1
    neg, 1 min, 1 max, 1 less, 3 select, 1 abs, 1 exp, 2 sin."""
    t1 = 0.5 * x
    t2 = np.sin(t1)
    t3 = t2 * t2
    x_2 = x * x
    p1 = horner(x_2, (-0.3333333333333333, 0.03333333333333333, -0.0011904761904761906, 2.2045855379188714e-05,
        -2.505210838544172e-07, 1.9270852604185937e-09, -1.0706029224547743e-11, 4.498331606952833e-14,
        -1.4797143443923793e-16, 3.9145882126782523e-19, -8.509974375387505e-22, 1.5472680682522736e-24,
        -2.387759364586842e-27, 3.166789608205361e-30))
    t4 = brake * x
    t5 = 2.0 * brake * x
    t6 = -t5
    t7 = np.maximum(-1.0, np.minimum(1.0, t6))
    p2 = horner(t7, SERIES_1)
    t8 = 2.0 * np.abs(t4) < 1.0
    t9 = np.where(t8, 1.0, t6)
    t10 = np.exp(t9)
    t11 = t10 - 1.0
    t12 = t9 * t9
    t13 = 8.0 * np.where(t8, p2, t10 / t9 - t11 / t12) * brake * brake * brake * x * x
    t14 = 1.0 + 4.0 * brake * brake
    t15 = 2.0 + t5
    p3 = horner(t7, SERIES_2)
    t16 = np.where(t8, p3, (t11 - t9 - 0.5 * t12) / (t9 * t12))
    p4 = horner(x_2, SERIES_3)
    t17 = 8.0 * t16 * brake * brake * brake * x * x * x - 2.0 * p4 * brake * x * x * x
    t18 = t1 + t2
    t19 = 0.25 * x * x
    p5 = horner(t19, SERIES_3)
    t20 = p4 * x * x * x
    t21 = 4.0 * t16 * brake * brake * x * x * x + 0.5 * t18 * p5 * brake * x * x * x
    return ((4.0 * t3 * brake + p1 * x * x * x - 2.0 * np.sin(x) * brake * x - t13) / t14,
        t15 * (t17 - 0.25 * t18 * p5 * x * x * x) / t14 - (t4 * x - t20) * x, 2.0 * t3 * x - t15 * (t21 - t20) / t14)


def energy_slopes(x: Any, start: Any, drive: Any, tilt: Any, constant: Any, brake: Any) -> tuple[Any, Any, Any, Any,
        Any]:
    """dE/d(start, drive, tilt, constant, brake) at x. Operations: 237 mul, 121 add, 22 sub, 12 div, 4 neg, 2
    min, 2 max, 2 less, 8 select, 1 abs, 2 exp, 1 expm1, 2 sin."""
    t1 = 2.0 * brake * x
    t2 = -t1
    t3 = np.exp(t2)
    t4 = 2.0 * np.abs(brake * x)
    t5 = t4 < 8.673617379884035e-19
    t6 = np.where(t5, 1.0, t2)
    t7 = np.where(t5, 1.0, np.expm1(t6) / t6)
    t8 = 0.5 * x
    t9 = np.sin(t8)
    t10 = t9 * t9
    t11 = 2.0 * t10
    t12 = 4.0 * brake * brake
    t13 = 1.0 + t12
    x_2 = x * x
    p1 = horner(x_2, (0.008333333333333333, -0.0001984126984126984, 2.7557319223985893e-06,
        -2.505210838544172e-08, 1.6059043836821613e-10, -7.647163731819816e-13, 2.8114572543455206e-15,
        -8.22063524662433e-18, 1.9572941063391263e-20, -3.868170170630684e-23, 6.446950284384474e-26,
        -9.183689863795546e-29))
    t14 = p1 * x_2 + -0.16666666666666666
    t15 = np.maximum(-1.0, np.minimum(1.0, t2))
    p2 = horner(t15, SERIES_2)
    t16 = t4 < 1.0
    t17 = np.where(t16, 1.0, t2)
    t18 = np.exp(t17)
    t19 = t18 - 1.0
    t20 = t19 - t17
    t21 = t17 * t17
    t22 = np.where(t16, p2 * t15 + 0.5, t20 / t21)
    t23 = 4.0 * t22 * brake * brake * x * x
    t24 = t17 * t21
    t25 = 4.0 * np.where(t16, p2, (t20 - 0.5 * t21) / t24) * brake * brake * x * x * x
    t26 = t8 + t9
    t27 = 0.25 * x * x
    p3 = horner(t27, SERIES_3)
    t28 = 4.0 * t14 * brake * x * x * x
    t29 = 4.0 * (t7 + t22) * brake * brake * x * x
    p4 = horner(t15, SERIES_1)
    t30 = t19 / t21
    t31 = np.where(t16, p4, t18 / t17 - t30)
    t32 = 8.0 * t10 * brake * brake - t28 - t29 - 16.0 * t31 * brake * brake * brake * brake * x * x
    t33 = t13 * t13
    t34 = np.maximum(-1.0, np.minimum(1.0, t1))
    p5 = horner(t34, (0.125, -0.03333333333333333, 0.006944444444444444, -0.0011904761904761906,
        0.00017361111111111112, -2.2045855379188714e-05, 2.48015873015873e-06, -2.505210838544172e-07,
        2.296443268665491e-08, -1.9270852604185937e-09, 1.4911969277048643e-10, -1.0706029224547743e-11,
        7.169215998581078e-13, -4.498331606952833e-14, 2.6552651846596585e-15, -1.4797143443923793e-16,
        7.809603484293113e-18, -3.9145882126782523e-19))
    p6 = horner(t34, (0.041666666666666664, -0.016666666666666666, 0.004166666666666667, -0.0007936507936507937,
        0.0001240079365079365, -1.6534391534391536e-05, 1.9290123456790124e-06, -2.0041686708353376e-07,
        1.878908128908129e-08, -1.6059043836821615e-09, 1.2617820157502697e-10, -9.17659647818378e-12,
        6.213320532103601e-13, -3.936040156083729e-14, 2.342881045287934e-15, -1.3153016394598927e-16,
        6.98753995963068e-18, -3.523129391410427e-19))
    t35 = 4.0 * (p5 * x * x + 4.0 * p6 * brake * brake * x * x) * brake * brake * x
    t36 = t12 - 1.0
    t37 = 4.0 * p1 * brake * x * x * x * x * x - t35 * x - 0.25 * t36 * t26 * p3 * x * x * x
    t38 = 2.0 * (1.0 - t12) * t10 + t28 + t29 - (x_2 + 8.0 * brake * brake * x * x) * t31
    p7 = horner(t15, (0.16666666666666666, 0.08333333333333333, 0.025, 0.005555555555555556,
        0.000992063492063492, 0.00014880952380952382, 1.9290123456790123e-05, 2.204585537918871e-06,
        2.2546897546897547e-07, 2.08767569878681e-08, 1.7664948220503776e-09, 1.376489471727567e-10,
        9.941312851365761e-12, 6.691268265342339e-13, 4.217185881518281e-14, 2.499073114973796e-15,
        1.3975079919261362e-16, 7.398571721961897e-18))
    t39 = 16.0 * np.where(t16, p7, t30 - 2.0 * t20 / t24) * brake * brake * brake * brake
    t40 = -(t23 * x) - t39 * x * x * x - t36 * t14 * x * x * x - t26 * p3 * brake * x * x * x
    t41 = (t32 - t11) / t33 * drive - np.where(t16, t37, t38) / t33 * constant - t40 / t33 * tilt
    return (t3, 2.0 * (2.0 * (2.0 * t7 * brake * x - t11) * brake + np.sin(x)) / t13,
        -(2.0 * (2.0 * t14 * brake * x * x * x + t23 + t11) / t13),
        -(2.0 * (t25 + 0.5 * t26 * p3 * brake * x * x * x - t14 * x * x * x) / t13), 4.0 * t41 - 2.0 * t3 * start * x)


def frozen_slopes(a: Any, b: Any, omega_0: Any, t: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """Derivatives of rotation, then of angular velocity, at a time by a, b and omega_0. Operations: 166 mul, 92
    add, 9 sub, 25 div, 1 neg, 3 min, 3 max, 2 less, 13 select, 3 abs, 1 exp, 2 log, 1 log1p, 2 sign, 2 sqrt."""
    k = np.sqrt(np.abs(a)) * np.sqrt(np.abs(b))
    kt = np.minimum(t, 800.0 / np.maximum(1e-300, k)) * k
    z = np.sign(a) * np.sign(b) * kt * kt
    near = np.maximum(-9.869604401089358, np.minimum(1.0, z))
    t1 = 1.0 < z
    t_near = np.where(t1, 0.0, t)
    t2 = 0.25 * near
    p1 = horner(t2, SERIES_4)
    versine = 0.5 * (p1 * p1)
    p2 = horner(near, SERIES_4)
    S = p2 * t_near
    C = 1.0 + near * versine
    t3 = S * omega_0
    G = t3 + a * t_near * t_near * versine
    q = np.exp(-(2.0 * kt))
    t4 = 1.0 + q
    tanh_k = (1.0 - q) / (t4 * np.where(t1, k, 1.0))
    sech_2 = 4.0 / (t4 * t4) * q
    t_far = np.where(t1, t, 0.0)
    t5 = np.where(t1, b, 1.0)
    turned = (k * t_far + np.log(0.5 + 0.5 * q) + np.log1p(b * omega_0 * tanh_k)) / t5
    t6 = 0.5 * sech_2 * t_far
    t7 = 0.5 * tanh_k
    t8 = t6 - t7
    t9 = 1.0 + t5 * omega_0 * tanh_k
    t10 = np.where(t1, a, 1.0)
    t11 = t9 * t10
    t12 = 0.5 * S
    p3 = horner(near, (0.3333333333333333, 0.03333333333333333, 0.0011904761904761906, 2.2045855379188714e-05,
        2.505210838544172e-07, 1.9270852604185937e-09, 1.0706029224547743e-11, 4.498331606952833e-14,
        1.4797143443923793e-16, 3.9145882126782523e-19, 8.509974375387505e-22, 1.5472680682522736e-24,
        2.387759364586842e-27, 3.166789608205361e-30))
    t13 = 0.5 * p3
    t14 = t12 * t_near + t13 * b * omega_0 * t_near * t_near * t_near
    t15 = G * b
    t16 = 1.0 + t15
    t17 = t7 + t6
    t18 = np.maximum(-0.125, np.minimum(0.125, t15))
    p4 = horner(t18, (-0.5, 0.6666666666666666, -0.75, 0.8, -0.8333333333333334, 0.8571428571428571, -0.875,
        0.8888888888888888, -0.9, 0.9090909090909091, -0.9166666666666666, 0.9230769230769231,
        -0.9285714285714286, 0.9333333333333333, -0.9375, 0.9411764705882353, -0.9444444444444444,
        0.9473684210526315, -0.95))
    t19 = np.abs(t15) < 0.125
    t20 = np.where(t19, 0.125, t15)
    t21 = 1.0 + t20
    p5 = horner(near, (0.08333333333333333, 0.005555555555555556, 0.00014880952380952382, 2.204585537918871e-06,
        2.08767569878681e-08, 1.376489471727567e-10, 6.691268265342339e-13, 2.499073114973796e-15,
        7.398571721961897e-18, 1.7793582784901146e-20, 3.54582265641146e-23, 5.951031031739514e-26,
        8.527712016381578e-29))
    t22 = t13 * a
    t23 = 0.5 * p5 * a * a * t_near * t_near * t_near * t_near
    t24 = np.where(t19, p4, 1.0 / (t21 * t20) - np.log(t21) / (t20 * t20)) * G * G
    t25 = (t17 / t9 * omega_0 + 0.5 * t10 * t_far * tanh_k - turned) / t5
    t26 = omega_0 + t10 * tanh_k
    t27 = t22 * b
    t28 = C * omega_0 + S * a
    t29 = S + t12 * b * omega_0 * t_near + t27 * t_near * t_near * t_near - t28 * t14 / t16 * b
    t30 = (t17 + 0.5 * t26 * (tanh_k - sech_2 * t_far) * t5 / t11 * omega_0) / t9
    t31 = (t8 * (t10 - t26 * t5 / t9 * omega_0) / t5 - t26 / t9 * omega_0 * tanh_k) / t9
    t32 = t12 * a
    t33 = t28 * (t3 + t32 * t_near + t27 * omega_0 * t_near * t_near * t_near) / t16
    t34 = (t22 * a * t_near * t_near * t_near + t32 * omega_0 * t_near - t33) / t16
    return (np.where(t1, 0.5 * t_far * tanh_k + t8 / t11 * omega_0, t14 / t16), np.where(t1, t25,
        t24 + (t23 + t22 * omega_0 * t_near * t_near * t_near) / t16), np.where(t1, tanh_k / t9, S / t16), np.where(t1,
        t30, t29 / t16), np.where(t1, t31, t34), np.where(t1, sech_2 / (t9 * t9), 1.0 / (t16 * t16)))


def pore_pressure_tangent(value: Any, half_angle: Any, gravity: Any, reference_stress: Any, Theta: Any, value_dot: Any,
        half_angle_dot: Any, gravity_dot: Any, reference_stress_dot: Any, Theta_dot: Any) -> Any:
    """Change of a dimensionless parameter. Operations: 2 mul, 1 sub, 2 div."""
    reference_stress_2 = reference_stress * reference_stress
    return value_dot / reference_stress - reference_stress_dot / reference_stress_2 * value


def pore_ratio_tangent(value: Any, half_angle: Any, gravity: Any, reference_stress: Any, Theta: Any, value_dot: Any,
        half_angle_dot: Any, gravity_dot: Any, reference_stress_dot: Any, Theta_dot: Any) -> Any:
    """Change of a dimensionless parameter. Operations: none."""
    return value_dot


def position_tangent(fall: Any, press: Any, fall_slope: Any, press_slope: Any, weight_growth: Any, radial_growth: Any,
        dip_dot: Any) -> tuple[Any, Any, Any, Any]:
    """Changes of J_theta, J_r over Theta* and of their slopes by the dip. Operations: 8 mul, 2 add, 2 sub."""
    return (dip_dot * fall_slope + fall * weight_growth, dip_dot * press_slope + press * radial_growth,
        fall_slope * weight_growth - dip_dot * fall, press_slope * radial_growth - dip_dot * press)
