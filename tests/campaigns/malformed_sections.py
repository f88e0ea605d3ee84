"""Malformed sections, in Python and in files: each is refused in one clear sentence, and nothing else is ever raised.

``python -m tests.campaigns.malformed_sections 10000 --seed 1`` draws so many, each a good section with one mistake, and
shows those that are answered badly. Where a file can hold the mistake it is read from one too.
"""

import argparse
import contextlib
import json
import re
import sys
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path
from random import Random
from typing import Any, NamedTuple

import numpy as np

from slipcircle import Scene, Section, load
from slipcircle.core.scene.ground import circle_through
from tests.campaigns.fuzz_scenes import toml

Data = dict[str, Any]
KEYS = {"ground": "ground.points_m", "unit_weight": "ground.unit_weight_kN_m3", "gravity": "ground.gravity_m_s2",
        "width": "ground.width_m", "base": "ground.base_m", "centre": "circle.centre_m", "radius": "circle.radius_m",
        "between": "circle.between_m", "level": "water.level_m",
        "water_unit_weight": "water.unit_weight_kN_m3"}  # fmt: skip
NUMBERS = [n for n in KEYS if n not in ("ground", "centre", "between", "level")]
NAN, INF = float("nan"), float("inf")


class Wrong(NamedTuple):
    """A mistake: other fields of the section, the field that is to be named, and what else is to be said.

    ``file`` is what a file's refusal begins with, by default the field's key; None where no file can hold it.
    """

    changed: Data
    field: str
    words: str
    file: str | None = ""


def good(rng: Random) -> Data:
    """A slope between level ground that falls to either side, its circle, often a level: no mistake."""
    while True:
        found = slope(rng)
        with contextlib.suppress(ValueError):
            if Section(**found).no_motion is None:
                return found


def slope(rng: Random) -> Data:
    """The same, except that its centre may lie below the ground."""
    height, edges = 10 ** rng.uniform(0, 2), rng.randrange(1, 5)
    run = height * rng.uniform(0.3, 3)
    shares = [0.0, *sorted(rng.uniform(0.1, 0.9) for _ in range(edges - 1)), 1.0]
    edge = [[run * s, height * (1 - s ** rng.uniform(0.9, 1.1))] for s in shares]
    ground = [[-6 * height - run, height], *edge, [run + 6 * height + run, 0.0]]
    ends = [-rng.uniform(0.3, 1) * height, height], [run + rng.uniform(0, 0.5) * height, 0.0]
    centre, radius = circle_through(*ends, depth=rng.uniform(0.25, 0.4) * float(np.hypot(*np.subtract(*ends))))
    found: Data = {"ground": ground, "centre": centre.tolist(), "radius": float(radius), "unit_weight": 2e4}
    if rng.random() < 0.5:
        found["level"] = [[x, y - 0.3 * height] for x, y in ground]
    if rng.random() < 0.5:
        found |= {k: [[-x, y] for x, y in found[k][::-1]] for k in ("ground", "level") if k in found}
        found["centre"] = [-found["centre"][0], found["centre"][1]]
    return found


# --- mistakes --------------------------------------------------------------------------------------------------------


def number(rng: Random, given: Data) -> Wrong:
    """A field that is no number, or none that it may be."""
    name = rng.choice(NUMBERS)
    odd: list[Any] = [NAN, INF, -INF, "12", True, None, {}, [[]], ["a"]]
    if name != "base":
        odd += [0.0, -rng.uniform(1e-9, 1e9), -5e-324]
    value = rng.choice(odd[:6] if name == "base" else odd)
    if value is None and name == "base":
        value = [1.0, 2.0]
    return Wrong({name: value}, name, shown(value), None if value is None else "")


