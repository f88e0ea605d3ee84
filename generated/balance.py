# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: 054bf0818e082baf139d85c97f4b9d7b97e04a398b17f9ca22e06f12f7f6a8e3
"""The balance of momentum and the energy in the phase plane, specialised to the effects that are present."""

from typing import Any

import numpy as np

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


def brake_centripetal(polar: Any, mu: Any) -> Any:
    """Brake. Operations: 1 mul."""
    v2 = mu * polar
    return v2


def brake_centripetal_drag(polar: Any, mu: Any, drag: Any) -> Any:
    """Brake. Operations: 1 mul, 1 add."""
    v4 = drag + mu * polar
    return v4


def brake_drag(drag: Any) -> Any:
    """Brake. Operations: none."""
    return drag


def constant_cohesion(level: Any, cohesion: Any) -> Any:
    """Constant. Operations: 1 mul."""
    v2 = cohesion * level
    return v2


def constant_cohesion_thermal_pressurisation(level: Any, mu: Any, cohesion: Any, excess: Any) -> Any:
    """Constant. Operations: 2 mul, 1 sub."""
    v6 = (cohesion - excess * mu) * level
    return v6


def constant_pore_pressure(level: Any, mu: Any, pore_pressure: Any) -> Any:
    """Constant. Operations: 2 mul, 1 neg."""
    v5 = -(level * mu * pore_pressure)
    return v5


def constant_pore_pressure_cohesion(level: Any, mu: Any, pore_pressure: Any, cohesion: Any) -> Any:
    """Constant. Operations: 2 mul, 1 sub."""
    v6 = (cohesion - mu * pore_pressure) * level
    return v6


def constant_pore_pressure_cohesion_thermal_pressurisation(level: Any, mu: Any, pore_pressure: Any, cohesion: Any, excess: Any) -> Any:
    """Constant. Operations: 3 mul, 2 sub."""
    v9 = (cohesion - excess * mu - mu * pore_pressure) * level
    return v9


def constant_pore_pressure_thermal_pressurisation(level: Any, mu: Any, pore_pressure: Any, excess: Any) -> Any:
    """Constant. Operations: 2 mul, 1 add, 1 neg."""
    v7 = -((excess + pore_pressure) * level * mu)
    return v7


def constant_thermal_pressurisation(level: Any, mu: Any, excess: Any) -> Any:
    """Constant. Operations: 2 mul, 1 neg."""
    v5 = -(excess * level * mu)
    return v5


def damping_viscosity(viscosity: Any) -> Any:
    """Damping. Operations: none."""
    return viscosity


def drive(press: Any, mu: Any, limit_friction: Any) -> Any:
    """Drive. Operations: 1 mul, 1 sub."""
    v4 = (limit_friction - mu) * press
    return v4


def drive_pore_pressure(press: Any, level: Any, mu: Any, pore_ratio: Any, pore_pressure: Any, limit_friction: Any) -> Any:
    """Drive. Operations: 3 mul, 3 sub."""
    v12 = (limit_friction - mu) * ((1.0 - pore_ratio) * press - level * pore_pressure)
    return v12


def drive_pore_pressure_shaking(press: Any, press_slope: Any, level: Any, mu: Any, pore_ratio: Any, pore_pressure: Any, k_h: Any, k_v: Any, limit_friction: Any) -> Any:
    """Drive. Operations: 4 mul, 1 add, 4 sub."""
    v18 = (limit_friction - mu) * (k_h * press_slope + (1.0 - k_v - pore_ratio) * press - level * pore_pressure)
    return v18


def drive_pore_pressure_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, mu: Any, pore_ratio: Any, pore_pressure: Any, k_h: Any, k_v: Any, excess: Any, limit_friction: Any) -> Any:
    """Drive. Operations: 5 mul, 1 add, 5 sub."""
    v21 = (limit_friction - mu) * (k_h * press_slope + (1.0 - k_v - pore_ratio) * press - excess * level - level * pore_pressure)
    return v21


def drive_pore_pressure_thermal_pressurisation(press: Any, level: Any, mu: Any, pore_ratio: Any, pore_pressure: Any, excess: Any, limit_friction: Any) -> Any:
    """Drive. Operations: 4 mul, 4 sub."""
    v15 = (limit_friction - mu) * ((1.0 - pore_ratio) * press - excess * level - level * pore_pressure)
    return v15


def drive_shaking(press: Any, press_slope: Any, mu: Any, k_h: Any, k_v: Any, limit_friction: Any) -> Any:
    """Drive. Operations: 3 mul, 1 add, 2 sub."""
    v12 = (limit_friction - mu) * (k_h * press_slope + (1.0 - k_v) * press)
    return v12


def drive_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, mu: Any, k_h: Any, k_v: Any, excess: Any, limit_friction: Any) -> Any:
    """Drive. Operations: 4 mul, 1 add, 3 sub."""
    v16 = (limit_friction - mu) * (k_h * press_slope + (1.0 - k_v) * press - excess * level)
    return v16


def drive_thermal_pressurisation(press: Any, level: Any, mu: Any, excess: Any, limit_friction: Any) -> Any:
    """Drive. Operations: 2 mul, 2 sub."""
    v8 = (limit_friction - mu) * (press - excess * level)
    return v8


def drop_exponential(slip: Any, more: Any, peak: Any, residual: Any, length: Any) -> Any:
    """Its fall over `more` slip, from `slip`. Operations: 2 mul, 1 sub, 2 div, 3 neg, 1 exp, 1 expm1."""
    v14 = -((peak - residual) * np.exp(-(slip / length)) * np.expm1(-(more / length)))
    return v14


def drop_hyperbolic(slip: Any, more: Any, peak: Any, residual: Any, length: Any) -> Any:
    """Its fall over `more` slip, from `slip`. Operations: 3 mul, 3 add, 1 sub, 1 div."""
    v12 = (peak - residual) / ((length + slip) * (length + more + slip)) * length * more
    return v12


def drop_linear(slip: Any, more: Any, peak: Any, residual: Any, length: Any) -> Any:
    """Its fall over `more` slip, from `slip`. Operations: 1 mul, 1 add, 2 sub, 2 div, 2 min."""
    v8 = slip / length
    v13 = (peak - residual) * (np.minimum(1.0, more / length + v8) - np.minimum(1.0, v8))
    return v13


def effective_stress(press: Any, level: Any) -> Any:
    """Effective_stress. Operations: 1 div."""
    v2 = press / level
    return v2


def effective_stress_centripetal(press: Any, level: Any, polar: Any, omega_2: Any) -> Any:
    """Effective_stress. Operations: 1 mul, 1 add, 1 div."""
    v6 = (press + omega_2 * polar) / level
    return v6


def effective_stress_centripetal_pore_pressure(press: Any, level: Any, polar: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any) -> Any:
    """Effective_stress. Operations: 3 mul, 1 add, 2 sub, 1 div."""
    v13 = (omega_2 * polar + (1.0 - pore_ratio) * press - level * pore_pressure) / level
    return v13


def effective_stress_centripetal_pore_pressure_shaking(press: Any, press_slope: Any, level: Any, polar: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, k_h: Any, k_v: Any) -> Any:
    """Effective_stress. Operations: 4 mul, 2 add, 3 sub, 1 div."""
    v19 = (k_h * press_slope + omega_2 * polar + (1.0 - k_v - pore_ratio) * press - level * pore_pressure) / level
    return v19


def effective_stress_centripetal_pore_pressure_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, polar: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Effective_stress. Operations: 5 mul, 2 add, 4 sub, 1 div."""
    v21 = k_h * press_slope + omega_2 * polar + (1.0 - k_v - pore_ratio) * press - excess * level - level * pore_pressure
    v22 = v21 / level
    return v22


def effective_stress_centripetal_pore_pressure_thermal_pressurisation(press: Any, level: Any, polar: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, excess: Any) -> Any:
    """Effective_stress. Operations: 4 mul, 1 add, 3 sub, 1 div."""
    v16 = (omega_2 * polar + (1.0 - pore_ratio) * press - excess * level - level * pore_pressure) / level
    return v16


def effective_stress_centripetal_shaking(press: Any, press_slope: Any, level: Any, polar: Any, omega_2: Any, k_h: Any, k_v: Any) -> Any:
    """Effective_stress. Operations: 3 mul, 2 add, 1 sub, 1 div."""
    v14 = (k_h * press_slope + omega_2 * polar + (1.0 - k_v) * press) / level
    return v14


def effective_stress_centripetal_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, polar: Any, omega_2: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Effective_stress. Operations: 4 mul, 2 add, 2 sub, 1 div."""
    v17 = (k_h * press_slope + omega_2 * polar + (1.0 - k_v) * press - excess * level) / level
    return v17


def effective_stress_centripetal_thermal_pressurisation(press: Any, level: Any, polar: Any, omega_2: Any, excess: Any) -> Any:
    """Effective_stress. Operations: 2 mul, 1 add, 1 sub, 1 div."""
    v9 = (press + omega_2 * polar - excess * level) / level
    return v9


def effective_stress_pore_pressure(press: Any, level: Any, pore_ratio: Any, pore_pressure: Any) -> Any:
    """Effective_stress. Operations: 2 mul, 2 sub, 1 div."""
    v9 = ((1.0 - pore_ratio) * press - level * pore_pressure) / level
    return v9


def effective_stress_pore_pressure_shaking(press: Any, press_slope: Any, level: Any, pore_ratio: Any, pore_pressure: Any, k_h: Any, k_v: Any) -> Any:
    """Effective_stress. Operations: 3 mul, 1 add, 3 sub, 1 div."""
    v15 = (k_h * press_slope + (1.0 - k_v - pore_ratio) * press - level * pore_pressure) / level
    return v15


def effective_stress_pore_pressure_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, pore_ratio: Any, pore_pressure: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Effective_stress. Operations: 4 mul, 1 add, 4 sub, 1 div."""
    v18 = (k_h * press_slope + (1.0 - k_v - pore_ratio) * press - excess * level - level * pore_pressure) / level
    return v18


def effective_stress_pore_pressure_thermal_pressurisation(press: Any, level: Any, pore_ratio: Any, pore_pressure: Any, excess: Any) -> Any:
    """Effective_stress. Operations: 3 mul, 3 sub, 1 div."""
    v12 = ((1.0 - pore_ratio) * press - excess * level - level * pore_pressure) / level
    return v12


def effective_stress_shaking(press: Any, press_slope: Any, level: Any, k_h: Any, k_v: Any) -> Any:
    """Effective_stress. Operations: 2 mul, 1 add, 1 sub, 1 div."""
    v10 = (k_h * press_slope + (1.0 - k_v) * press) / level
    return v10


def effective_stress_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Effective_stress. Operations: 3 mul, 1 add, 2 sub, 1 div."""
    v13 = (k_h * press_slope + (1.0 - k_v) * press - excess * level) / level
    return v13


def effective_stress_thermal_pressurisation(press: Any, level: Any, excess: Any) -> Any:
    """Effective_stress. Operations: 1 mul, 1 sub, 1 div."""
    v5 = (press - excess * level) / level
    return v5


