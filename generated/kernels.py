# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: 9c9f21d6d77b632fffece75249217b2eb0c7cee422a7d489bac0ce2056af2663
"""Moments, weights and quotients of the arc, from their definitions."""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from generated._evaluate import Array, evaluate

__all__ = [
    "polar_moment",
    "moment_of_inertia",
    "radial_weight_amplitude",
    "weight_moment_amplitude",
    "resistance_factor",
    "dynamic_coefficient",
    "weight_moment_per_inertia",
    "radial_weight_per_inertia",
    "polar_moment_per_inertia",
    "weight_moment_per_radial_weight",
    "radial_weight",
    "weight_moment",
    "limit_friction",
]


def _polar_moment(alpha: Array) -> Array:
    v2 = np.minimum(1.5707963267948966, alpha)
    v4 = v2 * v2
    v14 = ((1.9572941063391263e-20 * v4 + -8.22063524662433e-18) * v4 + 2.8114572543455206e-15) * v4 + -7.647163731819816e-13
    v23 = ((v14 * v4 + 1.6059043836821613e-10) * v4 + -2.505210838544172e-08) * v4 + 2.7557319223985893e-06
    v33 = (((v23 * v4 + -0.0001984126984126984) * v4 + 0.008333333333333333) * v4 + -0.16666666666666666) * v4
    v34 = v33 + 1.0
    v35 = np.cos(v2)
    v38 = v34 / (1.0 + v35) * v2
    v39 = v38 * v38
    v42 = 1.0 - v39
    v45 = np.minimum(0.4, v38)
    v46 = v45 * v45
    v56 = ((0.024390243902439025 * v46 + 0.02564102564102564) * v46 + 0.02702702702702703) * v46 + 0.02857142857142857
    v66 = (((v56 * v46 + 0.030303030303030304) * v46 + 0.03225806451612903) * v46 + 0.034482758620689655) * v46
    v77 = (((v66 + 0.037037037037037035) * v46 + 0.04) * v46 + 0.043478260869565216) * v46 + 0.047619047619047616
    v87 = (((v77 * v46 + 0.05263157894736842) * v46 + 0.058823529411764705) * v46 + 0.06666666666666667) * v46
    v98 = (((v87 + 0.07692307692307693) * v46 + 0.09090909090909091) * v46 + 0.1111111111111111) * v46 + 0.14285714285714285
    v109 = np.minimum(0.9999999999999999, np.maximum(0.4, v38))
    v120 = np.where(v38 < 0.4, (v98 * v46 + 0.2) * v46 + 0.3333333333333333, (0.5 * np.log1p(2.0 * v109 / (1.0 - v109)) - v109) / (v109 * (v109 * v109)))
    v134 = 4.0 * v2 * v2
    v144 = ((9.183689863795546e-29 * v134 + -6.446950284384474e-26) * v134 + 3.868170170630684e-23) * v134 + -1.9572941063391263e-20
    v153 = ((v144 * v134 + 8.22063524662433e-18) * v134 + -2.8114572543455206e-15) * v134 + 7.647163731819816e-13
    v162 = ((v153 * v134 + -1.6059043836821613e-10) * v134 + 2.505210838544172e-08) * v134 + -2.7557319223985893e-06
    v171 = ((v162 * v134 + 0.0001984126984126984) * v134 + -0.008333333333333333) * v134 + 0.16666666666666666
    v173 = (1.0 + v39) * (3.0 - v42 * v42 * v120 - v39) * v35 * (v34 * (v34 * v34)) / 12.0 + 2.6666666666666665 * v171
    v176 = v173 * v2 * v2 * v2
    return v176


def polar_moment(alpha: ArrayLike, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True) -> Any:
    """I_p*: polar surface moment of inertia of the moving mass, dimensionless.

    I_p* = (2*alpha - sin(alpha)*cos(alpha) - cos(alpha)**3*atanh(sin(alpha)))/3

    Parameters
    ----------
    alpha : array_like
        Half the opening angle of the arc, rad.
    out : ndarray, optional
        Where the result goes.
    where : array_like of bool, optional
        Lanes to compute; others keep what `out` holds (NaN without `out`).

    Returns
    -------
    ndarray or scalar
        I_p*. Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32.

    Notes
    -----
    Domain: 0 <= alpha <= pi/2 (1 + 4 eps), with the limits at both ends; elsewhere NaN and NumPy's ``invalid``
    flag.
    Accuracy: at most 16 ulp (sampled only: no certificate).
    Source: eq. (2.17) of the paper. Operations: 62 mul, 44 add, 5 sub, 4 div, 3 min, 1 max, 1 less, 1 select, 1
    cos, 1 log1p.
    """
    return evaluate(_polar_moment, lambda eps, alpha: (alpha >= 0.0) & (alpha <= 1.5707963267948966 * (1.0 + 4.0 * eps)), (0.5,), (alpha,), out, where)


def _moment_of_inertia(alpha: Array) -> Array:
    v2 = np.minimum(1.5707963267948966, alpha)
    v4 = v2 * v2
    v14 = ((1.9572941063391263e-20 * v4 + -8.22063524662433e-18) * v4 + 2.8114572543455206e-15) * v4 + -7.647163731819816e-13
    v23 = ((v14 * v4 + 1.6059043836821613e-10) * v4 + -2.505210838544172e-08) * v4 + 2.7557319223985893e-06
    v33 = (((v23 * v4 + -0.0001984126984126984) * v4 + 0.008333333333333333) * v4 + -0.16666666666666666) * v4
    v35 = v33 + 1.0
    v44 = 4.0 * v2 * v2
    v54 = ((9.183689863795546e-29 * v44 + -6.446950284384474e-26) * v44 + 3.868170170630684e-23) * v44 + -1.9572941063391263e-20
    v63 = ((v54 * v44 + 8.22063524662433e-18) * v44 + -2.8114572543455206e-15) * v44 + 7.647163731819816e-13
    v72 = ((v63 * v44 + -1.6059043836821613e-10) * v44 + 2.505210838544172e-08) * v44 + -2.7557319223985893e-06
    v82 = 2.0 * (((v72 * v44 + 0.0001984126984126984) * v44 + -0.008333333333333333) * v44 + 0.16666666666666666)
    v86 = (np.cos(v2) * (v35 * (v35 * v35)) / 3.0 + v82) * v2 * v2 * v2
    return v86


