"""Distributions of scene files: those of SciPy, by the parameters that engineers use."""

import math
from collections.abc import Callable, Mapping
from difflib import get_close_matches
from typing import Any, NamedTuple

from slipcircle.base.checks import shown
from slipcircle.base.optional import optional

_FAR = 30.0  # standard deviations, beyond which the probability is zero in float64


def statistics() -> Any:
    """SciPy's distributions, loaded on first use."""
    return optional("scipy.stats", "distributions")


def special() -> Any:
    """Return SciPy's special functions, which load in a tenth of the time of its distributions."""
    return optional("scipy.special", "intervals")


class Distribution(NamedTuple):
    """A distribution: its parameters, all required, a function that freezes SciPy's, and conditions."""

    help: str
    parameters: tuple[str, ...]
    frozen: Callable[..., Any]
    rules: Mapping[str, Callable[[Mapping[str, float]], bool]]


def _lognormal(mean: float, std: float) -> Any:
    """Log-normal by the moments of the number: its logarithm has the variance log(1 + (std/mean)^2)."""
    variance = math.log1p((std / mean) ** 2)
    return statistics().lognorm(math.sqrt(variance), scale=mean * math.exp(-variance / 2))


def _truncated(mean: float, std: float, low: float, high: float) -> Any:
    return statistics().truncnorm((low - mean) / std, (high - mean) / std, mean, std)


_SPREAD = {"std must be above 0": lambda g: g["std"] > 0.0}
_ORDER = {"high must be above low": lambda g: g["high"] > g["low"]}
DISTRIBUTIONS: Mapping[str, Distribution] = {
    "normal": Distribution("Gaussian", ("mean", "std"), lambda mean, std: statistics().norm(mean, std), _SPREAD),
    "lognormal": Distribution(
        "its logarithm is normal; mean and std are the number's own",
        ("mean", "std"),
        _lognormal,
        _SPREAD | {"mean must be above 0": lambda g: g["mean"] > 0.0},
    ),
    "uniform": Distribution("", ("low", "high"), lambda low, high: statistics().uniform(low, high - low), _ORDER),
    "triangular": Distribution(
        "",
        ("low", "mode", "high"),
        lambda low, mode, high: statistics().triang((mode - low) / (high - low), low, high - low),
        _ORDER | {"mode must be from low to high": lambda g: g["low"] <= g["mode"] <= g["high"]},
    ),
    "truncated_normal": Distribution(
        "normal between low and high; mean and std are those before truncation",
        ("mean", "std", "low", "high"),
        _truncated,
        _SPREAD
        | _ORDER
        | {
            f"low and high must hold values within {_FAR:g} std of the mean": lambda g: (
                g["low"] < g["mean"] + _FAR * g["std"] and g["high"] > g["mean"] - _FAR * g["std"]
            )
        },
    ),
}


def distribution_of(given: Mapping[str, Any]) -> Any:
    """SciPy's frozen distribution of a mapping such as ``{"distribution": "normal", "mean": 10, "std": 1}``."""
    numbers = {k: float(v) for k, v in given.items() if k != "distribution"}
    return DISTRIBUTIONS[given["distribution"]].frozen(**numbers)


def described(frozen: Any) -> dict[str, Any]:
    """Return SciPy's expression for a distribution; for one without a name, its class, moments and quantiles."""
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


def distribution_mistakes(given: Mapping[str, Any], limits: tuple[float, float]) -> list[str]:
    """A sentence for each mistake in a distribution whose numbers should stay within limits."""
    name = given.get("distribution")
    if name is None:
        return ["distribution: is missing: one of " + ", ".join(DISTRIBUTIONS)]
    if name not in DISTRIBUTIONS:
        asked = "".join(f"; did you mean {n}?" for n in get_close_matches(str(name), DISTRIBUTIONS, 1))
        return [f"distribution = {name!r}: must be one of {', '.join(DISTRIBUTIONS)}{asked}"]
    kind, numbers = DISTRIBUTIONS[name], {k: v for k, v in given.items() if k != "distribution"}
    known = kind.parameters
    faults = [f"{k}: is missing" for k in known if k not in numbers]
    faults += [f"{k}: is unknown; known are {', '.join(known)}" for k in numbers if k not in known]
    for k in known:
        value = numbers.get(k, 0.0)
        if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
            faults.append(f"{k} = {shown(value)}: must be a finite number")
    faults = faults or [rule for rule, holds in kind.rules.items() if not holds(numbers)]
    return faults or _limit_mistakes(distribution_of(given), *limits)


def _limit_mistakes(distribution: Any, lower: float, upper: float) -> list[str]:
    """Mistakes where a distribution exceeds the limits of its number.

    The tails of a normal distribution are ignored: samples out of bounds are counted instead.
    """
    low, high = map(float, distribution.support())
    least = min(lower, 0.0) if lower < 1.0 else lower
    faults = []
    if math.isfinite(low) and low < least:
        faults.append(f"reaches down to {low:g}, and must stay above {least:g}")
    if math.isfinite(high) and high > upper:
        faults.append(f"reaches up to {high:g}, and must stay below {upper:g}")
    middle = float(distribution.median())
    if not faults and not lower <= middle <= upper:
        faults.append(f"its median {middle:g} must be between {lower:g} and {upper:g}")
    return faults
