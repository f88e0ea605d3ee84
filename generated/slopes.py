# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: 40e49a2353671207b16580dfd675e99bd0a2a6232bd6979ba9b44c25915b8346
"""The mass between an arc and a ground of straight edges, and the slices above an arc; lengths over R."""

from __future__ import annotations

from typing import Any

import numpy as np

from generated._evaluate import horner

__all__ = [
    "closed",
    "rings",
    "head",
    "drive",
    "ordinary_normal",
    "bishop_strength",
    "bishop_lever",
    "bishop_normal",
    "radial_weight",
    "radial_tilt",
]

# Edges up to REACH (r1 + r2) long are integrated by `rings` with Gauss' rule of NODES nodes, others by `closed`.
REACH, NODES = 0.25, 10


def closed(x: Any, y: Any, e_x: Any, e_y: Any, angle: Any) -> tuple[Any, Any, Any, Any, Any, Any, Any]:
    """Return the integrals over the ring between an edge and the arc under it: sector minus triangle.

    Of r dr dtheta, then of its products with r and r^2, with (cos, sin)(theta), and with r (cos, sin)(theta).

    Parameters
    ----------
    x : float or ndarray
        First end of the edge from the centre, horizontally, over R.
    y : float or ndarray
        First end of the edge from the centre, upwards, over R.
    e_x : float or ndarray
        From the first end to the second, horizontally, over R.
    e_y : float or ndarray
        From the first end to the second, upwards, over R.
    angle : float or ndarray
        From the first end to the second as seen from the centre, rad, counterclockwise positive.

    Returns
    -------
    tuple of ndarray
        area, polar, inertia, radial_x, radial_y, moment_x, moment_y, all over powers of R.

    Notes
    -----
    Accurate where the edge is longer than 1/4 (r1 + r2); `rings` elsewhere.
    No domain check; shapes broadcast.

    Examples
    --------
    >>> from generated.slopes import closed
    >>> print(f"{closed(-0.5, -0.6, 0.9, 0.1, 1.3695)[0]:.6f}")
    0.439750
    """
    t1 = e_y * x - e_x * y
    t2 = e_x + x
    t3 = e_y + y
    t4 = t2 * e_x + t3 * e_y
    e_x_2 = e_x * e_x
    e_y_2 = e_y * e_y
    t5 = e_x_2 + e_y_2
    t6 = np.sqrt(t5)
    t7 = e_x * x + e_y * y
    t8 = t7 / t6 + t4 / t6
    x_2 = x * x
    y_2 = y * y
    t9 = np.sqrt(x_2 + y_2)
    t10 = np.sqrt(t2 * t2 + t3 * t3)
    t11 = t9 + t10
    t12 = t1 * t1
    t13 = t12 * np.arctanh(np.minimum(0.9999999999999999, t6 / t11))
    t14 = (0.25 * t4 / t6 - 0.25 * t7 / t6) * (t8 * t8 / t11 + t9 + t10) + t13 / t5
    t15 = t1 * (t7 * t7 / t5 + t4 * t4 / t5 + t7 * t4 / t5) / 12.0
    t16 = 0.5 / t9
    t17 = t13 / (t5 * t6)
    t18 = 0.5 * t1 * t8 / (t6 * t11)
    t19 = 3.0 * t10
    t20 = 3.0 * t9
    t21 = t12 / (3.0 * t5)
    t22 = t1 * t8 / (6.0 * t6)
    return (0.5 * angle + 0.5 * e_x * y - 0.5 * e_y * x, angle / 3.0 - t1 * t14 / (3.0 * t6),
        0.25 * angle - 0.25 * (t1 * t12) / t5 - t15, 0.5 * t3 / t10 - t16 * y - t17 * e_y - t18 * e_x,
        t16 * x + t17 * e_x - 0.5 * t2 / t10 - t18 * e_y, t3 / t19 - y / t20 - t21 * e_y - t22 * e_x,
        x / t20 + t21 * e_x - t2 / t19 - t22 * e_y)


def rings(g: Any) -> tuple[Any, Any, Any, Any, Any]:
    """Return the integrands, over s from 0 to 1 along an edge, of the integrals over a ring; divided by P1 x e.

    (1 - rho^n)/(n rho^2) for n = 2, 3, 4, then (1 - rho^n)/(n rho^3) for n = 2, 3, to be times the point itself.

    Parameters
    ----------
    g : float or ndarray
        1 - rho^2 of a point of the edge, rho its distance from the centre over R; below 1.

    Returns
    -------
    tuple of ndarray
        area, polar, inertia, radial, moment.

    Notes
    -----
    With g = (1-s) g1 + s g2 + s (1-s) d^2 and Gauss' rule of 10 nodes: accurate however thin the ring, where the
    edge is at most 1/4 (r1 + r2) long.
    No domain check; shapes broadcast.

    Examples
    --------
    >>> from generated.slopes import rings
    >>> print(f"{rings(0.39)[0]:.6f}")
    0.319672
    """
    b = 1.0 - g
    t1 = np.sqrt(b)
    t2 = 2.0 + t1 - g
    t3 = 3.0 + 3.0 * t1
    b_2 = 2.0 - g
    t4 = b * t1
    return 0.5 / b * g, t2 / (b * t3) * g, 0.25 * b_2 / b * g, 0.5 / t4 * g, t2 / (t4 * t3) * g


