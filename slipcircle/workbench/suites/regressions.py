"""Published regressions of the displacement of sliding blocks, with their standard deviations and ranges.

All give the natural logarithm of a displacement in cm; r is the yield coefficient over the peak acceleration.

Every coefficient and standard deviation agrees with at least two independent public sources: SLAMMER and groundfailure
of the U.S. Geological Survey, OpenQuake, OpenSRA, pyGEEMs, pyNewmarkDisp, newmark (CRAN), Kramer and Stewart
(Geotechnical Earthquake Engineering, 2nd ed.), and the spreadsheet of Bray and Travasarou, which has their range.
Results agree with worked examples in Kramer and Stewart, Rathje and others (2014), Bray (2007), Bray and Travasarou
(2007) and the spreadsheet. Where sources differ:

* Rathje and Saygili (2009, eq. 11) print 0.405 + 0.524 r for the standard deviation of the regression on PGA and PGV,
  which Saygili and Rathje (2008) round to 0.41 + 0.52 r;
* of that on PGA and magnitude -0.539 r^2 is -0.54 in pyGEEMs, -0.530 in Kramer and Stewart, and 0.95 replaces it in
  SLAMMER;
* of that on PGA alone -20.39 r^2 is -20.93 in pyNewmarkDisp.

One source only has the yield coefficients of Jibson's data and the least ratio of Ambraseys and Menu.
"""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from slipcircle.base.kinds import Floats

