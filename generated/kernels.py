# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: 7aaf6fde0bb594f84ebc5a993bdc50b95fc01b5cc8fdd4a5eee6cf1650de7b24
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
    v11 = ((1.889770671714059e-09 * v1 + -4.582723564839499e-09) * v1 + 1.2440331047706752e-08) * v1 + 1.6984201153024313e-09
    v22 = (((v11 * v1 + 5.044137796935493e-08) * v1 + 8.93673762386861e-08) * v1 + 2.824654298465376e-06) * v1
    v31 = (((v22 + -4.736023206134585e-05) * v1 + 0.0008850409089482901) * v1 + -0.010582010583821098) * v1
    v43 = 1.5707963267948966 - alpha
    v44 = v43 * v43
    v54 = ((3.295754619092071e-05 * v44 + -0.0004988530376566277) * v44 + 0.005209921678910539) * v44 + -0.033066047119410365
    v70 = ((-2.5834398517075226e-05 * v44 + 0.00036703390178095813) * v44 + -0.004519753612732019) * v44 + 0.03611110500268692
    v80 = ((v70 * v44 + -0.16666666655674875) * v44 + 0.3333333333338518) * xp.log(xp.maximum(v43, 8.673617379884035e-19))
    v85 = v43 * v44 * (v80 + ((v54 * v44 + 0.0988578636158992) * v44 + -0.008826837962552214)) + 5.360408832255455e-17
    v91 = xp.where(alpha < 0.93, (v1 * (((v31 + 0.08571428571435445) * v1 + -0.4000000000000009) * v1) + v1) / 1.5 * alpha, alpha + -0.5235987755982989 + v85)
    return v91


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
    Accuracy: proved, rounding included: 0.83 ulp compiled with FMA, 3.72 without, 3.72 in NumPy;
    accuracy=1e-10: 6.69e-11 relative; accuracy=1e-6: 6.63e-07 relative; float32: 0.503 ulp
    (certificates/polar_moment.json).
    Source: eq. (2.17) of the paper. Operations: 29 mul, 26 add, 1 sub, 1 div, 1 max, 1 less, 1 select, 1 log.
    """
    return _call_polar_moment(alpha, out, where, accuracy)


def _moment_of_inertia(alpha: Array, xp: Any = np) -> Array:
    v1 = alpha * alpha
    v11 = ((-3.732683841190808e-12 * v1 + 1.6740315538468622e-10) * v1 + -5.375029553546074e-09) * v1 + 1.4122447118930764e-07
    v20 = ((v11 * v1 + -3.018866760709754e-06) * v1 + 5.132550933405729e-05) * v1 + -0.0006738940064743411
    v31 = (((v20 * v1 + 0.006580086579932791) * v1 + -0.04550264550262728) * v1 + 0.20952380952380845) * v1
    v40 = 1.5707963267948966 - alpha
    v41 = v40 * v40
    v51 = ((-1.1937049677530915e-07 * v41 + 2.05744095772437e-06) * v41 + -3.423984087167627e-05) * v41 + 0.0004488358070079107
    v60 = ((v51 * v41 + -0.0043696247326275185) * v41 + 0.029864785768700504) * v41 + -0.13121693124481915
    v71 = v40 * (((v60 * v41 + 0.31111111111234796) * v41 + -0.22222222222224858) * v41 + -0.16666666666666646)
    v80 = xp.where(alpha < 1.0, (v1 * ((v31 + -0.6) * v1) + v1) / 1.5 * alpha, 0.5 * alpha + -0.1171875 + (v71 + 0.11718749999999999))
    return v80


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
    Accuracy: proved, rounding included: 0.783 ulp compiled with FMA, 3.9 without, 3.9 in NumPy; accuracy=1e-10:
    3.57e-12 relative; accuracy=1e-6: 2.42e-07 relative; float32: 0.503 ulp
    (certificates/moment_of_inertia.json).
    Source: eq. (3.12) of the paper. Operations: 26 mul, 23 add, 1 sub, 1 div, 1 less, 1 select.
    """
    return _call_moment_of_inertia(alpha, out, where, accuracy)