def energy(x: Any, start: Any, drive: Any, tilt: Any) -> Any:
    """Constant friction, nothing that grows with the speed. Operations: 6 mul, 1 add, 1 sub, 2 sin."""
    v12 = np.sin(0.5 * x)
    v16 = start + 2.0 * np.sin(x) * drive - 4.0 * (v12 * v12) * tilt
    return v16


def energy_braked(x: Any, start: Any, drive: Any, tilt: Any, brake: Any) -> Any:
    """Constant friction, centripetal stress or drag. Operations: 59 mul, 34 add, 4 sub, 3 div, 1 neg, 1 min, 1 max, 2 less, 4 select, 1 abs, 2 exp, 1 expm1, 2 sin."""
    v8 = -(2.0 * brake * x)
    v13 = 2.0 * np.abs(brake * x)
    v16 = v13 < 8.673617379884035e-19
    v17 = np.where(v16, 1.0, v8)
    v26 = np.sin(0.5 * x)
    v28 = 2.0 * (v26 * v26)
    v34 = (2.0 * (2.0 * np.where(v16, 1.0, np.expm1(v17) / v17) * brake * x - v28) * brake + np.sin(x)) * drive
    v35 = x * x
    v45 = ((-9.183689863795546e-29 * v35 + 6.446950284384474e-26) * v35 + -3.868170170630684e-23) * v35 + 1.9572941063391263e-20
    v54 = ((v45 * v35 + -8.22063524662433e-18) * v35 + 2.8114572543455206e-15) * v35 + -7.647163731819816e-13
    v63 = ((v54 * v35 + 1.6059043836821613e-10) * v35 + -2.505210838544172e-08) * v35 + 2.7557319223985893e-06
    v72 = ((v63 * v35 + -0.0001984126984126984) * v35 + 0.008333333333333333) * v35 + -0.16666666666666666
    v81 = np.maximum(-1.0, np.minimum(1.0, v8))
    v90 = ((8.22063524662433e-18 * v81 + 1.5619206968586225e-16) * v81 + 2.8114572543455206e-15) * v81 + 4.779477332387385e-14
    v98 = ((v90 * v81 + 7.647163731819816e-13) * v81 + 1.1470745597729725e-11) * v81 + 1.6059043836821613e-10
    v107 = ((v98 * v81 + 2.08767569878681e-09) * v81 + 2.505210838544172e-08) * v81 + 2.755731922398589e-07
    v115 = ((v107 * v81 + 2.7557319223985893e-06) * v81 + 2.48015873015873e-05) * v81 + 0.0001984126984126984
    v124 = (((v115 * v81 + 0.001388888888888889) * v81 + 0.008333333333333333) * v81 + 0.041666666666666664) * v81
    v129 = v13 < 1.0
    v130 = np.where(v129, 1.0, v8)
    v136 = np.where(v129, (v124 + 0.16666666666666666) * v81 + 0.5, (np.exp(v130) - 1.0 - v130) / (v130 * v130))
    v150 = 2.0 * (v34 - (2.0 * v72 * brake * x * x * x + 4.0 * v136 * brake * brake * x * x + v28) * tilt) / (1.0 + 4.0 * brake * brake)
    v151 = np.exp(v8) * start + v150
    return v151


def energy_braked_constant(x: Any, start: Any, drive: Any, tilt: Any, constant: Any, brake: Any) -> Any:
    """Constant friction, centripetal stress or drag. Operations: 69 mul, 36 add, 5 sub, 3 div, 1 neg, 1 min, 1 max, 2 less, 4 select, 1 abs, 2 exp, 1 expm1, 2 sin."""
    v9 = -(2.0 * brake * x)
    v12 = x * x
    v22 = ((-9.183689863795546e-29 * v12 + 6.446950284384474e-26) * v12 + -3.868170170630684e-23) * v12 + 1.9572941063391263e-20
    v31 = ((v22 * v12 + -8.22063524662433e-18) * v12 + 2.8114572543455206e-15) * v12 + -7.647163731819816e-13
    v40 = ((v31 * v12 + 1.6059043836821613e-10) * v12 + -2.505210838544172e-08) * v12 + 2.7557319223985893e-06
    v49 = ((v40 * v12 + -0.0001984126984126984) * v12 + 0.008333333333333333) * v12 + -0.16666666666666666
    v55 = 2.0 * np.abs(brake * x)
    v59 = np.maximum(-1.0, np.minimum(1.0, v9))
    v68 = ((8.22063524662433e-18 * v59 + 1.5619206968586225e-16) * v59 + 2.8114572543455206e-15) * v59 + 4.779477332387385e-14
    v76 = ((v68 * v59 + 7.647163731819816e-13) * v59 + 1.1470745597729725e-11) * v59 + 1.6059043836821613e-10
    v85 = ((v76 * v59 + 2.08767569878681e-09) * v59 + 2.505210838544172e-08) * v59 + 2.755731922398589e-07
    v93 = ((v85 * v59 + 2.7557319223985893e-06) * v59 + 2.48015873015873e-05) * v59 + 0.0001984126984126984
    v102 = (((v93 * v59 + 0.001388888888888889) * v59 + 0.008333333333333333) * v59 + 0.041666666666666664) * v59
    v108 = v55 < 1.0
    v109 = np.where(v108, 1.0, v9)
    v115 = np.where(v108, (v102 + 0.16666666666666666) * v59 + 0.5, (np.exp(v109) - 1.0 - v109) / (v109 * v109))
    v123 = np.sin(0.5 * x)
    v124 = v123 * v123
    v130 = v55 < 8.673617379884035e-19
    v131 = np.where(v130, 1.0, v9)
    v138 = 2.0 * v124
    v144 = (2.0 * (2.0 * np.where(v130, 1.0, np.expm1(v131) / v131) * brake * x - v138) * brake + np.sin(x)) * drive
    v159 = (v49 * x * x * x + 2.0 * v115 * brake * x * x - 4.0 * v124 * brake) * constant + v144 - (2.0 * v49 * brake * x * x * x + 4.0 * v115 * brake * brake * x * x + v138) * tilt
    v165 = np.exp(v9) * start + 2.0 * v159 / (1.0 + 4.0 * brake * brake)
    return v165


def energy_constant(x: Any, start: Any, drive: Any, tilt: Any, constant: Any) -> Any:
    """Constant friction, nothing that grows with the speed. Operations: 23 mul, 14 add, 1 sub, 2 sin."""
    v8 = x * x
    v18 = ((-9.183689863795546e-29 * v8 + 6.446950284384474e-26) * v8 + -3.868170170630684e-23) * v8 + 1.9572941063391263e-20
    v27 = ((v18 * v8 + -8.22063524662433e-18) * v8 + 2.8114572543455206e-15) * v8 + -7.647163731819816e-13
    v36 = ((v27 * v8 + 1.6059043836821613e-10) * v8 + -2.505210838544172e-08) * v8 + 2.7557319223985893e-06
    v46 = (((v36 * v8 + -0.0001984126984126984) * v8 + 0.008333333333333333) * v8 + -0.16666666666666666) * constant
    v53 = np.sin(0.5 * x)
    v59 = start + 2.0 * (np.sin(x) * drive + v46 * x * x * x - 2.0 * (v53 * v53) * tilt)
    return v59


def energy_softening(x: Any, start: Any, drive: Any, tilt: Any, drop: Any, decay: Any, press: Any, press_rise: Any) -> Any:
    """Exponential softening, no brake. Operations: 73 mul, 38 add, 5 sub, 4 div, 1 neg, 1 min, 1 max, 2 less, 4 select, 1 abs, 2 exp, 1 expm1, 2 sin."""
    v9 = np.sin(x)
    v13 = x * x
    v23 = ((-9.183689863795546e-29 * v13 + 6.446950284384474e-26) * v13 + -3.868170170630684e-23) * v13 + 1.9572941063391263e-20
    v32 = ((v23 * v13 + -8.22063524662433e-18) * v13 + 2.8114572543455206e-15) * v13 + -7.647163731819816e-13
    v41 = ((v32 * v13 + 1.6059043836821613e-10) * v13 + -2.505210838544172e-08) * v13 + 2.7557319223985893e-06
    v50 = ((v41 * v13 + -0.0001984126984126984) * v13 + 0.008333333333333333) * v13 + -0.16666666666666666
    v56 = decay * x
    v57 = np.abs(v56)
    v60 = -v56
    v62 = np.maximum(-1.0, np.minimum(1.0, v60))
    v71 = ((8.22063524662433e-18 * v62 + 1.5619206968586225e-16) * v62 + 2.8114572543455206e-15) * v62 + 4.779477332387385e-14
    v79 = ((v71 * v62 + 7.647163731819816e-13) * v62 + 1.1470745597729725e-11) * v62 + 1.6059043836821613e-10
    v88 = ((v79 * v62 + 2.08767569878681e-09) * v62 + 2.505210838544172e-08) * v62 + 2.755731922398589e-07
    v96 = ((v88 * v62 + 2.7557319223985893e-06) * v62 + 2.48015873015873e-05) * v62 + 0.0001984126984126984
    v105 = (((v96 * v62 + 0.001388888888888889) * v62 + 0.008333333333333333) * v62 + 0.041666666666666664) * v62
    v111 = v57 < 1.0
    v112 = np.where(v111, 1.0, v60)
    v118 = np.where(v111, (v105 + 0.16666666666666666) * v62 + 0.5, (np.exp(v112) - 1.0 - v112) / (v112 * v112))
    v120 = v118 * decay * decay
    v126 = v57 < 8.673617379884035e-19
    v127 = np.where(v126, 1.0, v60)
    v130 = np.where(v126, 1.0, np.expm1(v127) / v127)
    v135 = np.exp(v60)
    v137 = np.sin(0.5 * x)
    v138 = v137 * v137
    v142 = v50 * decay * decay * x * x * x + v120 * decay * x * x + v9 * v130 * decay * x - 2.0 * v135 * v138 * decay
    v143 = decay * decay
    v144 = 1.0 + v143
    v147 = v130 * decay
    v164 = 2.0 * (v143 + v147 * x) * v138 + v120 * x * x + v135 * v50 * decay * x * x * x - v147 * decay * x * x
    v174 = start + 2.0 * v9 * drive + 2.0 * (v142 / v144 * press + v164 / v144 * press_rise) * drop - 4.0 * v138 * tilt
    return v174


