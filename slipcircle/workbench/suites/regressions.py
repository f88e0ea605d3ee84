"""Published regressions of the displacement of sliding blocks, with their standard deviations and ranges.

All give the natural logarithm of a displacement in cm; r is the yield coefficient over the peak acceleration. The
coefficients agree with SLAMMER of the U.S. Geological Survey or with pyGEEMs, their results with worked examples in
Kramer and Stewart (Geotechnical Earthquake Engineering, 2nd ed.), Rathje and others (2014), Bray (2007) and Table 1 of
Bray and Travasarou (2007). Two doubts are left: SLAMMER has -3.320 for the -3.230 of Jibson's equation 9, and the range
of Bray and Travasarou is that in use, not confirmed in the paper.
"""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
_LN_10 = math.log(10.0)
RIGID = 0.05  # s, fundamental period below which Bray and Travasarou (2007) take a mass for rigid


@dataclass(frozen=True)
class Shaking:
    """Intensity measures of records, arrays of one value each.

    Attributes
    ----------
    k_y : float
        Yield coefficient of the slope.
    pga, pgv, arias : ndarray
        Over gravity, m/s and m/s.
    magnitude : float
        NaN if it is not known; regressions that need it then give NaN.
    period : float
        Fundamental period T_s of the sliding mass, s; 0 of a rigid one.
    spectral : ndarray, optional
        Pseudo-acceleration of 5 % damping at the period 1.5 T_s over gravity; by default the peak acceleration.
    """

    k_y: float
    pga: Floats
    pgv: Floats
    arias: Floats
    magnitude: float = math.nan
    period: float = 0.0
    spectral: Floats | None = None

    @property
    def ratio(self) -> Floats:
        return self.k_y / self.pga

    @property
    def response(self) -> Floats:
        """The pseudo-acceleration at 1.5 T_s over gravity, which of a rigid mass is the peak acceleration."""
        return self.pga if self.spectral is None else self.spectral


@dataclass(frozen=True)
class Regression:
    """A published regression.

    Attributes
    ----------
    name : str
    source : str
        Where its coefficients stand.
    ln_cm : callable
        ln D of `Shaking`; NaN or negative infinity where nothing moves.
    std_ln : callable
        Standard deviation of ln D.
    limits : mapping
        Least and greatest values of its authors' data, by the attributes of `Shaking`.
    least_cm : float
        Displacement that counts as none.
    none : callable, optional
        Probability that there is none.
    """

    name: str
    source: str
    ln_cm: Callable[[Shaking], Floats]
    std_ln: Callable[[Shaking], Floats]
    limits: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    least_cm: float = 0.0
    none: Callable[[Shaking], Floats] | None = None

    def in_range(self, shaking: Shaking) -> NDArray[np.bool_]:
        """Which records lie within its range; measures that are not known do not exclude a record."""
        inside = np.isfinite(self.ln_cm(shaking)) & (shaking.ratio < 1.0)
        for measure, (least, greatest) in self.limits.items():
            value = getattr(shaking, measure)
            outside = (value < least) | (value > greatest)
            inside &= ~np.asarray(outside)
        return np.asarray(inside)


def _of_ratio(constant: float, one: float, other: float) -> Callable[[Shaking], Floats]:
    """Log10 D = constant + log10[(1 - r)^one r^other]."""

    def ln_cm(shaking: Shaking) -> Floats:
        r = shaking.ratio
        with np.errstate(invalid="ignore", divide="ignore"):
            return np.asarray(_LN_10 * constant + one * np.log1p(-r) + other * np.log(r))

    return ln_cm


def _jibson_arias(shaking: Shaking) -> Floats:
    log_arias = np.log10(shaking.arias)
    log_ratio = np.log10(shaking.ratio)
    return np.asarray(_LN_10 * (0.561 * log_arias - 3.833 * log_ratio - 1.474))


def _jibson_magnitude(shaking: Shaking) -> Floats:
    of_ratio = _of_ratio(-2.710, 2.335, -1.478)
    return of_ratio(shaking) + _LN_10 * 0.424 * shaking.magnitude