def head(angle: Any, sine: Any, cosine: Any, height: Any, slope: Any) -> Any:
    """Return the integral of the height of a line above the arc, from a point of the arc over an angle.

    height a + (slope cos - sin) (1 - cos(a)) - (slope sin + cos) (a - sin(a)), a the angle, sin and cos the
    point's.

    Parameters
    ----------
    angle : float or ndarray
        From the first end to the second as seen from the centre, rad, counterclockwise positive.
    sine : float or ndarray
        sin(beta), beta from straight below the centre, positive down-slope.
    cosine : float or ndarray
        cos(beta).
    height : float or ndarray
        Of the slice, from the arc up to the ground, over R.
    slope : float or ndarray
        Of that line, its rise over a run to the right.

    Returns
    -------
    float or ndarray
        Over R.

    Notes
    -----
    Over at most pi; accurate however near the line and however steep.
    No domain check; shapes broadcast.

    Examples
    --------
    >>> from generated.slopes import head
    >>> print(f"{head(1.3695, 0.5, 0.866, 0.2, 0.5):.6f}")
    -0.214600
    """
    t1 = np.sin(0.5 * angle)
    angle_2 = angle * angle
    p1 = horner(angle_2, (-0.16666666666666666, 0.008333333333333333, -0.0001984126984126984,
        2.7557319223985893e-06, -2.505210838544172e-08, 1.6059043836821613e-10, -7.647163731819816e-13,
        2.8114572543455206e-15, -8.22063524662433e-18, 1.9572941063391263e-20, -3.868170170630684e-23,
        6.446950284384474e-26, -9.183689863795546e-29))
    t2 = angle * height + 2.0 * (cosine * slope - sine) * (t1 * t1)
    return t2 + (cosine + sine * slope) * p1 * angle * angle * angle


def drive(sine: Any, cosine: Any, height: Any, k_h: Any) -> Any:
    """Return the driving moment of the slices about the centre, over dbeta and gamma R^3.

    Weight and k_h times it, at half the slice's height.

    Parameters
    ----------
    sine : float or ndarray
        sin(beta), beta from straight below the centre, positive down-slope.
    cosine : float or ndarray
        cos(beta).
    height : float or ndarray
        Of the slice, from the arc up to the ground, over R.
    k_h : float or ndarray
        Horizontal acceleration over g, positive where it drives.

    Returns
    -------
    float or ndarray
        Positive down-slope.

    Notes
    -----
    No domain check; shapes broadcast.

    Examples
    --------
    >>> from generated.slopes import drive
    >>> print(f"{drive(0.5, 0.866, 0.2, 0.1):.6f}")
    -0.073333
    """
    return 0.5 * (2.0 * cosine * k_h - 2.0 * sine - height * k_h) * cosine * height


def ordinary_normal(sine: Any, cosine: Any, height: Any, pressure: Any, k_h: Any) -> Any:
    """Return the effective normal stress of the ordinary method (Fellenius), over gamma R.

    The forces between slices have no component along the radius: N' = W (cos a - k_h sin a) - u l.

    Parameters
    ----------
    sine : float or ndarray
        sin(beta), beta from straight below the centre, positive down-slope.
    cosine : float or ndarray
        cos(beta).
    height : float or ndarray
        Of the slice, from the arc up to the ground, over R.
    pressure : float or ndarray
        Pore pressure on the arc over gamma R.
    k_h : float or ndarray
        Horizontal acceleration over g, positive where it drives.

    Returns
    -------
    float or ndarray
        May be negative.

    Notes
    -----
    No domain check; shapes broadcast.

    Examples
    --------
    >>> from generated.slopes import ordinary_normal
    >>> print(f"{ordinary_normal(0.5, 0.866, 0.2, 0.05, 0.1):.6f}")
    0.108651
    """
    return (cosine + k_h * sine) * cosine * height - pressure