def line(rng: Random, given: Data) -> Wrong:
    """Points that make no line from left to right."""
    name = rng.choice([n for n in ("ground", "level") if n in given])
    points = [list(p) for p in given[name]]
    k = rng.randrange(1, len(points))
    match rng.randrange(6):
        case 0:
            points[k] = [points[k - 1][0] - rng.uniform(1e-6, 1), points[k][1]]
            return Wrong({name: points}, f"{name}[{k}]", shown(points[k]) + ".*lies left of the point before it")
        case 1:
            points.insert(k, list(points[k - 1]))
            return Wrong({name: points}, f"{name}[{k}]", shown(points[k]) + ".*is equal to the point before it")
        case 2:
            points[k][rng.randrange(2)] = rng.choice([NAN, INF, -INF, 1e9, -1e300])
            return Wrong({name: points}, f"{name}[{k}]", shown(points[k]) + ".*within 1e9 m")
        case 3:
            return Wrong({name: [[points[0][0], y] for _, y in points]}, name, "all points have the same x|is equal "
                         "to the point before it", KEYS[name])  # fmt: skip
        case 4:
            odd: list[Any] = [[], [points[0]], "ground", None, 3.0, True, [1.0, 2.0], [[1.0], [2.0]], points[0],
                              [[1, 2, 3], [4, 5, 6]], [["a", "b"], ["c", "d"]], {"x": 1}, [points[0], [1.0]],
                              [[True, False], [False, True]], [[None, 1], [2, 3]], np.array(points, dtype=complex),
                              [[points[0]]]]  # fmt: skip
            value = rng.choice([v for v in odd if v is not None or name == "ground"])
            return Wrong({name: value}, name, "at least two points", None if value is None else "")
    deep: list[Any] = points
    for _ in range(rng.randrange(14, 40)):  # with fewer axes of lanes it is one of many
        deep = [deep]
    return Wrong({name: deep}, name, "at least two points")


def centre(rng: Random, given: Data) -> Wrong:
    odd: list[Any] = [NAN, "a", None, True, [], [1.0], [1.0, 2.0, 3.0], [NAN, 0.0], [0.0, INF], [0.0, 1e9], {"x": 1},
                      ["a", "b"], [[0.0], [1.0]], [[0.0, 1.0], [2.0]], 5.0]  # fmt: skip
    value = rng.choice(odd)
    return Wrong({"centre": value}, "centre", "two", None if value is None else "")


def misses(rng: Random, given: Data) -> Wrong:
    """A circle above the ground, beside it, or too small to reach it."""
    (x, y), r = given["centre"], given["radius"]
    high, right = (max(p[k] for p in given["ground"]) for k in (1, 0))
    other: Data = {"centre": rng.choice([[x, high + 1.001 * r], [right + 1.001 * r, y]])}
    if y > high and rng.random() < 0.3:
        other = {"radius": (y - high) * 0.99}
    return Wrong(other, "centre", re.escape(f"radius = {(given | other)['radius']:.10g}: misses the ground"))


def several(rng: Random, given: Data) -> Wrong:
    """A trench through the arc parts the mass in two."""
    (x, y), r = given["centre"], given["radius"]
    section = Section(**given)
    (x1, _), (x2, _) = sorted((tuple(section.entry), tuple(section.exit)))
    cuts = [x1 + (x2 - x1) * share for share in (0.45, 0.5, 0.55)]
    floor = y - np.sqrt(r * r - (cuts[1] - x) ** 2) - 0.1 * r
    points = np.asarray(given["ground"])
    sides = [[c, float(np.interp(c, *points.T))] for c in (cuts[0], cuts[2])]
    inner = [p for p in given["ground"] if not cuts[0] <= p[0] <= cuts[2]]
    ground = sorted([*inner, *sides, [cuts[1], float(floor)]])
    return Wrong({"ground": ground, "level": None}, "centre", "several masses.*choose one by .*between")


def between(rng: Random, given: Data) -> Wrong:
    far = given["ground"][-1][0]
    odd: list[Any] = [(5.0, 3.0), (1.0, 1.0), (1.0,), (1.0, 2.0, 3.0), "ab", 3.0, (NAN, 1.0), (far, far + 1),
                      ("a", "b"), {"a": 1}, [(0.0, 1.0), (2.0, 3.0)], True]  # fmt: skip
    return Wrong({"between": rng.choice(odd)}, "between", "two|no mass there", "circle.")


