"""The notebooks run in a fresh kernel, print what they hold, and their numbers are the package's.

``./run python tests/test_notebooks.py`` stores fresh outputs, with the figures, which the tests do not compare.
Nor do they compare what cells print whose ids start with "timed": it holds measured times.
"""

import json
import math
import os
import sys
import tempfile
from dataclasses import replace
from decimal import Decimal
from functools import cache
from pathlib import Path
from typing import Any

import nbformat
import numpy as np
import oracle
import pytest
from nbclient import NotebookClient
from test_cost import QUICK
from test_stability import sliced

import generated
from derive.flow.operations import OPERATIONS as SERIES
from derive.judge.paper import CLAIMS
from generated import stable, tiers
from generated.effects import EFFECTS, LAWS
from slipcircle import Arc, Motion, Section, Slope, Status, critical, load, solve
from slipcircle.outputs.report import ASSUMED
from slipcircle.scene.ground import simple_slope

ROOT = Path(__file__).parents[1]
NOTEBOOKS = sorted((ROOT / "notebooks").glob("*.ipynb"))
METADATA = {
    "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
    "language_info": {"name": "python"},
}
each_notebook = pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)


def run(path: Path, first: str = "") -> Any:
    """The notebook, run in a fresh kernel that knows no settings of the user; nothing volatile is left in it.

    What is to be run ``first`` leaves no cell either.
    """
    notebook = nbformat.read(path, as_version=4)
    notebook.cells.insert(0, nbformat.v4.new_code_cell(first))
    with tempfile.TemporaryDirectory() as folder:
        # The kernel draws inline whatever the backend here, and keeps no history.
        env = {name: value for name, value in os.environ.items() if name not in ("MPLBACKEND", "MATPLOTLIBRC")}
        env |= {"IPYTHONDIR": folder, "PYTHONPATH": str(ROOT), "PYTHONWARNINGS": "default"}
        client = NotebookClient(
            notebook,
            timeout=300,  # a guard; the longest cell takes some seconds
            kernel_name="python3",
            record_timing=False,
            coalesce_streams=True,
            extra_arguments=["--log-level=ERROR"],
            resources={"metadata": {"path": folder}},
        )
        client.execute(env=env)
    del notebook.cells[0]
    notebook.metadata = METADATA
    for cell in notebook.cells:
        cell.metadata = {}
        if cell.cell_type == "code":
            cell.execution_count = None
            for output in cell.outputs:
                output.pop("execution_count", None)
                if output.output_type == "execute_result":
                    output.execution_count = None
    return notebook


def texts(cell: Any) -> list[Any]:
    """What a cell says, stream by stream and display by display; of a picture, only that it is there."""
    said = []
    for output in cell.get("outputs", []):
        if output.output_type == "stream":
            said.append({output.name: output.text})
        else:
            data = output.get("data", {})
            said.append({kind: "" if kind.startswith("image/") else text for kind, text in data.items()})
    return said


@cache
def stored(name: str) -> Any:
    """The notebook as it is kept; that a fresh run prints the same has its own test."""
    return nbformat.read(ROOT / "notebooks" / name, as_version=4)


def key_numbers(name: str) -> Any:
    """What the notebook's last cell prints."""
    return json.loads(printed(stored(name), "key-numbers"))


def printed(notebook: Any, cell_id: str) -> str:
    """What the cell of this id printed."""
    (cell,) = (cell for cell in notebook.cells if cell.id == cell_id)
    return "".join(output.text for output in cell.outputs if output.output_type == "stream")


@each_notebook
def test_outputs_are_those_of_a_fresh_run(path: Path) -> None:
    quick = f"from slipcircle.cost import cost\nvars(cost).update({QUICK})"  # no test is about how long something takes
    kept, fresh = stored(path.name), run(path, quick)
    stale = "stale; to store fresh outputs: ./run python tests/test_notebooks.py"
    for old, new in zip(kept.cells, fresh.cells, strict=True):
        assert old.id.startswith("timed") or texts(old) == texts(new), f"{path.name}, cell {old.id}: {stale}"
        assert len(texts(old)) == len(texts(new)), f"{path.name}, cell {old.id}: {stale}"
        assert not any("stderr" in said for said in texts(new)), f"{path.name}, cell {new.id} warns"


