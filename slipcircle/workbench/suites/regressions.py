"""Published regressions of sliding-block displacements, with their standard deviations and ranges.

Each regression predicts ln D, D in cm; r is the yield coefficient over the peak acceleration.

Every coefficient and standard deviation agrees with at least two independent public sources: SLAMMER and groundfailure
of the U.S. Geological Survey, OpenQuake, OpenSRA, pyGEEMs, pyNewmarkDisp, newmark (CRAN), Kramer and Stewart
(Geotechnical Earthquake Engineering, 2nd ed.), and the spreadsheet of Bray and Travasarou, which states their range.
Results agree with worked examples in Kramer and Stewart, Rathje and others (2014), Bray (2007), Bray and Travasarou
(2007) and the spreadsheet. Where sources differ:

* Rathje and Saygili (2009, eq. 11) print 0.405 + 0.524 r for the standard deviation of the regression on PGA and PGV,
  which Saygili and Rathje (2008) round to 0.41 + 0.52 r;
* in the regression on PGA and magnitude, -0.539 r^2 is -0.54 in pyGEEMs, -0.530 in Kramer and Stewart, and replaced
  by 0.95 in SLAMMER;
* in the regression on PGA alone, -20.39 r^2 is -20.93 in pyNewmarkDisp.

The yield coefficients of Jibson's data and the least ratio of Ambraseys and Menu are from one source only.
"""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from slipcircle.base.arrays import quiet
from slipcircle.base.kinds import Flags, Floats, NumberMap, Pair

_SYMBOLS = {"ratio": "r", "k_y": "k_y", "magnitude": "M", "period": "T_s", "response": "S_a(1.5 T_s)"}
RIGID = 0.05  # s, fundamental period below which Bray and Travasarou (2007) treat a mass as rigid


