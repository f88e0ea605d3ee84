# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: 5cb2bff952ac77e02e4ff54b46a6920ebd588462eedcf06d1a2f749001097b82
from __future__ import annotations

from typing import Any

from numpy.typing import ArrayLike

from generated._evaluate import Out

__all__: list[str]

def frozen_angular_velocity(
    a: ArrayLike, b: ArrayLike, omega_0: ArrayLike, t: ArrayLike,
    /,
    out: Out = None,
    *,
    where: ArrayLike = True,
) -> Any: ...

def frozen_rotation(
    a: ArrayLike, b: ArrayLike, omega_0: ArrayLike, t: ArrayLike,
    /,
    out: Out = None,
    *,
    where: ArrayLike = True,
) -> Any: ...

def frozen_angular_acceleration(
    a: ArrayLike, b: ArrayLike, omega_0: ArrayLike, t: ArrayLike,
    /,
    out: Out = None,
    *,
    where: ArrayLike = True,
) -> Any: ...

def frozen_arrest_time(
    a: ArrayLike, b: ArrayLike, omega_0: ArrayLike,
    /,
    out: Out = None,
    *,
    where: ArrayLike = True,
) -> Any: ...

def frozen_arrest_rotation(
    a: ArrayLike, b: ArrayLike, omega_0: ArrayLike,
    /,
    out: Out = None,
    *,
    where: ArrayLike = True,
) -> Any: ...