@each_notebook
def test_source_diffs_well(path: Path) -> None:
    notebook = nbformat.read(path, as_version=4)
    nbformat.validate(notebook)
    assert (notebook.nbformat, notebook.nbformat_minor) == (4, 5)
    assert notebook.metadata == METADATA
    assert not any(cell.metadata or cell.get("execution_count") for cell in notebook.cells)
    assert path.read_text(encoding="utf-8") == written(notebook)
    for cell in notebook.cells:
        for output in cell.get("outputs", []):
            assert len(output.get("data", {}).get("image/png", "")) < 80_000, "60 kB, in base 64"


def test_key_numbers_of_the_method() -> None:
    """Every declared effect, law and operation is rendered, and what the page computes by hand is the motion's."""
    notebook, numbers = stored("0_the_method.ipynb"), key_numbers("0_the_method.ipynb")
    scene, shown = load("vaiont"), "".join(str(texts(cell)) for cell in notebook.cells)
    for name in (*EFFECTS, *LAWS, *SERIES, *Status.__members__):
        assert f"| `{name}` |" in shown, name
    for claim in CLAIMS:  # what the method stands on is cited
        if claim.id in ("(1.1)", "(2.20)", "(3.11)", "(3.13)", "(3.20)", "(3.21)"):
            assert claim.id in shown or any(claim.id in cell.source for cell in notebook.cells), claim.id
    for said in ASSUMED:
        assert said in shown
    alpha, dip = float(scene.arc.half_angle), float(scene.arc.dip)
    ratio = oracle.kernel("weight_moment_amplitude", alpha) / oracle.kernel("radial_weight_amplitude", alpha)
    limit, mu = float(ratio) * math.tan(dip), math.tan(math.radians(10.0))
    assert numbers["limit_friction"] == pytest.approx(limit, rel=1e-11)
    # k_y: (J_theta + k J_theta') = mu (J_r + k J_r'), all over J_r.
    assert numbers["yield_coefficient"] == pytest.approx((mu - limit) / (float(ratio) + mu * math.tan(dip)), rel=1e-10)
    pendulum = solve(replace(scene, effects=["rotation"]))
    assert numbers["pendulum"] == pytest.approx([pendulum.run_out, pendulum.duration], rel=1e-10)
    assert numbers["frozen_30_s"] == pytest.approx(solve(load("vaiont-frozen")).run_out, abs=1e-6)
    assert numbers["acceleration_off"] is True
    assert numbers["swings"] == len(solve(replace(scene, friction=0.05)).phases)
    assert numbers["errors_kept"] == [True] * 4
    assert printed(notebook, "frozen").count("True") == 2
    assert "as printed it does: False" in printed(notebook, "frozen")


def test_key_numbers_of_the_derivation() -> None:
    notebook = stored("1_derivation.ipynb")
    numbers = key_numbers("1_derivation.ipynb")
    assert len(numbers["C_r"]) == 5
    worst = max(ulp or math.inf for _, ulp in tiers.BOUNDS["radial_weight_amplitude"]["best"].values())
    for alpha, text in numbers["C_r"].items():
        reference = oracle.kernel("radial_weight_amplitude", float(alpha))
        assert oracle.ulps(float(text), reference) <= 0.5 + 1e-9
        assert oracle.ulps(float(generated.radial_weight_amplitude(float(alpha))), reference) <= worst
    doc = " ".join((generated.radial_weight_amplitude.__doc__ or "").split())
    assert f"C_r = {numbers['closed_form']} " in doc
    assert f"Operations: {numbers['operations']}." in doc
    assert f"Operations: {numbers['stable_operations']}." in (stable.radial_weight_amplitude.__doc__ or "")
    assert_proved(numbers["bounds"])
    before, after = numbers["appendix_I_operations"]
    assert before > 50 * after
    assert "one line, as it stands: finite at 61 of 62 angles" in printed(notebook, "picture")
    assert "certified kernel: within its proved bound everywhere: True" in printed(notebook, "picture")
    assert "as checked in: True" in printed(notebook, "program")
    assert "of these programs: True" in printed(notebook, "certificate")
    assert printed(notebook, "certificate").count("refused") == 2
    assert "as checked in: True" in printed(notebook, "source")
    assert "Vaiont: 2.413 MPa" in printed(notebook, "use")