def below_ground(rng: Random, given: Data) -> Wrong:
    x = given["centre"][0]
    points = np.asarray(given["ground"])
    radius = 0.2 * given["radius"]
    y = float(np.interp(x, *points.T)) - rng.uniform(0.1, 0.9) * radius
    return Wrong({"centre": [x, y], "radius": radius, "level": None}, "centre", "lies below the ground")


def end_inside(rng: Random, given: Data) -> Wrong:
    x = given["centre"][0]
    side = [x, float(np.interp(x, *np.asarray(given["ground"]).T))]
    right = [p for p in given["ground"] if p[0] > x]
    left = [p for p in given["ground"] if p[0] < x]
    ground = rng.choice([[side, *right], [*left, side]])
    return Wrong({"ground": ground, "level": None}, "centre", "an end of the ground lies inside the circle")


def deep(rng: Random, given: Data) -> Wrong:
    section, (x, y), r = Section(**{k: v for k, v in given.items() if k != "level"}), given["centre"], given["radius"]
    (one, left), (other, right) = section.entry, section.exit
    low = y - r if min(one, other) < x < max(one, other) else min(left, right)
    base = low + rng.uniform(1e-6, 0.3) * r
    return Wrong({"base": base}, "radius", re.escape(f"{r:.10g}") + ".*below .*base")


def pond(rng: Random, given: Data) -> Wrong:
    up = given["radius"] * 10 ** rng.uniform(-6, 0)
    level = [[x, y + (up if rng.random() < 0.6 else 0.0)] for x, y in given["ground"]]
    level[rng.randrange(len(level))][1] += up
    return Wrong({"level": level}, "level", "above the ground at x = .*pond")


def uncovering(rng: Random, given: Data) -> Wrong:
    far = given["ground"][-1][0] + 1.0
    y = min(p[1] for p in given["ground"]) - 1.0
    return Wrong({"level": [[far, y], [far + 5, y]]}, "level", "beside the ground; it must extend over it")


def shapes(rng: Random, given: Data) -> Wrong:
    """Arrays that do not fit together, or are empty."""
    if rng.random() < 0.7:
        return Wrong({rng.choice(["radius", "unit_weight", "gravity", "width"]): np.full(3, given["radius"]),
                      "centre": np.array([given["centre"]] * 2)}, "shapes do not fit together", "", None)  # fmt: skip
    return Wrong({"radius": np.zeros(0)}, "radius", "is empty", None)


def half_disc(rng: Random, given: Data) -> Wrong:
    """Deeper than a half disc: geometry, but no motion."""
    size = given["radius"]
    wide, up, low = (size * rng.uniform(a, b) for a, b in ((1.1, 1.3), (0.5, 0.8), (-0.2, -0.05)))
    ground = [[-wide, up], [0.0, low], [wide, up * rng.uniform(0.8, 1.2)]]
    return Wrong({"ground": ground, "centre": [0.0, 0.0], "level": None}, "arc", "longer than half a circle", "arc")


def many(rng: Random, given: Data) -> Wrong:
    """One lane of several."""
    k, radii = rng.randrange(3), np.full(3, given["radius"])
    radii[k] *= 1e-6
    return Wrong({"radius": radii}, f"lane [{k}]", "misses the ground|no stretch", None)


def file_only(rng: Random, given: Data) -> Wrong:
    """Units, keys and tables that only a file has: by its document."""
    key, value, said = rng.choice([
        ("ground.unit_weight_kN_m3", rng.uniform(1e3, 3e4), "is that in N/m3"),
        ("ground.unit_weight_kN_m3", [20.0], "must be a number"), ("ground.unit_weight", 20.0, "did you mean"),
        ("ground.height_m", 3.0, "do not go together"), ("circle.depth_m", 3.0, "do not go together"),
        ("circle.centre", [0.0, 1.0], "did you mean centre_m"),
        ("circle", {"critical": "bishp"}, "did you mean bishop"),
        ("water.unit_weight_kN_m3", 9810.0, "is that in N/m3"), ("water.levels_m", [[0, 1]], "did you mean level_m"),
        ("circle.radius_m", "12 m", "must be a number"), ("circle", 3.0, ""), ("ground", [1, 2], ""),
        ("water", "wet", ""), ("search.k_h", 9.81, "a share of g"),
    ])  # fmt: skip
    return Wrong({"": (key, value)}, "", said, key if "together" not in said else key.partition(".")[0])


