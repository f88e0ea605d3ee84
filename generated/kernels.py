# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: 8c65e6164009a4b4a223bef2a334585c9accf1eaf2d9c333875a9fa641ab282f
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
    v11 = ((5.168625993130202e-10 * v1 + -1.6576286070544384e-09) * v1 + 4.229027862047401e-09) * v1 + -2.294785799497861e-09
    v22 = (((v11 * v1 + 1.105655322025256e-08) * v1 + 2.735267439239966e-08) * v1 + 6.229864974936299e-08) * v1
    v31 = (((v22 + 1.8822972508971063e-06) * v1 + -3.157332872662651e-05) * v1 + 0.0005900272525386768) * v1
    v42 = (((v31 + -0.007054673721059087) * v1 + 0.057142857142847545) * v1 + -0.26666666666666655) * v1 + 0.16666666666666666
    v48 = 1.5707963267948966 - alpha
    v49 = v48 * v48
    v59 = ((-2.5902481829787356e-05 * v49 + 0.000366809753599211) * v49 + -0.0045198575980835536) * v49 + 0.03611109475585648
    v78 = ((3.304584814267213e-05 * v49 + -0.0004988439913579735) * v49 + 0.005209840469412508) * v49 + -0.03306606290744626
    v85 = ((v59 * v49 + -0.16666666675971478) * v49 + 0.33333333333338067) * xp.log(xp.maximum(v48, 8.673617379884035e-19))
    v92 = v48 * v49 * (v85 + ((v78 * v49 + 0.09885786312498492) * v49 + -0.008826837964346697)) + 5.360408832255455e-17
    v96 = xp.where(alpha < 0.95, (v1 * v42 + v1 * 0.5) * alpha, alpha + -0.5235987755982989 + v92)
    return v96


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
    Accuracy: at most 16 ulp (sampled only: no certificate).
    Source: eq. (2.17) of the paper. Operations: 31 mul, 28 add, 1 sub, 1 max, 1 less, 1 select, 1 log.
    """
    return _call_polar_moment(alpha, out, where, accuracy)


def _moment_of_inertia(alpha: Array, xp: Any = np) -> Array:
    v1 = alpha * alpha
    v11 = ((-2.855680067158568e-12 * v1 + 1.136422044139104e-10) * v1 + -3.5882486043151087e-09) * v1 + 9.415628707786396e-08
    v20 = ((v11 * v1 + -2.012583430963377e-06) * v1 + 3.4217009244075565e-05) * v1 + -0.00044926267202941695
    v31 = (((v20 * v1 + 0.00438672438684678) * v1 + -0.03033509700177941) * v1 + 0.13968253968254069) * v1
    v42 = 1.5707963267948966 - alpha
    v43 = v42 * v42
    v53 = ((-1.1937049677530915e-07 * v43 + 2.05744095772437e-06) * v43 + -3.423984087167627e-05) * v43 + 0.0004488358070079107
    v62 = ((v53 * v43 + -0.0043696247326275185) * v43 + 0.029864785768700504) * v43 + -0.13121693124481915
    v73 = v42 * (((v62 * v43 + 0.31111111111234796) * v43 + -0.22222222222224858) * v43 + -0.16666666666666646)
    v81 = xp.where(alpha < 1.0, (v1 * ((v31 + -0.4) * v1 + 0.16666666666666666) + v1 * 0.5) * alpha, 0.5 * alpha + -0.1171875 + (v73 + 0.11718749999999999))
    return v81


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
    Accuracy: at most 16 ulp (sampled only: no certificate).
    Source: eq. (3.12) of the paper. Operations: 27 mul, 24 add, 1 sub, 1 less, 1 select.
    """
    return _call_moment_of_inertia(alpha, out, where, accuracy)


