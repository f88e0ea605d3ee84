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
NUMBERS = ("unit_weight", "gravity", "width", "radius", "water_unit_weight")
NAN, INF = float("nan"), float("inf")


class Wrong(NamedTuple):
    """A mistake: other fields of the section, the field that is to be named, and words that are to follow."""

    changed: Data
    field: str
    words: str


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


ODD: dict[str, tuple[str, list[Any]]] = {  # what is to be said of a field, and values that it cannot have
    "centre": ("two", [NAN, "a", None, True, [], [1.0], [1.0, 2.0, 3.0], [NAN, 0.0], [0.0, INF], [0.0, 1e9], {"x": 1},
                       ["a", "b"], [[0.0], [1.0]], [[0.0, 1.0], [2.0]], 5.0]),
    "between": ("two|no mass there", [(5.0, 3.0), (1.0, 1.0), (1.0,), (1.0, 2.0, 3.0), "ab", 3.0, (NAN, 1.0),
                                      (1e7, 2e7), ("a", "b"), {"a": 1}, [(0.0, 1.0), (2.0, 3.0)], True]),
    "base": ("", [NAN, INF, -INF, "12", True, [1.0, 2.0]]),
}  # fmt: skip
ODD |= dict.fromkeys(NUMBERS, ("", [*ODD["base"][1][:5], None, {}, [[]], ["a"], 0.0, -1e-9, -37.5, -1e9, -5e-324]))


def value(rng: Random, given: Data) -> Wrong:
    """A field of another type or range."""
    name = rng.choice([*ODD])
    words, values = ODD[name]
    odd = rng.choice(values)
    return Wrong({name: odd}, name, words or shown(odd))


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
            return Wrong({name: [[points[0][0], y] for _, y in points]}, name, "all points have the same x|is equal to")
        case 4:
            odd: list[Any] = [[], [points[0]], "ground", 3.0, True, [1.0, 2.0], [[1.0], [2.0]], points[0],
                              [[1, 2, 3], [4, 5, 6]], [["a", "b"], ["c", "d"]], {"x": 1}, [points[0], [1.0]],
                              [[True, False], [False, True]], [[None, 1], [2, 3]], np.array(points, dtype=complex),
                              [[points[0]]]]  # fmt: skip
            return Wrong({name: rng.choice(odd)}, name, "at least two points")
    deep: list[Any] = points
    for _ in range(rng.randrange(14, 40)):  # with fewer axes of lanes it is one of many
        deep = [deep]
    return Wrong({name: deep}, name, "at least two points")


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
                      "centre": np.array([given["centre"]] * 2)}, "shapes do not fit together", "")  # fmt: skip
    return Wrong({"radius": np.zeros(0)}, "radius", "is empty")


def half_disc(rng: Random, given: Data) -> Wrong:
    """Deeper than a half disc: geometry, but no motion."""
    size = given["radius"]
    wide, up, low = (size * rng.uniform(a, b) for a, b in ((1.1, 1.3), (0.5, 0.8), (-0.2, -0.05)))
    ground = [[-wide, up], [0.0, low], [wide, up * rng.uniform(0.8, 1.2)]]
    return Wrong({"ground": ground, "centre": [0.0, 0.0], "level": None}, "arc", "longer than half a circle")


def many(rng: Random, given: Data) -> Wrong:
    """One lane of several."""
    k, radii = rng.randrange(3), np.full(3, given["radius"])
    radii[k] *= 1e-6
    return Wrong({"radius": radii}, f"lane [{k}]", "misses the ground|no stretch")


MISTAKES: list[Callable[[Random, Data], Wrong]] = [
    value, value, line, misses, several, below_ground, end_inside, deep, pond, uncovering, shapes, half_disc, many,
]  # fmt: skip


# --- judgement -------------------------------------------------------------------------------------------------------


def shown(value: Any) -> str:
    """How a refusal shows a number or a point; anything where it is neither."""
    if isinstance(value, list):
        return re.escape(repr(value)) if len(value) == 2 and all(isinstance(v, float) for v in value) else ""
    return f"({re.escape(f'{value:.10g}')}|{re.escape(repr(value))})" if isinstance(value, float) else ""


def document(given: Data) -> Data | None:
    """A section as the document of a file; None where no file can hold it."""
    found: Data = {"ground": {}, "circle": {}, "friction": {"angle_deg": 12.0}}
    for name, value in given.items():
        table, _, key = KEYS[name].partition(".")
        if name == "level" and value is None:
            continue
        text = json.dumps(value, default=lambda odd: None)
        if "null" in text:
            return None
        unit = 1e3 if key.endswith("kN_m3") and isinstance(value, float) else None
        found.setdefault(table, {})[key] = value / unit if unit else json.loads(text)
    return found


def fault(rng: Random, folder: Path) -> str:
    """What is wrong with how one malformed section is refused, in Python and in a file; nothing, if all is well."""
    base = good(rng)
    wrong = rng.choice(MISTAKES)(rng, base)
    given = base | wrong.changed
    what = "Scene" if wrong.field == "arc" else "Section"
    if bad := judged(lambda: Scene(Section(**given), 0.3), f"{what}: {wrong.field}", wrong.words):
        return f"{bad}\n{given}"
    if (made := document(given)) is None:
        return ""
    path = folder / "section.toml"
    path.write_text(toml(made), "utf-8")
    name, _, place = wrong.field.partition("[")
    # A file's pair of points is refused before the section is made, with more words.
    key = "circle." if name == "between" else KEYS.get(name, name) + ("[" + place if place else "")
    bad = judged(lambda: load(path), f"{path}: {key}", "")
    return f"{bad}\n{path.read_text('utf-8')}" if bad else ""


def judged(work: Callable[[], object], begins: str, words: str) -> str:
    """What is wrong with a refusal: it is one sentence that begins with the field."""
    try:
        work()
    except ValueError as error:
        text = str(error)
        right = text.startswith(begins) and re.search(words, text) and "\n" not in text
        others = [n for n in {*KEYS, *KEYS.values()} if re.search(rf"; {re.escape(n)}( = |: )", text)]
        return "" if right and not others else f"says {text!r}; wanted {begins!r} and {words!r} alone"
    except Exception as error:
        return f"raises {error!r} and no ValueError"
    return f"is not refused; wanted {begins!r}"


def faults(count: int, seed: int) -> Iterator[str]:
    with tempfile.TemporaryDirectory() as place:
        for k in range(count):
            if said := fault(Random(f"{seed} {k}"), Path(place)):
                yield f"--- {k}: {said}"


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=str(__doc__).partition("\n")[0])
    parser.add_argument("count", type=int)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    bad = list(faults(options.count, options.seed))
    print(*bad, f"{options.count} malformed sections, {len(bad)} answered badly", sep="\n")
    sys.exit(bool(bad))
