# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: 537eb4cd4e2c1922070c94efa395518b7e037a17af5d83cff3fd19d80dfab716
"""The frozen slide under constant friction: angular velocity, rotation, acceleration, arrest."""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from generated._evaluate import Array, evaluate

__all__ = [
    "frozen_angular_velocity",
    "frozen_rotation",
    "frozen_angular_acceleration",
    "frozen_arrest_time",
    "frozen_arrest_rotation",
    "frozen_centripetal_angular_velocity",
    "frozen_centripetal_rotation",
    "frozen_centripetal_angular_acceleration",
    "frozen_centripetal_arrest_time",
    "frozen_centripetal_arrest_rotation",
]


def _frozen_angular_velocity(a: Array, omega_0: Array, t: Array) -> Array:
    v4 = omega_0 + a * t
    return v4


def frozen_angular_velocity(a: ArrayLike, omega_0: ArrayLike, t: ArrayLike, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True) -> Any:
    """Angular velocity under a constant drive, without centripetal stress.

    omega = omega_0 + a t

    Parameters
    ----------
    a : array_like
        Drive, (J_theta - mu J_r)/Theta* (3.17).
    omega_0 : array_like
        Initial angular velocity over sqrt(g/R).
    t : array_like
        Time over sqrt(R/g), not negative.
    out : ndarray, optional
        Where the result goes.
    where : array_like of bool, optional
        Lanes to compute; others keep what `out` holds (NaN without `out`).

    Returns
    -------
    ndarray or scalar
        Dimensionless. Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32.

    Notes
    -----
    Domain: t >= 0, until the solution runs to infinity; elsewhere NaN and NumPy's ``invalid`` flag.
    Accuracy: at most 8 ulp times (1 + condition number) (sampled only: no certificate).
    Source: eq. (3.16) of the paper. Operations: 1 mul, 1 add.
    """
    return evaluate(_frozen_angular_velocity, lambda eps, a, omega_0, t: np.isfinite(a) & np.isfinite(omega_0) & ((t >= 0.0) & np.isfinite(t)), (1.0, 0.0, 0.0), (a, omega_0, t), out, where)


def _frozen_rotation(a: Array, omega_0: Array, t: Array) -> Array:
    v7 = (omega_0 + 0.5 * a * t) * t
    return v7


def frozen_rotation(a: ArrayLike, omega_0: ArrayLike, t: ArrayLike, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True) -> Any:
    """Rotation under a constant drive, without centripetal stress.

    phi = omega_0 t + a t**2/2

    Parameters
    ----------
    a : array_like
        Drive, (J_theta - mu J_r)/Theta* (3.17).
    omega_0 : array_like
        Initial angular velocity over sqrt(g/R).
    t : array_like
        Time over sqrt(R/g), not negative.
    out : ndarray, optional
        Where the result goes.
    where : array_like of bool, optional
        Lanes to compute; others keep what `out` holds (NaN without `out`).

    Returns
    -------
    ndarray or scalar
        Dimensionless. Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32.

    Notes
    -----
    Domain: t >= 0, until the solution runs to infinity; elsewhere NaN and NumPy's ``invalid`` flag.
    Accuracy: at most 8 ulp times (1 + condition number) (sampled only: no certificate).
    Source: eq. (1.3) of the paper. Operations: 3 mul, 1 add.
    """
    return evaluate(_frozen_rotation, lambda eps, a, omega_0, t: np.isfinite(a) & np.isfinite(omega_0) & ((t >= 0.0) & np.isfinite(t)), (1.0, 0.0, 0.0), (a, omega_0, t), out, where)


def _frozen_angular_acceleration(a: Array, omega_0: Array, t: Array) -> Array:
    return a


