# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: 0b2a5a1e393fd8bd4ebe3abeab805507574228771a5b6d0166be8c6aedf8be78
"""Closed forms and quotients that define the functions of alpha."""

from collections.abc import Callable
from typing import Any

# Over any arithmetic m that has sin, cos and atanh.
CLOSED: dict[str, Callable[[Any, Any], Any]] = {
    'polar_moment': lambda m, x: (2*x - m.sin(x)*m.cos(x) - m.cos(x)**3*m.atanh(m.sin(x)))/3,
    'moment_of_inertia': lambda m, x: x/2 - m.sin(2*x)/6 - m.sin(4*x)/24,
    'radial_weight_amplitude': lambda m, x: m.sin(x) - m.cos(x)**2*m.atanh(m.sin(x)),
    'weight_moment_amplitude': lambda m, x: 2*m.sin(x)**3/3,
    'resistance_factor': lambda m, x: 2*x*(1 - m.cos(x)),
}

QUOTIENTS = {
    'dynamic_coefficient': ('polar_moment', 'resistance_factor'),
    'weight_moment_per_inertia': ('weight_moment_amplitude', 'moment_of_inertia'),
    'radial_weight_per_inertia': ('radial_weight_amplitude', 'moment_of_inertia'),
    'polar_moment_per_inertia': ('polar_moment', 'moment_of_inertia'),
    'weight_moment_per_radial_weight': ('weight_moment_amplitude', 'radial_weight_amplitude'),
}