def energy_softening_constant(x: Any, start: Any, drive: Any, tilt: Any, constant: Any, drop: Any, decay: Any, press: Any, press_rise: Any) -> Any:
    """Exponential softening, no brake. Operations: 77 mul, 39 add, 5 sub, 4 div, 1 neg, 1 min, 1 max, 2 less, 4 select, 1 abs, 2 exp, 1 expm1, 2 sin."""
    v10 = x * x
    v20 = ((-9.183689863795546e-29 * v10 + 6.446950284384474e-26) * v10 + -3.868170170630684e-23) * v10 + 1.9572941063391263e-20
    v29 = ((v20 * v10 + -8.22063524662433e-18) * v10 + 2.8114572543455206e-15) * v10 + -7.647163731819816e-13
    v38 = ((v29 * v10 + 1.6059043836821613e-10) * v10 + -2.505210838544172e-08) * v10 + 2.7557319223985893e-06
    v47 = ((v38 * v10 + -0.0001984126984126984) * v10 + 0.008333333333333333) * v10 + -0.16666666666666666
    v53 = decay * x
    v54 = np.abs(v53)
    v57 = -v53
    v59 = np.maximum(-1.0, np.minimum(1.0, v57))
    v68 = ((8.22063524662433e-18 * v59 + 1.5619206968586225e-16) * v59 + 2.8114572543455206e-15) * v59 + 4.779477332387385e-14
    v76 = ((v68 * v59 + 7.647163731819816e-13) * v59 + 1.1470745597729725e-11) * v59 + 1.6059043836821613e-10
    v85 = ((v76 * v59 + 2.08767569878681e-09) * v59 + 2.505210838544172e-08) * v59 + 2.755731922398589e-07
    v93 = ((v85 * v59 + 2.7557319223985893e-06) * v59 + 2.48015873015873e-05) * v59 + 0.0001984126984126984
    v102 = (((v93 * v59 + 0.001388888888888889) * v59 + 0.008333333333333333) * v59 + 0.041666666666666664) * v59
    v108 = v54 < 1.0
    v109 = np.where(v108, 1.0, v57)
    v115 = np.where(v108, (v102 + 0.16666666666666666) * v59 + 0.5, (np.exp(v109) - 1.0 - v109) / (v109 * v109))
    v117 = v115 * decay * decay
    v122 = np.sin(x)
    v124 = v54 < 8.673617379884035e-19
    v125 = np.where(v124, 1.0, v57)
    v128 = np.where(v124, 1.0, np.expm1(v125) / v125)
    v133 = np.exp(v57)
    v135 = np.sin(0.5 * x)
    v136 = v135 * v135
    v140 = v47 * decay * decay * x * x * x + v117 * decay * x * x + v122 * v128 * decay * x - 2.0 * v133 * v136 * decay
    v141 = decay * decay
    v142 = 1.0 + v141
    v145 = v128 * decay
    v162 = 2.0 * (v141 + v145 * x) * v136 + v117 * x * x + v133 * v47 * decay * x * x * x - v145 * decay * x * x
    v179 = start + 2.0 * (v140 / v142 * press + v162 / v142 * press_rise) * drop + 2.0 * (v122 * drive + v47 * constant * x * x * x - 2.0 * v136 * tilt)
    return v179


def energy_softening_constant_water(x: Any, start: Any, drive: Any, tilt: Any, constant: Any, drop: Any, decay: Any, press: Any, press_rise: Any, water: Any) -> Any:
    """Exponential softening, no brake. Operations: 80 mul, 39 add, 6 sub, 4 div, 1 neg, 1 min, 1 max, 2 less, 4 select, 1 abs, 2 exp, 1 expm1, 2 sin."""
    v11 = x * x
    v21 = ((-9.183689863795546e-29 * v11 + 6.446950284384474e-26) * v11 + -3.868170170630684e-23) * v11 + 1.9572941063391263e-20
    v30 = ((v21 * v11 + -8.22063524662433e-18) * v11 + 2.8114572543455206e-15) * v11 + -7.647163731819816e-13
    v39 = ((v30 * v11 + 1.6059043836821613e-10) * v11 + -2.505210838544172e-08) * v11 + 2.7557319223985893e-06
    v48 = ((v39 * v11 + -0.0001984126984126984) * v11 + 0.008333333333333333) * v11 + -0.16666666666666666
    v54 = decay * x
    v55 = np.abs(v54)
    v58 = -v54
    v60 = np.maximum(-1.0, np.minimum(1.0, v58))
    v69 = ((8.22063524662433e-18 * v60 + 1.5619206968586225e-16) * v60 + 2.8114572543455206e-15) * v60 + 4.779477332387385e-14
    v77 = ((v69 * v60 + 7.647163731819816e-13) * v60 + 1.1470745597729725e-11) * v60 + 1.6059043836821613e-10
    v86 = ((v77 * v60 + 2.08767569878681e-09) * v60 + 2.505210838544172e-08) * v60 + 2.755731922398589e-07
    v94 = ((v86 * v60 + 2.7557319223985893e-06) * v60 + 2.48015873015873e-05) * v60 + 0.0001984126984126984
    v103 = (((v94 * v60 + 0.001388888888888889) * v60 + 0.008333333333333333) * v60 + 0.041666666666666664) * v60
    v109 = v55 < 1.0
    v110 = np.where(v109, 1.0, v58)
    v116 = np.where(v109, (v103 + 0.16666666666666666) * v60 + 0.5, (np.exp(v110) - 1.0 - v110) / (v110 * v110))
    v117 = v116 * decay
    v118 = v117 * decay
    v123 = np.sin(x)
    v125 = v55 < 8.673617379884035e-19
    v126 = np.where(v125, 1.0, v58)
    v129 = np.where(v125, 1.0, np.expm1(v126) / v126)
    v134 = np.exp(v58)
    v136 = np.sin(0.5 * x)
    v137 = v136 * v136
    v141 = v48 * decay * decay * x * x * x + v118 * decay * x * x + v123 * v129 * decay * x - 2.0 * v134 * v137 * decay
    v142 = decay * decay
    v143 = 1.0 + v142
    v146 = v129 * decay
    v163 = 2.0 * (v142 + v146 * x) * v137 + v118 * x * x + v134 * v48 * decay * x * x * x - v146 * decay * x * x
    v184 = start + 2.0 * (v141 / v143 * press + v163 / v143 * press_rise - v117 * water * x * x) * drop + 2.0 * (v123 * drive + v48 * constant * x * x * x - 2.0 * v137 * tilt)
    return v184


def fall_shaking(fall: Any, fall_slope: Any, k_h: Any, k_v: Any) -> Any:
    """Fall. Operations: 2 mul, 1 add, 1 sub."""
    v8 = (1.0 - k_v) * fall + fall_slope * k_h
    return v8


def friction_exponential(slip: Any, peak: Any, residual: Any, length: Any) -> Any:
    """Friction: residual + (peak - residual) exp(-slip/length). Operations: 1 mul, 1 add, 1 sub, 1 div, 1 neg, 1 exp."""
    v9 = residual + (peak - residual) * np.exp(-(slip / length))
    return v9


def friction_hyperbolic(slip: Any, peak: Any, residual: Any, length: Any) -> Any:
    """Friction: residual + (peak - residual)/(1 + slip/length). Operations: 2 add, 1 sub, 2 div."""
    v9 = residual + (peak - residual) / (1.0 + slip / length)
    return v9


def friction_linear(slip: Any, peak: Any, residual: Any, length: Any) -> Any:
    """Friction: falls from peak to residual over the length, then stays. Operations: 1 mul, 1 add, 1 sub, 1 div, 1 min."""
    v9 = peak + (residual - peak) * np.minimum(1.0, slip / length)
    return v9


def friction_rate_weakening(speed: Any, peak: Any, residual: Any, velocity: Any) -> Any:
    """Friction: residual + (peak - residual)/(1 + speed/velocity). Operations: 2 add, 1 sub, 2 div."""
    v9 = residual + (peak - residual) / (1.0 + speed / velocity)
    return v9


def frozen_braked_state(a: Any, b: Any, omega_0: Any, t: Any) -> tuple[Any, Any, Any]:
    """Rotation, velocity and acceleration at a time. Operations: 56 mul, 35 add, 3 sub, 8 div, 1 neg, 4 min, 3 max, 4 less, 18 select, 3 abs, 1 exp, 1 log, 1 log1p, 2 sign, 2 sqrt."""
    v8 = np.sqrt(np.abs(a)) * np.sqrt(np.abs(b))
    v14 = np.minimum(t, 800.0 / np.maximum(1e-300, v8)) * v8
    v19 = np.sign(a) * np.sign(b) * v14 * v14
    v23 = np.maximum(-9.869604401089358, np.minimum(1.0, v19))
    v25 = 1.0 < v19
    v26 = np.where(v25, 0.0, t)
    v28 = np.exp(-v14)
    v30 = b * omega_0
    v31 = v8 + v30
    v32 = v8 - v30
    v35 = 0.25 * v23
    v45 = ((9.183689863795546e-29 * v35 + 6.446950284384474e-26) * v35 + 3.868170170630684e-23) * v35 + 1.9572941063391263e-20
    v54 = ((v45 * v35 + 8.22063524662433e-18) * v35 + 2.8114572543455206e-15) * v35 + 7.647163731819816e-13
    v63 = ((v54 * v35 + 1.6059043836821613e-10) * v35 + 2.505210838544172e-08) * v35 + 2.7557319223985893e-06
    v73 = (((v63 * v35 + 0.0001984126984126984) * v35 + 0.008333333333333333) * v35 + 0.16666666666666666) * v35
    v74 = v73 + 1.0
    v76 = 0.5 * (v74 * v74)
    v78 = 1.0 + v76 * v23
    v84 = ((9.183689863795546e-29 * v23 + 6.446950284384474e-26) * v23 + 3.868170170630684e-23) * v23 + 1.9572941063391263e-20
    v90 = ((v84 * v23 + 8.22063524662433e-18) * v23 + 2.8114572543455206e-15) * v23 + 7.647163731819816e-13
    v96 = ((v90 * v23 + 1.6059043836821613e-10) * v23 + 2.505210838544172e-08) * v23 + 2.7557319223985893e-06
    v103 = (((v96 * v23 + 0.0001984126984126984) * v23 + 0.008333333333333333) * v23 + 0.16666666666666666) * v23
    v105 = (v103 + 1.0) * v26
    v106 = v32 * (v28 * v28)
    v114 = np.where(v25, 0.5 * (v31 + v106) / np.where(v25, v8, 1.0), v78 + v105 * b * omega_0)
    v119 = v76 * a * v26 * v26 + v105 * omega_0
    v120 = v119 * b
    v122 = np.where(v25, v114, 1.0 + v120)
    v125 = 9.869604401089358 + v19
    v127 = 0.0 < np.minimum(v114, v125)
    v128 = np.where(v127, v114, 1.0)
    v129 = np.where(v25, v28, 1.0) / v128
    v133 = 0.0 < np.minimum(v122, v125)
    v137 = np.where(v25, b, 1.0)
    v141 = np.where(v25, 0.0, np.maximum(-0.9999999999999999, v120))
    v144 = np.abs(v141) < 8.673617379884035e-19
    v145 = np.where(v144, 1.0, v141)
    v150 = np.where(v25, (np.where(v25, t, 0.0) * v8 + np.log(np.where(v133, v122, 1.0))) / v137, np.where(v144, 1.0, np.log1p(v145) / v145) * v119)
    v152 = np.where(v133, v150, np.nan)
    v161 = np.where(v127, np.where(v25, 0.5 * (v31 - v106) / v137, v78 * omega_0 + v105 * a) / v128, np.nan)
    v169 = np.where(v127, np.where(v25, v32 / v137 * v31, a - v30 * omega_0) * v129 * v129, np.nan)
    return v152, v161, v169


def frozen_state(a: Any, omega_0: Any, t: Any) -> tuple[Any, Any, Any]:
    """Rotation, velocity and acceleration at a time. Operations: 4 mul, 2 add."""
    v7 = (omega_0 + 0.5 * a * t) * t
    v9 = omega_0 + a * t
    return v7, v9, a


def limit_friction(static_limit: Any) -> Any:
    """Limit_friction. Operations: none."""
    return static_limit