def moment_of_inertia(alpha: ArrayLike, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True) -> Any:
    """Theta*: moment of inertia of the moving mass about the centre, dimensionless.

    Theta* = alpha/2 - sin(2*alpha)/6 - sin(4*alpha)/24

    Parameters
    ----------
    alpha : array_like
        Half the opening angle of the arc, rad.
    out : ndarray, optional
        Where the result goes.
    where : array_like of bool, optional
        Lanes to compute; others keep what `out` holds (NaN without `out`).

    Returns
    -------
    ndarray or scalar
        Theta*. Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32.

    Notes
    -----
    Domain: 0 <= alpha <= pi/2 (1 + 4 eps), with the limits at both ends; elsewhere NaN and NumPy's ``invalid``
    flag.
    Accuracy: at most 16 ulp (sampled only: no certificate).
    Source: eq. (3.12) of the paper. Operations: 32 mul, 23 add, 1 div, 1 min, 1 cos.
    """
    return evaluate(_moment_of_inertia, lambda eps, alpha: (alpha >= 0.0) & (alpha <= 1.5707963267948966 * (1.0 + 4.0 * eps)), (0.5,), (alpha,), out, where)


def _radial_weight_amplitude(alpha: Array) -> Array:
    v2 = np.minimum(1.5707963267948966, alpha)
    v5 = v2 * v2
    v15 = ((1.9572941063391263e-20 * v5 + -8.22063524662433e-18) * v5 + 2.8114572543455206e-15) * v5 + -7.647163731819816e-13
    v24 = ((v15 * v5 + 1.6059043836821613e-10) * v5 + -2.505210838544172e-08) * v5 + 2.7557319223985893e-06
    v34 = (((v24 * v5 + -0.0001984126984126984) * v5 + 0.008333333333333333) * v5 + -0.16666666666666666) * v5
    v35 = v34 + 1.0
    v39 = v35 / (1.0 + np.cos(v2)) * v2
    v40 = v39 * v39
    v43 = 1.0 - v40
    v46 = np.minimum(0.4, v39)
    v47 = v46 * v46
    v57 = ((0.024390243902439025 * v47 + 0.02564102564102564) * v47 + 0.02702702702702703) * v47 + 0.02857142857142857
    v67 = (((v57 * v47 + 0.030303030303030304) * v47 + 0.03225806451612903) * v47 + 0.034482758620689655) * v47
    v78 = (((v67 + 0.037037037037037035) * v47 + 0.04) * v47 + 0.043478260869565216) * v47 + 0.047619047619047616
    v88 = (((v78 * v47 + 0.05263157894736842) * v47 + 0.058823529411764705) * v47 + 0.06666666666666667) * v47
    v99 = (((v88 + 0.07692307692307693) * v47 + 0.09090909090909091) * v47 + 0.1111111111111111) * v47 + 0.14285714285714285
    v110 = np.minimum(0.9999999999999999, np.maximum(0.4, v39))
    v121 = np.where(v39 < 0.4, (v99 * v47 + 0.2) * v47 + 0.3333333333333333, (0.5 * np.log1p(2.0 * v110 / (1.0 - v110)) - v110) / (v110 * (v110 * v110)))
    v132 = 0.25 * (1.0 + v40) * (3.0 - v43 * v43 * v121 - v40) * (v35 * (v35 * v35)) * v2 * v2 * v2
    return v132


def radial_weight_amplitude(alpha: ArrayLike, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True) -> Any:
    """C_r: weight of the moving mass along the radius, dimensionless.

    C_r = sin(alpha) - cos(alpha)**2*atanh(sin(alpha))

    Parameters
    ----------
    alpha : array_like
        Half the opening angle of the arc, rad.
    out : ndarray, optional
        Where the result goes.
    where : array_like of bool, optional
        Lanes to compute; others keep what `out` holds (NaN without `out`).

    Returns
    -------
    ndarray or scalar
        C_r. Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32.

    Notes
    -----
    Domain: 0 <= alpha <= pi/2 (1 + 4 eps), with the limits at both ends; elsewhere NaN and NumPy's ``invalid``
    flag.
    Accuracy: at most 16 ulp (sampled only: no certificate).
    Source: eq. (2.23) of the paper. Operations: 47 mul, 31 add, 5 sub, 3 div, 3 min, 1 max, 1 less, 1 select, 1
    cos, 1 log1p.
    """
    return evaluate(_radial_weight_amplitude, lambda eps, alpha: (alpha >= 0.0) & (alpha <= 1.5707963267948966 * (1.0 + 4.0 * eps)), (0.5,), (alpha,), out, where)


def _weight_moment_amplitude(alpha: Array) -> Array:
    v2 = np.minimum(1.5707963267948966, alpha)
    v4 = v2 * v2
    v14 = ((1.9572941063391263e-20 * v4 + -8.22063524662433e-18) * v4 + 2.8114572543455206e-15) * v4 + -7.647163731819816e-13
    v23 = ((v14 * v4 + 1.6059043836821613e-10) * v4 + -2.505210838544172e-08) * v4 + 2.7557319223985893e-06
    v33 = (((v23 * v4 + -0.0001984126984126984) * v4 + 0.008333333333333333) * v4 + -0.16666666666666666) * v4
    v35 = v33 + 1.0
    v41 = 0.6666666666666666 * (v35 * (v35 * v35)) * v2 * v2 * v2
    return v41


