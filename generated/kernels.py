# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: 8e3825e5cce568e49c70a3196605d24946c27835b3895b70cac82459443c4eea
"""Moments, weights and quotients of the arc, from their definitions."""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from generated._compiled import Text, kernel
from generated._evaluate import Array, evaluate, horner

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

SERIES_1 = (-0.08333333333333333, 0.002777777777777727, -4.960317460298492e-05,
        5.511463841362367e-07, -4.175351054736609e-09, 2.2941293244035988e-11, -9.552400725452637e-14,
        3.0090535662212205e-16)
SERIES_2 = (1.0, -0.16666666666666666, 0.008333333333333333, -0.0001984126984126984,
        2.7557319223985893e-06, -2.505210838544172e-08, 1.6059043836821613e-10, -7.647163731819816e-13,
        2.8114572543455206e-15, -8.22063524662433e-18, 1.9572941063391263e-20, -3.868170170630684e-23,
        6.446950284384474e-26, -9.183689863795546e-29)

# What NumPy runs, by kernel and tier.
TEXTS: dict[str, dict[str, Text]] = {}


def _polar_moment(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, (-0.3999999999999999, 0.08571428571427717, -0.010582010581735324, 0.000885040880629919,
        -4.736000567461671e-05, 2.8234940702881187e-06, 9.337445867814892e-08, 4.0834903094607294e-08,
        1.7955154929181704e-08, -7.1580083195333975e-09, 1.2368322935058749e-08, -8.737187294724759e-09,
        4.858247011588724e-09, -1.535039446871726e-09, 2.5389062459137545e-10))
    near = (alpha_2 * (p1 * alpha_2) + alpha_2) / 1.5 * alpha
    b = 1.5707963267948966 - alpha
    b_2 = b * b
    p2 = horner(b_2, (-0.00882683796482655, 0.09885786309049466, -0.03306605933076026, 0.005209901976095983,
        -0.0004987833640429598, 3.292146877449988e-05))
    p3 = horner(b_2, (0.33333333333324544, -0.16666666678253228, 0.036111096108339666, -0.004519807110141118,
        0.00036703445349598303, -2.578267895028451e-05))
    t1 = b * b_2 * (p3 * xp.log(xp.maximum(b, 8.673617379884035e-19)) + p2) + 0.015463724401701127
    far = alpha + -0.5390625 + t1
    return xp.where(alpha < 1.06, near, far)


