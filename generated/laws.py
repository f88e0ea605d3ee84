# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: d0431aa6b85a681d00edb4ed1ead02b239039eaa1f3d9a9f4478378f0c147bfd
"""The friction laws that have a formula."""

from typing import Any

import numpy as np

__all__ = [
    "friction_exponential",
    "friction_hyperbolic",
    "friction_linear",
    "friction_rate_weakening",
]


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
