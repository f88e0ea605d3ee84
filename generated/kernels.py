# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: b3fc34cdb3118b34e581c4b14e9e542a3ae3ea025114d788be81852acbe724d0
"""Moments, weights and quotients of the arc, from their definitions."""

from __future__ import annotations

from typing import Any

import numpy as np

from generated._compiled import Text, direct, kernel
from generated._evaluate import Array, horner, lost

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

SERIES_1 = (-0.49999999999999956, 0.10833333333331703, -0.01355820105799458,
        0.0011094576706712346, -6.400813237492561e-05, 2.7432007040306065e-06, -9.07550841596515e-08,
        2.378258460272636e-09, -4.654196085916315e-11)
SERIES_2 = (-0.08333333333333333, 0.002777777777777727, -4.960317460298492e-05,
        5.511463841362367e-07, -4.175351054736609e-09, 2.2941293244035988e-11, -9.552400725452637e-14,
        3.0090535662212205e-16)

# What NumPy runs, by kernel and tier.
TEXTS: dict[str, dict[str, Text]] = {}


def _cos_psi(theta_1: Array, theta_2: Array, xp: Any = np) -> tuple[Array, Array, Array]:
    t1 = theta_1 + theta_2
    t2 = xp.rint(t1 * 0.15915494309189535)
    t3 = t2 * 2.0
    t4 = t3 * -3.1415926535846666
    t5 = t3 * -5.1266883031679116e-12
    t6 = t3 * -2.1125998133888136e-23
    t7 = t3 * -8.671810130123781e-35
    t8 = lost(theta_1, theta_2)
    t9 = t1 + t4
    t10 = lost(t1, t4)
    t11 = t9 + t5
    t12 = lost(t9, t5)
    t13 = t11 + t6
    t14 = lost(t11, t6)
    t15 = t13 + t7
    t16 = lost(t13, t7)
    t17 = t8 + t10
    t18 = lost(t8, t10)
    t19 = t17 + t12
    t20 = lost(t17, t12)
    t21 = t19 + t14
    t22 = lost(t19, t14)
    t23 = t21 + t16
    t24 = lost(t21, t16)
    t25 = t23 + t15
    t26 = lost(t23, t15)
    t27 = t18 + t20
    t28 = t27 + t22
    t29 = t28 + t24
    t30 = t29 + t26
    t31 = t30 + t25
    t32 = lost(t18, t20) + lost(t27, t22) + lost(t28, t24) + lost(t29, t26) + lost(t30, t25)
    t33 = xp.maximum(xp.minimum(t31 + t32, 3.141592653589793), -3.141592653589793)
    t34 = t2 * 0.5
    t35 = t34 - xp.rint(t34)
    t36 = t33 * 0.5
    t37 = t36 * t36
    t38 = (t37 * -0.00021164021164021165 + -0.0021164021164021165) * t37 + -0.022222222222222223
    return t33, ((t38 * t37 + -0.3333333333333333) * t37 + 1.0) * lost(t31, t32), t35 * t35 * 4.0 - 0.5


def _sin_psi(theta_1: Array, theta_2: Array, xp: Any = np) -> tuple[Array, Array, Array]:
    t1 = theta_1 + theta_2
    t2 = xp.rint(t1 * 0.15915494309189535 - 0.5)
    t3 = t2 * 2.0 + 1.0
    t4 = t3 * -3.1415926535846666
    t5 = t3 * -5.1266883031679116e-12
    t6 = t3 * -2.1125998133888136e-23
    t7 = t3 * -8.671810130123781e-35
    t8 = lost(theta_1, theta_2)
    t9 = t1 + t4
    t10 = lost(t1, t4)
    t11 = t9 + t5
    t12 = lost(t9, t5)
    t13 = t11 + t6
    t14 = lost(t11, t6)
    t15 = t13 + t7
    t16 = lost(t13, t7)
    t17 = t8 + t10
    t18 = lost(t8, t10)
    t19 = t17 + t12
    t20 = lost(t17, t12)
    t21 = t19 + t14
    t22 = lost(t19, t14)
    t23 = t21 + t16
    t24 = lost(t21, t16)
    t25 = t23 + t15
    t26 = lost(t23, t15)
    t27 = t18 + t20
    t28 = t27 + t22
    t29 = t28 + t24
    t30 = t29 + t26
    t31 = t30 + t25
    t32 = lost(t18, t20) + lost(t27, t22) + lost(t28, t24) + lost(t29, t26) + lost(t30, t25)
    t33 = xp.maximum(xp.minimum(t31 + t32, 3.141592653589793), -3.141592653589793)
    t34 = t2 * 0.5
    t35 = t34 - xp.rint(t34)
    t36 = t33 * 0.5
    t37 = t36 * t36
    t38 = (t37 * -0.00021164021164021165 + -0.0021164021164021165) * t37 + -0.022222222222222223
    return t33, ((t38 * t37 + -0.3333333333333333) * t37 + 1.0) * lost(t31, t32), t35 * t35 * -4.0 - -0.5


def _share(theta_1: Array, theta_2: Array, xp: Any = np) -> Array:
    t1 = theta_2 - theta_1
    t2 = xp.minimum(t1 * 0.5, 1.5707963267948966)
    t3 = t2 * t2
    t4 = (t3 * -0.00021164021164021165 + -0.0021164021164021165) * t3 + -0.022222222222222223
    t5 = lost(theta_2, -theta_1) / xp.maximum(t1, 9.332636185032189e-302)
    return ((t4 * t3 + -0.3333333333333333) * t3 + 1.0) * 3.0 * t5


