# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: 4b0ad868ee8086a0e9b32c30586a2cd13ef3fd04c70e955f195682c3935e4d48
"""The frozen slide under constant friction: angular velocity, rotation, acceleration, arrest."""

from __future__ import annotations

import numpy as np

from generated._evaluate import Array, evaluate, horner

__all__ = [
    "frozen_angular_velocity",
    "frozen_rotation",
    "frozen_angular_acceleration",
    "frozen_arrest_time",
    "frozen_arrest_rotation",
]

SERIES_1 = (0.5, 0.041666666666666664, 0.001388888888888889, 2.48015873015873e-05,
        2.755731922398589e-07, 2.08767569878681e-09, 1.1470745597729725e-11, 4.779477332387385e-14,
        1.5619206968586225e-16, 4.110317623312165e-19, 8.896791392450574e-22, 1.6117375710961184e-24,
        2.4795962632247976e-27, 3.279889237069838e-30)
SERIES_2 = (1.0, 0.16666666666666666, 0.008333333333333333, 0.0001984126984126984,
        2.7557319223985893e-06, 2.505210838544172e-08, 1.6059043836821613e-10, 7.647163731819816e-13,
        2.8114572543455206e-15, 8.22063524662433e-18, 1.9572941063391263e-20, 3.868170170630684e-23,
        6.446950284384474e-26, 9.183689863795546e-29)


def _frozen_angular_velocity(a: Array, b: Array, omega_0: Array, t: Array) -> Array:
    k = np.sqrt(np.abs(a)) * np.sqrt(np.abs(b))
    x = np.minimum(t, 800.0 / np.maximum(1e-300, k)) * k
    z = np.sign(a) * np.sign(b) * x * x
    near = np.maximum(-9.869604401089358, np.minimum(1.0, z))
    t1 = 1.0 < z
    far = np.where(t1, 0.0, t)
    e = np.exp(-x)
    q = e * e
    t2 = b * omega_0
    P = k + t2
    M = k - t2
    t3 = M * q
    p1 = horner(near, SERIES_1)
    t4 = p1 * near
    p2 = horner(near, SERIES_2)
    y = np.where(t1, 0.5 * (P + t3) / np.where(t1, k, 1.0), 1.0 + t4 + p2 * b * far * omega_0)
    t5 = np.where(t1, 0.5 * (P - t3) / np.where(t1, b, 1.0), omega_0 + p2 * a * far + t4 * omega_0)
    t6 = 0.0 < np.minimum(y, 9.869604401089358 + z)
    return np.where(t6, t5 / np.where(t6, y, 1.0), np.nan)