def limit_friction_cohesion(static_limit: Any, press: Any, level: Any, cohesion: Any) -> Any:
    """Limit_friction. Operations: 2 mul, 1 sub, 1 div."""
    v7 = (press * static_limit - cohesion * level) / press
    return v7


def limit_friction_cohesion_shaking(static_limit: Any, press: Any, fall_slope: Any, press_slope: Any, level: Any, cohesion: Any, k_h: Any, k_v: Any) -> Any:
    """Limit_friction. Operations: 7 mul, 2 add, 3 sub, 1 div."""
    v21 = (fall_slope * k_h + press * static_limit - cohesion * level - k_v * press * static_limit) / (k_h * press_slope + (1.0 - k_v) * press)
    return v21


def limit_friction_cohesion_shaking_thermal_pressurisation(static_limit: Any, press: Any, fall_slope: Any, press_slope: Any, level: Any, cohesion: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Limit_friction. Operations: 8 mul, 2 add, 4 sub, 1 div."""
    v24 = (fall_slope * k_h + press * static_limit - cohesion * level - k_v * press * static_limit) / (k_h * press_slope + (1.0 - k_v) * press - excess * level)
    return v24


def limit_friction_cohesion_thermal_pressurisation(static_limit: Any, press: Any, level: Any, cohesion: Any, excess: Any) -> Any:
    """Limit_friction. Operations: 3 mul, 2 sub, 1 div."""
    v10 = (press * static_limit - cohesion * level) / (press - excess * level)
    return v10


def limit_friction_pore_pressure(static_limit: Any, press: Any, level: Any, pore_ratio: Any, pore_pressure: Any) -> Any:
    """Limit_friction. Operations: 3 mul, 2 sub, 1 div."""
    v11 = press / ((1.0 - pore_ratio) * press - level * pore_pressure) * static_limit
    return v11


def limit_friction_pore_pressure_cohesion(static_limit: Any, press: Any, level: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any) -> Any:
    """Limit_friction. Operations: 4 mul, 3 sub, 1 div."""
    v14 = (press * static_limit - cohesion * level) / ((1.0 - pore_ratio) * press - level * pore_pressure)
    return v14


def limit_friction_pore_pressure_cohesion_shaking(static_limit: Any, press: Any, fall_slope: Any, press_slope: Any, level: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, k_h: Any, k_v: Any) -> Any:
    """Limit_friction. Operations: 8 mul, 2 add, 5 sub, 1 div."""
    v26 = (fall_slope * k_h + press * static_limit - cohesion * level - k_v * press * static_limit) / (k_h * press_slope + (1.0 - k_v - pore_ratio) * press - level * pore_pressure)
    return v26


def limit_friction_pore_pressure_cohesion_shaking_thermal_pressurisation(static_limit: Any, press: Any, fall_slope: Any, press_slope: Any, level: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Limit_friction. Operations: 9 mul, 2 add, 6 sub, 1 div."""
    v29 = (fall_slope * k_h + press * static_limit - cohesion * level - k_v * press * static_limit) / (k_h * press_slope + (1.0 - k_v - pore_ratio) * press - excess * level - level * pore_pressure)
    return v29


def limit_friction_pore_pressure_cohesion_thermal_pressurisation(static_limit: Any, press: Any, level: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, excess: Any) -> Any:
    """Limit_friction. Operations: 5 mul, 4 sub, 1 div."""
    v17 = (press * static_limit - cohesion * level) / ((1.0 - pore_ratio) * press - excess * level - level * pore_pressure)
    return v17


def limit_friction_pore_pressure_shaking(static_limit: Any, press: Any, fall_slope: Any, press_slope: Any, level: Any, pore_ratio: Any, pore_pressure: Any, k_h: Any, k_v: Any) -> Any:
    """Limit_friction. Operations: 7 mul, 2 add, 4 sub, 1 div."""
    v23 = (fall_slope * k_h + press * static_limit - k_v * press * static_limit) / (k_h * press_slope + (1.0 - k_v - pore_ratio) * press - level * pore_pressure)
    return v23


def limit_friction_pore_pressure_shaking_thermal_pressurisation(static_limit: Any, press: Any, fall_slope: Any, press_slope: Any, level: Any, pore_ratio: Any, pore_pressure: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Limit_friction. Operations: 8 mul, 2 add, 5 sub, 1 div."""
    v26 = (fall_slope * k_h + press * static_limit - k_v * press * static_limit) / (k_h * press_slope + (1.0 - k_v - pore_ratio) * press - excess * level - level * pore_pressure)
    return v26


def limit_friction_pore_pressure_thermal_pressurisation(static_limit: Any, press: Any, level: Any, pore_ratio: Any, pore_pressure: Any, excess: Any) -> Any:
    """Limit_friction. Operations: 4 mul, 3 sub, 1 div."""
    v14 = press / ((1.0 - pore_ratio) * press - excess * level - level * pore_pressure) * static_limit
    return v14


def limit_friction_shaking(static_limit: Any, press: Any, fall_slope: Any, press_slope: Any, k_h: Any, k_v: Any) -> Any:
    """Limit_friction. Operations: 6 mul, 2 add, 2 sub, 1 div."""
    v17 = (fall_slope * k_h + press * static_limit - k_v * press * static_limit) / (k_h * press_slope + (1.0 - k_v) * press)
    return v17


def limit_friction_shaking_thermal_pressurisation(static_limit: Any, press: Any, fall_slope: Any, press_slope: Any, level: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Limit_friction. Operations: 7 mul, 2 add, 3 sub, 1 div."""
    v21 = (fall_slope * k_h + press * static_limit - k_v * press * static_limit) / (k_h * press_slope + (1.0 - k_v) * press - excess * level)
    return v21


def limit_friction_thermal_pressurisation(static_limit: Any, press: Any, level: Any, excess: Any) -> Any:
    """Limit_friction. Operations: 2 mul, 1 sub, 1 div."""
    v7 = press / (press - excess * level) * static_limit
    return v7


def normal(press: Any) -> Any:
    """Normal. Operations: none."""
    return press


def normal_pore_pressure(press: Any, level: Any, pore_ratio: Any, pore_pressure: Any) -> Any:
    """Normal. Operations: 2 mul, 2 sub."""
    v8 = (1.0 - pore_ratio) * press - level * pore_pressure
    return v8


def normal_pore_pressure_shaking(press: Any, press_slope: Any, level: Any, pore_ratio: Any, pore_pressure: Any, k_h: Any, k_v: Any) -> Any:
    """Normal. Operations: 3 mul, 1 add, 3 sub."""
    v14 = k_h * press_slope + (1.0 - k_v - pore_ratio) * press - level * pore_pressure
    return v14


def normal_pore_pressure_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, pore_ratio: Any, pore_pressure: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Normal. Operations: 4 mul, 1 add, 4 sub."""
    v17 = k_h * press_slope + (1.0 - k_v - pore_ratio) * press - excess * level - level * pore_pressure
    return v17


def normal_pore_pressure_thermal_pressurisation(press: Any, level: Any, pore_ratio: Any, pore_pressure: Any, excess: Any) -> Any:
    """Normal. Operations: 3 mul, 3 sub."""
    v11 = (1.0 - pore_ratio) * press - excess * level - level * pore_pressure
    return v11


def normal_shaking(press: Any, press_slope: Any, k_h: Any, k_v: Any) -> Any:
    """Normal. Operations: 2 mul, 1 add, 1 sub."""
    v8 = k_h * press_slope + (1.0 - k_v) * press
    return v8


def normal_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Normal. Operations: 3 mul, 1 add, 2 sub."""
    v12 = k_h * press_slope + (1.0 - k_v) * press - excess * level
    return v12


def normal_stress(press: Any, level: Any) -> Any:
    """Normal_stress. Operations: 1 div."""
    v2 = press / level
    return v2


def normal_stress_centripetal(press: Any, level: Any, polar: Any, omega_2: Any) -> Any:
    """Normal_stress. Operations: 1 mul, 1 add, 1 div."""
    v6 = (press + omega_2 * polar) / level
    return v6


def normal_stress_centripetal_shaking(press: Any, press_slope: Any, level: Any, polar: Any, omega_2: Any, k_h: Any, k_v: Any) -> Any:
    """Normal_stress. Operations: 3 mul, 2 add, 1 sub, 1 div."""
    v14 = (k_h * press_slope + omega_2 * polar + (1.0 - k_v) * press) / level
    return v14


def normal_stress_shaking(press: Any, press_slope: Any, level: Any, k_h: Any, k_v: Any) -> Any:
    """Normal_stress. Operations: 2 mul, 1 add, 1 sub, 1 div."""
    v10 = (k_h * press_slope + (1.0 - k_v) * press) / level
    return v10


def normal_thermal_pressurisation(press: Any, level: Any, excess: Any) -> Any:
    """Normal. Operations: 1 mul, 1 sub."""
    v4 = press - excess * level
    return v4


def pressurisation_centripetal_pore_pressure_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, polar: Any, mu: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, k_h: Any, k_v: Any, kappa: Any, excess: Any) -> Any:
    """Pressurisation. Operations: 7 mul, 2 add, 4 sub, 1 div."""
    v23 = k_h * press_slope + omega_2 * polar + (1.0 - k_v - pore_ratio) * press - excess * level - level * pore_pressure
    v26 = v23 / level * kappa * mu
    return v26


def pressurisation_centripetal_pore_pressure_thermal_pressurisation(press: Any, level: Any, polar: Any, mu: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, kappa: Any, excess: Any) -> Any:
    """Pressurisation. Operations: 6 mul, 1 add, 3 sub, 1 div."""
    v19 = (omega_2 * polar + (1.0 - pore_ratio) * press - excess * level - level * pore_pressure) / level * kappa
    v20 = v19 * mu
    return v20


def pressurisation_centripetal_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, polar: Any, mu: Any, omega_2: Any, k_h: Any, k_v: Any, kappa: Any, excess: Any) -> Any:
    """Pressurisation. Operations: 6 mul, 2 add, 2 sub, 1 div."""
    v21 = (k_h * press_slope + omega_2 * polar + (1.0 - k_v) * press - excess * level) / level * kappa * mu
    return v21


def pressurisation_centripetal_thermal_pressurisation(press: Any, level: Any, polar: Any, mu: Any, omega_2: Any, kappa: Any, excess: Any) -> Any:
    """Pressurisation. Operations: 4 mul, 1 add, 1 sub, 1 div."""
    v13 = (press + omega_2 * polar - excess * level) / level * kappa * mu
    return v13


def pressurisation_pore_pressure_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, mu: Any, pore_ratio: Any, pore_pressure: Any, k_h: Any, k_v: Any, kappa: Any, excess: Any) -> Any:
    """Pressurisation. Operations: 6 mul, 1 add, 4 sub, 1 div."""
    v20 = (k_h * press_slope + (1.0 - k_v - pore_ratio) * press - excess * level - level * pore_pressure) / level
    v22 = v20 * kappa * mu
    return v22


def pressurisation_pore_pressure_thermal_pressurisation(press: Any, level: Any, mu: Any, pore_ratio: Any, pore_pressure: Any, kappa: Any, excess: Any) -> Any:
    """Pressurisation. Operations: 5 mul, 3 sub, 1 div."""
    v16 = ((1.0 - pore_ratio) * press - excess * level - level * pore_pressure) / level * kappa * mu
    return v16


