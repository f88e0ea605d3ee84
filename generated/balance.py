# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: 7bfed4135f9b71252db170603118a1157558416c6e1994631a7316319a6c8c69
"""The balance of momentum and the energy in the phase plane, specialised to the effects that are present."""

from typing import Any

import numpy as np

from generated._evaluate import horner

__all__ = [
    "brake_centripetal",
    "brake_centripetal_drag",
    "brake_drag",
    "constant_cohesion",
    "constant_cohesion_thermal_pressurisation",
    "constant_pore_pressure",
    "constant_pore_pressure_cohesion",
    "constant_pore_pressure_cohesion_thermal_pressurisation",
    "constant_pore_pressure_thermal_pressurisation",
    "constant_thermal_pressurisation",
    "damping_viscosity",
    "drive",
    "drive_pore_pressure",
    "drive_pore_pressure_shaking",
    "drive_pore_pressure_shaking_thermal_pressurisation",
    "drive_pore_pressure_thermal_pressurisation",
    "drive_shaking",
    "drive_shaking_thermal_pressurisation",
    "drive_thermal_pressurisation",
    "drop_exponential",
    "drop_hyperbolic",
    "drop_linear",
    "effective_stress",
    "effective_stress_centripetal",
    "effective_stress_centripetal_pore_pressure",
    "effective_stress_centripetal_pore_pressure_shaking",
    "effective_stress_centripetal_pore_pressure_shaking_thermal_pressurisation",
    "effective_stress_centripetal_pore_pressure_thermal_pressurisation",
    "effective_stress_centripetal_shaking",
    "effective_stress_centripetal_shaking_thermal_pressurisation",
    "effective_stress_centripetal_thermal_pressurisation",
    "effective_stress_pore_pressure",
    "effective_stress_pore_pressure_shaking",
    "effective_stress_pore_pressure_shaking_thermal_pressurisation",
    "effective_stress_pore_pressure_thermal_pressurisation",
    "effective_stress_shaking",
    "effective_stress_shaking_thermal_pressurisation",
    "effective_stress_thermal_pressurisation",
    "energy",
    "energy_braked",
    "energy_braked_constant",
    "energy_constant",
    "energy_softening",
    "energy_softening_constant",
    "energy_softening_constant_water",
    "fall_shaking",
    "friction_exponential",
    "friction_hyperbolic",
    "friction_linear",
    "friction_rate_weakening",
    "frozen_braked_state",
    "frozen_state",
    "limit_friction",
    "limit_friction_cohesion",
    "limit_friction_cohesion_shaking",
    "limit_friction_cohesion_shaking_thermal_pressurisation",
    "limit_friction_cohesion_thermal_pressurisation",
    "limit_friction_pore_pressure",
    "limit_friction_pore_pressure_cohesion",
    "limit_friction_pore_pressure_cohesion_shaking",
    "limit_friction_pore_pressure_cohesion_shaking_thermal_pressurisation",
    "limit_friction_pore_pressure_cohesion_thermal_pressurisation",
    "limit_friction_pore_pressure_shaking",
    "limit_friction_pore_pressure_shaking_thermal_pressurisation",
    "limit_friction_pore_pressure_thermal_pressurisation",
    "limit_friction_shaking",
    "limit_friction_shaking_thermal_pressurisation",
    "limit_friction_thermal_pressurisation",
    "normal",
    "normal_pore_pressure",
    "normal_pore_pressure_shaking",
    "normal_pore_pressure_shaking_thermal_pressurisation",
    "normal_pore_pressure_thermal_pressurisation",
    "normal_shaking",
    "normal_shaking_thermal_pressurisation",
    "normal_stress",
    "normal_stress_centripetal",
    "normal_stress_centripetal_shaking",
    "normal_stress_shaking",
    "normal_thermal_pressurisation",
    "pressurisation_centripetal_pore_pressure_shaking_thermal_pressurisation",
    "pressurisation_centripetal_pore_pressure_thermal_pressurisation",
    "pressurisation_centripetal_shaking_thermal_pressurisation",
    "pressurisation_centripetal_thermal_pressurisation",
    "pressurisation_pore_pressure_shaking_thermal_pressurisation",
    "pressurisation_pore_pressure_thermal_pressurisation",
    "pressurisation_shaking_thermal_pressurisation",
    "pressurisation_thermal_pressurisation",
    "resistance",
    "resistance_centripetal",
    "resistance_centripetal_cohesion",
    "resistance_centripetal_cohesion_drag",
    "resistance_centripetal_cohesion_drag_shaking",
    "resistance_centripetal_cohesion_drag_shaking_thermal_pressurisation",
    "resistance_centripetal_cohesion_drag_thermal_pressurisation",
    "resistance_centripetal_cohesion_drag_viscosity",
    "resistance_centripetal_cohesion_drag_viscosity_shaking",
    "resistance_centripetal_cohesion_drag_viscosity_shaking_thermal_pressurisation",
    "resistance_centripetal_cohesion_drag_viscosity_thermal_pressurisation",
    "resistance_centripetal_cohesion_shaking",
    "resistance_centripetal_cohesion_shaking_thermal_pressurisation",
    "resistance_centripetal_cohesion_thermal_pressurisation",
    "resistance_centripetal_cohesion_viscosity",
    "resistance_centripetal_cohesion_viscosity_shaking",
    "resistance_centripetal_cohesion_viscosity_shaking_thermal_pressurisation",
    "resistance_centripetal_cohesion_viscosity_thermal_pressurisation",
    "resistance_centripetal_drag",
    "resistance_centripetal_drag_shaking",
    "resistance_centripetal_drag_shaking_thermal_pressurisation",
    "resistance_centripetal_drag_thermal_pressurisation",
    "resistance_centripetal_drag_viscosity",
    "resistance_centripetal_drag_viscosity_shaking",
    "resistance_centripetal_drag_viscosity_shaking_thermal_pressurisation",
    "resistance_centripetal_drag_viscosity_thermal_pressurisation",
    "resistance_centripetal_pore_pressure",
    "resistance_centripetal_pore_pressure_cohesion",
    "resistance_centripetal_pore_pressure_cohesion_drag",
    "resistance_centripetal_pore_pressure_cohesion_drag_shaking",
    "resistance_centripetal_pore_pressure_cohesion_drag_shaking_thermal_pressurisation",
    "resistance_centripetal_pore_pressure_cohesion_drag_thermal_pressurisation",
    "resistance_centripetal_pore_pressure_cohesion_drag_viscosity",
    "resistance_centripetal_pore_pressure_cohesion_drag_viscosity_shaking",
    "resistance_centripetal_pore_pressure_cohesion_drag_viscosity_shaking_thermal_pressurisation",
    "resistance_centripetal_pore_pressure_cohesion_drag_viscosity_thermal_pressurisation",
    "resistance_centripetal_pore_pressure_cohesion_shaking",
    "resistance_centripetal_pore_pressure_cohesion_shaking_thermal_pressurisation",
    "resistance_centripetal_pore_pressure_cohesion_thermal_pressurisation",
    "resistance_centripetal_pore_pressure_cohesion_viscosity",
    "resistance_centripetal_pore_pressure_cohesion_viscosity_shaking",
    "resistance_centripetal_pore_pressure_cohesion_viscosity_shaking_thermal_pressurisation",
    "resistance_centripetal_pore_pressure_cohesion_viscosity_thermal_pressurisation",
    "resistance_centripetal_pore_pressure_drag",
    "resistance_centripetal_pore_pressure_drag_shaking",
    "resistance_centripetal_pore_pressure_drag_shaking_thermal_pressurisation",
    "resistance_centripetal_pore_pressure_drag_thermal_pressurisation",
    "resistance_centripetal_pore_pressure_drag_viscosity",
    "resistance_centripetal_pore_pressure_drag_viscosity_shaking",
    "resistance_centripetal_pore_pressure_drag_viscosity_shaking_thermal_pressurisation",
    "resistance_centripetal_pore_pressure_drag_viscosity_thermal_pressurisation",
    "resistance_centripetal_pore_pressure_shaking",
    "resistance_centripetal_pore_pressure_shaking_thermal_pressurisation",
    "resistance_centripetal_pore_pressure_thermal_pressurisation",
    "resistance_centripetal_pore_pressure_viscosity",
    "resistance_centripetal_pore_pressure_viscosity_shaking",
    "resistance_centripetal_pore_pressure_viscosity_shaking_thermal_pressurisation",
    "resistance_centripetal_pore_pressure_viscosity_thermal_pressurisation",
    "resistance_centripetal_shaking",
    "resistance_centripetal_shaking_thermal_pressurisation",
    "resistance_centripetal_thermal_pressurisation",
    "resistance_centripetal_viscosity",
    "resistance_centripetal_viscosity_shaking",
    "resistance_centripetal_viscosity_shaking_thermal_pressurisation",
    "resistance_centripetal_viscosity_thermal_pressurisation",
    "resistance_cohesion",
    "resistance_cohesion_drag",
    "resistance_cohesion_drag_shaking",
    "resistance_cohesion_drag_shaking_thermal_pressurisation",
    "resistance_cohesion_drag_thermal_pressurisation",
    "resistance_cohesion_drag_viscosity",
    "resistance_cohesion_drag_viscosity_shaking",
    "resistance_cohesion_drag_viscosity_shaking_thermal_pressurisation",
    "resistance_cohesion_drag_viscosity_thermal_pressurisation",
    "resistance_cohesion_shaking",
    "resistance_cohesion_shaking_thermal_pressurisation",
    "resistance_cohesion_thermal_pressurisation",
    "resistance_cohesion_viscosity",
    "resistance_cohesion_viscosity_shaking",
    "resistance_cohesion_viscosity_shaking_thermal_pressurisation",
    "resistance_cohesion_viscosity_thermal_pressurisation",
    "resistance_drag",
    "resistance_drag_shaking",
    "resistance_drag_shaking_thermal_pressurisation",
    "resistance_drag_thermal_pressurisation",
    "resistance_drag_viscosity",
    "resistance_drag_viscosity_shaking",
    "resistance_drag_viscosity_shaking_thermal_pressurisation",
    "resistance_drag_viscosity_thermal_pressurisation",
    "resistance_pore_pressure",
    "resistance_pore_pressure_cohesion",
    "resistance_pore_pressure_cohesion_drag",
    "resistance_pore_pressure_cohesion_drag_shaking",
    "resistance_pore_pressure_cohesion_drag_shaking_thermal_pressurisation",
    "resistance_pore_pressure_cohesion_drag_thermal_pressurisation",
    "resistance_pore_pressure_cohesion_drag_viscosity",
    "resistance_pore_pressure_cohesion_drag_viscosity_shaking",
    "resistance_pore_pressure_cohesion_drag_viscosity_shaking_thermal_pressurisation",
    "resistance_pore_pressure_cohesion_drag_viscosity_thermal_pressurisation",
    "resistance_pore_pressure_cohesion_shaking",
    "resistance_pore_pressure_cohesion_shaking_thermal_pressurisation",
    "resistance_pore_pressure_cohesion_thermal_pressurisation",
    "resistance_pore_pressure_cohesion_viscosity",
    "resistance_pore_pressure_cohesion_viscosity_shaking",
    "resistance_pore_pressure_cohesion_viscosity_shaking_thermal_pressurisation",
    "resistance_pore_pressure_cohesion_viscosity_thermal_pressurisation",
    "resistance_pore_pressure_drag",
    "resistance_pore_pressure_drag_shaking",
    "resistance_pore_pressure_drag_shaking_thermal_pressurisation",
    "resistance_pore_pressure_drag_thermal_pressurisation",
    "resistance_pore_pressure_drag_viscosity",
    "resistance_pore_pressure_drag_viscosity_shaking",
    "resistance_pore_pressure_drag_viscosity_shaking_thermal_pressurisation",
    "resistance_pore_pressure_drag_viscosity_thermal_pressurisation",
    "resistance_pore_pressure_shaking",
    "resistance_pore_pressure_shaking_thermal_pressurisation",
    "resistance_pore_pressure_thermal_pressurisation",
    "resistance_pore_pressure_viscosity",
    "resistance_pore_pressure_viscosity_shaking",
    "resistance_pore_pressure_viscosity_shaking_thermal_pressurisation",
    "resistance_pore_pressure_viscosity_thermal_pressurisation",
    "resistance_shaking",
    "resistance_shaking_thermal_pressurisation",
    "resistance_thermal_pressurisation",
    "resistance_viscosity",
    "resistance_viscosity_shaking",
    "resistance_viscosity_shaking_thermal_pressurisation",
    "resistance_viscosity_thermal_pressurisation",
    "tilt",
    "tilt_pore_pressure",
    "tilt_pore_pressure_shaking",
    "tilt_shaking",
]

