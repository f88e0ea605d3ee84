"""Published layered slopes: factors of safety of given circles, and least factors, beside those of a prototype.

``python -m tests.campaigns.layered_benchmarks [NAME ...]`` writes each case as a scene file, searches it as `slipcircle
search` does, and prints a table: case, published, ours by Bishop's method and by the paper's with strips, their
differences from the prototype's converged values, seconds. Inputs and published values as njones61/xslope transcribes
them (benchmarks/rocscience/build_problems.py, docs/verification); the geometry of "two clays" is from memory.
"""

import json
import sys
import tempfile
import time
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from slipcircle.workbench.files.scenefile import critical_of_file
from slipcircle.workbench.stability.search import Critical

CASES: list[dict[str, Any]] = json.loads(Path(__file__).with_suffix(".json").read_text("utf-8"))
OURS = {"bishop": "bishop", "ordinary": "ordinary", "strips": "paper"}  # by what the cases call them
FOOT, POUND = 0.3048, 4.4482216152605e-3  # m, kN
UNITS = {"kN, m": (1.0, 1.0), "lb, ft": (FOOT, POUND)}


def scene_text(case: Mapping[str, Any]) -> str:
    """A case as a scene file, in kN and m."""
    return "\n".join([*_ground(case), *_soils(case), *_loads(case), *_circle(case)])


def _scaled(case: Mapping[str, Any]) -> tuple[Any, float, float]:
    """Lengths of a case in m, from numbers or lists of them; its unit of weight and its unit of stress."""
    metre, newton = UNITS[case["units"]]
    return (lambda lengths: (np.asarray(lengths) * metre).tolist()), newton / metre**3, newton / metre**2


def _ground(case: Mapping[str, Any]) -> Iterator[str]:
    metres, weight, _ = _scaled(case)
    yield f"[ground]\npoints_m = {metres(case['lines'][0])}"
    if "base" in case:
        yield f"base_m = {metres(case['base'])}"
    yield "[water]"
    if "gamma_w" in case:
        yield f"unit_weight_kN_m3 = {case['gamma_w'] * weight}"
    if "level" in case:
        yield f"level_m = {metres(case['level'])}"
    if "pond" in case:
        yield f"[pond]\nlevel_m = {metres(case['pond'])}"


def _soils(case: Mapping[str, Any]) -> Iterator[str]:
    metres, weight, stress = _scaled(case)
    for k, soil in enumerate(case["soils"], 1):
        yield f"[soils.soil-{k}]\nunit_weight_kN_m3 = {soil['unit_weight'] * weight}"
        yield f"cohesion_kPa = {soil['cohesion'] * stress}\nfriction = {{ angle_deg = {soil['angle_deg']} }}"
        yield f"pore_pressure_ratio = {soil.get('pore_ratio', 0.0)}"
        if "cohesion_gradient" in soil:
            yield f"cohesion_per_m_kPa = {soil['cohesion_gradient'] * weight}\ndatum_m = {metres(soil['datum'])}"
    for k, line in enumerate(case["lines"], 1):
        yield f"[[layers]]\nsoil = 'soil-{k}'" + (f"\ntop_m = {metres(line)}" if k > 1 else "")


def _loads(case: Mapping[str, Any]) -> Iterator[str]:
    metres, _, stress = _scaled(case)
    for left, right, *pressure in case.get("loads", ()):
        kilopascals = [q * stress for q in pressure]
        yield f"[[surcharge]]\nfrom_m = {metres(left)}\nto_m = {metres(right)}\npressure_kPa = {kilopascals}"
    if "crack" in case:
        yield f"[tension_crack]\ndepth_m = {metres(case['crack'])}\nwater_m = {metres(case.get('crack_water', 0.0))}"


def _circle(case: Mapping[str, Any]) -> Iterator[str]:
    metres, *_ = _scaled(case)
    limits = case.get("limits", {})
    window = limits.get("window")
    exits = limits.get("exits", window)
    yield f"[search]\nk_h = {case.get('kh', 0.0)}\ndepth_m = {metres(limits.get('least', 0.0))}"
    for key, pair in {"entry_m": window, "exit_m": exits}.items():
        if pair is not None:
            yield f"{key} = {metres(pair)}"
    circle = case.get("circle")
    if circle:
        yield f"[circle]\ncentre_m = {metres(circle['centre'])}\nradius_m = {metres(circle['radius'])}"
        yield f"between_m = {metres(circle['between'])}"
    else:
        yield "[circle]\ncritical = 'bishop'"


def solved(case: Mapping[str, Any]) -> Critical:
    """The factors of a case's circle, or of the circle of the least factor by Bishop's method, from its scene file."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "case.toml"
        path.write_text(scene_text(case), "utf-8")
        return critical_of_file(path, None, lambda line: None)[2]


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