def pressurisation_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, mu: Any, k_h: Any, k_v: Any, kappa: Any, excess: Any) -> Any:
    """Pressurisation. Operations: 5 mul, 1 add, 2 sub, 1 div."""
    v17 = (k_h * press_slope + (1.0 - k_v) * press - excess * level) / level * kappa * mu
    return v17


def pressurisation_thermal_pressurisation(press: Any, level: Any, mu: Any, kappa: Any, excess: Any) -> Any:
    """Pressurisation. Operations: 3 mul, 1 sub, 1 div."""
    v9 = (press - excess * level) / level * kappa * mu
    return v9


def resistance(press: Any, mu: Any) -> Any:
    """Resistance. Operations: 1 mul."""
    v2 = mu * press
    return v2


def resistance_centripetal(press: Any, polar: Any, mu: Any, omega_2: Any) -> Any:
    """Resistance. Operations: 2 mul, 1 add."""
    v6 = (press + omega_2 * polar) * mu
    return v6


def resistance_centripetal_cohesion(press: Any, level: Any, polar: Any, mu: Any, omega_2: Any, cohesion: Any) -> Any:
    """Resistance. Operations: 3 mul, 2 add."""
    v10 = cohesion * level + (press + omega_2 * polar) * mu
    return v10


def resistance_centripetal_cohesion_drag(press: Any, level: Any, polar: Any, mu: Any, omega_2: Any, cohesion: Any, drag: Any) -> Any:
    """Resistance. Operations: 4 mul, 3 add."""
    v13 = cohesion * level + drag * omega_2 + (press + omega_2 * polar) * mu
    return v13


