# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: 4a7c516a68251da5a0dfc443f88c44d87256d4cac88b039eb7c070117ad50895
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

# What NumPy runs, by kernel and tier.
TEXTS: dict[str, dict[str, Text]] = {}


def _polar_moment(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, (-0.4000000000000009, 0.08571428571435445, -0.010582010583821098,
        0.0008850409089482901, -4.736023206134585e-05, 2.824654298465376e-06, 8.93673762386861e-08,
        5.044137796935493e-08, 1.6984201153024313e-09, 1.2440331047706752e-08, -4.582723564839499e-09,
        1.889770671714059e-09))
    near = (alpha_2 * (p1 * alpha_2) + alpha_2) / 1.5 * alpha
    b = 1.5707963267948966 - alpha
    b_2 = b * b
    p2 = horner(b_2, (0.3333333333338518, -0.16666666655674875, 0.03611110500268692, -0.004519753612732019,
        0.00036703390178095813, -2.5834398517075226e-05))
    p3 = horner(b_2, (-0.008826837962552214, 0.0988578636158992, -0.033066047119410365, 0.005209921678910539,
        -0.0004988530376566277, 3.295754619092071e-05))
    t1 = b * b_2 * (p2 * xp.log(xp.maximum(b, 8.673617379884035e-19)) + p3) + 5.360408832255455e-17
    far = alpha + -0.5235987755982989 + t1
    return xp.where(alpha < 0.93, near, far)


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
    Accuracy: proved, rounding included: 0.83 ulp compiled with FMA, 3.72 without, 3.72 in NumPy;
    accuracy=1e-10: 6.69e-11 relative; accuracy=1e-6: 6.63e-07 relative; float32: 0.503 ulp
    (certificates/polar_moment.json).
    Source: eq. (2.17) of the paper. Operations: 29 mul, 26 add, 1 sub, 1 div, 1 max, 1 less, 1 select, 1 log.
    """
    return _call_polar_moment(alpha, out, where, accuracy)


def _moment_of_inertia(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, (-0.6, 0.20952380952380845, -0.04550264550262728, 0.006580086579932791,
        -0.0006738940064743411, 5.132550933405729e-05, -3.018866760709754e-06, 1.4122447118930764e-07,
        -5.375029553546074e-09, 1.6740315538468622e-10, -3.732683841190808e-12))
    near = (alpha_2 * (p1 * alpha_2) + alpha_2) / 1.5 * alpha
    b = 1.5707963267948966 - alpha
    b_2 = b * b
    p2 = horner(b_2, (-0.16666666666666646, -0.22222222222224858, 0.31111111111234796, -0.13121693124481915,
        0.029864785768700504, -0.0043696247326275185, 0.0004488358070079107, -3.423984087167627e-05,
        2.05744095772437e-06, -1.1937049677530915e-07))
    far = 0.5 * alpha + -0.1171875 + (b * p2 + 0.11718749999999999)
    return xp.where(alpha < 1.0, near, far)


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
    Accuracy: proved, rounding included: 0.783 ulp compiled with FMA, 3.9 without, 3.9 in NumPy; accuracy=1e-10:
    3.57e-12 relative; accuracy=1e-6: 2.42e-07 relative; float32: 0.503 ulp
    (certificates/moment_of_inertia.json).
    Source: eq. (3.12) of the paper. Operations: 26 mul, 23 add, 1 sub, 1 div, 1 less, 1 select.
    """
    return _call_moment_of_inertia(alpha, out, where, accuracy)


