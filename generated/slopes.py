# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: 15f12ff389b39d91546b4de4dd996e499be20cc104a506371edb2d3369da90b8
"""The mass between an arc and a ground of straight edges, and the slices above an arc; lengths over R."""

from typing import Any

import numpy as np

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
    """Integrals over the ring between an edge and the arc under it: sector minus triangle.

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
    Operations: 53 mul, 17 add, 16 sub, 25 div, 1 min, 1 arctanh, 3 sqrt. No domain check; shapes broadcast.
    """
    v12 = 0.5 * angle + 0.5 * e_x * y - 0.5 * e_y * x
    v17 = e_y * x - e_x * y
    v19 = e_x + x
    v21 = e_y + y
    v23 = v19 * e_x + v21 * e_y
    v27 = e_x * e_x + e_y * e_y
    v28 = np.sqrt(v27)
    v32 = e_x * x + e_y * y
    v38 = v32 / v28 + v23 / v28
    v43 = np.sqrt(x * x + y * y)
    v47 = np.sqrt(v19 * v19 + v21 * v21)
    v48 = v43 + v47
    v53 = v17 * v17
    v58 = v53 * np.arctanh(np.minimum(0.9999999999999999, v28 / v48))
    v63 = v17 * ((0.25 * v23 / v28 - 0.25 * v32 / v28) * (v38 * v38 / v48 + v43 + v47) + v58 / v27) / (3.0 * v28)
    v64 = angle / 3.0 - v63
    v81 = 0.25 * angle - 0.25 * (v17 * v53) / v27 - v17 * (v32 * v32 / v27 + v23 * v23 / v27 + v32 * v23 / v27) / 12.0
    v84 = 0.5 / v43
    v88 = v58 / (v27 * v28)
    v94 = 0.5 * v17 * v38 / (v28 * v48)
    v96 = 0.5 * v21 / v47 - v84 * y - v88 * e_y - v94 * e_x
    v104 = v84 * x + v88 * e_x - 0.5 * v19 / v47 - v94 * e_y
    v105 = 3.0 * v47
    v107 = 3.0 * v43
    v111 = v53 / (3.0 * v27)
    v117 = v17 * v38 / (6.0 * v28)
    v119 = v21 / v105 - y / v107 - v111 * e_y - v117 * e_x
    v126 = x / v107 + v111 * e_x - v19 / v105 - v117 * e_y
    return v12, v64, v81, v96, v104, v119, v126


def rings(g: Any) -> tuple[Any, Any, Any, Any, Any]:
    """What the integrals over a ring grow by along its edge, over P1 x e: for quadrature over s from 0 to 1.

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
    Operations: 10 mul, 2 add, 3 sub, 5 div, 1 sqrt. No domain check; shapes broadcast.
    """
    v3 = 1.0 - g
    v5 = 0.5 / v3 * g
    v7 = np.sqrt(v3)
    v9 = 2.0 + v7 - g
    v12 = 3.0 + 3.0 * v7
    v15 = v9 / (v3 * v12) * g
    v20 = 0.25 * (2.0 - g) / v3 * g
    v21 = v3 * v7
    v23 = 0.5 / v21 * g
    v26 = v9 / (v21 * v12) * g
    return v5, v15, v20, v23, v26


def head(sine: Any, cosine: Any, beta: Any, offset: Any, slope: Any) -> Any:
    """Integral over beta of the height of a line above the arc.

    offset beta - slope cos(beta) + sin(beta), up to a constant.

    Parameters
    ----------
    sine : float or ndarray
        sin(beta), beta from straight below the centre, positive down-slope.
    cosine : float or ndarray
        cos(beta).
    beta : float or ndarray
        Angle from straight below the centre, rad.
    offset : float or ndarray
        Height of a line straight below the centre, from the centre up, over R.
    slope : float or ndarray
        Of that line, its rise over a run to the right.

    Returns
    -------
    float or ndarray
        Over R.

    Notes
    -----
    Operations: 2 mul, 1 add, 1 sub. No domain check; shapes broadcast.
    """
    v8 = sine + beta * offset - cosine * slope
    return v8


def drive(sine: Any, cosine: Any, height: Any, k_h: Any) -> Any:
    """Driving moment of the slices about the centre, over dbeta and gamma R^3.

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
    Operations: 7 mul, 2 sub. No domain check; shapes broadcast.
    """
    v14 = 0.5 * (2.0 * cosine * k_h - 2.0 * sine - height * k_h) * cosine * height
    return v14


def ordinary_normal(sine: Any, cosine: Any, height: Any, pressure: Any, k_h: Any) -> Any:
    """Effective normal stress of the ordinary method (Fellenius), over gamma R.

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
    Operations: 3 mul, 1 add, 1 sub. No domain check; shapes broadcast.
    """
    v9 = (cosine + k_h * sine) * cosine * height - pressure
    return v9


def bishop_strength(cosine: Any, height: Any, pressure: Any, cohesion: Any, mu: Any) -> Any:
    """Strength of Bishop's simplified method times its lever, over gamma R.

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
    Operations: 2 mul, 1 add, 1 sub. No domain check; shapes broadcast.
    """
    v8 = (cohesion + (height - pressure) * mu) * cosine
    return v8


def bishop_lever(sine: Any, cosine: Any, mu: Any, factor: Any) -> Any:
    """m_alpha of Bishop's simplified method.

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
    Operations: 1 mul, 1 sub, 1 div. No domain check; shapes broadcast.
    """
    v6 = cosine - mu / factor * sine
    return v6


def bishop_normal(sine: Any, cosine: Any, height: Any, pressure: Any, cohesion: Any, mu: Any, factor: Any) -> Any:
    """Effective normal stress of Bishop's simplified method, over gamma R.

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
    Operations: 3 mul, 1 add, 2 sub, 3 div. No domain check; shapes broadcast.
    """
    v15 = ((height - pressure) * cosine + cohesion / factor * sine) / (cosine - mu / factor * sine)
    return v15


def radial_weight(cosine: Any, distance: Any) -> Any:
    """Weight along the radius (2.23) by strips above the arc, over dbeta and gamma R^2.

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
    Operations: 1 mul, 1 sub. No domain check; shapes broadcast.
    """
    v4 = (1.0 - distance) * cosine
    return v4


def radial_tilt(sine: Any, cosine: Any, height: Any, distance: Any) -> Any:
    """What a unit of k_h adds to `radial_weight`.

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
    Operations: 2 mul, 2 add, 1 sub, 1 div, 1 log. No domain check; shapes broadcast.
    """
    v11 = np.log((1.0 + cosine) / (cosine + distance - height)) * cosine * sine
    return v11