MISTAKES: list[Callable[[Random, Data], Wrong]] = [
    number, line, centre, misses, several, between, below_ground, end_inside, deep, pond, uncovering, shapes, half_disc,
    many, file_only,
]  # fmt: skip


# --- judgement -------------------------------------------------------------------------------------------------------


def shown(value: Any) -> str:
    """How a refusal shows a number or a point; anything where it is neither."""
    if isinstance(value, list):
        return re.escape(repr(value)) if len(value) == 2 and all(isinstance(v, float) for v in value) else ""
    return f"({re.escape(f'{value:.10g}')}|{re.escape(repr(value))})" if isinstance(value, float) else ""


def document(given: Data) -> Data | None:
    """What a file says of a section; None where none can."""
    found: Data = {"ground": {}, "circle": {}, "friction": {"angle_deg": 12.0}}
    for name, value in given.items():
        table, _, key = KEYS[name].partition(".") if name else given[""][0].partition(".")
        value = value if name else given[""][1]
        if value is None and name == "level":
            continue
        if "null" in (text := json.dumps(value, default=lambda odd: None)):
            return None
        value = json.loads(text)
        if key.endswith("kN_m3") and isinstance(value, float) and name:
            value /= 1e3
        if key:
            found.setdefault(table, {})[key] = value
        else:
            found[table] = value
    return found


def fault(rng: Random, folder: Path) -> str:
    """What is wrong with how one malformed section is refused, in Python and in a file; nothing, if all is well."""
    base = good(rng)
    wrong = rng.choice(MISTAKES)(rng, base)
    given = base | wrong.changed
    if wrong.field:
        what = "Scene" if wrong.field == "arc" else "Section"

        def in_python() -> object:
            return Scene(Section(**given), 0.3)

        if said := judged(in_python, f"{what}: {wrong.field}", wrong.words):
            return f"{said}\n{given}"
    if wrong.file is None or (made := document(given)) is None:
        return ""
    path = folder / "section.toml"
    path.write_text(toml(made), "utf-8")
    name, _, place = wrong.field.partition("[")
    key = wrong.file or KEYS[name] + ("[" + place if place else "")
    said = judged(lambda: load(path), f"{path}: {key}", "" if wrong.field else wrong.words)
    return f"{said}\n{path.read_text('utf-8')}" if said else ""


def judged(work: Callable[[], object], begins: str, words: str) -> str:
    """What is wrong with a refusal."""
    try:
        work()
    except ValueError as error:
        said = str(error)
    except Exception as error:
        return f"raises {error!r} and no ValueError"
    else:
        return f"is not refused; wanted {begins!r}"
    if not said.startswith(begins) or not re.search(words, said):
        return f"says {said!r}; wanted {begins!r} and {words!r}"
    others = [n for n in {*KEYS, *KEYS.values()} if re.search(rf"; {re.escape(n)}( = |: )", said)]
    return f"says more than one thing: {said!r}" if others or "\n" in said else ""


def faults(count: int, seed: int) -> Iterator[str]:
    with tempfile.TemporaryDirectory() as place:
        for k in range(count):
            if said := fault(Random(f"{seed} {k}"), Path(place)):
                yield f"--- {k}: {said}"


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("count", type=int)
    parser.add_argument("--seed", type=int, default=1)
    asked = parser.parse_args()
    bad = 0
    for text in faults(asked.count, asked.seed):
        bad += 1
        print(text)
    print(f"{asked.count} malformed sections, {bad} answered badly")
    sys.exit(bool(bad))