SERIES_1 = (-0.16666666666666666, 0.008333333333333333, -0.0001984126984126984,
        2.7557319223985893e-06, -2.505210838544172e-08, 1.6059043836821613e-10, -7.647163731819816e-13,
        2.8114572543455206e-15, -8.22063524662433e-18, 1.9572941063391263e-20, -3.868170170630684e-23,
        6.446950284384474e-26, -9.183689863795546e-29)
SERIES_2 = (0.5, 0.16666666666666666, 0.041666666666666664, 0.008333333333333333, 0.001388888888888889,
        0.0001984126984126984, 2.48015873015873e-05, 2.7557319223985893e-06, 2.755731922398589e-07,
        2.505210838544172e-08, 2.08767569878681e-09, 1.6059043836821613e-10, 1.1470745597729725e-11,
        7.647163731819816e-13, 4.779477332387385e-14, 2.8114572543455206e-15, 1.5619206968586225e-16,
        8.22063524662433e-18)


def brake_centripetal(polar: Any, mu: Any) -> Any:
    """Brake. Operations: 1 mul."""
    return mu * polar


def brake_centripetal_drag(polar: Any, mu: Any, drag: Any) -> Any:
    """Brake. Operations: 1 mul, 1 add."""
    return drag + mu * polar


def brake_drag(drag: Any) -> Any:
    """Brake. Operations: none."""
    return drag


def constant_cohesion(level: Any, cohesion: Any) -> Any:
    """Constant. Operations: 1 mul."""
    return cohesion * level


def constant_cohesion_thermal_pressurisation(level: Any, mu: Any, cohesion: Any, excess: Any) -> Any:
    """Constant. Operations: 2 mul, 1 sub."""
    return (cohesion - excess * mu) * level


def constant_pore_pressure(level: Any, mu: Any, pore_pressure: Any) -> Any:
    """Constant. Operations: 2 mul, 1 neg."""
    return -(level * mu * pore_pressure)


def constant_pore_pressure_cohesion(level: Any, mu: Any, pore_pressure: Any, cohesion: Any) -> Any:
    """Constant. Operations: 2 mul, 1 sub."""
    return (cohesion - mu * pore_pressure) * level


def constant_pore_pressure_cohesion_thermal_pressurisation(level: Any, mu: Any, pore_pressure: Any, cohesion: Any,
        excess: Any) -> Any:
    """Constant. Operations: 3 mul, 2 sub."""
    return (cohesion - excess * mu - mu * pore_pressure) * level


def constant_pore_pressure_thermal_pressurisation(level: Any, mu: Any, pore_pressure: Any, excess: Any) -> Any:
    """Constant. Operations: 2 mul, 1 add, 1 neg."""
    return -((excess + pore_pressure) * level * mu)


def constant_thermal_pressurisation(level: Any, mu: Any, excess: Any) -> Any:
    """Constant. Operations: 2 mul, 1 neg."""
    return -(excess * level * mu)


def damping_viscosity(viscosity: Any) -> Any:
    """Damping. Operations: none."""
    return viscosity


def drive(press: Any, mu: Any, limit_friction: Any) -> Any:
    """Drive. Operations: 1 mul, 1 sub."""
    return (limit_friction - mu) * press


def drive_pore_pressure(press: Any, level: Any, mu: Any, pore_ratio: Any, pore_pressure: Any,
        limit_friction: Any) -> Any:
    """Drive. Operations: 3 mul, 3 sub."""
    b = 1.0 - pore_ratio
    return (limit_friction - mu) * (b * press - level * pore_pressure)


def drive_pore_pressure_shaking(press: Any, press_slope: Any, level: Any, mu: Any, pore_ratio: Any, pore_pressure: Any,
        k_h: Any, k_v: Any, limit_friction: Any) -> Any:
    """Drive. Operations: 4 mul, 1 add, 4 sub."""
    b = 1.0 - k_v
    t1 = k_h * press_slope + (b - pore_ratio) * press - level * pore_pressure
    return (limit_friction - mu) * t1


def drive_pore_pressure_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, mu: Any,
        pore_ratio: Any, pore_pressure: Any, k_h: Any, k_v: Any, excess: Any, limit_friction: Any) -> Any:
    """Drive. Operations: 5 mul, 1 add, 5 sub."""
    b = 1.0 - k_v
    t1 = k_h * press_slope + (b - pore_ratio) * press - excess * level - level * pore_pressure
    return (limit_friction - mu) * t1


def drive_pore_pressure_thermal_pressurisation(press: Any, level: Any, mu: Any, pore_ratio: Any, pore_pressure: Any,
        excess: Any, limit_friction: Any) -> Any:
    """Drive. Operations: 4 mul, 4 sub."""
    b = 1.0 - pore_ratio
    return (limit_friction - mu) * (b * press - excess * level - level * pore_pressure)


def drive_shaking(press: Any, press_slope: Any, mu: Any, k_h: Any, k_v: Any, limit_friction: Any) -> Any:
    """Drive. Operations: 3 mul, 1 add, 2 sub."""
    b = 1.0 - k_v
    return (limit_friction - mu) * (k_h * press_slope + b * press)


def drive_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, mu: Any, k_h: Any, k_v: Any,
        excess: Any, limit_friction: Any) -> Any:
    """Drive. Operations: 4 mul, 1 add, 3 sub."""
    b = 1.0 - k_v
    return (limit_friction - mu) * (k_h * press_slope + b * press - excess * level)


def drive_thermal_pressurisation(press: Any, level: Any, mu: Any, excess: Any, limit_friction: Any) -> Any:
    """Drive. Operations: 2 mul, 2 sub."""
    return (limit_friction - mu) * (press - excess * level)


def drop_exponential(slip: Any, more: Any, peak: Any, residual: Any, length: Any) -> Any:
    """Its fall over `more` slip, from `slip`. Operations: 2 mul, 1 sub, 2 div, 3 neg, 1 exp, 1 expm1."""
    t1 = (peak - residual) * np.exp(-(slip / length)) * np.expm1(-(more / length))
    return -t1


def drop_hyperbolic(slip: Any, more: Any, peak: Any, residual: Any, length: Any) -> Any:
    """Its fall over `more` slip, from `slip`. Operations: 3 mul, 3 add, 1 sub, 1 div."""
    return (peak - residual) / ((length + slip) * (length + more + slip)) * length * more


def drop_linear(slip: Any, more: Any, peak: Any, residual: Any, length: Any) -> Any:
    """Its fall over `more` slip, from `slip`. Operations: 1 mul, 1 add, 2 sub, 2 div, 2 min."""
    t1 = slip / length
    return (peak - residual) * (np.minimum(1.0, more / length + t1) - np.minimum(1.0, t1))


def effective_stress(press: Any, level: Any) -> Any:
    """effective_stress. Operations: 1 div."""
    return press / level


def effective_stress_centripetal(press: Any, level: Any, polar: Any, omega_2: Any) -> Any:
    """effective_stress. Operations: 1 mul, 1 add, 1 div."""
    return (press + omega_2 * polar) / level


def effective_stress_centripetal_pore_pressure(press: Any, level: Any, polar: Any, omega_2: Any, pore_ratio: Any,
        pore_pressure: Any) -> Any:
    """effective_stress. Operations: 3 mul, 1 add, 2 sub, 1 div."""
    b = 1.0 - pore_ratio
    return (omega_2 * polar + b * press - level * pore_pressure) / level


def effective_stress_centripetal_pore_pressure_shaking(press: Any, press_slope: Any, level: Any, polar: Any,
        omega_2: Any, pore_ratio: Any, pore_pressure: Any, k_h: Any, k_v: Any) -> Any:
    """effective_stress. Operations: 4 mul, 2 add, 3 sub, 1 div."""
    b = 1.0 - k_v
    t1 = k_h * press_slope + omega_2 * polar + (b - pore_ratio) * press - level * pore_pressure
    return t1 / level


def effective_stress_centripetal_pore_pressure_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any,
        polar: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """effective_stress. Operations: 5 mul, 2 add, 4 sub, 1 div."""
    b = 1.0 - k_v
    t1 = k_h * press_slope + omega_2 * polar + (b - pore_ratio) * press - excess * level
    return (t1 - level * pore_pressure) / level


def effective_stress_centripetal_pore_pressure_thermal_pressurisation(press: Any, level: Any, polar: Any, omega_2: Any,
        pore_ratio: Any, pore_pressure: Any, excess: Any) -> Any:
    """effective_stress. Operations: 4 mul, 1 add, 3 sub, 1 div."""
    b = 1.0 - pore_ratio
    return (omega_2 * polar + b * press - excess * level - level * pore_pressure) / level


def effective_stress_centripetal_shaking(press: Any, press_slope: Any, level: Any, polar: Any, omega_2: Any, k_h: Any,
        k_v: Any) -> Any:
    """effective_stress. Operations: 3 mul, 2 add, 1 sub, 1 div."""
    b = 1.0 - k_v
    return (k_h * press_slope + omega_2 * polar + b * press) / level


def effective_stress_centripetal_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, polar: Any,
        omega_2: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """effective_stress. Operations: 4 mul, 2 add, 2 sub, 1 div."""
    b = 1.0 - k_v
    return (k_h * press_slope + omega_2 * polar + b * press - excess * level) / level


def effective_stress_centripetal_thermal_pressurisation(press: Any, level: Any, polar: Any, omega_2: Any,
        excess: Any) -> Any:
    """effective_stress. Operations: 2 mul, 1 add, 1 sub, 1 div."""
    return (press + omega_2 * polar - excess * level) / level


def effective_stress_pore_pressure(press: Any, level: Any, pore_ratio: Any, pore_pressure: Any) -> Any:
    """effective_stress. Operations: 2 mul, 2 sub, 1 div."""
    b = 1.0 - pore_ratio
    return (b * press - level * pore_pressure) / level


def effective_stress_pore_pressure_shaking(press: Any, press_slope: Any, level: Any, pore_ratio: Any,
        pore_pressure: Any, k_h: Any, k_v: Any) -> Any:
    """effective_stress. Operations: 3 mul, 1 add, 3 sub, 1 div."""
    b = 1.0 - k_v
    return (k_h * press_slope + (b - pore_ratio) * press - level * pore_pressure) / level


def effective_stress_pore_pressure_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any,
        pore_ratio: Any, pore_pressure: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """effective_stress. Operations: 4 mul, 1 add, 4 sub, 1 div."""
    b = 1.0 - k_v
    t1 = k_h * press_slope + (b - pore_ratio) * press - excess * level - level * pore_pressure
    return t1 / level


def effective_stress_pore_pressure_thermal_pressurisation(press: Any, level: Any, pore_ratio: Any, pore_pressure: Any,
        excess: Any) -> Any:
    """effective_stress. Operations: 3 mul, 3 sub, 1 div."""
    b = 1.0 - pore_ratio
    return (b * press - excess * level - level * pore_pressure) / level


def effective_stress_shaking(press: Any, press_slope: Any, level: Any, k_h: Any, k_v: Any) -> Any:
    """effective_stress. Operations: 2 mul, 1 add, 1 sub, 1 div."""
    b = 1.0 - k_v
    return (k_h * press_slope + b * press) / level


def effective_stress_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, k_h: Any, k_v: Any,
        excess: Any) -> Any:
    """effective_stress. Operations: 3 mul, 1 add, 2 sub, 1 div."""
    b = 1.0 - k_v
    return (k_h * press_slope + b * press - excess * level) / level


def effective_stress_thermal_pressurisation(press: Any, level: Any, excess: Any) -> Any:
    """effective_stress. Operations: 1 mul, 1 sub, 1 div."""
    return (press - excess * level) / level


def energy(x: Any, start: Any, drive: Any, tilt: Any) -> Any:
    """Constant friction, nothing that grows with the speed. Operations: 6 mul, 1 add, 1 sub, 2 sin."""
    t1 = np.sin(0.5 * x)
    return start + 2.0 * np.sin(x) * drive - 4.0 * (t1 * t1) * tilt


