"""Distributions of scene files, defined by the parameters that engineers use."""

import math
from collections.abc import Callable, Mapping
from difflib import get_close_matches
from typing import Any, NamedTuple

import numpy as np

from slipcircle.base.bounds import abridged
from slipcircle.base.kinds import Names, NumberMap, Pair, Texts, ValueDict, Values
from slipcircle.base.optional import optional

_FAR = 30.0  # standard deviations, beyond which the probability is zero in float64


def statistics() -> Any:
    """Return the module scipy.stats, whose import takes half a second."""
    return optional("scipy.stats", "distributions")


def special() -> Any:
    """Return the module scipy.special, loaded on first use."""
    return optional("scipy.special", "distributions")


class Gaussian(NamedTuple):
    """Normal or log-normal distribution with the methods of SciPy's distributions that studies use."""

    moments: Pair
    shape: float = 0.0  # standard deviation of the logarithm, 0 for a normal distribution
    scale: float = 1.0  # median of a log-normal distribution

    def ppf(self, p: Any) -> Any:
        """Return the quantiles at probabilities ``p``."""
        score = special().ndtri(p)
        mean, std = self.moments
        return np.exp(self.shape * score) * self.scale if self.shape else score * std + mean

    def cdf(self, x: float) -> Any:
        """Return the probability of a value less than or equal to ``x``."""
        mean, std = self.moments
        if not self.shape:
            return special().ndtr((x - mean) / std)
        return special().ndtr(math.log(x / self.scale) / self.shape) if x > 0.0 else 0.0

    def support(self) -> Pair:
        """Return the least and the greatest possible value, which may be infinite."""
        return 0.0 if self.shape else -math.inf, math.inf


class Triangle(NamedTuple):
    """Triangular distribution, or a uniform distribution if ``mode`` is None."""

    low: float
    high: float
    mode: float | None = None

    @property
    def moments(self) -> Pair:
        """Mean and standard deviation."""
        low, high, mode = self
        if mode is None:
            return (low + high) / 2, (high - low) / math.sqrt(12.0)
        return (low + mode + high) / 3, math.sqrt(((high - low) ** 2 + (mode - low) * (mode - high)) / 18)

    def ppf(self, p: Any) -> Any:
        """Return the quantiles at probabilities ``p``."""
        low, high, mode = self
        share = p
        if mode is not None:
            peak = (mode - low) / (high - low)
            share = np.where(p < peak, np.sqrt(peak * p), 1.0 - np.sqrt((1.0 - peak) * (1.0 - p)))
        return share * (high - low) + low

    def cdf(self, x: float) -> float:
        """Return the probability of a value less than or equal to ``x``."""
        low, high, mode = self
        share = min(max((x - low) / (high - low), 0.0), 1.0)
        if mode is None:
            return share
        peak = (mode - low) / (high - low)
        return share**2 / peak if share < peak else 1.0 - (1.0 - share) ** 2 / (1.0 - peak or 1.0)

    def support(self) -> Pair:
        """Return the least and the greatest possible value."""
        return self.low, self.high


class Distribution(NamedTuple):
    """Kind of distribution in scene files: required parameters, constructor, and conditions on the parameters."""

    help: str
    parameters: Names
    frozen: Callable[..., Any]
    rules: Mapping[str, Callable[[NumberMap], bool]]


def _lognormal(mean: float, std: float) -> Gaussian:
    """Return the log-normal distribution with this mean and standard deviation.

    The variance of its logarithm is log(1 + (std/mean)^2).
    """
    variance = math.log1p((std / mean) ** 2)
    return Gaussian((mean, std), math.sqrt(variance), mean * math.exp(-variance / 2))


def _truncated(mean: float, std: float, low: float, high: float) -> Any:
    """Return SciPy's normal distribution truncated to [low, high], by mean and deviation before truncation."""
    return statistics().truncnorm((low - mean) / std, (high - mean) / std, mean, std)