def frozen_angular_acceleration(a: ArrayLike, omega_0: ArrayLike, t: ArrayLike, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True) -> Any:
    """Angular acceleration under a constant drive, without centripetal stress.

    d(omega)/dt = a

    Parameters
    ----------
    a : array_like
        Drive, (J_theta - mu J_r)/Theta* (3.17).
    omega_0 : array_like
        Initial angular velocity over sqrt(g/R).
    t : array_like
        Time over sqrt(R/g), not negative.
    out : ndarray, optional
        Where the result goes.
    where : array_like of bool, optional
        Lanes to compute; others keep what `out` holds (NaN without `out`).

    Returns
    -------
    ndarray or scalar
        Dimensionless. Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32.

    Notes
    -----
    Domain: t >= 0, until the solution runs to infinity; elsewhere NaN and NumPy's ``invalid`` flag.
    Accuracy: at most 8 ulp times (1 + condition number) (sampled only: no certificate).
    Source: eq. (3.16) of the paper. Operations: .
    """
    return evaluate(_frozen_angular_acceleration, lambda eps, a, omega_0, t: np.isfinite(a) & np.isfinite(omega_0) & ((t >= 0.0) & np.isfinite(t)), (1.0, 0.0, 0.0), (a, omega_0, t), out, where)


def _frozen_arrest_time(a: Array, omega_0: Array) -> Array:
    v3 = -(omega_0 / a)
    return v3


def frozen_arrest_time(a: ArrayLike, omega_0: ArrayLike, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True) -> Any:
    """Time at which a braked motion stands still, without centripetal stress.

    t = omega_0/(-a)

    Parameters
    ----------
    a : array_like
        Drive, (J_theta - mu J_r)/Theta* (3.17).
    omega_0 : array_like
        Initial angular velocity over sqrt(g/R).
    out : ndarray, optional
        Where the result goes.
    where : array_like of bool, optional
        Lanes to compute; others keep what `out` holds (NaN without `out`).

    Returns
    -------
    ndarray or scalar
        Dimensionless. Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32.

    Notes
    -----
    Domain: a < 0, b >= 0, omega_0 >= 0; elsewhere NaN and NumPy's ``invalid`` flag.
    Accuracy: at most 8 ulp times (1 + condition number) (sampled only: no certificate).
    Source: eq. (3.16) of the paper. Operations: 1 div, 1 neg.
    """
    return evaluate(_frozen_arrest_time, lambda eps, a, omega_0: ((a < 0.0) & np.isfinite(a)) & ((omega_0 >= 0.0) & np.isfinite(omega_0)), (-1.0, 0.0), (a, omega_0), out, where)


def _frozen_arrest_rotation(a: Array, omega_0: Array) -> Array:
    v6 = -(0.5 / a * omega_0 * omega_0)
    return v6


def frozen_arrest_rotation(a: ArrayLike, omega_0: ArrayLike, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True) -> Any:
    """Rotation at which a braked motion stands still, without centripetal stress.

    phi = omega_0**2/(-2 a)

    Parameters
    ----------
    a : array_like
        Drive, (J_theta - mu J_r)/Theta* (3.17).
    omega_0 : array_like
        Initial angular velocity over sqrt(g/R).
    out : ndarray, optional
        Where the result goes.
    where : array_like of bool, optional
        Lanes to compute; others keep what `out` holds (NaN without `out`).

    Returns
    -------
    ndarray or scalar
        Dimensionless. Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32.

    Notes
    -----
    Domain: a < 0, b >= 0, omega_0 >= 0; elsewhere NaN and NumPy's ``invalid`` flag.
    Accuracy: at most 8 ulp times (1 + condition number) (sampled only: no certificate).
    Source: eq. (1.3) of the paper. Operations: 2 mul, 1 div, 1 neg.
    """
    return evaluate(_frozen_arrest_rotation, lambda eps, a, omega_0: ((a < 0.0) & np.isfinite(a)) & ((omega_0 >= 0.0) & np.isfinite(omega_0)), (-1.0, 0.0), (a, omega_0), out, where)