def _radial_weight_amplitude(alpha: Array, xp: Any = np) -> Array:
    v1 = alpha * alpha
    v11 = ((-4.5188121572386835e-09 * v1 + 2.5007234963925954e-08) * v1 + -7.33468076658569e-08) * v1 + 1.2122887937773674e-07
    v20 = ((v11 * v1 + -1.6096153527717823e-07) * v1 + 8.129338984711107e-08) * v1 + -2.1094020387158865e-07
    v29 = ((v20 * v1 + -4.27192161729551e-07) * v1 + -1.6071042972661217e-06) * v1 + -5.748939911380635e-06
    v38 = ((v29 * v1 + -2.358979926715789e-05) * v1 + -2.9310932078856943e-05) * v1 + -0.00205026455232666
    v50 = (v1 * (((v38 * v1 + 0.027380952381014536) * v1 + -0.30000000000000066) * v1) + v1) / 1.5 * alpha
    v52 = 1.5707963267948966 - alpha
    v53 = v52 * v52
    v63 = ((1.1478604078416286e-05 * v53 + -0.0003319900095938882) * v53 + 0.006850736078366394) * v53 + -0.08591864082343585
    v79 = ((-4.939780977762555e-06 * v53 + 0.0001406310379480802) * v53 + -0.003174665132525031) * v53 + 0.044444442966048575
    v91 = ((v79 * v53 + -0.3333333333305296) * v53 + 1.0000000000000404) * xp.log(xp.maximum(2.0 * v52, 8.673617379884035e-19))
    v99 = v52 * (v52 * -1.875 + 1.0) + v53 * (v91 + ((v63 * v53 + 0.5870981203688485) * v53 + -0.011294361119786078))
    v105 = xp.where(alpha < 1.02, v50, alpha + -0.5707963267948966 + v99)
    return v105


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
    v13 = ((7.195953669006319 * v3 + 34.76818674305253) * v3 + 36.601032371134735) * v3 + 8.224581008808277
    v27 = ((0.2995744918708443 * v3 + -7.813125850567415) * v3 + 65.38467016559643) * v3 + 123.25899356161463
    v35 = (v13 * v3 + 0.25801236203059347) * v1 / ((v27 * v3 + 31.26943231679909) * v3 + 1.0) * alpha
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
    Accuracy: proved, rounding included: 0.889 ulp compiled with FMA, 3.93 without, 3.93 in NumPy;
    accuracy=1e-10: 5.86e-11 relative; accuracy=1e-6: 3.41e-07 relative; float32: 0.505 ulp
    (certificates/radial_weight_amplitude.json).
    Source: eq. (2.23) of the paper. Operations: 34 mul, 30 add, 1 sub, 1 div, 1 max, 1 less, 1 select, 1 log.
    """
    return _call_radial_weight_amplitude(alpha, out, where, accuracy)


def _weight_moment_amplitude(alpha: Array, xp: Any = np) -> Array:
    v1 = alpha * alpha
    v11 = ((8.187055569051608e-13 * v1 + -5.091116216053079e-11) * v1 + 2.38816894559699e-09) * v1 + -9.076752700888329e-08
    v22 = (((v11 * v1 + 2.7432101373162098e-06) * v1 + -6.400813679259755e-05) * v1 + 0.001109457671925056) * v1
    v34 = (v1 * ((((v22 + -0.013558201058196795) * v1 + 0.10833333333333311) * v1 + -0.5) * v1) + v1) / 1.5
    v37 = 1.5707963267948966 - alpha
    v38 = v37 * v37
    v48 = ((3.351225419331419e-07 * v38 + -9.141581197542956e-06) * v38 + 0.00018491338192303807) * v38 + -0.0027121913216134426
    v63 = v38 * v38 * (((v48 * v38 + 0.027132936506283845) * v38 + -0.16944444444442117) * v38 + 0.5833333333333343)
    v74 = 0.5 * alpha + -0.11873149673078154 + (v37 * (v37 * -1.0 + 0.5) + (v63 + (v37 * -1.2246467991473532e-16 + -7.401486830834378e-17)))
    v77 = xp.where(alpha < 1.14, v34 * alpha, v74)
    return v77


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
    Accuracy: proved, rounding included: 0.824 ulp compiled with FMA, 4.92 without, 4.92 in NumPy;
    accuracy=1e-10: 2.07e-12 relative; accuracy=1e-6: 4.38e-07 relative; float32: 0.503 ulp
    (certificates/weight_moment_amplitude.json).
    Source: eq. (3.13) of the paper. Operations: 26 mul, 22 add, 1 sub, 1 div, 1 less, 1 select.
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
    v12 = ((1.889770671714059e-09 * v2 + -4.582723564839499e-09) * v2 + 1.2440331047706752e-08) * v2 + 1.6984201153024313e-09
    v23 = (((v12 * v2 + 5.044137796935493e-08) * v2 + 8.93673762386861e-08) * v2 + 2.824654298465376e-06) * v2
    v32 = (((v23 + -4.736023206134585e-05) * v2 + 0.0008850409089482901) * v2 + -0.010582010583821098) * v2
    v40 = 1.5707963267948966 - alpha
    v41 = v40 * v40
    v51 = ((3.295754619092071e-05 * v41 + -0.0004988530376566277) * v41 + 0.005209921678910539) * v41 + -0.033066047119410365
    v67 = ((-2.5834398517075226e-05 * v41 + 0.00036703390178095813) * v41 + -0.004519753612732019) * v41 + 0.03611110500268692
    v77 = ((v67 * v41 + -0.16666666655674875) * v41 + 0.3333333333338518) * xp.log(xp.maximum(v40, 8.673617379884035e-19))
    v82 = v40 * v41 * (v77 + ((v51 * v41 + 0.0988578636158992) * v41 + -0.008826837962552214)) + 5.360408832255455e-17
    v87 = alpha < 0.93
    v88 = xp.where(v87, 1.0 + ((v32 + 0.08571428571435445) * v2 + -0.4000000000000009) * v2, alpha + -0.5235987755982989 + v82)
    v98 = ((3.0090535662212205e-16 * v2 + -9.552400725452637e-14) * v2 + 2.2941293244035988e-11) * v2 + -4.175351054736609e-09
    v109 = (((v98 * v2 + 5.511463841362367e-07) * v2 + -4.960317460298492e-05) * v2 + 0.002777777777777727) * v2
    v111 = (v109 + -0.08333333333333333) * v2
    v116 = xp.where(v87, 1.0 + v111, (v2 * v111 + v2) * alpha)
    v121 = xp.where(v87, v88 / 1.5, v88) / xp.where(v87, v116, v116)
    return v121


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
    Source: eq. (2.24) of the paper. Operations: 37 mul, 35 add, 1 sub, 2 div, 1 max, 1 less, 4 select, 1 log.
    """
    return _call_dynamic_coefficient(alpha, out, where, accuracy)