def weight_moment_amplitude(alpha: ArrayLike, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True) -> Any:
    """C_theta: moment of the weight about the centre, dimensionless.

    C_theta = 2*sin(alpha)**3/3

    Parameters
    ----------
    alpha : array_like
        Half the opening angle of the arc, rad.
    out : ndarray, optional
        Where the result goes.
    where : array_like of bool, optional
        Lanes to compute; others keep what `out` holds (NaN without `out`).

    Returns
    -------
    ndarray or scalar
        C_theta. Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32.

    Notes
    -----
    Domain: 0 <= alpha <= pi/2 (1 + 4 eps), with the limits at both ends; elsewhere NaN and NumPy's ``invalid``
    flag.
    Accuracy: at most 16 ulp (sampled only: no certificate).
    Source: eq. (3.13) of the paper. Operations: 17 mul, 10 add, 1 min.
    """
    return evaluate(_weight_moment_amplitude, lambda eps, alpha: (alpha >= 0.0) & (alpha <= 1.5707963267948966 * (1.0 + 4.0 * eps)), (0.5,), (alpha,), out, where)


def _resistance_factor(alpha: Array) -> Array:
    v2 = np.minimum(1.5707963267948966, alpha)
    v5 = 0.25 * v2 * v2
    v15 = ((1.9572941063391263e-20 * v5 + -8.22063524662433e-18) * v5 + 2.8114572543455206e-15) * v5 + -7.647163731819816e-13
    v24 = ((v15 * v5 + 1.6059043836821613e-10) * v5 + -2.505210838544172e-08) * v5 + 2.7557319223985893e-06
    v34 = (((v24 * v5 + -0.0001984126984126984) * v5 + 0.008333333333333333) * v5 + -0.16666666666666666) * v5
    v36 = v34 + 1.0
    v40 = v36 * v36 * v2 * v2 * v2
    return v40


def resistance_factor(alpha: ArrayLike, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True) -> Any:
    """lambda: lever of the resistance, arc length times depth, dimensionless.

    lambda = 2*alpha*(1 - cos(alpha))

    Parameters
    ----------
    alpha : array_like
        Half the opening angle of the arc, rad.
    out : ndarray, optional
        Where the result goes.
    where : array_like of bool, optional
        Lanes to compute; others keep what `out` holds (NaN without `out`).

    Returns
    -------
    ndarray or scalar
        lambda. Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32.

    Notes
    -----
    Domain: 0 <= alpha <= pi/2 (1 + 4 eps), with the limits at both ends; elsewhere NaN and NumPy's ``invalid``
    flag.
    Accuracy: at most 16 ulp (sampled only: no certificate).
    Source: eq. (3.14) of the paper. Operations: 16 mul, 10 add, 1 min.
    """
    return evaluate(_resistance_factor, lambda eps, alpha: (alpha >= 0.0) & (alpha <= 1.5707963267948966 * (1.0 + 4.0 * eps)), (0.5,), (alpha,), out, where)


def _dynamic_coefficient(alpha: Array) -> Array:
    v2 = np.minimum(1.5707963267948966, alpha)
    v4 = v2 * v2
    v14 = ((1.9572941063391263e-20 * v4 + -8.22063524662433e-18) * v4 + 2.8114572543455206e-15) * v4 + -7.647163731819816e-13
    v23 = ((v14 * v4 + 1.6059043836821613e-10) * v4 + -2.505210838544172e-08) * v4 + 2.7557319223985893e-06
    v33 = (((v23 * v4 + -0.0001984126984126984) * v4 + 0.008333333333333333) * v4 + -0.16666666666666666) * v4
    v34 = v33 + 1.0
    v35 = np.cos(v2)
    v38 = v34 / (1.0 + v35) * v2
    v39 = v38 * v38
    v42 = 1.0 - v39
    v45 = np.minimum(0.4, v38)
    v46 = v45 * v45
    v56 = ((0.024390243902439025 * v46 + 0.02564102564102564) * v46 + 0.02702702702702703) * v46 + 0.02857142857142857
    v66 = (((v56 * v46 + 0.030303030303030304) * v46 + 0.03225806451612903) * v46 + 0.034482758620689655) * v46
    v77 = (((v66 + 0.037037037037037035) * v46 + 0.04) * v46 + 0.043478260869565216) * v46 + 0.047619047619047616
    v87 = (((v77 * v46 + 0.05263157894736842) * v46 + 0.058823529411764705) * v46 + 0.06666666666666667) * v46
    v98 = (((v87 + 0.07692307692307693) * v46 + 0.09090909090909091) * v46 + 0.1111111111111111) * v46 + 0.14285714285714285
    v109 = np.minimum(0.9999999999999999, np.maximum(0.4, v38))
    v120 = np.where(v38 < 0.4, (v98 * v46 + 0.2) * v46 + 0.3333333333333333, (0.5 * np.log1p(2.0 * v109 / (1.0 - v109)) - v109) / (v109 * (v109 * v109)))
    v134 = 4.0 * v2 * v2
    v144 = ((9.183689863795546e-29 * v134 + -6.446950284384474e-26) * v134 + 3.868170170630684e-23) * v134 + -1.9572941063391263e-20
    v153 = ((v144 * v134 + 8.22063524662433e-18) * v134 + -2.8114572543455206e-15) * v134 + 7.647163731819816e-13
    v162 = ((v153 * v134 + -1.6059043836821613e-10) * v134 + 2.505210838544172e-08) * v134 + -2.7557319223985893e-06
    v171 = ((v162 * v134 + 0.0001984126984126984) * v134 + -0.008333333333333333) * v134 + 0.16666666666666666
    v173 = (1.0 + v39) * (3.0 - v42 * v42 * v120 - v39) * v35 * (v34 * (v34 * v34)) / 12.0 + 2.6666666666666665 * v171
    v176 = 0.25 * v2 * v2
    v181 = ((1.9572941063391263e-20 * v176 + -8.22063524662433e-18) * v176 + 2.8114572543455206e-15) * v176
    v186 = ((v181 + -7.647163731819816e-13) * v176 + 1.6059043836821613e-10) * v176 + -2.505210838544172e-08
    v192 = ((v186 * v176 + 2.7557319223985893e-06) * v176 + -0.0001984126984126984) * v176 + 0.008333333333333333
    v196 = (v192 * v176 + -0.16666666666666666) * v176 + 1.0
    v198 = v173 / (v196 * v196)
    return v198