def resistance_centripetal_cohesion_drag_shaking(press: Any, press_slope: Any, level: Any, polar: Any, mu: Any, omega_2: Any, cohesion: Any, drag: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 6 mul, 4 add, 1 sub."""
    v21 = cohesion * level + drag * omega_2 + (k_h * press_slope + omega_2 * polar + (1.0 - k_v) * press) * mu
    return v21


def resistance_centripetal_cohesion_drag_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, polar: Any, mu: Any, omega_2: Any, cohesion: Any, drag: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 7 mul, 4 add, 2 sub."""
    v24 = cohesion * level + drag * omega_2 + (k_h * press_slope + omega_2 * polar + (1.0 - k_v) * press - excess * level) * mu
    return v24


def resistance_centripetal_cohesion_drag_thermal_pressurisation(press: Any, level: Any, polar: Any, mu: Any, omega_2: Any, cohesion: Any, drag: Any, excess: Any) -> Any:
    """Resistance. Operations: 5 mul, 3 add, 1 sub."""
    v16 = cohesion * level + drag * omega_2 + (press + omega_2 * polar - excess * level) * mu
    return v16


def resistance_centripetal_cohesion_drag_viscosity(press: Any, level: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, cohesion: Any, drag: Any, viscosity: Any) -> Any:
    """Resistance. Operations: 5 mul, 4 add."""
    v17 = cohesion * level + drag * omega_2 + (press + omega_2 * polar) * mu + omega * viscosity
    return v17


def resistance_centripetal_cohesion_drag_viscosity_shaking(press: Any, press_slope: Any, level: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, cohesion: Any, drag: Any, viscosity: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 7 mul, 5 add, 1 sub."""
    v23 = cohesion * level + drag * omega_2 + (k_h * press_slope + omega_2 * polar + (1.0 - k_v) * press) * mu
    v25 = v23 + omega * viscosity
    return v25


def resistance_centripetal_cohesion_drag_viscosity_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, cohesion: Any, drag: Any, viscosity: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 8 mul, 5 add, 2 sub."""
    v26 = cohesion * level + drag * omega_2 + (k_h * press_slope + omega_2 * polar + (1.0 - k_v) * press - excess * level) * mu
    v28 = v26 + omega * viscosity
    return v28


def resistance_centripetal_cohesion_drag_viscosity_thermal_pressurisation(press: Any, level: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, cohesion: Any, drag: Any, viscosity: Any, excess: Any) -> Any:
    """Resistance. Operations: 6 mul, 4 add, 1 sub."""
    v20 = cohesion * level + drag * omega_2 + (press + omega_2 * polar - excess * level) * mu + omega * viscosity
    return v20


def resistance_centripetal_cohesion_shaking(press: Any, press_slope: Any, level: Any, polar: Any, mu: Any, omega_2: Any, cohesion: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 5 mul, 3 add, 1 sub."""
    v18 = cohesion * level + (k_h * press_slope + omega_2 * polar + (1.0 - k_v) * press) * mu
    return v18


def resistance_centripetal_cohesion_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, polar: Any, mu: Any, omega_2: Any, cohesion: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 6 mul, 3 add, 2 sub."""
    v21 = cohesion * level + (k_h * press_slope + omega_2 * polar + (1.0 - k_v) * press - excess * level) * mu
    return v21


def resistance_centripetal_cohesion_thermal_pressurisation(press: Any, level: Any, polar: Any, mu: Any, omega_2: Any, cohesion: Any, excess: Any) -> Any:
    """Resistance. Operations: 4 mul, 2 add, 1 sub."""
    v13 = cohesion * level + (press + omega_2 * polar - excess * level) * mu
    return v13


def resistance_centripetal_cohesion_viscosity(press: Any, level: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, cohesion: Any, viscosity: Any) -> Any:
    """Resistance. Operations: 4 mul, 3 add."""
    v14 = cohesion * level + (press + omega_2 * polar) * mu + omega * viscosity
    return v14


def resistance_centripetal_cohesion_viscosity_shaking(press: Any, press_slope: Any, level: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, cohesion: Any, viscosity: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 6 mul, 4 add, 1 sub."""
    v22 = cohesion * level + (k_h * press_slope + omega_2 * polar + (1.0 - k_v) * press) * mu + omega * viscosity
    return v22


def resistance_centripetal_cohesion_viscosity_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, cohesion: Any, viscosity: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 7 mul, 4 add, 2 sub."""
    v23 = cohesion * level + (k_h * press_slope + omega_2 * polar + (1.0 - k_v) * press - excess * level) * mu
    v25 = v23 + omega * viscosity
    return v25


def resistance_centripetal_cohesion_viscosity_thermal_pressurisation(press: Any, level: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, cohesion: Any, viscosity: Any, excess: Any) -> Any:
    """Resistance. Operations: 5 mul, 3 add, 1 sub."""
    v17 = cohesion * level + (press + omega_2 * polar - excess * level) * mu + omega * viscosity
    return v17


def resistance_centripetal_drag(press: Any, polar: Any, mu: Any, omega_2: Any, drag: Any) -> Any:
    """Resistance. Operations: 3 mul, 2 add."""
    v9 = drag * omega_2 + (press + omega_2 * polar) * mu
    return v9


def resistance_centripetal_drag_shaking(press: Any, press_slope: Any, polar: Any, mu: Any, omega_2: Any, drag: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 5 mul, 3 add, 1 sub."""
    v17 = drag * omega_2 + (k_h * press_slope + omega_2 * polar + (1.0 - k_v) * press) * mu
    return v17


def resistance_centripetal_drag_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, polar: Any, mu: Any, omega_2: Any, drag: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 6 mul, 3 add, 2 sub."""
    v21 = drag * omega_2 + (k_h * press_slope + omega_2 * polar + (1.0 - k_v) * press - excess * level) * mu
    return v21


def resistance_centripetal_drag_thermal_pressurisation(press: Any, level: Any, polar: Any, mu: Any, omega_2: Any, drag: Any, excess: Any) -> Any:
    """Resistance. Operations: 4 mul, 2 add, 1 sub."""
    v13 = drag * omega_2 + (press + omega_2 * polar - excess * level) * mu
    return v13


def resistance_centripetal_drag_viscosity(press: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, drag: Any, viscosity: Any) -> Any:
    """Resistance. Operations: 4 mul, 3 add."""
    v13 = drag * omega_2 + (press + omega_2 * polar) * mu + omega * viscosity
    return v13


def resistance_centripetal_drag_viscosity_shaking(press: Any, press_slope: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, drag: Any, viscosity: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 6 mul, 4 add, 1 sub."""
    v21 = drag * omega_2 + (k_h * press_slope + omega_2 * polar + (1.0 - k_v) * press) * mu + omega * viscosity
    return v21


def resistance_centripetal_drag_viscosity_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, drag: Any, viscosity: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 7 mul, 4 add, 2 sub."""
    v23 = drag * omega_2 + (k_h * press_slope + omega_2 * polar + (1.0 - k_v) * press - excess * level) * mu
    v25 = v23 + omega * viscosity
    return v25


def resistance_centripetal_drag_viscosity_thermal_pressurisation(press: Any, level: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, drag: Any, viscosity: Any, excess: Any) -> Any:
    """Resistance. Operations: 5 mul, 3 add, 1 sub."""
    v17 = drag * omega_2 + (press + omega_2 * polar - excess * level) * mu + omega * viscosity
    return v17


def resistance_centripetal_pore_pressure(press: Any, level: Any, polar: Any, mu: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any) -> Any:
    """Resistance. Operations: 4 mul, 1 add, 2 sub."""
    v14 = (omega_2 * polar + (1.0 - pore_ratio) * press - level * pore_pressure) * mu
    return v14


def resistance_centripetal_pore_pressure_cohesion(press: Any, level: Any, polar: Any, mu: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any) -> Any:
    """Resistance. Operations: 5 mul, 2 add, 2 sub."""
    v17 = cohesion * level + (omega_2 * polar + (1.0 - pore_ratio) * press - level * pore_pressure) * mu
    return v17


def resistance_centripetal_pore_pressure_cohesion_drag(press: Any, level: Any, polar: Any, mu: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, drag: Any) -> Any:
    """Resistance. Operations: 6 mul, 3 add, 2 sub."""
    v20 = cohesion * level + drag * omega_2 + (omega_2 * polar + (1.0 - pore_ratio) * press - level * pore_pressure) * mu
    return v20


def resistance_centripetal_pore_pressure_cohesion_drag_shaking(press: Any, press_slope: Any, level: Any, polar: Any, mu: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, drag: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 7 mul, 4 add, 3 sub."""
    v25 = (k_h * press_slope + omega_2 * polar + (1.0 - k_v - pore_ratio) * press - level * pore_pressure) * mu
    v26 = cohesion * level + drag * omega_2 + v25
    return v26


def resistance_centripetal_pore_pressure_cohesion_drag_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, polar: Any, mu: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, drag: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 8 mul, 4 add, 4 sub."""
    v27 = k_h * press_slope + omega_2 * polar + (1.0 - k_v - pore_ratio) * press - excess * level - level * pore_pressure
    v29 = cohesion * level + drag * omega_2 + v27 * mu
    return v29


def resistance_centripetal_pore_pressure_cohesion_drag_thermal_pressurisation(press: Any, level: Any, polar: Any, mu: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, drag: Any, excess: Any) -> Any:
    """Resistance. Operations: 7 mul, 3 add, 3 sub."""
    v23 = cohesion * level + drag * omega_2 + (omega_2 * polar + (1.0 - pore_ratio) * press - excess * level - level * pore_pressure) * mu
    return v23


def resistance_centripetal_pore_pressure_cohesion_drag_viscosity(press: Any, level: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, drag: Any, viscosity: Any) -> Any:
    """Resistance. Operations: 7 mul, 4 add, 2 sub."""
    v22 = cohesion * level + drag * omega_2 + (omega_2 * polar + (1.0 - pore_ratio) * press - level * pore_pressure) * mu
    v24 = v22 + omega * viscosity
    return v24


def resistance_centripetal_pore_pressure_cohesion_drag_viscosity_shaking(press: Any, press_slope: Any, level: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, drag: Any, viscosity: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 8 mul, 5 add, 3 sub."""
    v27 = (k_h * press_slope + omega_2 * polar + (1.0 - k_v - pore_ratio) * press - level * pore_pressure) * mu
    v30 = cohesion * level + drag * omega_2 + v27 + omega * viscosity
    return v30


def resistance_centripetal_pore_pressure_cohesion_drag_viscosity_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, drag: Any, viscosity: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 9 mul, 5 add, 4 sub."""
    v29 = k_h * press_slope + omega_2 * polar + (1.0 - k_v - pore_ratio) * press - excess * level - level * pore_pressure
    v33 = cohesion * level + drag * omega_2 + v29 * mu + omega * viscosity
    return v33


def resistance_centripetal_pore_pressure_cohesion_drag_viscosity_thermal_pressurisation(press: Any, level: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, drag: Any, viscosity: Any, excess: Any) -> Any:
    """Resistance. Operations: 8 mul, 4 add, 3 sub."""
    v25 = cohesion * level + drag * omega_2 + (omega_2 * polar + (1.0 - pore_ratio) * press - excess * level - level * pore_pressure) * mu
    v27 = v25 + omega * viscosity
    return v27


def resistance_centripetal_pore_pressure_cohesion_shaking(press: Any, press_slope: Any, level: Any, polar: Any, mu: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 6 mul, 3 add, 3 sub."""
    v22 = (k_h * press_slope + omega_2 * polar + (1.0 - k_v - pore_ratio) * press - level * pore_pressure) * mu
    v23 = cohesion * level + v22
    return v23


def resistance_centripetal_pore_pressure_cohesion_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, polar: Any, mu: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 7 mul, 3 add, 4 sub."""
    v24 = k_h * press_slope + omega_2 * polar + (1.0 - k_v - pore_ratio) * press - excess * level - level * pore_pressure
    v26 = cohesion * level + v24 * mu
    return v26


def resistance_centripetal_pore_pressure_cohesion_thermal_pressurisation(press: Any, level: Any, polar: Any, mu: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, excess: Any) -> Any:
    """Resistance. Operations: 6 mul, 2 add, 3 sub."""
    v20 = cohesion * level + (omega_2 * polar + (1.0 - pore_ratio) * press - excess * level - level * pore_pressure) * mu
    return v20


def resistance_centripetal_pore_pressure_cohesion_viscosity(press: Any, level: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, viscosity: Any) -> Any:
    """Resistance. Operations: 6 mul, 3 add, 2 sub."""
    v21 = cohesion * level + (omega_2 * polar + (1.0 - pore_ratio) * press - level * pore_pressure) * mu + omega * viscosity
    return v21


def resistance_centripetal_pore_pressure_cohesion_viscosity_shaking(press: Any, press_slope: Any, level: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, viscosity: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 7 mul, 4 add, 3 sub."""
    v24 = (k_h * press_slope + omega_2 * polar + (1.0 - k_v - pore_ratio) * press - level * pore_pressure) * mu
    v27 = cohesion * level + v24 + omega * viscosity
    return v27


def resistance_centripetal_pore_pressure_cohesion_viscosity_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, viscosity: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 8 mul, 4 add, 4 sub."""
    v26 = k_h * press_slope + omega_2 * polar + (1.0 - k_v - pore_ratio) * press - excess * level - level * pore_pressure
    v30 = cohesion * level + v26 * mu + omega * viscosity
    return v30


def resistance_centripetal_pore_pressure_cohesion_viscosity_thermal_pressurisation(press: Any, level: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, viscosity: Any, excess: Any) -> Any:
    """Resistance. Operations: 7 mul, 3 add, 3 sub."""
    v22 = cohesion * level + (omega_2 * polar + (1.0 - pore_ratio) * press - excess * level - level * pore_pressure) * mu
    v24 = v22 + omega * viscosity
    return v24


def resistance_centripetal_pore_pressure_drag(press: Any, level: Any, polar: Any, mu: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, drag: Any) -> Any:
    """Resistance. Operations: 5 mul, 2 add, 2 sub."""
    v17 = drag * omega_2 + (omega_2 * polar + (1.0 - pore_ratio) * press - level * pore_pressure) * mu
    return v17


def resistance_centripetal_pore_pressure_drag_shaking(press: Any, press_slope: Any, level: Any, polar: Any, mu: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, drag: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 6 mul, 3 add, 3 sub."""
    v22 = (k_h * press_slope + omega_2 * polar + (1.0 - k_v - pore_ratio) * press - level * pore_pressure) * mu
    v23 = drag * omega_2 + v22
    return v23


def resistance_centripetal_pore_pressure_drag_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, polar: Any, mu: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, drag: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 7 mul, 3 add, 4 sub."""
    v24 = k_h * press_slope + omega_2 * polar + (1.0 - k_v - pore_ratio) * press - excess * level - level * pore_pressure
    v26 = drag * omega_2 + v24 * mu
    return v26


def resistance_centripetal_pore_pressure_drag_thermal_pressurisation(press: Any, level: Any, polar: Any, mu: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, drag: Any, excess: Any) -> Any:
    """Resistance. Operations: 6 mul, 2 add, 3 sub."""
    v20 = drag * omega_2 + (omega_2 * polar + (1.0 - pore_ratio) * press - excess * level - level * pore_pressure) * mu
    return v20


def resistance_centripetal_pore_pressure_drag_viscosity(press: Any, level: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, drag: Any, viscosity: Any) -> Any:
    """Resistance. Operations: 6 mul, 3 add, 2 sub."""
    v21 = drag * omega_2 + (omega_2 * polar + (1.0 - pore_ratio) * press - level * pore_pressure) * mu + omega * viscosity
    return v21


def resistance_centripetal_pore_pressure_drag_viscosity_shaking(press: Any, press_slope: Any, level: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, drag: Any, viscosity: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 7 mul, 4 add, 3 sub."""
    v24 = (k_h * press_slope + omega_2 * polar + (1.0 - k_v - pore_ratio) * press - level * pore_pressure) * mu
    v27 = drag * omega_2 + v24 + omega * viscosity
    return v27


def resistance_centripetal_pore_pressure_drag_viscosity_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, drag: Any, viscosity: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 8 mul, 4 add, 4 sub."""
    v26 = k_h * press_slope + omega_2 * polar + (1.0 - k_v - pore_ratio) * press - excess * level - level * pore_pressure
    v30 = drag * omega_2 + v26 * mu + omega * viscosity
    return v30


def resistance_centripetal_pore_pressure_drag_viscosity_thermal_pressurisation(press: Any, level: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, drag: Any, viscosity: Any, excess: Any) -> Any:
    """Resistance. Operations: 7 mul, 3 add, 3 sub."""
    v22 = drag * omega_2 + (omega_2 * polar + (1.0 - pore_ratio) * press - excess * level - level * pore_pressure) * mu
    v24 = v22 + omega * viscosity
    return v24


def resistance_centripetal_pore_pressure_shaking(press: Any, press_slope: Any, level: Any, polar: Any, mu: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 5 mul, 2 add, 3 sub."""
    v20 = (k_h * press_slope + omega_2 * polar + (1.0 - k_v - pore_ratio) * press - level * pore_pressure) * mu
    return v20


def resistance_centripetal_pore_pressure_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, polar: Any, mu: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 6 mul, 2 add, 4 sub."""
    v22 = k_h * press_slope + omega_2 * polar + (1.0 - k_v - pore_ratio) * press - excess * level - level * pore_pressure
    v23 = v22 * mu
    return v23


def resistance_centripetal_pore_pressure_thermal_pressurisation(press: Any, level: Any, polar: Any, mu: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, excess: Any) -> Any:
    """Resistance. Operations: 5 mul, 1 add, 3 sub."""
    v17 = (omega_2 * polar + (1.0 - pore_ratio) * press - excess * level - level * pore_pressure) * mu
    return v17


def resistance_centripetal_pore_pressure_viscosity(press: Any, level: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, viscosity: Any) -> Any:
    """Resistance. Operations: 5 mul, 2 add, 2 sub."""
    v18 = (omega_2 * polar + (1.0 - pore_ratio) * press - level * pore_pressure) * mu + omega * viscosity
    return v18


def resistance_centripetal_pore_pressure_viscosity_shaking(press: Any, press_slope: Any, level: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, viscosity: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 6 mul, 3 add, 3 sub."""
    v22 = (k_h * press_slope + omega_2 * polar + (1.0 - k_v - pore_ratio) * press - level * pore_pressure) * mu
    v24 = v22 + omega * viscosity
    return v24


def resistance_centripetal_pore_pressure_viscosity_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, viscosity: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 7 mul, 3 add, 4 sub."""
    v24 = k_h * press_slope + omega_2 * polar + (1.0 - k_v - pore_ratio) * press - excess * level - level * pore_pressure
    v27 = v24 * mu + omega * viscosity
    return v27


def resistance_centripetal_pore_pressure_viscosity_thermal_pressurisation(press: Any, level: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, viscosity: Any, excess: Any) -> Any:
    """Resistance. Operations: 6 mul, 2 add, 3 sub."""
    v21 = (omega_2 * polar + (1.0 - pore_ratio) * press - excess * level - level * pore_pressure) * mu + omega * viscosity
    return v21


def resistance_centripetal_shaking(press: Any, press_slope: Any, polar: Any, mu: Any, omega_2: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 4 mul, 2 add, 1 sub."""
    v14 = (k_h * press_slope + omega_2 * polar + (1.0 - k_v) * press) * mu
    return v14


def resistance_centripetal_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, polar: Any, mu: Any, omega_2: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 5 mul, 2 add, 2 sub."""
    v18 = (k_h * press_slope + omega_2 * polar + (1.0 - k_v) * press - excess * level) * mu
    return v18


def resistance_centripetal_thermal_pressurisation(press: Any, level: Any, polar: Any, mu: Any, omega_2: Any, excess: Any) -> Any:
    """Resistance. Operations: 3 mul, 1 add, 1 sub."""
    v10 = (press + omega_2 * polar - excess * level) * mu
    return v10


def resistance_centripetal_viscosity(press: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, viscosity: Any) -> Any:
    """Resistance. Operations: 3 mul, 2 add."""
    v10 = (press + omega_2 * polar) * mu + omega * viscosity
    return v10


def resistance_centripetal_viscosity_shaking(press: Any, press_slope: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, viscosity: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 5 mul, 3 add, 1 sub."""
    v18 = (k_h * press_slope + omega_2 * polar + (1.0 - k_v) * press) * mu + omega * viscosity
    return v18


def resistance_centripetal_viscosity_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, viscosity: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 6 mul, 3 add, 2 sub."""
    v22 = (k_h * press_slope + omega_2 * polar + (1.0 - k_v) * press - excess * level) * mu + omega * viscosity
    return v22


def resistance_centripetal_viscosity_thermal_pressurisation(press: Any, level: Any, polar: Any, mu: Any, omega: Any, omega_2: Any, viscosity: Any, excess: Any) -> Any:
    """Resistance. Operations: 4 mul, 2 add, 1 sub."""
    v14 = (press + omega_2 * polar - excess * level) * mu + omega * viscosity
    return v14


def resistance_cohesion(press: Any, level: Any, mu: Any, cohesion: Any) -> Any:
    """Resistance. Operations: 2 mul, 1 add."""
    v6 = cohesion * level + mu * press
    return v6


def resistance_cohesion_drag(press: Any, level: Any, mu: Any, omega_2: Any, cohesion: Any, drag: Any) -> Any:
    """Resistance. Operations: 3 mul, 2 add."""
    v10 = cohesion * level + drag * omega_2 + mu * press
    return v10


def resistance_cohesion_drag_shaking(press: Any, press_slope: Any, level: Any, mu: Any, omega_2: Any, cohesion: Any, drag: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 5 mul, 3 add, 1 sub."""
    v18 = cohesion * level + drag * omega_2 + (k_h * press_slope + (1.0 - k_v) * press) * mu
    return v18


def resistance_cohesion_drag_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, mu: Any, omega_2: Any, cohesion: Any, drag: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 6 mul, 3 add, 2 sub."""
    v21 = cohesion * level + drag * omega_2 + (k_h * press_slope + (1.0 - k_v) * press - excess * level) * mu
    return v21


def resistance_cohesion_drag_thermal_pressurisation(press: Any, level: Any, mu: Any, omega_2: Any, cohesion: Any, drag: Any, excess: Any) -> Any:
    """Resistance. Operations: 4 mul, 2 add, 1 sub."""
    v13 = cohesion * level + drag * omega_2 + (press - excess * level) * mu
    return v13


def resistance_cohesion_drag_viscosity(press: Any, level: Any, mu: Any, omega: Any, omega_2: Any, cohesion: Any, drag: Any, viscosity: Any) -> Any:
    """Resistance. Operations: 4 mul, 3 add."""
    v14 = cohesion * level + drag * omega_2 + mu * press + omega * viscosity
    return v14


def resistance_cohesion_drag_viscosity_shaking(press: Any, press_slope: Any, level: Any, mu: Any, omega: Any, omega_2: Any, cohesion: Any, drag: Any, viscosity: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 6 mul, 4 add, 1 sub."""
    v22 = cohesion * level + drag * omega_2 + (k_h * press_slope + (1.0 - k_v) * press) * mu + omega * viscosity
    return v22


def resistance_cohesion_drag_viscosity_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, mu: Any, omega: Any, omega_2: Any, cohesion: Any, drag: Any, viscosity: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 7 mul, 4 add, 2 sub."""
    v23 = cohesion * level + drag * omega_2 + (k_h * press_slope + (1.0 - k_v) * press - excess * level) * mu
    v25 = v23 + omega * viscosity
    return v25


def resistance_cohesion_drag_viscosity_thermal_pressurisation(press: Any, level: Any, mu: Any, omega: Any, omega_2: Any, cohesion: Any, drag: Any, viscosity: Any, excess: Any) -> Any:
    """Resistance. Operations: 5 mul, 3 add, 1 sub."""
    v17 = cohesion * level + drag * omega_2 + (press - excess * level) * mu + omega * viscosity
    return v17


def resistance_cohesion_shaking(press: Any, press_slope: Any, level: Any, mu: Any, cohesion: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 4 mul, 2 add, 1 sub."""
    v14 = cohesion * level + (k_h * press_slope + (1.0 - k_v) * press) * mu
    return v14


def resistance_cohesion_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, mu: Any, cohesion: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 5 mul, 2 add, 2 sub."""
    v17 = cohesion * level + (k_h * press_slope + (1.0 - k_v) * press - excess * level) * mu
    return v17


def resistance_cohesion_thermal_pressurisation(press: Any, level: Any, mu: Any, cohesion: Any, excess: Any) -> Any:
    """Resistance. Operations: 3 mul, 1 add, 1 sub."""
    v9 = cohesion * level + (press - excess * level) * mu
    return v9


def resistance_cohesion_viscosity(press: Any, level: Any, mu: Any, omega: Any, cohesion: Any, viscosity: Any) -> Any:
    """Resistance. Operations: 3 mul, 2 add."""
    v10 = cohesion * level + mu * press + omega * viscosity
    return v10


def resistance_cohesion_viscosity_shaking(press: Any, press_slope: Any, level: Any, mu: Any, omega: Any, cohesion: Any, viscosity: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 5 mul, 3 add, 1 sub."""
    v18 = cohesion * level + (k_h * press_slope + (1.0 - k_v) * press) * mu + omega * viscosity
    return v18


def resistance_cohesion_viscosity_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, mu: Any, omega: Any, cohesion: Any, viscosity: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 6 mul, 3 add, 2 sub."""
    v21 = cohesion * level + (k_h * press_slope + (1.0 - k_v) * press - excess * level) * mu + omega * viscosity
    return v21


def resistance_cohesion_viscosity_thermal_pressurisation(press: Any, level: Any, mu: Any, omega: Any, cohesion: Any, viscosity: Any, excess: Any) -> Any:
    """Resistance. Operations: 4 mul, 2 add, 1 sub."""
    v13 = cohesion * level + (press - excess * level) * mu + omega * viscosity
    return v13


def resistance_drag(press: Any, mu: Any, omega_2: Any, drag: Any) -> Any:
    """Resistance. Operations: 2 mul, 1 add."""
    v6 = drag * omega_2 + mu * press
    return v6


def resistance_drag_shaking(press: Any, press_slope: Any, mu: Any, omega_2: Any, drag: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 4 mul, 2 add, 1 sub."""
    v14 = drag * omega_2 + (k_h * press_slope + (1.0 - k_v) * press) * mu
    return v14


def resistance_drag_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, mu: Any, omega_2: Any, drag: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 5 mul, 2 add, 2 sub."""
    v18 = drag * omega_2 + (k_h * press_slope + (1.0 - k_v) * press - excess * level) * mu
    return v18


def resistance_drag_thermal_pressurisation(press: Any, level: Any, mu: Any, omega_2: Any, drag: Any, excess: Any) -> Any:
    """Resistance. Operations: 3 mul, 1 add, 1 sub."""
    v10 = drag * omega_2 + (press - excess * level) * mu
    return v10


def resistance_drag_viscosity(press: Any, mu: Any, omega: Any, omega_2: Any, drag: Any, viscosity: Any) -> Any:
    """Resistance. Operations: 3 mul, 2 add."""
    v10 = drag * omega_2 + mu * press + omega * viscosity
    return v10


def resistance_drag_viscosity_shaking(press: Any, press_slope: Any, mu: Any, omega: Any, omega_2: Any, drag: Any, viscosity: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 5 mul, 3 add, 1 sub."""
    v18 = drag * omega_2 + (k_h * press_slope + (1.0 - k_v) * press) * mu + omega * viscosity
    return v18


def resistance_drag_viscosity_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, mu: Any, omega: Any, omega_2: Any, drag: Any, viscosity: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 6 mul, 3 add, 2 sub."""
    v22 = drag * omega_2 + (k_h * press_slope + (1.0 - k_v) * press - excess * level) * mu + omega * viscosity
    return v22


def resistance_drag_viscosity_thermal_pressurisation(press: Any, level: Any, mu: Any, omega: Any, omega_2: Any, drag: Any, viscosity: Any, excess: Any) -> Any:
    """Resistance. Operations: 4 mul, 2 add, 1 sub."""
    v14 = drag * omega_2 + (press - excess * level) * mu + omega * viscosity
    return v14


def resistance_pore_pressure(press: Any, level: Any, mu: Any, pore_ratio: Any, pore_pressure: Any) -> Any:
    """Resistance. Operations: 3 mul, 2 sub."""
    v10 = ((1.0 - pore_ratio) * press - level * pore_pressure) * mu
    return v10


def resistance_pore_pressure_cohesion(press: Any, level: Any, mu: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any) -> Any:
    """Resistance. Operations: 4 mul, 1 add, 2 sub."""
    v13 = cohesion * level + ((1.0 - pore_ratio) * press - level * pore_pressure) * mu
    return v13


def resistance_pore_pressure_cohesion_drag(press: Any, level: Any, mu: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, drag: Any) -> Any:
    """Resistance. Operations: 5 mul, 2 add, 2 sub."""
    v17 = cohesion * level + drag * omega_2 + ((1.0 - pore_ratio) * press - level * pore_pressure) * mu
    return v17


def resistance_pore_pressure_cohesion_drag_shaking(press: Any, press_slope: Any, level: Any, mu: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, drag: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 6 mul, 3 add, 3 sub."""
    v23 = cohesion * level + drag * omega_2 + (k_h * press_slope + (1.0 - k_v - pore_ratio) * press - level * pore_pressure) * mu
    return v23


def resistance_pore_pressure_cohesion_drag_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, mu: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, drag: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 7 mul, 3 add, 4 sub."""
    v25 = (k_h * press_slope + (1.0 - k_v - pore_ratio) * press - excess * level - level * pore_pressure) * mu
    v26 = cohesion * level + drag * omega_2 + v25
    return v26


def resistance_pore_pressure_cohesion_drag_thermal_pressurisation(press: Any, level: Any, mu: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, drag: Any, excess: Any) -> Any:
    """Resistance. Operations: 6 mul, 2 add, 3 sub."""
    v20 = cohesion * level + drag * omega_2 + ((1.0 - pore_ratio) * press - excess * level - level * pore_pressure) * mu
    return v20


def resistance_pore_pressure_cohesion_drag_viscosity(press: Any, level: Any, mu: Any, omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, drag: Any, viscosity: Any) -> Any:
    """Resistance. Operations: 6 mul, 3 add, 2 sub."""
    v21 = cohesion * level + drag * omega_2 + ((1.0 - pore_ratio) * press - level * pore_pressure) * mu + omega * viscosity
    return v21


def resistance_pore_pressure_cohesion_drag_viscosity_shaking(press: Any, press_slope: Any, level: Any, mu: Any, omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, drag: Any, viscosity: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 7 mul, 4 add, 3 sub."""
    v25 = cohesion * level + drag * omega_2 + (k_h * press_slope + (1.0 - k_v - pore_ratio) * press - level * pore_pressure) * mu
    v27 = v25 + omega * viscosity
    return v27


def resistance_pore_pressure_cohesion_drag_viscosity_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, mu: Any, omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, drag: Any, viscosity: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 8 mul, 4 add, 4 sub."""
    v27 = (k_h * press_slope + (1.0 - k_v - pore_ratio) * press - excess * level - level * pore_pressure) * mu
    v30 = cohesion * level + drag * omega_2 + v27 + omega * viscosity
    return v30


def resistance_pore_pressure_cohesion_drag_viscosity_thermal_pressurisation(press: Any, level: Any, mu: Any, omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, drag: Any, viscosity: Any, excess: Any) -> Any:
    """Resistance. Operations: 7 mul, 3 add, 3 sub."""
    v22 = cohesion * level + drag * omega_2 + ((1.0 - pore_ratio) * press - excess * level - level * pore_pressure) * mu
    v24 = v22 + omega * viscosity
    return v24


def resistance_pore_pressure_cohesion_shaking(press: Any, press_slope: Any, level: Any, mu: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 5 mul, 2 add, 3 sub."""
    v19 = cohesion * level + (k_h * press_slope + (1.0 - k_v - pore_ratio) * press - level * pore_pressure) * mu
    return v19


def resistance_pore_pressure_cohesion_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, mu: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 6 mul, 2 add, 4 sub."""
    v21 = (k_h * press_slope + (1.0 - k_v - pore_ratio) * press - excess * level - level * pore_pressure) * mu
    v22 = cohesion * level + v21
    return v22


def resistance_pore_pressure_cohesion_thermal_pressurisation(press: Any, level: Any, mu: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, excess: Any) -> Any:
    """Resistance. Operations: 5 mul, 1 add, 3 sub."""
    v16 = cohesion * level + ((1.0 - pore_ratio) * press - excess * level - level * pore_pressure) * mu
    return v16


def resistance_pore_pressure_cohesion_viscosity(press: Any, level: Any, mu: Any, omega: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, viscosity: Any) -> Any:
    """Resistance. Operations: 5 mul, 2 add, 2 sub."""
    v17 = cohesion * level + ((1.0 - pore_ratio) * press - level * pore_pressure) * mu + omega * viscosity
    return v17


def resistance_pore_pressure_cohesion_viscosity_shaking(press: Any, press_slope: Any, level: Any, mu: Any, omega: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, viscosity: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 6 mul, 3 add, 3 sub."""
    v21 = cohesion * level + (k_h * press_slope + (1.0 - k_v - pore_ratio) * press - level * pore_pressure) * mu
    v23 = v21 + omega * viscosity
    return v23


def resistance_pore_pressure_cohesion_viscosity_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, mu: Any, omega: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, viscosity: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 7 mul, 3 add, 4 sub."""
    v23 = (k_h * press_slope + (1.0 - k_v - pore_ratio) * press - excess * level - level * pore_pressure) * mu
    v26 = cohesion * level + v23 + omega * viscosity
    return v26


def resistance_pore_pressure_cohesion_viscosity_thermal_pressurisation(press: Any, level: Any, mu: Any, omega: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any, viscosity: Any, excess: Any) -> Any:
    """Resistance. Operations: 6 mul, 2 add, 3 sub."""
    v20 = cohesion * level + ((1.0 - pore_ratio) * press - excess * level - level * pore_pressure) * mu + omega * viscosity
    return v20


def resistance_pore_pressure_drag(press: Any, level: Any, mu: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, drag: Any) -> Any:
    """Resistance. Operations: 4 mul, 1 add, 2 sub."""
    v14 = drag * omega_2 + ((1.0 - pore_ratio) * press - level * pore_pressure) * mu
    return v14


def resistance_pore_pressure_drag_shaking(press: Any, press_slope: Any, level: Any, mu: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, drag: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 5 mul, 2 add, 3 sub."""
    v20 = drag * omega_2 + (k_h * press_slope + (1.0 - k_v - pore_ratio) * press - level * pore_pressure) * mu
    return v20


def resistance_pore_pressure_drag_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, mu: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, drag: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 6 mul, 2 add, 4 sub."""
    v22 = (k_h * press_slope + (1.0 - k_v - pore_ratio) * press - excess * level - level * pore_pressure) * mu
    v23 = drag * omega_2 + v22
    return v23


def resistance_pore_pressure_drag_thermal_pressurisation(press: Any, level: Any, mu: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, drag: Any, excess: Any) -> Any:
    """Resistance. Operations: 5 mul, 1 add, 3 sub."""
    v17 = drag * omega_2 + ((1.0 - pore_ratio) * press - excess * level - level * pore_pressure) * mu
    return v17


def resistance_pore_pressure_drag_viscosity(press: Any, level: Any, mu: Any, omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, drag: Any, viscosity: Any) -> Any:
    """Resistance. Operations: 5 mul, 2 add, 2 sub."""
    v18 = drag * omega_2 + ((1.0 - pore_ratio) * press - level * pore_pressure) * mu + omega * viscosity
    return v18


def resistance_pore_pressure_drag_viscosity_shaking(press: Any, press_slope: Any, level: Any, mu: Any, omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, drag: Any, viscosity: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 6 mul, 3 add, 3 sub."""
    v22 = drag * omega_2 + (k_h * press_slope + (1.0 - k_v - pore_ratio) * press - level * pore_pressure) * mu
    v24 = v22 + omega * viscosity
    return v24


def resistance_pore_pressure_drag_viscosity_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, mu: Any, omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, drag: Any, viscosity: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 7 mul, 3 add, 4 sub."""
    v24 = (k_h * press_slope + (1.0 - k_v - pore_ratio) * press - excess * level - level * pore_pressure) * mu
    v27 = drag * omega_2 + v24 + omega * viscosity
    return v27


def resistance_pore_pressure_drag_viscosity_thermal_pressurisation(press: Any, level: Any, mu: Any, omega: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, drag: Any, viscosity: Any, excess: Any) -> Any:
    """Resistance. Operations: 6 mul, 2 add, 3 sub."""
    v21 = drag * omega_2 + ((1.0 - pore_ratio) * press - excess * level - level * pore_pressure) * mu + omega * viscosity
    return v21


def resistance_pore_pressure_shaking(press: Any, press_slope: Any, level: Any, mu: Any, pore_ratio: Any, pore_pressure: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 4 mul, 1 add, 3 sub."""
    v16 = (k_h * press_slope + (1.0 - k_v - pore_ratio) * press - level * pore_pressure) * mu
    return v16


def resistance_pore_pressure_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, mu: Any, pore_ratio: Any, pore_pressure: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 5 mul, 1 add, 4 sub."""
    v19 = (k_h * press_slope + (1.0 - k_v - pore_ratio) * press - excess * level - level * pore_pressure) * mu
    return v19


def resistance_pore_pressure_thermal_pressurisation(press: Any, level: Any, mu: Any, pore_ratio: Any, pore_pressure: Any, excess: Any) -> Any:
    """Resistance. Operations: 4 mul, 3 sub."""
    v13 = ((1.0 - pore_ratio) * press - excess * level - level * pore_pressure) * mu
    return v13


def resistance_pore_pressure_viscosity(press: Any, level: Any, mu: Any, omega: Any, pore_ratio: Any, pore_pressure: Any, viscosity: Any) -> Any:
    """Resistance. Operations: 4 mul, 1 add, 2 sub."""
    v14 = ((1.0 - pore_ratio) * press - level * pore_pressure) * mu + omega * viscosity
    return v14


def resistance_pore_pressure_viscosity_shaking(press: Any, press_slope: Any, level: Any, mu: Any, omega: Any, pore_ratio: Any, pore_pressure: Any, viscosity: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 5 mul, 2 add, 3 sub."""
    v20 = (k_h * press_slope + (1.0 - k_v - pore_ratio) * press - level * pore_pressure) * mu + omega * viscosity
    return v20


def resistance_pore_pressure_viscosity_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, mu: Any, omega: Any, pore_ratio: Any, pore_pressure: Any, viscosity: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 6 mul, 2 add, 4 sub."""
    v21 = (k_h * press_slope + (1.0 - k_v - pore_ratio) * press - excess * level - level * pore_pressure) * mu
    v23 = v21 + omega * viscosity
    return v23


def resistance_pore_pressure_viscosity_thermal_pressurisation(press: Any, level: Any, mu: Any, omega: Any, pore_ratio: Any, pore_pressure: Any, viscosity: Any, excess: Any) -> Any:
    """Resistance. Operations: 5 mul, 1 add, 3 sub."""
    v17 = ((1.0 - pore_ratio) * press - excess * level - level * pore_pressure) * mu + omega * viscosity
    return v17


def resistance_shaking(press: Any, press_slope: Any, mu: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 3 mul, 1 add, 1 sub."""
    v10 = (k_h * press_slope + (1.0 - k_v) * press) * mu
    return v10


def resistance_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, mu: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 4 mul, 1 add, 2 sub."""
    v14 = (k_h * press_slope + (1.0 - k_v) * press - excess * level) * mu
    return v14


def resistance_thermal_pressurisation(press: Any, level: Any, mu: Any, excess: Any) -> Any:
    """Resistance. Operations: 2 mul, 1 sub."""
    v6 = (press - excess * level) * mu
    return v6


def resistance_viscosity(press: Any, mu: Any, omega: Any, viscosity: Any) -> Any:
    """Resistance. Operations: 2 mul, 1 add."""
    v6 = mu * press + omega * viscosity
    return v6


def resistance_viscosity_shaking(press: Any, press_slope: Any, mu: Any, omega: Any, viscosity: Any, k_h: Any, k_v: Any) -> Any:
    """Resistance. Operations: 4 mul, 2 add, 1 sub."""
    v14 = (k_h * press_slope + (1.0 - k_v) * press) * mu + omega * viscosity
    return v14


def resistance_viscosity_shaking_thermal_pressurisation(press: Any, press_slope: Any, level: Any, mu: Any, omega: Any, viscosity: Any, k_h: Any, k_v: Any, excess: Any) -> Any:
    """Resistance. Operations: 5 mul, 2 add, 2 sub."""
    v18 = (k_h * press_slope + (1.0 - k_v) * press - excess * level) * mu + omega * viscosity
    return v18


def resistance_viscosity_thermal_pressurisation(press: Any, level: Any, mu: Any, omega: Any, viscosity: Any, excess: Any) -> Any:
    """Resistance. Operations: 3 mul, 1 add, 1 sub."""
    v10 = (press - excess * level) * mu + omega * viscosity
    return v10


def tilt(fall_slope: Any, press_slope: Any, mu: Any) -> Any:
    """Tilt. Operations: 1 mul, 1 sub."""
    v4 = fall_slope - mu * press_slope
    return v4


def tilt_pore_pressure(fall_slope: Any, press_slope: Any, mu: Any, pore_ratio: Any) -> Any:
    """Tilt. Operations: 2 mul, 1 add, 1 sub."""
    v8 = fall_slope + (pore_ratio - 1.0) * mu * press_slope
    return v8


def tilt_pore_pressure_shaking(fall: Any, press: Any, fall_slope: Any, press_slope: Any, mu: Any, pore_ratio: Any, k_h: Any, k_v: Any) -> Any:
    """Tilt. Operations: 6 mul, 3 add, 3 sub."""
    v20 = (1.0 - k_v) * fall_slope + k_h * mu * press + (k_v + pore_ratio - 1.0) * mu * press_slope - fall * k_h
    return v20


def tilt_shaking(fall: Any, press: Any, fall_slope: Any, press_slope: Any, mu: Any, k_h: Any, k_v: Any) -> Any:
    """Tilt. Operations: 6 mul, 2 add, 3 sub."""
    v18 = (1.0 - k_v) * fall_slope + k_h * mu * press + (k_v - 1.0) * mu * press_slope - fall * k_h
    return v18