def _polar_moment(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, (-0.39999999999999974, 0.08571428571426432, -0.010582010581380249,
        0.0008850408756454547, -4.735996404406431e-05, 2.8232683551833642e-06, 9.421135635599145e-08,
        3.8645798774633384e-08, 2.206174034731525e-08, -1.2705506890239765e-08, 1.7718598611390323e-08,
        -1.2330293856874414e-08, 6.454240125083444e-09, -1.9564161712828478e-09, 3.039515410332813e-10))
    near = (alpha_2 * (p1 * alpha_2) + alpha_2) / 1.5 * alpha
    b = 1.5707963267948966 - alpha
    b_2 = b * b
    p2 = horner(b_2, (-0.008826837964582748, 0.09885786320877188, -0.03306605252243474, 0.005209969065168702,
        -0.0004987333296356622, 3.27988474921164e-05))
    p3 = horner(b_2, (0.3333333333333052, -0.16666666673848812, 0.03611109988364303, -0.004519742585040029,
        0.00036726703982202014, -2.5665251138060843e-05))
    t1 = b * b_2 * (p3 * xp.log(xp.maximum(b, 8.673617379884035e-19)) + p2) + -0.007973775598298873
    far = alpha + -0.515625 + t1
    return xp.where(alpha < 1.08, near, far)


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
    b = 1.5707963267948966 - alpha
    t1 = b * (alpha + 1.5707963267948966)
    p1 = horner(t1, (-0.24102901849440184, -507.09573457752685, -219524.54306815894, -28874628.62946362,
        -1387995720.3906124, -27150691473.6917, -230373884494.88724, -874488161171.5526, -1481754569607.5928,
        -1070262305101.3746, -293207195370.58575, -26093454656.26703, -2007653637.0938618, -71264367.55358593))
    p2 = horner(t1, (1.0, 2103.680212921125, 910363.7125347395, 119616895.8806746, 5734908113.738208,
        111506483496.57628, 933596446502.1342, 3441104825812.091, 5447798468586.475, 3290261763937.4214,
        441942659829.33887, -65336458198.67665, 2977040481.4232764, -51790122.64786269))
    return alpha_2 * alpha * (p1 / p2 * alpha_2 + -5.662137425588298e-17 + 1.0) * 0.6666666666666666


TEXTS["polar_moment"] = {"best": _polar_moment, "1e-10": _polar_moment_1e_10, "1e-6": _polar_moment_1e_6,
    "float32": _polar_moment_float32}
_call_polar_moment = kernel("polar_moment", TEXTS["polar_moment"])


@direct
def polar_moment(alpha, out=None, *, where=True, accuracy=None):
    """Return I_p*, the polar surface moment of inertia of the moving mass, dimensionless.

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
    flag, of NaN without.
    Accuracy: proved, rounding included: 0.633 ulp compiled with FMA, 4.17 without, 4.17 in NumPy;
    accuracy=1e-10: 6.69e-11 relative; accuracy=1e-6: 6.63e-07 relative; float32: correctly rounded
    (certificates/polar_moment.json).
    Source: eq. (2.17) of the paper.
    Arrays: numbers, lists, NumPy, pint, xarray, pandas, Dask and JAX. Safe in threads. Compiled, an element of
    a large array takes about 1 ns. Unlike NumPy's ufuncs, arguments may be named and `out` is one array, not a
    tuple; dtype= and casting= are not supported.

    Examples
    --------
    >>> from generated import polar_moment
    >>> print(f"{polar_moment(0.5):.6f}")
    0.075433
    """
    return _call_polar_moment(alpha, out, where, accuracy)


def _moment_of_inertia(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, (-0.5999999999999998, 0.20952380952379734, -0.04550264550243621, 0.006580086578305242,
        -0.0006738939984995255, 5.132548512990964e-05, -3.0188197325753546e-06, 1.411658671333195e-07,
        -5.329718078413831e-09, 1.47611654619011e-10))
    near = (alpha_2 * (p1 * alpha_2) + alpha_2) / 1.5 * alpha
    b = 1.5707963267948966 - alpha
    b_2 = b * b
    p2 = horner(b_2, (-0.1666666666666665, -0.22222222222224144, 0.31111111111188117, -0.13121693123180003,
        0.02986478557904773, -0.004369623146848829, 0.0004488279185946946, -3.421678384574033e-05,
        2.0208958409177413e-06, -9.513938118878148e-08))
    far = 0.5 * alpha + -0.125 + (b * p2 + 0.12499999999999999)
    return xp.where(alpha < 0.98, near, far)


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
    p1 = horner(alpha_2, (-5.662137425588298e-17, -0.39999999999995994, 0.13968253968167607,
        -0.03033509699518903, 0.004386724361469859, -0.00044926261457960983, 3.421692646328296e-05,
        -2.0125042310053647e-06, 9.410519422271687e-08, -3.5663837649125645e-09, 1.0789769704560224e-10,
        -2.140696264180252e-12))
    return alpha_2 * alpha * (p1 + 0.6666666666666666)


TEXTS["moment_of_inertia"] = {"best": _moment_of_inertia, "1e-10": _moment_of_inertia_1e_10,
    "1e-6": _moment_of_inertia_1e_6, "float32": _moment_of_inertia_float32}
_call_moment_of_inertia = kernel("moment_of_inertia", TEXTS["moment_of_inertia"])


@direct
def moment_of_inertia(alpha, out=None, *, where=True, accuracy=None):
    """Return Theta*, the moment of inertia of the moving mass about the centre, dimensionless.

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
    flag, of NaN without.
    Accuracy: proved, rounding included: 0.784 ulp compiled with FMA, 3.92 without, 3.92 in NumPy;
    accuracy=1e-10: 3.56e-12 relative; accuracy=1e-6: 2.42e-07 relative; float32: correctly rounded
    (certificates/moment_of_inertia.json).
    Source: eq. (3.12) of the paper.
    Arrays: numbers, lists, NumPy, pint, xarray, pandas, Dask and JAX. Safe in threads. Compiled, an element of
    a large array takes about 1 ns. Unlike NumPy's ufuncs, arguments may be named and `out` is one array, not a
    tuple; dtype= and casting= are not supported.

    Examples
    --------
    >>> from generated import moment_of_inertia
    >>> print(f"{moment_of_inertia(0.5):.6f}")
    0.071867
    """
    return _call_moment_of_inertia(alpha, out, where, accuracy)