def dynamic_coefficient(alpha: ArrayLike, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True) -> Any:
    """A: share of the centripetal term in the mean normal stress, dimensionless.

    A = polar_moment(alpha)/resistance_factor(alpha), finite at alpha = 0 where both vanish.

    Parameters
    ----------
    alpha : array_like
        Half the opening angle of the arc, rad.
    out : ndarray, optional
        Where the result goes.
    where : array_like of bool, optional
        Lanes to compute; others keep what `out` holds (NaN without `out`).

    Returns
    -------
    ndarray or scalar
        A. Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32.

    Notes
    -----
    Domain: 0 <= alpha <= pi/2 (1 + 4 eps), with the limits at both ends; elsewhere NaN and NumPy's ``invalid``
    flag.
    Accuracy: at most 16 ulp (sampled only: no certificate).
    Source: eq. (2.24) of the paper. Operations: 72 mul, 54 add, 5 sub, 5 div, 3 min, 1 max, 1 less, 1 select, 1
    cos, 1 log1p.
    """
    return evaluate(_dynamic_coefficient, lambda eps, alpha: (alpha >= 0.0) & (alpha <= 1.5707963267948966 * (1.0 + 4.0 * eps)), (0.5,), (alpha,), out, where)


def _weight_moment_per_inertia(alpha: Array) -> Array:
    v2 = np.minimum(1.5707963267948966, alpha)
    v4 = v2 * v2
    v14 = ((1.9572941063391263e-20 * v4 + -8.22063524662433e-18) * v4 + 2.8114572543455206e-15) * v4 + -7.647163731819816e-13
    v23 = ((v14 * v4 + 1.6059043836821613e-10) * v4 + -2.505210838544172e-08) * v4 + 2.7557319223985893e-06
    v33 = (((v23 * v4 + -0.0001984126984126984) * v4 + 0.008333333333333333) * v4 + -0.16666666666666666) * v4
    v35 = v33 + 1.0
    v37 = v35 * (v35 * v35)
    v46 = 4.0 * v2 * v2
    v56 = ((9.183689863795546e-29 * v46 + -6.446950284384474e-26) * v46 + 3.868170170630684e-23) * v46 + -1.9572941063391263e-20
    v65 = ((v56 * v46 + 8.22063524662433e-18) * v46 + -2.8114572543455206e-15) * v46 + 7.647163731819816e-13
    v74 = ((v65 * v46 + -1.6059043836821613e-10) * v46 + 2.505210838544172e-08) * v46 + -2.7557319223985893e-06
    v84 = 2.0 * (((v74 * v46 + 0.0001984126984126984) * v46 + -0.008333333333333333) * v46 + 0.16666666666666666)
    v86 = 0.6666666666666666 * v37 / (np.cos(v2) * v37 / 3.0 + v84)
    return v86


def weight_moment_per_inertia(alpha: ArrayLike, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True) -> Any:
    """C_theta/Theta*: drive of gravity in the equation of motion, dimensionless.

    C_theta/Theta* = weight_moment_amplitude(alpha)/moment_of_inertia(alpha), finite at alpha = 0 where both
    vanish.

    Parameters
    ----------
    alpha : array_like
        Half the opening angle of the arc, rad.
    out : ndarray, optional
        Where the result goes.
    where : array_like of bool, optional
        Lanes to compute; others keep what `out` holds (NaN without `out`).

    Returns
    -------
    ndarray or scalar
        C_theta/Theta*. Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32.

    Notes
    -----
    Domain: 0 <= alpha <= pi/2 (1 + 4 eps), with the limits at both ends; elsewhere NaN and NumPy's ``invalid``
    flag.
    Accuracy: at most 16 ulp (sampled only: no certificate).
    Source: eq. (3.17) of the paper. Operations: 30 mul, 23 add, 2 div, 1 min, 1 cos.
    """
    return evaluate(_weight_moment_per_inertia, lambda eps, alpha: (alpha >= 0.0) & (alpha <= 1.5707963267948966 * (1.0 + 4.0 * eps)), (0.5,), (alpha,), out, where)


