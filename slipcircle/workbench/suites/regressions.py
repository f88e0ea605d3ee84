"""Published regressions of the displacement of rigid sliding blocks, with their standard deviations and ranges.

All give the natural logarithm of a displacement in cm; r is the yield coefficient over the peak acceleration.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
_LN_10 = math.log(10.0)


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
    """

    k_y: float
    pga: Floats
    pgv: Floats
    arias: Floats
    magnitude: float = math.nan

    @property
    def ratio(self) -> Floats:
        return self.k_y / self.pga


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
    least, greatest : float
        Range of r: that of its authors, or where they give none, 0.05 to 0.95; outside it says nothing.
    """

    name: str
    source: str
    ln_cm: Callable[[Shaking], Floats]
    std_ln: Callable[[Shaking], Floats]
    least: float = 0.05
    greatest: float = 0.95

    def in_range(self, shaking: Shaking) -> NDArray[np.bool_]:
        """Which records lie within its range."""
        inside = (shaking.ratio >= self.least) & (shaking.ratio <= self.greatest)
        return np.asarray(inside & np.isfinite(self.ln_cm(shaking)))


def _of_ratio(constant: float, one: float, other: float) -> Callable[[Shaking], Floats]:
    """Log10 D = constant + log10[(1 - r)^one r^other]."""

    def ln_cm(shaking: Shaking) -> Floats:
        r = shaking.ratio
        with np.errstate(invalid="ignore", divide="ignore"):
            return np.asarray(_LN_10 * constant + one * np.log1p(-r) + other * np.log(r))

    return ln_cm


def _jibson_arias(shaking: Shaking) -> Floats:
    log_arias, log_ratio = np.log10(shaking.arias), np.log10(shaking.ratio)
    return np.asarray(_LN_10 * (0.561 * log_arias - 3.833 * log_ratio - 1.474))


def _jibson_magnitude(shaking: Shaking) -> Floats:
    of_ratio = _of_ratio(-2.710, 2.335, -1.478)
    return of_ratio(shaking) + _LN_10 * 0.424 * shaking.magnitude


def _jibson_arias_only(shaking: Shaking) -> Floats:
    log_arias, log_yield = np.log10(shaking.arias), math.log10(shaking.k_y)
    return np.asarray(_LN_10 * (2.401 * log_arias - 3.481 * log_yield - 3.230))


def _saygili_rathje(shaking: Shaking) -> Floats:
    shape = np.polynomial.Polynomial((-1.56, -4.58, -20.84, 44.75, -30.50))
    velocity_cm = 100.0 * shaking.pgv
    return np.asarray(shape(shaking.ratio) - 0.64 * np.log(shaking.pga) + 1.55 * np.log(velocity_cm))


def _saygili_rathje_arias(shaking: Shaking) -> Floats:
    shape = np.polynomial.Polynomial((-0.74, -4.93, -19.91, 43.75, -30.12))
    of_peaks = -1.30 * np.log(shaking.pga) + 1.04 * np.log(100.0 * shaking.pgv)
    return np.asarray(shape(shaking.ratio) + of_peaks + 0.67 * np.log(shaking.arias))


def _rathje_saygili(shaking: Shaking) -> Floats:
    shape = np.polynomial.Polynomial((4.89, -4.85, -19.64, 42.49, -29.06))
    return np.asarray(shape(shaking.ratio) + 0.72 * np.log(shaking.pga) + 0.89 * (shaking.magnitude - 6.0))


def _bray_travasarou(shaking: Shaking) -> Floats:
    """Of a rigid mass, whose spectral acceleration is the peak acceleration."""
    y, s = math.log(shaking.k_y), np.log(shaking.pga)
    of_slope = -0.22 - 2.83 * y - 0.333 * y * y
    of_shaking = 0.566 * y * s + 3.04 * s - 0.244 * s * s
    return np.asarray(of_slope + of_shaking + 0.278 * (shaking.magnitude - 7.0))


def _constant(std: float) -> Callable[[Shaking], Floats]:
    return lambda shaking: np.full_like(shaking.pga, std)


REGRESSIONS = (
    Regression(
        "Ambraseys and Menu (1988)",
        "Earthquake Engineering and Structural Dynamics 16, 985-1006",
        _of_ratio(0.90, 2.53, -1.09),
        _constant(0.30 * _LN_10),
        0.1,
        0.9,
    ),
    Regression(
        "Jibson (2007), r",
        "Engineering Geology 91, 209-218, eq. 6",
        _of_ratio(0.215, 2.341, -1.438),
        _constant(0.510 * _LN_10),
    ),
    Regression(
        "Jibson (2007), Arias intensity and r",
        "Engineering Geology 91, 209-218, eq. 10",
        _jibson_arias,
        _constant(0.616 * _LN_10),
    ),
    Regression(
        "Jibson (2007), r and magnitude",
        "Engineering Geology 91, 209-218, eq. 7",
        _jibson_magnitude,
        _constant(0.454 * _LN_10),
    ),
    Regression(
        "Jibson (2007), Arias intensity and k_y",
        "Engineering Geology 91, 209-218, eq. 9",
        _jibson_arias_only,
        _constant(0.656 * _LN_10),
    ),
    Regression(
        "Saygili and Rathje (2008), PGA and PGV",
        "Journal of Geotechnical and Geoenvironmental Engineering 134, 790-803",
        _saygili_rathje,
        lambda shaking: 0.41 + 0.52 * shaking.ratio,
    ),
    Regression(
        "Saygili and Rathje (2008), PGA, PGV and Arias intensity",
        "Journal of Geotechnical and Geoenvironmental Engineering 134, 790-803",
        _saygili_rathje_arias,
        lambda shaking: 0.20 + 0.79 * shaking.ratio,
    ),
    Regression(
        "Rathje and Saygili (2009), PGA and magnitude",
        "Bulletin of the New Zealand Society for Earthquake Engineering 42, 18-27",
        _rathje_saygili,
        lambda shaking: 0.732 + 0.789 * shaking.ratio - 0.539 * shaking.ratio**2,
    ),
    Regression(
        "Bray and Travasarou (2007), rigid",
        "Journal of Geotechnical and Geoenvironmental Engineering 133, 381-392",
        _bray_travasarou,
        _constant(0.66),
    ),
)


class Comparison(NamedTuple):
    """Computed displacements beside a regression.

    Attributes
    ----------
    name, source : str
    records : int
        Records within its range that move.
    mean, std : float
        Of ln of the computed over the predicted displacement; NaN if too few records are within the range.
    std_ln : float
        The regression's standard deviation of ln D, in the mean of these records.
    """

    name: str
    source: str
    records: int
    mean: float
    std: float
    std_ln: float


def comparisons(displacement: Floats, shaking: Shaking) -> list[Comparison]:
    """Displacements of a rigid block, m, one a record, beside every regression that has what it needs."""
    found = []
    for regression in REGRESSIONS:
        inside = regression.in_range(shaking) & (displacement > 0.0) & np.isfinite(displacement)
        count = int(inside.sum())
        if count > 1:
            logs = np.log(100.0 * displacement[inside]) - regression.ln_cm(shaking)[inside]
            mean, std = float(logs.mean()), float(logs.std(ddof=1))
            std_ln = float(regression.std_ln(shaking)[inside].mean())
            found.append(Comparison(regression.name, regression.source, count, mean, std, std_ln))
    return found