def _frozen_centripetal_angular_velocity(a: Array, b: Array, omega_0: Array, t: Array) -> Array:
    v8 = np.sqrt(np.abs(a)) * np.sqrt(np.abs(b))
    v14 = np.minimum(t, 800.0 / np.maximum(1e-300, v8)) * v8
    v19 = np.sign(a) * np.sign(b) * v14 * v14
    v23 = np.maximum(-9.869604401089358, np.minimum(1.0, v19))
    v25 = 1.0 < v19
    v28 = np.exp(-v14)
    v29 = v28 * v28
    v34 = 0.25 * v23
    v44 = ((9.183689863795546e-29 * v34 + 6.446950284384474e-26) * v34 + 3.868170170630684e-23) * v34 + 1.9572941063391263e-20
    v53 = ((v44 * v34 + 8.22063524662433e-18) * v34 + 2.8114572543455206e-15) * v34 + 7.647163731819816e-13
    v62 = ((v53 * v34 + 1.6059043836821613e-10) * v34 + 2.505210838544172e-08) * v34 + 2.7557319223985893e-06
    v72 = (((v62 * v34 + 0.0001984126984126984) * v34 + 0.008333333333333333) * v34 + 0.16666666666666666) * v34
    v73 = v72 + 1.0
    v78 = np.where(v25, 0.5 + 0.5 * v29, 1.0 + 0.5 * (v73 * v73) * v23)
    v88 = ((9.183689863795546e-29 * v23 + 6.446950284384474e-26) * v23 + 3.868170170630684e-23) * v23 + 1.9572941063391263e-20
    v94 = ((v88 * v23 + 8.22063524662433e-18) * v23 + 2.8114572543455206e-15) * v23 + 7.647163731819816e-13
    v100 = ((v94 * v23 + 1.6059043836821613e-10) * v23 + 2.505210838544172e-08) * v23 + 2.7557319223985893e-06
    v107 = (((v100 * v23 + 0.0001984126984126984) * v23 + 0.008333333333333333) * v23 + 0.16666666666666666) * v23
    v110 = np.where(v25, 0.5 * (1.0 - v29) / np.where(v25, v8, 1.0), (v107 + 1.0) * np.where(v25, 0.0, t))
    v113 = v78 + v110 * b * omega_0
    v120 = 0.0 < np.minimum(v113, 9.869604401089358 + v19)
    v124 = np.where(v120, (v78 * omega_0 + v110 * a) / np.where(v120, v113, 1.0), np.nan)
    return v124


def frozen_centripetal_angular_velocity(a: ArrayLike, b: ArrayLike, omega_0: ArrayLike, t: ArrayLike, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True) -> Any:
    """Angular velocity of the paper's motion, for any sign of a and b and any initial velocity.

    omega = (omega_0 + a T)/(1 + b omega_0 T), T = tanh(k t)/k, k = sqrt(a b)

    Parameters
    ----------
    a : array_like
        Drive, (J_theta - mu J_r)/Theta* (3.17).
    b : array_like
        Brake, mu I_p*/Theta* (3.18).
    omega_0 : array_like
        Initial angular velocity over sqrt(g/R).
    t : array_like
        Time over sqrt(R/g), not negative.
    out : ndarray, optional
        Where the result goes.
    where : array_like of bool, optional
        Lanes to compute; others keep what `out` holds (NaN without `out`).

    Returns
    -------
    ndarray or scalar
        Dimensionless. Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32.

    Notes
    -----
    Domain: t >= 0, until the solution runs to infinity; elsewhere NaN and NumPy's ``invalid`` flag.
    Accuracy: at most 8 ulp times (1 + condition number) (sampled only: no certificate).
    Source: eq. (3.20) of the paper. Operations: 43 mul, 31 add, 1 sub, 3 div, 1 neg, 3 min, 2 max, 2 less, 6
    select, 2 abs, 1 exp, 2 sign, 2 sqrt.
    """
    return evaluate(_frozen_centripetal_angular_velocity, lambda eps, a, b, omega_0, t: np.isfinite(a) & np.isfinite(b) & np.isfinite(omega_0) & ((t >= 0.0) & np.isfinite(t)), (1.0, 1.0, 0.0, 0.0), (a, b, omega_0, t), out, where)


