"""Odd files and sections: each ends in an answer, or in a refusal that says what is wrong."""

import json
import re
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from slipcircle import Scene, Section, load
from tests.campaigns import fuzz_scenes

GOOD: dict[str, Any] = {
    "ground": [[-50.0, 10.0], [-20.0, 10.0], [0.0, 0.0], [50.0, 0.0]],
    "centre": [-5.0, 20.0],
    "radius": 22.0,
    "unit_weight": 2e4,
    "level": [[-50.0, 5.0], [-20.0, 5.0], [0.0, -2.0], [50.0, -2.0]],
}
KEYS = {"ground": "ground.points_m", "unit_weight": "ground.unit_weight_kN_m3", "gravity": "ground.gravity_m_s2",
        "width": "ground.width_m", "base": "ground.base_m", "centre": "circle.centre_m", "radius": "circle.radius_m",
        "between": "circle.between_m", "level": "water.level_m",
        "water_unit_weight": "water.unit_weight_kN_m3"}  # fmt: skip
NAN, INF = float("nan"), float("inf")
NUMBERS: tuple[Any, ...] = NAN, INF, -INF, "12", True, [1.0, 2.0]
POSITIVE: tuple[Any, ...] = *NUMBERS[:5], None, {}, [[]], ["a"], 0.0, -1e-9, -37.5, -1e9, -5e-324
PAIRS: tuple[Any, ...] = (
    NAN, "a", None, True, [], [1.0], [1.0, 2.0, 3.0], [NAN, 0.0], [0.0, INF], [0.0, 1e9], {"x": 1}, ["a", "b"],
    [[0.0], [1.0]], [[0.0, 1.0], [2.0]], 5.0,
)  # fmt: skip
RANGES: tuple[Any, ...] = (
    (5.0, 3.0), (1.0, 1.0), (1.0,), (1.0, 2.0, 3.0), "ab", 3.0, (NAN, 1.0), (1e7, 2e7), ("a", "b"), {"a": 1},
    [(0.0, 1.0), (2.0, 3.0)], True,
)  # fmt: skip
P, Q = [-80.0, -1.0], [80.0, -4.0]
DEEP: list[Any] = [P, Q]
for _ in range(20):
    DEEP = [DEEP]
NO_LINE: tuple[Any, ...] = ([], [P], "ground", 3.0, True, [1.0, 2.0], [[1.0], [2.0]], P, [[1, 2, 3], [4, 5, 6]],
           [["a", "b"], ["c", "d"]], {"x": 1}, [P, [1.0]], [[True, False], [False, True]], [[None, 1], [2, 3]],
           np.array([P, Q], dtype=complex), [[P]], DEEP)  # fmt: skip