def assert_proved(claimed: dict[str, float]) -> None:
    """The bounds that a notebook shows are those that the package reads."""
    found: dict[str, float] = {}
    for tier, forms in tiers.BOUNDS["radial_weight_amplitude"].items():
        found |= {f"{tier}, {form}": relative if ulp is None else ulp for form, (relative, ulp) in forms.items()}
    assert claimed == found


def numbers_of(motion: Motion) -> list[float]:
    return [float(motion.peak.velocity), motion.run_out, motion.duration]


def test_key_numbers_of_the_paper() -> None:
    numbers, arc = key_numbers("2_the_paper_reproduced.ipynb"), load("vaiont-frozen").arc
    assert isinstance(arc, Arc)
    d = arc.dimensionless
    package = {
        "Table 2-1 2alpha": np.degrees(2 * arc.half_angle),
        "Table 2-1 I_p": arc.polar_moment / 1e9,
        "Table 2-1 sigma_ref": arc.reference_stress / 1e6,
        "Table 2-1 sigma_n0": arc.static_normal_stress / 1e6,
        "Table 2-1 A": d.dynamic_coefficient,
        "Table 4-1 Theta*": d.moment_of_inertia,
        "Table 4-1 J_r": d.radial_weight,
        "Table 4-1 J_theta": d.weight_moment,
        "Table 4-1 lambda": d.resistance_factor,
        "Table 4-1 sigma*_n0": d.static_normal_stress,
        "Table 4-1 A": d.dynamic_coefficient,
        "Table 4-1 phi_C,eq": np.degrees(arc.limit_friction_angle),
    }
    assert numbers["tables"].keys() == package.keys()
    in_paper = {claim.id: claim.printed for claim in CLAIMS}
    wrong = []
    for entry, (shown, computed) in numbers["tables"].items():
        assert shown == in_paper[entry]
        assert float(computed) == pytest.approx(float(package[entry]), rel=1e-6)
        unit = 10.0 ** int(Decimal(shown).as_tuple().exponent)
        wrong += [entry] if abs(float(shown) - float(package[entry])) >= unit else []
    assert numbers["wrong"] == wrong
    assert len(wrong) == 5  # of 16 entries, as the first sentence says
    scenes = {"as printed": "vaiont-as-printed", "corrected": "vaiont-frozen", "turning": "vaiont"}
    for name, scene in scenes.items():
        state = solve(load(scene)).at(30.0)
        reached = [state.velocity, state.displacement, np.degrees(state.rotation)]
        assert numbers["after_30_s"][name] == pytest.approx(reached, abs=6e-4)
    drive, brake = zip(*(_coefficients(scenes[name]) for name in ("as printed", "corrected")), strict=True)
    assert numbers["ratios"] == pytest.approx([drive[1] / drive[0], brake[1] / brake[0]], abs=6e-4)


def _coefficients(name: str) -> tuple[float, float]:
    scene = load(name)
    d, mu = scene.arc.dimensionless, float(np.asarray(scene.friction))
    return d.limit_friction * d.radial_weight_per_inertia - mu * d.radial_weight_per_inertia, (
        mu * d.polar_moment_per_inertia
    )


def test_key_numbers_of_the_price_list() -> None:
    notebook, numbers = (
        stored("3_what_accuracy_costs.ipynb"),
        key_numbers("3_what_accuracy_costs.ipynb"),
    )
    assert_proved(numbers["claimed"])
    alpha, error = float.fromhex(numbers["witness"][0]), numbers["witness"][1]
    assert 0.0 < alpha < math.pi / 2
    assert 0.5 < error <= numbers["claimed"]["best, fused"]
    assert numbers["run_out"] == pytest.approx(solve(load("vaiont")).run_out, abs=6e-7)
    assert numbers["measured_above_proved"] == []
    assert printed(notebook, "accuracy").count("True") == 3
    assert "refused: radial_weight_amplitude cannot promise" in printed(notebook, "accuracy")
    assert printed(notebook, "certificate").count("refused,") == 2
    assert "Frontier: " in printed(notebook, "timed-table")
    assert "above what is proved" not in printed(notebook, "timed-table")


