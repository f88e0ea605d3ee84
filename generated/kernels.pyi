# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: 8f2b8a729e7634c1f6cb9122ebdf547e96f0c778cccbb74560e3e5442ab464d0
from __future__ import annotations

from typing import Any, TypeVar, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from generated._compiled import Text
from generated._evaluate import Out

F = TypeVar("F", np.float64, np.float32, np.float16)
__all__: list[str]
TEXTS: dict[str, dict[str, Text]]

@overload
def polar_moment(
    alpha: float,
    out: None = None,
    *,
    where: bool = True,
    accuracy: float | None = None,
) -> np.float64: ...

@overload
def polar_moment(
    alpha: NDArray[F],
    out: None = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> NDArray[F]: ...

@overload
def polar_moment(
    alpha: ArrayLike,
    out: Out = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> Any: ...

@overload
def moment_of_inertia(
    alpha: float,
    out: None = None,
    *,
    where: bool = True,
    accuracy: float | None = None,
) -> np.float64: ...

@overload
def moment_of_inertia(
    alpha: NDArray[F],
    out: None = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> NDArray[F]: ...

@overload
def moment_of_inertia(
    alpha: ArrayLike,
    out: Out = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> Any: ...

@overload
def radial_weight_amplitude(
    alpha: float,
    out: None = None,
    *,
    where: bool = True,
    accuracy: float | None = None,
) -> np.float64: ...

@overload
def radial_weight_amplitude(
    alpha: NDArray[F],
    out: None = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> NDArray[F]: ...

@overload
def radial_weight_amplitude(
    alpha: ArrayLike,
    out: Out = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> Any: ...

@overload
def weight_moment_amplitude(
    alpha: float,
    out: None = None,
    *,
    where: bool = True,
    accuracy: float | None = None,
) -> np.float64: ...

@overload
def weight_moment_amplitude(
    alpha: NDArray[F],
    out: None = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> NDArray[F]: ...

@overload
def weight_moment_amplitude(
    alpha: ArrayLike,
    out: Out = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> Any: ...

@overload
def resistance_factor(
    alpha: float,
    out: None = None,
    *,
    where: bool = True,
    accuracy: float | None = None,
) -> np.float64: ...

@overload
def resistance_factor(
    alpha: NDArray[F],
    out: None = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> NDArray[F]: ...

@overload
def resistance_factor(
    alpha: ArrayLike,
    out: Out = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> Any: ...

@overload
def dynamic_coefficient(
    alpha: float,
    out: None = None,
    *,
    where: bool = True,
    accuracy: float | None = None,
) -> np.float64: ...

@overload
def dynamic_coefficient(
    alpha: NDArray[F],
    out: None = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> NDArray[F]: ...

@overload
def dynamic_coefficient(
    alpha: ArrayLike,
    out: Out = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> Any: ...

@overload
def weight_moment_per_inertia(
    alpha: float,
    out: None = None,
    *,
    where: bool = True,
    accuracy: float | None = None,
) -> np.float64: ...

@overload
def weight_moment_per_inertia(
    alpha: NDArray[F],
    out: None = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> NDArray[F]: ...

@overload
def weight_moment_per_inertia(
    alpha: ArrayLike,
    out: Out = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> Any: ...

@overload
def radial_weight_per_inertia(
    alpha: float,
    out: None = None,
    *,
    where: bool = True,
    accuracy: float | None = None,
) -> np.float64: ...

@overload
def radial_weight_per_inertia(
    alpha: NDArray[F],
    out: None = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> NDArray[F]: ...

@overload
def radial_weight_per_inertia(
    alpha: ArrayLike,
    out: Out = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> Any: ...

@overload
def polar_moment_per_inertia(
    alpha: float,
    out: None = None,
    *,
    where: bool = True,
    accuracy: float | None = None,
) -> np.float64: ...

@overload
def polar_moment_per_inertia(
    alpha: NDArray[F],
    out: None = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> NDArray[F]: ...

@overload
def polar_moment_per_inertia(
    alpha: ArrayLike,
    out: Out = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> Any: ...

@overload
def weight_moment_per_radial_weight(
    alpha: float,
    out: None = None,
    *,
    where: bool = True,
    accuracy: float | None = None,
) -> np.float64: ...

@overload
def weight_moment_per_radial_weight(
    alpha: NDArray[F],
    out: None = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> NDArray[F]: ...

@overload
def weight_moment_per_radial_weight(
    alpha: ArrayLike,
    out: Out = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> Any: ...

@overload
def radial_weight(
    theta_1: float, theta_2: float,
    out: None = None,
    *,
    where: bool = True,
    accuracy: float | None = None,
) -> np.float64: ...

@overload
def radial_weight(
    theta_1: NDArray[F], theta_2: NDArray[F] | float,
    out: None = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> NDArray[F]: ...

@overload
def radial_weight(
    theta_1: float, theta_2: NDArray[F],
    out: None = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> NDArray[F]: ...

@overload
def radial_weight(
    theta_1: ArrayLike, theta_2: ArrayLike,
    out: Out = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> Any: ...

@overload
def weight_moment(
    theta_1: float, theta_2: float,
    out: None = None,
    *,
    where: bool = True,
    accuracy: float | None = None,
) -> np.float64: ...

@overload
def weight_moment(
    theta_1: NDArray[F], theta_2: NDArray[F] | float,
    out: None = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> NDArray[F]: ...

@overload
def weight_moment(
    theta_1: float, theta_2: NDArray[F],
    out: None = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> NDArray[F]: ...

@overload
def weight_moment(
    theta_1: ArrayLike, theta_2: ArrayLike,
    out: Out = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> Any: ...

@overload
def limit_friction(
    theta_1: float, theta_2: float,
    out: None = None,
    *,
    where: bool = True,
    accuracy: float | None = None,
) -> np.float64: ...

@overload
def limit_friction(
    theta_1: NDArray[F], theta_2: NDArray[F] | float,
    out: None = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> NDArray[F]: ...

@overload
def limit_friction(
    theta_1: float, theta_2: NDArray[F],
    out: None = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> NDArray[F]: ...

@overload
def limit_friction(
    theta_1: ArrayLike, theta_2: ArrayLike,
    out: Out = None,
    *,
    where: ArrayLike = True,
    accuracy: float | None = None,
) -> Any: ...
