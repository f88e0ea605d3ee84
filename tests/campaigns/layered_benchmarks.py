"""Published layered slopes: factors of safety of given circles, and least factors, beside those of a prototype.

``python -m tests.campaigns.layered_benchmarks`` prints a table: case, published, ours by Bishop's method and by the
paper's with strips, their differences from the prototype's converged values, seconds. Inputs and published values as
njones61/xslope transcribes them (benchmarks/rocscience/build_problems.py, docs/verification); the geometry of "two
clays" is from memory.
"""

import json
import math
import time
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from slipcircle import Section, Soil
from slipcircle.workbench.stability.critical import Critical, at_circle
from slipcircle.workbench.stability.search import critical
from slipcircle.workbench.stability.stability import Slope

CASES: list[dict[str, Any]] = json.loads(Path(__file__).with_suffix(".json").read_text("utf-8"))
OURS = {"bishop": "bishop", "ordinary": "ordinary", "strips": "paper"}  # by what the cases call them
WATER = {"kN, m": 9.81, "lb, ft": 62.449}  # unit weight, where a case says none


def solved(case: Mapping[str, Any]) -> Critical:
    """Return the circle of a case, or the critical one by Bishop's method, with its factors, in the case's units."""
    friction = [math.tan(math.radians(soil["angle_deg"])) for soil in case["soils"]]
    more = [{k: v for k, v in soil.items() if k != "angle_deg"} for soil in case["soils"]]
    soils = [Soil(**row, friction=mu, name=f"soil-{k}") for k, (row, mu) in enumerate(zip(more, friction, strict=True))]
    ground, *tops = case["lines"]
    slope = Slope(
        ground, layers=list(zip(soils, [None, *tops], strict=True)), surcharge=case.get("loads", ()),
        water_unit_weight=case.get("gamma_w", WATER[case["units"]]), k_h=case.get("kh", 0.0),
        **{name: case[name] for name in ("level", "base", "crack", "crack_water") if name in case},
    )  # fmt: skip
    if "circle" in case:
        return at_circle(slope, Section(ground, **case["circle"], unit_weight=1.0))
    limits = case.get("limits", {})
    window = limits.get("window")
    return critical(slope, entry=window, exit=limits.get("exits", window), depth=limits.get("least", 0.0))


def differences(case: Mapping[str, Any], found: Critical) -> dict[str, float]:
    """Our factors over the prototype's, less 1."""
    return {name: (found.factors_of_safety[ours] or np.nan) / case[name] - 1.0 for name, ours in OURS.items()}


if __name__ == "__main__":
    print(f"{'case':46} {'published':44} {'Bishop':>8} {'':>8} {'strips':>8} {'':>8} {'s':>6}")
    for case in CASES:
        start = time.perf_counter()
        found = solved(case)
        row = f"{case['name'][:44]:45}{' ' if 'circle' in case else '*'}{case['published'][:44]:45}"
        for name in ("bishop", "strips"):
            row += f" {found.factors_of_safety[OURS[name]]:8.4f} {100 * differences(case, found)[name]:+7.3f}%"
        print(f"{row} {time.perf_counter() - start:6.2f}", flush=True)
    print("* least factor by Bishop's method; the others are those of that circle")