def _radial_weight_amplitude(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, (-0.30000000000000443, 0.027380952381361054, -0.0020502645635375287,
        -2.9310747248092117e-05, -2.359162657327504e-05, -5.737071000804523e-06, -1.6607207250726915e-06,
        -2.523751686440813e-07, -6.323341559797518e-07, 8.429350784762609e-07, -1.1989538168552983e-06,
        1.1845285368728222e-06, -8.809582775890203e-07, 4.6694895918490556e-07, -1.6952524017670547e-07,
        3.767877363596828e-08, -3.9738447224952535e-09))
    near = (alpha_2 * (p1 * alpha_2) + alpha_2) / 1.5 * alpha
    b = 1.5707963267948966 - alpha
    b_2 = b * b
    p2 = horner(b_2, (0.11370563888040008, 0.5870981205544475, -0.08591862402579921, 0.006850929563488556,
        -0.00033249910103147446, 9.296578378454615e-06))
    p3 = horner(b_2, (1.0000000000000882, -0.3333333332507387, 0.04444445522759079, -0.00317432637871888,
        0.00014250678815565116, -3.5232192030009918e-06))
    t1 = b_2 * (p3 * xp.log(xp.maximum(2.0 * b, 8.673617379884035e-19)) + p2) + 0.03491433660255172
    far = 0.5 * alpha + 0.1796875 + (b * (b * -2.0 + 0.5) + t1)
    return xp.where(alpha < 1.16, near, far)


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
    b = 1.5707963267948966 - alpha
    t1 = b * (alpha + 1.5707963267948966)
    p1 = horner(t1, (-0.24843207970278855, -299790.94517230336, -53094329458.53106, -2208746396253612.0,
        -2.7297195342743515e+19, -1.1620506355947354e+23, -1.890958329010032e+26, -1.2717218610429169e+29,
        -3.7563737385470173e+31, -5.114482771541253e+33, -3.335705387356763e+35, -1.073673175367051e+37,
        -1.7423760121978842e+38, -1.4430579613622696e+39, -6.105098924586792e+39, -1.3004209734651639e+40,
        -1.3424445458395202e+40, -6.19829378898583e+39, -1.0788349034287355e+39, -4.787898906820424e+37,
        -1.3998398651788972e+36))
    p2 = horner(t1, (1.0, 1206731.9977363856, 213717661137.1219, 8890740919544712.0, 1.0987770961219802e+20,
        4.677514942312853e+23, 7.611469708745196e+26, 5.118826623568652e+29, 1.5119195361909133e+32,
        2.0583620934029367e+34, 1.3422155109080396e+36, 4.318387898554051e+37, 7.00135509006509e+38,
        5.786151103665985e+39, 2.4354875406158717e+40, 5.1226269701670705e+40, 5.114063818316506e+40,
        2.1344004634841737e+40, 2.4056713689245876e+39, -1.5148812239293033e+38, 2.6024155632890138e+36))
    return alpha_2 * alpha * (p1 / p2 * alpha_2 + -5.662137425588298e-17 + 1.0) * 0.6666666666666666


TEXTS["radial_weight_amplitude"] = {"best": _radial_weight_amplitude, "1e-10": _radial_weight_amplitude_1e_10,
    "1e-6": _radial_weight_amplitude_1e_6, "float32": _radial_weight_amplitude_float32}
_call_radial_weight_amplitude = kernel("radial_weight_amplitude", TEXTS["radial_weight_amplitude"])


@direct
def radial_weight_amplitude(alpha, out=None, *, where=True, accuracy=None):
    """Return C_r, the weight of the moving mass along the radius, dimensionless.

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
    flag, of NaN without.
    Accuracy: proved, rounding included: 0.711 ulp compiled with FMA, 4.05 without, 4.05 in NumPy;
    accuracy=1e-10: 5.86e-11 relative; accuracy=1e-6: 3.41e-07 relative; float32: correctly rounded
    (certificates/radial_weight_amplitude.json).
    Source: eq. (2.23) of the paper.
    Arrays: numbers, lists, NumPy, pint, xarray, pandas, Dask and JAX. Safe in threads. Compiled, an element of
    a large array takes about 1 ns. Unlike NumPy's ufuncs, arguments may be named and `out` is one array, not a
    tuple; dtype= and casting= are not supported.

    Examples
    --------
    >>> from generated import radial_weight_amplitude
    >>> print(f"{radial_weight_amplitude(0.5):.6f}")
    0.077223
    """
    return _call_radial_weight_amplitude(alpha, out, where, accuracy)


def _weight_moment_amplitude(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, SERIES_1)
    near = (alpha_2 * (p1 * alpha_2) + alpha_2) / 1.5 * alpha
    b = 1.5707963267948966 - alpha
    b_2 = b * b
    p2 = horner(b_2, (-0.24999999999999947, 0.5833333333332784, -0.16944444444240292, 0.02713293647133452,
        -0.0027121909939875357, 0.00018491167101180786, -9.136881914195445e-06, 3.298125052684321e-07))
    t1 = b * (b * -0.75 + 0.5) + (b_2 * p2 + (b * -1.2246467991473532e-16 + 1.4802973661668753e-16))
    far = 0.5 * alpha + -0.11873149673078176 + t1
    return xp.where(alpha < 1.03, near, far)


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
    p1 = horner(alpha_2, (-5.662137425588298e-17, -0.33333333333333326, 0.0722222222222205,
        -0.00903880070545426, 0.000739638447921641, -4.267209117083234e-05, 1.8288068114793681e-06,
        -6.051185726412952e-08, 1.5923276753779613e-09, -3.4084383795066453e-11, 5.965813193101547e-13,
        -7.493368410306472e-15))
    return alpha_2 * alpha * (p1 + 0.6666666666666666)


TEXTS["weight_moment_amplitude"] = {"best": _weight_moment_amplitude, "1e-10": _weight_moment_amplitude_1e_10,
    "1e-6": _weight_moment_amplitude_1e_6, "float32": _weight_moment_amplitude_float32}
_call_weight_moment_amplitude = kernel("weight_moment_amplitude", TEXTS["weight_moment_amplitude"])


