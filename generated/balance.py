# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: a9104da7e889decf95ceafe3744d4ea2377b7bd0ed771bc593332f3c48d98967
"""The balance of momentum and the energy in the phase plane, specialised to the effects that are present."""

from typing import Any

import numpy as np

__all__ = [
    "brake_centripetal",
    "brake_centripetal_drag",
    "brake_drag",
    "constant_cohesion",
    "constant_pore_pressure",
    "constant_pore_pressure_cohesion",
    "drive",
    "drive_pore_pressure",
    "drop_exponential",
    "drop_hyperbolic",
    "drop_linear",
    "effective_stress",
    "effective_stress_centripetal",
    "effective_stress_centripetal_pore_pressure",
    "effective_stress_pore_pressure",
    "energy",
    "energy_braked",
    "energy_braked_constant",
    "energy_constant",
    "energy_softening",
    "energy_softening_constant",
    "energy_softening_constant_water",
    "friction_exponential",
    "friction_hyperbolic",
    "friction_linear",
    "limit_friction",
    "limit_friction_cohesion",
    "limit_friction_pore_pressure",
    "limit_friction_pore_pressure_cohesion",
    "normal",
    "normal_pore_pressure",
    "normal_stress",
    "normal_stress_centripetal",
    "resistance",
    "resistance_centripetal",
    "resistance_centripetal_cohesion",
    "resistance_centripetal_cohesion_drag",
    "resistance_centripetal_drag",
    "resistance_centripetal_pore_pressure",
    "resistance_centripetal_pore_pressure_cohesion",
    "resistance_centripetal_pore_pressure_cohesion_drag",
    "resistance_centripetal_pore_pressure_drag",
    "resistance_cohesion",
    "resistance_cohesion_drag",
    "resistance_drag",
    "resistance_pore_pressure",
    "resistance_pore_pressure_cohesion",
    "resistance_pore_pressure_cohesion_drag",
    "resistance_pore_pressure_drag",
    "tilt",
    "tilt_pore_pressure",
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


def constant_pore_pressure(level: Any, mu: Any, pore_pressure: Any) -> Any:
    """Constant. Operations: 2 mul, 1 neg."""
    v5 = -(level * mu * pore_pressure)
    return v5


def constant_pore_pressure_cohesion(level: Any, mu: Any, pore_pressure: Any, cohesion: Any) -> Any:
    """Constant. Operations: 2 mul, 1 sub."""
    v6 = (cohesion - mu * pore_pressure) * level
    return v6


def drive(press: Any, mu: Any, limit_friction: Any) -> Any:
    """Drive. Operations: 1 mul, 1 sub."""
    v4 = (limit_friction - mu) * press
    return v4


def drive_pore_pressure(press: Any, level: Any, mu: Any, pore_ratio: Any, pore_pressure: Any, limit_friction: Any) -> Any:
    """Drive. Operations: 3 mul, 3 sub."""
    v12 = (limit_friction - mu) * ((1.0 - pore_ratio) * press - level * pore_pressure)
    return v12


def drop_exponential(slip: Any, more: Any, peak: Any, residual: Any, length: Any) -> Any:
    """Its fall over `more` slip, from `slip`. Operations: 2 mul, 1 sub, 2 div, 3 neg, 1 exp, 1 expm1."""
    v14 = -((peak - residual) * np.exp(-(slip / length)) * np.expm1(-(more / length)))
    return v14


def drop_hyperbolic(slip: Any, more: Any, peak: Any, residual: Any, length: Any) -> Any:
    """Its fall over `more` slip, from `slip`. Operations: 3 mul, 3 add, 1 sub, 3 div."""
    v15 = (peak - residual) / (length * (1.0 + slip / length) * (1.0 + (more + slip) / length)) * more
    return v15


def drop_linear(slip: Any, more: Any, peak: Any, residual: Any, length: Any) -> Any:
    """Its fall over `more` slip, from `slip`. Operations: 1 mul, 1 add, 2 sub, 2 div, 2 min."""
    v13 = (peak - residual) * (np.minimum(1.0, (more + slip) / length) - np.minimum(1.0, slip / length))
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


def effective_stress_pore_pressure(press: Any, level: Any, pore_ratio: Any, pore_pressure: Any) -> Any:
    """Effective_stress. Operations: 2 mul, 2 sub, 1 div."""
    v9 = ((1.0 - pore_ratio) * press - level * pore_pressure) / level
    return v9


def energy(x: Any, start: Any, drive: Any, tilt: Any) -> Any:
    """Constant friction, nothing that grows with the speed. Operations: 6 mul, 1 add, 1 sub, 2 sin."""
    v12 = np.sin(0.5 * x)
    v16 = start + 2.0 * np.sin(x) * drive - 4.0 * (v12 * v12) * tilt
    return v16


def energy_braked(x: Any, start: Any, drive: Any, tilt: Any, brake: Any) -> Any:
    """Constant friction, centripetal stress or drag. Operations: 57 mul, 34 add, 3 sub, 3 div, 4 neg, 1 min, 2 max, 1 less, 1 select, 1 exp, 2 expm1, 2 sin."""
    v7 = 2.0 * brake * x
    v12 = np.maximum(1e-300, v7)
    v22 = np.sin(0.5 * x)
    v24 = 2.0 * (v22 * v22)
    v33 = np.minimum(1.0, v7)
    v43 = ((-8.22063524662433e-18 * v33 + 1.5619206968586225e-16) * v33 + -2.8114572543455206e-15) * v33 + 4.779477332387385e-14
    v52 = ((v43 * v33 + -7.647163731819816e-13) * v33 + 1.1470745597729725e-11) * v33 + -1.6059043836821613e-10
    v61 = ((v52 * v33 + 2.08767569878681e-09) * v33 + -2.505210838544172e-08) * v33 + 2.755731922398589e-07
    v70 = ((v61 * v33 + -2.7557319223985893e-06) * v33 + 2.48015873015873e-05) * v33 + -0.0001984126984126984
    v80 = (((v70 * v33 + 0.001388888888888889) * v33 + -0.008333333333333333) * v33 + 0.041666666666666664) * v33
    v85 = np.maximum(1.0, v7)
    v92 = np.where(v7 < 1.0, (v80 + -0.16666666666666666) * v33 + 0.5, (np.expm1(-v85) + v85) / (v85 * v85))
    v99 = x * x
    v109 = ((9.183689863795546e-29 * v99 + -6.446950284384474e-26) * v99 + 3.868170170630684e-23) * v99 + -1.9572941063391263e-20
    v117 = ((v109 * v99 + 8.22063524662433e-18) * v99 + -2.8114572543455206e-15) * v99 + 7.647163731819816e-13
    v124 = ((v117 * v99 + -1.6059043836821613e-10) * v99 + 2.505210838544172e-08) * v99 + -2.7557319223985893e-06
    v132 = ((v124 * v99 + 0.0001984126984126984) * v99 + -0.008333333333333333) * v99 + 0.16666666666666666
    v140 = (2.0 * (2.0 * (-(np.expm1(-v12) / v12)) * brake * x - v24) * brake + np.sin(x)) * drive - (4.0 * v92 * brake * brake * x * x + v24 - 2.0 * v132 * brake * x * x * x) * tilt
    v146 = np.exp(-v7) * start + 2.0 * v140 / (1.0 + 4.0 * brake * brake)
    return v146


def energy_braked_constant(x: Any, start: Any, drive: Any, tilt: Any, constant: Any, brake: Any) -> Any:
    """Constant friction, centripetal stress or drag. Operations: 67 mul, 35 add, 5 sub, 3 div, 4 neg, 1 min, 2 max, 1 less, 1 select, 1 exp, 2 expm1, 2 sin."""
    v8 = 2.0 * brake * x
    v13 = np.minimum(1.0, v8)
    v23 = ((-8.22063524662433e-18 * v13 + 1.5619206968586225e-16) * v13 + -2.8114572543455206e-15) * v13 + 4.779477332387385e-14
    v32 = ((v23 * v13 + -7.647163731819816e-13) * v13 + 1.1470745597729725e-11) * v13 + -1.6059043836821613e-10
    v41 = ((v32 * v13 + 2.08767569878681e-09) * v13 + -2.505210838544172e-08) * v13 + 2.755731922398589e-07
    v50 = ((v41 * v13 + -2.7557319223985893e-06) * v13 + 2.48015873015873e-05) * v13 + -0.0001984126984126984
    v60 = (((v50 * v13 + 0.001388888888888889) * v13 + -0.008333333333333333) * v13 + 0.041666666666666664) * v13
    v66 = np.maximum(1.0, v8)
    v73 = np.where(v8 < 1.0, (v60 + -0.16666666666666666) * v13 + 0.5, (np.expm1(-v66) + v66) / (v66 * v66))
    v80 = np.sin(0.5 * x)
    v81 = v80 * v80
    v85 = x * x
    v95 = ((9.183689863795546e-29 * v85 + -6.446950284384474e-26) * v85 + 3.868170170630684e-23) * v85 + -1.9572941063391263e-20
    v103 = ((v95 * v85 + 8.22063524662433e-18) * v85 + -2.8114572543455206e-15) * v85 + 7.647163731819816e-13
    v110 = ((v103 * v85 + -1.6059043836821613e-10) * v85 + 2.505210838544172e-08) * v85 + -2.7557319223985893e-06
    v118 = ((v110 * v85 + 0.0001984126984126984) * v85 + -0.008333333333333333) * v85 + 0.16666666666666666
    v125 = np.maximum(1e-300, v8)
    v133 = 2.0 * v81
    v140 = (2.0 * v73 * brake * x * x - 4.0 * v81 * brake - v118 * x * x * x) * constant + (2.0 * (2.0 * (-(np.expm1(-v125) / v125)) * brake * x - v133) * brake + np.sin(x)) * drive
    v155 = 2.0 * (v140 - (4.0 * v73 * brake * brake * x * x + v133 - 2.0 * v118 * brake * x * x * x) * tilt)
    v160 = np.exp(-v8) * start + v155 / (1.0 + 4.0 * brake * brake)
    return v160


def energy_constant(x: Any, start: Any, drive: Any, tilt: Any, constant: Any) -> Any:
    """Constant friction, nothing that grows with the speed. Operations: 24 mul, 13 add, 2 sub, 2 sin."""
    v13 = np.sin(0.5 * x)
    v18 = x * x
    v28 = ((9.183689863795546e-29 * v18 + -6.446950284384474e-26) * v18 + 3.868170170630684e-23) * v18 + -1.9572941063391263e-20
    v37 = ((v28 * v18 + 8.22063524662433e-18) * v18 + -2.8114572543455206e-15) * v18 + 7.647163731819816e-13
    v46 = ((v37 * v18 + -1.6059043836821613e-10) * v18 + 2.505210838544172e-08) * v18 + -2.7557319223985893e-06
    v56 = 2.0 * (((v46 * v18 + 0.0001984126984126984) * v18 + -0.008333333333333333) * v18 + 0.16666666666666666)
    v61 = start + 2.0 * np.sin(x) * drive - 4.0 * (v13 * v13) * tilt - v56 * constant * x * x * x
    return v61


def energy_softening(x: Any, start: Any, drive: Any, tilt: Any, drop: Any, decay: Any, press: Any, press_rise: Any) -> Any:
    """Exponential softening, no brake. Operations: 73 mul, 37 add, 5 sub, 4 div, 4 neg, 1 min, 2 max, 1 less, 1 select, 1 exp, 2 expm1, 2 sin."""
    v9 = np.sin(x)
    v13 = decay * x
    v15 = np.minimum(1.0, v13)
    v25 = ((-8.22063524662433e-18 * v15 + 1.5619206968586225e-16) * v15 + -2.8114572543455206e-15) * v15 + 4.779477332387385e-14
    v34 = ((v25 * v15 + -7.647163731819816e-13) * v15 + 1.1470745597729725e-11) * v15 + -1.6059043836821613e-10
    v43 = ((v34 * v15 + 2.08767569878681e-09) * v15 + -2.505210838544172e-08) * v15 + 2.755731922398589e-07
    v52 = ((v43 * v15 + -2.7557319223985893e-06) * v15 + 2.48015873015873e-05) * v15 + -0.0001984126984126984
    v62 = (((v52 * v15 + 0.001388888888888889) * v15 + -0.008333333333333333) * v15 + 0.041666666666666664) * v15
    v68 = np.maximum(1.0, v13)
    v75 = np.where(v13 < 1.0, (v62 + -0.16666666666666666) * v15 + 0.5, (np.expm1(-v68) + v68) / (v68 * v68))
    v77 = v75 * decay * decay
    v82 = np.maximum(1e-300, v13)
    v86 = -(np.expm1(-v82) / v82)
    v92 = np.exp(-v13)
    v94 = np.sin(0.5 * x)
    v95 = v94 * v94
    v100 = x * x
    v110 = ((9.183689863795546e-29 * v100 + -6.446950284384474e-26) * v100 + 3.868170170630684e-23) * v100 + -1.9572941063391263e-20
    v118 = ((v110 * v100 + 8.22063524662433e-18) * v100 + -2.8114572543455206e-15) * v100 + 7.647163731819816e-13
    v125 = ((v118 * v100 + -1.6059043836821613e-10) * v100 + 2.505210838544172e-08) * v100 + -2.7557319223985893e-06
    v133 = ((v125 * v100 + 0.0001984126984126984) * v100 + -0.008333333333333333) * v100 + 0.16666666666666666
    v139 = v77 * decay * x * x + v9 * v86 * decay * x - 2.0 * v92 * v95 * decay - v133 * decay * decay * x * x * x
    v140 = decay * decay
    v141 = 1.0 + v140
    v144 = v86 * decay
    v161 = 2.0 * (v140 + v144 * x) * v95 + v77 * x * x - v144 * decay * x * x - v92 * v133 * decay * x * x * x
    v171 = start + 2.0 * v9 * drive + 2.0 * (v139 / v141 * press + v161 / v141 * press_rise) * drop - 4.0 * v95 * tilt
    return v171


def energy_softening_constant(x: Any, start: Any, drive: Any, tilt: Any, constant: Any, drop: Any, decay: Any, press: Any, press_rise: Any) -> Any:
    """Exponential softening, no brake. Operations: 78 mul, 37 add, 6 sub, 4 div, 4 neg, 1 min, 2 max, 1 less, 1 select, 1 exp, 2 expm1, 2 sin."""
    v10 = np.sin(x)
    v14 = decay * x
    v16 = np.minimum(1.0, v14)
    v26 = ((-8.22063524662433e-18 * v16 + 1.5619206968586225e-16) * v16 + -2.8114572543455206e-15) * v16 + 4.779477332387385e-14
    v35 = ((v26 * v16 + -7.647163731819816e-13) * v16 + 1.1470745597729725e-11) * v16 + -1.6059043836821613e-10
    v44 = ((v35 * v16 + 2.08767569878681e-09) * v16 + -2.505210838544172e-08) * v16 + 2.755731922398589e-07
    v53 = ((v44 * v16 + -2.7557319223985893e-06) * v16 + 2.48015873015873e-05) * v16 + -0.0001984126984126984
    v63 = (((v53 * v16 + 0.001388888888888889) * v16 + -0.008333333333333333) * v16 + 0.041666666666666664) * v16
    v69 = np.maximum(1.0, v14)
    v76 = np.where(v14 < 1.0, (v63 + -0.16666666666666666) * v16 + 0.5, (np.expm1(-v69) + v69) / (v69 * v69))
    v78 = v76 * decay * decay
    v83 = np.maximum(1e-300, v14)
    v87 = -(np.expm1(-v83) / v83)
    v93 = np.exp(-v14)
    v95 = np.sin(0.5 * x)
    v96 = v95 * v95
    v101 = x * x
    v111 = ((9.183689863795546e-29 * v101 + -6.446950284384474e-26) * v101 + 3.868170170630684e-23) * v101 + -1.9572941063391263e-20
    v119 = ((v111 * v101 + 8.22063524662433e-18) * v101 + -2.8114572543455206e-15) * v101 + 7.647163731819816e-13
    v126 = ((v119 * v101 + -1.6059043836821613e-10) * v101 + 2.505210838544172e-08) * v101 + -2.7557319223985893e-06
    v134 = ((v126 * v101 + 0.0001984126984126984) * v101 + -0.008333333333333333) * v101 + 0.16666666666666666
    v140 = v78 * decay * x * x + v10 * v87 * decay * x - 2.0 * v93 * v96 * decay - v134 * decay * decay * x * x * x
    v141 = decay * decay
    v142 = 1.0 + v141
    v145 = v87 * decay
    v162 = 2.0 * (v141 + v145 * x) * v96 + v78 * x * x - v145 * decay * x * x - v93 * v134 * decay * x * x * x
    v172 = start + 2.0 * v10 * drive + 2.0 * (v140 / v142 * press + v162 / v142 * press_rise) * drop - 4.0 * v96 * tilt
    v178 = v172 - 2.0 * v134 * constant * x * x * x
    return v178


def energy_softening_constant_water(x: Any, start: Any, drive: Any, tilt: Any, constant: Any, drop: Any, decay: Any, press: Any, press_rise: Any, water: Any) -> Any:
    """Exponential softening, no brake. Operations: 81 mul, 37 add, 7 sub, 4 div, 4 neg, 1 min, 2 max, 1 less, 1 select, 1 exp, 2 expm1, 2 sin."""
    v11 = np.sin(x)
    v15 = decay * x
    v17 = np.minimum(1.0, v15)
    v27 = ((-8.22063524662433e-18 * v17 + 1.5619206968586225e-16) * v17 + -2.8114572543455206e-15) * v17 + 4.779477332387385e-14
    v36 = ((v27 * v17 + -7.647163731819816e-13) * v17 + 1.1470745597729725e-11) * v17 + -1.6059043836821613e-10
    v45 = ((v36 * v17 + 2.08767569878681e-09) * v17 + -2.505210838544172e-08) * v17 + 2.755731922398589e-07
    v54 = ((v45 * v17 + -2.7557319223985893e-06) * v17 + 2.48015873015873e-05) * v17 + -0.0001984126984126984
    v64 = (((v54 * v17 + 0.001388888888888889) * v17 + -0.008333333333333333) * v17 + 0.041666666666666664) * v17
    v70 = np.maximum(1.0, v15)
    v77 = np.where(v15 < 1.0, (v64 + -0.16666666666666666) * v17 + 0.5, (np.expm1(-v70) + v70) / (v70 * v70))
    v78 = v77 * decay
    v79 = v78 * decay
    v84 = np.maximum(1e-300, v15)
    v88 = -(np.expm1(-v84) / v84)
    v94 = np.exp(-v15)
    v96 = np.sin(0.5 * x)
    v97 = v96 * v96
    v102 = x * x
    v112 = ((9.183689863795546e-29 * v102 + -6.446950284384474e-26) * v102 + 3.868170170630684e-23) * v102 + -1.9572941063391263e-20
    v120 = ((v112 * v102 + 8.22063524662433e-18) * v102 + -2.8114572543455206e-15) * v102 + 7.647163731819816e-13
    v127 = ((v120 * v102 + -1.6059043836821613e-10) * v102 + 2.505210838544172e-08) * v102 + -2.7557319223985893e-06
    v135 = ((v127 * v102 + 0.0001984126984126984) * v102 + -0.008333333333333333) * v102 + 0.16666666666666666
    v141 = v79 * decay * x * x + v11 * v88 * decay * x - 2.0 * v94 * v97 * decay - v135 * decay * decay * x * x * x
    v142 = decay * decay
    v143 = 1.0 + v142
    v146 = v88 * decay
    v163 = 2.0 * (v142 + v146 * x) * v97 + v79 * x * x - v146 * decay * x * x - v94 * v135 * decay * x * x * x
    v173 = start + 2.0 * v11 * drive + 2.0 * (v141 / v143 * press + v163 / v143 * press_rise - v78 * water * x * x) * drop
    v183 = v173 - 4.0 * v97 * tilt - 2.0 * v135 * constant * x * x * x
    return v183


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


def limit_friction(static_limit: Any) -> Any:
    """Limit_friction. Operations: none."""
    return static_limit


def limit_friction_cohesion(static_limit: Any, press: Any, level: Any, cohesion: Any) -> Any:
    """Limit_friction. Operations: 2 mul, 1 sub, 1 div."""
    v7 = (press * static_limit - cohesion * level) / press
    return v7


def limit_friction_pore_pressure(static_limit: Any, press: Any, level: Any, pore_ratio: Any, pore_pressure: Any) -> Any:
    """Limit_friction. Operations: 3 mul, 2 sub, 1 div."""
    v11 = press / ((1.0 - pore_ratio) * press - level * pore_pressure) * static_limit
    return v11


def limit_friction_pore_pressure_cohesion(static_limit: Any, press: Any, level: Any, pore_ratio: Any, pore_pressure: Any, cohesion: Any) -> Any:
    """Limit_friction. Operations: 4 mul, 3 sub, 1 div."""
    v14 = (press * static_limit - cohesion * level) / ((1.0 - pore_ratio) * press - level * pore_pressure)
    return v14


def normal(press: Any) -> Any:
    """Normal. Operations: none."""
    return press


def normal_pore_pressure(press: Any, level: Any, pore_ratio: Any, pore_pressure: Any) -> Any:
    """Normal. Operations: 2 mul, 2 sub."""
    v8 = (1.0 - pore_ratio) * press - level * pore_pressure
    return v8


def normal_stress(press: Any, level: Any) -> Any:
    """Normal_stress. Operations: 1 div."""
    v2 = press / level
    return v2


def normal_stress_centripetal(press: Any, level: Any, polar: Any, omega_2: Any) -> Any:
    """Normal_stress. Operations: 1 mul, 1 add, 1 div."""
    v6 = (press + omega_2 * polar) / level
    return v6


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


def resistance_centripetal_drag(press: Any, polar: Any, mu: Any, omega_2: Any, drag: Any) -> Any:
    """Resistance. Operations: 3 mul, 2 add."""
    v9 = drag * omega_2 + (press + omega_2 * polar) * mu
    return v9


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


def resistance_centripetal_pore_pressure_drag(press: Any, level: Any, polar: Any, mu: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, drag: Any) -> Any:
    """Resistance. Operations: 5 mul, 2 add, 2 sub."""
    v17 = drag * omega_2 + (omega_2 * polar + (1.0 - pore_ratio) * press - level * pore_pressure) * mu
    return v17


def resistance_cohesion(press: Any, level: Any, mu: Any, cohesion: Any) -> Any:
    """Resistance. Operations: 2 mul, 1 add."""
    v6 = cohesion * level + mu * press
    return v6


def resistance_cohesion_drag(press: Any, level: Any, mu: Any, omega_2: Any, cohesion: Any, drag: Any) -> Any:
    """Resistance. Operations: 3 mul, 2 add."""
    v10 = cohesion * level + drag * omega_2 + mu * press
    return v10


def resistance_drag(press: Any, mu: Any, omega_2: Any, drag: Any) -> Any:
    """Resistance. Operations: 2 mul, 1 add."""
    v6 = drag * omega_2 + mu * press
    return v6


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


def resistance_pore_pressure_drag(press: Any, level: Any, mu: Any, omega_2: Any, pore_ratio: Any, pore_pressure: Any, drag: Any) -> Any:
    """Resistance. Operations: 4 mul, 1 add, 2 sub."""
    v14 = drag * omega_2 + ((1.0 - pore_ratio) * press - level * pore_pressure) * mu
    return v14


def tilt(fall_slope: Any, press_slope: Any, mu: Any) -> Any:
    """Tilt. Operations: 1 mul, 1 sub."""
    v4 = fall_slope - mu * press_slope
    return v4


def tilt_pore_pressure(fall_slope: Any, press_slope: Any, mu: Any, pore_ratio: Any) -> Any:
    """Tilt. Operations: 2 mul, 2 sub."""
    v8 = fall_slope - (1.0 - pore_ratio) * mu * press_slope
    return v8
