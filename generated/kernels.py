# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: 6a5438587d3373b39770b615acd7cbda0a66a1fb286a6c6f10cc0c5a3ba03bce
"""Moments, weights and quotients of the arc, from their definitions."""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from generated._compiled import Text, kernel
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

# What NumPy runs, by kernel and tier.
TEXTS: dict[str, dict[str, Text]] = {}


def _polar_moment(alpha: Array, xp: Any = np) -> Array:
    v1 = alpha * alpha
    v11 = ((2.5389062459137545e-10 * v1 + -1.535039446871726e-09) * v1 + 4.858247011588724e-09) * v1 + -8.737187294724759e-09
    v20 = ((v11 * v1 + 1.2368322935058749e-08) * v1 + -7.1580083195333975e-09) * v1 + 1.7955154929181704e-08
    v29 = ((v20 * v1 + 4.0834903094607294e-08) * v1 + 9.337445867814892e-08) * v1 + 2.8234940702881187e-06
    v40 = (((v29 * v1 + -4.736000567461671e-05) * v1 + 0.000885040880629919) * v1 + -0.010582010581735324) * v1
    v52 = 1.5707963267948966 - alpha
    v53 = v52 * v52
    v63 = ((3.292146877449988e-05 * v53 + -0.0004987833640429598) * v53 + 0.005209901976095983) * v53 + -0.03306605933076026
    v79 = ((-2.578267895028451e-05 * v53 + 0.00036703445349598303) * v53 + -0.004519807110141118) * v53 + 0.036111096108339666
    v89 = ((v79 * v53 + -0.16666666678253228) * v53 + 0.33333333333324544) * xp.log(xp.maximum(v52, 8.673617379884035e-19))
    v94 = v52 * v53 * (v89 + ((v63 * v53 + 0.09885786309049466) * v53 + -0.00882683796482655)) + 0.015463724401701127
    v100 = xp.where(alpha < 1.06, (v1 * (((v40 + 0.08571428571427717) * v1 + -0.3999999999999999) * v1) + v1) / 1.5 * alpha, alpha + -0.5390625 + v94)
    return v100


def _polar_moment_1e_10(alpha: Array, xp: Any = np) -> Array:
    v1 = alpha * alpha
    v3 = 2.4674011002723395 - v1
    v13 = ((0.058876226263682115 * v3 + 2.924173333296739) * v3 + 17.372410880113158) * v3 + 101.88292373597345
    v25 = (((v13 * v3 + 188.0609794452953) * v3 + 92.09333594378792) * v3 + 11.481432227545879) * v3 + 0.27018982302843847
    v36 = ((-0.1210440526494234 * v3 + 3.451058209446253) * v3 + -40.532846996251536) * v3 + 167.31840391801205
    v48 = (((v36 * v3 + 592.4905912523266) * v3 + 327.93026766650274) * v3 + 42.18998405310376) * v3 + 1.0
    v50 = v25 * v1 / v48 * alpha
    return v50


def _polar_moment_1e_6(alpha: Array, xp: Any = np) -> Array:
    v1 = alpha * alpha
    v11 = ((1.3553916148132743e-05 * v1 + -0.00012300991011412324) * v1 + 0.0004641334116873807) * v1 + -0.0009462187190355254
    v22 = (((v11 * v1 + 0.001603521078160282) * v1 + -0.007671609149860532) * v1 + 0.05732983555205492) * v1
    v28 = ((v22 + -0.26668864793741015) * v1 + 0.6666671005494391) * v1 * alpha
    return v28


def _polar_moment_float32(alpha: Array, xp: Any = np) -> Array:
    v1 = alpha * alpha
    v3 = 2.4674011002723395 - v1
    v13 = ((0.06414296134293003 * v3 + 0.9297869610419341) * v3 + 6.300636026761616) * v3 + 29.69445259391
    v25 = (((v13 * v3 + 69.64967393431827) * v3 + 47.82136127644069) * v3 + 8.321440448598144) * v3 + 0.2701898230006029
    v36 = ((0.23038315612586163 * v3 + -5.545295729315065) * v3 + 32.75732007943386) * v3 + 204.0410319285895
    v47 = v25 * v1 / (((v36 * v3 + 167.63021002311652) * v3 + 30.494533122537817) * v3 + 1.0) * alpha
    return v47


TEXTS["polar_moment"] = {"best": _polar_moment, "1e-10": _polar_moment_1e_10, "1e-6": _polar_moment_1e_6, "float32": _polar_moment_float32}
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
    v1 = alpha * alpha
    v11 = ((1.4479305864374496e-10 * v1 + -5.315887776253596e-09) * v1 + 1.4113705860392406e-07) * v1 + -3.018786567118006e-06
    v22 = (((v11 * v1 + 5.132546211756001e-05) * v1 + -0.0006738939886585666) * v1 + 0.006580086575761721) * v1
    v31 = v1 * ((((v22 + -0.04550264550206386) * v1 + 0.20952380952377056) * v1 + -0.5999999999999991) * v1)
    v37 = 1.5707963267948966 - alpha
    v38 = v37 * v37
    v48 = ((1.8663660698510027e-06 * v38 + -3.411169653682064e-05) * v38 + 0.00044878890078446106) * v38 + -0.004369614517657968
    v59 = (((v48 * v38 + 0.02986478441763371) * v38 + -0.13121693113874042) * v38 + 0.3111111111077384) * v38
    v71 = 0.5 * alpha + -0.1328125 + (v37 * ((v59 + -0.22222222222215263) * v38 + -0.1666666666666672) + 0.1328125)
    v74 = xp.where(alpha < 1.04, (v31 + v1) / 1.5 * alpha, v71)
    return v74