def _radial_weight_amplitude(alpha: Array, xp: Any = np) -> Array:
    v1 = alpha * alpha
    v11 = ((-1.4221669551817225e-09 * v1 + 8.886939911289569e-09) * v1 + -2.8454575100932283e-08) * v1 + 5.3681538685951145e-08
    v20 = ((v11 * v1 + -7.494696739063352e-08) * v1 + 5.9364558201916204e-08) * v1 + -7.498484365937765e-08
    v29 = ((v20 * v1 + -6.722111408844424e-08) * v1 + -3.154008251985666e-07) * v1 + -1.0621260068948484e-06
    v38 = ((v29 * v1 + -3.834630088040768e-06) * v1 + -1.572623480726951e-05) * v1 + -1.9540650317766474e-05
    v48 = (((v38 * v1 + -0.0013668430332074324) * v1 + 0.01825396825396029) * v1 + -0.19999999999999993) * v1
    v58 = 1.5707963267948966 - alpha
    v59 = v58 * v58
    v69 = ((-4.9168401285595965e-06 * v59 + 0.0001406780287090666) * v59 + -0.0031746522241927555) * v59 + 0.04444444366472531
    v90 = ((1.1438171613493169e-05 * v59 + -0.0003320128199016475) * v59 + 0.006850740800236919) * v59 + -0.08591864000408327
    v97 = ((v69 * v59 + -0.333333333323824) * v59 + 1.0000000000000464) * xp.log(xp.maximum(2.0 * v58, 8.673617379884035e-19))
    v105 = v58 * (v58 * -1.875 + 1.0) + v59 * (v97 + ((v90 * v59 + 0.5870981203831558) * v59 + -0.011294361119764083))
    v109 = xp.where(alpha < 1.03, (v1 * (v48 + 0.16666666666666666) + v1 * 0.5) * alpha, 1.0 - v58 + v105)
    return v109


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
    Accuracy: at most 16 ulp (sampled only: no certificate).
    Source: eq. (2.23) of the paper. Operations: 36 mul, 31 add, 2 sub, 1 max, 1 less, 1 select, 1 log.
    """
    return _call_radial_weight_amplitude(alpha, out, where, accuracy)


def _weight_moment_amplitude(alpha: Array, xp: Any = np) -> Array:
    v1 = alpha * alpha
    v3 = v1 - 1.5
    v13 = ((-7.48664059255431e-15 * v3 + 4.729537997954169e-13) * v3 + -2.6062983535142563e-11) * v3 + 1.1884194487023759e-09
    v22 = ((v13 * v3 + -4.3935663408279237e-08) * v3 + 1.284693982418436e-06) * v3 + -2.879170456961079e-05
    v33 = (((v22 * v3 + 0.00047470508443483625) * v3 + -0.00544772383773238) * v3 + 0.04022226784472187) * v3
    v39 = v1 * ((v33 + -0.168694879540106) * v3 + 0.30210092961985757) * alpha
    return v39


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
    Accuracy: at most 16 ulp (sampled only: no certificate).
    Source: eq. (3.13) of the paper. Operations: 14 mul, 11 add, 1 sub.
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
    Accuracy: at most 16 ulp (sampled only: no certificate).
    Source: eq. (3.14) of the paper. Operations: 11 mul, 8 add.
    """
    return _call_resistance_factor(alpha, out, where, accuracy)