def test_key_numbers_of_vaiont() -> None:
    numbers, scene = key_numbers("4_vaiont_effect_by_effect.ipynb"), load("vaiont")
    both: dict[str, dict[str, float]] = {"rotation": {}, "centripetal": {}}

    def solved(effects: dict[str, dict[str, float]], end: float | None = None) -> Motion:
        return solve(replace(scene, effects=effects, end_time=end))

    steps = [
        solved({}, 45.0),
        solved({"centripetal": {}}, 45.0),
        solved({"rotation": {}}),
        solve(scene),
        solve(replace(load("vaiont-as-printed"), end_time=45.0)),
    ]
    assert [m.arrested for m in steps] == [False, False, True, True, False]
    for shown, motion in zip(numbers["steps"].values(), steps, strict=True):
        assert shown == pytest.approx(numbers_of(motion), abs=6e-4)
    added = [{"pore_pressure": {"ratio": 0.2}}, {"cohesion": {"cohesion": 1e5}}, {"drag": {"xi": 1000.0}}]
    others = [solve(load("vaiont-softening")), *(solved(both | more) for more in added)]
    others += [solve(load(name)) for name in ("vaiont-rate", "vaiont-heated")]
    for shown, motion in zip(numbers["others"], others, strict=True):
        assert shown == pytest.approx(numbers_of(motion), abs=6e-4)
    # Interpolated between half degrees, so a little less exact: what the friction angles do give.
    for what, targets in (("run-out", (300.0, 450.0)), ("peak", (20.0, 30.0))):
        for angle, target in zip(numbers["friction_deg"][what], targets, strict=True):
            motion = solve(replace(scene, friction=math.tan(math.radians(angle))))
            reached = motion.run_out if what == "run-out" else float(motion.peak.velocity)
            assert reached == pytest.approx(target, rel=0.02)
    for way, (time, speed) in numbers["arrival"].items():
        state = steps[3].at(time)
        assert float(state.displacement) == pytest.approx(float(way), abs=2.0)
        assert float(state.velocity) == pytest.approx(speed, abs=0.1)
    assert numbers["dip_at_rest_deg"] == pytest.approx(23.95 - np.degrees(float(steps[3].end.rotation)), abs=0.006)


def test_key_numbers_of_the_ensemble() -> None:
    """Beside another sample, drawn by NumPy and solved as one scene of arrays, and differences of single motions."""
    numbers, scene = key_numbers("5_an_uncertain_slide.ipynb"), load("vaiont")
    draw, n = np.random.default_rng(7), 50_000
    angle, ratio = draw.normal(10.0, 1.5, n), draw.triangular(0.0, 0.05, 0.2, n)
    first, radius = draw.normal(215.2, 1.0, n), draw.normal(1492.6, 50.0, n)

    def slide(angle: Any, ratio: Any, first: Any, radius: Any) -> Any:
        water = {**scene.called, "pore_pressure": {"ratio": ratio}}
        arc = replace(scene.arc, theta_1=np.deg2rad(first), radius=radius)
        return solve(replace(scene, arc=arc, friction=np.tan(np.deg2rad(angle)), effects=water))

    many = slide(angle, ratio, first, radius)
    for name, values, wide in (("run_out", many.run_out, 4.0), ("peak_velocity", many.peak.velocity, 0.15)):
        assert numbers[name] == pytest.approx(np.quantile(values, [0.05, 0.5, 0.95]).tolist(), abs=wide)
    seen = many.run_out <= 450.0
    hits, rare = numbers["as_observed"]
    assert abs(np.sum(seen) - hits / 4) < 4 * math.sqrt(hits / 4 * 1.25)
    assert rare == 0 == np.sum(seen & (many.peak.velocity >= 20.0))
    assert numbers["turn_back"] == pytest.approx(np.mean(many.duration > 60.0), abs=0.006)
    # What is left of the variance when all but one are known: pairs of slides that share these.
    other = slide(draw.normal(10.0, 1.5, n), ratio, first, radius)
    share = np.mean((other.run_out - many.run_out) ** 2) / (2 * np.var(many.run_out))
    assert numbers["total_index"]["friction.angle_deg"] == pytest.approx(share, abs=0.02)
    # Derivatives as differences of single motions, at the means.
    mean, std = np.array([10.0, 0.25 / 3, 215.2, 1492.6]), np.array([1.5, math.sqrt(0.0325 / 18), 1.0, 50.0])
    steps = [np.where(np.arange(4) == k, 1e-4 * mean, 0.0) for k in range(4)]
    for name, got in numbers["linear_std"].items():
        ends = [(_output(slide(*(mean + h)), name), _output(slide(*(mean - h)), name)) for h in steps]
        slopes = [(a - b) / (2e-4 * x) for (a, b), x in zip(ends, mean, strict=True)]
        assert got == pytest.approx(math.hypot(*(std * slopes)), abs=0.01)
    # What the friction angles that it found give.
    for target, (found, speed, late) in numbers["back"].items():
        motion = solve(replace(scene, friction=math.tan(math.radians(found))))
        assert numbers_of(motion) == pytest.approx([speed, float(target), late], abs=0.06)
    for r, found in zip(np.linspace(0.0, 0.3, 7), numbers["angle_with_water"], strict=True):
        assert slide(found, float(r), 215.2, 1492.6).run_out == pytest.approx(400.0, abs=0.06)
    best, chi = numbers["both"]
    angles = np.linspace(best - 0.2, best + 0.2, 401)
    swept = slide(angles, 0.0, 215.2, 1492.6)
    missed = ((swept.run_out - 400.0) / 50.0) ** 2 + ((swept.peak.velocity - 25.0) / 2.5) ** 2
    assert angles[np.argmin(missed)] == pytest.approx(best, abs=0.002)
    assert np.min(missed) == pytest.approx(chi, abs=0.01)
    # 1e9 scenes: blocks on workers, or what hands them out.
    small, large = numbers["region"]["65536"], numbers["region"]["262144"]
    assert small == pytest.approx([1526 * 0.174, 15259 * 0.0024], abs=0.5)
    assert large == pytest.approx([382 * 0.658, 39 * 0.658], abs=0.5)
    assert "us each" in printed(stored("5_an_uncertain_slide.ipynb"), "timed-cost")