def energy_braked(x: Any, start: Any, drive: Any, tilt: Any, brake: Any) -> Any:
    """Constant friction, centripetal stress or drag. Operations: 59 mul, 34 add, 4 sub, 3 div, 1 neg, 1 min, 1
    max, 2 less, 4 select, 1 abs, 2 exp, 1 expm1, 2 sin."""
    t1 = -(2.0 * brake * x)
    t2 = 2.0 * np.abs(brake * x)
    t3 = t2 < 8.673617379884035e-19
    t4 = np.where(t3, 1.0, t1)
    t5 = np.sin(0.5 * x)
    t6 = 2.0 * (t5 * t5)
    t7 = 2.0 * (2.0 * np.where(t3, 1.0, np.expm1(t4) / t4) * brake * x - t6) * brake
    x_2 = x * x
    p1 = horner(x_2, SERIES_1)
    t8 = np.maximum(-1.0, np.minimum(1.0, t1))
    p2 = horner(t8, SERIES_2)
    t9 = t2 < 1.0
    t10 = np.where(t9, 1.0, t1)
    t11 = 4.0 * np.where(t9, p2, (np.exp(t10) - 1.0 - t10) / (t10 * t10)) * brake * brake
    t12 = (t7 + np.sin(x)) * drive - (2.0 * p1 * brake * x * x * x + t11 * x * x + t6) * tilt
    return np.exp(t1) * start + 2.0 * t12 / (1.0 + 4.0 * brake * brake)


def energy_braked_constant(x: Any, start: Any, drive: Any, tilt: Any, constant: Any, brake: Any) -> Any:
    """Constant friction, centripetal stress or drag. Operations: 69 mul, 36 add, 5 sub, 3 div, 1 neg, 1 min, 1
    max, 2 less, 4 select, 1 abs, 2 exp, 1 expm1, 2 sin."""
    t1 = -(2.0 * brake * x)
    x_2 = x * x
    p1 = horner(x_2, SERIES_1)
    t2 = 2.0 * np.abs(brake * x)
    t3 = np.maximum(-1.0, np.minimum(1.0, t1))
    p2 = horner(t3, SERIES_2)
    t4 = t2 < 1.0
    t5 = np.where(t4, 1.0, t1)
    t6 = np.where(t4, p2, (np.exp(t5) - 1.0 - t5) / (t5 * t5))
    t7 = np.sin(0.5 * x)
    t8 = t7 * t7
    t9 = (p1 * x * x * x + 2.0 * t6 * brake * x * x - 4.0 * t8 * brake) * constant
    t10 = t2 < 8.673617379884035e-19
    t11 = np.where(t10, 1.0, t1)
    t12 = 2.0 * t8
    t13 = 2.0 * (2.0 * np.where(t10, 1.0, np.expm1(t11) / t11) * brake * x - t12) * brake
    t14 = (2.0 * p1 * brake * x * x * x + 4.0 * t6 * brake * brake * x * x + t12) * tilt
    t15 = 2.0 * (t9 + (t13 + np.sin(x)) * drive - t14) / (1.0 + 4.0 * brake * brake)
    return np.exp(t1) * start + t15


def energy_constant(x: Any, start: Any, drive: Any, tilt: Any, constant: Any) -> Any:
    """Constant friction, nothing that grows with the speed. Operations: 23 mul, 14 add, 1 sub, 2 sin."""
    x_2 = x * x
    p1 = horner(x_2, SERIES_1)
    t1 = np.sin(0.5 * x)
    t2 = 2.0 * (np.sin(x) * drive + p1 * constant * x * x * x - 2.0 * (t1 * t1) * tilt)
    return start + t2


def energy_softening(x: Any, start: Any, drive: Any, tilt: Any, drop: Any, decay: Any, press: Any,
        press_rise: Any) -> Any:
    """Exponential softening, no brake. Operations: 73 mul, 38 add, 5 sub, 4 div, 1 neg, 1 min, 1 max, 2 less, 4
    select, 1 abs, 2 exp, 1 expm1, 2 sin."""
    t1 = np.sin(x)
    x_2 = x * x
    p1 = horner(x_2, SERIES_1)
    t2 = decay * x
    t3 = np.abs(t2)
    t4 = -t2
    t5 = np.maximum(-1.0, np.minimum(1.0, t4))
    p2 = horner(t5, SERIES_2)
    t6 = t3 < 1.0
    t7 = np.where(t6, 1.0, t4)
    t8 = np.where(t6, p2, (np.exp(t7) - 1.0 - t7) / (t7 * t7)) * decay * decay
    t9 = t3 < 8.673617379884035e-19
    t10 = np.where(t9, 1.0, t4)
    t11 = np.where(t9, 1.0, np.expm1(t10) / t10)
    t12 = p1 * decay * decay * x * x * x + t8 * decay * x * x + t1 * t11 * decay * x
    t13 = np.exp(t4)
    t14 = np.sin(0.5 * x)
    t15 = t14 * t14
    decay_2 = decay * decay
    t16 = 1.0 + decay_2
    t17 = t11 * decay
    t18 = 2.0 * (decay_2 + t17 * x) * t15 + t8 * x * x + t13 * p1 * decay * x * x * x
    t19 = (t18 - t17 * decay * x * x) / t16 * press_rise
    t20 = 2.0 * ((t12 - 2.0 * t13 * t15 * decay) / t16 * press + t19) * drop
    return start + 2.0 * t1 * drive + t20 - 4.0 * t15 * tilt


def energy_softening_constant(x: Any, start: Any, drive: Any, tilt: Any, constant: Any, drop: Any, decay: Any,
        press: Any, press_rise: Any) -> Any:
    """Exponential softening, no brake. Operations: 77 mul, 39 add, 5 sub, 4 div, 1 neg, 1 min, 1 max, 2 less, 4
    select, 1 abs, 2 exp, 1 expm1, 2 sin."""
    x_2 = x * x
    p1 = horner(x_2, SERIES_1)
    t1 = decay * x
    t2 = np.abs(t1)
    t3 = -t1
    t4 = np.maximum(-1.0, np.minimum(1.0, t3))
    p2 = horner(t4, SERIES_2)
    t5 = t2 < 1.0
    t6 = np.where(t5, 1.0, t3)
    t7 = np.where(t5, p2, (np.exp(t6) - 1.0 - t6) / (t6 * t6)) * decay * decay
    t8 = np.sin(x)
    t9 = t2 < 8.673617379884035e-19
    t10 = np.where(t9, 1.0, t3)
    t11 = np.where(t9, 1.0, np.expm1(t10) / t10)
    t12 = p1 * decay * decay * x * x * x + t7 * decay * x * x + t8 * t11 * decay * x
    t13 = np.exp(t3)
    t14 = np.sin(0.5 * x)
    t15 = t14 * t14
    decay_2 = decay * decay
    t16 = 1.0 + decay_2
    t17 = t11 * decay
    t18 = 2.0 * (decay_2 + t17 * x) * t15 + t7 * x * x + t13 * p1 * decay * x * x * x
    t19 = (t18 - t17 * decay * x * x) / t16 * press_rise
    t20 = start + 2.0 * ((t12 - 2.0 * t13 * t15 * decay) / t16 * press + t19) * drop
    return t20 + 2.0 * (t8 * drive + p1 * constant * x * x * x - 2.0 * t15 * tilt)


def energy_softening_constant_water(x: Any, start: Any, drive: Any, tilt: Any, constant: Any, drop: Any, decay: Any,
        press: Any, press_rise: Any, water: Any) -> Any:
    """Exponential softening, no brake. Operations: 80 mul, 39 add, 6 sub, 4 div, 1 neg, 1 min, 1 max, 2 less, 4
    select, 1 abs, 2 exp, 1 expm1, 2 sin."""
    x_2 = x * x
    p1 = horner(x_2, SERIES_1)
    t1 = decay * x
    t2 = np.abs(t1)
    t3 = -t1
    t4 = np.maximum(-1.0, np.minimum(1.0, t3))
    p2 = horner(t4, SERIES_2)
    t5 = t2 < 1.0
    t6 = np.where(t5, 1.0, t3)
    t7 = np.where(t5, p2, (np.exp(t6) - 1.0 - t6) / (t6 * t6)) * decay
    t8 = t7 * decay
    t9 = np.sin(x)
    t10 = t2 < 8.673617379884035e-19
    t11 = np.where(t10, 1.0, t3)
    t12 = np.where(t10, 1.0, np.expm1(t11) / t11)
    t13 = p1 * decay * decay * x * x * x + t8 * decay * x * x + t9 * t12 * decay * x
    t14 = np.exp(t3)
    t15 = np.sin(0.5 * x)
    t16 = t15 * t15
    decay_2 = decay * decay
    t17 = 1.0 + decay_2
    t18 = t12 * decay
    t19 = 2.0 * (decay_2 + t18 * x) * t16 + t8 * x * x + t14 * p1 * decay * x * x * x
    t20 = (t19 - t18 * decay * x * x) / t17 * press_rise
    t21 = 2.0 * ((t13 - 2.0 * t14 * t16 * decay) / t17 * press + t20 - t7 * water * x * x)
    return start + t21 * drop + 2.0 * (t9 * drive + p1 * constant * x * x * x - 2.0 * t16 * tilt)


def fall_shaking(fall: Any, fall_slope: Any, k_h: Any, k_v: Any) -> Any:
    """Fall. Operations: 2 mul, 1 add, 1 sub."""
    b = 1.0 - k_v
    return b * fall + fall_slope * k_h


def friction_exponential(slip: Any, peak: Any, residual: Any, length: Any) -> Any:
    """Friction: residual + (peak - residual) exp(-slip/length). Operations: 1 mul, 1 add, 1 sub, 1 div, 1 neg,
    1 exp."""
    return residual + (peak - residual) * np.exp(-(slip / length))


def friction_hyperbolic(slip: Any, peak: Any, residual: Any, length: Any) -> Any:
    """Friction: residual + (peak - residual)/(1 + slip/length). Operations: 2 add, 1 sub, 2 div."""
    return residual + (peak - residual) / (1.0 + slip / length)


def friction_linear(slip: Any, peak: Any, residual: Any, length: Any) -> Any:
    """Friction: falls from peak to residual over the length, then stays. Operations: 1 mul, 1 add, 1 sub, 1
    div, 1 min."""
    return peak + (residual - peak) * np.minimum(1.0, slip / length)


def friction_rate_weakening(speed: Any, peak: Any, residual: Any, velocity: Any) -> Any:
    """Friction: residual + (peak - residual)/(1 + speed/velocity). Operations: 2 add, 1 sub, 2 div."""
    return residual + (peak - residual) / (1.0 + speed / velocity)


def frozen_braked_state(a: Any, b: Any, omega_0: Any, t: Any) -> tuple[Any, Any, Any]:
    """Rotation, velocity and acceleration at a time. Operations: 55 mul, 36 add, 3 sub, 8 div, 1 neg, 4 min, 3
    max, 4 less, 18 select, 3 abs, 1 exp, 1 log, 1 log1p, 2 sign, 2 sqrt."""
    k = np.sqrt(np.abs(a)) * np.sqrt(np.abs(b))
    x = np.minimum(t, 800.0 / np.maximum(1e-300, k)) * k
    z = np.sign(a) * np.sign(b) * x * x
    near = np.maximum(-9.869604401089358, np.minimum(1.0, z))
    t1 = 1.0 < z
    far = np.where(t1, 0.0, t)
    e = np.exp(-x)
    q = e * e
    t2 = b * omega_0
    P = k + t2
    M = k - t2
    t3 = M * q
    p1 = horner(near, (0.5, 0.041666666666666664, 0.001388888888888889, 2.48015873015873e-05,
        2.755731922398589e-07, 2.08767569878681e-09, 1.1470745597729725e-11, 4.779477332387385e-14,
        1.5619206968586225e-16, 4.110317623312165e-19, 8.896791392450574e-22, 1.6117375710961184e-24,
        2.4795962632247976e-27, 3.279889237069838e-30))
    t4 = p1 * near
    p2 = horner(near, (1.0, 0.16666666666666666, 0.008333333333333333, 0.0001984126984126984,
        2.7557319223985893e-06, 2.505210838544172e-08, 1.6059043836821613e-10, 7.647163731819816e-13,
        2.8114572543455206e-15, 8.22063524662433e-18, 1.9572941063391263e-20, 3.868170170630684e-23,
        6.446950284384474e-26, 9.183689863795546e-29))
    y = np.where(t1, 0.5 * (P + t3) / np.where(t1, k, 1.0), 1.0 + t4 + p2 * b * far * omega_0)
    G = p1 * a * far * far + p2 * far * omega_0
    t5 = G * b
    y_near = np.where(t1, y, 1.0 + t5)
    t6 = 9.869604401089358 + z
    t7 = 0.0 < np.minimum(y, t6)
    t8 = np.where(t7, y, 1.0)
    decay = np.where(t1, e, 1.0) / t8
    t9 = 0.0 < np.minimum(y_near, t6)
    t10 = np.where(t1, b, 1.0)
    t11 = np.where(t1, 0.0, np.maximum(-0.9999999999999999, t5))
    t12 = np.abs(t11) < 8.673617379884035e-19
    t13 = np.where(t12, 1.0, t11)
    t14 = (np.where(t1, t, 0.0) * k + np.log(np.where(t9, y_near, 1.0))) / t10
    t15 = np.where(t1, 0.5 * (P - t3) / t10, omega_0 + p2 * a * far + t4 * omega_0)
    return (np.where(t9, np.where(t1, t14, np.where(t12, 1.0, np.log1p(t13) / t13) * G), np.nan), np.where(t7, t15 / t8,
        np.nan), np.where(t7, np.where(t1, M / t10 * P, a - t2 * omega_0) * decay * decay, np.nan))