def _dynamic_coefficient(alpha: Array, xp: Any = np) -> Array:
    v1 = alpha * alpha
    v11 = ((5.168625993130202e-10 * v1 + -1.6576286070544384e-09) * v1 + 4.229027862047401e-09) * v1 + -2.294785799497861e-09
    v22 = (((v11 * v1 + 1.105655322025256e-08) * v1 + 2.735267439239966e-08) * v1 + 6.229864974936299e-08) * v1
    v31 = (((v22 + 1.8822972508971063e-06) * v1 + -3.157332872662651e-05) * v1 + 0.0005900272525386768) * v1
    v42 = (((v31 + -0.007054673721059087) * v1 + 0.057142857142847545) * v1 + -0.26666666666666655) * v1 + 0.16666666666666666
    v45 = 1.5707963267948966 - alpha
    v46 = v45 * v45
    v56 = ((-2.5902481829787356e-05 * v46 + 0.000366809753599211) * v46 + -0.0045198575980835536) * v46 + 0.03611109475585648
    v75 = ((3.304584814267213e-05 * v46 + -0.0004988439913579735) * v46 + 0.005209840469412508) * v46 + -0.03306606290744626
    v82 = ((v56 * v46 + -0.16666666675971478) * v46 + 0.33333333333338067) * xp.log(xp.maximum(v45, 8.673617379884035e-19))
    v89 = v45 * v46 * (v82 + ((v75 * v46 + 0.09885786312498492) * v46 + -0.008826837964346697)) + 5.360408832255455e-17
    v92 = alpha < 0.95
    v103 = ((3.0090535662212205e-16 * v1 + -9.552400725452637e-14) * v1 + 2.2941293244035988e-11) * v1 + -4.175351054736609e-09
    v114 = (((v103 * v1 + 5.511463841362367e-07) * v1 + -4.960317460298492e-05) * v1 + 0.002777777777777727) * v1
    v116 = (v114 + -0.08333333333333333) * v1
    v123 = xp.where(v92, v42 + 0.5, alpha + -0.5235987755982989 + v89) / xp.where(v92, v116 + 1.0, (v1 * v116 + v1) * alpha)
    return v123


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
    Accuracy: at most 16 ulp (sampled only: no certificate).
    Source: eq. (2.24) of the paper. Operations: 38 mul, 37 add, 1 sub, 1 div, 1 max, 1 less, 2 select, 1 log.
    """
    return _call_dynamic_coefficient(alpha, out, where, accuracy)


def _weight_moment_per_inertia(alpha: Array, xp: Any = np) -> Array:
    v1 = alpha * alpha
    v11 = ((5.001505994449722e-13 * v1 + -3.371593788571054e-11) * v1 + 1.5916423603850018e-09) * v1 + -6.051113992001625e-08
    v20 = ((v11 * v1 + 1.8288063759966314e-06) * v1 + -4.2672091028127684e-05) * v1 + 0.0007396384479051326
    v33 = (((v20 * v1 + -0.00903880070545745) * v1 + 0.0722222222222215) * v1 + -0.3333333333333333) * v1 + 0.16666666666666666
    v36 = 1.5707963267948966 - alpha
    v37 = v36 * v36
    v48 = ((3.288361855471376e-07 * v37 + -9.135845964510098e-06) * v37 + 0.00018491124374270671) * v37 + -0.0027121909092596313
    v62 = v37 * v37 * (((v48 * v37 + 0.027132936463543637) * v37 + -0.16944444444220988) * v37 + 0.583333333333291)
    v67 = 0.5 * alpha
    v70 = v67 + -0.11873149673078165 + (v36 * (0.5 - v36) + (v62 + (v36 * -1.2246467991473532e-16 + 3.700743415417188e-17)))
    v72 = alpha < 1.0
    v83 = ((-2.855680067158568e-12 * v1 + 1.136422044139104e-10) * v1 + -3.5882486043151087e-09) * v1 + 9.415628707786396e-08
    v92 = ((v83 * v1 + -2.012583430963377e-06) * v1 + 3.4217009244075565e-05) * v1 + -0.00044926267202941695
    v103 = (((v92 * v1 + 0.00438672438684678) * v1 + -0.03033509700177941) * v1 + 0.13968253968254069) * v1
    v117 = ((-1.1937049677530915e-07 * v37 + 2.05744095772437e-06) * v37 + -3.423984087167627e-05) * v37 + 0.0004488358070079107
    v126 = ((v117 * v37 + -0.0043696247326275185) * v37 + 0.029864785768700504) * v37 + -0.13121693124481915
    v137 = v36 * (((v126 * v37 + 0.31111111111234796) * v37 + -0.22222222222224858) * v37 + -0.16666666666666646)
    v142 = xp.where(v72, (v103 + -0.4) * v1 + 0.16666666666666666 + 0.5, v67 + -0.1171875 + (v137 + 0.11718749999999999))
    v143 = xp.where(v72, v33 + 0.5, v70) / v142
    return v143


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
    Accuracy: at most 16 ulp (sampled only: no certificate).
    Source: eq. (3.17) of the paper. Operations: 44 mul, 46 add, 2 sub, 1 div, 1 less, 2 select.
    """
    return _call_weight_moment_per_inertia(alpha, out, where, accuracy)