def _radial_weight_amplitude(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, (-0.30000000000000066, 0.027380952381014536, -0.00205026455232666,
        -2.9310932078856943e-05, -2.358979926715789e-05, -5.748939911380635e-06, -1.6071042972661217e-06,
        -4.27192161729551e-07, -2.1094020387158865e-07, 8.129338984711107e-08, -1.6096153527717823e-07,
        1.2122887937773674e-07, -7.33468076658569e-08, 2.5007234963925954e-08, -4.5188121572386835e-09))
    near = (alpha_2 * (p1 * alpha_2) + alpha_2) / 1.5 * alpha
    b = 1.5707963267948966 - alpha
    b_2 = b * b
    p2 = horner(b_2, (1.0000000000000404, -0.3333333333305296, 0.044444442966048575, -0.003174665132525031,
        0.0001406310379480802, -4.939780977762555e-06))
    p3 = horner(b_2, (-0.011294361119786078, 0.5870981203688485, -0.08591864082343585, 0.006850736078366394,
        -0.0003319900095938882, 1.1478604078416286e-05))
    t1 = b_2 * (p2 * xp.log(xp.maximum(2.0 * b, 8.673617379884035e-19)) + p3)
    far = 1.0 - b + (b * (b * -1.875 + 1.0) + t1)
    return xp.where(alpha < 1.02, near, far)


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
    p1 = horner(t1, (0.25801236203059347, 8.224581008808277, 36.601032371134735, 34.76818674305253, 7.195953669006319))
    p2 = horner(t1, (1.0, 31.26943231679909, 123.25899356161463, 65.38467016559643, -7.813125850567415,
        0.2995744918708443))
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
    Accuracy: proved, rounding included: 0.889 ulp compiled with FMA, 3.93 without, 3.93 in NumPy;
    accuracy=1e-10: 5.86e-11 relative; accuracy=1e-6: 3.41e-07 relative; float32: 0.505 ulp
    (certificates/radial_weight_amplitude.json).
    Source: eq. (2.23) of the paper. Operations: 34 mul, 29 add, 2 sub, 1 div, 1 max, 1 less, 1 select, 1 log.
    """
    return _call_radial_weight_amplitude(alpha, out, where, accuracy)


def _weight_moment_amplitude(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, (-0.5, 0.10833333333333311, -0.013558201058196795, 0.001109457671925056,
        -6.400813679259755e-05, 2.7432101373162098e-06, -9.076752700888329e-08, 2.38816894559699e-09,
        -5.091116216053079e-11, 8.187055569051608e-13))
    near = (alpha_2 * (p1 * alpha_2) + alpha_2) / 1.5 * alpha
    b = 1.5707963267948966 - alpha
    b_2 = b * b
    p2 = horner(b_2, (-0.9999999999999772, 0.5833333333306961, -0.16944444433167383, 0.027132934145921533,
        -0.002712164475090247, 0.00018474405199510153, -8.584869661319525e-06, -4.0914984693367235e-07))
    far = 0.6666666666666666 + b_2 * p2
    return xp.where(alpha < 1.14, near, far)


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
    Accuracy: proved, rounding included: 0.824 ulp compiled with FMA, 4.92 without, 4.92 in NumPy;
    accuracy=1e-10: 2.07e-12 relative; accuracy=1e-6: 4.38e-07 relative; float32: 0.503 ulp
    (certificates/weight_moment_amplitude.json).
    Source: eq. (3.13) of the paper. Operations: 22 mul, 18 add, 1 sub, 1 div, 1 less, 1 select.
    """
    return _call_weight_moment_amplitude(alpha, out, where, accuracy)