def _weight_moment_per_inertia(alpha: Array, xp: Any = np) -> Array:
    v2 = alpha * alpha
    v12 = ((8.379280740707739e-13 * v2 + -5.101516744418913e-11) * v2 + 2.388407067851668e-09) * v2 + -9.076782643795506e-08
    v23 = (((v12 * v2 + 2.7432103616866782e-06) * v2 + -6.400813689411748e-05) * v2 + 0.001109457671951761) * v2
    v34 = 1.5707963267948966 - alpha
    v35 = v34 * v34
    v45 = ((3.288361253494495e-07 * v35 + -9.135845922674888e-06) * v35 + 0.000184911243733198) * v35 + -0.002712190909258921
    v60 = v35 * v35 * (((v45 * v35 + 0.027132936463543637) * v35 + -0.16944444444220988) * v35 + 0.583333333333291)
    v68 = 0.5 * alpha
    v71 = v68 + -0.11873149673078154 + (v34 * (v34 * -1.0 + 0.5) + (v60 + (v34 * -1.2246467991473532e-16 + -7.401486830834378e-17)))
    v72 = alpha < 1.0
    v73 = xp.where(v72, 1.0 + (((v23 + -0.013558201058200455) * v2 + 0.10833333333333331) * v2 + -0.5) * v2, v71)
    v83 = ((-3.732683841190808e-12 * v2 + 1.6740315538468622e-10) * v2 + -5.375029553546074e-09) * v2 + 1.4122447118930764e-07
    v92 = ((v83 * v2 + -3.018866760709754e-06) * v2 + 5.132550933405729e-05) * v2 + -0.0006738940064743411
    v103 = (((v92 * v2 + 0.006580086579932791) * v2 + -0.04550264550262728) * v2 + 0.20952380952380845) * v2
    v116 = ((-1.1937049677530915e-07 * v35 + 2.05744095772437e-06) * v35 + -3.423984087167627e-05) * v35 + 0.0004488358070079107
    v125 = ((v116 * v35 + -0.0043696247326275185) * v35 + 0.029864785768700504) * v35 + -0.13121693124481915
    v136 = v34 * (((v125 * v35 + 0.31111111111234796) * v35 + -0.22222222222224858) * v35 + -0.16666666666666646)
    v142 = v73 / xp.where(v72, 1.0 + (v103 + -0.6) * v2, v68 + -0.1171875 + (v136 + 0.11718749999999999))
    return v142


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
    Accuracy: proved, rounding included: 1.03 ulp compiled with FMA, 3.23 without, 3.23 in NumPy
    (certificates/weight_moment_per_inertia.json).
    Source: eq. (3.17) of the paper. Operations: 45 mul, 45 add, 1 sub, 1 div, 1 less, 2 select.
    """
    return _call_weight_moment_per_inertia(alpha, out, where, accuracy)


def _radial_weight_per_inertia(alpha: Array, xp: Any = np) -> Array:
    v2 = alpha * alpha
    v12 = ((-2.139209998434664e-09 * v2 + 1.3382982815931337e-08) * v2 + -4.2892782058850495e-08) * v2 + 8.103151569271108e-08
    v21 = ((v12 * v2 + -1.1324533913384523e-07) * v2 + 8.999334096323842e-08) * v2 + -1.1326873008824011e-07
    v30 = ((v21 * v2 + -1.00342932351716e-07) * v2 + -4.733246249348672e-07) * v2 + -1.5931139807176382e-06
    v39 = ((v30 * v2 + -5.751963333931437e-06) * v2 + -2.358934911464318e-05) * v2 + -2.931097582881904e-05
    v49 = (((v39 * v2 + -0.002050264549786367) * v2 + 0.027380952380939495) * v2 + -0.2999999999999999) * v2
    v52 = 1.5707963267948966 - alpha
    v53 = v52 * v52
    v63 = ((1.1438171613493169e-05 * v53 + -0.0003320128199016475) * v53 + 0.006850740800236919) * v53 + -0.08591864000408327
    v79 = ((-4.9168401285595965e-06 * v53 + 0.0001406780287090666) * v53 + -0.0031746522241927555) * v53 + 0.04444444366472531
    v91 = ((v79 * v53 + -0.333333333323824) * v53 + 1.0000000000000464) * xp.log(xp.maximum(2.0 * v52, 8.673617379884035e-19))
    v98 = v52 * (v52 * -1.875 + 1.0) + v53 * (v91 + ((v63 * v53 + 0.5870981203831558) * v53 + -0.011294361119764083))
    v103 = alpha < 1.03
    v114 = ((-2.8926984471622783e-13 * v2 + -2.0553102512697325e-12) * v2 + 1.631776273622312e-10) * v2 + -5.368971633832605e-09
    v123 = ((v114 * v2 + 1.4121903333477066e-07) * v2 + -3.01886359372378e-06) * v2 + 5.1325508135255255e-05
    v134 = (((v123 * v2 + -0.0006738940061873448) * v2 + 0.006580086579892048) * v2 + -0.04550264550262428) * v2
    v149 = ((-1.7039030552510834e-07 * v53 + 2.1246918811419113e-06) * v53 + -3.4276716122893775e-05) * v53
    v158 = (((v149 + 0.00044884668554678663) * v53 + -0.0043696265965371605) * v53 + 0.029864785955206526) * v53
    v168 = (((v158 + -0.1312169312551838) * v53 + 0.31111111111262857) * v53 + -0.22222222222225121) * v53 + -0.16666666666666646
    v177 = xp.where(v103, 1.0 + ((v134 + 0.20952380952380836) * v2 + -0.6) * v2, 0.5 * alpha + -0.1171875 + (v52 * v168 + 0.11718749999999999))
    v178 = xp.where(v103, 1.0 + v49, alpha + -0.5707963267948966 + v98) / v177
    return v178


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
    Source: eq. (3.17) of the paper. Operations: 56 mul, 55 add, 1 sub, 1 div, 1 max, 1 less, 2 select, 1 log.
    """
    return _call_radial_weight_per_inertia(alpha, out, where, accuracy)


