# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: 89da7bac581475fd1d33d4f3c6da4ca085f04e252328c0cf21f5fb2bfe2687ca
from __future__ import annotations

from typing import Any

import numpy as np
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