def _moment_of_inertia_1e_10(alpha: Array, xp: Any = np) -> Array:
    v1 = alpha * alpha
    v11 = ((-2.3953502944853665e-09 * v1 + 8.812338767321207e-08) * v1 + -1.9950359696495124e-06) * v1 + 3.4185573188242115e-05
    v22 = (((v11 * v1 + -0.0004492273466971816) * v1 + 0.004386699926783207) * v1 + -0.0303350871470488) * v1
    v31 = (((v22 + 0.1396825376348758) * v1 + -0.3999999998316554) * v1 + 0.6666666666643195) * v1 * alpha
    return v31


def _moment_of_inertia_1e_6(alpha: Array, xp: Any = np) -> Array:
    v1 = alpha * alpha
    v11 = ((2.0082920286826588e-05 * v1 + -0.000403298571291692) * v1 + 0.004308477621092885) * v1 + -0.03026448683123845
    v22 = (((v11 * v1 + 0.13965129672735824) * v1 + -0.39999462582420825) * v1 + 0.6666665071706455) * v1 * alpha
    return v22


def _moment_of_inertia_float32(alpha: Array, xp: Any = np) -> Array:
    v1 = alpha * alpha
    v11 = ((6.067635607731889e-08 * v1 + -1.8634045174042801e-06) * v1 + 3.384325821315492e-05) * v1 + -0.0004487049076745006
    v22 = (((v11 * v1 + 0.004386227374003602) * v1 + -0.030334844229585666) * v1 + 0.13968247408715742) * v1
    v28 = ((v22 + -0.39999999328741215) * v1 + 0.6666666665497277) * v1 * alpha
    return v28


TEXTS["moment_of_inertia"] = {"best": _moment_of_inertia, "1e-10": _moment_of_inertia_1e_10, "1e-6": _moment_of_inertia_1e_6, "float32": _moment_of_inertia_float32}
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
    v1 = alpha * alpha
    v11 = ((-1.4755252283863973e-09 * v1 + 1.431517905747653e-08) * v1 + -6.620230319236922e-08) * v1 + 1.8874892154394597e-07
    v22 = (((v11 * v1 + -3.71129271596167e-07) * v1 + 5.257481069240742e-07) * v1 + -5.634927377087995e-07) * v1
    v31 = (((v22 + 4.365790675108399e-07) * v1 + -3.1762046893209714e-07) * v1 + -8.101057950761354e-09) * v1
    v40 = (((v31 + -5.04949574608979e-07) * v1 + -1.585007778277986e-06) * v1 + -5.7534777342876125e-06) * v1
    v49 = (((v40 + -2.358915071705018e-05) * v1 + -2.931099301644356e-05) * v1 + -0.002050264548889697) * v1
    v61 = 1.5707963267948966 - alpha
    v62 = v61 * v61
    v72 = ((1.011431311417566e-05 * v62 + -0.00033238232410696576) * v62 + 0.0068508659329300425) * v62 + -0.08591862806465715
    v88 = ((-4.079654945729119e-06 * v62 + 0.00014187659175596328) * v62 + -0.003174420422838561) * v62 + 0.04444445253534339
    v100 = ((v88 * v62 + -0.33333333326382136) * v62 + 1.0000000000000828) * xp.log(xp.maximum(2.0 * v61, 8.673617379884035e-19))
    v104 = v62 * (v100 + ((v72 * v62 + 0.5870981205218737) * v62 + 0.11370563888037802)) + 0.01928933660255172
    v117 = xp.where(alpha < 1.14, (v1 * (((v49 + 0.02738095238091564) * v1 + -0.29999999999999966) * v1) + v1) / 1.5 * alpha, 0.5 * alpha + 0.1953125 + (v61 * (v61 * -2.0 + 0.5) + v104))
    return v117


def _radial_weight_amplitude_1e_10(alpha: Array, xp: Any = np) -> Array:
    v1 = alpha * alpha
    v3 = 2.4674011002723395 - v1
    v13 = ((34205630.793633714 * v3 + 813313646.8119079) * v3 + 5646454336.979666) * v3 + 13342513505.110321
    v25 = (((v13 * v3 + 11890031808.210299) * v3 + 4006787534.1965985) * v3 + 487791535.0085183) * v3 + 19765640.525143933
    v45 = ((14117638.984697843 * v3 + -481748049.5507379) * v3 + 4809333505.187634) * v3 + 30457363960.293766
    v57 = (((v45 * v3 + 37692912285.01263) * v3 + 14432151525.685879) * v3 + 1844741626.5491843) * v3 + 76059724.29630841
    v67 = (((v25 * v3 + 233461.82406543285) * v3 + 641.5972189319754) * v3 + 0.2580122754802636) * v1 / (((v57 * v3 + 903337.2314638863) * v3 + 2486.084692390184) * v3 + 1.0)
    v68 = v67 * alpha
    return v68