def _radial_weight_per_inertia(alpha: Array, xp: Any = np) -> Array:
    v1 = alpha * alpha
    v11 = ((-1.4221669551817225e-09 * v1 + 8.886939911289569e-09) * v1 + -2.8454575100932283e-08) * v1 + 5.3681538685951145e-08
    v20 = ((v11 * v1 + -7.494696739063352e-08) * v1 + 5.9364558201916204e-08) * v1 + -7.498484365937765e-08
    v29 = ((v20 * v1 + -6.722111408844424e-08) * v1 + -3.154008251985666e-07) * v1 + -1.0621260068948484e-06
    v38 = ((v29 * v1 + -3.834630088040768e-06) * v1 + -1.572623480726951e-05) * v1 + -1.9540650317766474e-05
    v48 = (((v38 * v1 + -0.0013668430332074324) * v1 + 0.01825396825396029) * v1 + -0.19999999999999993) * v1
    v55 = 1.5707963267948966 - alpha
    v56 = v55 * v55
    v66 = ((-4.9168401285595965e-06 * v56 + 0.0001406780287090666) * v56 + -0.0031746522241927555) * v56 + 0.04444444366472531
    v87 = ((1.1438171613493169e-05 * v56 + -0.0003320128199016475) * v56 + 0.006850740800236919) * v56 + -0.08591864000408327
    v94 = ((v66 * v56 + -0.333333333323824) * v56 + 1.0000000000000464) * xp.log(xp.maximum(2.0 * v55, 8.673617379884035e-19))
    v102 = v55 * (v55 * -1.875 + 1.0) + v56 * (v94 + ((v87 * v56 + 0.5870981203831558) * v56 + -0.011294361119764083))
    v105 = alpha < 1.03
    v116 = ((4.57753278921582e-13 * v1 + -5.548620913076601e-12) * v1 + 1.2052958467791444e-10) * v1 + -3.5982823958341344e-09
    v125 = ((v116 * v1 + 9.416545026318226e-08) * v1 + -2.0125888686507808e-06) * v1 + 3.421701134578372e-05
    v136 = (((v125 * v1 + -0.00044926267254467134) * v1 + 0.004386724386922003) * v1 + -0.03033509700178515) * v1
    v152 = ((-1.7039030552510834e-07 * v56 + 2.1246918811419113e-06) * v56 + -3.4276716122893775e-05) * v56
    v161 = (((v152 + 0.00044884668554678663) * v56 + -0.0043696265965371605) * v56 + 0.029864785955206526) * v56
    v171 = (((v161 + -0.1312169312551838) * v56 + 0.31111111111262857) * v56 + -0.22222222222225121) * v56 + -0.16666666666666646
    v179 = xp.where(v105, ((v136 + 0.13968253968254085) * v1 + -0.4) * v1 + 0.16666666666666666 + 0.5, 0.5 * alpha + -0.1171875 + (v55 * v171 + 0.11718749999999999))
    v180 = xp.where(v105, v48 + 0.16666666666666666 + 0.5, 1.0 - v55 + v102) / v179
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
    Accuracy: at most 16 ulp (sampled only: no certificate).
    Source: eq. (3.17) of the paper. Operations: 56 mul, 56 add, 2 sub, 1 div, 1 max, 1 less, 2 select, 1 log.
    """
    return _call_radial_weight_per_inertia(alpha, out, where, accuracy)


def _polar_moment_per_inertia(alpha: Array, xp: Any = np) -> Array:
    v1 = alpha * alpha
    v11 = ((2.678785639883319e-10 * v1 + -1.1948752164090461e-09) * v1 + 3.2255206167281327e-09) * v1 + -3.972432721750019e-09
    v20 = ((v11 * v1 + 6.7097461068657905e-09) * v1 + 4.2720306610181334e-09) * v1 + 3.0935602383989865e-08
    v29 = ((v20 * v1 + 6.096812694588104e-08) * v1 + 1.8826405809840912e-06) * v1 + -3.157338857200392e-05
    v40 = (((v29 * v1 + 0.0005900272592389474) * v1 + -0.007054673721500878) * v1 + 0.05714285714286215) * v1
    v48 = 1.5707963267948966 - alpha
    v49 = v48 * v48
    v59 = ((-2.5945329335152922e-05 * v49 + 0.00036666972541074983) * v49 + -0.004519922077362515) * v49 + 0.036111088421710145
    v78 = ((3.310128751531202e-05 * v49 + -0.0004988389017989785) * v49 + 0.0052097899146714855) * v49 + -0.033066072663597075
    v85 = ((v59 * v49 + -0.1666666668862208) * v49 + 0.33333333333307696) * xp.log(xp.maximum(v48, 8.673617379884035e-19))
    v92 = v48 * v49 * (v85 + ((v78 * v49 + 0.09885786282011913) * v49 + -0.008826837965495118)) + 5.360408832255455e-17
    v95 = alpha < 1.0
    v96 = xp.where(v95, (v40 + -0.2666666666666667) * v1 + 0.16666666666666666 + 0.5, alpha + -0.5235987755982989 + v92)
    v106 = ((-2.855680067158568e-12 * v1 + 1.136422044139104e-10) * v1 + -3.5882486043151087e-09) * v1 + 9.415628707786396e-08
    v115 = ((v106 * v1 + -2.012583430963377e-06) * v1 + 3.4217009244075565e-05) * v1 + -0.00044926267202941695
    v126 = (((v115 * v1 + 0.00438672438684678) * v1 + -0.03033509700177941) * v1 + 0.13968253968254069) * v1
    v140 = ((-1.1937049677530915e-07 * v49 + 2.05744095772437e-06) * v49 + -3.423984087167627e-05) * v49 + 0.0004488358070079107
    v149 = ((v140 * v49 + -0.0043696247326275185) * v49 + 0.029864785768700504) * v49 + -0.13121693124481915
    v160 = v48 * (((v149 * v49 + 0.31111111111234796) * v49 + -0.22222222222224858) * v49 + -0.16666666666666646)
    v166 = xp.where(v95, (v126 + -0.4) * v1 + 0.16666666666666666 + 0.5, 0.5 * alpha + -0.1171875 + (v160 + 0.11718749999999999))
    v167 = v96 / v166
    return v167


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
    Accuracy: at most 16 ulp (sampled only: no certificate).
    Source: eq. (3.18) of the paper. Operations: 51 mul, 53 add, 1 sub, 1 div, 1 max, 1 less, 2 select, 1 log.
    """
    return _call_polar_moment_per_inertia(alpha, out, where, accuracy)