def _frozen_centripetal_rotation(a: Array, b: Array, omega_0: Array, t: Array) -> Array:
    v8 = np.sqrt(np.abs(a)) * np.sqrt(np.abs(b))
    v14 = np.minimum(t, 800.0 / np.maximum(1e-300, v8)) * v8
    v19 = np.sign(a) * np.sign(b) * v14 * v14
    v23 = np.maximum(-9.869604401089358, np.minimum(1.0, v19))
    v25 = 1.0 < v19
    v26 = np.where(v25, 0.0, t)
    v28 = np.exp(-v14)
    v29 = v28 * v28
    v34 = 0.25 * v23
    v44 = ((9.183689863795546e-29 * v34 + 6.446950284384474e-26) * v34 + 3.868170170630684e-23) * v34 + 1.9572941063391263e-20
    v53 = ((v44 * v34 + 8.22063524662433e-18) * v34 + 2.8114572543455206e-15) * v34 + 7.647163731819816e-13
    v62 = ((v53 * v34 + 1.6059043836821613e-10) * v34 + 2.505210838544172e-08) * v34 + 2.7557319223985893e-06
    v72 = (((v62 * v34 + 0.0001984126984126984) * v34 + 0.008333333333333333) * v34 + 0.16666666666666666) * v34
    v73 = v72 + 1.0
    v75 = 0.5 * (v73 * v73)
    v88 = ((9.183689863795546e-29 * v23 + 6.446950284384474e-26) * v23 + 3.868170170630684e-23) * v23 + 1.9572941063391263e-20
    v94 = ((v88 * v23 + 8.22063524662433e-18) * v23 + 2.8114572543455206e-15) * v23 + 7.647163731819816e-13
    v100 = ((v94 * v23 + 1.6059043836821613e-10) * v23 + 2.505210838544172e-08) * v23 + 2.7557319223985893e-06
    v107 = (((v100 * v23 + 0.0001984126984126984) * v23 + 0.008333333333333333) * v23 + 0.16666666666666666) * v23
    v109 = (v107 + 1.0) * v26
    v113 = np.where(v25, 0.5 + 0.5 * v29, 1.0 + v75 * v23) + np.where(v25, 0.5 * (1.0 - v29) / np.where(v25, v8, 1.0), v109) * b * omega_0
    v118 = v75 * a * v26 * v26 + v109 * omega_0
    v119 = v118 * b
    v121 = np.where(v25, v113, 1.0 + v119)
    v127 = 0.0 < np.minimum(v121, 9.869604401089358 + v19)
    v135 = np.where(v25, 0.0, np.maximum(-0.9999999999999999, v119))
    v138 = np.abs(v135) < 8.673617379884035e-19
    v139 = np.where(v138, 1.0, v135)
    v144 = np.where(v25, (np.where(v25, t, 0.0) * v8 + np.log(np.where(v127, v121, 1.0))) / np.where(v25, b, 1.0), np.where(v138, 1.0, np.log1p(v139) / v139) * v118)
    v146 = np.where(v127, v144, np.nan)
    return v146


def frozen_centripetal_rotation(a: ArrayLike, b: ArrayLike, omega_0: ArrayLike, t: ArrayLike, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True) -> Any:
    """Rotation of the paper's motion, for any sign of a and b and any initial velocity.

    phi = ln(cosh(k t) + b omega_0 sinh(k t)/k)/b, k = sqrt(a b)

    Parameters
    ----------
    a : array_like
        Drive, (J_theta - mu J_r)/Theta* (3.17).
    b : array_like
        Brake, mu I_p*/Theta* (3.18).
    omega_0 : array_like
        Initial angular velocity over sqrt(g/R).
    t : array_like
        Time over sqrt(R/g), not negative.
    out : ndarray, optional
        Where the result goes.
    where : array_like of bool, optional
        Lanes to compute; others keep what `out` holds (NaN without `out`).

    Returns
    -------
    ndarray or scalar
        Dimensionless. Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32.

    Notes
    -----
    Domain: t >= 0, until the solution runs to infinity; elsewhere NaN and NumPy's ``invalid`` flag.
    Accuracy: at most 8 ulp times (1 + condition number) (sampled only: no certificate).
    Source: eq. (4.3) of the paper. Operations: 48 mul, 33 add, 1 sub, 4 div, 1 neg, 3 min, 3 max, 3 less, 13
    select, 3 abs, 1 exp, 1 log, 1 log1p, 2 sign, 2 sqrt.
    """
    return evaluate(_frozen_centripetal_rotation, lambda eps, a, b, omega_0, t: np.isfinite(a) & np.isfinite(b) & np.isfinite(omega_0) & ((t >= 0.0) & np.isfinite(t)), (1.0, 1.0, 0.0, 0.0), (a, b, omega_0, t), out, where)