def _radial_weight_amplitude_1e_6(alpha: Array, xp: Any = np) -> Array:
    v1 = alpha * alpha
    v3 = 2.4674011002723395 - v1
    v13 = ((0.3095579708379847 * v3 + 5.441400718506571) * v3 + 24.086548523952633) * v3 + 27.706040179137357
    v30 = ((-2.461606616849178 * v3 + 42.267614275244746) * v3 + 91.34715133265911) * v3 + 27.029402721585523
    v35 = ((v13 * v3 + 7.130575609363919) * v3 + 0.25801239057120384) * v1 / (v30 * v3 + 1.0) * alpha
    return v35


def _radial_weight_amplitude_float32(alpha: Array, xp: Any = np) -> Array:
    v1 = alpha * alpha
    v3 = 2.4674011002723395 - v1
    v13 = ((430153.8542312948 * v3 + 11285361.253041798) * v3 + 72463713.17090172) * v3 + 148401585.24043858
    v25 = (((v13 * v3 + 108350816.76157898) * v3 + 27787633.640274998) * v3 + 2330133.7496379497) * v3 + 56347.855766680615
    v42 = ((230360.80867666923 * v3 + -7497699.99752473) * v3 + 74805268.88796055) * v3 + 370828964.64343065
    v54 = (((v42 * v3 + 359918483.66369116) * v3 + 102370874.21533594) * v3 + 8899441.692057962) * v3 + 217650.15907975892
    v61 = ((v25 * v3 + 315.3984503326471) * v3 + 0.25801227552627604) * v1 / ((v54 * v3 + 1221.8085422638378) * v3 + 1.0)
    v62 = v61 * alpha
    return v62


TEXTS["radial_weight_amplitude"] = {"best": _radial_weight_amplitude, "1e-10": _radial_weight_amplitude_1e_10, "1e-6": _radial_weight_amplitude_1e_6, "float32": _radial_weight_amplitude_float32}
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
    v1 = alpha * alpha
    v11 = ((8.339688103371207e-13 * v1 + -5.0995940299020745e-11) * v1 + 2.3883677784975775e-09) * v1 + -9.076778260218794e-08
    v20 = ((v11 * v1 + 2.7432103327249243e-06) * v1 + -6.400813688264376e-05) * v1 + 0.0011094576719491399
    v34 = (v1 * ((((v20 * v1 + -0.013558201058200147) * v1 + 0.1083333333333333) * v1 + -0.5) * v1) + v1) / 1.5
    v37 = 1.5707963267948966 - alpha
    v38 = v37 * v37
    v48 = ((3.3026082585149297e-07 * v38 + -9.13736805715034e-06) * v38 + 0.00018491188411207517) * v38 + -0.002712191042308909
    v59 = (((v48 * v38 + 0.027132936477346933) * v38 + -0.16944444444280285) * v38 + 0.5833333333332911) * v38
    v72 = v37 * (v37 * -0.75 + 0.5) + (v38 * (v59 + -0.2499999999999996) + (v37 * -1.2246467991473532e-16 + -0.0015439967307816123))
    v79 = xp.where(alpha < 1.04, v34 * alpha, 0.5 * alpha + -0.1171875 + v72)
    return v79


def _weight_moment_amplitude_1e_10(alpha: Array, xp: Any = np) -> Array:
    v1 = alpha * alpha
    v11 = ((1.2431444217923382e-09 * v1 + -5.8896078807575524e-08) * v1 + 1.8246695364307174e-06) * v1 + -4.266582272700972e-05
    v22 = (((v11 * v1 + 0.0007396327967499843) * v1 + -0.009038797804484562) * v1 + 0.07222222146402071) * v1
    v28 = ((v22 + -0.33333333325541464) * v1 + 0.6666666666653104) * v1 * alpha
    return v28


def _weight_moment_amplitude_1e_6(alpha: Array, xp: Any = np) -> Array:
    v1 = alpha * alpha
    v11 = ((-3.0487249815407907e-05 * v1 + 0.0007055263399624791) * v1 + -0.008992837331217642) * v1 + 0.07219326041626052
    v19 = ((v11 * v1 + -0.3333263814016009) * v1 + 0.6666663784539829) * v1 * alpha
    return v19


def _weight_moment_amplitude_float32(alpha: Array, xp: Any = np) -> Array:
    v1 = alpha * alpha
    v11 = ((-4.6119747876616884e-08 * v1 + 1.7710020240603323e-06) * v1 + -4.254754715360433e-05) * v1 + 0.0007394869977279918
    v22 = (((v11 * v1 + -0.009038698970556838) * v1 + 0.07222218799987005) * v1 + -0.3333333288344924) * v1
    v25 = (v22 + 0.6666666665660732) * v1 * alpha
    return v25


TEXTS["weight_moment_amplitude"] = {"best": _weight_moment_amplitude, "1e-10": _weight_moment_amplitude_1e_10, "1e-6": _weight_moment_amplitude_1e_6, "float32": _weight_moment_amplitude_float32}
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
    v1 = alpha * alpha
    v11 = ((3.0090535662212205e-16 * v1 + -9.552400725452637e-14) * v1 + 2.2941293244035988e-11) * v1 + -4.175351054736609e-09
    v22 = (((v11 * v1 + 5.511463841362367e-07) * v1 + -4.960317460298492e-05) * v1 + 0.002777777777777727) * v1
    v27 = (v1 * ((v22 + -0.08333333333333333) * v1) + v1) * alpha
    return v27