def _radial_weight_per_inertia(alpha: Array) -> Array:
    v2 = np.minimum(1.5707963267948966, alpha)
    v5 = v2 * v2
    v15 = ((1.9572941063391263e-20 * v5 + -8.22063524662433e-18) * v5 + 2.8114572543455206e-15) * v5 + -7.647163731819816e-13
    v24 = ((v15 * v5 + 1.6059043836821613e-10) * v5 + -2.505210838544172e-08) * v5 + 2.7557319223985893e-06
    v34 = (((v24 * v5 + -0.0001984126984126984) * v5 + 0.008333333333333333) * v5 + -0.16666666666666666) * v5
    v35 = v34 + 1.0
    v36 = np.cos(v2)
    v39 = v35 / (1.0 + v36) * v2
    v40 = v39 * v39
    v43 = 1.0 - v40
    v46 = np.minimum(0.4, v39)
    v47 = v46 * v46
    v57 = ((0.024390243902439025 * v47 + 0.02564102564102564) * v47 + 0.02702702702702703) * v47 + 0.02857142857142857
    v67 = (((v57 * v47 + 0.030303030303030304) * v47 + 0.03225806451612903) * v47 + 0.034482758620689655) * v47
    v78 = (((v67 + 0.037037037037037035) * v47 + 0.04) * v47 + 0.043478260869565216) * v47 + 0.047619047619047616
    v88 = (((v78 * v47 + 0.05263157894736842) * v47 + 0.058823529411764705) * v47 + 0.06666666666666667) * v47
    v99 = (((v88 + 0.07692307692307693) * v47 + 0.09090909090909091) * v47 + 0.1111111111111111) * v47 + 0.14285714285714285
    v110 = np.minimum(0.9999999999999999, np.maximum(0.4, v39))
    v121 = np.where(v39 < 0.4, (v99 * v47 + 0.2) * v47 + 0.3333333333333333, (0.5 * np.log1p(2.0 * v110 / (1.0 - v110)) - v110) / (v110 * (v110 * v110)))
    v126 = v35 * (v35 * v35)
    v134 = 4.0 * v2 * v2
    v144 = ((9.183689863795546e-29 * v134 + -6.446950284384474e-26) * v134 + 3.868170170630684e-23) * v134 + -1.9572941063391263e-20
    v153 = ((v144 * v134 + 8.22063524662433e-18) * v134 + -2.8114572543455206e-15) * v134 + 7.647163731819816e-13
    v162 = ((v153 * v134 + -1.6059043836821613e-10) * v134 + 2.505210838544172e-08) * v134 + -2.7557319223985893e-06
    v171 = ((v162 * v134 + 0.0001984126984126984) * v134 + -0.008333333333333333) * v134 + 0.16666666666666666
    v174 = 0.25 * (1.0 + v40) * (3.0 - v43 * v43 * v121 - v40) * v126 / (v36 * v126 / 3.0 + 2.0 * v171)
    return v174


def radial_weight_per_inertia(alpha: ArrayLike, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True) -> Any:
    """C_r/Theta*: brake of static friction in the equation of motion, dimensionless.

    C_r/Theta* = radial_weight_amplitude(alpha)/moment_of_inertia(alpha), finite at alpha = 0 where both vanish.

    Parameters
    ----------
    alpha : array_like
        Half the opening angle of the arc, rad.
    out : ndarray, optional
        Where the result goes.
    where : array_like of bool, optional
        Lanes to compute; others keep what `out` holds (NaN without `out`).

    Returns
    -------
    ndarray or scalar
        C_r/Theta*. Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32.

    Notes
    -----
    Domain: 0 <= alpha <= pi/2 (1 + 4 eps), with the limits at both ends; elsewhere NaN and NumPy's ``invalid``
    flag.
    Accuracy: at most 16 ulp (sampled only: no certificate).
    Source: eq. (3.17) of the paper. Operations: 60 mul, 44 add, 5 sub, 5 div, 3 min, 1 max, 1 less, 1 select, 1
    cos, 1 log1p.
    """
    return evaluate(_radial_weight_per_inertia, lambda eps, alpha: (alpha >= 0.0) & (alpha <= 1.5707963267948966 * (1.0 + 4.0 * eps)), (0.5,), (alpha,), out, where)


def _polar_moment_per_inertia(alpha: Array) -> Array:
    v2 = np.minimum(1.5707963267948966, alpha)
    v4 = v2 * v2
    v14 = ((1.9572941063391263e-20 * v4 + -8.22063524662433e-18) * v4 + 2.8114572543455206e-15) * v4 + -7.647163731819816e-13
    v23 = ((v14 * v4 + 1.6059043836821613e-10) * v4 + -2.505210838544172e-08) * v4 + 2.7557319223985893e-06
    v33 = (((v23 * v4 + -0.0001984126984126984) * v4 + 0.008333333333333333) * v4 + -0.16666666666666666) * v4
    v34 = v33 + 1.0
    v35 = np.cos(v2)
    v38 = v34 / (1.0 + v35) * v2
    v39 = v38 * v38
    v42 = 1.0 - v39
    v45 = np.minimum(0.4, v38)
    v46 = v45 * v45
    v56 = ((0.024390243902439025 * v46 + 0.02564102564102564) * v46 + 0.02702702702702703) * v46 + 0.02857142857142857
    v66 = (((v56 * v46 + 0.030303030303030304) * v46 + 0.03225806451612903) * v46 + 0.034482758620689655) * v46
    v77 = (((v66 + 0.037037037037037035) * v46 + 0.04) * v46 + 0.043478260869565216) * v46 + 0.047619047619047616
    v87 = (((v77 * v46 + 0.05263157894736842) * v46 + 0.058823529411764705) * v46 + 0.06666666666666667) * v46
    v98 = (((v87 + 0.07692307692307693) * v46 + 0.09090909090909091) * v46 + 0.1111111111111111) * v46 + 0.14285714285714285
    v109 = np.minimum(0.9999999999999999, np.maximum(0.4, v38))
    v120 = np.where(v38 < 0.4, (v98 * v46 + 0.2) * v46 + 0.3333333333333333, (0.5 * np.log1p(2.0 * v109 / (1.0 - v109)) - v109) / (v109 * (v109 * v109)))
    v125 = v34 * (v34 * v34)
    v134 = 4.0 * v2 * v2
    v144 = ((9.183689863795546e-29 * v134 + -6.446950284384474e-26) * v134 + 3.868170170630684e-23) * v134 + -1.9572941063391263e-20
    v153 = ((v144 * v134 + 8.22063524662433e-18) * v134 + -2.8114572543455206e-15) * v134 + 7.647163731819816e-13
    v162 = ((v153 * v134 + -1.6059043836821613e-10) * v134 + 2.505210838544172e-08) * v134 + -2.7557319223985893e-06
    v171 = ((v162 * v134 + 0.0001984126984126984) * v134 + -0.008333333333333333) * v134 + 0.16666666666666666
    v178 = ((1.0 + v39) * (3.0 - v42 * v42 * v120 - v39) * v35 * v125 / 12.0 + 2.6666666666666665 * v171) / (v35 * v125 / 3.0 + 2.0 * v171)
    return v178