def frozen_angular_velocity(a, b, omega_0, t, /, out=None, *, where=True):
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
    Domain: t >= 0, until the solution runs to infinity; elsewhere NaN and NumPy's ``invalid`` flag, of NaN
    without.
    Accuracy: at most 8 ulp times (1 + condition number) (sampled only: no certificate).
    Source: eq. (3.20) of the paper. Operations: 43 mul, 33 add, 2 sub, 4 div, 1 neg, 3 min, 2 max, 2 less, 7
    select, 2 abs, 1 exp, 2 sign, 2 sqrt.

    Examples
    --------
    >>> from generated.motion import frozen_angular_velocity
    >>> print(f"{frozen_angular_velocity(1.0, 1.0, 0.0, 0.5):.6f}")
    0.462117
    """
    return evaluate(
        'frozen_angular_velocity',
        _frozen_angular_velocity,
        lambda eps, a, b, omega_0, t: (
            np.isfinite(a)
            & np.isfinite(b)
            & np.isfinite(omega_0)
            & ((t >= 0.0)
            & np.isfinite(t))
        ),
        (1.0, 1.0, 0.0, 0.5),
        (a, b, omega_0, t),
        out,
        where,
    )


def _frozen_rotation(a: Array, b: Array, omega_0: Array, t: Array) -> Array:
    k = np.sqrt(np.abs(a)) * np.sqrt(np.abs(b))
    x = np.minimum(t, 800.0 / np.maximum(1e-300, k)) * k
    z = np.sign(a) * np.sign(b) * x * x
    near = np.maximum(-9.869604401089358, np.minimum(1.0, z))
    t1 = 1.0 < z
    far = np.where(t1, 0.0, t)
    e = np.exp(-x)
    q = e * e
    t2 = b * omega_0
    P = k + t2
    M = k - t2
    p1 = horner(near, SERIES_1)
    p2 = horner(near, SERIES_2)
    t3 = 0.5 * (P + M * q) / np.where(t1, k, 1.0)
    y = np.where(t1, t3, 1.0 + p1 * near + p2 * b * far * omega_0)
    G = p1 * a * far * far + p2 * far * omega_0
    t4 = G * b
    y_near = np.where(t1, y, 1.0 + t4)
    t5 = 0.0 < np.minimum(y_near, 9.869604401089358 + z)
    t6 = (np.where(t1, t, 0.0) * k + np.log(np.where(t5, y_near, 1.0))) / np.where(t1, b, 1.0)
    t7 = np.where(t1, 0.0, np.maximum(-0.9999999999999999, t4))
    t8 = np.abs(t7) < 8.673617379884035e-19
    t9 = np.where(t8, 1.0, t7)
    return np.where(t5, np.where(t1, t6, np.where(t8, 1.0, np.log1p(t9) / t9) * G), np.nan)


def frozen_rotation(a, b, omega_0, t, /, out=None, *, where=True):
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
    Domain: t >= 0, until the solution runs to infinity; elsewhere NaN and NumPy's ``invalid`` flag, of NaN
    without.
    Accuracy: at most 8 ulp times (1 + condition number) (sampled only: no certificate).
    Source: eq. (4.3) of the paper. Operations: 47 mul, 34 add, 1 sub, 4 div, 1 neg, 3 min, 3 max, 3 less, 12
    select, 3 abs, 1 exp, 1 log, 1 log1p, 2 sign, 2 sqrt.

    Examples
    --------
    >>> from generated.motion import frozen_rotation
    >>> print(f"{frozen_rotation(1.0, 1.0, 0.0, 0.5):.6f}")
    0.120115
    """
    return evaluate(
        'frozen_rotation',
        _frozen_rotation,
        lambda eps, a, b, omega_0, t: (
            np.isfinite(a)
            & np.isfinite(b)
            & np.isfinite(omega_0)
            & ((t >= 0.0)
            & np.isfinite(t))
        ),
        (1.0, 1.0, 0.0, 0.5),
        (a, b, omega_0, t),
        out,
        where,
    )


def _frozen_angular_acceleration(a: Array, b: Array, omega_0: Array, t: Array) -> Array:
    k = np.sqrt(np.abs(a)) * np.sqrt(np.abs(b))
    x = np.minimum(t, 800.0 / np.maximum(1e-300, k)) * k
    z = np.sign(a) * np.sign(b) * x * x
    near = np.maximum(-9.869604401089358, np.minimum(1.0, z))
    t1 = 1.0 < z
    far = np.where(t1, 0.0, t)
    e = np.exp(-x)
    q = e * e
    t2 = b * omega_0
    P = k + t2
    M = k - t2
    p1 = horner(near, SERIES_1)
    p2 = horner(near, SERIES_2)
    t3 = 0.5 * (P + M * q) / np.where(t1, k, 1.0)
    y = np.where(t1, t3, 1.0 + p1 * near + p2 * b * far * omega_0)
    t4 = 0.0 < np.minimum(y, 9.869604401089358 + z)
    decay = np.where(t1, e, 1.0) / np.where(t4, y, 1.0)
    t5 = np.where(t1, M / np.where(t1, b, 1.0) * P, a - t2 * omega_0) * decay * decay
    return np.where(t4, t5, np.nan)