def _resistance_factor(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, (-0.08333333333333333, 0.002777777777777727, -4.960317460298492e-05,
        5.511463841362367e-07, -4.175351054736609e-09, 2.2941293244035988e-11, -9.552400725452637e-14,
        3.0090535662212205e-16))
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
    p1 = horner(alpha_2, (-0.4000000000000009, 0.08571428571435445, -0.010582010583821098,
        0.0008850409089482901, -4.736023206134585e-05, 2.824654298465376e-06, 8.93673762386861e-08,
        5.044137796935493e-08, 1.6984201153024313e-09, 1.2440331047706752e-08, -4.582723564839499e-09,
        1.889770671714059e-09))
    b = 1.5707963267948966 - alpha
    b_2 = b * b
    p2 = horner(b_2, (0.3333333333338518, -0.16666666655674875, 0.03611110500268692, -0.004519753612732019,
        0.00036703390178095813, -2.5834398517075226e-05))
    p3 = horner(b_2, (-0.008826837962552214, 0.0988578636158992, -0.033066047119410365, 0.005209921678910539,
        -0.0004988530376566277, 3.295754619092071e-05))
    t1 = b * b_2 * (p2 * xp.log(xp.maximum(b, 8.673617379884035e-19)) + p3) + 5.360408832255455e-17
    t2 = alpha < 0.93
    t3 = xp.where(t2, 1.0 + p1 * alpha_2, alpha + -0.5235987755982989 + t1)
    p4 = horner(alpha_2, (-0.08333333333333333, 0.002777777777777727, -4.960317460298492e-05,
        5.511463841362367e-07, -4.175351054736609e-09, 2.2941293244035988e-11, -9.552400725452637e-14,
        3.0090535662212205e-16))
    return xp.where(t2, t3 / 1.5, t3) / xp.where(t2, 1.0 + p4 * alpha_2, _resistance_factor(alpha))


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
    Accuracy: proved, rounding included: 0.924 ulp compiled with FMA, 4.62 without, 4.9 in NumPy
    (certificates/dynamic_coefficient.json).
    Source: eq. (2.24) of the paper. Operations: 37 mul, 35 add, 1 sub, 2 div, 1 max, 1 less, 3 select, 1 log.
    """
    return _call_dynamic_coefficient(alpha, out, where, accuracy)


def _weight_moment_per_inertia(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, (-0.5, 0.10833333333333331, -0.013558201058200455, 0.001109457671951761,
        -6.400813689411748e-05, 2.7432103616866782e-06, -9.076782643795506e-08, 2.388407067851668e-09,
        -5.101516744418913e-11, 8.379280740707739e-13))
    b = 1.5707963267948966 - alpha
    b_2 = b * b
    p2 = horner(b_2, (-0.9999999999999871, 0.5833333333324444, -0.169444444421841, 0.02713293622298696,
        -0.0027121893627596407, 0.00018490572238061962, -9.12555983644245e-06, 3.2103783038330574e-07))
    t1 = alpha < 1.0
    p3 = horner(alpha_2, (-0.6, 0.20952380952380845, -0.04550264550262728, 0.006580086579932791,
        -0.0006738940064743411, 5.132550933405729e-05, -3.018866760709754e-06, 1.4122447118930764e-07,
        -5.375029553546074e-09, 1.6740315538468622e-10, -3.732683841190808e-12))
    p4 = horner(b_2, (-0.16666666666666646, -0.22222222222224858, 0.31111111111234796, -0.13121693124481915,
        0.029864785768700504, -0.0043696247326275185, 0.0004488358070079107, -3.423984087167627e-05,
        2.05744095772437e-06, -1.1937049677530915e-07))
    t2 = xp.where(t1, 1.0 + p3 * alpha_2, 0.5 * alpha + -0.1171875 + (b * p4 + 0.11718749999999999))
    return xp.where(t1, 1.0 + p1 * alpha_2, 0.6666666666666666 + b_2 * p2) / t2


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
    Accuracy: proved, rounding included: 1.03 ulp compiled with FMA, 3.6 without, 3.6 in NumPy
    (certificates/weight_moment_per_inertia.json).
    Source: eq. (3.17) of the paper. Operations: 42 mul, 41 add, 1 sub, 1 div, 1 less, 2 select.
    """
    return _call_weight_moment_per_inertia(alpha, out, where, accuracy)