def _polar_moment_1e_10(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    t1 = 2.4674011002723395 - alpha_2
    p1 = horner(t1, (0.27018982302843847, 11.481432227545879, 92.09333594378792, 188.0609794452953,
        101.88292373597345, 17.372410880113158, 2.924173333296739, 0.058876226263682115))
    p2 = horner(t1, (1.0, 42.18998405310376, 327.93026766650274, 592.4905912523266, 167.31840391801205,
        -40.532846996251536, 3.451058209446253, -0.1210440526494234))
    return p1 * alpha_2 / p2 * alpha


def _polar_moment_1e_6(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, (0.6666671005494391, -0.26668864793741015, 0.05732983555205492, -0.007671609149860532,
        0.001603521078160282, -0.0009462187190355254, 0.0004641334116873807, -0.00012300991011412324,
        1.3553916148132743e-05))
    return p1 * alpha_2 * alpha


def _polar_moment_float32(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    t1 = 2.4674011002723395 - alpha_2
    p1 = horner(t1, (0.2701898230006029, 8.321440448598144, 47.82136127644069, 69.64967393431827,
        29.69445259391, 6.300636026761616, 0.9297869610419341, 0.06414296134293003))
    p2 = horner(t1, (1.0, 30.494533122537817, 167.63021002311652, 204.0410319285895, 32.75732007943386,
        -5.545295729315065, 0.23038315612586163))
    return p1 * alpha_2 / p2 * alpha


TEXTS["polar_moment"] = {"best": _polar_moment, "1e-10": _polar_moment_1e_10, "1e-6": _polar_moment_1e_6,
    "float32": _polar_moment_float32}
_call_polar_moment = kernel("polar_moment", TEXTS["polar_moment"])


def polar_moment(
    alpha: ArrayLike, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True, accuracy: float | None = None
) -> Any:
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
    accuracy : float, optional
        Relative error to meet: the cheapest tier that is proved to meet it, or a ValueError. By default the
        best tier.

    Returns
    -------
    ndarray or scalar
        I_p*. Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32.

    Notes
    -----
    Domain: 0 <= alpha <= pi/2 (1 + 4 eps), with the limits at both ends; elsewhere NaN and NumPy's ``invalid``
    flag.
    Accuracy: proved, rounding included: 0.63 ulp compiled with FMA, 4.17 without, 4.17 in NumPy;
    accuracy=1e-10: 6.69e-11 relative; accuracy=1e-6: 6.63e-07 relative; float32: 0.503 ulp
    (certificates/polar_moment.json).
    Source: eq. (2.17) of the paper. Operations: 32 mul, 29 add, 1 sub, 1 div, 1 max, 1 less, 1 select, 1 log.
    """
    return _call_polar_moment(alpha, out, where, accuracy)


def _moment_of_inertia(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, (-0.5999999999999991, 0.20952380952377056, -0.04550264550206386, 0.006580086575761721,
        -0.0006738939886585666, 5.132546211756001e-05, -3.018786567118006e-06, 1.4113705860392406e-07,
        -5.315887776253596e-09, 1.4479305864374496e-10))
    near = (alpha_2 * (p1 * alpha_2) + alpha_2) / 1.5 * alpha
    b = 1.5707963267948966 - alpha
    b_2 = b * b
    p2 = horner(b_2, (-0.1666666666666672, -0.22222222222215263, 0.3111111111077384, -0.13121693113874042,
        0.02986478441763371, -0.004369614517657968, 0.00044878890078446106, -3.411169653682064e-05,
        1.8663660698510027e-06))
    far = 0.5 * alpha + -0.1328125 + (b * p2 + 0.1328125)
    return xp.where(alpha < 1.04, near, far)


def _moment_of_inertia_1e_10(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, (0.6666666666643195, -0.3999999998316554, 0.1396825376348758, -0.0303350871470488,
        0.004386699926783207, -0.0004492273466971816, 3.4185573188242115e-05, -1.9950359696495124e-06,
        8.812338767321207e-08, -2.3953502944853665e-09))
    return p1 * alpha_2 * alpha


def _moment_of_inertia_1e_6(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, (0.6666665071706455, -0.39999462582420825, 0.13965129672735824, -0.03026448683123845,
        0.004308477621092885, -0.000403298571291692, 2.0082920286826588e-05))
    return p1 * alpha_2 * alpha


def _moment_of_inertia_float32(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, (0.6666666665497277, -0.39999999328741215, 0.13968247408715742, -0.030334844229585666,
        0.004386227374003602, -0.0004487049076745006, 3.384325821315492e-05, -1.8634045174042801e-06,
        6.067635607731889e-08))
    return p1 * alpha_2 * alpha


TEXTS["moment_of_inertia"] = {"best": _moment_of_inertia, "1e-10": _moment_of_inertia_1e_10,
    "1e-6": _moment_of_inertia_1e_6, "float32": _moment_of_inertia_float32}
_call_moment_of_inertia = kernel("moment_of_inertia", TEXTS["moment_of_inertia"])


def moment_of_inertia(
    alpha: ArrayLike, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True, accuracy: float | None = None
) -> Any:
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
    accuracy : float, optional
        Relative error to meet: the cheapest tier that is proved to meet it, or a ValueError. By default the
        best tier.

    Returns
    -------
    ndarray or scalar
        Theta*. Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32.

    Notes
    -----
    Domain: 0 <= alpha <= pi/2 (1 + 4 eps), with the limits at both ends; elsewhere NaN and NumPy's ``invalid``
    flag.
    Accuracy: proved, rounding included: 0.864 ulp compiled with FMA, 3.94 without, 3.94 in NumPy;
    accuracy=1e-10: 3.57e-12 relative; accuracy=1e-6: 2.42e-07 relative; float32: 0.503 ulp
    (certificates/moment_of_inertia.json).
    Source: eq. (3.12) of the paper. Operations: 24 mul, 21 add, 1 sub, 1 div, 1 less, 1 select.
    """
    return _call_moment_of_inertia(alpha, out, where, accuracy)


def _radial_weight_amplitude(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, (-0.29999999999999966, 0.02738095238091564, -0.002050264548889697,
        -2.931099301644356e-05, -2.358915071705018e-05, -5.7534777342876125e-06, -1.585007778277986e-06,
        -5.04949574608979e-07, -8.101057950761354e-09, -3.1762046893209714e-07, 4.365790675108399e-07,
        -5.634927377087995e-07, 5.257481069240742e-07, -3.71129271596167e-07, 1.8874892154394597e-07,
        -6.620230319236922e-08, 1.431517905747653e-08, -1.4755252283863973e-09))
    near = (alpha_2 * (p1 * alpha_2) + alpha_2) / 1.5 * alpha
    b = 1.5707963267948966 - alpha
    b_2 = b * b
    p2 = horner(b_2, (0.11370563888037802, 0.5870981205218737, -0.08591862806465715, 0.0068508659329300425,
        -0.00033238232410696576, 1.011431311417566e-05))
    p3 = horner(b_2, (1.0000000000000828, -0.33333333326382136, 0.04444445253534339, -0.003174420422838561,
        0.00014187659175596328, -4.079654945729119e-06))
    t1 = b_2 * (p3 * xp.log(xp.maximum(2.0 * b, 8.673617379884035e-19)) + p2) + 0.01928933660255172
    far = 0.5 * alpha + 0.1953125 + (b * (b * -2.0 + 0.5) + t1)
    return xp.where(alpha < 1.14, near, far)


def _radial_weight_amplitude_1e_10(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    t1 = 2.4674011002723395 - alpha_2
    p1 = horner(t1, (0.2580122754802636, 641.5972189319754, 233461.82406543285, 19765640.525143933,
        487791535.0085183, 4006787534.1965985, 11890031808.210299, 13342513505.110321, 5646454336.979666,
        813313646.8119079, 34205630.793633714))
    p2 = horner(t1, (1.0, 2486.084692390184, 903337.2314638863, 76059724.29630841, 1844741626.5491843,
        14432151525.685879, 37692912285.01263, 30457363960.293766, 4809333505.187634, -481748049.5507379,
        14117638.984697843))
    return p1 * alpha_2 / p2 * alpha


def _radial_weight_amplitude_1e_6(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    t1 = 2.4674011002723395 - alpha_2
    p1 = horner(t1, (0.25801239057120384, 7.130575609363919, 27.706040179137357, 24.086548523952633,
        5.441400718506571, 0.3095579708379847))
    p2 = horner(t1, (1.0, 27.029402721585523, 91.34715133265911, 42.267614275244746, -2.461606616849178))
    return p1 * alpha_2 / p2 * alpha


def _radial_weight_amplitude_float32(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    t1 = 2.4674011002723395 - alpha_2
    p1 = horner(t1, (0.25801227552627604, 315.3984503326471, 56347.855766680615, 2330133.7496379497,
        27787633.640274998, 108350816.76157898, 148401585.24043858, 72463713.17090172, 11285361.253041798,
        430153.8542312948))
    p2 = horner(t1, (1.0, 1221.8085422638378, 217650.15907975892, 8899441.692057962, 102370874.21533594,
        359918483.66369116, 370828964.64343065, 74805268.88796055, -7497699.99752473, 230360.80867666923))
    return p1 * alpha_2 / p2 * alpha


TEXTS["radial_weight_amplitude"] = {"best": _radial_weight_amplitude, "1e-10": _radial_weight_amplitude_1e_10,
    "1e-6": _radial_weight_amplitude_1e_6, "float32": _radial_weight_amplitude_float32}
_call_radial_weight_amplitude = kernel("radial_weight_amplitude", TEXTS["radial_weight_amplitude"])


def radial_weight_amplitude(
    alpha: ArrayLike, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True, accuracy: float | None = None
) -> Any:
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
    accuracy : float, optional
        Relative error to meet: the cheapest tier that is proved to meet it, or a ValueError. By default the
        best tier.

    Returns
    -------
    ndarray or scalar
        C_r. Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32.

    Notes
    -----
    Domain: 0 <= alpha <= pi/2 (1 + 4 eps), with the limits at both ends; elsewhere NaN and NumPy's ``invalid``
    flag.
    Accuracy: proved, rounding included: 0.717 ulp compiled with FMA, 3.92 without, 3.92 in NumPy;
    accuracy=1e-10: 5.86e-11 relative; accuracy=1e-6: 4.53e-07 relative; float32: 0.505 ulp
    (certificates/radial_weight_amplitude.json).
    Source: eq. (2.23) of the paper. Operations: 38 mul, 34 add, 1 sub, 1 div, 1 max, 1 less, 1 select, 1 log.
    """
    return _call_radial_weight_amplitude(alpha, out, where, accuracy)


def _weight_moment_amplitude(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, (-0.5, 0.1083333333333333, -0.013558201058200147, 0.0011094576719491399,
        -6.400813688264376e-05, 2.7432103327249243e-06, -9.076778260218794e-08, 2.3883677784975775e-09,
        -5.0995940299020745e-11, 8.339688103371207e-13))
    near = (alpha_2 * (p1 * alpha_2) + alpha_2) / 1.5 * alpha
    b = 1.5707963267948966 - alpha
    b_2 = b * b
    p2 = horner(b_2, (-0.2499999999999996, 0.5833333333332911, -0.16944444444280285, 0.027132936477346933,
        -0.002712191042308909, 0.00018491188411207517, -9.13736805715034e-06, 3.3026082585149297e-07))
    t1 = b * (b * -0.75 + 0.5) + (b_2 * p2 + (b * -1.2246467991473532e-16 + -0.0015439967307816123))
    far = 0.5 * alpha + -0.1171875 + t1
    return xp.where(alpha < 1.04, near, far)


def _weight_moment_amplitude_1e_10(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, (0.6666666666653104, -0.33333333325541464, 0.07222222146402071, -0.009038797804484562,
        0.0007396327967499843, -4.266582272700972e-05, 1.8246695364307174e-06, -5.8896078807575524e-08,
        1.2431444217923382e-09))
    return p1 * alpha_2 * alpha


def _weight_moment_amplitude_1e_6(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, (0.6666663784539829, -0.3333263814016009, 0.07219326041626052, -0.008992837331217642,
        0.0007055263399624791, -3.0487249815407907e-05))
    return p1 * alpha_2 * alpha


def _weight_moment_amplitude_float32(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, (0.6666666665660732, -0.3333333288344924, 0.07222218799987005, -0.009038698970556838,
        0.0007394869977279918, -4.254754715360433e-05, 1.7710020240603323e-06, -4.6119747876616884e-08))
    return p1 * alpha_2 * alpha


TEXTS["weight_moment_amplitude"] = {"best": _weight_moment_amplitude, "1e-10": _weight_moment_amplitude_1e_10,
    "1e-6": _weight_moment_amplitude_1e_6, "float32": _weight_moment_amplitude_float32}
_call_weight_moment_amplitude = kernel("weight_moment_amplitude", TEXTS["weight_moment_amplitude"])


def weight_moment_amplitude(
    alpha: ArrayLike, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True, accuracy: float | None = None
) -> Any:
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
    accuracy : float, optional
        Relative error to meet: the cheapest tier that is proved to meet it, or a ValueError. By default the
        best tier.

    Returns
    -------
    ndarray or scalar
        C_theta. Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32.

    Notes
    -----
    Domain: 0 <= alpha <= pi/2 (1 + 4 eps), with the limits at both ends; elsewhere NaN and NumPy's ``invalid``
    flag.
    Accuracy: proved, rounding included: 0.733 ulp compiled with FMA, 3.8 without, 3.8 in NumPy; accuracy=1e-10:
    2.07e-12 relative; accuracy=1e-6: 4.38e-07 relative; float32: 0.503 ulp
    (certificates/weight_moment_amplitude.json).
    Source: eq. (3.13) of the paper. Operations: 26 mul, 23 add, 1 sub, 1 div, 1 less, 1 select.
    """
    return _call_weight_moment_amplitude(alpha, out, where, accuracy)


def _resistance_factor(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, SERIES_1)
    return (alpha_2 * (p1 * alpha_2) + alpha_2) * alpha


def _resistance_factor_1e_10(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, (0.9999999999972994, -0.08333333325677353, 0.002777777423221201,
        -4.960257036031239e-05, 5.506785717843854e-07, -4.007433105099138e-09))
    return p1 * alpha_2 * alpha


def _resistance_factor_1e_6(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, (0.9999998318478346, -0.08333123626934905, 0.002773612256777145, -4.692255852080745e-05))
    return p1 * alpha_2 * alpha


def _resistance_factor_float32(alpha: Array, xp: Any = np) -> Array:
    return _resistance_factor_1e_10(alpha)


TEXTS["resistance_factor"] = {"best": _resistance_factor, "1e-10": _resistance_factor_1e_10,
    "1e-6": _resistance_factor_1e_6, "float32": _resistance_factor_float32}
_call_resistance_factor = kernel("resistance_factor", TEXTS["resistance_factor"])


def resistance_factor(
    alpha: ArrayLike, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True, accuracy: float | None = None
) -> Any:
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
    accuracy : float, optional
        Relative error to meet: the cheapest tier that is proved to meet it, or a ValueError. By default the
        best tier.

    Returns
    -------
    ndarray or scalar
        lambda. Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32.

    Notes
    -----
    Domain: 0 <= alpha <= pi/2 (1 + 4 eps), with the limits at both ends; elsewhere NaN and NumPy's ``invalid``
    flag.
    Accuracy: proved, rounding included: 0.65 ulp compiled with FMA, 3.01 without, 3.01 in NumPy;
    accuracy=1e-10: 2.74e-12 relative; accuracy=1e-6: 1.71e-07 relative; float32: 0.501 ulp
    (certificates/resistance_factor.json).
    Source: eq. (3.14) of the paper. Operations: 11 mul, 8 add.
    """
    return _call_resistance_factor(alpha, out, where, accuracy)


def _dynamic_coefficient(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, (-0.3999999999999997, 0.08571428571425747, -0.010582010581117055,
        0.0008850408707033633, -4.735990982233164e-05, 2.822884338426451e-06, 9.607871394302501e-08,
        3.215892014327322e-08, 3.8569975506359614e-08, -4.392760924048977e-08, 6.183369010976702e-08,
        -5.8718978986658795e-08, 4.223518046373998e-08, -2.1613153923147333e-08, 7.583637118101315e-09,
        -1.6286878242945004e-09, 1.6626223621024597e-10))
    b = 1.5707963267948966 - alpha
    b_2 = b * b
    p2 = horner(b_2, (-0.008826837963451475, 0.09885786403242842, -0.03306598168250652, 0.005211052149520961,
        -0.0004968503493886828, 2.9872353280334895e-05))
    p3 = horner(b_2, (0.33333333333356946, -0.16666666645179565, 0.03611113551017215, -0.00451885966831341,
        0.0003719086683763541, -2.222090620284525e-05))
    t1 = b * b_2 * (p3 * xp.log(xp.maximum(b, 8.673617379884035e-19)) + p2) + 0.015463724401701127
    t2 = alpha < 1.18
    t3 = xp.where(t2, 1.0 + p1 * alpha_2, alpha + -0.5390625 + t1)
    p4 = horner(alpha_2, SERIES_1)
    t4 = xp.where(t2, 1.0 + p4 * alpha_2, _resistance_factor(alpha))
    return xp.where(t2, t3 / 1.5, t3) / xp.where(t2, t4, t4)


TEXTS["dynamic_coefficient"] = {"best": _dynamic_coefficient}
_call_dynamic_coefficient = kernel("dynamic_coefficient", TEXTS["dynamic_coefficient"])


def dynamic_coefficient(
    alpha: ArrayLike, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True, accuracy: float | None = None
) -> Any:
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
    accuracy : float, optional
        Relative error to meet: the cheapest tier that is proved to meet it, or a ValueError. By default the
        best tier.

    Returns
    -------
    ndarray or scalar
        A. Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32.

    Notes
    -----
    Domain: 0 <= alpha <= pi/2 (1 + 4 eps), with the limits at both ends; elsewhere NaN and NumPy's ``invalid``
    flag.
    Accuracy: proved, rounding included: 0.824 ulp compiled with FMA, 3.99 without, 3.99 in NumPy
    (certificates/dynamic_coefficient.json).
    Source: eq. (2.24) of the paper. Operations: 42 mul, 40 add, 1 sub, 2 div, 1 max, 1 less, 4 select, 1 log.
    """
    return _call_dynamic_coefficient(alpha, out, where, accuracy)


def _weight_moment_per_inertia(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, (-0.5, 0.10833333333333328, -0.013558201058199847, 0.001109457671946687,
        -6.400813687235277e-05, 2.7432103078892563e-06, -9.076774672061455e-08, 2.388337116754608e-09,
        -5.098164781997805e-11, 8.311677077858953e-13))
    b = 1.5707963267948966 - alpha
    b_2 = b * b
    p2 = horner(b_2, (-0.25000000000000033, 0.5833333333333486, -0.16944444444452478, 0.027132936502729948,
        -0.002712191246293181, 0.0001849127952255673, -9.139492424160367e-06, 3.3227677166736995e-07))
    t1 = b * (b * -0.75 + 0.5) + (b_2 * p2 + (b * -1.2246467991473532e-16 + -0.01716899673078161))
    t2 = 0.5 * alpha + -0.1015625
    t3 = alpha < 1.06
    p3 = horner(alpha_2, (-0.6, 0.2095238095238085, -0.04550264550262906, 0.00658008657995396,
        -0.0006738940066034418, 5.132550979125799e-05, -3.018867755411378e-06, 1.4122581998292043e-07,
        -5.376140679440608e-09, 1.6791198438408976e-10, -3.83202657381123e-12))
    p4 = horner(b_2, (-0.1666666666666665, -0.22222222222223978, 0.3111111111116941, -0.13121693122399697,
        0.029864785416135266, -0.00436962124279994, 0.00044881492633847974, -3.4165472134294174e-05,
        1.912335320748958e-06))
    t4 = xp.where(t3, 1.0 + p3 * alpha_2, t2 + (b * p4 + 0.10156249999999999))
    return xp.where(t3, 1.0 + p1 * alpha_2, t2 + t1) / t4


TEXTS["weight_moment_per_inertia"] = {"best": _weight_moment_per_inertia}
_call_weight_moment_per_inertia = kernel("weight_moment_per_inertia", TEXTS["weight_moment_per_inertia"])


def weight_moment_per_inertia(
    alpha: ArrayLike, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True, accuracy: float | None = None
) -> Any:
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
    accuracy : float, optional
        Relative error to meet: the cheapest tier that is proved to meet it, or a ValueError. By default the
        best tier.

    Returns
    -------
    ndarray or scalar
        C_theta/Theta*. Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32.

    Notes
    -----
    Domain: 0 <= alpha <= pi/2 (1 + 4 eps), with the limits at both ends; elsewhere NaN and NumPy's ``invalid``
    flag.
    Accuracy: proved, rounding included: 0.892 ulp compiled with FMA, 3.17 without, 3.17 in NumPy
    (certificates/weight_moment_per_inertia.json).
    Source: eq. (3.17) of the paper. Operations: 44 mul, 44 add, 1 sub, 1 div, 1 less, 2 select.
    """
    return _call_weight_moment_per_inertia(alpha, out, where, accuracy)


def _radial_weight_per_inertia(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, (-0.2999999999999999, 0.02738095238093843, -0.0020502645497105835,
        -2.931097796918108e-05, -2.358931609263516e-05, -5.752282822587549e-06, -1.5910204621339517e-06,
        -4.830686635855356e-07, -6.713430538813725e-08, -1.977170416160583e-07, 2.5182679267513344e-07,
        -3.4743252232526025e-07, 3.353626380489223e-07, -2.468524552204202e-07, 1.305065578176369e-07,
        -4.7680010378922496e-08, 1.073684857797492e-08, -1.1586039910451562e-09))
    b = 1.5707963267948966 - alpha
    b_2 = b * b
    p2 = horner(b_2, (-0.011294361119643392, 0.5870981204939706, -0.08591863114699338, 0.00685082383403923,
        -0.0003322866718334205, 1.060969811375175e-05))
    p3 = horner(b_2, (1.0000000000000775, -0.33333333327526726, 0.04444445040892791, -0.0031744875985231327,
        0.00014146896597637675, -4.4058766217095835e-06))
    t1 = b_2 * (p3 * xp.log(xp.maximum(2.0 * b, 8.673617379884035e-19)) + p2) + 0.04272683660255172
    t2 = 0.5 * alpha
    t3 = alpha < 1.12
    t4 = xp.where(t3, 1.0 + p1 * alpha_2, t2 + 0.171875 + (b * (b * -1.875 + 0.5) + t1))
    p4 = horner(alpha_2, (-0.6, 0.20952380952380836, -0.0455026455026261, 0.00658008657992928,
        -0.0006738940064945646, 5.132550950640006e-05, -3.0188672910288945e-06, 1.4122534371639664e-07,
        -5.375842228035577e-09, 1.6780773246644826e-10, -3.816499096792332e-12))
    p5 = horner(b_2, (-0.16666666666666644, -0.22222222222226065, 0.31111111111341694, -0.13121693128224232,
        0.029864786417086647, -0.004369630780617362, 0.0004488660001961668, -3.430940961037193e-05,
        2.0785159488122554e-06))
    t5 = xp.where(t3, 1.0 + p4 * alpha_2, t2 + -0.09375 + (b * p5 + 0.09374999999999999))
    return t4 / t5


TEXTS["radial_weight_per_inertia"] = {"best": _radial_weight_per_inertia}
_call_radial_weight_per_inertia = kernel("radial_weight_per_inertia", TEXTS["radial_weight_per_inertia"])


def radial_weight_per_inertia(
    alpha: ArrayLike, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True, accuracy: float | None = None
) -> Any:
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
    accuracy : float, optional
        Relative error to meet: the cheapest tier that is proved to meet it, or a ValueError. By default the
        best tier.

    Returns
    -------
    ndarray or scalar
        C_r/Theta*. Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32.

    Notes
    -----
    Domain: 0 <= alpha <= pi/2 (1 + 4 eps), with the limits at both ends; elsewhere NaN and NumPy's ``invalid``
    flag.
    Accuracy: proved, rounding included: 1.08 ulp compiled with FMA, 3.75 without, 3.75 in NumPy
    (certificates/radial_weight_per_inertia.json).
    Source: eq. (3.17) of the paper. Operations: 56 mul, 56 add, 1 sub, 1 div, 1 max, 1 less, 2 select, 1 log.
    """
    return _call_radial_weight_per_inertia(alpha, out, where, accuracy)


def _polar_moment_per_inertia(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, (-0.3999999999999991, 0.08571428571421652, -0.010582010580190438, 0.000885040860908459,
        -4.735985877395161e-05, 2.822804137356218e-06, 9.54924982273984e-08, 3.65851715201639e-08,
        2.3200699326773943e-08, -1.0080735545578033e-08, 1.0635642342643017e-08, -4.1011157201467435e-09,
        1.0438507136322873e-09))
    b = 1.5707963267948966 - alpha
    b_2 = b * b
    p2 = horner(b_2, (-0.2398758981538578, 0.21438239256080094, -0.05809638684427457, 0.008342729184846673,
        -0.0007526763708477574, 5.141697843624536e-05))
    p3 = horner(b_2, (0.33333333333247117, -0.16666666716897885, 0.0361110720734664, -0.004520115161148769,
        0.0003661824477726528, -2.6119064549573967e-05))
    t1 = b * b_2 * (p3 * xp.log(xp.maximum(2.0 * b, 8.673617379884035e-19)) + p2)
    t2 = alpha < 1.0
    t3 = xp.where(t2, 1.0 + p1 * alpha_2, alpha + -0.546875 + (t1 + 0.023276224401701125))
    p4 = horner(alpha_2, (-0.5999999999999996, 0.20952380952379232, -0.04550264550236013, 0.0065800865777468414,
        -0.000673893996196225, 5.132547941677655e-05, -3.0188110309881937e-06, 1.4115790231721552e-07,
        -5.3256984711383125e-09, 1.4675229409541942e-10))
    p5 = horner(b_2, (-0.16666666666666646, -0.22222222222224858, 0.31111111111234796, -0.13121693124481915,
        0.029864785768700504, -0.0043696247326275185, 0.0004488358070079107, -3.423984087167627e-05,
        2.05744095772437e-06, -1.1937049677530915e-07))
    t4 = xp.where(t2, 1.0 + p4 * alpha_2, 0.5 * alpha + -0.1171875 + (b * p5 + 0.11718749999999999))
    return t3 / t4


TEXTS["polar_moment_per_inertia"] = {"best": _polar_moment_per_inertia}
_call_polar_moment_per_inertia = kernel("polar_moment_per_inertia", TEXTS["polar_moment_per_inertia"])


def polar_moment_per_inertia(
    alpha: ArrayLike, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True, accuracy: float | None = None
) -> Any:
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
    accuracy : float, optional
        Relative error to meet: the cheapest tier that is proved to meet it, or a ValueError. By default the
        best tier.

    Returns
    -------
    ndarray or scalar
        I_p*/Theta*. Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32.

    Notes
    -----
    Domain: 0 <= alpha <= pi/2 (1 + 4 eps), with the limits at both ends; elsewhere NaN and NumPy's ``invalid``
    flag.
    Accuracy: proved, rounding included: 0.814 ulp compiled with FMA, 3.01 without, 3.01 in NumPy
    (certificates/polar_moment_per_inertia.json).
    Source: eq. (3.18) of the paper. Operations: 50 mul, 49 add, 1 sub, 1 div, 1 max, 1 less, 2 select, 1 log.
    """
    return _call_polar_moment_per_inertia(alpha, out, where, accuracy)


def _weight_moment_per_radial_weight(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, (-0.5, 0.10833333333333316, -0.013558201058197508, 0.0011094576719297984,
        -6.400813680902941e-05, 2.743210170353137e-06, -9.076756699884043e-08, 2.3881976877903854e-09,
        -5.0922462259974074e-11, 8.205773118275206e-13))
    b = 1.5707963267948966 - alpha
    b_2 = b * b
    p2 = horner(b_2, (-0.12499999999999852, 0.583333333333178, -0.16944444443813225, 0.027132936381399846,
        -0.002712189970245263, 0.00018490525920221364, -9.116104748851073e-06, 3.02606622886103e-07))
    t1 = b * (b * -0.875 + 0.5) + (b_2 * p2 + (b * -1.2246467991473532e-16 + -0.048418996730781615))
    t2 = 0.5 * alpha
    t3 = alpha < 1.13
    p3 = horner(alpha_2, (-0.3000000000000012, 0.027380952381070512, -0.0020502645543247324,
        -2.9310895742984074e-05, -2.359019575838328e-05, -5.746092779161184e-06, -1.6213538572889048e-06,
        -3.7560944307809877e-07, -3.491992005720133e-07, 3.593124674080841e-07, -5.821614082905277e-07,
        5.997407424406731e-07, -4.7480898739475487e-07, 2.663310221256971e-07, -1.0281605241196749e-07,
        2.429554005631876e-08, -2.750170988699041e-09))
    p4 = horner(b_2, (-0.011294361119632735, 0.5870981205074514, -0.08591862970310375, 0.006850842796753032,
        -0.00033233199219427515, 1.039171256004066e-05))
    p5 = horner(b_2, (1.0000000000000802, -0.33333333326970643, 0.04444445141438387, -0.003174456678003164,
        0.00014165161709039066, -4.263599921619414e-06))
    t4 = b_2 * (p5 * xp.log(xp.maximum(2.0 * b, 8.673617379884035e-19)) + p4) + 0.04272683660255172
    t5 = xp.where(t3, 1.0 + p3 * alpha_2, t2 + 0.171875 + (b * (b * -1.875 + 0.5) + t4))
    return xp.where(t3, 1.0 + p1 * alpha_2, t2 + -0.0703125 + t1) / t5


TEXTS["weight_moment_per_radial_weight"] = {"best": _weight_moment_per_radial_weight}
_call_weight_moment_per_radial_weight = kernel("weight_moment_per_radial_weight",
    TEXTS["weight_moment_per_radial_weight"])


def weight_moment_per_radial_weight(
    alpha: ArrayLike, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True, accuracy: float | None = None
) -> Any:
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
    accuracy : float, optional
        Relative error to meet: the cheapest tier that is proved to meet it, or a ValueError. By default the
        best tier.

    Returns
    -------
    ndarray or scalar
        C_theta/C_r. Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32.

    Notes
    -----
    Domain: 0 <= alpha <= pi/2 (1 + 4 eps), with the limits at both ends; elsewhere NaN and NumPy's ``invalid``
    flag.
    Accuracy: proved, rounding included: 1.03 ulp compiled with FMA, 4 without, 4 in NumPy
    (certificates/weight_moment_per_radial_weight.json).
    Source: eq. (3.21) of the paper. Operations: 56 mul, 56 add, 1 sub, 1 div, 1 max, 1 less, 2 select, 1 log.
    """
    return _call_weight_moment_per_radial_weight(alpha, out, where, accuracy)


def _radial_weight(theta_1: Array, theta_2: Array) -> Array:
    t1 = 0.5 * theta_2
    t2 = 0.5 * theta_1
    alpha = np.minimum(1.5707963267948966, t1 - t2)
    t3 = -theta_1
    t4 = theta_2 + t3
    t5 = t4 - theta_2
    delta = 0.5 * (theta_2 - (t4 - t5) + (t3 - t5))
    theta_m = t2 + t1
    t6 = theta_1 + theta_2
    t7 = t6 - theta_1
    epsilon = 0.5 * (theta_1 - (t6 - t7) + (theta_2 - t7))
    alpha_2 = alpha * alpha
    kernel = _radial_weight_amplitude(alpha)
    t8 = np.cos(alpha)
    p1 = horner(alpha_2, SERIES_2)
    t9 = p1 * p1
    t10 = 4.0 * t8
    t11 = 1.0 + t8
    t12 = p1 / t11 * alpha
    t13 = np.maximum(-0.4, np.minimum(0.4, t12))
    t14 = t13 * t13
    p2 = horner(t14, (0.3333333333333333, 0.2, 0.14285714285714285, 0.1111111111111111, 0.09090909090909091,
        0.07692307692307693, 0.06666666666666667, 0.058823529411764705, 0.05263157894736842,
        0.047619047619047616, 0.043478260869565216, 0.04, 0.037037037037037035, 0.034482758620689655,
        0.03225806451612903, 0.030303030303030304, 0.02857142857142857, 0.02702702702702703,
        0.02564102564102564, 0.024390243902439025))
    t15 = np.abs(t12) < 0.4
    t16 = np.minimum(0.9999999999999999, np.where(t15, 0.4, t12))
    t17 = t10 * (t9 * t9) * np.where(t15, p2, (np.arctanh(t16) - t16) / (t16 * (t16 * t16)))
    t18 = (t10 * t9 / t11 + t17 / (t11 * (t11 * t11)) * alpha * alpha) * alpha * alpha
    return -((np.cos(theta_m) * epsilon + np.sin(theta_m)) * (kernel + t18 * delta))


def radial_weight(
    theta_1: ArrayLike, theta_2: ArrayLike, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True
) -> Any:
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
    Accuracy: the error of radial_weight_amplitude in NumPy plus 2 ulp of the amplitude (sampled only: no
    certificate).
    Source: eq. (2.23) of the paper. Operations: 93 mul, 75 add, 11 sub, 5 div, 2 neg, 3 min, 2 max, 2 less, 3
    select, 1 abs, 1 arctanh, 2 cos, 1 log, 1 sin.
    """
    return evaluate(
        _radial_weight,
        lambda eps, theta_1, theta_2: (
            (theta_2 >= theta_1)
            & (0.5 * theta_2 - 0.5 * theta_1 <= 1.5707963267948966 * (1.0 + 4.0 * eps))
            & np.isfinite(theta_1)
        ),
        (4.0, 5.0),
        (theta_1, theta_2),
        out,
        where,
    )


def _weight_moment(theta_1: Array, theta_2: Array) -> Array:
    t1 = 0.5 * theta_2
    t2 = 0.5 * theta_1
    alpha = np.minimum(1.5707963267948966, t1 - t2)
    t3 = -theta_1
    t4 = theta_2 + t3
    t5 = t4 - theta_2
    delta = 0.5 * (theta_2 - (t4 - t5) + (t3 - t5))
    theta_m = t2 + t1
    t6 = theta_1 + theta_2
    t7 = t6 - theta_1
    epsilon = 0.5 * (theta_1 - (t6 - t7) + (theta_2 - t7))
    alpha_2 = alpha * alpha
    kernel = _weight_moment_amplitude(alpha)
    p1 = horner(alpha_2, SERIES_2)
    t8 = kernel + 2.0 * np.cos(alpha) * (p1 * p1) * alpha * alpha * delta
    return -((np.cos(theta_m) - np.sin(theta_m) * epsilon) * t8)


def weight_moment(
    theta_1: ArrayLike, theta_2: ArrayLike, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True
) -> Any:
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
    Accuracy: the error of weight_moment_amplitude in NumPy plus 2 ulp of the amplitude (sampled only: no
    certificate).
    Source: eq. (3.13) of the paper. Operations: 51 mul, 42 add, 11 sub, 1 div, 2 neg, 1 min, 1 less, 1 select,
    2 cos, 1 sin.
    """
    return evaluate(
        _weight_moment,
        lambda eps, theta_1, theta_2: (
            (theta_2 >= theta_1)
            & (0.5 * theta_2 - 0.5 * theta_1 <= 1.5707963267948966 * (1.0 + 4.0 * eps))
            & np.isfinite(theta_1)
        ),
        (4.0, 5.0),
        (theta_1, theta_2),
        out,
        where,
    )


def _limit_friction(theta_1: Array, theta_2: Array) -> Array:
    t1 = 0.5 * theta_2
    t2 = 0.5 * theta_1
    alpha = np.minimum(1.5707963267948966, t1 - t2)
    theta_m = t2 + t1
    t3 = theta_1 + theta_2
    t4 = t3 - theta_1
    epsilon = 0.5 * (theta_1 - (t3 - t4) + (theta_2 - t4))
    kernel = _weight_moment_per_radial_weight(alpha)
    t5 = np.cos(theta_m)
    t6 = np.sin(theta_m)
    return (t5 - t6 * epsilon) / (t5 * epsilon + t6) * kernel


def limit_friction(
    theta_1: ArrayLike, theta_2: ArrayLike, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True
) -> Any:
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
    Source: eq. (3.21) of the paper. Operations: 62 mul, 60 add, 7 sub, 2 div, 1 min, 1 max, 1 less, 2 select, 1
    cos, 1 log, 1 sin.
    """
    return evaluate(
        _limit_friction,
        lambda eps, theta_1, theta_2: (
            (theta_2 >= theta_1)
            & (0.5 * theta_2 - 0.5 * theta_1 <= 1.5707963267948966 * (1.0 + 4.0 * eps))
            & np.isfinite(theta_1)
        ),
        (4.0, 5.0),
        (theta_1, theta_2),
        out,
        where,
    )