@dataclass(frozen=True)
class Shaking:
    """Intensity measures of records, in arrays with one value for each record.

    Attributes
    ----------
    k_y : float
        Yield coefficient of the slope.
    pga, pgv, arias : ndarray
        Peak acceleration over gravity, peak velocity in m/s and Arias intensity in m/s.
    magnitude : float
        Moment magnitude; if unknown it is NaN, and so are regressions that need it.
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
        """Yield coefficient over the peak acceleration, r."""
        return self.k_y / self.pga

    @property
    def response(self) -> Floats:
        """Pseudo-acceleration over gravity at 1.5 T_s; for a rigid mass, the peak acceleration."""
        return self.pga if self.spectral is None or self.is_rigid else self.spectral

    @property
    def is_rigid(self) -> bool:
        """Whether the fundamental period of the mass is below `RIGID`."""
        return self.period < RIGID

    @property
    def flexible_period(self) -> float:
        """Fundamental period in s; 0 for a rigid mass."""
        return 0.0 if self.is_rigid else self.period


@dataclass(frozen=True)
class Regression:
    """A published regression of ln D on intensity measures, and its range.

    Attributes
    ----------
    name : str
    source : str
        Publication and equation of the coefficients.
    median, deviation : mapping
        Coefficients by the names of `_FEATURES`; their sums are ln D, D in cm, and the standard deviation of ln D.
    limits : mapping
        Least and greatest value of each measure in its authors' data, by the attributes of `Shaking`.
    least_cm : float
        Displacement, cm, up to which the regression counts it as zero.
    motion : mapping
        Coefficients by feature; their sum is the standard normal quantile of the probability of a larger displacement.
    """

    name: str
    source: str
    median: NumberMap
    deviation: NumberMap
    limits: Mapping[str, Pair] = field(default_factory=dict)
    least_cm: float = 0.0
    motion: NumberMap = field(default_factory=dict)

    def ln_cm(self, shaking: Shaking) -> Floats:
        """Return ln D for each record, D in cm; NaN or negative infinity where the block does not move."""
        return _sum(self.median, shaking)

    def std_ln(self, shaking: Shaking) -> Floats:
        """Return the standard deviation of ln D, as given by `ln_cm`, for each record."""
        return _sum(self.deviation, shaking)

    def negligible(self, shaking: Shaking) -> Floats:
        """Return the probability, for each record, of a displacement up to ``least_cm``; needs ``motion``."""
        return np.array([0.5 * math.erfc(z / math.sqrt(2.0)) for z in _sum(self.motion, shaking).tolist()])

    @property
    def valid(self) -> str:
        """Range of the regression in words; r < 1 always applies and is not named."""
        ranges = (
            f"{_SYMBOLS[measure]} {least:g} to {greatest:g}" for measure, (least, greatest) in self.limits.items()
        )
        return ", ".join(ranges)

    def in_range(self, shaking: Shaking) -> Flags:
        """Return whether each record is in the range, (records,); an unknown measure does not exclude a record."""
        inside = np.isfinite(self.ln_cm(shaking)) & (shaking.ratio < 1.0)
        for measure, (least, greatest) in self.limits.items():
            value = getattr(shaking, measure)
            inside &= ~np.asarray((value < least) | (value > greatest))
        return inside


# Factors of coefficients: ln 10 if a source has common logarithms; PGV in cm/s, PGA and S_a over gravity.
_FEATURES: dict[str, Callable[[Shaking], Any]] = {
    "1": lambda s: np.ones(s.pga.shape),
    "ln 10": lambda s: np.full(s.pga.shape, math.log(10.0)),
    "r": lambda s: s.ratio,
    "r^2": lambda s: s.ratio**2,
    "r^3": lambda s: s.ratio**3,
    "r^4": lambda s: s.ratio**4,
    "ln r": lambda s: np.log(s.ratio),
    "ln (1 - r)": lambda s: np.log1p(-s.ratio),
    "ln k_y": lambda s: math.log(s.k_y),
    "(ln k_y)^2": lambda s: math.log(s.k_y) ** 2,
    "ln k_y ln S_a": lambda s: math.log(s.k_y) * np.log(s.response),
    "T_s ln k_y": lambda s: s.flexible_period * math.log(s.k_y),
    "ln S_a": lambda s: np.log(s.response),
    "(ln S_a)^2": lambda s: np.log(s.response) ** 2,
    "ln PGA": lambda s: np.log(s.pga),
    "ln PGV": lambda s: np.log(100.0 * s.pgv),
    "ln I_A": lambda s: np.log(s.arias),
    "M ln 10": lambda s: s.magnitude * math.log(10.0),
    "M - 6": lambda s: s.magnitude - 6.0,
    "M - 7": lambda s: s.magnitude - 7.0,
    "rigid": lambda s: float(s.is_rigid),
    "flexible": lambda s: float(not s.is_rigid),
    "T_s": lambda s: s.flexible_period,
}


def _sum(coefficients: NumberMap, shaking: Shaking) -> Floats:
    """Return the sum of coefficients times their features, one value for each record."""
    with quiet():
        return np.asarray(sum(factor * _FEATURES[name](shaking) for name, factor in coefficients.items()))


_JIBSON = {"k_y": (0.05, 0.40), "magnitude": (5.3, 7.6)}
_SAYGILI_RATHJE = {"k_y": (0.05, 0.30)}
_ASCE = "Journal of Geotechnical and Geoenvironmental Engineering"
REGRESSIONS = (
    Regression(
        "Ambraseys and Menu (1988)",
        "Earthquake Engineering and Structural Dynamics 16, 985-1006",
        {"ln 10": 0.90, "ln (1 - r)": 2.53, "ln r": -1.09},
        {"ln 10": 0.30},
        {"ratio": (0.1, 1.0), "magnitude": (6.6, 7.3)},
    ),
    Regression(
        "Jibson (2007), r",
        "Engineering Geology 91, 209-218, eq. 6",
        {"ln 10": 0.215, "ln (1 - r)": 2.341, "ln r": -1.438},
        {"ln 10": 0.510},
        _JIBSON,
    ),
    Regression(
        "Jibson (2007), I_A and r",
        "Engineering Geology 91, 209-218, eq. 10",
        {"ln 10": -1.474, "ln I_A": 0.561, "ln r": -3.833},
        {"ln 10": 0.616},
        _JIBSON,
    ),
    Regression(
        "Jibson (2007), r and M",
        "Engineering Geology 91, 209-218, eq. 7",
        {"ln 10": -2.710, "M ln 10": 0.424, "ln (1 - r)": 2.335, "ln r": -1.478},
        {"ln 10": 0.454},
        _JIBSON,
    ),
    Regression(
        "Jibson (2007), I_A and k_y",
        "Engineering Geology 91, 209-218, eq. 9",
        {"ln 10": -3.230, "ln I_A": 2.401, "ln k_y": -3.481},
        {"ln 10": 0.656},
        _JIBSON,
    ),
    Regression(
        "Saygili and Rathje (2008), PGA",
        f"{_ASCE} 134, 790-803, eq. 5",
        {"1": 5.52, "r": -4.43, "r^2": -20.39, "r^3": 42.61, "r^4": -28.74, "ln PGA": 0.72},
        {"1": 1.13},
        _SAYGILI_RATHJE,
    ),
    Regression(
        "Saygili and Rathje (2008), PGA and PGV",
        f"{_ASCE} 134, 790-803, eq. 6",
        {"1": -1.56, "r": -4.58, "r^2": -20.84, "r^3": 44.75, "r^4": -30.50, "ln PGA": -0.64, "ln PGV": 1.55},
        {"1": 0.41, "r": 0.52},
        _SAYGILI_RATHJE,
    ),
    Regression(
        "Saygili and Rathje (2008), PGA and I_A",
        f"{_ASCE} 134, 790-803, eq. 6",
        {"1": 2.39, "r": -5.24, "r^2": -18.78, "r^3": 42.01, "r^4": -29.15, "ln PGA": -1.56, "ln I_A": 1.38},
        {"1": 0.46, "r": 0.56},
        _SAYGILI_RATHJE,
    ),
    Regression(
        "Saygili and Rathje (2008), PGA, PGV and I_A",
        f"{_ASCE} 134, 790-803, eq. 6",
        {
            "1": -0.74,
            "r": -4.93,
            "r^2": -19.91,
            "r^3": 43.75,
            "r^4": -30.12,
            "ln PGA": -1.30,
            "ln PGV": 1.04,
            "ln I_A": 0.67,
        },
        {"1": 0.20, "r": 0.79},
        _SAYGILI_RATHJE,
    ),
    Regression(
        "Rathje and Saygili (2009), PGA and M",
        "Bulletin of the New Zealand Society for Earthquake Engineering 42, 18-27, eqs. 8 and 9",
        {"1": 4.89, "r": -4.85, "r^2": -19.64, "r^3": 42.49, "r^4": -29.06, "ln PGA": 0.72, "M - 6": 0.89},
        {"1": 0.732, "r": 0.789, "r^2": -0.539},
        _SAYGILI_RATHJE,
    ),
    Regression(
        "Bray and Travasarou (2007)",
        f"{_ASCE} 133, 381-392, eqs. 3, 5 and 6",
        {
            "rigid": -0.22,
            "flexible": -1.10,
            "T_s": 1.50,
            "ln k_y": -2.83,
            "(ln k_y)^2": -0.333,
            "ln k_y ln S_a": 0.566,
            "ln S_a": 3.04,
            "(ln S_a)^2": -0.244,
            "M - 7": 0.278,
        },
        {"1": 0.66},
        {"k_y": (0.01, 0.5), "period": (0.0, 2.0), "response": (0.002, 2.7), "magnitude": (4.5, 9.0)},
        least_cm=1.0,
        motion={"1": -1.76, "ln k_y": -3.22, "T_s ln k_y": -0.484, "ln S_a": 3.52},
    ),
)


class Comparison(NamedTuple):
    """Comparison of computed displacements with a regression.

    Attributes
    ----------
    name, source, valid : str
        Name and source of the regression, and the range of its authors' data.
    of : int
        Number of records.
    records : int
        Number of records in the range that move the block; the next four values refer to them, NaN for fewer than 2.
    predicted : float
        Geometric mean of the displacements by the regression, m.
    mean, std : float
        Mean and standard deviation of the logarithm of the computed over the predicted displacement.
    std_ln : float
        Published standard deviation of ln D, averaged over these records.
    negligible, negligible_computed : float
        Predicted and computed shares of records in the range with a negligible displacement; NaN if not predicted.
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
    """Return a comparison for each regression with known measures; ``displacement`` in m, by record."""
    rows = []
    for regression in REGRESSIONS:
        predicted = regression.ln_cm(shaking)
        if not np.all(np.isnan(predicted)):  # otherwise a measure is unknown
            rows.append(_compared(regression, 100.0 * displacement, shaking, predicted))
    return rows


def _compared(regression: Regression, displacement_cm: Floats, shaking: Shaking, predicted: Floats) -> Comparison:
    """Return the comparison of computed displacements in cm with a regression.

    ``predicted`` is ln D by the regression, D in cm; both arrays have one value for each record.
    """
    inside = regression.in_range(shaking) & np.isfinite(displacement_cm)
    moves = inside & (displacement_cm > regression.least_cm)
    count = int(moves.sum())
    row = Comparison(regression.name, regression.source, regression.valid, displacement_cm.size, count)
    if regression.motion and np.any(inside):
        probability = float(regression.negligible(shaking)[inside].mean())
        row = row._replace(negligible=probability, negligible_computed=1.0 - count / int(inside.sum()))
    if count < 2:
        return row
    residuals = np.log(displacement_cm[moves]) - predicted[moves]
    median = math.exp(predicted[moves].mean()) / 100.0
    std_ln = float(regression.std_ln(shaking)[moves].mean())
    mean, std = float(residuals.mean()), float(residuals.std(ddof=1))
    return row._replace(predicted=median, mean=mean, std=std, std_ln=std_ln)