def _resistance_factor_1e_10(alpha: Array, xp: Any = np) -> Array:
    v1 = alpha * alpha
    v11 = ((-4.007433105099138e-09 * v1 + 5.506785717843854e-07) * v1 + -4.960257036031239e-05) * v1 + 0.002777777423221201
    v19 = ((v11 * v1 + -0.08333333325677353) * v1 + 0.9999999999972994) * v1 * alpha
    return v19


def _resistance_factor_1e_6(alpha: Array, xp: Any = np) -> Array:
    v1 = alpha * alpha
    v11 = ((-4.692255852080745e-05 * v1 + 0.002773612256777145) * v1 + -0.08333123626934905) * v1 + 0.9999998318478346
    v13 = v11 * v1 * alpha
    return v13


def _resistance_factor_float32(alpha: Array, xp: Any = np) -> Array:
    v1 = alpha * alpha
    v11 = ((-4.007433105099138e-09 * v1 + 5.506785717843854e-07) * v1 + -4.960257036031239e-05) * v1 + 0.002777777423221201
    v19 = ((v11 * v1 + -0.08333333325677353) * v1 + 0.9999999999972994) * v1 * alpha
    return v19


TEXTS["resistance_factor"] = {"best": _resistance_factor, "1e-10": _resistance_factor_1e_10, "1e-6": _resistance_factor_1e_6, "float32": _resistance_factor_float32}
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
    v2 = alpha * alpha
    v12 = ((1.6626223621024597e-10 * v2 + -1.6286878242945004e-09) * v2 + 7.583637118101315e-09) * v2 + -2.1613153923147333e-08
    v21 = ((v12 * v2 + 4.223518046373998e-08) * v2 + -5.8718978986658795e-08) * v2 + 6.183369010976702e-08
    v30 = ((v21 * v2 + -4.392760924048977e-08) * v2 + 3.8569975506359614e-08) * v2 + 3.215892014327322e-08
    v41 = (((v30 * v2 + 9.607871394302501e-08) * v2 + 2.822884338426451e-06) * v2 + -4.735990982233164e-05) * v2
    v51 = (((v41 + 0.0008850408707033633) * v2 + -0.010582010581117055) * v2 + 0.08571428571425747) * v2 + -0.3999999999999997
    v55 = 1.5707963267948966 - alpha
    v56 = v55 * v55
    v66 = ((2.9872353280334895e-05 * v56 + -0.0004968503493886828) * v56 + 0.005211052149520961) * v56 + -0.03306598168250652
    v82 = ((-2.222090620284525e-05 * v56 + 0.0003719086683763541) * v56 + -0.00451885966831341) * v56 + 0.03611113551017215
    v92 = ((v82 * v56 + -0.16666666645179565) * v56 + 0.33333333333356946) * xp.log(xp.maximum(v55, 8.673617379884035e-19))
    v97 = v55 * v56 * (v92 + ((v66 * v56 + 0.09885786403242842) * v56 + -0.008826837963451475)) + 0.015463724401701127
    v102 = alpha < 1.18
    v103 = xp.where(v102, 1.0 + v51 * v2, alpha + -0.5390625 + v97)
    v116 = ((3.0090535662212205e-16 * v2 + -9.552400725452637e-14) * v2 + 2.2941293244035988e-11) * v2 + -4.175351054736609e-09
    v127 = (((v116 * v2 + 5.511463841362367e-07) * v2 + -4.960317460298492e-05) * v2 + 0.002777777777777727) * v2
    v129 = (v127 + -0.08333333333333333) * v2
    v134 = xp.where(v102, 1.0 + v129, (v2 * v129 + v2) * alpha)
    v136 = xp.where(v102, v103 / 1.5, v103) / xp.where(v102, v134, v134)
    return v136


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
    v2 = alpha * alpha
    v12 = ((8.311677077858953e-13 * v2 + -5.098164781997805e-11) * v2 + 2.388337116754608e-09) * v2 + -9.076774672061455e-08
    v23 = (((v12 * v2 + 2.7432103078892563e-06) * v2 + -6.400813687235277e-05) * v2 + 0.001109457671946687) * v2
    v34 = 1.5707963267948966 - alpha
    v35 = v34 * v34
    v45 = ((3.3227677166736995e-07 * v35 + -9.139492424160367e-06) * v35 + 0.0001849127952255673) * v35 + -0.002712191246293181
    v56 = (((v45 * v35 + 0.027132936502729948) * v35 + -0.16944444444452478) * v35 + 0.5833333333333486) * v35
    v69 = v34 * (v34 * -0.75 + 0.5) + (v35 * (v56 + -0.25000000000000033) + (v34 * -1.2246467991473532e-16 + -0.01716899673078161))
    v72 = 0.5 * alpha + -0.1015625
    v75 = alpha < 1.06
    v76 = xp.where(v75, 1.0 + (((v23 + -0.013558201058199847) * v2 + 0.10833333333333328) * v2 + -0.5) * v2, v72 + v69)
    v86 = ((-3.83202657381123e-12 * v2 + 1.6791198438408976e-10) * v2 + -5.376140679440608e-09) * v2 + 1.4122581998292043e-07
    v95 = ((v86 * v2 + -3.018867755411378e-06) * v2 + 5.132550979125799e-05) * v2 + -0.0006738940066034418
    v107 = (((v95 * v2 + 0.00658008657995396) * v2 + -0.04550264550262906) * v2 + 0.2095238095238085) * v2 + -0.6
    v119 = ((1.912335320748958e-06 * v35 + -3.4165472134294174e-05) * v35 + 0.00044881492633847974) * v35 + -0.00436962124279994
    v130 = (((v119 * v35 + 0.029864785416135266) * v35 + -0.13121693122399697) * v35 + 0.3111111111116941) * v35
    v139 = xp.where(v75, 1.0 + v107 * v2, v72 + (v34 * ((v130 + -0.22222222222223978) * v35 + -0.1666666666666665) + 0.10156249999999999))
    v140 = v76 / v139
    return v140


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
    v2 = alpha * alpha
    v12 = ((-1.1586039910451562e-09 * v2 + 1.073684857797492e-08) * v2 + -4.7680010378922496e-08) * v2 + 1.305065578176369e-07
    v21 = ((v12 * v2 + -2.468524552204202e-07) * v2 + 3.353626380489223e-07) * v2 + -3.4743252232526025e-07
    v30 = ((v21 * v2 + 2.5182679267513344e-07) * v2 + -1.977170416160583e-07) * v2 + -6.713430538813725e-08
    v39 = ((v30 * v2 + -4.830686635855356e-07) * v2 + -1.5910204621339517e-06) * v2 + -5.752282822587549e-06
    v48 = ((v39 * v2 + -2.358931609263516e-05) * v2 + -2.931097796918108e-05) * v2 + -0.0020502645497105835
    v58 = 1.5707963267948966 - alpha
    v59 = v58 * v58
    v69 = ((1.060969811375175e-05 * v59 + -0.0003322866718334205) * v59 + 0.00685082383403923) * v59 + -0.08591863114699338
    v85 = ((-4.4058766217095835e-06 * v59 + 0.00014146896597637675) * v59 + -0.0031744875985231327) * v59 + 0.04444445040892791
    v97 = ((v85 * v59 + -0.33333333327526726) * v59 + 1.0000000000000775) * xp.log(xp.maximum(2.0 * v58, 8.673617379884035e-19))
    v101 = v59 * (v97 + ((v69 * v59 + 0.5870981204939706) * v59 + -0.011294361119643392)) + 0.04272683660255172
    v108 = 0.5 * alpha
    v113 = alpha < 1.12
    v114 = xp.where(v113, 1.0 + ((v48 * v2 + 0.02738095238093843) * v2 + -0.2999999999999999) * v2, v108 + 0.171875 + (v58 * (v58 * -1.875 + 0.5) + v101))
    v124 = ((-3.816499096792332e-12 * v2 + 1.6780773246644826e-10) * v2 + -5.375842228035577e-09) * v2 + 1.4122534371639664e-07
    v133 = ((v124 * v2 + -3.0188672910288945e-06) * v2 + 5.132550950640006e-05) * v2 + -0.0006738940064945646
    v144 = (((v133 * v2 + 0.00658008657992928) * v2 + -0.0455026455026261) * v2 + 0.20952380952380836) * v2
    v157 = ((2.0785159488122554e-06 * v59 + -3.430940961037193e-05) * v59 + 0.0004488660001961668) * v59 + -0.004369630780617362
    v168 = (((v157 * v59 + 0.029864786417086647) * v59 + -0.13121693128224232) * v59 + 0.31111111111341694) * v59
    v178 = v108 + -0.09375 + (v58 * ((v168 + -0.22222222222226065) * v59 + -0.16666666666666644) + 0.09374999999999999)
    v180 = v114 / xp.where(v113, 1.0 + (v144 + -0.6) * v2, v178)
    return v180


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
    v2 = alpha * alpha
    v12 = ((1.0438507136322873e-09 * v2 + -4.1011157201467435e-09) * v2 + 1.0635642342643017e-08) * v2 + -1.0080735545578033e-08
    v23 = (((v12 * v2 + 2.3200699326773943e-08) * v2 + 3.65851715201639e-08) * v2 + 9.54924982273984e-08) * v2
    v32 = (((v23 + 2.822804137356218e-06) * v2 + -4.735985877395161e-05) * v2 + 0.000885040860908459) * v2
    v41 = 1.0 + (((v32 + -0.010582010580190438) * v2 + 0.08571428571421652) * v2 + -0.3999999999999991) * v2
    v43 = 1.5707963267948966 - alpha
    v44 = v43 * v43
    v54 = ((5.141697843624536e-05 * v44 + -0.0007526763708477574) * v44 + 0.008342729184846673) * v44 + -0.05809638684427457
    v70 = ((-2.6119064549573967e-05 * v44 + 0.0003661824477726528) * v44 + -0.004520115161148769) * v44 + 0.0361110720734664
    v82 = ((v70 * v44 + -0.16666666716897885) * v44 + 0.33333333333247117) * xp.log(xp.maximum(2.0 * v43, 8.673617379884035e-19))
    v87 = v43 * v44 * (v82 + ((v54 * v44 + 0.21438239256080094) * v44 + -0.2398758981538578)) + 0.023276224401701125
    v91 = alpha < 1.0
    v102 = ((1.4675229409541942e-10 * v2 + -5.3256984711383125e-09) * v2 + 1.4115790231721552e-07) * v2 + -3.0188110309881937e-06
    v113 = (((v102 * v2 + 5.132547941677655e-05) * v2 + -0.000673893996196225) * v2 + 0.0065800865777468414) * v2
    v122 = 1.0 + (((v113 + -0.04550264550236013) * v2 + 0.20952380952379232) * v2 + -0.5999999999999996) * v2
    v132 = ((-1.1937049677530915e-07 * v44 + 2.05744095772437e-06) * v44 + -3.423984087167627e-05) * v44 + 0.0004488358070079107
    v141 = ((v132 * v44 + -0.0043696247326275185) * v44 + 0.029864785768700504) * v44 + -0.13121693124481915
    v152 = v43 * (((v141 * v44 + 0.31111111111234796) * v44 + -0.22222222222224858) * v44 + -0.16666666666666646)
    v160 = xp.where(v91, v41, alpha + -0.546875 + v87) / xp.where(v91, v122, 0.5 * alpha + -0.1171875 + (v152 + 0.11718749999999999))
    return v160


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
    v2 = alpha * alpha
    v12 = ((8.205773118275206e-13 * v2 + -5.0922462259974074e-11) * v2 + 2.3881976877903854e-09) * v2 + -9.076756699884043e-08
    v23 = (((v12 * v2 + 2.743210170353137e-06) * v2 + -6.400813680902941e-05) * v2 + 0.0011094576719297984) * v2
    v34 = 1.5707963267948966 - alpha
    v35 = v34 * v34
    v45 = ((3.02606622886103e-07 * v35 + -9.116104748851073e-06) * v35 + 0.00018490525920221364) * v35 + -0.002712189970245263
    v56 = (((v45 * v35 + 0.027132936381399846) * v35 + -0.16944444443813225) * v35 + 0.583333333333178) * v35
    v69 = v34 * (v34 * -0.875 + 0.5) + (v35 * (v56 + -0.12499999999999852) + (v34 * -1.2246467991473532e-16 + -0.048418996730781615))
    v70 = 0.5 * alpha
    v75 = alpha < 1.13
    v76 = xp.where(v75, 1.0 + (((v23 + -0.013558201058197508) * v2 + 0.10833333333333316) * v2 + -0.5) * v2, v70 + -0.0703125 + v69)
    v86 = ((-2.750170988699041e-09 * v2 + 2.429554005631876e-08) * v2 + -1.0281605241196749e-07) * v2 + 2.663310221256971e-07
    v95 = ((v86 * v2 + -4.7480898739475487e-07) * v2 + 5.997407424406731e-07) * v2 + -5.821614082905277e-07
    v104 = ((v95 * v2 + 3.593124674080841e-07) * v2 + -3.491992005720133e-07) * v2 + -3.7560944307809877e-07
    v113 = ((v104 * v2 + -1.6213538572889048e-06) * v2 + -5.746092779161184e-06) * v2 + -2.359019575838328e-05
    v122 = ((v113 * v2 + -2.9310895742984074e-05) * v2 + -0.0020502645543247324) * v2 + 0.027380952381070512
    v137 = ((1.039171256004066e-05 * v35 + -0.00033233199219427515) * v35 + 0.006850842796753032) * v35 + -0.08591862970310375
    v153 = ((-4.263599921619414e-06 * v35 + 0.00014165161709039066) * v35 + -0.003174456678003164) * v35 + 0.04444445141438387
    v165 = ((v153 * v35 + -0.33333333326970643) * v35 + 1.0000000000000802) * xp.log(xp.maximum(2.0 * v34, 8.673617379884035e-19))
    v169 = v35 * (v165 + ((v137 * v35 + 0.5870981205074514) * v35 + -0.011294361119632735)) + 0.04272683660255172
    v178 = xp.where(v75, 1.0 + (v122 * v2 + -0.3000000000000012) * v2, v70 + 0.171875 + (v34 * (v34 * -1.875 + 0.5) + v169))
    v179 = v76 / v178
    return v179


