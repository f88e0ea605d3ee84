"""Factors of safety of samples, with the critical circle searched for each sample."""

from contextlib import suppress
from dataclasses import replace
from typing import Any

import numpy as np

from slipcircle.base.inputerror import InputError
from slipcircle.base.kinds import ArrayDict, ArrayMap, Flags, Texts
from slipcircle.core import Scene
from slipcircle.derivatives import with_parameters
from slipcircle.workbench.files.loaded import stability_of
from slipcircle.workbench.files.variation import varied_slope
from slipcircle.workbench.stability.condensed import least
from slipcircle.workbench.stability.critical import SlopeScene
from slipcircle.workbench.stability.factors import circle_factors
from slipcircle.workbench.stability.family import Search
from slipcircle.workbench.stability.stability import METHODS
from slipcircle.workbench.stability.starting import OF_CLOSURE

SEARCHED = "searched "  # prefix of a method's name: the circle is searched for every sample


def searched_factors(scene: Scene, si: ArrayMap, valid: Flags) -> ArrayDict:
    """Return factors of safety by `SEARCHED` and method, (samples,) each, NaN where not ``valid``.

    ``si`` are the values of the inputs by name in SI units, (samples,) each.
    """
    stability = stability_of(scene)
    assert isinstance(scene, SlopeScene)
    assert stability is not None
    scene = replace(scene, start=OF_CLOSURE)  # no motion starts here
    factors = {method: np.full(len(valid), np.nan) for method in METHODS}
    for k in np.flatnonzero(valid):
        numbers = {name: float(values[k]) for name, values in si.items()}
        slope = varied_slope(with_parameters(scene, numbers), stability.slope)
        search = Search(slope, stability.method, **stability.limits)
        with suppress(InputError):  # no circle within the limits can slide
            by_method = circle_factors(search.arrays, search.circles(least(search, lambda _: None)[:1]))
            for method in METHODS:
                factors[method][k] = by_method[method][0]
    return {f"{SEARCHED}{method}": values for method, values in factors.items()}


def search_mistakes(scene: Any) -> Texts:
    """Return a message, in a list, if the scene does not search for its critical circle; otherwise an empty list."""
    stability = stability_of(scene)
    if stability is not None and stability.method:
        return []
    return ['search_each: the scene does not search for a circle; give [ground] and critical = "bishop" in [circle]']


def effect_of_searching(study: Any, method: str) -> str:
    """Return a text on how searching the circle of every sample changes the factors of safety by a method."""
    method = method if method in METHODS else "paper"
    both = (method, f"{SEARCHED}{method}")
    below, below_searched = (f"{study.failure[name].value:.3g}" for name in both)
    median, median_searched = (f"{study.factor_quantile(name, 0.5).value:.4g}" for name in both)
    of_means = f"on the circle of the means P(F < 1) by {method} is {below} and the median factor {median}"
    return f"{of_means}; with the circle searched for every sample {below_searched} and {median_searched}"