def frozen_angular_acceleration(a, b, omega_0, t, /, out=None, *, where=True):
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
    Domain: t >= 0, until the solution runs to infinity; elsewhere NaN and NumPy's ``invalid`` flag, of NaN
    without.
    Accuracy: at most 8 ulp times (1 + condition number) (sampled only: no certificate).
    Source: eq. (3.16) of the paper. Operations: 43 mul, 31 add, 2 sub, 4 div, 1 neg, 3 min, 2 max, 2 less, 8
    select, 2 abs, 1 exp, 2 sign, 2 sqrt.

    Examples
    --------
    >>> from generated.motion import frozen_angular_acceleration
    >>> print(f"{frozen_angular_acceleration(1.0, 1.0, 0.0, 0.5):.6f}")
    0.786448
    """
    return evaluate(
        'frozen_angular_acceleration',
        _frozen_angular_acceleration,
        lambda eps, a, b, omega_0, t: (
            np.isfinite(a)
            & np.isfinite(b)
            & np.isfinite(omega_0)
            & ((t >= 0.0)
            & np.isfinite(t))
        ),
        (1.0, 1.0, 0.0, 0.5),
        (a, b, omega_0, t),
        out,
        where,
    )


def _frozen_arrest_time(a: Array, b: Array, omega_0: Array) -> Array:
    t1 = np.sqrt(b)
    t2 = np.sqrt(-a)
    t3 = np.abs(t1 * omega_0) / np.abs(t2) < 8.673617379884035e-19
    t4 = np.where(t3, 1.0, t1 / t2 * omega_0)
    return -(np.where(t3, 1.0, np.arctan(t4) / t4) / a * omega_0)


def frozen_arrest_time(a, b, omega_0, /, out=None, *, where=True):
    """Time at which a braked motion stops.

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
    Domain: a < 0, b >= 0, omega_0 >= 0; elsewhere NaN and NumPy's ``invalid`` flag, of NaN without.
    Accuracy: at most 8 ulp times (1 + condition number) (sampled only: no certificate).
    Source: eq. (3.20) of the paper. Operations: 3 mul, 4 div, 2 neg, 1 less, 2 select, 2 abs, 1 arctan, 2 sqrt.

    Examples
    --------
    >>> from generated.motion import frozen_arrest_time
    >>> print(f"{frozen_arrest_time(-1.0, 1.0, 0.5):.6f}")
    0.463648
    """
    return evaluate(
        'frozen_arrest_time',
        _frozen_arrest_time,
        lambda eps, a, b, omega_0: (
            ((a < 0.0)
            & np.isfinite(a))
            & ((b >= 0.0)
            & np.isfinite(b))
            & ((omega_0 >= 0.0)
            & np.isfinite(omega_0))
        ),
        (-1.0, 1.0, 0.5),
        (a, b, omega_0),
        out,
        where,
    )


def _frozen_arrest_rotation(a: Array, b: Array, omega_0: Array) -> Array:
    t1 = b / a
    t2 = np.abs(t1) * omega_0 * omega_0 < 8.673617379884035e-19
    t3 = np.where(t2, 1.0, -(t1 * omega_0 * omega_0))
    return -(0.5 * np.where(t2, 1.0, np.log1p(t3) / t3) / a * omega_0 * omega_0)


def frozen_arrest_rotation(a, b, omega_0, /, out=None, *, where=True):
    """Rotation at which a braked motion stops.

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
    Domain: a < 0, b >= 0, omega_0 >= 0; elsewhere NaN and NumPy's ``invalid`` flag, of NaN without.
    Accuracy: at most 8 ulp times (1 + condition number) (sampled only: no certificate).
    Source: eq. (4.3) of the paper. Operations: 7 mul, 3 div, 2 neg, 1 less, 2 select, 1 abs, 1 log1p.

    Examples
    --------
    >>> from generated.motion import frozen_arrest_rotation
    >>> print(f"{frozen_arrest_rotation(-1.0, 1.0, 0.5):.6f}")
    0.111572
    """
    return evaluate(
        'frozen_arrest_rotation',
        _frozen_arrest_rotation,
        lambda eps, a, b, omega_0: (
            ((a < 0.0)
            & np.isfinite(a))
            & ((b >= 0.0)
            & np.isfinite(b))
            & ((omega_0 >= 0.0)
            & np.isfinite(omega_0))
        ),
        (-1.0, 1.0, 0.5),
        (a, b, omega_0),
        out,
        where,
    )