def polar_moment_per_inertia(alpha: ArrayLike, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True) -> Any:
    """I_p*/Theta*: brake of centripetal friction in the equation of motion, dimensionless.

    I_p*/Theta* = polar_moment(alpha)/moment_of_inertia(alpha), finite at alpha = 0 where both vanish.

    Parameters
    ----------
    alpha : array_like
        Half the opening angle of the arc, rad.
    out : ndarray, optional
        Where the result goes.
    where : array_like of bool, optional
        Lanes to compute; others keep what `out` holds (NaN without `out`).

    Returns
    -------
    ndarray or scalar
        I_p*/Theta*. Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32.

    Notes
    -----
    Domain: 0 <= alpha <= pi/2 (1 + 4 eps), with the limits at both ends; elsewhere NaN and NumPy's ``invalid``
    flag.
    Accuracy: at most 16 ulp (sampled only: no certificate).
    Source: eq. (3.18) of the paper. Operations: 61 mul, 45 add, 5 sub, 6 div, 3 min, 1 max, 1 less, 1 select, 1
    cos, 1 log1p.
    """
    return evaluate(_polar_moment_per_inertia, lambda eps, alpha: (alpha >= 0.0) & (alpha <= 1.5707963267948966 * (1.0 + 4.0 * eps)), (0.5,), (alpha,), out, where)


def _weight_moment_per_radial_weight(alpha: Array) -> Array:
    v2 = np.minimum(1.5707963267948966, alpha)
    v5 = v2 * v2
    v15 = ((1.9572941063391263e-20 * v5 + -8.22063524662433e-18) * v5 + 2.8114572543455206e-15) * v5 + -7.647163731819816e-13
    v24 = ((v15 * v5 + 1.6059043836821613e-10) * v5 + -2.505210838544172e-08) * v5 + 2.7557319223985893e-06
    v34 = (((v24 * v5 + -0.0001984126984126984) * v5 + 0.008333333333333333) * v5 + -0.16666666666666666) * v5
    v39 = (v34 + 1.0) / (1.0 + np.cos(v2)) * v2
    v40 = v39 * v39
    v43 = 1.0 - v40
    v46 = np.minimum(0.4, v39)
    v47 = v46 * v46
    v57 = ((0.024390243902439025 * v47 + 0.02564102564102564) * v47 + 0.02702702702702703) * v47 + 0.02857142857142857
    v67 = (((v57 * v47 + 0.030303030303030304) * v47 + 0.03225806451612903) * v47 + 0.034482758620689655) * v47
    v78 = (((v67 + 0.037037037037037035) * v47 + 0.04) * v47 + 0.043478260869565216) * v47 + 0.047619047619047616
    v88 = (((v78 * v47 + 0.05263157894736842) * v47 + 0.058823529411764705) * v47 + 0.06666666666666667) * v47
    v99 = (((v88 + 0.07692307692307693) * v47 + 0.09090909090909091) * v47 + 0.1111111111111111) * v47 + 0.14285714285714285
    v110 = np.minimum(0.9999999999999999, np.maximum(0.4, v39))
    v121 = np.where(v39 < 0.4, (v99 * v47 + 0.2) * v47 + 0.3333333333333333, (0.5 * np.log1p(2.0 * v110 / (1.0 - v110)) - v110) / (v110 * (v110 * v110)))
    v126 = 2.6666666666666665 / ((1.0 + v40) * (3.0 - v43 * v43 * v121 - v40))
    return v126


def weight_moment_per_radial_weight(alpha: ArrayLike, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True) -> Any:
    """C_theta/C_r: limit friction over tan(psi), dimensionless.

    C_theta/C_r = weight_moment_amplitude(alpha)/radial_weight_amplitude(alpha), finite at alpha = 0 where both
    vanish.

    Parameters
    ----------
    alpha : array_like
        Half the opening angle of the arc, rad.
    out : ndarray, optional
        Where the result goes.
    where : array_like of bool, optional
        Lanes to compute; others keep what `out` holds (NaN without `out`).

    Returns
    -------
    ndarray or scalar
        C_theta/C_r. Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32.

    Notes
    -----
    Domain: 0 <= alpha <= pi/2 (1 + 4 eps), with the limits at both ends; elsewhere NaN and NumPy's ``invalid``
    flag.
    Accuracy: at most 16 ulp (sampled only: no certificate).
    Source: eq. (3.21) of the paper. Operations: 40 mul, 31 add, 5 sub, 4 div, 3 min, 1 max, 1 less, 1 select, 1
    cos, 1 log1p.
    """
    return evaluate(_weight_moment_per_radial_weight, lambda eps, alpha: (alpha >= 0.0) & (alpha <= 1.5707963267948966 * (1.0 + 4.0 * eps)), (0.5,), (alpha,), out, where)


