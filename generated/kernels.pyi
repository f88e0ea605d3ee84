# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: 2e65e02ef999ce9ff95ff918b68f3726dc5ea6e69d970eed19ebc86895f19f5d
from __future__ import annotations

from typing import Any

from numpy.typing import ArrayLike

from generated._compiled import Text
from generated._evaluate import Out

__all__: list[str]
TEXTS: dict[str, dict[str, Text]]

def polar_moment(
    alpha: ArrayLike,
    /,
    out: Out = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> Any: ...

def moment_of_inertia(
    alpha: ArrayLike,
    /,
    out: Out = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> Any: ...

def radial_weight_amplitude(
    alpha: ArrayLike,
    /,
    out: Out = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> Any: ...

def weight_moment_amplitude(
    alpha: ArrayLike,
    /,
    out: Out = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> Any: ...

def resistance_factor(
    alpha: ArrayLike,
    /,
    out: Out = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> Any: ...

def dynamic_coefficient(
    alpha: ArrayLike,
    /,
    out: Out = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> Any: ...

def weight_moment_per_inertia(
    alpha: ArrayLike,
    /,
    out: Out = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> Any: ...

def radial_weight_per_inertia(
    alpha: ArrayLike,
    /,
    out: Out = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> Any: ...

def polar_moment_per_inertia(
    alpha: ArrayLike,
    /,
    out: Out = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> Any: ...

def weight_moment_per_radial_weight(
    alpha: ArrayLike,
    /,
    out: Out = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> Any: ...

def radial_weight(
    theta_1: ArrayLike, theta_2: ArrayLike,
    /,
    out: Out = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> Any: ...

def weight_moment(
    theta_1: ArrayLike, theta_2: ArrayLike,
    /,
    out: Out = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> Any: ...

def limit_friction(
    theta_1: ArrayLike, theta_2: ArrayLike,
    /,
    out: Out = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> Any: ...