def bishop_strength(cosine: Any, height: Any, pressure: Any, cohesion: Any, mu: Any) -> Any:
    """Return the strength of Bishop's simplified method times its lever, over gamma R.

    (c + mu (h - u)) cos(beta).

    Parameters
    ----------
    cosine : float or ndarray
        cos(beta).
    height : float or ndarray
        Of the slice, from the arc up to the ground, over R.
    pressure : float or ndarray
        Pore pressure on the arc over gamma R.
    cohesion : float or ndarray
        Over gamma R.
    mu : float or ndarray
        Friction coefficient, tan(phi).

    Returns
    -------
    float or ndarray
        Strength is this over `bishop_lever`.

    Notes
    -----
    No domain check; shapes broadcast.

    Examples
    --------
    >>> from generated.slopes import bishop_strength
    >>> print(f"{bishop_strength(0.866, 0.2, 0.05, 0.03, 0.4):.6f}")
    0.077940
    """
    return (cohesion + (height - pressure) * mu) * cosine


def bishop_lever(sine: Any, cosine: Any, mu: Any, factor: Any) -> Any:
    """Return m_alpha of Bishop's simplified method.

    cos(beta) - sin(beta) mu/F.

    Parameters
    ----------
    sine : float or ndarray
        sin(beta), beta from straight below the centre, positive down-slope.
    cosine : float or ndarray
        cos(beta).
    mu : float or ndarray
        Friction coefficient, tan(phi).
    factor : float or ndarray
        Factor of safety, above 0.

    Returns
    -------
    float or ndarray
        Below 0.05 the method is of no use.

    Notes
    -----
    No domain check; shapes broadcast.

    Examples
    --------
    >>> from generated.slopes import bishop_lever
    >>> print(f"{bishop_lever(0.5, 0.866, 0.4, 1.2):.6f}")
    0.699333
    """
    return cosine - mu / factor * sine


def bishop_normal(sine: Any, cosine: Any, height: Any, pressure: Any, cohesion: Any, mu: Any, factor: Any) -> Any:
    """Return the effective normal stress of Bishop's simplified method, over gamma R.

    From the vertical balance of a slice that carries no vertical force to its neighbours.

    Parameters
    ----------
    sine : float or ndarray
        sin(beta), beta from straight below the centre, positive down-slope.
    cosine : float or ndarray
        cos(beta).
    height : float or ndarray
        Of the slice, from the arc up to the ground, over R.
    pressure : float or ndarray
        Pore pressure on the arc over gamma R.
    cohesion : float or ndarray
        Over gamma R.
    mu : float or ndarray
        Friction coefficient, tan(phi).
    factor : float or ndarray
        Factor of safety, above 0.

    Returns
    -------
    float or ndarray
        May be negative.

    Notes
    -----
    No domain check; shapes broadcast.

    Examples
    --------
    >>> from generated.slopes import bishop_normal
    >>> print(f"{bishop_normal(0.5, 0.866, 0.2, 0.05, 0.03, 0.4, 1.2):.6f}")
    0.203622
    """
    return ((height - pressure) * cosine + cohesion / factor * sine) / (cosine - mu / factor * sine)


def radial_weight(cosine: Any, distance: Any) -> Any:
    """Return the weight along the radius (2.23) by strips above the arc, over dbeta and gamma R^2.

    Integral of the cosine of a point's angle from straight below the centre, over a strip.

    Parameters
    ----------
    cosine : float or ndarray
        cos(beta).
    distance : float or ndarray
        Of the ground above the arc's point, from the centre, over R.

    Returns
    -------
    float or ndarray
        Its integral over the arc is J_r, of the paper's mean normal stress.

    Notes
    -----
    No domain check; shapes broadcast.

    Examples
    --------
    >>> from generated.slopes import radial_weight
    >>> print(f"{radial_weight(0.866, 0.7):.6f}")
    0.259800
    """
    b = 1.0 - distance
    return b * cosine


def radial_tilt(sine: Any, cosine: Any, height: Any, distance: Any) -> Any:
    """Return the contribution of a unit of k_h to `radial_weight`.

    Integral of the sine of a point's angle from straight below the centre, over a strip.

    Parameters
    ----------
    sine : float or ndarray
        sin(beta), beta from straight below the centre, positive down-slope.
    cosine : float or ndarray
        cos(beta).
    height : float or ndarray
        Of the slice, from the arc up to the ground, over R.
    distance : float or ndarray
        Of the ground above the arc's point, from the centre, over R.

    Returns
    -------
    float or ndarray
        Its integral over the arc is dJ_r/dpsi.

    Notes
    -----
    No domain check; shapes broadcast.

    Examples
    --------
    >>> from generated.slopes import radial_tilt
    >>> print(f"{radial_tilt(0.5, 0.866, 0.2, 0.7):.6f}")
    0.135057
    """
    return np.log((1.0 + cosine) / (cosine + distance - height)) * cosine * sine