def _radial_weight(theta_1: Array, theta_2: Array) -> Array:
    v4 = 0.5 * theta_2
    v5 = 0.5 * theta_1
    v7 = np.minimum(1.5707963267948966, v4 - v5)
    v8 = -theta_1
    v9 = theta_2 + v8
    v10 = v9 - theta_2
    v16 = v5 + v4
    v17 = theta_1 + theta_2
    v18 = v17 - theta_1
    v30 = v7 * v7
    v40 = ((1.9572941063391263e-20 * v30 + -8.22063524662433e-18) * v30 + 2.8114572543455206e-15) * v30 + -7.647163731819816e-13
    v49 = ((v40 * v30 + 1.6059043836821613e-10) * v30 + -2.505210838544172e-08) * v30 + 2.7557319223985893e-06
    v58 = ((v49 * v30 + -0.0001984126984126984) * v30 + 0.008333333333333333) * v30 + -0.16666666666666666
    v60 = v58 * v30 + 1.0
    v61 = np.cos(v7)
    v64 = v60 / (1.0 + v61) * v7
    v65 = v64 * v64
    v68 = 1.0 - v65
    v71 = np.minimum(0.4, v64)
    v72 = v71 * v71
    v82 = ((0.024390243902439025 * v72 + 0.02564102564102564) * v72 + 0.02702702702702703) * v72 + 0.02857142857142857
    v92 = (((v82 * v72 + 0.030303030303030304) * v72 + 0.03225806451612903) * v72 + 0.034482758620689655) * v72
    v103 = (((v92 + 0.037037037037037035) * v72 + 0.04) * v72 + 0.043478260869565216) * v72 + 0.047619047619047616
    v113 = (((v103 * v72 + 0.05263157894736842) * v72 + 0.058823529411764705) * v72 + 0.06666666666666667) * v72
    v124 = (((v113 + 0.07692307692307693) * v72 + 0.09090909090909091) * v72 + 0.1111111111111111) * v72 + 0.14285714285714285
    v134 = np.minimum(0.9999999999999999, np.maximum(0.4, v64))
    v145 = np.where(v64 < 0.4, (v124 * v72 + 0.2) * v72 + 0.3333333333333333, (0.5 * np.log1p(2.0 * v134 / (1.0 - v134)) - v134) / (v134 * (v134 * v134)))
    v167 = -(0.25 * (1.0 + v65) * (3.0 - v68 * v68 * v145 - v65) * (v60 * (v60 * v60)) * v7 * v7 * v7) - 4.0 * (1.0 + v145 * v65) * v61 * v64 * v60 * v7 * (0.5 * (theta_2 - (v9 - v10) + (v8 - v10)))
    v168 = (np.cos(v16) * (0.5 * (theta_1 - (v17 - v18) + (theta_2 - v18))) + np.sin(v16)) * v167
    return v168


def radial_weight(theta_1: ArrayLike, theta_2: ArrayLike, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True) -> Any:
    """J_r: weight of the moving mass along the radius, dimensionless.

    J_r = C_r(alpha) cos(psi), alpha = (theta_2 - theta_1)/2, psi = 3 pi/2 - (theta_1 + theta_2)/2.

    Parameters
    ----------
    theta_1 : array_like
        Polar angle of the arc's first end, rad, from the positive x axis.
    theta_2 : array_like
        Polar angle of its other end, rad; theta_1 <= theta_2 <= theta_1 + pi.
    out : ndarray, optional
        Where the result goes.
    where : array_like of bool, optional
        Lanes to compute; others keep what `out` holds (NaN without `out`).

    Returns
    -------
    ndarray or scalar
        J_r. Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32.

    Notes
    -----
    Domain: 0 <= (theta_2 - theta_1)/2 <= pi/2 (1 + 4 eps); elsewhere NaN and NumPy's ``invalid`` flag.
    Accuracy: the error of radial_weight_amplitude plus 2 ulp of the amplitude (sampled only: no certificate).
    Source: eq. (2.23) of the paper. Operations: 60 mul, 38 add, 15 sub, 3 div, 2 neg, 3 min, 1 max, 1 less, 1
    select, 2 cos, 1 log1p, 1 sin.
    """
    return evaluate(_radial_weight, lambda eps, theta_1, theta_2: (theta_2 >= theta_1) & (0.5 * theta_2 - 0.5 * theta_1 <= 1.5707963267948966 * (1.0 + 4.0 * eps)) & np.isfinite(theta_1), (4.0, 5.0), (theta_1, theta_2), out, where)


def _weight_moment(theta_1: Array, theta_2: Array) -> Array:
    v4 = 0.5 * theta_2
    v5 = 0.5 * theta_1
    v7 = np.minimum(1.5707963267948966, v4 - v5)
    v8 = -theta_1
    v9 = theta_2 + v8
    v10 = v9 - theta_2
    v16 = v5 + v4
    v17 = theta_1 + theta_2
    v18 = v17 - theta_1
    v25 = v7 * v7
    v35 = ((1.9572941063391263e-20 * v25 + -8.22063524662433e-18) * v25 + 2.8114572543455206e-15) * v25 + -7.647163731819816e-13
    v44 = ((v35 * v25 + 1.6059043836821613e-10) * v25 + -2.505210838544172e-08) * v25 + 2.7557319223985893e-06
    v53 = ((v44 * v25 + -0.0001984126984126984) * v25 + 0.008333333333333333) * v25 + -0.16666666666666666
    v56 = v53 * v25 + 1.0
    v57 = v56 * v56
    v71 = -(0.6666666666666666 * (v56 * v57) * v7 * v7 * v7) - 2.0 * np.cos(v7) * v57 * v7 * v7 * (0.5 * (theta_2 - (v9 - v10) + (v8 - v10)))
    v76 = v71 * (np.cos(v16) - np.sin(v16) * (0.5 * (theta_1 - (v17 - v18) + (theta_2 - v18))))
    return v76