def _polar_moment_per_inertia(alpha: Array, xp: Any = np) -> Array:
    v2 = alpha * alpha
    v12 = ((4.017272391566167e-10 * v2 + -1.7917048191672271e-09) * v2 + 4.836465117910106e-09) * v2 + -5.955468143854293e-09
    v23 = (((v12 * v2 + 1.0060992875040901e-08) * v2 + 6.410866962893706e-09) * v2 + 4.640187672689376e-08) * v2
    v32 = (((v23 + 9.14527657267713e-08) * v2 + 2.8239607230135376e-06) * v2 + -4.7360082832704373e-05) * v2
    v42 = (((v32 + 0.0008850408888557582) * v2 + -0.010582010582251165) * v2 + 0.08571428571429322) * v2 + -0.4000000000000001
    v46 = 1.5707963267948966 - alpha
    v47 = v46 * v46
    v57 = ((3.310128751531202e-05 * v47 + -0.0004988389017989785) * v47 + 0.0052097899146714855) * v47 + -0.033066072663597075
    v73 = ((-2.5945329335152922e-05 * v47 + 0.00036666972541074983) * v47 + -0.004519922077362515) * v47 + 0.036111088421710145
    v83 = ((v73 * v47 + -0.1666666668862208) * v47 + 0.33333333333307696) * xp.log(xp.maximum(v46, 8.673617379884035e-19))
    v88 = v46 * v47 * (v83 + ((v57 * v47 + 0.09885786282011913) * v47 + -0.008826837965495118)) + 5.360408832255455e-17
    v92 = alpha < 1.0
    v103 = ((-3.732683841190808e-12 * v2 + 1.6740315538468622e-10) * v2 + -5.375029553546074e-09) * v2 + 1.4122447118930764e-07
    v112 = ((v103 * v2 + -3.018866760709754e-06) * v2 + 5.132550933405729e-05) * v2 + -0.0006738940064743411
    v123 = (((v112 * v2 + 0.006580086579932791) * v2 + -0.04550264550262728) * v2 + 0.20952380952380845) * v2
    v136 = ((-1.1937049677530915e-07 * v47 + 2.05744095772437e-06) * v47 + -3.423984087167627e-05) * v47 + 0.0004488358070079107
    v145 = ((v136 * v47 + -0.0043696247326275185) * v47 + 0.029864785768700504) * v47 + -0.13121693124481915
    v156 = v46 * (((v145 * v47 + 0.31111111111234796) * v47 + -0.22222222222224858) * v47 + -0.16666666666666646)
    v163 = xp.where(v92, 1.0 + (v123 + -0.6) * v2, 0.5 * alpha + -0.1171875 + (v156 + 0.11718749999999999))
    v164 = xp.where(v92, 1.0 + v42 * v2, alpha + -0.5235987755982989 + v88) / v163
    return v164


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
    v2 = alpha * alpha
    v12 = ((8.342554711571668e-13 * v2 + -5.099731404727816e-11) * v2 + 2.388370515571034e-09) * v2 + -9.076778552804277e-08
    v21 = ((v12 * v2 + 2.7432103345270403e-06) * v2 + -6.400813688327872e-05) * v2 + 0.0011094576719492572
    v34 = 1.5707963267948966 - alpha
    v35 = v34 * v34
    v45 = ((3.3027683347881747e-07 * v35 + -9.137450665661518e-06) * v35 + 0.00018491195613480358) * v35 + -0.0027121910690977792
    v60 = v35 * v35 * (((v45 * v35 + 0.027132936482417516) * v35 + -0.16944444444330195) * v35 + 0.5833333333333145)
    v71 = 0.5 * alpha + -0.11873149673078154 + (v34 * (v34 * -1.0 + 0.5) + (v60 + (v34 * -1.2246467991473532e-16 + -7.401486830834378e-17)))
    v73 = alpha < 1.03
    v74 = xp.where(v73, 1.0 + (((v21 * v2 + -0.013558201058200155) * v2 + 0.1083333333333333) * v2 + -0.5) * v2, v71)
    v84 = ((-2.139209998434664e-09 * v2 + 1.3382982815931337e-08) * v2 + -4.2892782058850495e-08) * v2 + 8.103151569271108e-08
    v93 = ((v84 * v2 + -1.1324533913384523e-07) * v2 + 8.999334096323842e-08) * v2 + -1.1326873008824011e-07
    v102 = ((v93 * v2 + -1.00342932351716e-07) * v2 + -4.733246249348672e-07) * v2 + -1.5931139807176382e-06
    v111 = ((v102 * v2 + -5.751963333931437e-06) * v2 + -2.358934911464318e-05) * v2 + -2.931097582881904e-05
    v121 = (((v111 * v2 + -0.002050264549786367) * v2 + 0.027380952380939495) * v2 + -0.2999999999999999) * v2
    v132 = ((1.1438171613493169e-05 * v35 + -0.0003320128199016475) * v35 + 0.006850740800236919) * v35 + -0.08591864000408327
    v148 = ((-4.9168401285595965e-06 * v35 + 0.0001406780287090666) * v35 + -0.0031746522241927555) * v35 + 0.04444444366472531
    v160 = ((v148 * v35 + -0.333333333323824) * v35 + 1.0000000000000464) * xp.log(xp.maximum(2.0 * v34, 8.673617379884035e-19))
    v167 = v34 * (v34 * -1.875 + 1.0) + v35 * (v160 + ((v132 * v35 + 0.5870981203831558) * v35 + -0.011294361119764083))
    v172 = v74 / xp.where(v73, 1.0 + v121, alpha + -0.5707963267948966 + v167)
    return v172


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
    Accuracy: proved, rounding included: 1.15 ulp compiled with FMA, 3.52 without, 3.66 in NumPy
    (certificates/weight_moment_per_radial_weight.json).
    Source: eq. (3.21) of the paper. Operations: 55 mul, 53 add, 1 sub, 1 div, 1 max, 1 less, 2 select, 1 log.
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
    v34 = ((-4.5188121572386835e-09 * v24 + 2.5007234963925954e-08) * v24 + -7.33468076658569e-08) * v24 + 1.2122887937773674e-07
    v43 = ((v34 * v24 + -1.6096153527717823e-07) * v24 + 8.129338984711107e-08) * v24 + -2.1094020387158865e-07
    v52 = ((v43 * v24 + -4.27192161729551e-07) * v24 + -1.6071042972661217e-06) * v24 + -5.748939911380635e-06
    v61 = ((v52 * v24 + -2.358979926715789e-05) * v24 + -2.9310932078856943e-05) * v24 + -0.00205026455232666
    v73 = (v24 * (((v61 * v24 + 0.027380952381014536) * v24 + -0.30000000000000066) * v24) + v24) / 1.5 * v7
    v74 = 1.5707963267948966 - v7
    v75 = v74 * v74
    v85 = ((1.1478604078416286e-05 * v75 + -0.0003319900095938882) * v75 + 0.006850736078366394) * v75 + -0.08591864082343585
    v101 = ((-4.939780977762555e-06 * v75 + 0.0001406310379480802) * v75 + -0.003174665132525031) * v75 + 0.044444442966048575
    v113 = ((v101 * v75 + -0.3333333333305296) * v75 + 1.0000000000000404) * np.log(np.maximum(2.0 * v74, 8.673617379884035e-19))
    v121 = v74 * (v74 * -1.875 + 1.0) + v75 * (v113 + ((v85 * v75 + 0.5870981203688485) * v75 + -0.011294361119786078))
    v133 = np.cos(v7)
    v143 = ((-9.183689863795546e-29 * v24 + 6.446950284384474e-26) * v24 + -3.868170170630684e-23) * v24 + 1.9572941063391263e-20
    v152 = ((v143 * v24 + -8.22063524662433e-18) * v24 + 2.8114572543455206e-15) * v24 + -7.647163731819816e-13
    v161 = ((v152 * v24 + 1.6059043836821613e-10) * v24 + -2.505210838544172e-08) * v24 + 2.7557319223985893e-06
    v170 = ((v161 * v24 + -0.0001984126984126984) * v24 + 0.008333333333333333) * v24 + -0.16666666666666666
    v172 = v170 * v24 + 1.0
    v173 = v172 * v172
    v174 = 4.0 * v133
    v176 = 1.0 + v133
    v180 = v172 / v176 * v7
    v185 = np.maximum(-0.4, np.minimum(0.4, v180))
    v186 = v185 * v185
    v196 = ((0.024390243902439025 * v186 + 0.02564102564102564) * v186 + 0.02702702702702703) * v186 + 0.02857142857142857
    v205 = ((v196 * v186 + 0.030303030303030304) * v186 + 0.03225806451612903) * v186 + 0.034482758620689655
    v217 = (((v205 * v186 + 0.037037037037037035) * v186 + 0.04) * v186 + 0.043478260869565216) * v186 + 0.047619047619047616
    v226 = ((v217 * v186 + 0.05263157894736842) * v186 + 0.058823529411764705) * v186 + 0.06666666666666667
    v236 = (((v226 * v186 + 0.07692307692307693) * v186 + 0.09090909090909091) * v186 + 0.1111111111111111) * v186
    v246 = np.abs(v180) < 0.4
    v248 = np.minimum(0.9999999999999999, np.where(v246, 0.4, v180))
    v254 = np.where(v246, ((v236 + 0.14285714285714285) * v186 + 0.2) * v186 + 0.3333333333333333, (np.arctanh(v248) - v248) / (v248 * (v248 * v248)))
    v265 = (v174 * v173 / v176 + v174 * (v173 * v173) * v254 / (v176 * (v176 * v176)) * v7 * v7) * v7 * v7 * (0.5 * (theta_2 - (v9 - v10) + (v8 - v10)))
    v267 = (np.cos(v16) * (0.5 * (theta_1 - (v17 - v18) + (theta_2 - v18))) + np.sin(v16)) * (np.where(v7 < 1.02, v73, v7 + -0.5707963267948966 + v121) + v265)
    v268 = -v267
    return v268


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
    Source: eq. (2.23) of the paper. Operations: 89 mul, 71 add, 11 sub, 5 div, 2 neg, 3 min, 2 max, 2 less, 3
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
    v34 = ((8.187055569051608e-13 * v24 + -5.091116216053079e-11) * v24 + 2.38816894559699e-09) * v24 + -9.076752700888329e-08
    v43 = ((v34 * v24 + 2.7432101373162098e-06) * v24 + -6.400813679259755e-05) * v24 + 0.001109457671925056
    v55 = v24 * ((((v43 * v24 + -0.013558201058196795) * v24 + 0.10833333333333311) * v24 + -0.5) * v24) + v24
    v59 = 1.5707963267948966 - v7
    v60 = v59 * v59
    v70 = ((3.351225419331419e-07 * v60 + -9.141581197542956e-06) * v60 + 0.00018491338192303807) * v60 + -0.0027121913216134426
    v85 = v60 * v60 * (((v70 * v60 + 0.027132936506283845) * v60 + -0.16944444444442117) * v60 + 0.5833333333333343)
    v95 = 0.5 * v7 + -0.11873149673078154 + (v59 * (v59 * -1.0 + 0.5) + (v85 + (v59 * -1.2246467991473532e-16 + -7.401486830834378e-17)))
    v114 = ((-9.183689863795546e-29 * v24 + 6.446950284384474e-26) * v24 + -3.868170170630684e-23) * v24 + 1.9572941063391263e-20
    v123 = ((v114 * v24 + -8.22063524662433e-18) * v24 + 2.8114572543455206e-15) * v24 + -7.647163731819816e-13
    v132 = ((v123 * v24 + 1.6059043836821613e-10) * v24 + -2.505210838544172e-08) * v24 + 2.7557319223985893e-06
    v141 = ((v132 * v24 + -0.0001984126984126984) * v24 + 0.008333333333333333) * v24 + -0.16666666666666666
    v144 = v141 * v24 + 1.0
    v151 = np.where(v7 < 1.14, v55 / 1.5 * v7, v95) + 2.0 * np.cos(v7) * (v144 * v144) * v7 * v7 * (0.5 * (theta_2 - (v9 - v10) + (v8 - v10)))
    v153 = -((np.cos(v16) - np.sin(v16) * (0.5 * (theta_1 - (v17 - v18) + (theta_2 - v18)))) * v151)
    return v153


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
    Source: eq. (3.13) of the paper. Operations: 51 mul, 41 add, 11 sub, 1 div, 2 neg, 1 min, 1 less, 1 select,
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
    v27 = ((8.342554711571668e-13 * v17 + -5.099731404727816e-11) * v17 + 2.388370515571034e-09) * v17 + -9.076778552804277e-08
    v36 = ((v27 * v17 + 2.7432103345270403e-06) * v17 + -6.400813688327872e-05) * v17 + 0.0011094576719492572
    v48 = 1.5707963267948966 - v7
    v49 = v48 * v48
    v59 = ((3.3027683347881747e-07 * v49 + -9.137450665661518e-06) * v49 + 0.00018491195613480358) * v49 + -0.0027121910690977792
    v74 = v49 * v49 * (((v59 * v49 + 0.027132936482417516) * v49 + -0.16944444444330195) * v49 + 0.5833333333333145)
    v84 = 0.5 * v7 + -0.11873149673078154 + (v48 * (v48 * -1.0 + 0.5) + (v74 + (v48 * -1.2246467991473532e-16 + -7.401486830834378e-17)))
    v86 = v7 < 1.03
    v87 = np.where(v86, 1.0 + (((v36 * v17 + -0.013558201058200155) * v17 + 0.1083333333333333) * v17 + -0.5) * v17, v84)
    v97 = ((-2.139209998434664e-09 * v17 + 1.3382982815931337e-08) * v17 + -4.2892782058850495e-08) * v17 + 8.103151569271108e-08
    v106 = ((v97 * v17 + -1.1324533913384523e-07) * v17 + 8.999334096323842e-08) * v17 + -1.1326873008824011e-07
    v115 = ((v106 * v17 + -1.00342932351716e-07) * v17 + -4.733246249348672e-07) * v17 + -1.5931139807176382e-06
    v124 = ((v115 * v17 + -5.751963333931437e-06) * v17 + -2.358934911464318e-05) * v17 + -2.931097582881904e-05
    v134 = (((v124 * v17 + -0.002050264549786367) * v17 + 0.027380952380939495) * v17 + -0.2999999999999999) * v17
    v145 = ((1.1438171613493169e-05 * v49 + -0.0003320128199016475) * v49 + 0.006850740800236919) * v49 + -0.08591864000408327
    v161 = ((-4.9168401285595965e-06 * v49 + 0.0001406780287090666) * v49 + -0.0031746522241927555) * v49 + 0.04444444366472531
    v173 = ((v161 * v49 + -0.333333333323824) * v49 + 1.0000000000000464) * np.log(np.maximum(2.0 * v48, 8.673617379884035e-19))
    v180 = v48 * (v48 * -1.875 + 1.0) + v49 * (v173 + ((v145 * v49 + 0.5870981203831558) * v49 + -0.011294361119764083))
    v186 = np.cos(v8)
    v187 = np.sin(v8)
    v193 = (v186 - v187 * v15) / (v186 * v15 + v187) * (v87 / np.where(v86, 1.0 + v134, v7 + -0.5707963267948966 + v180))
    return v193


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
    Source: eq. (3.21) of the paper. Operations: 61 mul, 57 add, 7 sub, 2 div, 1 min, 1 max, 1 less, 2 select, 1
    cos, 1 log, 1 sin.
    """
    return evaluate(_limit_friction, lambda eps, theta_1, theta_2: (theta_2 >= theta_1) & (0.5 * theta_2 - 0.5 * theta_1 <= 1.5707963267948966 * (1.0 + 4.0 * eps)) & np.isfinite(theta_1), (4.0, 5.0), (theta_1, theta_2), out, where)
