"""Odd files and sections: each ends in an answer, or in a refusal that says what is wrong."""

import sys
from pathlib import Path
from typing import Any

import pytest

from slipcircle import Scene, Section, load
from tests.campaigns import fuzz_scenes, malformed_sections

GOOD: dict[str, Any] = {
    "ground": [(-50, 10), (-20, 10), (0, 0), (50, 0)],
    "centre": (-5, 20),
    "radius": 22.0,
    "unit_weight": 2e4,
}


def test_malformed_sections() -> None:
    """`python -m tests.campaigns.malformed_sections 10000` draws more."""
    assert not list(malformed_sections.faults(200, 16))


@pytest.mark.parametrize("part", range(2))
def test_odd_scene_files_end_in_an_answer_or_a_refusal(part: int, tmp_path: Path) -> None:
    """Two hundred in all; `python -m tests.campaigns.fuzz_scenes 2000` draws others."""
    bad = fuzz_scenes.faults(range(100 * part, 100 * part + 100), 11, tmp_path, "run", 60.0)
    assert not bad, bad[0]


def test_the_fuzz_sees_faults(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A traceback, a NaN, a refusal with an interpreter's words, silence."""
    path = tmp_path / "a.toml"
    path.write_text("x" * 2, "utf-8")
    for work, said in (
        (lambda argv: 1 / 0, "ZeroDivisionError"), (lambda argv: print("NaN") or 0, "prints"),
        (lambda argv: print("x is ambiguous", file=sys.stderr) or 1, "refuses with 1"),
        (lambda argv: 0, "says nothing"),
    ):  # fmt: skip
        monkeypatch.setattr(fuzz_scenes, "main", work)
        assert said in fuzz_scenes.fault(path)


def test_a_level_and_a_pore_ratio_exclude_each_other() -> None:
    wet = Section(**GOOD, level=[(-50, 0), (50, -1)])
    words = (
        r"^Scene: effects\.pore_pressure\.ratio: cannot be combined with the level of the section, which says .*out$"
    )
    with pytest.raises(ValueError, match=words):
        Scene(wet, 0.3, {"pore_pressure": {"ratio": 0.2}})
    Scene(wet, 0.3, {"pore_pressure": {"pressure": 2e3}})  # an excess over the level's is no second level


def test_layers_above_a_ground_that_is_no_table_are_refused_in_words(tmp_path: Path) -> None:
    path = tmp_path / "layers.toml"
    path.write_text(
        'ground = 23.9\nlayers = [{soil = "crust"}, {soil = "gravel", top_m = -6}]\n'
        "[soils]\ncrust = {unit_weight_kN_m3 = 18, friction = {angle_deg = 30}}\n"
        "gravel = {unit_weight_kN_m3 = 21, friction = {angle_deg = 33}}\n",
        "utf-8",
    )
    with pytest.raises(ValueError, match=r"ground = 23\.9: must be a table \[ground\]"):
        load(path)
