# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: e2f12e6f94c2127e982762b7494ab458c050cd9fdbcdd42d0c3c3d29d35ce414
"""The friction laws that have a formula, and how far they fall over a slip."""

from typing import Any

import numpy as np

__all__ = [
    "drop_exponential",
    "drop_hyperbolic",
    "drop_linear",
    "friction_exponential",
    "friction_hyperbolic",
    "friction_linear",
    "friction_rate_weakening",
]


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