def frozen_state(a: Any, omega_0: Any, t: Any) -> tuple[Any, Any, Any]:
    """Rotation, velocity and acceleration at a time. Operations: 4 mul, 2 add."""
    return (omega_0 + 0.5 * a * t) * t, omega_0 + a * t, a


def limit_friction(static_limit: Any) -> Any:
    """limit_friction. Operations: none."""
    return static_limit


def limit_friction_cohesion(static_limit: Any, press: Any, level: Any, cohesion: Any) -> Any:
    """limit_friction. Operations: 2 mul, 1 sub, 1 div."""
    return (press * static_limit - cohesion * level) / press


def limit_friction_cohesion_shaking(static_limit: Any, press: Any, fall_slope: Any, press_slope: Any, level: Any,
        cohesion: Any, k_h: Any, k_v: Any) -> Any:
    """limit_friction. Operations: 7 mul, 2 add, 3 sub, 1 div."""
    t1 = fall_slope * k_h + press * static_limit - cohesion * level - k_v * press * static_limit
    b = 1.0 - k_v
    return t1 / (k_h * press_slope + b * press)


def limit_friction_cohesion_shaking_thermal_pressurisation(static_limit: Any, press: Any, fall_slope: Any,
        press_slope: Any, level: Any, cohesion: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """limit_friction. Operations: 8 mul, 2 add, 4 sub, 1 div."""
    t1 = fall_slope * k_h + press * static_limit - cohesion * level - k_v * press * static_limit
    b = 1.0 - k_v
    return t1 / (k_h * press_slope + b * press - excess * level)


def limit_friction_cohesion_thermal_pressurisation(static_limit: Any, press: Any, level: Any, cohesion: Any,
        excess: Any) -> Any:
    """limit_friction. Operations: 3 mul, 2 sub, 1 div."""
    return (press * static_limit - cohesion * level) / (press - excess * level)


def limit_friction_pore_pressure(static_limit: Any, press: Any, level: Any, pore_ratio: Any, pore_pressure: Any) -> Any:
    """limit_friction. Operations: 3 mul, 2 sub, 1 div."""
    b = 1.0 - pore_ratio
    return press / (b * press - level * pore_pressure) * static_limit


def limit_friction_pore_pressure_cohesion(static_limit: Any, press: Any, level: Any, pore_ratio: Any,
        pore_pressure: Any, cohesion: Any) -> Any:
    """limit_friction. Operations: 4 mul, 3 sub, 1 div."""
    b = 1.0 - pore_ratio
    return (press * static_limit - cohesion * level) / (b * press - level * pore_pressure)


def limit_friction_pore_pressure_cohesion_shaking(static_limit: Any, press: Any, fall_slope: Any, press_slope: Any,
        level: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, k_h: Any, k_v: Any) -> Any:
    """limit_friction. Operations: 8 mul, 2 add, 5 sub, 1 div."""
    t1 = fall_slope * k_h + press * static_limit - cohesion * level - k_v * press * static_limit
    b = 1.0 - k_v
    return t1 / (k_h * press_slope + (b - pore_ratio) * press - level * pore_pressure)


def limit_friction_pore_pressure_cohesion_shaking_thermal_pressurisation(static_limit: Any, press: Any, fall_slope: Any,
        press_slope: Any, level: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, k_h: Any, k_v: Any,
        excess: Any) -> Any:
    """limit_friction. Operations: 9 mul, 2 add, 6 sub, 1 div."""
    t1 = fall_slope * k_h + press * static_limit - cohesion * level - k_v * press * static_limit
    b = 1.0 - k_v
    t2 = k_h * press_slope + (b - pore_ratio) * press - excess * level - level * pore_pressure
    return t1 / t2


def limit_friction_pore_pressure_cohesion_thermal_pressurisation(static_limit: Any, press: Any, level: Any,
        pore_ratio: Any, pore_pressure: Any, cohesion: Any, excess: Any) -> Any:
    """limit_friction. Operations: 5 mul, 4 sub, 1 div."""
    b = 1.0 - pore_ratio
    t1 = b * press - excess * level - level * pore_pressure
    return (press * static_limit - cohesion * level) / t1


def limit_friction_pore_pressure_shaking(static_limit: Any, press: Any, fall_slope: Any, press_slope: Any, level: Any,
        pore_ratio: Any, pore_pressure: Any, k_h: Any, k_v: Any) -> Any:
    """limit_friction. Operations: 7 mul, 2 add, 4 sub, 1 div."""
    b = 1.0 - k_v
    t1 = fall_slope * k_h + press * static_limit - k_v * press * static_limit
    return t1 / (k_h * press_slope + (b - pore_ratio) * press - level * pore_pressure)


def limit_friction_pore_pressure_shaking_thermal_pressurisation(static_limit: Any, press: Any, fall_slope: Any,
        press_slope: Any, level: Any, pore_ratio: Any, pore_pressure: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """limit_friction. Operations: 8 mul, 2 add, 5 sub, 1 div."""
    b = 1.0 - k_v
    t1 = k_h * press_slope + (b - pore_ratio) * press - excess * level - level * pore_pressure
    return (fall_slope * k_h + press * static_limit - k_v * press * static_limit) / t1


def limit_friction_pore_pressure_thermal_pressurisation(static_limit: Any, press: Any, level: Any, pore_ratio: Any,
        pore_pressure: Any, excess: Any) -> Any:
    """limit_friction. Operations: 4 mul, 3 sub, 1 div."""
    b = 1.0 - pore_ratio
    return press / (b * press - excess * level - level * pore_pressure) * static_limit


def limit_friction_shaking(static_limit: Any, press: Any, fall_slope: Any, press_slope: Any, k_h: Any, k_v: Any) -> Any:
    """limit_friction. Operations: 6 mul, 2 add, 2 sub, 1 div."""
    b = 1.0 - k_v
    t1 = fall_slope * k_h + press * static_limit - k_v * press * static_limit
    return t1 / (k_h * press_slope + b * press)


def limit_friction_shaking_thermal_pressurisation(static_limit: Any, press: Any, fall_slope: Any, press_slope: Any,
        level: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """limit_friction. Operations: 7 mul, 2 add, 3 sub, 1 div."""
    b = 1.0 - k_v
    t1 = fall_slope * k_h + press * static_limit - k_v * press * static_limit
    return t1 / (k_h * press_slope + b * press - excess * level)


def limit_friction_thermal_pressurisation(static_limit: Any, press: Any, level: Any, excess: Any) -> Any:
    """limit_friction. Operations: 2 mul, 1 sub, 1 div."""
    return press / (press - excess * level) * static_limit


def normal(press: Any) -> Any:
    """Normal. Operations: none."""
    return press


def normal_pore_pressure(press: Any, level: Any, pore_ratio: Any, pore_pressure: Any) -> Any:
    """Normal. Operations: 2 mul, 2 sub."""
    b = 1.0 - pore_ratio
    return b * press - level * pore_pressure


def normal_pore_pressure_shaking(press: Any, press_slope: Any, level: Any, pore_ratio: Any, pore_pressure: Any,
        k_h: Any, k_v: Any) -> Any:
    """Normal. Operations: 3 mul, 1 add, 3 sub."""
    b = 1.0 - k_v
    return k_h * press_slope + (b - pore_ratio) * press - level * pore_pressure


def normal_pore_pressure_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, pore_ratio: Any,
        pore_pressure: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Normal. Operations: 4 mul, 1 add, 4 sub."""
    b = 1.0 - k_v
    return k_h * press_slope + (b - pore_ratio) * press - excess * level - level * pore_pressure


def normal_pore_pressure_thermal_pressurisation(press: Any, level: Any, pore_ratio: Any, pore_pressure: Any,
        excess: Any) -> Any:
    """Normal. Operations: 3 mul, 3 sub."""
    b = 1.0 - pore_ratio
    return b * press - excess * level - level * pore_pressure


def normal_shaking(press: Any, press_slope: Any, k_h: Any, k_v: Any) -> Any:
    """Normal. Operations: 2 mul, 1 add, 1 sub."""
    b = 1.0 - k_v
    return k_h * press_slope + b * press


def normal_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, k_h: Any, k_v: Any,
        excess: Any) -> Any:
    """Normal. Operations: 3 mul, 1 add, 2 sub."""
    b = 1.0 - k_v
    return k_h * press_slope + b * press - excess * level


def normal_stress(press: Any, level: Any) -> Any:
    """normal_stress. Operations: 1 div."""
    return press / level


def normal_stress_centripetal(press: Any, level: Any, polar: Any, omega_2: Any) -> Any:
    """normal_stress. Operations: 1 mul, 1 add, 1 div."""
    return (press + omega_2 * polar) / level


def normal_stress_centripetal_shaking(press: Any, press_slope: Any, level: Any, polar: Any, omega_2: Any, k_h: Any,
        k_v: Any) -> Any:
    """normal_stress. Operations: 3 mul, 2 add, 1 sub, 1 div."""
    b = 1.0 - k_v
    return (k_h * press_slope + omega_2 * polar + b * press) / level


def normal_stress_shaking(press: Any, press_slope: Any, level: Any, k_h: Any, k_v: Any) -> Any:
    """normal_stress. Operations: 2 mul, 1 add, 1 sub, 1 div."""
    b = 1.0 - k_v
    return (k_h * press_slope + b * press) / level


def normal_thermal_pressurisation(press: Any, level: Any, excess: Any) -> Any:
    """Normal. Operations: 1 mul, 1 sub."""
    return press - excess * level


def pressurisation_centripetal_pore_pressure_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any,
        polar: Any, mu: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, k_h: Any, k_v: Any, kappa: Any,
        excess: Any) -> Any:
    """Pressurisation. Operations: 7 mul, 2 add, 4 sub, 1 div."""
    b = 1.0 - k_v
    t1 = k_h * press_slope + omega_2 * polar + (b - pore_ratio) * press - excess * level
    return (t1 - level * pore_pressure) / level * kappa * mu


def pressurisation_centripetal_pore_pressure_thermal_pressurisation(press: Any, level: Any, polar: Any, mu: Any,
        omega_2: Any, pore_ratio: Any, pore_pressure: Any, kappa: Any, excess: Any) -> Any:
    """Pressurisation. Operations: 6 mul, 1 add, 3 sub, 1 div."""
    b = 1.0 - pore_ratio
    t1 = (omega_2 * polar + b * press - excess * level - level * pore_pressure) / level
    return t1 * kappa * mu


def pressurisation_centripetal_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, polar: Any,
        mu: Any, omega_2: Any, k_h: Any, k_v: Any, kappa: Any, excess: Any) -> Any:
    """Pressurisation. Operations: 6 mul, 2 add, 2 sub, 1 div."""
    b = 1.0 - k_v
    t1 = (k_h * press_slope + omega_2 * polar + b * press - excess * level) / level
    return t1 * kappa * mu


def pressurisation_centripetal_thermal_pressurisation(press: Any, level: Any, polar: Any, mu: Any, omega_2: Any,
        kappa: Any, excess: Any) -> Any:
    """Pressurisation. Operations: 4 mul, 1 add, 1 sub, 1 div."""
    return (press + omega_2 * polar - excess * level) / level * kappa * mu


def pressurisation_pore_pressure_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, mu: Any,
        pore_ratio: Any, pore_pressure: Any, k_h: Any, k_v: Any, kappa: Any, excess: Any) -> Any:
    """Pressurisation. Operations: 6 mul, 1 add, 4 sub, 1 div."""
    b = 1.0 - k_v
    t1 = k_h * press_slope + (b - pore_ratio) * press - excess * level - level * pore_pressure
    return t1 / level * kappa * mu


def pressurisation_pore_pressure_thermal_pressurisation(press: Any, level: Any, mu: Any, pore_ratio: Any,
        pore_pressure: Any, kappa: Any, excess: Any) -> Any:
    """Pressurisation. Operations: 5 mul, 3 sub, 1 div."""
    b = 1.0 - pore_ratio
    return (b * press - excess * level - level * pore_pressure) / level * kappa * mu


def pressurisation_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, mu: Any, k_h: Any, k_v: Any,
        kappa: Any, excess: Any) -> Any:
    """Pressurisation. Operations: 5 mul, 1 add, 2 sub, 1 div."""
    b = 1.0 - k_v
    return (k_h * press_slope + b * press - excess * level) / level * kappa * mu


def pressurisation_thermal_pressurisation(press: Any, level: Any, mu: Any, kappa: Any, excess: Any) -> Any:
    """Pressurisation. Operations: 3 mul, 1 sub, 1 div."""
    return (press - excess * level) / level * kappa * mu


def resistance(press: Any, mu: Any) -> Any:
    """Resistance. Operations: 1 mul."""
    return mu * press


def resistance_centripetal(press: Any, polar: Any, mu: Any, omega_2: Any) -> Any:
    """Resistance. Operations: 2 mul, 1 add."""
    return (press + omega_2 * polar) * mu


def resistance_centripetal_cohesion(press: Any, level: Any, polar: Any, mu: Any, omega_2: Any, cohesion: Any) -> Any:
    """Resistance. Operations: 3 mul, 2 add."""
    return cohesion * level + (press + omega_2 * polar) * mu


def resistance_centripetal_cohesion_drag(press: Any, level: Any, polar: Any, mu: Any, omega_2: Any, cohesion: Any,
        drag: Any) -> Any:
    """Resistance. Operations: 4 mul, 3 add."""
    return cohesion * level + drag * omega_2 + (press + omega_2 * polar) * mu


def resistance_centripetal_cohesion_drag_shaking(press: Any, press_slope: Any, level: Any, polar: Any, mu: Any,
        omega_2: Any, cohesion: Any, drag: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 6 mul, 4 add, 1 sub."""
    b = 1.0 - k_v
    return cohesion * level + drag * omega_2 + (k_h * press_slope + omega_2 * polar + b * press) * mu


def resistance_centripetal_cohesion_drag_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any,
        polar: Any, mu: Any, omega_2: Any, cohesion: Any, drag: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 7 mul, 4 add, 2 sub."""
    b = 1.0 - k_v
    t1 = (k_h * press_slope + omega_2 * polar + b * press - excess * level) * mu
    return cohesion * level + drag * omega_2 + t1


def resistance_centripetal_cohesion_drag_thermal_pressurisation(press: Any, level: Any, polar: Any, mu: Any,
        omega_2: Any, cohesion: Any, drag: Any, excess: Any) -> Any:
    """Resistance. Operations: 5 mul, 3 add, 1 sub."""
    return cohesion * level + drag * omega_2 + (press + omega_2 * polar - excess * level) * mu


def resistance_centripetal_cohesion_drag_viscosity(press: Any, level: Any, polar: Any, mu: Any, omega: Any,
        omega_2: Any, cohesion: Any, drag: Any, viscosity: Any) -> Any:
    """Resistance. Operations: 5 mul, 4 add."""
    return cohesion * level + drag * omega_2 + (press + omega_2 * polar) * mu + omega * viscosity


def resistance_centripetal_cohesion_drag_viscosity_shaking(press: Any, press_slope: Any, level: Any, polar: Any,
        mu: Any, omega: Any, omega_2: Any, cohesion: Any, drag: Any, viscosity: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 7 mul, 5 add, 1 sub."""
    b = 1.0 - k_v
    t1 = cohesion * level + drag * omega_2 + (k_h * press_slope + omega_2 * polar + b * press) * mu
    return t1 + omega * viscosity


def resistance_centripetal_cohesion_drag_viscosity_shaking_thermal_pressurisation(press: Any, press_slope: Any,
        level: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, cohesion: Any, drag: Any, viscosity: Any, k_h: Any,
        k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 8 mul, 5 add, 2 sub."""
    b = 1.0 - k_v
    t1 = (k_h * press_slope + omega_2 * polar + b * press - excess * level) * mu
    return cohesion * level + drag * omega_2 + t1 + omega * viscosity


def resistance_centripetal_cohesion_drag_viscosity_thermal_pressurisation(press: Any, level: Any, polar: Any, mu: Any,
        omega: Any, omega_2: Any, cohesion: Any, drag: Any, viscosity: Any, excess: Any) -> Any:
    """Resistance. Operations: 6 mul, 4 add, 1 sub."""
    t1 = cohesion * level + drag * omega_2 + (press + omega_2 * polar - excess * level) * mu
    return t1 + omega * viscosity


def resistance_centripetal_cohesion_shaking(press: Any, press_slope: Any, level: Any, polar: Any, mu: Any, omega_2: Any,
        cohesion: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 5 mul, 3 add, 1 sub."""
    b = 1.0 - k_v
    return cohesion * level + (k_h * press_slope + omega_2 * polar + b * press) * mu


def resistance_centripetal_cohesion_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, polar: Any,
        mu: Any, omega_2: Any, cohesion: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 6 mul, 3 add, 2 sub."""
    b = 1.0 - k_v
    return cohesion * level + (k_h * press_slope + omega_2 * polar + b * press - excess * level) * mu


def resistance_centripetal_cohesion_thermal_pressurisation(press: Any, level: Any, polar: Any, mu: Any, omega_2: Any,
        cohesion: Any, excess: Any) -> Any:
    """Resistance. Operations: 4 mul, 2 add, 1 sub."""
    return cohesion * level + (press + omega_2 * polar - excess * level) * mu


def resistance_centripetal_cohesion_viscosity(press: Any, level: Any, polar: Any, mu: Any, omega: Any, omega_2: Any,
        cohesion: Any, viscosity: Any) -> Any:
    """Resistance. Operations: 4 mul, 3 add."""
    return cohesion * level + (press + omega_2 * polar) * mu + omega * viscosity


def resistance_centripetal_cohesion_viscosity_shaking(press: Any, press_slope: Any, level: Any, polar: Any, mu: Any,
        omega: Any, omega_2: Any, cohesion: Any, viscosity: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 6 mul, 4 add, 1 sub."""
    b = 1.0 - k_v
    t1 = cohesion * level + (k_h * press_slope + omega_2 * polar + b * press) * mu
    return t1 + omega * viscosity


def resistance_centripetal_cohesion_viscosity_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any,
        polar: Any, mu: Any, omega: Any, omega_2: Any, cohesion: Any, viscosity: Any, k_h: Any, k_v: Any,
        excess: Any) -> Any:
    """Resistance. Operations: 7 mul, 4 add, 2 sub."""
    b = 1.0 - k_v
    t1 = cohesion * level + (k_h * press_slope + omega_2 * polar + b * press - excess * level) * mu
    return t1 + omega * viscosity


def resistance_centripetal_cohesion_viscosity_thermal_pressurisation(press: Any, level: Any, polar: Any, mu: Any,
        omega: Any, omega_2: Any, cohesion: Any, viscosity: Any, excess: Any) -> Any:
    """Resistance. Operations: 5 mul, 3 add, 1 sub."""
    return cohesion * level + (press + omega_2 * polar - excess * level) * mu + omega * viscosity


def resistance_centripetal_drag(press: Any, polar: Any, mu: Any, omega_2: Any, drag: Any) -> Any:
    """Resistance. Operations: 3 mul, 2 add."""
    return drag * omega_2 + (press + omega_2 * polar) * mu


def resistance_centripetal_drag_shaking(press: Any, press_slope: Any, polar: Any, mu: Any, omega_2: Any, drag: Any,
        k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 5 mul, 3 add, 1 sub."""
    b = 1.0 - k_v
    return drag * omega_2 + (k_h * press_slope + omega_2 * polar + b * press) * mu


def resistance_centripetal_drag_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, polar: Any,
        mu: Any, omega_2: Any, drag: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 6 mul, 3 add, 2 sub."""
    b = 1.0 - k_v
    return drag * omega_2 + (k_h * press_slope + omega_2 * polar + b * press - excess * level) * mu


def resistance_centripetal_drag_thermal_pressurisation(press: Any, level: Any, polar: Any, mu: Any, omega_2: Any,
        drag: Any, excess: Any) -> Any:
    """Resistance. Operations: 4 mul, 2 add, 1 sub."""
    return drag * omega_2 + (press + omega_2 * polar - excess * level) * mu


def resistance_centripetal_drag_viscosity(press: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, drag: Any,
        viscosity: Any) -> Any:
    """Resistance. Operations: 4 mul, 3 add."""
    return drag * omega_2 + (press + omega_2 * polar) * mu + omega * viscosity


def resistance_centripetal_drag_viscosity_shaking(press: Any, press_slope: Any, polar: Any, mu: Any, omega: Any,
        omega_2: Any, drag: Any, viscosity: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 6 mul, 4 add, 1 sub."""
    b = 1.0 - k_v
    return drag * omega_2 + (k_h * press_slope + omega_2 * polar + b * press) * mu + omega * viscosity


def resistance_centripetal_drag_viscosity_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any,
        polar: Any, mu: Any, omega: Any, omega_2: Any, drag: Any, viscosity: Any, k_h: Any, k_v: Any,
        excess: Any) -> Any:
    """Resistance. Operations: 7 mul, 4 add, 2 sub."""
    b = 1.0 - k_v
    t1 = drag * omega_2 + (k_h * press_slope + omega_2 * polar + b * press - excess * level) * mu
    return t1 + omega * viscosity


def resistance_centripetal_drag_viscosity_thermal_pressurisation(press: Any, level: Any, polar: Any, mu: Any,
        omega: Any, omega_2: Any, drag: Any, viscosity: Any, excess: Any) -> Any:
    """Resistance. Operations: 5 mul, 3 add, 1 sub."""
    return drag * omega_2 + (press + omega_2 * polar - excess * level) * mu + omega * viscosity


def resistance_centripetal_pore_pressure(press: Any, level: Any, polar: Any, mu: Any, omega_2: Any, pore_ratio: Any,
        pore_pressure: Any) -> Any:
    """Resistance. Operations: 4 mul, 1 add, 2 sub."""
    b = 1.0 - pore_ratio
    return (omega_2 * polar + b * press - level * pore_pressure) * mu


def resistance_centripetal_pore_pressure_cohesion(press: Any, level: Any, polar: Any, mu: Any, omega_2: Any,
        pore_ratio: Any, pore_pressure: Any, cohesion: Any) -> Any:
    """Resistance. Operations: 5 mul, 2 add, 2 sub."""
    b = 1.0 - pore_ratio
    return cohesion * level + (omega_2 * polar + b * press - level * pore_pressure) * mu


def resistance_centripetal_pore_pressure_cohesion_drag(press: Any, level: Any, polar: Any, mu: Any, omega_2: Any,
        pore_ratio: Any, pore_pressure: Any, cohesion: Any, drag: Any) -> Any:
    """Resistance. Operations: 6 mul, 3 add, 2 sub."""
    b = 1.0 - pore_ratio
    t1 = (omega_2 * polar + b * press - level * pore_pressure) * mu
    return cohesion * level + drag * omega_2 + t1


def resistance_centripetal_pore_pressure_cohesion_drag_shaking(press: Any, press_slope: Any, level: Any, polar: Any,
        mu: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, drag: Any, k_h: Any,
        k_v: Any) -> Any:
    """Resistance. Operations: 7 mul, 4 add, 3 sub."""
    b = 1.0 - k_v
    t1 = k_h * press_slope + omega_2 * polar + (b - pore_ratio) * press - level * pore_pressure
    return cohesion * level + drag * omega_2 + t1 * mu


def resistance_centripetal_pore_pressure_cohesion_drag_shaking_thermal_pressurisation(press: Any, press_slope: Any,
        level: Any, polar: Any, mu: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, drag: Any,
        k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 8 mul, 4 add, 4 sub."""
    b = 1.0 - k_v
    t1 = k_h * press_slope + omega_2 * polar + (b - pore_ratio) * press - excess * level
    return cohesion * level + drag * omega_2 + (t1 - level * pore_pressure) * mu


def resistance_centripetal_pore_pressure_cohesion_drag_thermal_pressurisation(press: Any, level: Any, polar: Any,
        mu: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, drag: Any, excess: Any) -> Any:
    """Resistance. Operations: 7 mul, 3 add, 3 sub."""
    b = 1.0 - pore_ratio
    t1 = (omega_2 * polar + b * press - excess * level - level * pore_pressure) * mu
    return cohesion * level + drag * omega_2 + t1


def resistance_centripetal_pore_pressure_cohesion_drag_viscosity(press: Any, level: Any, polar: Any, mu: Any,
        omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, drag: Any, viscosity: Any) -> Any:
    """Resistance. Operations: 7 mul, 4 add, 2 sub."""
    b = 1.0 - pore_ratio
    t1 = (omega_2 * polar + b * press - level * pore_pressure) * mu
    return cohesion * level + drag * omega_2 + t1 + omega * viscosity


def resistance_centripetal_pore_pressure_cohesion_drag_viscosity_shaking(press: Any, press_slope: Any, level: Any,
        polar: Any, mu: Any, omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, drag: Any,
        viscosity: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 8 mul, 5 add, 3 sub."""
    b = 1.0 - k_v
    t1 = k_h * press_slope + omega_2 * polar + (b - pore_ratio) * press - level * pore_pressure
    return cohesion * level + drag * omega_2 + t1 * mu + omega * viscosity


def resistance_centripetal_pore_pressure_cohesion_drag_viscosity_shaking_thermal_pressurisation(press: Any,
        press_slope: Any, level: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, pore_ratio: Any,
        pore_pressure: Any, cohesion: Any, drag: Any, viscosity: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 9 mul, 5 add, 4 sub."""
    b = 1.0 - k_v
    t1 = k_h * press_slope + omega_2 * polar + (b - pore_ratio) * press - excess * level
    return cohesion * level + drag * omega_2 + (t1 - level * pore_pressure) * mu + omega * viscosity


def resistance_centripetal_pore_pressure_cohesion_drag_viscosity_thermal_pressurisation(press: Any, level: Any,
        polar: Any, mu: Any, omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, drag: Any,
        viscosity: Any, excess: Any) -> Any:
    """Resistance. Operations: 8 mul, 4 add, 3 sub."""
    b = 1.0 - pore_ratio
    t1 = (omega_2 * polar + b * press - excess * level - level * pore_pressure) * mu
    return cohesion * level + drag * omega_2 + t1 + omega * viscosity


def resistance_centripetal_pore_pressure_cohesion_shaking(press: Any, press_slope: Any, level: Any, polar: Any, mu: Any,
        omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 6 mul, 3 add, 3 sub."""
    b = 1.0 - k_v
    t1 = k_h * press_slope + omega_2 * polar + (b - pore_ratio) * press - level * pore_pressure
    return cohesion * level + t1 * mu


def resistance_centripetal_pore_pressure_cohesion_shaking_thermal_pressurisation(press: Any, press_slope: Any,
        level: Any, polar: Any, mu: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, k_h: Any,
        k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 7 mul, 3 add, 4 sub."""
    b = 1.0 - k_v
    t1 = k_h * press_slope + omega_2 * polar + (b - pore_ratio) * press - excess * level
    return cohesion * level + (t1 - level * pore_pressure) * mu


def resistance_centripetal_pore_pressure_cohesion_thermal_pressurisation(press: Any, level: Any, polar: Any, mu: Any,
        omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, excess: Any) -> Any:
    """Resistance. Operations: 6 mul, 2 add, 3 sub."""
    b = 1.0 - pore_ratio
    t1 = (omega_2 * polar + b * press - excess * level - level * pore_pressure) * mu
    return cohesion * level + t1


def resistance_centripetal_pore_pressure_cohesion_viscosity(press: Any, level: Any, polar: Any, mu: Any, omega: Any,
        omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, viscosity: Any) -> Any:
    """Resistance. Operations: 6 mul, 3 add, 2 sub."""
    b = 1.0 - pore_ratio
    t1 = cohesion * level + (omega_2 * polar + b * press - level * pore_pressure) * mu
    return t1 + omega * viscosity


def resistance_centripetal_pore_pressure_cohesion_viscosity_shaking(press: Any, press_slope: Any, level: Any,
        polar: Any, mu: Any, omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any,
        viscosity: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 7 mul, 4 add, 3 sub."""
    b = 1.0 - k_v
    t1 = k_h * press_slope + omega_2 * polar + (b - pore_ratio) * press - level * pore_pressure
    return cohesion * level + t1 * mu + omega * viscosity


def resistance_centripetal_pore_pressure_cohesion_viscosity_shaking_thermal_pressurisation(press: Any, press_slope: Any,
        level: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any,
        viscosity: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 8 mul, 4 add, 4 sub."""
    b = 1.0 - k_v
    t1 = k_h * press_slope + omega_2 * polar + (b - pore_ratio) * press - excess * level
    return cohesion * level + (t1 - level * pore_pressure) * mu + omega * viscosity


def resistance_centripetal_pore_pressure_cohesion_viscosity_thermal_pressurisation(press: Any, level: Any, polar: Any,
        mu: Any, omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, viscosity: Any,
        excess: Any) -> Any:
    """Resistance. Operations: 7 mul, 3 add, 3 sub."""
    b = 1.0 - pore_ratio
    t1 = (omega_2 * polar + b * press - excess * level - level * pore_pressure) * mu
    return cohesion * level + t1 + omega * viscosity


def resistance_centripetal_pore_pressure_drag(press: Any, level: Any, polar: Any, mu: Any, omega_2: Any,
        pore_ratio: Any, pore_pressure: Any, drag: Any) -> Any:
    """Resistance. Operations: 5 mul, 2 add, 2 sub."""
    b = 1.0 - pore_ratio
    return drag * omega_2 + (omega_2 * polar + b * press - level * pore_pressure) * mu


def resistance_centripetal_pore_pressure_drag_shaking(press: Any, press_slope: Any, level: Any, polar: Any, mu: Any,
        omega_2: Any, pore_ratio: Any, pore_pressure: Any, drag: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 6 mul, 3 add, 3 sub."""
    b = 1.0 - k_v
    t1 = k_h * press_slope + omega_2 * polar + (b - pore_ratio) * press - level * pore_pressure
    return drag * omega_2 + t1 * mu


def resistance_centripetal_pore_pressure_drag_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any,
        polar: Any, mu: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, drag: Any, k_h: Any, k_v: Any,
        excess: Any) -> Any:
    """Resistance. Operations: 7 mul, 3 add, 4 sub."""
    b = 1.0 - k_v
    t1 = k_h * press_slope + omega_2 * polar + (b - pore_ratio) * press - excess * level
    return drag * omega_2 + (t1 - level * pore_pressure) * mu


def resistance_centripetal_pore_pressure_drag_thermal_pressurisation(press: Any, level: Any, polar: Any, mu: Any,
        omega_2: Any, pore_ratio: Any, pore_pressure: Any, drag: Any, excess: Any) -> Any:
    """Resistance. Operations: 6 mul, 2 add, 3 sub."""
    b = 1.0 - pore_ratio
    t1 = (omega_2 * polar + b * press - excess * level - level * pore_pressure) * mu
    return drag * omega_2 + t1


def resistance_centripetal_pore_pressure_drag_viscosity(press: Any, level: Any, polar: Any, mu: Any, omega: Any,
        omega_2: Any, pore_ratio: Any, pore_pressure: Any, drag: Any, viscosity: Any) -> Any:
    """Resistance. Operations: 6 mul, 3 add, 2 sub."""
    b = 1.0 - pore_ratio
    t1 = drag * omega_2 + (omega_2 * polar + b * press - level * pore_pressure) * mu
    return t1 + omega * viscosity


def resistance_centripetal_pore_pressure_drag_viscosity_shaking(press: Any, press_slope: Any, level: Any, polar: Any,
        mu: Any, omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, drag: Any, viscosity: Any, k_h: Any,
        k_v: Any) -> Any:
    """Resistance. Operations: 7 mul, 4 add, 3 sub."""
    b = 1.0 - k_v
    t1 = k_h * press_slope + omega_2 * polar + (b - pore_ratio) * press - level * pore_pressure
    return drag * omega_2 + t1 * mu + omega * viscosity


def resistance_centripetal_pore_pressure_drag_viscosity_shaking_thermal_pressurisation(press: Any, press_slope: Any,
        level: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, drag: Any,
        viscosity: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 8 mul, 4 add, 4 sub."""
    b = 1.0 - k_v
    t1 = k_h * press_slope + omega_2 * polar + (b - pore_ratio) * press - excess * level
    return drag * omega_2 + (t1 - level * pore_pressure) * mu + omega * viscosity


def resistance_centripetal_pore_pressure_drag_viscosity_thermal_pressurisation(press: Any, level: Any, polar: Any,
        mu: Any, omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, drag: Any, viscosity: Any,
        excess: Any) -> Any:
    """Resistance. Operations: 7 mul, 3 add, 3 sub."""
    b = 1.0 - pore_ratio
    t1 = (omega_2 * polar + b * press - excess * level - level * pore_pressure) * mu
    return drag * omega_2 + t1 + omega * viscosity


def resistance_centripetal_pore_pressure_shaking(press: Any, press_slope: Any, level: Any, polar: Any, mu: Any,
        omega_2: Any, pore_ratio: Any, pore_pressure: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 5 mul, 2 add, 3 sub."""
    b = 1.0 - k_v
    t1 = k_h * press_slope + omega_2 * polar + (b - pore_ratio) * press - level * pore_pressure
    return t1 * mu


def resistance_centripetal_pore_pressure_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any,
        polar: Any, mu: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 6 mul, 2 add, 4 sub."""
    b = 1.0 - k_v
    t1 = k_h * press_slope + omega_2 * polar + (b - pore_ratio) * press - excess * level
    return (t1 - level * pore_pressure) * mu


def resistance_centripetal_pore_pressure_thermal_pressurisation(press: Any, level: Any, polar: Any, mu: Any,
        omega_2: Any, pore_ratio: Any, pore_pressure: Any, excess: Any) -> Any:
    """Resistance. Operations: 5 mul, 1 add, 3 sub."""
    b = 1.0 - pore_ratio
    return (omega_2 * polar + b * press - excess * level - level * pore_pressure) * mu


def resistance_centripetal_pore_pressure_viscosity(press: Any, level: Any, polar: Any, mu: Any, omega: Any,
        omega_2: Any, pore_ratio: Any, pore_pressure: Any, viscosity: Any) -> Any:
    """Resistance. Operations: 5 mul, 2 add, 2 sub."""
    b = 1.0 - pore_ratio
    return (omega_2 * polar + b * press - level * pore_pressure) * mu + omega * viscosity


def resistance_centripetal_pore_pressure_viscosity_shaking(press: Any, press_slope: Any, level: Any, polar: Any,
        mu: Any, omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, viscosity: Any, k_h: Any,
        k_v: Any) -> Any:
    """Resistance. Operations: 6 mul, 3 add, 3 sub."""
    b = 1.0 - k_v
    t1 = k_h * press_slope + omega_2 * polar + (b - pore_ratio) * press - level * pore_pressure
    return t1 * mu + omega * viscosity


def resistance_centripetal_pore_pressure_viscosity_shaking_thermal_pressurisation(press: Any, press_slope: Any,
        level: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, viscosity: Any,
        k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 7 mul, 3 add, 4 sub."""
    b = 1.0 - k_v
    t1 = k_h * press_slope + omega_2 * polar + (b - pore_ratio) * press - excess * level
    return (t1 - level * pore_pressure) * mu + omega * viscosity


def resistance_centripetal_pore_pressure_viscosity_thermal_pressurisation(press: Any, level: Any, polar: Any, mu: Any,
        omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, viscosity: Any, excess: Any) -> Any:
    """Resistance. Operations: 6 mul, 2 add, 3 sub."""
    b = 1.0 - pore_ratio
    t1 = (omega_2 * polar + b * press - excess * level - level * pore_pressure) * mu
    return t1 + omega * viscosity


def resistance_centripetal_shaking(press: Any, press_slope: Any, polar: Any, mu: Any, omega_2: Any, k_h: Any,
        k_v: Any) -> Any:
    """Resistance. Operations: 4 mul, 2 add, 1 sub."""
    b = 1.0 - k_v
    return (k_h * press_slope + omega_2 * polar + b * press) * mu


def resistance_centripetal_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, polar: Any, mu: Any,
        omega_2: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 5 mul, 2 add, 2 sub."""
    b = 1.0 - k_v
    return (k_h * press_slope + omega_2 * polar + b * press - excess * level) * mu


def resistance_centripetal_thermal_pressurisation(press: Any, level: Any, polar: Any, mu: Any, omega_2: Any,
        excess: Any) -> Any:
    """Resistance. Operations: 3 mul, 1 add, 1 sub."""
    return (press + omega_2 * polar - excess * level) * mu


def resistance_centripetal_viscosity(press: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, viscosity: Any) -> Any:
    """Resistance. Operations: 3 mul, 2 add."""
    return (press + omega_2 * polar) * mu + omega * viscosity


def resistance_centripetal_viscosity_shaking(press: Any, press_slope: Any, polar: Any, mu: Any, omega: Any,
        omega_2: Any, viscosity: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 5 mul, 3 add, 1 sub."""
    b = 1.0 - k_v
    return (k_h * press_slope + omega_2 * polar + b * press) * mu + omega * viscosity


def resistance_centripetal_viscosity_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any,
        polar: Any, mu: Any, omega: Any, omega_2: Any, viscosity: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 6 mul, 3 add, 2 sub."""
    b = 1.0 - k_v
    return (k_h * press_slope + omega_2 * polar + b * press - excess * level) * mu + omega * viscosity


def resistance_centripetal_viscosity_thermal_pressurisation(press: Any, level: Any, polar: Any, mu: Any, omega: Any,
        omega_2: Any, viscosity: Any, excess: Any) -> Any:
    """Resistance. Operations: 4 mul, 2 add, 1 sub."""
    return (press + omega_2 * polar - excess * level) * mu + omega * viscosity


def resistance_cohesion(press: Any, level: Any, mu: Any, cohesion: Any) -> Any:
    """Resistance. Operations: 2 mul, 1 add."""
    return cohesion * level + mu * press


def resistance_cohesion_drag(press: Any, level: Any, mu: Any, omega_2: Any, cohesion: Any, drag: Any) -> Any:
    """Resistance. Operations: 3 mul, 2 add."""
    return cohesion * level + drag * omega_2 + mu * press


def resistance_cohesion_drag_shaking(press: Any, press_slope: Any, level: Any, mu: Any, omega_2: Any, cohesion: Any,
        drag: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 5 mul, 3 add, 1 sub."""
    b = 1.0 - k_v
    return cohesion * level + drag * omega_2 + (k_h * press_slope + b * press) * mu


def resistance_cohesion_drag_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, mu: Any,
        omega_2: Any, cohesion: Any, drag: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 6 mul, 3 add, 2 sub."""
    b = 1.0 - k_v
    return cohesion * level + drag * omega_2 + (k_h * press_slope + b * press - excess * level) * mu


def resistance_cohesion_drag_thermal_pressurisation(press: Any, level: Any, mu: Any, omega_2: Any, cohesion: Any,
        drag: Any, excess: Any) -> Any:
    """Resistance. Operations: 4 mul, 2 add, 1 sub."""
    return cohesion * level + drag * omega_2 + (press - excess * level) * mu


def resistance_cohesion_drag_viscosity(press: Any, level: Any, mu: Any, omega: Any, omega_2: Any, cohesion: Any,
        drag: Any, viscosity: Any) -> Any:
    """Resistance. Operations: 4 mul, 3 add."""
    return cohesion * level + drag * omega_2 + mu * press + omega * viscosity


def resistance_cohesion_drag_viscosity_shaking(press: Any, press_slope: Any, level: Any, mu: Any, omega: Any,
        omega_2: Any, cohesion: Any, drag: Any, viscosity: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 6 mul, 4 add, 1 sub."""
    b = 1.0 - k_v
    return cohesion * level + drag * omega_2 + (k_h * press_slope + b * press) * mu + omega * viscosity


def resistance_cohesion_drag_viscosity_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, mu: Any,
        omega: Any, omega_2: Any, cohesion: Any, drag: Any, viscosity: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 7 mul, 4 add, 2 sub."""
    b = 1.0 - k_v
    t1 = cohesion * level + drag * omega_2 + (k_h * press_slope + b * press - excess * level) * mu
    return t1 + omega * viscosity


def resistance_cohesion_drag_viscosity_thermal_pressurisation(press: Any, level: Any, mu: Any, omega: Any, omega_2: Any,
        cohesion: Any, drag: Any, viscosity: Any, excess: Any) -> Any:
    """Resistance. Operations: 5 mul, 3 add, 1 sub."""
    return cohesion * level + drag * omega_2 + (press - excess * level) * mu + omega * viscosity


def resistance_cohesion_shaking(press: Any, press_slope: Any, level: Any, mu: Any, cohesion: Any, k_h: Any,
        k_v: Any) -> Any:
    """Resistance. Operations: 4 mul, 2 add, 1 sub."""
    b = 1.0 - k_v
    return cohesion * level + (k_h * press_slope + b * press) * mu


def resistance_cohesion_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, mu: Any, cohesion: Any,
        k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 5 mul, 2 add, 2 sub."""
    b = 1.0 - k_v
    return cohesion * level + (k_h * press_slope + b * press - excess * level) * mu


def resistance_cohesion_thermal_pressurisation(press: Any, level: Any, mu: Any, cohesion: Any, excess: Any) -> Any:
    """Resistance. Operations: 3 mul, 1 add, 1 sub."""
    return cohesion * level + (press - excess * level) * mu


def resistance_cohesion_viscosity(press: Any, level: Any, mu: Any, omega: Any, cohesion: Any, viscosity: Any) -> Any:
    """Resistance. Operations: 3 mul, 2 add."""
    return cohesion * level + mu * press + omega * viscosity


def resistance_cohesion_viscosity_shaking(press: Any, press_slope: Any, level: Any, mu: Any, omega: Any, cohesion: Any,
        viscosity: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 5 mul, 3 add, 1 sub."""
    b = 1.0 - k_v
    return cohesion * level + (k_h * press_slope + b * press) * mu + omega * viscosity


def resistance_cohesion_viscosity_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, mu: Any,
        omega: Any, cohesion: Any, viscosity: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 6 mul, 3 add, 2 sub."""
    b = 1.0 - k_v
    return cohesion * level + (k_h * press_slope + b * press - excess * level) * mu + omega * viscosity


def resistance_cohesion_viscosity_thermal_pressurisation(press: Any, level: Any, mu: Any, omega: Any, cohesion: Any,
        viscosity: Any, excess: Any) -> Any:
    """Resistance. Operations: 4 mul, 2 add, 1 sub."""
    return cohesion * level + (press - excess * level) * mu + omega * viscosity


def resistance_drag(press: Any, mu: Any, omega_2: Any, drag: Any) -> Any:
    """Resistance. Operations: 2 mul, 1 add."""
    return drag * omega_2 + mu * press


def resistance_drag_shaking(press: Any, press_slope: Any, mu: Any, omega_2: Any, drag: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 4 mul, 2 add, 1 sub."""
    b = 1.0 - k_v
    return drag * omega_2 + (k_h * press_slope + b * press) * mu


def resistance_drag_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, mu: Any, omega_2: Any,
        drag: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 5 mul, 2 add, 2 sub."""
    b = 1.0 - k_v
    return drag * omega_2 + (k_h * press_slope + b * press - excess * level) * mu


def resistance_drag_thermal_pressurisation(press: Any, level: Any, mu: Any, omega_2: Any, drag: Any,
        excess: Any) -> Any:
    """Resistance. Operations: 3 mul, 1 add, 1 sub."""
    return drag * omega_2 + (press - excess * level) * mu


def resistance_drag_viscosity(press: Any, mu: Any, omega: Any, omega_2: Any, drag: Any, viscosity: Any) -> Any:
    """Resistance. Operations: 3 mul, 2 add."""
    return drag * omega_2 + mu * press + omega * viscosity


def resistance_drag_viscosity_shaking(press: Any, press_slope: Any, mu: Any, omega: Any, omega_2: Any, drag: Any,
        viscosity: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 5 mul, 3 add, 1 sub."""
    b = 1.0 - k_v
    return drag * omega_2 + (k_h * press_slope + b * press) * mu + omega * viscosity


def resistance_drag_viscosity_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, mu: Any,
        omega: Any, omega_2: Any, drag: Any, viscosity: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 6 mul, 3 add, 2 sub."""
    b = 1.0 - k_v
    return drag * omega_2 + (k_h * press_slope + b * press - excess * level) * mu + omega * viscosity


def resistance_drag_viscosity_thermal_pressurisation(press: Any, level: Any, mu: Any, omega: Any, omega_2: Any,
        drag: Any, viscosity: Any, excess: Any) -> Any:
    """Resistance. Operations: 4 mul, 2 add, 1 sub."""
    return drag * omega_2 + (press - excess * level) * mu + omega * viscosity


def resistance_pore_pressure(press: Any, level: Any, mu: Any, pore_ratio: Any, pore_pressure: Any) -> Any:
    """Resistance. Operations: 3 mul, 2 sub."""
    b = 1.0 - pore_ratio
    return (b * press - level * pore_pressure) * mu


def resistance_pore_pressure_cohesion(press: Any, level: Any, mu: Any, pore_ratio: Any, pore_pressure: Any,
        cohesion: Any) -> Any:
    """Resistance. Operations: 4 mul, 1 add, 2 sub."""
    b = 1.0 - pore_ratio
    return cohesion * level + (b * press - level * pore_pressure) * mu


def resistance_pore_pressure_cohesion_drag(press: Any, level: Any, mu: Any, omega_2: Any, pore_ratio: Any,
        pore_pressure: Any, cohesion: Any, drag: Any) -> Any:
    """Resistance. Operations: 5 mul, 2 add, 2 sub."""
    b = 1.0 - pore_ratio
    return cohesion * level + drag * omega_2 + (b * press - level * pore_pressure) * mu


def resistance_pore_pressure_cohesion_drag_shaking(press: Any, press_slope: Any, level: Any, mu: Any, omega_2: Any,
        pore_ratio: Any, pore_pressure: Any, cohesion: Any, drag: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 6 mul, 3 add, 3 sub."""
    b = 1.0 - k_v
    t1 = (k_h * press_slope + (b - pore_ratio) * press - level * pore_pressure) * mu
    return cohesion * level + drag * omega_2 + t1


def resistance_pore_pressure_cohesion_drag_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any,
        mu: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, drag: Any, k_h: Any, k_v: Any,
        excess: Any) -> Any:
    """Resistance. Operations: 7 mul, 3 add, 4 sub."""
    b = 1.0 - k_v
    t1 = k_h * press_slope + (b - pore_ratio) * press - excess * level - level * pore_pressure
    return cohesion * level + drag * omega_2 + t1 * mu


def resistance_pore_pressure_cohesion_drag_thermal_pressurisation(press: Any, level: Any, mu: Any, omega_2: Any,
        pore_ratio: Any, pore_pressure: Any, cohesion: Any, drag: Any, excess: Any) -> Any:
    """Resistance. Operations: 6 mul, 2 add, 3 sub."""
    b = 1.0 - pore_ratio
    t1 = (b * press - excess * level - level * pore_pressure) * mu
    return cohesion * level + drag * omega_2 + t1


def resistance_pore_pressure_cohesion_drag_viscosity(press: Any, level: Any, mu: Any, omega: Any, omega_2: Any,
        pore_ratio: Any, pore_pressure: Any, cohesion: Any, drag: Any, viscosity: Any) -> Any:
    """Resistance. Operations: 6 mul, 3 add, 2 sub."""
    b = 1.0 - pore_ratio
    t1 = cohesion * level + drag * omega_2 + (b * press - level * pore_pressure) * mu
    return t1 + omega * viscosity


def resistance_pore_pressure_cohesion_drag_viscosity_shaking(press: Any, press_slope: Any, level: Any, mu: Any,
        omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, drag: Any, viscosity: Any,
        k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 7 mul, 4 add, 3 sub."""
    b = 1.0 - k_v
    t1 = (k_h * press_slope + (b - pore_ratio) * press - level * pore_pressure) * mu
    return cohesion * level + drag * omega_2 + t1 + omega * viscosity


def resistance_pore_pressure_cohesion_drag_viscosity_shaking_thermal_pressurisation(press: Any, press_slope: Any,
        level: Any, mu: Any, omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, drag: Any,
        viscosity: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 8 mul, 4 add, 4 sub."""
    b = 1.0 - k_v
    t1 = k_h * press_slope + (b - pore_ratio) * press - excess * level - level * pore_pressure
    return cohesion * level + drag * omega_2 + t1 * mu + omega * viscosity


def resistance_pore_pressure_cohesion_drag_viscosity_thermal_pressurisation(press: Any, level: Any, mu: Any, omega: Any,
        omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, drag: Any, viscosity: Any,
        excess: Any) -> Any:
    """Resistance. Operations: 7 mul, 3 add, 3 sub."""
    b = 1.0 - pore_ratio
    t1 = (b * press - excess * level - level * pore_pressure) * mu
    return cohesion * level + drag * omega_2 + t1 + omega * viscosity


def resistance_pore_pressure_cohesion_shaking(press: Any, press_slope: Any, level: Any, mu: Any, pore_ratio: Any,
        pore_pressure: Any, cohesion: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 5 mul, 2 add, 3 sub."""
    b = 1.0 - k_v
    t1 = (k_h * press_slope + (b - pore_ratio) * press - level * pore_pressure) * mu
    return cohesion * level + t1


def resistance_pore_pressure_cohesion_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, mu: Any,
        pore_ratio: Any, pore_pressure: Any, cohesion: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 6 mul, 2 add, 4 sub."""
    b = 1.0 - k_v
    t1 = k_h * press_slope + (b - pore_ratio) * press - excess * level - level * pore_pressure
    return cohesion * level + t1 * mu


def resistance_pore_pressure_cohesion_thermal_pressurisation(press: Any, level: Any, mu: Any, pore_ratio: Any,
        pore_pressure: Any, cohesion: Any, excess: Any) -> Any:
    """Resistance. Operations: 5 mul, 1 add, 3 sub."""
    b = 1.0 - pore_ratio
    return cohesion * level + (b * press - excess * level - level * pore_pressure) * mu


def resistance_pore_pressure_cohesion_viscosity(press: Any, level: Any, mu: Any, omega: Any, pore_ratio: Any,
        pore_pressure: Any, cohesion: Any, viscosity: Any) -> Any:
    """Resistance. Operations: 5 mul, 2 add, 2 sub."""
    b = 1.0 - pore_ratio
    return cohesion * level + (b * press - level * pore_pressure) * mu + omega * viscosity


def resistance_pore_pressure_cohesion_viscosity_shaking(press: Any, press_slope: Any, level: Any, mu: Any, omega: Any,
        pore_ratio: Any, pore_pressure: Any, cohesion: Any, viscosity: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 6 mul, 3 add, 3 sub."""
    b = 1.0 - k_v
    t1 = (k_h * press_slope + (b - pore_ratio) * press - level * pore_pressure) * mu
    return cohesion * level + t1 + omega * viscosity


def resistance_pore_pressure_cohesion_viscosity_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any,
        mu: Any, omega: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, viscosity: Any, k_h: Any, k_v: Any,
        excess: Any) -> Any:
    """Resistance. Operations: 7 mul, 3 add, 4 sub."""
    b = 1.0 - k_v
    t1 = k_h * press_slope + (b - pore_ratio) * press - excess * level - level * pore_pressure
    return cohesion * level + t1 * mu + omega * viscosity


def resistance_pore_pressure_cohesion_viscosity_thermal_pressurisation(press: Any, level: Any, mu: Any, omega: Any,
        pore_ratio: Any, pore_pressure: Any, cohesion: Any, viscosity: Any, excess: Any) -> Any:
    """Resistance. Operations: 6 mul, 2 add, 3 sub."""
    b = 1.0 - pore_ratio
    t1 = cohesion * level + (b * press - excess * level - level * pore_pressure) * mu
    return t1 + omega * viscosity


def resistance_pore_pressure_drag(press: Any, level: Any, mu: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any,
        drag: Any) -> Any:
    """Resistance. Operations: 4 mul, 1 add, 2 sub."""
    b = 1.0 - pore_ratio
    return drag * omega_2 + (b * press - level * pore_pressure) * mu


def resistance_pore_pressure_drag_shaking(press: Any, press_slope: Any, level: Any, mu: Any, omega_2: Any,
        pore_ratio: Any, pore_pressure: Any, drag: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 5 mul, 2 add, 3 sub."""
    b = 1.0 - k_v
    t1 = (k_h * press_slope + (b - pore_ratio) * press - level * pore_pressure) * mu
    return drag * omega_2 + t1


def resistance_pore_pressure_drag_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, mu: Any,
        omega_2: Any, pore_ratio: Any, pore_pressure: Any, drag: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 6 mul, 2 add, 4 sub."""
    b = 1.0 - k_v
    t1 = k_h * press_slope + (b - pore_ratio) * press - excess * level - level * pore_pressure
    return drag * omega_2 + t1 * mu


def resistance_pore_pressure_drag_thermal_pressurisation(press: Any, level: Any, mu: Any, omega_2: Any, pore_ratio: Any,
        pore_pressure: Any, drag: Any, excess: Any) -> Any:
    """Resistance. Operations: 5 mul, 1 add, 3 sub."""
    b = 1.0 - pore_ratio
    return drag * omega_2 + (b * press - excess * level - level * pore_pressure) * mu


def resistance_pore_pressure_drag_viscosity(press: Any, level: Any, mu: Any, omega: Any, omega_2: Any, pore_ratio: Any,
        pore_pressure: Any, drag: Any, viscosity: Any) -> Any:
    """Resistance. Operations: 5 mul, 2 add, 2 sub."""
    b = 1.0 - pore_ratio
    return drag * omega_2 + (b * press - level * pore_pressure) * mu + omega * viscosity


def resistance_pore_pressure_drag_viscosity_shaking(press: Any, press_slope: Any, level: Any, mu: Any, omega: Any,
        omega_2: Any, pore_ratio: Any, pore_pressure: Any, drag: Any, viscosity: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 6 mul, 3 add, 3 sub."""
    b = 1.0 - k_v
    t1 = (k_h * press_slope + (b - pore_ratio) * press - level * pore_pressure) * mu
    return drag * omega_2 + t1 + omega * viscosity


def resistance_pore_pressure_drag_viscosity_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any,
        mu: Any, omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, drag: Any, viscosity: Any, k_h: Any,
        k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 7 mul, 3 add, 4 sub."""
    b = 1.0 - k_v
    t1 = k_h * press_slope + (b - pore_ratio) * press - excess * level - level * pore_pressure
    return drag * omega_2 + t1 * mu + omega * viscosity


def resistance_pore_pressure_drag_viscosity_thermal_pressurisation(press: Any, level: Any, mu: Any, omega: Any,
        omega_2: Any, pore_ratio: Any, pore_pressure: Any, drag: Any, viscosity: Any, excess: Any) -> Any:
    """Resistance. Operations: 6 mul, 2 add, 3 sub."""
    b = 1.0 - pore_ratio
    t1 = drag * omega_2 + (b * press - excess * level - level * pore_pressure) * mu
    return t1 + omega * viscosity


def resistance_pore_pressure_shaking(press: Any, press_slope: Any, level: Any, mu: Any, pore_ratio: Any,
        pore_pressure: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 4 mul, 1 add, 3 sub."""
    b = 1.0 - k_v
    return (k_h * press_slope + (b - pore_ratio) * press - level * pore_pressure) * mu


def resistance_pore_pressure_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, mu: Any,
        pore_ratio: Any, pore_pressure: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 5 mul, 1 add, 4 sub."""
    b = 1.0 - k_v
    t1 = k_h * press_slope + (b - pore_ratio) * press - excess * level - level * pore_pressure
    return t1 * mu


def resistance_pore_pressure_thermal_pressurisation(press: Any, level: Any, mu: Any, pore_ratio: Any,
        pore_pressure: Any, excess: Any) -> Any:
    """Resistance. Operations: 4 mul, 3 sub."""
    b = 1.0 - pore_ratio
    return (b * press - excess * level - level * pore_pressure) * mu


def resistance_pore_pressure_viscosity(press: Any, level: Any, mu: Any, omega: Any, pore_ratio: Any, pore_pressure: Any,
        viscosity: Any) -> Any:
    """Resistance. Operations: 4 mul, 1 add, 2 sub."""
    b = 1.0 - pore_ratio
    return (b * press - level * pore_pressure) * mu + omega * viscosity


def resistance_pore_pressure_viscosity_shaking(press: Any, press_slope: Any, level: Any, mu: Any, omega: Any,
        pore_ratio: Any, pore_pressure: Any, viscosity: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 5 mul, 2 add, 3 sub."""
    b = 1.0 - k_v
    t1 = (k_h * press_slope + (b - pore_ratio) * press - level * pore_pressure) * mu
    return t1 + omega * viscosity


def resistance_pore_pressure_viscosity_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, mu: Any,
        omega: Any, pore_ratio: Any, pore_pressure: Any, viscosity: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 6 mul, 2 add, 4 sub."""
    b = 1.0 - k_v
    t1 = k_h * press_slope + (b - pore_ratio) * press - excess * level - level * pore_pressure
    return t1 * mu + omega * viscosity


def resistance_pore_pressure_viscosity_thermal_pressurisation(press: Any, level: Any, mu: Any, omega: Any,
        pore_ratio: Any, pore_pressure: Any, viscosity: Any, excess: Any) -> Any:
    """Resistance. Operations: 5 mul, 1 add, 3 sub."""
    b = 1.0 - pore_ratio
    return (b * press - excess * level - level * pore_pressure) * mu + omega * viscosity


def resistance_shaking(press: Any, press_slope: Any, mu: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 3 mul, 1 add, 1 sub."""
    b = 1.0 - k_v
    return (k_h * press_slope + b * press) * mu


def resistance_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, mu: Any, k_h: Any, k_v: Any,
        excess: Any) -> Any:
    """Resistance. Operations: 4 mul, 1 add, 2 sub."""
    b = 1.0 - k_v
    return (k_h * press_slope + b * press - excess * level) * mu


def resistance_thermal_pressurisation(press: Any, level: Any, mu: Any, excess: Any) -> Any:
    """Resistance. Operations: 2 mul, 1 sub."""
    return (press - excess * level) * mu


def resistance_viscosity(press: Any, mu: Any, omega: Any, viscosity: Any) -> Any:
    """Resistance. Operations: 2 mul, 1 add."""
    return mu * press + omega * viscosity


def resistance_viscosity_shaking(press: Any, press_slope: Any, mu: Any, omega: Any, viscosity: Any, k_h: Any,
        k_v: Any) -> Any:
    """Resistance. Operations: 4 mul, 2 add, 1 sub."""
    b = 1.0 - k_v
    return (k_h * press_slope + b * press) * mu + omega * viscosity


def resistance_viscosity_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, mu: Any, omega: Any,
        viscosity: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 5 mul, 2 add, 2 sub."""
    b = 1.0 - k_v
    return (k_h * press_slope + b * press - excess * level) * mu + omega * viscosity


def resistance_viscosity_thermal_pressurisation(press: Any, level: Any, mu: Any, omega: Any, viscosity: Any,
        excess: Any) -> Any:
    """Resistance. Operations: 3 mul, 1 add, 1 sub."""
    return (press - excess * level) * mu + omega * viscosity


def tilt(fall_slope: Any, press_slope: Any, mu: Any) -> Any:
    """Tilt. Operations: 1 mul, 1 sub."""
    return fall_slope - mu * press_slope


def tilt_pore_pressure(fall_slope: Any, press_slope: Any, mu: Any, pore_ratio: Any) -> Any:
    """Tilt. Operations: 2 mul, 1 add, 1 sub."""
    return fall_slope + (pore_ratio - 1.0) * mu * press_slope


def tilt_pore_pressure_shaking(fall: Any, press: Any, fall_slope: Any, press_slope: Any, mu: Any, pore_ratio: Any,
        k_h: Any, k_v: Any) -> Any:
    """Tilt. Operations: 6 mul, 3 add, 3 sub."""
    b = 1.0 - k_v
    t1 = b * fall_slope + k_h * mu * press + (k_v + pore_ratio - 1.0) * mu * press_slope
    return t1 - fall * k_h


def tilt_shaking(fall: Any, press: Any, fall_slope: Any, press_slope: Any, mu: Any, k_h: Any, k_v: Any) -> Any:
    """Tilt. Operations: 6 mul, 2 add, 3 sub."""
    b = 1.0 - k_v
    return b * fall_slope + k_h * mu * press + (k_v - 1.0) * mu * press_slope - fall * k_h
