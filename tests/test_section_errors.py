"""What a section refuses, and in which words."""

import math
from pathlib import Path
from typing import Any

import malformed_sections
import pytest

from slipcircle import Arc, Scene, Section, load

GOOD: dict[str, Any] = {
    "ground": [(-50, 10), (-20, 10), (0, 0), (50, 0)],
    "centre": (-5, 20),
    "radius": 22.0,
    "unit_weight": 2e4,
}
WRONG: dict[str, dict[str, Any]] = {
    "misses the ground": {"radius": 5.0},
    "several stretches": {"ground": [(-50, 10), (-20, 10), (-8, -9), (0, 0), (50, 0)]},
    "no stretch of the ground": {"between": (20.0, 30.0)},
    "order them by x": {"ground": [(-50, 10), (-20, 10), (-25, 0), (50, 0)]},
    "leave one out": {"ground": [(-50, 10), (-50, 10), (0, 0), (50, 0)]},
    "lies below the ground": {"centre": (-20, 9.0), "radius": 4.0},
    "below base": {"base": -1.0},
    "ponds": {"level": [(-50, 5), (50, 5)]},
    "an end of the ground": {"ground": [(-15, 10), (0, 0), (50, 0)]},
    "positive length": {"radius": -1.0},
    "finite": {"centre": (math.nan, 20)},
    "at least two points": {"ground": [(0, 1)]},
    "positive unit weight": {"unit_weight": 0.0},
    "from left to right": {"between": (5.0, 3.0)},
    "above each other": {"ground": [(0, 1), (0, 5)]},
}  # fmt: skip


@pytest.mark.parametrize("words", WRONG)
def test_errors_say_what_is_wrong(words: str) -> None:
    Section(**GOOD)
    with pytest.raises(ValueError, match=words) as raised:
        Section(**(GOOD | WRONG[words]))
    assert "\n" not in str(raised.value)


def test_deeper_than_a_half_disc_has_geometry_and_no_motion() -> None:
    found = Section([(-50, 0), (0, -1), (50, 0)], (0.0, 1.0), 20.0, 2e4)
    assert found.no_motion is None
    found = Section([(-50, 10), (0, 0), (50, 10)], (0.0, 1.0), 20.0, 2e4)
    assert found.half_angle > math.pi / 2
    assert found.area > 0.0
    assert found.no_motion is not None
    assert "half a circle" in found.no_motion


def test_a_thousand_malformed_sections() -> None:
    """`python tests/malformed_sections.py 10000` draws ten times as many."""
    assert not list(malformed_sections.faults(1000, 16))


def test_a_level_and_a_pore_ratio_exclude_each_other(tmp_path: Path) -> None:
    wet = Section(**GOOD, level=[(-50, 0), (50, -1)])
    words = (
        r"^Scene: effects\.pore_pressure\.ratio: cannot be combined with the level of the section, which says .*out$"
    )
    with pytest.raises(ValueError, match=words):
        Scene(wet, 0.3, {"pore_pressure": {"ratio": 0.2}})
    Scene(wet, 0.3, {"pore_pressure": {"pressure": 2e3}})  # an excess over the level's is no second level
    text = Path("slipcircle/scenes/real-slope.toml").read_text("utf-8") + "[pore_pressure]\nratio = 0.2\n"
    path = tmp_path / "wet.toml"
    for water in ("", "[water]\nlevel_m = [[0, 20], [90, 22]]\n"):
        path.write_text(text + water, "utf-8")
        if water:
            with pytest.raises(ValueError, match=r"pore_pressure\.ratio.* level") as raised:
                load(path)
            assert len(str(raised.value).splitlines()) == 1
        else:
            load(path)


ARC = "[arc]\nradius_m = 60\ntheta_1_deg = 215\ntheta_2_deg = 276\nunit_weight_kN_m3 = 19\n[friction]\nangle_deg = 12\n"


def test_a_unit_that_was_probably_meant_is_said(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="in rad: were they in degrees"):
        Arc(60.0, 215.0, 276.0, 19e3)
    with pytest.raises(ValueError, match="unit_weight = 19500000: must be a positive unit weight in N/m"):
        Section(**GOOD | {"unit_weight": 19.5e6})
    path = tmp_path / "arc.toml"
    for old, new, words in (
        ("kN_m3 = 19", "kN_m3 = 19500", r"is that in N/m3\?"),
        ("angle_deg = 12", "coefficient = 10", "an angle\\? say angle_deg"),
    ):
        path.write_text(ARC.replace(old, new), "utf-8")
        with pytest.raises(ValueError, match=words):
            load(path)
    path.write_text(ARC, "utf-8")
    load(path)