@direct
def weight_moment_amplitude(alpha, out=None, *, where=True, accuracy=None):
    """Return C_theta, the moment of the weight about the centre, dimensionless.

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
    flag, of NaN without.
    Accuracy: proved, rounding included: 0.746 ulp compiled with FMA, 3.82 without, 3.82 in NumPy;
    accuracy=1e-10: 2.07e-12 relative; accuracy=1e-6: 4.38e-07 relative; float32: correctly rounded
    (certificates/weight_moment_amplitude.json).
    Source: eq. (3.13) of the paper.
    Arrays: numbers, lists, NumPy, pint, xarray, pandas, Dask and JAX. Safe in threads. Compiled, an element of
    a large array takes about 1 ns. Unlike NumPy's ufuncs, arguments may be named and `out` is one array, not a
    tuple; dtype= and casting= are not supported.

    Examples
    --------
    >>> from generated import weight_moment_amplitude
    >>> print(f"{weight_moment_amplitude(0.5):.6f}")
    0.073464
    """
    return _call_weight_moment_amplitude(alpha, out, where, accuracy)


def _resistance_factor(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, SERIES_2)
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
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, (-5.662137425588298e-17, -0.08333333333333284, 0.00277777777777281,
        -4.960317458602754e-05, 5.5114635634152e-07, -4.1753266432650525e-09, 2.2929493283404088e-11,
        -9.256453881586108e-14))
    return alpha_2 * alpha * (p1 + 1.0)


TEXTS["resistance_factor"] = {"best": _resistance_factor, "1e-10": _resistance_factor_1e_10,
    "1e-6": _resistance_factor_1e_6, "float32": _resistance_factor_float32}
_call_resistance_factor = kernel("resistance_factor", TEXTS["resistance_factor"])


@direct
def resistance_factor(alpha, out=None, *, where=True, accuracy=None):
    """Return lambda, the lever of the resistance, arc length times depth, dimensionless.

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
    flag, of NaN without.
    Accuracy: proved, rounding included: 0.65 ulp compiled with FMA, 3.01 without, 3.01 in NumPy;
    accuracy=1e-10: 2.74e-12 relative; accuracy=1e-6: 1.71e-07 relative; float32: correctly rounded
    (certificates/resistance_factor.json).
    Source: eq. (3.14) of the paper.
    Arrays: numbers, lists, NumPy, pint, xarray, pandas, Dask and JAX. Safe in threads. Compiled, an element of
    a large array takes about 1 ns. Unlike NumPy's ufuncs, arguments may be named and `out` is one array, not a
    tuple; dtype= and casting= are not supported.

    Examples
    --------
    >>> from generated import resistance_factor
    >>> print(f"{resistance_factor(0.5):.6f}")
    0.122417
    """
    return _call_resistance_factor(alpha, out, where, accuracy)


def _dynamic_coefficient(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, (-0.40000000000000036, 0.0857142857143163, -0.010582010582931184,
        0.0008850408990923499, -4.736017531977007e-05, 2.824509642273071e-06, 8.918936804993921e-08,
        5.312283812220017e-08, -8.28290916617753e-09, 3.39768529756107e-08, -3.4952404680679605e-08,
        3.0732106475213986e-08, -1.8364334220085374e-08, 7.602712023673237e-09, -1.9039567047829526e-09,
        2.3123724272633964e-10))
    b = 1.5707963267948966 - alpha
    b_2 = b * b
    p2 = horner(b_2, (-0.00882683796382319, 0.09885786368001354, -0.033066018317969646, 0.0052104006457507806,
        -0.0004981990095698824, 3.1820436947715596e-05))
    p3 = horner(b_2, (0.3333333333334858, -0.1666666665699842, 0.0361111178026514, -0.004519365188149176,
        0.00036894134337063067, -2.4623510834846708e-05))
    t1 = b * b_2 * (p3 * xp.log(xp.maximum(b, 8.673617379884035e-19)) + p2) + 0.015463724401701127
    t2 = alpha < 1.14
    t3 = xp.where(t2, 1.0 + p1 * alpha_2, alpha + -0.5390625 + t1)
    p4 = horner(alpha_2, SERIES_2)
    t4 = xp.where(t2, 1.0 + p4 * alpha_2, _resistance_factor(alpha, xp))
    return xp.where(t2, t3 / 1.5, t3) / xp.where(t2, t4, t4)


TEXTS["dynamic_coefficient"] = {"best": _dynamic_coefficient}
_call_dynamic_coefficient = kernel("dynamic_coefficient", TEXTS["dynamic_coefficient"])


@direct
def dynamic_coefficient(alpha, out=None, *, where=True, accuracy=None):
    """Return A, the coefficient of omega*^2 in the mean normal stress (2.20), dimensionless.

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
    flag, of NaN without.
    Accuracy: proved, rounding included: 0.791 ulp compiled with FMA, 3.98 without, 3.98 in NumPy; float32: this
    double rounded, with half an ulp of float32 more (certificates/dynamic_coefficient.json).
    Source: eq. (2.24) of the paper.
    Arrays: numbers, lists, NumPy, pint, xarray, pandas, Dask and JAX. Safe in threads. Compiled, an element of
    a large array takes about 1 ns. Unlike NumPy's ufuncs, arguments may be named and `out` is one array, not a
    tuple; dtype= and casting= are not supported.

    Examples
    --------
    >>> from generated import dynamic_coefficient
    >>> print(f"{dynamic_coefficient(0.5):.6f}")
    0.616194
    """
    return _call_dynamic_coefficient(alpha, out, where, accuracy)


