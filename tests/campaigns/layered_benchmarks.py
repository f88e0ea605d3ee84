"""Published layered slopes: factors of safety of given circles, and least factors, beside those of a prototype.

``python -m tests.campaigns.layered_benchmarks [NAME ...]`` prints a table: case, published, ours by Bishop's method and
by the paper's with strips, their differences from the prototype's converged values, seconds. Inputs and published
values as njones61/xslope transcribes them (benchmarks/rocscience/build_problems.py, docs/verification), in their own
units, which are consistent; the geometry of "two clays" is from memory.
"""

import json
import sys
import time
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from slipcircle.core import Section, Soil
from slipcircle.workbench.stability.search import Critical, at_circle, critical
from slipcircle.workbench.stability.stability import Slope

CASES: list[dict[str, Any]] = json.loads(Path(__file__).with_suffix(".json").read_text("utf-8"))
OURS = {"bishop": "bishop", "ordinary": "ordinary", "strips": "paper"}  # by what the cases call them


def slope_of(case: Mapping[str, Any]) -> Slope:
    """The slope of a case."""
    soils = []
    for k, given in enumerate(case["soils"]):
        numbers = {"cohesion_gradient": given.get("cohesion_gradient", 0.0), "datum": given.get("datum")}
        friction = float(np.tan(np.deg2rad(given["angle_deg"])))
        ratio = given.get("pore_ratio", 0.0)
        soils.append(
            Soil(given["unit_weight"], given["cohesion"], friction, pore_ratio=ratio, name=f"soil {k + 1}", **numbers)
        )
    ground, *tops = case["lines"]
    return Slope(
        ground,
        layers=list(zip(soils, [None, *tops], strict=True)),
        level=case.get("level"),
        water_unit_weight=case.get("gamma_w", 9.81),
        k_h=case.get("kh", 0.0),
        base=case.get("base"),
        pond=case.get("pond"),
        surcharge=case.get("loads", ()),
        crack=case.get("crack", 0.0),
        crack_water=case.get("crack_water", 0.0),
    )


def solved(case: Mapping[str, Any]) -> Critical:
    """The factors of a case's circle, or of the circle of the least factor by Bishop's method."""
    slope = slope_of(case)
    if circle := case.get("circle"):
        between = tuple(circle["between"])
        return at_circle(slope, Section(slope.ground, circle["centre"], circle["radius"], 1.0, between=between))
    limits = case.get("limits", {})
    window = limits.get("window")
    return critical(slope, entry=window, exit=limits.get("exits", window), depth=float(limits.get("least", 0.0)))


def differences(case: Mapping[str, Any], found: Critical) -> dict[str, float]:
    """Our factors over the prototype's, less 1."""
    return {name: (found.factor_of_safety[ours] or np.nan) / case[name] - 1.0 for name, ours in OURS.items()}


def main(names: list[str]) -> None:
    """Print the table."""
    print(f"{'case':46} {'published':44} {'Bishop':>8} {'':>8} {'strips':>8} {'':>8} {'s':>6}")
    for case in CASES:
        if names and not any(name in case["name"] for name in names):
            continue
        start = time.perf_counter()
        found = solved(case)
        seconds = time.perf_counter() - start
        by = differences(case, found)
        shown = [f"{found.factor_of_safety[OURS[n]]:8.4f} {100 * by[n]:+7.3f}%" for n in ("bishop", "strips")]
        kind = " " if "circle" in case else "*"
        print(f"{case['name'][:44]:45}{kind}{case['published'][:44]:45}{' '.join(shown)} {seconds:6.2f}", flush=True)
    print("* least factor by Bishop's method; the others are those of that circle")


if __name__ == "__main__":
    main(sys.argv[1:])