LINES = ("ground", "level")
DRY: dict[str, Any] = {"level": None}
MISTAKES: list[tuple[dict[str, Any], str, str]] = [  # other fields of the section, the field to be named, and words
    *(({name: value}, name, f"{value:.10g}|{value!r}" if isinstance(value, float) else "")
      for name, value in product(("unit_weight", "gravity", "width", "radius", "water_unit_weight"), POSITIVE)),
    *(({"base": value}, "base", "") for value in NUMBERS),
    *(({"centre": value}, "centre", "two") for value in PAIRS),
    *(({"between": value}, "between", "two|no mass there") for value in RANGES),
    *(({name: value}, name, "at least two points") for name, value in product(LINES, NO_LINE)),
    *(({name: [P, [-80.5, 0.0], Q]}, f"{name}[1]", r"\[-80.5, 0.0\].*lies left of the point before it")
      for name in LINES),
    *(({name: [P, P, Q]}, f"{name}[1]", "is equal to the point before it") for name in LINES),
    *(({name: [P, [0.0, value], Q]}, f"{name}[1]", "within 1e9 m") for name, value in product(LINES, (NAN, -INF, 1e9))),
    *(({name: [P, [-80.0, 3.0]]}, name, "all points have the same x") for name in LINES),
    *(({"centre": centre}, "centre", "radius = 22: misses the ground") for centre in ([-5.0, 32.1], [72.1, 20.0])),
    ({"radius": 9.9}, "centre", r"radius = 9\.9: misses the ground"),
    (DRY | {"ground": [*GOOD["ground"][:2], [-10.0, 5.0], [-8.0, -9.0], [-6.0, 3.0], *GOOD["ground"][2:]]},
     "centre", "several masses.*choose one by .*between"),
    (DRY | {"centre": [-10.0, 3.0], "radius": 4.0}, "centre", "lies below the ground"),
    (DRY | {"ground": [[-15.0, 8.0], *GOOD["ground"][2:]]}, "centre", "an end of the ground lies inside the circle"),
    (DRY | {"ground": [[-20.0, 10.0], [-5.0, 45.0], [5.0, 5.0], [50.0, 0.0]]},
     "centre", "choose one by .*between.* besides one that an end of the ground cuts short"),
    ({"base": -1.0}, "radius", "22.*below .*base"),
    *(({"level": [[-50.0, 10.0], [-20.0, 10.0 + up], [0.0, 0.0], [50.0, 0.0]]}, "level",
       "varies by .* above the ground.*confined = true")
      for up in (1.0, 2.0)),
    ({"level": [[51.0, -1.0], [56.0, -1.0]]}, "level", "beside the ground; it must extend over it"),
    ({"radius": np.full(3, 22.0), "centre": np.array([GOOD["centre"]] * 2)}, "shapes do not fit together", ""),
    ({"radius": np.zeros(0)}, "radius", "is empty"),
    (DRY | {"ground": [[-26.0, 14.0], [0.0, -2.0], [26.0, 16.0]], "centre": [0.0, 0.0]}, "arc", "longer than half"),
    ({"radius": np.array([22.0, 2e-5, 22.0])}, "lane [1]", "misses the ground"),
]  # fmt: skip


def document(given: dict[str, Any]) -> dict[str, Any]:
    """Return a section as the document of a file; what no file can hold is null."""
    found: dict[str, Any] = {"ground": {}, "circle": {}, "friction": {"angle_deg": 12.0}}
    for name, value in given.items():
        table, _, key = KEYS[name].partition(".")
        if name != "level" or value is not None:
            heavy = key.endswith("kN_m3") and isinstance(value, float)
            found.setdefault(table, {})[key] = value / 1e3 if heavy else value
    plain: dict[str, Any] = json.loads(json.dumps(found, default=lambda odd: None))
    return plain


@pytest.mark.parametrize(("changes", "field", "words"), MISTAKES)
def test_a_malformed_section_is_refused_in_one_sentence(
    changes: dict[str, Any], field: str, words: str, tmp_path: Path
) -> None:
    """The sentence begins with the field, in Python and, if a file can contain the mistake, in a file."""
    with pytest.raises(ValueError, match=f"^(Section|Scene): {re.escape(field)}") as refusal:
        Scene(Section(**GOOD | changes), 0.3)
    assert re.search(words, str(refusal.value))
    made = document(GOOD | changes)
    path = tmp_path / "section.toml"
    refusals = [refusal]
    if "null" not in json.dumps(made):
        path.write_text(fuzz_scenes.toml(made), "utf-8")
        name, bracket, index = field.partition("[")
        key = re.escape(KEYS.get(name, name) + bracket + index).replace(r"circle\.between_m", "circle.")
        with pytest.raises(ValueError, match=f"^{re.escape(str(path))}: {key}") as refusal:
            load(path)
        refusals.append(refusal)
    for said in map(str, refusals):
        assert not re.search(rf"\n|; ({'|'.join([*KEYS, *KEYS.values()])})( = |: )", said)


def test_odd_scene_files_end_in_an_answer_or_a_refusal(tmp_path: Path) -> None:
    """Forty; `python -m tests.campaigns.fuzz_scenes 2000` draws others."""
    bad = fuzz_scenes.faults(range(40), 11, tmp_path, "run", 60.0)
    assert not bad, bad[0]


def test_a_level_and_a_pore_ratio_exclude_each_other() -> None:
    words = (
        r"^Scene: effects\.pore_pressure\.ratio: cannot be combined with the level of the section, which says .*out$"
    )
    with pytest.raises(ValueError, match=words):
        Scene(Section(**GOOD), 0.3, {"pore_pressure": {"ratio": 0.2}})
    Scene(Section(**GOOD), 0.3, {"pore_pressure": {"pressure": 2e3}})  # an excess is no second level