def _frozen_centripetal_angular_acceleration(a: Array, b: Array, omega_0: Array, t: Array) -> Array:
    v8 = np.sqrt(np.abs(a)) * np.sqrt(np.abs(b))
    v14 = np.minimum(t, 800.0 / np.maximum(1e-300, v8)) * v8
    v19 = np.sign(a) * np.sign(b) * v14 * v14
    v23 = np.maximum(-9.869604401089358, np.minimum(1.0, v19))
    v25 = 1.0 < v19
    v28 = np.exp(-v14)
    v29 = v28 * v28
    v34 = 0.25 * v23
    v44 = ((9.183689863795546e-29 * v34 + 6.446950284384474e-26) * v34 + 3.868170170630684e-23) * v34 + 1.9572941063391263e-20
    v53 = ((v44 * v34 + 8.22063524662433e-18) * v34 + 2.8114572543455206e-15) * v34 + 7.647163731819816e-13
    v62 = ((v53 * v34 + 1.6059043836821613e-10) * v34 + 2.505210838544172e-08) * v34 + 2.7557319223985893e-06
    v72 = (((v62 * v34 + 0.0001984126984126984) * v34 + 0.008333333333333333) * v34 + 0.16666666666666666) * v34
    v73 = v72 + 1.0
    v88 = ((9.183689863795546e-29 * v23 + 6.446950284384474e-26) * v23 + 3.868170170630684e-23) * v23 + 1.9572941063391263e-20
    v94 = ((v88 * v23 + 8.22063524662433e-18) * v23 + 2.8114572543455206e-15) * v23 + 7.647163731819816e-13
    v100 = ((v94 * v23 + 1.6059043836821613e-10) * v23 + 2.505210838544172e-08) * v23 + 2.7557319223985893e-06
    v107 = (((v100 * v23 + 0.0001984126984126984) * v23 + 0.008333333333333333) * v23 + 0.16666666666666666) * v23
    v111 = np.where(v25, 0.5 * (1.0 - v29) / np.where(v25, v8, 1.0), (v107 + 1.0) * np.where(v25, 0.0, t)) * b
    v113 = np.where(v25, 0.5 + 0.5 * v29, 1.0 + 0.5 * (v73 * v73) * v23) + v111 * omega_0
    v118 = 0.0 < np.minimum(v113, 9.869604401089358 + v19)
    v120 = np.where(v25, v28, 1.0) / np.where(v118, v113, 1.0)
    v127 = np.where(v118, (a - b * omega_0 * omega_0) * v120 * v120, np.nan)
    return v127


def frozen_centripetal_angular_acceleration(a: ArrayLike, b: ArrayLike, omega_0: ArrayLike, t: ArrayLike, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True) -> Any:
    """Angular acceleration of the paper's motion, for any sign of a and b and any initial velocity.

    (a - b omega_0**2)/y**2 with y = exp(b phi)

    Parameters
    ----------
    a : array_like
        Drive, (J_theta - mu J_r)/Theta* (3.17).
    b : array_like
        Brake, mu I_p*/Theta* (3.18).
    omega_0 : array_like
        Initial angular velocity over sqrt(g/R).
    t : array_like
        Time over sqrt(R/g), not negative.
    out : ndarray, optional
        Where the result goes.
    where : array_like of bool, optional
        Lanes to compute; others keep what `out` holds (NaN without `out`).

    Returns
    -------
    ndarray or scalar
        Dimensionless. Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32.

    Notes
    -----
    Domain: t >= 0, until the solution runs to infinity; elsewhere NaN and NumPy's ``invalid`` flag.
    Accuracy: at most 8 ulp times (1 + condition number) (sampled only: no certificate).
    Source: eq. (3.16) of the paper. Operations: 45 mul, 30 add, 2 sub, 3 div, 1 neg, 3 min, 2 max, 2 less, 7
    select, 2 abs, 1 exp, 2 sign, 2 sqrt.
    """
    return evaluate(_frozen_centripetal_angular_acceleration, lambda eps, a, b, omega_0, t: np.isfinite(a) & np.isfinite(b) & np.isfinite(omega_0) & ((t >= 0.0) & np.isfinite(t)), (1.0, 1.0, 0.0, 0.0), (a, b, omega_0, t), out, where)