def _radial_weight_per_inertia(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, (-0.2999999999999999, 0.027380952380939495, -0.002050264549786367,
        -2.931097582881904e-05, -2.358934911464318e-05, -5.751963333931437e-06, -1.5931139807176382e-06,
        -4.733246249348672e-07, -1.00342932351716e-07, -1.1326873008824011e-07, 8.999334096323842e-08,
        -1.1324533913384523e-07, 8.103151569271108e-08, -4.2892782058850495e-08, 1.3382982815931337e-08,
        -2.139209998434664e-09))
    b = 1.5707963267948966 - alpha
    b_2 = b * b
    p2 = horner(b_2, (1.0000000000000464, -0.333333333323824, 0.04444444366472531, -0.0031746522241927555,
        0.0001406780287090666, -4.9168401285595965e-06))
    p3 = horner(b_2, (-0.011294361119764083, 0.5870981203831558, -0.08591864000408327, 0.006850740800236919,
        -0.0003320128199016475, 1.1438171613493169e-05))
    t1 = b_2 * (p2 * xp.log(xp.maximum(2.0 * b, 8.673617379884035e-19)) + p3)
    t2 = alpha < 1.03
    t3 = xp.where(t2, 1.0 + p1 * alpha_2, 1.0 - b + (b * (b * -1.875 + 1.0) + t1))
    p4 = horner(alpha_2, (-0.6, 0.20952380952380836, -0.04550264550262428, 0.006580086579892048,
        -0.0006738940061873448, 5.1325508135255255e-05, -3.01886359372378e-06, 1.4121903333477066e-07,
        -5.368971633832605e-09, 1.631776273622312e-10, -2.0553102512697325e-12, -2.8926984471622783e-13))
    p5 = horner(b_2, (-0.16666666666666646, -0.22222222222225121, 0.31111111111262857, -0.1312169312551838,
        0.029864785955206526, -0.0043696265965371605, 0.00044884668554678663, -3.4276716122893775e-05,
        2.1246918811419113e-06, -1.7039030552510834e-07))
    t4 = xp.where(t2, 1.0 + p4 * alpha_2, 0.5 * alpha + -0.1171875 + (b * p5 + 0.11718749999999999))
    return t3 / t4


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
    Accuracy: proved, rounding included: 1.13 ulp compiled with FMA, 3.16 without, 3.17 in NumPy
    (certificates/radial_weight_per_inertia.json).
    Source: eq. (3.17) of the paper. Operations: 56 mul, 54 add, 2 sub, 1 div, 1 max, 1 less, 2 select, 1 log.
    """
    return _call_radial_weight_per_inertia(alpha, out, where, accuracy)


def _polar_moment_per_inertia(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, (-0.4000000000000001, 0.08571428571429322, -0.010582010582251165,
        0.0008850408888557582, -4.7360082832704373e-05, 2.8239607230135376e-06, 9.14527657267713e-08,
        4.640187672689376e-08, 6.410866962893706e-09, 1.0060992875040901e-08, -5.955468143854293e-09,
        4.836465117910106e-09, -1.7917048191672271e-09, 4.017272391566167e-10))
    b = 1.5707963267948966 - alpha
    b_2 = b * b
    p2 = horner(b_2, (0.33333333333307696, -0.1666666668862208, 0.036111088421710145, -0.004519922077362515,
        0.00036666972541074983, -2.5945329335152922e-05))
    p3 = horner(b_2, (-0.008826837965495118, 0.09885786282011913, -0.033066072663597075, 0.0052097899146714855,
        -0.0004988389017989785, 3.310128751531202e-05))
    t1 = b * b_2 * (p2 * xp.log(xp.maximum(b, 8.673617379884035e-19)) + p3) + 5.360408832255455e-17
    t2 = alpha < 1.0
    p4 = horner(alpha_2, (-0.6, 0.20952380952380845, -0.04550264550262728, 0.006580086579932791,
        -0.0006738940064743411, 5.132550933405729e-05, -3.018866760709754e-06, 1.4122447118930764e-07,
        -5.375029553546074e-09, 1.6740315538468622e-10, -3.732683841190808e-12))
    p5 = horner(b_2, (-0.16666666666666646, -0.22222222222224858, 0.31111111111234796, -0.13121693124481915,
        0.029864785768700504, -0.0043696247326275185, 0.0004488358070079107, -3.423984087167627e-05,
        2.05744095772437e-06, -1.1937049677530915e-07))
    t3 = xp.where(t2, 1.0 + p4 * alpha_2, 0.5 * alpha + -0.1171875 + (b * p5 + 0.11718749999999999))
    return xp.where(t2, 1.0 + p1 * alpha_2, alpha + -0.5235987755982989 + t1) / t3


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
    Accuracy: proved, rounding included: 0.885 ulp compiled with FMA, 3.01 without, 3.01 in NumPy
    (certificates/polar_moment_per_inertia.json).
    Source: eq. (3.18) of the paper. Operations: 51 mul, 51 add, 1 sub, 1 div, 1 max, 1 less, 2 select, 1 log.
    """
    return _call_polar_moment_per_inertia(alpha, out, where, accuracy)