TEXTS["weight_moment_per_radial_weight"] = {"best": _weight_moment_per_radial_weight}
_call_weight_moment_per_radial_weight = kernel("weight_moment_per_radial_weight", TEXTS["weight_moment_per_radial_weight"])


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
    v4 = 0.5 * theta_2
    v5 = 0.5 * theta_1
    v7 = np.minimum(1.5707963267948966, v4 - v5)
    v8 = -theta_1
    v9 = theta_2 + v8
    v10 = v9 - theta_2
    v16 = v5 + v4
    v17 = theta_1 + theta_2
    v18 = v17 - theta_1
    v24 = v7 * v7
    v34 = ((-1.4755252283863973e-09 * v24 + 1.431517905747653e-08) * v24 + -6.620230319236922e-08) * v24 + 1.8874892154394597e-07
    v43 = ((v34 * v24 + -3.71129271596167e-07) * v24 + 5.257481069240742e-07) * v24 + -5.634927377087995e-07
    v52 = ((v43 * v24 + 4.365790675108399e-07) * v24 + -3.1762046893209714e-07) * v24 + -8.101057950761354e-09
    v61 = ((v52 * v24 + -5.04949574608979e-07) * v24 + -1.585007778277986e-06) * v24 + -5.7534777342876125e-06
    v70 = ((v61 * v24 + -2.358915071705018e-05) * v24 + -2.931099301644356e-05) * v24 + -0.002050264548889697
    v82 = (v24 * (((v70 * v24 + 0.02738095238091564) * v24 + -0.29999999999999966) * v24) + v24) / 1.5 * v7
    v83 = 1.5707963267948966 - v7
    v84 = v83 * v83
    v94 = ((1.011431311417566e-05 * v84 + -0.00033238232410696576) * v84 + 0.0068508659329300425) * v84 + -0.08591862806465715
    v110 = ((-4.079654945729119e-06 * v84 + 0.00014187659175596328) * v84 + -0.003174420422838561) * v84 + 0.04444445253534339
    v122 = ((v110 * v84 + -0.33333333326382136) * v84 + 1.0000000000000828) * np.log(np.maximum(2.0 * v83, 8.673617379884035e-19))
    v126 = v84 * (v122 + ((v94 * v84 + 0.5870981205218737) * v84 + 0.11370563888037802)) + 0.01928933660255172
    v144 = np.cos(v7)
    v154 = ((-9.183689863795546e-29 * v24 + 6.446950284384474e-26) * v24 + -3.868170170630684e-23) * v24 + 1.9572941063391263e-20
    v163 = ((v154 * v24 + -8.22063524662433e-18) * v24 + 2.8114572543455206e-15) * v24 + -7.647163731819816e-13
    v172 = ((v163 * v24 + 1.6059043836821613e-10) * v24 + -2.505210838544172e-08) * v24 + 2.7557319223985893e-06
    v181 = ((v172 * v24 + -0.0001984126984126984) * v24 + 0.008333333333333333) * v24 + -0.16666666666666666
    v184 = v181 * v24 + 1.0
    v185 = v184 * v184
    v186 = 4.0 * v144
    v188 = 1.0 + v144
    v192 = v184 / v188 * v7
    v197 = np.maximum(-0.4, np.minimum(0.4, v192))
    v198 = v197 * v197
    v208 = ((0.024390243902439025 * v198 + 0.02564102564102564) * v198 + 0.02702702702702703) * v198 + 0.02857142857142857
    v217 = ((v208 * v198 + 0.030303030303030304) * v198 + 0.03225806451612903) * v198 + 0.034482758620689655
    v229 = (((v217 * v198 + 0.037037037037037035) * v198 + 0.04) * v198 + 0.043478260869565216) * v198 + 0.047619047619047616
    v238 = ((v229 * v198 + 0.05263157894736842) * v198 + 0.058823529411764705) * v198 + 0.06666666666666667
    v248 = (((v238 * v198 + 0.07692307692307693) * v198 + 0.09090909090909091) * v198 + 0.1111111111111111) * v198
    v258 = np.abs(v192) < 0.4
    v260 = np.minimum(0.9999999999999999, np.where(v258, 0.4, v192))
    v266 = np.where(v258, ((v248 + 0.14285714285714285) * v198 + 0.2) * v198 + 0.3333333333333333, (np.arctanh(v260) - v260) / (v260 * (v260 * v260)))
    v277 = (v186 * v185 / v188 + v186 * (v185 * v185) * v266 / (v188 * (v188 * v188)) * v7 * v7) * v7 * v7 * (0.5 * (theta_2 - (v9 - v10) + (v8 - v10)))
    v279 = (np.cos(v16) * (0.5 * (theta_1 - (v17 - v18) + (theta_2 - v18))) + np.sin(v16)) * (np.where(v7 < 1.14, v82, 0.5 * v7 + 0.1953125 + (v83 * (v83 * -2.0 + 0.5) + v126)) + v277)
    v280 = -v279
    return v280


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
    Accuracy: the error of radial_weight_amplitude in NumPy plus 2 ulp of the amplitude (sampled only: no
    certificate).
    Source: eq. (2.23) of the paper. Operations: 93 mul, 75 add, 11 sub, 5 div, 2 neg, 3 min, 2 max, 2 less, 3
    select, 1 abs, 1 arctanh, 2 cos, 1 log, 1 sin.
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
    v24 = v7 * v7
    v34 = ((8.339688103371207e-13 * v24 + -5.0995940299020745e-11) * v24 + 2.3883677784975775e-09) * v24 + -9.076778260218794e-08
    v43 = ((v34 * v24 + 2.7432103327249243e-06) * v24 + -6.400813688264376e-05) * v24 + 0.0011094576719491399
    v55 = v24 * ((((v43 * v24 + -0.013558201058200147) * v24 + 0.1083333333333333) * v24 + -0.5) * v24) + v24
    v59 = 1.5707963267948966 - v7
    v60 = v59 * v59
    v70 = ((3.3026082585149297e-07 * v60 + -9.13736805715034e-06) * v60 + 0.00018491188411207517) * v60 + -0.002712191042308909
    v81 = (((v70 * v60 + 0.027132936477346933) * v60 + -0.16944444444280285) * v60 + 0.5833333333332911) * v60
    v93 = v59 * (v59 * -0.75 + 0.5) + (v60 * (v81 + -0.2499999999999996) + (v59 * -1.2246467991473532e-16 + -0.0015439967307816123))
    v116 = ((-9.183689863795546e-29 * v24 + 6.446950284384474e-26) * v24 + -3.868170170630684e-23) * v24 + 1.9572941063391263e-20
    v125 = ((v116 * v24 + -8.22063524662433e-18) * v24 + 2.8114572543455206e-15) * v24 + -7.647163731819816e-13
    v134 = ((v125 * v24 + 1.6059043836821613e-10) * v24 + -2.505210838544172e-08) * v24 + 2.7557319223985893e-06
    v143 = ((v134 * v24 + -0.0001984126984126984) * v24 + 0.008333333333333333) * v24 + -0.16666666666666666
    v146 = v143 * v24 + 1.0
    v153 = np.where(v7 < 1.04, v55 / 1.5 * v7, 0.5 * v7 + -0.1171875 + v93) + 2.0 * np.cos(v7) * (v146 * v146) * v7 * v7 * (0.5 * (theta_2 - (v9 - v10) + (v8 - v10)))
    v155 = -((np.cos(v16) - np.sin(v16) * (0.5 * (theta_1 - (v17 - v18) + (theta_2 - v18)))) * v153)
    return v155


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
    Accuracy: the error of weight_moment_amplitude in NumPy plus 2 ulp of the amplitude (sampled only: no
    certificate).
    Source: eq. (3.13) of the paper. Operations: 51 mul, 42 add, 11 sub, 1 div, 2 neg, 1 min, 1 less, 1 select,
    2 cos, 1 sin.
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
    v17 = v7 * v7
    v27 = ((8.205773118275206e-13 * v17 + -5.0922462259974074e-11) * v17 + 2.3881976877903854e-09) * v17 + -9.076756699884043e-08
    v36 = ((v27 * v17 + 2.743210170353137e-06) * v17 + -6.400813680902941e-05) * v17 + 0.0011094576719297984
    v48 = 1.5707963267948966 - v7
    v49 = v48 * v48
    v59 = ((3.02606622886103e-07 * v49 + -9.116104748851073e-06) * v49 + 0.00018490525920221364) * v49 + -0.002712189970245263
    v70 = (((v59 * v49 + 0.027132936381399846) * v49 + -0.16944444443813225) * v49 + 0.583333333333178) * v49
    v82 = v48 * (v48 * -0.875 + 0.5) + (v49 * (v70 + -0.12499999999999852) + (v48 * -1.2246467991473532e-16 + -0.048418996730781615))
    v83 = 0.5 * v7
    v88 = v7 < 1.13
    v89 = np.where(v88, 1.0 + (((v36 * v17 + -0.013558201058197508) * v17 + 0.10833333333333316) * v17 + -0.5) * v17, v83 + -0.0703125 + v82)
    v99 = ((-2.750170988699041e-09 * v17 + 2.429554005631876e-08) * v17 + -1.0281605241196749e-07) * v17 + 2.663310221256971e-07
    v108 = ((v99 * v17 + -4.7480898739475487e-07) * v17 + 5.997407424406731e-07) * v17 + -5.821614082905277e-07
    v117 = ((v108 * v17 + 3.593124674080841e-07) * v17 + -3.491992005720133e-07) * v17 + -3.7560944307809877e-07
    v126 = ((v117 * v17 + -1.6213538572889048e-06) * v17 + -5.746092779161184e-06) * v17 + -2.359019575838328e-05
    v135 = ((v126 * v17 + -2.9310895742984074e-05) * v17 + -0.0020502645543247324) * v17 + 0.027380952381070512
    v150 = ((1.039171256004066e-05 * v49 + -0.00033233199219427515) * v49 + 0.006850842796753032) * v49 + -0.08591862970310375
    v166 = ((-4.263599921619414e-06 * v49 + 0.00014165161709039066) * v49 + -0.003174456678003164) * v49 + 0.04444445141438387
    v178 = ((v166 * v49 + -0.33333333326970643) * v49 + 1.0000000000000802) * np.log(np.maximum(2.0 * v48, 8.673617379884035e-19))
    v182 = v49 * (v178 + ((v150 * v49 + 0.5870981205074514) * v49 + -0.011294361119632735)) + 0.04272683660255172
    v191 = np.where(v88, 1.0 + (v135 * v17 + -0.3000000000000012) * v17, v83 + 0.171875 + (v48 * (v48 * -1.875 + 0.5) + v182))
    v193 = np.cos(v8)
    v194 = np.sin(v8)
    v200 = (v193 - v194 * v15) / (v193 * v15 + v194) * (v89 / v191)
    return v200


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
    Source: eq. (3.21) of the paper. Operations: 62 mul, 60 add, 7 sub, 2 div, 1 min, 1 max, 1 less, 2 select, 1
    cos, 1 log, 1 sin.
    """
    return evaluate(_limit_friction, lambda eps, theta_1, theta_2: (theta_2 >= theta_1) & (0.5 * theta_2 - 0.5 * theta_1 <= 1.5707963267948966 * (1.0 + 4.0 * eps)) & np.isfinite(theta_1), (4.0, 5.0), (theta_1, theta_2), out, where)