def _weight_moment_per_inertia(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, SERIES_1)
    b = 1.5707963267948966 - alpha
    b_2 = b * b
    p2 = horner(b_2, (-0.12499999999999947, 0.5833333333332784, -0.16944444444240292, 0.02713293647133452,
        -0.0027121909939875357, 0.00018491167101180786, -9.136881914195445e-06, 3.298125052684321e-07))
    t1 = b * (b * -0.875 + 0.5) + (b_2 * p2 + (b * -1.2246467991473532e-16 + 1.4802973661668753e-16))
    t2 = 0.5 * alpha
    t3 = alpha < 1.03
    p3 = horner(alpha_2, (-0.6, 0.20952380952380847, -0.04550264550262826, 0.0065800865799451776,
        -0.0006738940065532301, 5.132550962307507e-05, -3.0188674074455013e-06, 1.41225369728428e-07,
        -5.375785948582399e-09, 1.677564133083151e-10, -3.802914549757597e-12))
    p4 = horner(b_2, (-0.16666666666666688, -0.22222222222219154, 0.3111111111094639, -0.13121693117498273,
        0.02986478483001271, -0.00436961720864293, 0.0004487989664096435, -3.413175786177963e-05,
        1.8828772896407477e-06))
    t4 = xp.where(t3, 1.0 + p3 * alpha_2, t2 + -0.0546875 + (b * p4 + 0.05468749999999999))
    return xp.where(t3, 1.0 + p1 * alpha_2, t2 + -0.11873149673078176 + t1) / t4


TEXTS["weight_moment_per_inertia"] = {"best": _weight_moment_per_inertia}
_call_weight_moment_per_inertia = kernel("weight_moment_per_inertia", TEXTS["weight_moment_per_inertia"])


@direct
def weight_moment_per_inertia(alpha, out=None, *, where=True, accuracy=None):
    """Return C_theta/Theta*, the drive of gravity in the equation of motion, dimensionless.

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
    flag, of NaN without.
    Accuracy: proved, rounding included: 0.849 ulp compiled with FMA, 3.25 without, 3.25 in NumPy; float32: this
    double rounded, with half an ulp of float32 more (certificates/weight_moment_per_inertia.json).
    Source: eq. (3.17) of the paper.
    Arrays: numbers, lists, NumPy, pint, xarray, pandas, Dask and JAX. Safe in threads. Compiled, an element of
    a large array takes about 1 ns. Unlike NumPy's ufuncs, arguments may be named and `out` is one array, not a
    tuple; dtype= and casting= are not supported.

    Examples
    --------
    >>> from generated import weight_moment_per_inertia
    >>> print(f"{weight_moment_per_inertia(0.5):.6f}")
    1.022210
    """
    return _call_weight_moment_per_inertia(alpha, out, where, accuracy)


def _radial_weight_per_inertia(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, (-0.3000000000000005, 0.02738095238100271, -0.0020502645520764015,
        -2.9310933702505553e-05, -2.3589812421668114e-05, -5.748626386238054e-06, -1.6097657066449622e-06,
        -4.1362879765688486e-07, -2.5766208992811846e-07, 1.9548887349209718e-07, -3.632796586517013e-07,
        3.823682759266141e-07, -3.1669738416549463e-07, 1.845491695579341e-07, -7.434388969470277e-08,
        1.8315791000679476e-08, -2.177882597962352e-09))
    b = 1.5707963267948966 - alpha
    b_2 = b * b
    p2 = horner(b_2, (-0.011294361119653965, 0.5870981204813102, -0.08591863242948194, 0.006850808145690842,
        -0.000332245915550729, 1.0783014412464472e-05))
    p3 = horner(b_2, (1.0000000000000748, -0.3333333332805437, 0.044444449500505266, -0.0031745142197574456,
        0.00014131902715019387, -4.517290126971216e-06))
    t1 = b_2 * (p3 * xp.log(xp.maximum(2.0 * b, 8.673617379884035e-19)) + p2) + 0.04272683660255172
    t2 = 0.5 * alpha
    t3 = alpha < 1.11
    t4 = xp.where(t3, 1.0 + p1 * alpha_2, t2 + 0.171875 + (b * (b * -1.875 + 0.5) + t1))
    p4 = horner(alpha_2, (-0.6, 0.20952380952380845, -0.045502645502627885, 0.006580086579944287,
        -0.0006738940065614713, 5.132550968382343e-05, -3.0188675851820063e-06, 1.4122565172285413e-07,
        -5.376040189172496e-09, 1.6787903900515265e-10, -3.827521599329173e-12))
    p5 = horner(b_2, (-0.16666666666666685, -0.22222222222219618, 0.3111111111096943, -0.13121693118022226,
        0.02986478489497928, -0.004369617685531612, 0.00044880107843296116, -3.413705944082581e-05,
        1.888712989097015e-06))
    t5 = xp.where(t3, 1.0 + p4 * alpha_2, t2 + -0.0546875 + (b * p5 + 0.05468749999999999))
    return t4 / t5


TEXTS["radial_weight_per_inertia"] = {"best": _radial_weight_per_inertia}
_call_radial_weight_per_inertia = kernel("radial_weight_per_inertia", TEXTS["radial_weight_per_inertia"])


@direct
def radial_weight_per_inertia(alpha, out=None, *, where=True, accuracy=None):
    """Return C_r/Theta*, the brake of static friction in the equation of motion, dimensionless.

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
    flag, of NaN without.
    Accuracy: proved, rounding included: 1.06 ulp compiled with FMA, 3.68 without, 3.68 in NumPy; float32: this
    double rounded, with half an ulp of float32 more (certificates/radial_weight_per_inertia.json).
    Source: eq. (3.17) of the paper.
    Arrays: numbers, lists, NumPy, pint, xarray, pandas, Dask and JAX. Safe in threads. Compiled, an element of
    a large array takes about 1 ns. Unlike NumPy's ufuncs, arguments may be named and `out` is one array, not a
    tuple; dtype= and casting= are not supported.

    Examples
    --------
    >>> from generated import radial_weight_per_inertia
    >>> print(f"{radial_weight_per_inertia(0.5):.6f}")
    1.074524
    """
    return _call_radial_weight_per_inertia(alpha, out, where, accuracy)