def _frozen_centripetal_arrest_time(a: Array, b: Array, omega_0: Array) -> Array:
    v3 = np.sqrt(b)
    v7 = np.sqrt(-a)
    v14 = np.abs(v3 * omega_0) / np.abs(v7) < 8.673617379884035e-19
    v15 = np.where(v14, 1.0, v3 / v7 * omega_0)
    v21 = -(np.where(v14, 1.0, np.arctan(v15) / v15) / a * omega_0)
    return v21


def frozen_centripetal_arrest_time(a: ArrayLike, b: ArrayLike, omega_0: ArrayLike, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True) -> Any:
    """Time at which a braked motion stands still.

    t = arctan(omega_0 sqrt(b/(-a)))/sqrt(-a b)

    Parameters
    ----------
    a : array_like
        Drive, (J_theta - mu J_r)/Theta* (3.17).
    b : array_like
        Brake, mu I_p*/Theta* (3.18).
    omega_0 : array_like
        Initial angular velocity over sqrt(g/R).
    out : ndarray, optional
        Where the result goes.
    where : array_like of bool, optional
        Lanes to compute; others keep what `out` holds (NaN without `out`).

    Returns
    -------
    ndarray or scalar
        Dimensionless. Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32.

    Notes
    -----
    Domain: a < 0, b >= 0, omega_0 >= 0; elsewhere NaN and NumPy's ``invalid`` flag.
    Accuracy: at most 8 ulp times (1 + condition number) (sampled only: no certificate).
    Source: eq. (3.20) of the paper. Operations: 3 mul, 4 div, 2 neg, 1 less, 2 select, 2 abs, 1 arctan, 2 sqrt.
    """
    return evaluate(_frozen_centripetal_arrest_time, lambda eps, a, b, omega_0: ((a < 0.0) & np.isfinite(a)) & ((b >= 0.0) & np.isfinite(b)) & ((omega_0 >= 0.0) & np.isfinite(omega_0)), (-1.0, 1.0, 0.0), (a, b, omega_0), out, where)


def _frozen_centripetal_arrest_rotation(a: Array, b: Array, omega_0: Array) -> Array:
    v4 = b / a
    v13 = np.abs(v4) * omega_0 * omega_0 < 8.673617379884035e-19
    v14 = np.where(v13, 1.0, -(v4 * omega_0 * omega_0))
    v22 = -(0.5 * np.where(v13, 1.0, np.log1p(v14) / v14) / a * omega_0 * omega_0)
    return v22


def frozen_centripetal_arrest_rotation(a: ArrayLike, b: ArrayLike, omega_0: ArrayLike, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True) -> Any:
    """Rotation at which a braked motion stands still.

    phi = ln(1 + b omega_0**2/(-a))/(2 b)

    Parameters
    ----------
    a : array_like
        Drive, (J_theta - mu J_r)/Theta* (3.17).
    b : array_like
        Brake, mu I_p*/Theta* (3.18).
    omega_0 : array_like
        Initial angular velocity over sqrt(g/R).
    out : ndarray, optional
        Where the result goes.
    where : array_like of bool, optional
        Lanes to compute; others keep what `out` holds (NaN without `out`).

    Returns
    -------
    ndarray or scalar
        Dimensionless. Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32.

    Notes
    -----
    Domain: a < 0, b >= 0, omega_0 >= 0; elsewhere NaN and NumPy's ``invalid`` flag.
    Accuracy: at most 8 ulp times (1 + condition number) (sampled only: no certificate).
    Source: eq. (4.3) of the paper. Operations: 7 mul, 3 div, 2 neg, 1 less, 2 select, 1 abs, 1 log1p.
    """
    return evaluate(_frozen_centripetal_arrest_rotation, lambda eps, a, b, omega_0: ((a < 0.0) & np.isfinite(a)) & ((b >= 0.0) & np.isfinite(b)) & ((omega_0 >= 0.0) & np.isfinite(omega_0)), (-1.0, 1.0, 0.0), (a, b, omega_0), out, where)
