"""The README is run: its Python, its scene file, and the commands that it lists."""

import re
from pathlib import Path

import numpy as np
import pytest

from generated.tiers import BOUNDS
from slipcircle import Scene, plan, solve
from slipcircle.__main__ import main

TEXT = (Path(__file__).resolve().parent.parent / "README.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"^```(\w*)\n(.*?)^```", TEXT, re.DOTALL | re.MULTILINE)


def test_python(capsys: pytest.CaptureFixture[str]) -> None:
    for code in (text for kind, text in BLOCKS if kind == "python"):
        exec(code, {})
    said = capsys.readouterr().out
    assert "677 m in 38 s, 28.0 m/s at most" in said
    assert float(said.split()[-1]) < 6.7e-7


def test_proved_bounds_of_the_readme() -> None:
    rows = [line.split("|")[1:-1] for line in TEXT.splitlines() if line.startswith("| `") and line.count("|") == 8]
    shown = {row[0].strip(" `"): float(row[5]) for row in rows}
    assert shown == {name: BOUNDS[name]["best"]["fused"][1] for name in shown}
    assert len(shown) == 5
    assert f"proved to {BOUNDS['polar_moment']['1e-6']['fused'][0]}" in TEXT


def test_scene_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The file as it stands in the README: it runs, is planned, and every effect and law of the README exists."""
    (toml,) = (text for kind, text in BLOCKS if kind == "toml")
    path = tmp_path / "my-slope.toml"
    path.write_text(toml, encoding="utf-8")
    motion = solve(Scene.load(str(path)))
    assert motion.moves
    assert motion.arrested
    assert motion.plan.left_out == ("viscosity", "shaking", "thermal_pressurisation")
    assert main(["run", str(path)]) == 0
    assert main(["plan", "--ladder", str(path)]) == 0
    assert "my-slope" in capsys.readouterr().out


def test_ladder_of_the_readme() -> None:
    """Peak, run-out and duration in the README's ladder are today's."""
    (shown,) = (text for _, text in BLOCKS if "effect added" in text)
    rungs = plan(Scene.load("vaiont")).ladder()
    for rung in rungs:
        line = next(x for x in shown.splitlines() if x.strip().startswith(f"+ {rung.added}" if rung.added else "none"))
        peak, run_out, duration = (float(x) for x in re.findall(r"([\d.]+) (?:m/s|m|s)(?=\s)", line))
        assert np.allclose([peak, run_out, duration], [rung.peak_velocity, rung.run_out, rung.duration], rtol=2e-3)


def test_shape() -> None:
    assert len(TEXT.splitlines()) < 200
    for target in re.findall(r"\]\(([^)]+)\)", TEXT):
        assert (Path(__file__).resolve().parent.parent / target).exists(), target