def _polar_moment_per_inertia(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, (-0.4000000000000004, 0.08571428571431881, -0.010582010582942055,
        0.0008850408982730014, -4.736015864264007e-05, 2.8243531481499e-06, 9.008013767016806e-08,
        4.9737779482696804e-08, 7.117714173185223e-10, 1.6882459191940736e-08, -1.15560506084502e-08,
        7.840839407231713e-09, -2.7401008140313025e-09, 5.353191284833124e-10))
    b = 1.5707963267948966 - alpha
    b_2 = b * b
    p2 = horner(b_2, (-0.008826837961427752, 0.09885786421132424, -0.033066013063606875, 0.00521022727822448,
        -0.0004986980279078123, 3.2465652459368815e-05))
    p3 = horner(b_2, (0.3333333333341266, -0.16666666633743915, 0.036111124040964115, -0.004519447094263767,
        0.00036802998570292377, -2.5392817363572472e-05))
    t1 = b * b_2 * (p3 * xp.log(xp.maximum(b, 8.673617379884035e-19)) + p2) + 0.03890122440170113
    t2 = alpha < 1.04
    p4 = horner(alpha_2, (-0.6, 0.2095238095238085, -0.04550264550262904, 0.006580086579953581,
        -0.0006738940066006911, 5.1325509780678385e-05, -3.0188677315258672e-06, 1.412257872526488e-07,
        -5.376113894858473e-09, 1.6789994426219067e-10, -3.829739283038018e-12))
    p5 = horner(b_2, (-0.16666666666666685, -0.22222222222219623, 0.3111111111096991, -0.1312169311803108,
        0.029864784894164376, -0.004369617647047175, 0.0004488006722756672, -3.413527762193474e-05,
        1.8858652415852653e-06))
    t3 = xp.where(t2, 1.0 + p4 * alpha_2, 0.5 * alpha + -0.0546875 + (b * p5 + 0.05468749999999999))
    return xp.where(t2, 1.0 + p1 * alpha_2, alpha + -0.5625 + t1) / t3


TEXTS["polar_moment_per_inertia"] = {"best": _polar_moment_per_inertia}
_call_polar_moment_per_inertia = kernel("polar_moment_per_inertia", TEXTS["polar_moment_per_inertia"])


@direct
def polar_moment_per_inertia(alpha, out=None, *, where=True, accuracy=None):
    """Return I_p*/Theta*, the brake of centripetal friction in the equation of motion, dimensionless.

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
    flag, of NaN without.
    Accuracy: proved, rounding included: 0.859 ulp compiled with FMA, 3.2 without, 3.2 in NumPy; float32: this
    double rounded, with half an ulp of float32 more (certificates/polar_moment_per_inertia.json).
    Source: eq. (3.18) of the paper.
    Arrays: numbers, lists, NumPy, pint, xarray, pandas, Dask and JAX. Safe in threads. Compiled, an element of
    a large array takes about 1 ns. Unlike NumPy's ufuncs, arguments may be named and `out` is one array, not a
    tuple; dtype= and casting= are not supported.

    Examples
    --------
    >>> from generated import polar_moment_per_inertia
    >>> print(f"{polar_moment_per_inertia(0.5):.6f}")
    1.049612
    """
    return _call_polar_moment_per_inertia(alpha, out, where, accuracy)


def _weight_moment_per_radial_weight(alpha: Array, xp: Any = np) -> Array:
    alpha_2 = alpha * alpha
    p1 = horner(alpha_2, (-0.5, 0.10833333333333316, -0.013558201058197508, 0.0011094576719297984,
        -6.400813680902941e-05, 2.743210170353137e-06, -9.076756699884043e-08, 2.3881976877903854e-09,
        -5.0922462259974074e-11, 8.205773118275206e-13))
    b = 1.5707963267948966 - alpha
    b_2 = b * b
    p2 = horner(b_2, (-0.12499999999999997, 0.5833333333333308, -0.1694444444442715, 0.027132936503138506,
        -0.0027121912858520157, 0.00018491315678955818, -9.140842683979124e-06, 3.3413722889953973e-07))
    t1 = b * (b * -0.875 + 0.5) + (b_2 * p2 + (b * -1.2246467991473532e-16 + 1.4802973661668753e-16))
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
    return xp.where(t3, 1.0 + p1 * alpha_2, t2 + -0.11873149673078176 + t1) / t5


TEXTS["weight_moment_per_radial_weight"] = {"best": _weight_moment_per_radial_weight}
_call_weight_moment_per_radial_weight = kernel("weight_moment_per_radial_weight",
    TEXTS["weight_moment_per_radial_weight"])


@direct
def weight_moment_per_radial_weight(alpha, out=None, *, where=True, accuracy=None):
    """Return C_theta/C_r, the limit friction over tan(psi), dimensionless.

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
    flag, of NaN without.
    Accuracy: proved, rounding included: 0.95 ulp compiled with FMA, 4 without, 4 in NumPy; float32: this double
    rounded, with half an ulp of float32 more (certificates/weight_moment_per_radial_weight.json).
    Source: eq. (3.21) of the paper.
    Arrays: numbers, lists, NumPy, pint, xarray, pandas, Dask and JAX. Safe in threads. Compiled, an element of
    a large array takes about 1 ns. Unlike NumPy's ufuncs, arguments may be named and `out` is one array, not a
    tuple; dtype= and casting= are not supported.

    Examples
    --------
    >>> from generated import weight_moment_per_radial_weight
    >>> print(f"{weight_moment_per_radial_weight(0.5):.6f}")
    0.951314
    """
    return _call_weight_moment_per_radial_weight(alpha, out, where, accuracy)


def _radial_weight(theta_1: Array, theta_2: Array, xp: Any = np) -> Array:
    t1 = _radial_weight_amplitude(xp.minimum((theta_2 - theta_1) * 0.5, 1.5707963267948966), xp)
    t2, t3, t4 = _cos_psi(theta_1, theta_2, xp)
    t5 = t2 * 0.5
    t6 = t5 * t5
    t7 = (t6 * -3.868170170630684e-23 + 1.9572941063391263e-20) * t6 + -8.22063524662433e-18
    t8 = ((t7 * t6 + 2.8114572543455206e-15) * t6 + -7.647163731819816e-13) * t6
    t9 = ((t8 + 1.6059043836821613e-10) * t6 + -2.505210838544172e-08) * t6 + 2.7557319223985893e-06
    t10 = ((t9 * t6 + -0.0001984126984126984) * t6 + 0.008333333333333333) * t6 + -0.16666666666666666
    return t1 * (t10 * t6 + 1.0) * t4 * (t2 + (t3 + t2 * _share(theta_1, theta_2, xp)))