def _weight_moment_per_radial_weight(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, (-0.5, 0.1083333333333333, -0.013558201058200155, 0.0011094576719492572,
        -6.400813688327872e-05, 2.7432103345270403e-06, -9.076778552804277e-08, 2.388370515571034e-09,
        -5.099731404727816e-11, 8.342554711571668e-13))
    b = 1.5707963267948966 - alpha
    b_2 = b * b
    p2 = horner(b_2, (-0.9999999999999859, 0.5833333333322787, -0.16944444441544115, 0.027132936115055552,
        -0.0027121884343851966, 0.00018490146712436985, -9.1156670921878e-06, 3.118689539390622e-07))
    t1 = alpha < 1.03
    p3 = horner(alpha_2, (-0.2999999999999999, 0.027380952380939495, -0.002050264549786367,
        -2.931097582881904e-05, -2.358934911464318e-05, -5.751963333931437e-06, -1.5931139807176382e-06,
        -4.733246249348672e-07, -1.00342932351716e-07, -1.1326873008824011e-07, 8.999334096323842e-08,
        -1.1324533913384523e-07, 8.103151569271108e-08, -4.2892782058850495e-08, 1.3382982815931337e-08,
        -2.139209998434664e-09))
    p4 = horner(b_2, (1.0000000000000464, -0.333333333323824, 0.04444444366472531, -0.0031746522241927555,
        0.0001406780287090666, -4.9168401285595965e-06))
    p5 = horner(b_2, (-0.011294361119764083, 0.5870981203831558, -0.08591864000408327, 0.006850740800236919,
        -0.0003320128199016475, 1.1438171613493169e-05))
    t2 = b_2 * (p4 * xp.log(xp.maximum(2.0 * b, 8.673617379884035e-19)) + p5)
    t3 = xp.where(t1, 1.0 + p3 * alpha_2, 1.0 - b + (b * (b * -1.875 + 1.0) + t2))
    return xp.where(t1, 1.0 + p1 * alpha_2, 0.6666666666666666 + b_2 * p2) / t3


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
    Accuracy: proved, rounding included: 1.15 ulp compiled with FMA, 4.99 without, 4.85 in NumPy
    (certificates/weight_moment_per_radial_weight.json).
    Source: eq. (3.21) of the paper. Operations: 51 mul, 48 add, 2 sub, 1 div, 1 max, 1 less, 2 select, 1 log.
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
    p1 = horner(alpha_2, (1.0, -0.16666666666666666, 0.008333333333333333, -0.0001984126984126984,
        2.7557319223985893e-06, -2.505210838544172e-08, 1.6059043836821613e-10, -7.647163731819816e-13,
        2.8114572543455206e-15, -8.22063524662433e-18, 1.9572941063391263e-20, -3.868170170630684e-23,
        6.446950284384474e-26, -9.183689863795546e-29))
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
    Source: eq. (2.23) of the paper. Operations: 89 mul, 70 add, 12 sub, 5 div, 2 neg, 3 min, 2 max, 2 less, 3
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
    p1 = horner(alpha_2, (1.0, -0.16666666666666666, 0.008333333333333333, -0.0001984126984126984,
        2.7557319223985893e-06, -2.505210838544172e-08, 1.6059043836821613e-10, -7.647163731819816e-13,
        2.8114572543455206e-15, -8.22063524662433e-18, 1.9572941063391263e-20, -3.868170170630684e-23,
        6.446950284384474e-26, -9.183689863795546e-29))
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
    Source: eq. (3.13) of the paper. Operations: 47 mul, 37 add, 11 sub, 1 div, 2 neg, 1 min, 1 less, 1 select,
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
    Source: eq. (3.21) of the paper. Operations: 57 mul, 52 add, 8 sub, 2 div, 1 min, 1 max, 1 less, 2 select, 1
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