_SPREAD = {"std must be above 0": lambda g: g["std"] > 0.0}
_ORDER = {"high must be above low": lambda g: g["high"] > g["low"]}
DISTRIBUTIONS: Mapping[str, Distribution] = {
    "normal": Distribution("Gaussian", ("mean", "std"), lambda mean, std: Gaussian((mean, std)), _SPREAD),
    "lognormal": Distribution(
        "its logarithm is normal; mean and std are the number's own",
        ("mean", "std"),
        _lognormal,
        _SPREAD | {"mean must be above 0": lambda g: g["mean"] > 0.0},
    ),
    "uniform": Distribution("", ("low", "high"), Triangle, _ORDER),
    "triangular": Distribution(
        "",
        ("low", "mode", "high"),
        Triangle,
        _ORDER | {"mode must be from low to high": lambda g: g["low"] <= g["mode"] <= g["high"]},
    ),
    "truncated_normal": Distribution(
        "normal between low and high; mean and std before truncation",
        ("mean", "std", "low", "high"),
        _truncated,
        _SPREAD
        | _ORDER
        | {
            f"low and high must include values within {_FAR:g} std of the mean": lambda g: (
                g["low"] < g["mean"] + _FAR * g["std"] and g["high"] > g["mean"] - _FAR * g["std"]
            )
        },
    ),
}


def distribution_of(parameters: Values) -> Any:
    """Return the distribution for a mapping such as ``{"distribution": "normal", "mean": 10, "std": 1}``."""
    numbers = {k: float(v) for k, v in parameters.items() if k != "distribution"}
    return DISTRIBUTIONS[parameters["distribution"]].frozen(**numbers)


def distribution_record(frozen: Any) -> ValueDict:
    """Return a frozen distribution as values of JSON: its SciPy expression, or its class, moments and quantiles."""
    name = str(getattr(getattr(frozen, "dist", None), "name", ""))
    standard = getattr(statistics(), name, None)
    if name and type(standard) is type(frozen.dist):
        named = [f"{key}={float(value)!r}" for key, value in sorted(frozen.kwds.items())]
        parameters = ", ".join([*map(repr, map(float, frozen.args)), *named])
        return {"distribution": f"scipy.stats.{name}({parameters})"}
    if hasattr(frozen, "icdf"):
        return {"distribution": repr(frozen)}
    quantiles = {f"quantile_{p}": float(frozen.ppf(p)) for p in (0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99)}
    moments = {"mean": float(frozen.mean()), "std": float(frozen.std())}
    return {"distribution": type(getattr(frozen, "dist", frozen)).__name__} | moments | quantiles


def distribution_mistakes(parameters: Values, limits: Pair) -> Texts:
    """Return a message for each mistake in the mapping of a distribution.

    ``limits`` are the least and greatest value of its number, in the same unit.
    """
    name = parameters.get("distribution")
    if name is None:
        return ["distribution: is missing: one of " + ", ".join(DISTRIBUTIONS)]
    if name not in DISTRIBUTIONS:
        suggestion = "".join(f"; did you mean {n}?" for n in get_close_matches(str(name), DISTRIBUTIONS, 1))
        return [f"distribution = {name!r}: must be one of {', '.join(DISTRIBUTIONS)}{suggestion}"]
    kind, numbers = DISTRIBUTIONS[name], {k: v for k, v in parameters.items() if k != "distribution"}
    names = kind.parameters
    faults = [f"{k}: is missing" for k in names if k not in numbers]
    faults += [f"{k}: is unknown; known are {', '.join(names)}" for k in numbers if k not in names]
    for k in names:
        value = numbers.get(k, 0.0)
        if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
            faults.append(f"{k} = {abridged(value)}: must be a finite number")
    faults = faults or [rule for rule, holds in kind.rules.items() if not holds(numbers)]
    return faults or _limit_mistakes(distribution_of(parameters), *limits)


def _limit_mistakes(distribution: Any, lower: float, upper: float) -> Texts:
    """Return a message for each limit of its number, ``lower`` or ``upper``, that a distribution exceeds.

    The tails of a normal distribution are ignored: samples out of bounds are counted when they are drawn.
    """
    low, high = map(float, distribution.support())
    least = min(lower, 0.0) if lower < 1.0 else lower
    faults = []
    if math.isfinite(low) and low < least:
        faults.append(f"reaches down to {low:g}, and must stay above {least:g}")
    if math.isfinite(high) and high > upper:
        faults.append(f"reaches up to {high:g}, and must stay below {upper:g}")
    middle = float(distribution.ppf(0.5))
    if not faults and not lower <= middle <= upper:
        faults.append(f"its median {middle:g} must be between {lower:g} and {upper:g}")
    return faults