def weight_moment(theta_1: ArrayLike, theta_2: ArrayLike, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True) -> Any:
    """J_theta: moment of the weight about the centre, dimensionless.

    J_theta = C_theta(alpha) sin(psi), alpha = (theta_2 - theta_1)/2, psi = 3 pi/2 - (theta_1 + theta_2)/2.

    Parameters
    ----------
    theta_1 : array_like
        Polar angle of the arc's first end, rad, from the positive x axis.
    theta_2 : array_like
        Polar angle of its other end, rad; theta_1 <= theta_2 <= theta_1 + pi.
    out : ndarray, optional
        Where the result goes.
    where : array_like of bool, optional
        Lanes to compute; others keep what `out` holds (NaN without `out`).

    Returns
    -------
    ndarray or scalar
        J_theta. Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32.

    Notes
    -----
    Domain: 0 <= (theta_2 - theta_1)/2 <= pi/2 (1 + 4 eps); elsewhere NaN and NumPy's ``invalid`` flag.
    Accuracy: the error of weight_moment_amplitude plus 2 ulp of the amplitude (sampled only: no certificate).
    Source: eq. (3.13) of the paper. Operations: 28 mul, 15 add, 11 sub, 2 neg, 1 min, 2 cos, 1 sin.
    """
    return evaluate(_weight_moment, lambda eps, theta_1, theta_2: (theta_2 >= theta_1) & (0.5 * theta_2 - 0.5 * theta_1 <= 1.5707963267948966 * (1.0 + 4.0 * eps)) & np.isfinite(theta_1), (4.0, 5.0), (theta_1, theta_2), out, where)


def _limit_friction(theta_1: Array, theta_2: Array) -> Array:
    v4 = 0.5 * theta_2
    v5 = 0.5 * theta_1
    v7 = np.minimum(1.5707963267948966, v4 - v5)
    v8 = v5 + v4
    v9 = theta_1 + theta_2
    v10 = v9 - theta_1
    v15 = 0.5 * (theta_1 - (v9 - v10) + (theta_2 - v10))
    v17 = np.cos(v8)
    v18 = np.sin(v8)
    v25 = v7 * v7
    v35 = ((1.9572941063391263e-20 * v25 + -8.22063524662433e-18) * v25 + 2.8114572543455206e-15) * v25 + -7.647163731819816e-13
    v44 = ((v35 * v25 + 1.6059043836821613e-10) * v25 + -2.505210838544172e-08) * v25 + 2.7557319223985893e-06
    v53 = ((v44 * v25 + -0.0001984126984126984) * v25 + 0.008333333333333333) * v25 + -0.16666666666666666
    v59 = (v53 * v25 + 1.0) / (1.0 + np.cos(v7)) * v7
    v60 = v59 * v59
    v63 = 1.0 - v60
    v66 = np.minimum(0.4, v59)
    v67 = v66 * v66
    v77 = ((0.024390243902439025 * v67 + 0.02564102564102564) * v67 + 0.02702702702702703) * v67 + 0.02857142857142857
    v87 = (((v77 * v67 + 0.030303030303030304) * v67 + 0.03225806451612903) * v67 + 0.034482758620689655) * v67
    v98 = (((v87 + 0.037037037037037035) * v67 + 0.04) * v67 + 0.043478260869565216) * v67 + 0.047619047619047616
    v108 = (((v98 * v67 + 0.05263157894736842) * v67 + 0.058823529411764705) * v67 + 0.06666666666666667) * v67
    v119 = (((v108 + 0.07692307692307693) * v67 + 0.09090909090909091) * v67 + 0.1111111111111111) * v67 + 0.14285714285714285
    v129 = np.minimum(0.9999999999999999, np.maximum(0.4, v59))
    v140 = np.where(v59 < 0.4, (v119 * v67 + 0.2) * v67 + 0.3333333333333333, (0.5 * np.log1p(2.0 * v129 / (1.0 - v129)) - v129) / (v129 * (v129 * v129)))
    v146 = 2.6666666666666665 * (v17 - v18 * v15) / ((v17 * v15 + v18) * (1.0 + v60) * (3.0 - v63 * v63 * v140 - v60))
    return v146


def limit_friction(theta_1: ArrayLike, theta_2: ArrayLike, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True) -> Any:
    """mu_eq: friction coefficient at limit equilibrium.

    mu_eq = J_theta/J_r = (C_theta/C_r) tan(psi); negative where gravity turns the mass clockwise.

    Parameters
    ----------
    theta_1 : array_like
        Polar angle of the arc's first end, rad, from the positive x axis.
    theta_2 : array_like
        Polar angle of its other end, rad; theta_1 <= theta_2 <= theta_1 + pi.
    out : ndarray, optional
        Where the result goes.
    where : array_like of bool, optional
        Lanes to compute; others keep what `out` holds (NaN without `out`).

    Returns
    -------
    ndarray or scalar
        mu_eq. Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32.

    Notes
    -----
    Domain: 0 <= (theta_2 - theta_1)/2 <= pi/2 (1 + 4 eps); elsewhere NaN and NumPy's ``invalid`` flag.
    Accuracy: at most 16 ulp (sampled only: no certificate).
    Source: eq. (3.21) of the paper. Operations: 47 mul, 35 add, 11 sub, 4 div, 3 min, 1 max, 1 less, 1 select,
    2 cos, 1 log1p, 1 sin.
    """
    return evaluate(_limit_friction, lambda eps, theta_1, theta_2: (theta_2 >= theta_1) & (0.5 * theta_2 - 0.5 * theta_1 <= 1.5707963267948966 * (1.0 + 4.0 * eps)) & np.isfinite(theta_1), (4.0, 5.0), (theta_1, theta_2), out, where)