def _jibson_arias_only(shaking: Shaking) -> Floats:
    log_arias = np.log10(shaking.arias)
    log_yield = math.log10(shaking.k_y)
    return np.asarray(_LN_10 * (2.401 * log_arias - 3.481 * log_yield - 3.230))


def _polynomial(shaking: Shaking, *coefficients: float) -> Floats:
    """A polynomial of r."""
    return np.asarray(np.polynomial.Polynomial(coefficients)(shaking.ratio))


def _saygili_rathje_peak(shaking: Shaking) -> Floats:
    of_ratio = _polynomial(shaking, 5.52, -4.43, -20.39, 42.61, -28.74)
    return of_ratio + 0.72 * np.log(shaking.pga)


def _saygili_rathje(shaking: Shaking) -> Floats:
    of_ratio = _polynomial(shaking, -1.56, -4.58, -20.84, 44.75, -30.50)
    velocity_cm = 100.0 * shaking.pgv
    return np.asarray(of_ratio - 0.64 * np.log(shaking.pga) + 1.55 * np.log(velocity_cm))


def _saygili_rathje_two(shaking: Shaking) -> Floats:
    of_ratio = _polynomial(shaking, 2.39, -5.24, -18.78, 42.01, -29.15)
    return np.asarray(of_ratio - 1.56 * np.log(shaking.pga) + 1.38 * np.log(shaking.arias))


def _saygili_rathje_three(shaking: Shaking) -> Floats:
    of_ratio = _polynomial(shaking, -0.74, -4.93, -19.91, 43.75, -30.12)
    velocity_cm = 100.0 * shaking.pgv
    of_peaks = -1.30 * np.log(shaking.pga) + 1.04 * np.log(velocity_cm)
    return np.asarray(of_ratio + of_peaks + 0.67 * np.log(shaking.arias))


def _rathje_saygili(shaking: Shaking) -> Floats:
    of_ratio = _polynomial(shaking, 4.89, -4.85, -19.64, 42.49, -29.06)
    return np.asarray(of_ratio + 0.72 * np.log(shaking.pga) + 0.89 * (shaking.magnitude - 6.0))


def _bray_travasarou(shaking: Shaking) -> Floats:
    """Equation 5, and 6 of a rigid mass."""
    y = math.log(shaking.k_y)
    s = np.log(shaking.response)
    of_period = -0.22 if shaking.period < RIGID else -1.10 + 1.50 * shaking.period
    of_slope = -2.83 * y - 0.333 * y * y
    of_shaking = 0.566 * y * s + 3.04 * s - 0.244 * s * s
    return np.asarray(of_period + of_slope + of_shaking + 0.278 * (shaking.magnitude - 7.0))


def _no_displacement(shaking: Shaking) -> Floats:
    """Probability of less than 1 cm by Bray and Travasarou (2007), equation 3."""
    y = math.log(shaking.k_y)
    s = np.log(shaking.response)
    z = -1.76 - 3.22 * y - 0.484 * shaking.period * y + 3.52 * s
    return np.array([0.5 * math.erfc(x / math.sqrt(2.0)) for x in z.tolist()])


def _constant(std: float) -> Callable[[Shaking], Floats]:
    return lambda shaking: np.full_like(shaking.pga, std)