def _radial_weight_1e_10(theta_1: Array, theta_2: Array, xp: Any = np) -> Array:
    t1 = _radial_weight_amplitude_1e_10(xp.minimum((theta_2 - theta_1) * 0.5, 1.5707963267948966), xp)
    t2, t3, t4 = _cos_psi(theta_1, theta_2, xp)
    t5 = t2 * 0.5
    t6 = t5 * t5
    t7 = (t6 * -7.647163731819816e-13 + 1.6059043836821613e-10) * t6 + -2.505210838544172e-08
    t8 = ((t7 * t6 + 2.7557319223985893e-06) * t6 + -0.0001984126984126984) * t6
    t9 = t1 * (((t8 + 0.008333333333333333) * t6 + -0.16666666666666666) * t6 + 1.0)
    return t9 * t4 * (t2 + (t3 + t2 * _share(theta_1, theta_2, xp)))


def _radial_weight_float32(theta_1: Array, theta_2: Array, xp: Any = np) -> Array:
    return _radial_weight_1e_10(theta_1, theta_2, xp)


def _radial_weight_1e_6(theta_1: Array, theta_2: Array, xp: Any = np) -> Array:
    t1 = _radial_weight_amplitude_1e_6(xp.minimum((theta_2 - theta_1) * 0.5, 1.5707963267948966), xp)
    t2, t3, t4 = _cos_psi(theta_1, theta_2, xp)
    t5 = t2 * 0.5
    t6 = t5 * t5
    t7 = (t6 * -2.505210838544172e-08 + 2.7557319223985893e-06) * t6 + -0.0001984126984126984
    t8 = ((t7 * t6 + 0.008333333333333333) * t6 + -0.16666666666666666) * t6 + 1.0
    return t1 * t8 * t4 * (t2 + (t3 + t2 * _share(theta_1, theta_2, xp)))


TEXTS["radial_weight"] = {"best": _radial_weight, "1e-10": _radial_weight_1e_10, "float32": _radial_weight_float32,
    "1e-6": _radial_weight_1e_6}
_call_radial_weight = kernel("radial_weight", TEXTS["radial_weight"], both_ends=True)


@direct
def radial_weight(theta_1, theta_2, out=None, *, where=True, accuracy=None):
    """Return J_r, the weight of the moving mass along the radius, dimensionless.

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
    accuracy : float, optional
        Relative error to meet: the cheapest tier that is proved to meet it, or a ValueError. By default the
        best tier.

    Returns
    -------
    ndarray or scalar
        J_r. Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32.

    Notes
    -----
    Domain: 0 <= (theta_2 - theta_1)/2 <= pi/2 (1 + 4 eps), both ends within 65536 rad of 0; elsewhere NaN and
    NumPy's ``invalid`` flag, of NaN without.
    Accuracy: proved, rounding included: 8.56e-16 relative compiled with FMA, 1.6e-15 without, 1.6e-15 in NumPy;
    accuracy=1e-10: 6.47e-11 relative; accuracy=1e-6: 3.99e-07 relative; float32: 0.502 ulp
    (certificates/radial_weight.json).
    Source: eq. (2.23) of the paper.
    Arrays: numbers, lists, NumPy, pint, xarray, pandas, Dask and JAX. Safe in threads. Compiled, an element of
    a large array takes about 1 ns. Unlike NumPy's ufuncs, arguments may be named and `out` is one array, not a
    tuple; dtype= and casting= are not supported.

    Examples
    --------
    >>> from generated import radial_weight
    >>> print(f"{radial_weight(4.0, 5.0):.6f}")
    0.075488
    """
    return _call_radial_weight(theta_1, theta_2, out, where, accuracy)


def _weight_moment(theta_1: Array, theta_2: Array, xp: Any = np) -> Array:
    t1 = _weight_moment_amplitude(xp.minimum((theta_2 - theta_1) * 0.5, 1.5707963267948966), xp)
    t2, t3, t4 = _sin_psi(theta_1, theta_2, xp)
    t5 = t2 * 0.5
    t6 = t5 * t5
    t7 = (t6 * -3.868170170630684e-23 + 1.9572941063391263e-20) * t6 + -8.22063524662433e-18
    t8 = ((t7 * t6 + 2.8114572543455206e-15) * t6 + -7.647163731819816e-13) * t6
    t9 = ((t8 + 1.6059043836821613e-10) * t6 + -2.505210838544172e-08) * t6 + 2.7557319223985893e-06
    t10 = ((t9 * t6 + -0.0001984126984126984) * t6 + 0.008333333333333333) * t6 + -0.16666666666666666
    return t1 * (t10 * t6 + 1.0) * t4 * (t2 + (t3 + t2 * _share(theta_1, theta_2, xp)))


def _weight_moment_1e_10(theta_1: Array, theta_2: Array, xp: Any = np) -> Array:
    t1 = _weight_moment_amplitude_1e_10(xp.minimum((theta_2 - theta_1) * 0.5, 1.5707963267948966), xp)
    t2, t3, t4 = _sin_psi(theta_1, theta_2, xp)
    t5 = t2 * 0.5
    t6 = t5 * t5
    t7 = (t6 * -7.647163731819816e-13 + 1.6059043836821613e-10) * t6 + -2.505210838544172e-08
    t8 = ((t7 * t6 + 2.7557319223985893e-06) * t6 + -0.0001984126984126984) * t6
    t9 = t1 * (((t8 + 0.008333333333333333) * t6 + -0.16666666666666666) * t6 + 1.0)
    return t9 * t4 * (t2 + (t3 + t2 * _share(theta_1, theta_2, xp)))


def _weight_moment_float32(theta_1: Array, theta_2: Array, xp: Any = np) -> Array:
    return _weight_moment_1e_10(theta_1, theta_2, xp)