def test_key_numbers_of_the_slope() -> None:
    numbers, scene = key_numbers("6_from_a_slope_to_a_slide.ipynb"), load("real-slope")
    assert scene.stability is not None
    slope, section = scene.stability.slope, scene.arc
    assert isinstance(section, Section)
    assert numbers["factors"]["bishop"] == 0.985  # as converged by others
    ways = sliced(slope, section.centre, section.radius, section)  # type: ignore[arg-type]
    assert numbers["factors"] == pytest.approx({m: ways[m] for m in numbers["factors"]}, abs=6e-5)
    for k, (angle, row) in enumerate(numbers["lower"].items()):  # each slope, and each of the pressures
        mu = math.tan(math.radians(25))
        ground = simple_slope(10.0, angle=math.radians(float(angle)))
        of = Slope(ground, 20e3 * mu, mu, 20e3, pore_ratio=0.25 * k, base=-20.0)
        circle = critical(of)
        body = Section(ground, circle.centre, circle.radius, 20e3, between=circle.between)
        ways = sliced(of, circle.centre, circle.radius, body)
        assert row[k] == pytest.approx(ways["paper"] / ways["bishop"] - 1, abs=1e-4)
    motion = solve(scene)
    shown = [motion.peak.velocity, motion.duration, motion.journey.run_out]
    assert numbers["slides"]["bishop"][2:] == pytest.approx(shown, abs=6e-5)
    title = nbformat.read(ROOT / "notebooks" / "6_from_a_slope_to_a_slide.ipynb", as_version=4).cells[0].source
    for words in (f"**{shown[0]:.1f} m/s**", f"**{shown[1]:.1f} s**", f"**{shown[2]:.1f} m**", "**0.985**", "0.942"):
        assert words in title
    assert numbers["moving"] == pytest.approx(0.75, abs=0.02)  # three of four
    assert numbers["reach_95"] == pytest.approx(13.0, abs=0.5)


def _output(motion: Any, name: str) -> float:
    return float(motion.outcomes[name])


def written(notebook: Any) -> str:
    """Its text, as these files are written."""
    return str(nbformat.writes(notebook)) + "\n"


if __name__ == "__main__":
    for notebook_path in NOTEBOOKS:
        notebook_path.write_text(written(run(notebook_path)), encoding="utf-8", newline="\n")
        print(f"stored {notebook_path.relative_to(ROOT)}", file=sys.stderr)