_LN_10 = math.log(10.0)
_SYMBOLS = {"ratio": "r", "k_y": "k_y", "magnitude": "M", "period": "T_s", "response": "S_a(1.5 T_s)"}
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
        Fundamental period T_s of the sliding mass, s; below 0.05 s it is rigid.
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
        return self.pga if self.spectral is None or self.is_rigid else self.spectral

    @property
    def is_rigid(self) -> bool:
        return self.period < RIGID


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
    negligible : callable, optional
        Probability of at most this.
    """

    name: str
    source: str
    ln_cm: Callable[[Shaking], Floats]
    std_ln: Callable[[Shaking], Floats]
    limits: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    least_cm: float = 0.0
    negligible: Callable[[Shaking], Floats] | None = None

    @property
    def valid(self) -> str:
        """The range in words; r < 1 goes without saying."""
        ranges = (
            f"{_SYMBOLS[measure]} {least:g} to {greatest:g}" for measure, (least, greatest) in self.limits.items()
        )
        return ", ".join(ranges)

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


def _of_polynomial(
    *coefficients: float, pga: float, pgv: float = 0.0, arias: float = 0.0, magnitude: float = 0.0
) -> Callable[[Shaking], Floats]:
    """Ln D = polynomial of r + pga ln PGA + pgv ln PGV (cm/s) + arias ln I_A + magnitude (M - 6)."""
    polynomial = np.polynomial.Polynomial(coefficients)

    def ln_cm(shaking: Shaking) -> Floats:
        displacement = polynomial(shaking.ratio) + pga * np.log(shaking.pga)
        if pgv:
            displacement += pgv * np.log(100.0 * shaking.pgv)
        if arias:
            displacement += arias * np.log(shaking.arias)
        if magnitude:
            displacement += magnitude * (shaking.magnitude - 6.0)
        return np.asarray(displacement)

    return ln_cm


def _bray_travasarou(shaking: Shaking) -> Floats:
    """Equation 5, and 6 of a rigid mass."""
    y = math.log(shaking.k_y)
    s = np.log(shaking.response)
    of_period = -0.22 if shaking.is_rigid else -1.10 + 1.50 * shaking.period
    of_slope = -2.83 * y - 0.333 * y * y
    of_shaking = 0.566 * y * s + 3.04 * s - 0.244 * s * s
    return np.asarray(of_period + of_slope + of_shaking + 0.278 * (shaking.magnitude - 7.0))


def _negligible(shaking: Shaking) -> Floats:
    """Probability of at most 1 cm by Bray and Travasarou (2007), equation 3."""
    y = math.log(shaking.k_y)
    s = np.log(shaking.response)
    period = 0.0 if shaking.is_rigid else shaking.period
    z = -1.76 - 3.22 * y - 0.484 * period * y + 3.52 * s
    return np.array([0.5 * math.erfc(x / math.sqrt(2.0)) for x in z.tolist()])


def _std(constant: float, slope: float = 0.0, square: float = 0.0) -> Callable[[Shaking], Floats]:
    """Standard deviation of ln D, constant + slope r + square r^2."""
    return lambda shaking: constant + slope * shaking.ratio + square * shaking.ratio**2


_JIBSON = {"k_y": (0.05, 0.40), "magnitude": (5.3, 7.6)}
_SAYGILI_RATHJE = {"k_y": (0.05, 0.30)}
_ASCE = "Journal of Geotechnical and Geoenvironmental Engineering"
REGRESSIONS = (
    Regression(
        "Ambraseys and Menu (1988)",
        "Earthquake Engineering and Structural Dynamics 16, 985-1006",
        _of_ratio(0.90, 2.53, -1.09),
        _std(0.30 * _LN_10),
        {"ratio": (0.1, 1.0), "magnitude": (6.6, 7.3)},
    ),
    Regression(
        "Jibson (2007), r",
        "Engineering Geology 91, 209-218, eq. 6",
        _of_ratio(0.215, 2.341, -1.438),
        _std(0.510 * _LN_10),
        _JIBSON,
    ),
    Regression(
        "Jibson (2007), I_A and r",
        "Engineering Geology 91, 209-218, eq. 10",
        _jibson_arias,
        _std(0.616 * _LN_10),
        _JIBSON,
    ),
    Regression(
        "Jibson (2007), r and M",
        "Engineering Geology 91, 209-218, eq. 7",
        _jibson_magnitude,
        _std(0.454 * _LN_10),
        _JIBSON,
    ),
    Regression(
        "Jibson (2007), I_A and k_y",
        "Engineering Geology 91, 209-218, eq. 9",
        _jibson_arias_only,
        _std(0.656 * _LN_10),
        _JIBSON,
    ),
    Regression(
        "Saygili and Rathje (2008), PGA",
        f"{_ASCE} 134, 790-803, eq. 5",
        _of_polynomial(5.52, -4.43, -20.39, 42.61, -28.74, pga=0.72),
        _std(1.13),
        _SAYGILI_RATHJE,
    ),
    Regression(
        "Saygili and Rathje (2008), PGA and PGV",
        f"{_ASCE} 134, 790-803, eq. 6",
        _of_polynomial(-1.56, -4.58, -20.84, 44.75, -30.50, pga=-0.64, pgv=1.55),
        _std(0.41, 0.52),
        _SAYGILI_RATHJE,
    ),
    Regression(
        "Saygili and Rathje (2008), PGA and I_A",
        f"{_ASCE} 134, 790-803, eq. 6",
        _of_polynomial(2.39, -5.24, -18.78, 42.01, -29.15, pga=-1.56, arias=1.38),
        _std(0.46, 0.56),
        _SAYGILI_RATHJE,
    ),
    Regression(
        "Saygili and Rathje (2008), PGA, PGV and I_A",
        f"{_ASCE} 134, 790-803, eq. 6",
        _of_polynomial(-0.74, -4.93, -19.91, 43.75, -30.12, pga=-1.30, pgv=1.04, arias=0.67),
        _std(0.20, 0.79),
        _SAYGILI_RATHJE,
    ),
    Regression(
        "Rathje and Saygili (2009), PGA and M",
        "Bulletin of the New Zealand Society for Earthquake Engineering 42, 18-27, eqs. 8 and 9",
        _of_polynomial(4.89, -4.85, -19.64, 42.49, -29.06, pga=0.72, magnitude=0.89),
        _std(0.732, 0.789, -0.539),
        _SAYGILI_RATHJE,
    ),
    Regression(
        "Bray and Travasarou (2007)",
        f"{_ASCE} 133, 381-392, eqs. 3, 5 and 6",
        _bray_travasarou,
        _std(0.66),
        {"k_y": (0.01, 0.5), "period": (0.0, 2.0), "response": (0.002, 2.7), "magnitude": (4.5, 9.0)},
        least_cm=1.0,
        negligible=_negligible,
    ),
)


class Comparison(NamedTuple):
    """Computed displacements beside a regression.

    Attributes
    ----------
    name, source, valid : str
        Valid is the range of its authors' data.
    of : int
        Records.
    records : int
        Those within its range that move; the next four numbers are of these, NaN if they are fewer than two.
    predicted : float
        Geometric mean of the displacements by the regression, m.
    mean, std : float
        Of ln of the computed over the predicted displacement.
    std_ln : float
        The regression's standard deviation of ln D, in the mean of these records.
    negligible, negligible_computed : float
        Predicted and computed shares of records within its range without a displacement, where it predicts one; NaN.
    """

    name: str
    source: str
    valid: str
    of: int
    records: int
    predicted: float = math.nan
    mean: float = math.nan
    std: float = math.nan
    std_ln: float = math.nan
    negligible: float = math.nan
    negligible_computed: float = math.nan


def comparisons(displacement: Floats, shaking: Shaking) -> list[Comparison]:
    """Displacements of a block, m, one a record, beside every regression whose measures are known."""
    rows = []
    for regression in REGRESSIONS:
        predicted = regression.ln_cm(shaking)
        if not np.all(np.isnan(predicted)):  # else it needs a measure that is not known
            rows.append(_compared(regression, 100.0 * displacement, shaking, predicted))
    return rows


def _compared(regression: Regression, displacement_cm: Floats, shaking: Shaking, predicted: Floats) -> Comparison:
    """A row; predicted is ln D of the regression."""
    inside = regression.in_range(shaking) & np.isfinite(displacement_cm)
    moves = inside & (displacement_cm > regression.least_cm)
    count = int(moves.sum())
    row = Comparison(regression.name, regression.source, regression.valid, displacement_cm.size, count)
    if regression.negligible is not None and np.any(inside):
        probability = float(regression.negligible(shaking)[inside].mean())
        row = row._replace(negligible=probability, negligible_computed=1.0 - count / int(inside.sum()))
    if count < 2:
        return row
    residuals = np.log(displacement_cm[moves]) - predicted[moves]
    median = math.exp(predicted[moves].mean()) / 100.0
    std_ln = float(regression.std_ln(shaking)[moves].mean())
    mean, std = float(residuals.mean()), float(residuals.std(ddof=1))
    return row._replace(predicted=median, mean=mean, std=std, std_ln=std_ln)