def _weight_moment_1e_6(theta_1: Array, theta_2: Array, xp: Any = np) -> Array:
    t1 = _weight_moment_amplitude_1e_6(xp.minimum((theta_2 - theta_1) * 0.5, 1.5707963267948966), xp)
    t2, t3, t4 = _sin_psi(theta_1, theta_2, xp)
    t5 = t2 * 0.5
    t6 = t5 * t5
    t7 = (t6 * -2.505210838544172e-08 + 2.7557319223985893e-06) * t6 + -0.0001984126984126984
    t8 = ((t7 * t6 + 0.008333333333333333) * t6 + -0.16666666666666666) * t6 + 1.0
    return t1 * t8 * t4 * (t2 + (t3 + t2 * _share(theta_1, theta_2, xp)))


TEXTS["weight_moment"] = {"best": _weight_moment, "1e-10": _weight_moment_1e_10, "float32": _weight_moment_float32,
    "1e-6": _weight_moment_1e_6}
_call_weight_moment = kernel("weight_moment", TEXTS["weight_moment"], both_ends=True)


@direct
def weight_moment(theta_1, theta_2, out=None, *, where=True, accuracy=None):
    """Return J_theta, the moment of the weight about the centre, dimensionless.

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
    accuracy : float, optional
        Relative error to meet: the cheapest tier that is proved to meet it, or a ValueError. By default the
        best tier.

    Returns
    -------
    ndarray or scalar
        J_theta. Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32.

    Notes
    -----
    Domain: 0 <= (theta_2 - theta_1)/2 <= pi/2 (1 + 4 eps), both ends within 65536 rad of 0; elsewhere NaN and
    NumPy's ``invalid`` flag, of NaN without.
    Accuracy: proved, rounding included: 8.47e-16 relative compiled with FMA, 1.53e-15 without, 1.53e-15 in
    NumPy; accuracy=1e-10: 8.17e-12 relative; accuracy=1e-6: 4.96e-07 relative; float32: 0.501 ulp
    (certificates/weight_moment.json).
    Source: eq. (3.13) of the paper.
    Arrays: numbers, lists, NumPy, pint, xarray, pandas, Dask and JAX. Safe in threads. Compiled, an element of
    a large array takes about 1 ns. Unlike NumPy's ufuncs, arguments may be named and `out` is one array, not a
    tuple; dtype= and casting= are not supported.

    Examples
    --------
    >>> from generated import weight_moment
    >>> print(f"{weight_moment(4.0, 5.0):.6f}")
    0.015486
    """
    return _call_weight_moment(theta_1, theta_2, out, where, accuracy)


def _limit_friction(theta_1: Array, theta_2: Array, xp: Any = np) -> Array:
    t1 = _weight_moment_per_radial_weight(xp.minimum((theta_2 - theta_1) * 0.5, 1.5707963267948966), xp)
    t2, t3, t4 = _sin_psi(theta_1, theta_2, xp)
    t5 = t2 * 0.5
    t6 = t5 * t5
    t7 = (t6 * -3.868170170630684e-23 + 1.9572941063391263e-20) * t6 + -8.22063524662433e-18
    t8 = ((t7 * t6 + 2.8114572543455206e-15) * t6 + -7.647163731819816e-13) * t6
    t9 = ((t8 + 1.6059043836821613e-10) * t6 + -2.505210838544172e-08) * t6 + 2.7557319223985893e-06
    t10 = ((t9 * t6 + -0.0001984126984126984) * t6 + 0.008333333333333333) * t6 + -0.16666666666666666
    t11, t12, t13 = _cos_psi(theta_1, theta_2, xp)
    t14 = t11 * 0.5
    t15 = t14 * t14
    t16 = (t15 * -3.868170170630684e-23 + 1.9572941063391263e-20) * t15 + -8.22063524662433e-18
    t17 = ((t16 * t15 + 2.8114572543455206e-15) * t15 + -7.647163731819816e-13) * t15
    t18 = ((t17 + 1.6059043836821613e-10) * t15 + -2.505210838544172e-08) * t15
    t19 = ((t18 + 2.7557319223985893e-06) * t15 + -0.0001984126984126984) * t15 + 0.008333333333333333
    t20 = (t2 + t3) * (t1 * (t10 * t6 + 1.0) / ((t19 * t15 + -0.16666666666666666) * t15 + 1.0))
    return t20 * (t4 * t13 * 4.0) / (t11 + t12)


TEXTS["limit_friction"] = {"best": _limit_friction}
_call_limit_friction = kernel("limit_friction", TEXTS["limit_friction"], both_ends=True)


@direct
def limit_friction(theta_1, theta_2, out=None, *, where=True, accuracy=None):
    """Return mu_eq, the friction coefficient at limit equilibrium.

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
    accuracy : float, optional
        Relative error to meet: the cheapest tier that is proved to meet it, or a ValueError. By default the
        best tier.

    Returns
    -------
    ndarray or scalar
        mu_eq. Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32.

    Notes
    -----
    Domain: 0 <= (theta_2 - theta_1)/2 <= pi/2 (1 + 4 eps), both ends within 65536 rad of 0; elsewhere NaN and
    NumPy's ``invalid`` flag, of NaN without.
    Accuracy: proved, rounding included: 1.59e-15 relative compiled with FMA, 2.27e-15 without, 2.27e-15 in
    NumPy; float32: this double rounded, with half an ulp of float32 more (certificates/limit_friction.json).
    Source: eq. (3.21) of the paper.
    Arrays: numbers, lists, NumPy, pint, xarray, pandas, Dask and JAX. Safe in threads. Compiled, an element of
    a large array takes about 1 ns. Unlike NumPy's ufuncs, arguments may be named and `out` is one array, not a
    tuple; dtype= and casting= are not supported.

    Examples
    --------
    >>> from generated import limit_friction
    >>> print(f"{limit_friction(4.0, 5.0):.6f}")
    0.205143
    """
    return _call_limit_friction(theta_1, theta_2, out, where, accuracy)