_JIBSON = {"k_y": (0.05, 0.40), "magnitude": (5.3, 7.6)}
_SAYGILI_RATHJE = {"k_y": (0.05, 0.30)}
_ASCE = "Journal of Geotechnical and Geoenvironmental Engineering"
REGRESSIONS = (
    Regression(
        "Ambraseys and Menu (1988)",
        "Earthquake Engineering and Structural Dynamics 16, 985-1006",
        _of_ratio(0.90, 2.53, -1.09),
        _constant(0.30 * _LN_10),
        {"ratio": (0.1, 1.0), "magnitude": (6.6, 7.3)},
    ),
    Regression(
        "Jibson (2007), r",
        "Engineering Geology 91, 209-218, eq. 6",
        _of_ratio(0.215, 2.341, -1.438),
        _constant(0.510 * _LN_10),
        _JIBSON,
    ),
    Regression(
        "Jibson (2007), Arias intensity and r",
        "Engineering Geology 91, 209-218, eq. 10",
        _jibson_arias,
        _constant(0.616 * _LN_10),
        _JIBSON,
    ),
    Regression(
        "Jibson (2007), r and magnitude",
        "Engineering Geology 91, 209-218, eq. 7",
        _jibson_magnitude,
        _constant(0.454 * _LN_10),
        _JIBSON,
    ),
    Regression(
        "Jibson (2007), Arias intensity and k_y",
        "Engineering Geology 91, 209-218, eq. 9",
        _jibson_arias_only,
        _constant(0.656 * _LN_10),
        _JIBSON,
    ),
    Regression(
        "Saygili and Rathje (2008), PGA",
        f"{_ASCE} 134, 790-803",
        _saygili_rathje_peak,
        _constant(1.13),
        _SAYGILI_RATHJE,
    ),
    Regression(
        "Saygili and Rathje (2008), PGA and PGV",
        f"{_ASCE} 134, 790-803, eq. 6",
        _saygili_rathje,
        lambda shaking: 0.41 + 0.52 * shaking.ratio,
        _SAYGILI_RATHJE,
    ),
    Regression(
        "Saygili and Rathje (2008), PGA and Arias intensity",
        f"{_ASCE} 134, 790-803",
        _saygili_rathje_two,
        lambda shaking: 0.46 + 0.56 * shaking.ratio,
        _SAYGILI_RATHJE,
    ),
    Regression(
        "Saygili and Rathje (2008), PGA, PGV and Arias intensity",
        f"{_ASCE} 134, 790-803",
        _saygili_rathje_three,
        lambda shaking: 0.20 + 0.79 * shaking.ratio,
        _SAYGILI_RATHJE,
    ),
    Regression(
        "Rathje and Saygili (2009), PGA and magnitude",
        "Bulletin of the New Zealand Society for Earthquake Engineering 42, 18-27",
        _rathje_saygili,
        lambda shaking: 0.732 + 0.789 * shaking.ratio - 0.539 * shaking.ratio**2,
        _SAYGILI_RATHJE,
    ),
    Regression(
        "Bray and Travasarou (2007)",
        f"{_ASCE} 133, 381-392, eqs. 3, 5 and 6",
        _bray_travasarou,
        _constant(0.66),
        {"k_y": (0.01, 0.5), "period": (0.0, 2.0), "response": (0.002, 2.7), "magnitude": (4.5, 9.0)},
        least_cm=1.0,
        none=_no_displacement,
    ),
)


class Comparison(NamedTuple):
    """Computed displacements beside a regression.

    Attributes
    ----------
    name, source : str
    of : int
        Records.
    records : int
        Those within its range that move.
    mean, std : float
        Of ln of the computed over the predicted displacement; NaN if fewer than two records are within the range.
    std_ln : float
        The regression's standard deviation of ln D, in the mean of these records.
    none, none_computed : float
        Predicted and computed shares of records within its range without a displacement, where it predicts one; NaN.
    """

    name: str
    source: str
    of: int
    records: int
    mean: float
    std: float
    std_ln: float
    none: float
    none_computed: float


def comparisons(displacement: Floats, shaking: Shaking) -> list[Comparison]:
    """Displacements of a block, m, one a record, beside every regression whose measures are known."""
    rows = []
    displacement_cm = 100.0 * displacement
    for regression in REGRESSIONS:
        inside = regression.in_range(shaking) & np.isfinite(displacement)
        moves = inside & (displacement_cm > regression.least_cm)
        predicted = regression.ln_cm(shaking)
        if np.all(np.isnan(predicted)):  # it needs a measure that is not known
            continue
        count = int(moves.sum())
        mean = std = std_ln = none = none_computed = math.nan
        if count > 1:
            residuals = np.log(displacement_cm[moves]) - predicted[moves]
            mean = float(residuals.mean())
            std = float(residuals.std(ddof=1))
            std_ln = float(regression.std_ln(shaking)[moves].mean())
        if regression.none is not None and np.any(inside):
            none = float(regression.none(shaking)[inside].mean())
            none_computed = 1.0 - count / int(inside.sum())
        numbers = (count, mean, std, std_ln, none, none_computed)
        rows.append(Comparison(regression.name, regression.source, displacement.size, *numbers))
    return rows
