# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: b992618d529ce31cfcbea0bbad80b2840207588f80526fa179f2a05d45e69f97
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
    Domain: t >= 0; elsewhere NaN and NumPy's ``invalid`` flag.
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
    Domain: t >= 0; elsewhere NaN and NumPy's ``invalid`` flag.
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
    Domain: t >= 0; elsewhere NaN and NumPy's ``invalid`` flag.
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
    Domain: a < 0, omega_0 >= 0; elsewhere NaN and NumPy's ``invalid`` flag.
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
    Domain: a < 0, omega_0 >= 0; elsewhere NaN and NumPy's ``invalid`` flag.
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
    v30 = b * omega_0
    v31 = v8 + v30
    v35 = 0.25 * v23
    v45 = ((9.183689863795546e-29 * v35 + 6.446950284384474e-26) * v35 + 3.868170170630684e-23) * v35 + 1.9572941063391263e-20
    v54 = ((v45 * v35 + 8.22063524662433e-18) * v35 + 2.8114572543455206e-15) * v35 + 7.647163731819816e-13
    v63 = ((v54 * v35 + 1.6059043836821613e-10) * v35 + 2.505210838544172e-08) * v35 + 2.7557319223985893e-06
    v73 = (((v63 * v35 + 0.0001984126984126984) * v35 + 0.008333333333333333) * v35 + 0.16666666666666666) * v35
    v74 = v73 + 1.0
    v78 = 1.0 + 0.5 * (v74 * v74) * v23
    v84 = ((9.183689863795546e-29 * v23 + 6.446950284384474e-26) * v23 + 3.868170170630684e-23) * v23 + 1.9572941063391263e-20
    v90 = ((v84 * v23 + 8.22063524662433e-18) * v23 + 2.8114572543455206e-15) * v23 + 7.647163731819816e-13
    v96 = ((v90 * v23 + 1.6059043836821613e-10) * v23 + 2.505210838544172e-08) * v23 + 2.7557319223985893e-06
    v103 = (((v96 * v23 + 0.0001984126984126984) * v23 + 0.008333333333333333) * v23 + 0.16666666666666666) * v23
    v105 = (v103 + 1.0) * np.where(v25, 0.0, t)
    v106 = (v8 - v30) * (v28 * v28)
    v114 = np.where(v25, 0.5 * (v31 + v106) / np.where(v25, v8, 1.0), v78 + v105 * b * omega_0)
    v126 = 0.0 < np.minimum(v114, 9.869604401089358 + v19)
    v128 = np.where(v25, 0.5 * (v31 - v106) / np.where(v25, b, 1.0), v78 * omega_0 + v105 * a) / np.where(v126, v114, 1.0)
    v130 = np.where(v126, v128, np.nan)
    return v130


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
    Source: eq. (3.20) of the paper. Operations: 45 mul, 32 add, 2 sub, 4 div, 1 neg, 3 min, 2 max, 2 less, 7
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
    v30 = b * omega_0
    v35 = 0.25 * v23
    v45 = ((9.183689863795546e-29 * v35 + 6.446950284384474e-26) * v35 + 3.868170170630684e-23) * v35 + 1.9572941063391263e-20
    v54 = ((v45 * v35 + 8.22063524662433e-18) * v35 + 2.8114572543455206e-15) * v35 + 7.647163731819816e-13
    v63 = ((v54 * v35 + 1.6059043836821613e-10) * v35 + 2.505210838544172e-08) * v35 + 2.7557319223985893e-06
    v73 = (((v63 * v35 + 0.0001984126984126984) * v35 + 0.008333333333333333) * v35 + 0.16666666666666666) * v35
    v74 = v73 + 1.0
    v76 = 0.5 * (v74 * v74)
    v84 = ((9.183689863795546e-29 * v23 + 6.446950284384474e-26) * v23 + 3.868170170630684e-23) * v23 + 1.9572941063391263e-20
    v90 = ((v84 * v23 + 8.22063524662433e-18) * v23 + 2.8114572543455206e-15) * v23 + 7.647163731819816e-13
    v96 = ((v90 * v23 + 1.6059043836821613e-10) * v23 + 2.505210838544172e-08) * v23 + 2.7557319223985893e-06
    v103 = (((v96 * v23 + 0.0001984126984126984) * v23 + 0.008333333333333333) * v23 + 0.16666666666666666) * v23
    v105 = (v103 + 1.0) * v26
    v114 = np.where(v25, 0.5 * (v8 + v30 + (v8 - v30) * (v28 * v28)) / np.where(v25, v8, 1.0), 1.0 + v76 * v23 + v105 * b * omega_0)
    v119 = v76 * a * v26 * v26 + v105 * omega_0
    v120 = v119 * b
    v122 = np.where(v25, v114, 1.0 + v120)
    v128 = 0.0 < np.minimum(v122, 9.869604401089358 + v19)
    v136 = np.where(v25, 0.0, np.maximum(-0.9999999999999999, v120))
    v139 = np.abs(v136) < 8.673617379884035e-19
    v140 = np.where(v139, 1.0, v136)
    v145 = np.where(v25, (np.where(v25, t, 0.0) * v8 + np.log(np.where(v128, v122, 1.0))) / np.where(v25, b, 1.0), np.where(v139, 1.0, np.log1p(v140) / v140) * v119)
    v147 = np.where(v128, v145, np.nan)
    return v147


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
    Source: eq. (4.3) of the paper. Operations: 49 mul, 34 add, 1 sub, 4 div, 1 neg, 3 min, 3 max, 3 less, 12
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
    v30 = b * omega_0
    v31 = v8 + v30
    v32 = v8 - v30
    v35 = 0.25 * v23
    v45 = ((9.183689863795546e-29 * v35 + 6.446950284384474e-26) * v35 + 3.868170170630684e-23) * v35 + 1.9572941063391263e-20
    v54 = ((v45 * v35 + 8.22063524662433e-18) * v35 + 2.8114572543455206e-15) * v35 + 7.647163731819816e-13
    v63 = ((v54 * v35 + 1.6059043836821613e-10) * v35 + 2.505210838544172e-08) * v35 + 2.7557319223985893e-06
    v73 = (((v63 * v35 + 0.0001984126984126984) * v35 + 0.008333333333333333) * v35 + 0.16666666666666666) * v35
    v74 = v73 + 1.0
    v84 = ((9.183689863795546e-29 * v23 + 6.446950284384474e-26) * v23 + 3.868170170630684e-23) * v23 + 1.9572941063391263e-20
    v90 = ((v84 * v23 + 8.22063524662433e-18) * v23 + 2.8114572543455206e-15) * v23 + 7.647163731819816e-13
    v96 = ((v90 * v23 + 1.6059043836821613e-10) * v23 + 2.505210838544172e-08) * v23 + 2.7557319223985893e-06
    v103 = (((v96 * v23 + 0.0001984126984126984) * v23 + 0.008333333333333333) * v23 + 0.16666666666666666) * v23
    v114 = np.where(v25, 0.5 * (v31 + v32 * (v28 * v28)) / np.where(v25, v8, 1.0), 1.0 + 0.5 * (v74 * v74) * v23 + (v103 + 1.0) * np.where(v25, 0.0, t) * b * omega_0)
    v119 = 0.0 < np.minimum(v114, 9.869604401089358 + v19)
    v121 = np.where(v25, v28, 1.0) / np.where(v119, v114, 1.0)
    v131 = np.where(v119, np.where(v25, v32 / np.where(v25, b, 1.0) * v31, a - v30 * omega_0) * v121 * v121, np.nan)
    return v131


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
    Source: eq. (3.16) of the paper. Operations: 46 mul, 31 add, 2 sub, 4 div, 1 neg, 3 min, 2 max, 2 less, 8
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