def _weight_moment_per_radial_weight(alpha: Array, xp: Any = np) -> Array:
    v1 = alpha * alpha
    v11 = ((5.232553437961233e-13 * v1 + -3.382232778917949e-11) * v1 + 1.5918475098118753e-09) * v1 + -6.051135465240077e-08
    v20 = ((v11 * v1 + 1.8288065081316203e-06) * v1 + -4.267209107643332e-05) * v1 + 0.0007396384479151915
    v30 = (((v20 * v1 + -0.009038800705458512) * v1 + 0.07222222222222154) * v1 + -0.3333333333333333) * v1
    v36 = 1.5707963267948966 - alpha
    v37 = v36 * v36
    v48 = ((3.302768333827866e-07 * v37 + -9.137450665577807e-06) * v37 + 0.00018491195613477677) * v37 + -0.0027121910690977753
    v62 = v37 * v37 * (((v48 * v37 + 0.027132936482417516) * v37 + -0.16944444444330195) * v37 + 0.5833333333333145)
    v70 = 0.5 * alpha + -0.11873149673078165 + (v36 * (0.5 - v36) + (v62 + (v36 * -1.2246467991473532e-16 + 3.700743415417188e-17)))
    v72 = alpha < 1.03
    v83 = ((-1.4221669551817225e-09 * v1 + 8.886939911289569e-09) * v1 + -2.8454575100932283e-08) * v1 + 5.3681538685951145e-08
    v92 = ((v83 * v1 + -7.494696739063352e-08) * v1 + 5.9364558201916204e-08) * v1 + -7.498484365937765e-08
    v101 = ((v92 * v1 + -6.722111408844424e-08) * v1 + -3.154008251985666e-07) * v1 + -1.0621260068948484e-06
    v110 = ((v101 * v1 + -3.834630088040768e-06) * v1 + -1.572623480726951e-05) * v1 + -1.9540650317766474e-05
    v120 = (((v110 * v1 + -0.0013668430332074324) * v1 + 0.01825396825396029) * v1 + -0.19999999999999993) * v1
    v133 = ((-4.9168401285595965e-06 * v37 + 0.0001406780287090666) * v37 + -0.0031746522241927555) * v37 + 0.04444444366472531
    v154 = ((1.1438171613493169e-05 * v37 + -0.0003320128199016475) * v37 + 0.006850740800236919) * v37 + -0.08591864000408327
    v161 = ((v133 * v37 + -0.333333333323824) * v37 + 1.0000000000000464) * xp.log(xp.maximum(2.0 * v36, 8.673617379884035e-19))
    v169 = v36 * (v36 * -1.875 + 1.0) + v37 * (v161 + ((v154 * v37 + 0.5870981203831558) * v37 + -0.011294361119764083))
    v172 = xp.where(v72, v30 + 0.16666666666666666 + 0.5, v70) / xp.where(v72, v120 + 0.16666666666666666 + 0.5, 1.0 - v36 + v169)
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
    Accuracy: at most 16 ulp (sampled only: no certificate).
    Source: eq. (3.21) of the paper. Operations: 54 mul, 53 add, 3 sub, 1 div, 1 max, 1 less, 2 select, 1 log.
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
    v34 = ((-1.4221669551817225e-09 * v24 + 8.886939911289569e-09) * v24 + -2.8454575100932283e-08) * v24 + 5.3681538685951145e-08
    v43 = ((v34 * v24 + -7.494696739063352e-08) * v24 + 5.9364558201916204e-08) * v24 + -7.498484365937765e-08
    v52 = ((v43 * v24 + -6.722111408844424e-08) * v24 + -3.154008251985666e-07) * v24 + -1.0621260068948484e-06
    v61 = ((v52 * v24 + -3.834630088040768e-06) * v24 + -1.572623480726951e-05) * v24 + -1.9540650317766474e-05
    v71 = (((v61 * v24 + -0.0013668430332074324) * v24 + 0.01825396825396029) * v24 + -0.19999999999999993) * v24
    v79 = 1.5707963267948966 - v7
    v80 = v79 * v79
    v90 = ((-4.9168401285595965e-06 * v80 + 0.0001406780287090666) * v80 + -0.0031746522241927555) * v80 + 0.04444444366472531
    v111 = ((1.1438171613493169e-05 * v80 + -0.0003320128199016475) * v80 + 0.006850740800236919) * v80 + -0.08591864000408327
    v118 = ((v90 * v80 + -0.333333333323824) * v80 + 1.0000000000000464) * np.log(np.maximum(2.0 * v79, 8.673617379884035e-19))
    v126 = v79 * (v79 * -1.875 + 1.0) + v80 * (v118 + ((v111 * v80 + 0.5870981203831558) * v80 + -0.011294361119764083))
    v146 = ((1.9572941063391263e-20 * v24 + -8.22063524662433e-18) * v24 + 2.8114572543455206e-15) * v24 + -7.647163731819816e-13
    v155 = ((v146 * v24 + 1.6059043836821613e-10) * v24 + -2.505210838544172e-08) * v24 + 2.7557319223985893e-06
    v164 = ((v155 * v24 + -0.0001984126984126984) * v24 + 0.008333333333333333) * v24 + -0.16666666666666666
    v166 = v164 * v24 + 1.0
    v167 = np.cos(v7)
    v170 = v166 / (1.0 + v167) * v7
    v172 = np.minimum(0.4, v170)
    v173 = v172 * v172
    v183 = ((0.024390243902439025 * v173 + 0.02564102564102564) * v173 + 0.02702702702702703) * v173 + 0.02857142857142857
    v192 = ((v183 * v173 + 0.030303030303030304) * v173 + 0.03225806451612903) * v173 + 0.034482758620689655
    v204 = (((v192 * v173 + 0.037037037037037035) * v173 + 0.04) * v173 + 0.043478260869565216) * v173 + 0.047619047619047616
    v213 = ((v204 * v173 + 0.05263157894736842) * v173 + 0.058823529411764705) * v173 + 0.06666666666666667
    v223 = (((v213 * v173 + 0.07692307692307693) * v173 + 0.09090909090909091) * v173 + 0.1111111111111111) * v173
    v234 = np.minimum(0.9999999999999999, np.maximum(0.4, v170))
    v245 = np.where(v170 < 0.4, ((v223 + 0.14285714285714285) * v173 + 0.2) * v173 + 0.3333333333333333, (0.5 * np.log1p(2.0 * v234 / (1.0 - v234)) - v234) / (v234 * (v234 * v234)))
    v254 = 4.0 * (1.0 + v245 * (v170 * v170)) * v167 * v170 * v166 * v7 * (0.5 * (theta_2 - (v9 - v10) + (v8 - v10)))
    v255 = -np.where(v7 < 1.03, (v24 * (v71 + 0.16666666666666666) + v24 * 0.5) * v7, 1.0 - v79 + v126) - v254
    v256 = (np.cos(v16) * (0.5 * (theta_1 - (v17 - v18) + (theta_2 - v18))) + np.sin(v16)) * v255
    return v256


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
    Source: eq. (2.23) of the paper. Operations: 85 mul, 68 add, 14 sub, 3 div, 2 neg, 3 min, 2 max, 2 less, 2
    select, 2 cos, 1 log, 1 log1p, 1 sin.
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
    v26 = v24 - 1.5
    v36 = ((-7.48664059255431e-15 * v26 + 4.729537997954169e-13) * v26 + -2.6062983535142563e-11) * v26 + 1.1884194487023759e-09
    v45 = ((v36 * v26 + -4.3935663408279237e-08) * v26 + 1.284693982418436e-06) * v26 + -2.879170456961079e-05
    v56 = (((v45 * v26 + 0.00047470508443483625) * v26 + -0.00544772383773238) * v26 + 0.04022226784472187) * v26
    v79 = ((1.9572941063391263e-20 * v24 + -8.22063524662433e-18) * v24 + 2.8114572543455206e-15) * v24 + -7.647163731819816e-13
    v88 = ((v79 * v24 + 1.6059043836821613e-10) * v24 + -2.505210838544172e-08) * v24 + 2.7557319223985893e-06
    v97 = ((v88 * v24 + -0.0001984126984126984) * v24 + 0.008333333333333333) * v24 + -0.16666666666666666
    v100 = v97 * v24 + 1.0
    v107 = -(v24 * ((v56 + -0.168694879540106) * v26 + 0.30210092961985757) * v7) - 2.0 * np.cos(v7) * (v100 * v100) * v7 * v7 * (0.5 * (theta_2 - (v9 - v10) + (v8 - v10)))
    v108 = (np.cos(v16) - np.sin(v16) * (0.5 * (theta_1 - (v17 - v18) + (theta_2 - v18)))) * v107
    return v108


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
    Source: eq. (3.13) of the paper. Operations: 36 mul, 26 add, 12 sub, 2 neg, 1 min, 2 cos, 1 sin.
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
    v16 = v7 * v7
    v26 = ((5.232553437961233e-13 * v16 + -3.382232778917949e-11) * v16 + 1.5918475098118753e-09) * v16 + -6.051135465240077e-08
    v35 = ((v26 * v16 + 1.8288065081316203e-06) * v16 + -4.267209107643332e-05) * v16 + 0.0007396384479151915
    v45 = (((v35 * v16 + -0.009038800705458512) * v16 + 0.07222222222222154) * v16 + -0.3333333333333333) * v16
    v49 = 1.5707963267948966 - v7
    v50 = v49 * v49
    v61 = ((3.302768333827866e-07 * v50 + -9.137450665577807e-06) * v50 + 0.00018491195613477677) * v50 + -0.0027121910690977753
    v75 = v50 * v50 * (((v61 * v50 + 0.027132936482417516) * v50 + -0.16944444444330195) * v50 + 0.5833333333333145)
    v83 = 0.5 * v7 + -0.11873149673078165 + (v49 * (0.5 - v49) + (v75 + (v49 * -1.2246467991473532e-16 + 3.700743415417188e-17)))
    v85 = v7 < 1.03
    v96 = ((-1.4221669551817225e-09 * v16 + 8.886939911289569e-09) * v16 + -2.8454575100932283e-08) * v16 + 5.3681538685951145e-08
    v105 = ((v96 * v16 + -7.494696739063352e-08) * v16 + 5.9364558201916204e-08) * v16 + -7.498484365937765e-08
    v114 = ((v105 * v16 + -6.722111408844424e-08) * v16 + -3.154008251985666e-07) * v16 + -1.0621260068948484e-06
    v123 = ((v114 * v16 + -3.834630088040768e-06) * v16 + -1.572623480726951e-05) * v16 + -1.9540650317766474e-05
    v132 = ((v123 * v16 + -0.0013668430332074324) * v16 + 0.01825396825396029) * v16 + -0.19999999999999993
    v146 = ((-4.9168401285595965e-06 * v50 + 0.0001406780287090666) * v50 + -0.0031746522241927555) * v50 + 0.04444444366472531
    v167 = ((1.1438171613493169e-05 * v50 + -0.0003320128199016475) * v50 + 0.006850740800236919) * v50 + -0.08591864000408327
    v174 = ((v146 * v50 + -0.333333333323824) * v50 + 1.0000000000000464) * np.log(np.maximum(2.0 * v49, 8.673617379884035e-19))
    v182 = v49 * (v49 * -1.875 + 1.0) + v50 * (v174 + ((v167 * v50 + 0.5870981203831558) * v50 + -0.011294361119764083))
    v185 = np.where(v85, v45 + 0.16666666666666666 + 0.5, v83) / np.where(v85, v132 * v16 + 0.16666666666666666 + 0.5, 1.0 - v49 + v182)
    v186 = np.cos(v8)
    v187 = np.sin(v8)
    v193 = (v186 - v187 * v15) / (v186 * v15 + v187) * v185
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
    Source: eq. (3.21) of the paper. Operations: 60 mul, 57 add, 9 sub, 2 div, 1 min, 1 max, 1 less, 2 select, 1
    cos, 1 log, 1 sin.
    """
    return evaluate(_limit_friction, lambda eps, theta_1, theta_2: (theta_2 >= theta_1) & (0.5 * theta_2 - 0.5 * theta_1 <= 1.5707963267948966 * (1.0 + 4.0 * eps)) & np.isfinite(theta_1), (4.0, 5.0), (theta_1, theta_2), out, where)
