"""Studies of uncertain numbers: how they are declared, what they find beside single motions, and the command."""

import json
import math
import re
import tomllib
from dataclasses import replace
from importlib import import_module
from pathlib import Path
from typing import Any, cast

import numpy as np
import pytest
from scipy import stats

from slipcircle import Scene, backanalyse, ensemble, load, solve
from slipcircle.base import JSON_FORMAT
from slipcircle.core.motion.states import Status
from slipcircle.tables import Series
from slipcircle.workbench.common.quantities import OUTCOMES
from slipcircle.workbench.files.scenefile import load as read
from slipcircle.workbench.files.schema import schema
from slipcircle.workbench.outputs.report import study_report
from slipcircle.workbench.stability.stability import METHODS, factors_of_safety
from slipcircle.workbench.studies import export
from slipcircle.workbench.studies.ensemble import grid
from slipcircle.workbench.studies.motions import motions
from slipcircle.workbench.studies.study import Study
from tests.support.motions import from_method

jsonschema: Any = import_module("jsonschema")  # comes with nbformat, untyped
VAIONT = load("vaiont")
# So much friction that no sample turns back: run-out and peak velocity fall as it grows.
ANGLE: Any = {"distribution": "normal", "mean": 14, "std": 1}
ONE = replace(VAIONT, uncertain={"friction.angle_deg": ANGLE})
FILE = """
[arc]
radius_m = { distribution = "lognormal", mean = 1492.6, std = 50 }
theta_1_deg = 215.2
theta_2_deg = { distribution = "truncated_normal", mean = 276.9, std = 1, low = 274, high = 279 }
unit_weight_kN_m3 = { distribution = "triangular", low = 18, mode = 20, high = 23 }
[friction]
angle_deg = { distribution = "normal", mean = 10, std = 1 }
[rotation]
[centripetal]
[cohesion]
cohesion_kPa = { distribution = "uniform", low = 0, high = 5 }
[pore_pressure]
pressure_kPa = { distribution = "triangular", low = 0, mode = 1, high = 3 }
"""


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "slope.toml"
    path.write_text(FILE, "utf-8")
    return path


# --- what is uncertain -----------------------------------------------------------------------------------------------


def test_a_file_declares_them(file: Path) -> None:
    """The scene has the medians, in SI units; the schema knows them, and refuses what the reader refuses."""
    scene = read(file)
    assert list(scene.uncertain) == ["radius", "theta_2", "unit_weight", "friction", "pore_pressure.pressure",
                                    "cohesion.cohesion"]  # fmt: skip
    medians = scene.friction, scene.arc.unit_weight, scene.called["cohesion"]["cohesion"]
    expected = math.tan(math.radians(10)), 1e3 * stats.triang(0.4, 18, 5).median(), 2500.0
    assert medians == pytest.approx(expected, rel=1e-14)
    assert ensemble(scene, 2000, 1).samples["arc.theta_2_deg"].min() >= 274
    document = tomllib.loads(FILE)
    validator = jsonschema.Draft202012Validator(schema())
    validator.validate(document)
    document["arc"]["radius_m"] = {"distribution": "gauss", "mean": 1, "std": 1}
    assert not validator.is_valid(document)


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"friction.angel_deg": ANGLE}, "did you mean friction.angle_deg"),
        ({"drag.xi_m_s2": ANGLE}, "drag.xi_m_s2: the scene has no value of it to vary"),
        ({"friction.angle_deg": 3.0}, "must be a distribution"),
        ({"friction.angle_deg": ANGLE, "friction": stats.norm(0.2, 0.01)}, "says the same"),
        ({"arc.radius_m": {"distribution": "uniform", "low": -1, "high": 5}}, "reaches down to -1"),
        ({}, "the scene has no uncertain parameter"),
        ({"arc.radius_m": {"distribution": "normal", "mean": 1000, "std": 800}}, "arc.radius_m: 11 % of its distribu"),
    ],
)
def test_distributions_that_are_refused(given: dict[str, Any], said: str) -> None:
    with pytest.raises(ValueError, match=re.escape(said)):
        ensemble(replace(VAIONT, uncertain=given), 10)
    with pytest.raises(ValueError, match=r"(?s)n = 0.*method = 'lhs'.*confidence = 2"):
        ensemble(ONE, 0, method="lhs", confidence=2)


TIME = np.arange(0.0, 10.0, 0.01)
RECORD = Series(TIME, 0.2 * np.sin(5 * TIME), held=False)
PULSE = load("newmark-pulse")


def shaken(**more: Any) -> Scene:
    return replace(PULSE, effects={"shaking": {"horizontal": RECORD, **more}}, end_time=None)


def run_outs(scene: Scene, key: str, levels: list[float]) -> Any:
    return grid(scene, {key: levels}).samples["run_out"]


def test_a_law_of_speed_that_multiplies_varies() -> None:
    law: dict[str, Any] = {"law": "linear", "peak": 0.24, "residual": 0.2, "length": 3.0}
    rate = {"law": "rate_weakening", "peak": 1.0, "velocity": 2.0}
    scene, other = (replace(VAIONT, friction=law | {"rate": rate | {"residual": x}}) for x in (0.5, 0.7))
    assert run_outs(scene, "friction.rate.residual", [0.7]) == pytest.approx([solve(other).run_out], rel=1e-11)


def test_what_shakes_varies_everywhere() -> None:
    """An amplitude, a scale or a peak: as if the record had been given so."""
    pulse = PULSE.called["shaking"]
    one = [solve(replace(PULSE, effects={"shaking": {**pulse, "amplitude": a}})).run_out for a in (0.1, 0.3, 0.5)]
    assert run_outs(PULSE, "shaking.amplitude_g", [0.1, 0.3, 0.5]) == pytest.approx(one, rel=1e-9)
    assert backanalyse(PULSE, run_out=one[1], field="shaking.amplitude_g").value == pytest.approx(0.3, rel=1e-9)
    double = replace(PULSE, effects={"shaking": {"horizontal": RECORD.scaled(2.0)}}, end_time=None)
    expected = pytest.approx([solve(shaken()).run_out, solve(double).run_out], rel=1e-9)
    for scene in (shaken(), shaken(scale=3.0), shaken(peak=0.7)):
        assert run_outs(scene, "shaking.scale", [1, 2]) == expected
        assert run_outs(scene, "shaking.peak_g", [RECORD.greatest, 2 * RECORD.greatest]) == expected
    assert solve(shaken(scale=np.array([1.0, 2.0]))).run_out == expected
    with pytest.raises(ValueError, match="scale and peak exclude each other"):
        shaken(scale=1.0, peak=0.4)
    with pytest.raises(ValueError, match=r"shaking.duration_s: the scene has no value .* shaking.amplitude_g"):
        run_outs(PULSE, "shaking.duration_s", [1.0])


@pytest.mark.usefixtures("unseen")
def test_pairs_are_correlated() -> None:
    """The correlation of the normal scores is the one asked for; the marginals are what they were; linear too."""
    normal = {"distribution": "normal", "mean": 22, "std": 1}
    held = {"distribution": "lognormal", "mean": 5, "std": 2}
    pair = ("friction.angle_deg", "cohesion.cohesion_kPa")
    scene = replace(load("wet-slope"), uncertain=dict(zip(pair, (normal, held), strict=True)))
    study = ensemble(scene, 4096, 1, method="sobol", correlation={pair: -0.6})
    x, y = (study.samples[k] for k in pair)
    assert np.corrcoef(x, np.log(y))[0, 1] == pytest.approx(-0.6, abs=0.01)
    assert (np.mean(x), np.std(x), np.mean(y)) == pytest.approx((22.0, 1.0, 5.0), rel=1e-2)
    assert study.linear["run_out"].std == pytest.approx(study.std("run_out").value, rel=0.1)
    assert not study.sensitivity
    said = f"correlation of {pair[0]} with {pair[1]} -0.6"
    assert said in study_report(study, b"", "slipcircle sweep")
    assert study.to_dict()["correlation"] == [{"key": pair[0], "with": pair[1], "value": -0.6}]
    wrongs = {
        "must be between -1 and 1": {pair: 1.5},
        "not uncertain": {(pair[0], "x"): 0.1},
        "must be a mapping from pairs": {pair[0]: 0.1},
    }
    for words, wrong in wrongs.items():
        with pytest.raises(ValueError, match=words):
            ensemble(scene, 16, 1, correlation=cast(Any, wrong))


def test_peak_and_scale_of_a_record_do_not_vary_together() -> None:
    scene = replace(load("vaiont"), effects={"shaking": {"horizontal": RECORD, "scale": 1.0}}, end_time=1.0)
    with pytest.raises(ValueError, match=r"shaking\.scale and shaking\.peak exclude each other: .*; vary one"):
        grid(scene, {"shaking.scale": [1.0, 2.0], "shaking.peak_g": [0.3, 0.6]})


def test_names_of_settings_are_checked() -> None:
    """Settings are checked also if the call has no records and ignores them."""
    scene = replace(load("vaiont"), uncertain={"friction.angle_deg": {"distribution": "normal", "mean": 9, "std": 1}})
    settings: list[tuple[dict[str, Any], str]] = [
        ({"scales": [1]}, r"scales = \[1\]: is for records; give records"),
        ({"records": [], "polarities": 3}, "polarities = 3: must be True or False"),
        ({"search_each": "no"}, "search_each = 'no': must be True or False"),
    ]
    for given, words in settings:
        with pytest.raises(ValueError, match=words):
            ensemble(scene, 8, 1, **given)


def factors_of_samples(study: Study) -> dict[str, Any]:
    """Factors of safety of the kept samples, by method."""
    values = {n: u.to_si(study.samples[u.key]) for n, u in study.design.inputs.items()}
    return dict(factors_of_safety(motions(study.scene, values).plan.scene))


# --- linear propagation ----------------------------------------------------------------------------------------------


WATERED = """
[ground]
points_m = [[0, 25], [30, 25], [50, 35], [90, 35]]
unit_weight_kN_m3 = 20
[circle]
centre_m = [40, 40]
radius_m = 12
[friction]
angle_deg = { distribution = "uniform", low = 5, high = 60 }
[cohesion]
cohesion_kPa = 1
[pore_pressure]
ratio = { distribution = "uniform", low = 0.0, high = 0.95 }
"""


def test_a_method_without_a_factor_widens_the_probability_of_failure(tmp_path: Path) -> None:
    """Bishop's equation has no root for some samples: between none and all of them fail, (Clopper and Pearson)."""
    path = tmp_path / "watered.toml"
    path.write_text(WATERED, "utf-8")
    study = ensemble(from_method(read(path), "paper"), 512, 1, sensitivity=0)
    factors = factors_of_samples(study)["bishop"]
    failing, unknown = int(np.sum(factors < 1.0)), int(np.sum(np.isnan(factors)))
    assert failing > 200
    assert unknown > 20
    low = stats.binomtest(failing, 512).proportion_ci().low
    high = stats.binomtest(failing + unknown, 512).proportion_ci().high
    probability = study.failure["bishop"]
    assert math.isnan(probability.value)
    assert (probability.low, probability.high) == pytest.approx((low, high), rel=1e-12)
    assert study.factor_quantile("bishop", 0.5).value == pytest.approx(np.nanmedian(factors), rel=0.02)


def test_shares_of_a_grid_are_of_the_combinations_that_have_a_factor(records: Any, tmp_path: Path) -> None:
    path = tmp_path / "watered.toml"
    path.write_text(WATERED, "utf-8")
    (found,) = records("sweep", path, "--grid friction.angle_deg=5:60:9 --grid pore_pressure.ratio=0:0.95:9")
    factors = [row["factor of safety, bishop"] for row in found["rows"]]
    known = [factor for factor in factors if factor is not None]
    assert 0 < len(known) < len(factors) - 3
    shares = found["factors_of_safety"]["bishop"]
    assert shares["below_1"] == sum(factor < 1.0 for factor in known) / len(known)
    assert shares["quantile_0.5"] == sorted(known)[math.ceil(len(known) / 2) - 1]


@pytest.mark.parametrize("method", ["monte-carlo", "sobol"])
def test_linear_propagation_of_narrow_inputs(method: str) -> None:
    """Moments are those of the samples: nothing to warn of."""
    given: Any = {"friction.angle_deg": stats.norm(14, 0.05), "arc.radius_m": stats.uniform(1490, 10)}
    study = ensemble(replace(VAIONT, uncertain=given), 4096, 2, method=method)
    for name in OUTCOMES:
        linear = study.linear[name]
        mean, std = study.mean(name), study.std(name)
        width = mean.high - mean.low
        # Twice the interval, and what is of second order, which a Sobol sequence is good enough to show.
        assert abs(linear.mean - mean.value) <= width + 0.01 * linear.std
        assert width < (0.1 if method == "monte-carlo" else 0.01) * linear.std
        assert std.value == pytest.approx(linear.std, rel=0.05 if method == "monte-carlo" else 0.01)
    assert (study.warnings, study.no_linear) == ([], "")


@pytest.mark.parametrize(("mean", "moves"), [(20.0, True), (24.0, False)])
def test_linear_propagation_next_to_the_limit(mean: float, moves: bool) -> None:
    """Linear propagation warns if a part of the samples does not move, which derivatives at the means cannot show."""
    study = ensemble(replace(VAIONT, uncertain={"friction.angle_deg": stats.norm(mean, 2.5)}), 4096, 2)
    for name in OUTCOMES:
        linear, std = study.linear[name].std, float(np.std(study.samples[name]))
        assert (abs(linear - std) > 0.05 * std, linear > 0.0) == (True, moves)
        (warning,) = (w for w in study.warnings if w.startswith(name.replace("run_", "run-").replace("_", " ")))
        assert "use the samples" in warning


def test_where_nothing_is_propagated() -> None:
    """Inputs without moments are named; an input without effect causes no disagreement by rounding."""
    found = ensemble(replace(VAIONT, uncertain={"friction": stats.pareto(2, scale=0.05)}), 20, 1)
    assert dict(found.linear) == {}
    assert "not have a finite mean" in found.no_linear
    assert json.dumps(export.study_record(found), allow_nan=False)
    assert ensemble(replace(VAIONT, uncertain={"arc.unit_weight_kN_m3": stats.norm(20, 1)}), 500, 1).warnings == []


# --- what an ensemble finds ------------------------------------------------------------------------------------------


@pytest.mark.parametrize("method", ["monte-carlo", "sobol"])
def test_quantiles_of_a_monotone_answer(method: str) -> None:
    """Run-out and peak velocity fall as friction grows, so that their quantiles are known.

    Sobol sequences in one dimension differ by less than a sample, and have no interval.
    """
    mean = math.degrees(math.atan(solve(VAIONT).limit_friction)) - 1
    scene = replace(VAIONT, uncertain={"friction.angle_deg": stats.Normal(mu=mean, sigma=2)})
    study = ensemble(scene, 65536, 11, method=method, sensitivity=0)
    error = 0.02 if method == "monte-carlo" else 1e-3
    has_interval = method == "monte-carlo"
    assert study.moving.value == pytest.approx(stats.norm.cdf(0.5), abs=5e-3 if has_interval else 1e-4)
    assert has_interval == (study.moving.low <= stats.norm.cdf(0.5) <= study.moving.high)
    assert study.quantile("run_out", 0.3).value == 0.0
    for p in (0.5, 0.95):
        motion = solve(replace(VAIONT, friction=math.tan(math.radians(stats.norm(mean, 2).ppf(1 - p)))))
        for name, value in (("run_out", motion.run_out), ("peak_velocity", motion.peak.velocity)):
            estimate = study.quantile(name, p)
            assert estimate.value == pytest.approx(value, rel=error)
            assert has_interval == (estimate.low <= value <= estimate.high)
    widths = [c.median.high - c.median.low for c in study.convergence]
    assert has_interval == (widths[-1] < widths[-4])
    assert study.convergence[-1].n == 65536
    curve = study.exceedance("run_out")
    assert has_interval == bool(np.all((curve.low <= curve.probability) & (curve.probability <= curve.high)))
    samples = np.sort(study.samples["run_out"])
    np.testing.assert_allclose(curve.probability, 1 - np.searchsorted(samples, curve.at) / 65536, atol=1e-14)


def test_what_is_no_scene_is_counted_apart() -> None:
    """An end of the arc before its start."""
    study = ensemble(replace(VAIONT, uncertain={"arc.theta_2_deg": stats.uniform(205, 75)}), 4000, 1)
    invalid = np.sum(study.samples["arc.theta_2_deg"] < 215.2)
    assert invalid == study.counts[Status.INVALID] > 300
    assert study.n == 4000 - invalid == export.study_record(study)["valid_samples"]
    (first, *_) = np.flatnonzero(study.samples["arc.theta_2_deg"] < 215.2)
    with pytest.raises(ValueError, match="theta_2") as refused:
        study[int(first)]
    assert f"{invalid} of 4000 samples are not valid scenes and not counted: {refused.value}" in study.warnings[0]
    assert study.failure["paper"].value == study.moving.value
    nothing = ensemble(replace(VAIONT, uncertain={"arc.theta_2_deg": stats.norm(190, 1)}), 10, 1)
    assert (nothing.n, math.isnan(nothing.moving.value)) == (0, True)
    assert json.dumps(export.study_record(nothing), allow_nan=False)
    assert export.rows(nothing)


SLOPE = """
[ground]
points_m = [[0, 25], [30, 25], [50, 35], [90, 35]]
unit_weight_kN_m3 = 20
[circle]
critical = "bishop"
[friction]
angle_deg = { distribution = "normal", mean = 20, std = 2 }
[cohesion]
cohesion_kPa = { distribution = "lognormal", mean = 5, std = 1.5 }
"""


@pytest.mark.parametrize("method", ["monte-carlo", "sobol"])
def test_what_slides_without_a_result_moves(method: str, tmp_path: Path) -> None:
    """Frozen geometry: whatever moves slides for ever, beyond every threshold, and has no mean."""
    path = tmp_path / "slope.toml"
    path.write_text(SLOPE, "utf-8")
    study = ensemble(from_method(read(path), "paper"), 1024, 1, method=method)
    sliding = int(study.counts[Status.ENDLESS])
    assert sliding == study.without_result > 100
    assert (study.n, study.moving.value, study.failure["paper"]) == (1024, sliding / 1024, study.moving)
    factors = factors_of_samples(study)
    assert {m: study.failure[m].value for m in METHODS} == {m: np.mean(factors[m] < 1.0) for m in METHODS}
    run_out = json.loads(json.dumps(study.to_dict(), allow_nan=False))["outputs"]["run_out"]
    assert [q["value"] for q in run_out["quantiles"]] == [0.0] * 4 + ["beyond"] * 4
    assert (run_out["mean"]["value"], run_out["linear"]) == (None, None)
    assert math.isnan(study.sensitivity["run_out"].first[0].value)
    assert 0.0 < study.sensitivity["moves"].first[0].value < 1.0
    assert ["quantile", "run_out", "", 0.99, "beyond", "beyond", "beyond"] in export.rows(study)
    assert any("count as moving and as exceeding every threshold" in w for w in study.warnings)


def test_a_part_without_a_result_ends_the_curve() -> None:
    """Some of these turn over: the exceedance probability does not fall below that share."""
    fast = replace(VAIONT, initial_velocity=20.0, uncertain={"initial_velocity": stats.uniform(50, 230)})
    study = ensemble(fast, 2000, 1)
    share = study.without_result / 2000
    assert 0 < share < 0.5
    assert study.exceedance("run_out").probability[-1] >= share
    assert study.quantile("run_out", 1 - share).value == np.nanmax(study.samples["run_out"])
    assert study.quantile("run_out", 1 - share + 5e-4).value == math.inf


@pytest.mark.parametrize("n", [1, 15, 17, 65, 130])
@pytest.mark.parametrize("method", ["monte-carlo", "sobol"])
def test_blocks_fill_the_arrays_once(method: str, n: int) -> None:
    """Whatever the shares of the replicates; and samples and base points of indices are drawn apart."""
    design = ensemble(ONE, n, 1, method=method, sensitivity=34, size=4).design
    filled = np.zeros(design.shape, dtype=int)
    for block in range(design.blocks):
        filled[design.place(block)] += 1
    assert filled.size == sum(map(design.scenes, range(design.blocks))) == n + 3 * 34
    assert np.all(filled == 1)
    streams = [design.piece(block)[0] for block in range(design.blocks)]
    assert not {*streams[: design.sample_blocks]} & {*streams[design.sample_blocks :]}


def test_indices_of_a_scene(file: Path) -> None:
    """Indices by Monte Carlo and by Sobol points agree with conditional means of plain samples."""
    scene = read(file)
    plain, quasi = (ensemble(scene, 2**13, 1, method=m, sensitivity=2048) for m in ("monte-carlo", "sobol"))
    values = plain.samples["run_out"]
    for k, u in enumerate(scene.uncertain.values()):
        means = values[np.argsort(plain.samples[u.key])].reshape(64, -1).mean(axis=1)
        given_data = (means.var() - values.var() / 128) / values.var()
        for first in (study.sensitivity["run_out"].first[k] for study in (plain, quasi)):
            assert first.low - 0.02 <= given_data <= first.high + 0.02


# --- the command -----------------------------------------------------------------------------------------------------


def test_the_command_prints_and_writes_the_estimates_of_a_study(file: Path, tmp_path: Path, asked: Any) -> None:
    line = f"sweep {file} --samples 3e3 --seed 4 --sensitivity 64"
    table, arrays = tmp_path / "a.csv", tmp_path / "a.npz"
    _, out, err = asked(line, "--json --csv", table, "--npz", arrays)
    assert re.search(r"of \d+ scenes, .* a second", err)
    study: Study = ensemble(read(file), 3000, 4, sensitivity=64)
    assert json.loads(out) == [{"format": JSON_FORMAT} | json.loads(json.dumps(export.study_record(study)))]
    held = np.load(arrays)
    np.testing.assert_array_equal(held["run_out"], study.samples["run_out"])
    assert study.quantile("run_out", 0.5).value in held["run_out"]
    head, *rows = table.read_text("utf-8").splitlines()
    assert (head, len(rows)) == ("table,output,input,at,value,low,high", len(export.rows(study)))
    printed = " ".join(asked(line)[1].split())
    assert f"{study.quantile('run_out', 0.5).value:.4g} [" in printed
    for heading in ("How safe, how far and how fast", "Mean and standard deviation", "Sensitivity indices"):
        assert heading in printed
    assert "Convergence" not in printed
    assert "Convergence" in asked(line, "--verbose")[1]
    assert "solved at the median of arc.radius_m, arc.theta_2_deg" in asked("run", file)[2]


def test_a_grid_is_printed_written_and_resumed(tmp_path: Path, said: Any, asked: Any, records: Any) -> None:
    table, line = tmp_path / "a.csv", "sweep vaiont --grid friction.angle_deg=8:12:41 --grid arc.radius_m=1000,1500"
    for _ in range(2):  # the second time from the blocks of the first
        out = said(line, "--csv", table, "--resume", tmp_path / "blocks")
    head, _, *rows = (row.split() for row in out.splitlines()[1:44])
    assert (head, len(rows)) == (["friction.angle_deg", "1000", "1500"], 41)
    for angle, *run_outs in rows[::20]:
        friction = math.tan(math.radians(float(angle)))
        for radius, run_out in zip((1000.0, 1500.0), run_outs, strict=True):
            scene = replace(VAIONT, arc=replace(VAIONT.arc, radius=radius), friction=friction)
            assert f"{solve(scene).run_out:.4g}" == run_out
    assert "comes to rest: 82" in out
    assert np.load(tmp_path / "blocks" / "run_out.npy").size == 82
    head, *rows = table.read_text("utf-8").splitlines()
    outcomes = "run_out (m),peak_velocity (m/s),duration (s)"
    assert head == f'friction.angle_deg,arc.radius_m,{outcomes},"factor of safety, paper",status,reason'
    assert len(rows) == 82
    # The paper's factor is proportional to the friction; each of three combinations counts alike.
    factors = records("sweep vaiont --grid friction.angle_deg=8,12,20")[0]["factors_of_safety"]["paper"]
    low, middle, high = np.tan(np.radians([8, 12, 20])) / solve(VAIONT).limit_friction
    assert (factors["quantile_0.5"], factors["quantile_0.95"]) == pytest.approx((middle, high), rel=1e-12)
    assert factors["below_1"] == np.mean([low < 1, middle < 1, high < 1])
    _, out, err = asked("sweep vaiont --grid friction.angle_deg=1e-9,10")
    assert "still moving" in out
    assert "1 of 2 scenes still move at their end" in err


@pytest.mark.parametrize(
    ("more", "told"),
    [
        ("--samples 10", "the scene has no uncertain parameter"),
        ("--uncertain friction.angle_deg=normal:10:1 --samples 1e300", "a whole number of samples, from 1 to 1e+12"),
        ("--grid friction.angle_deg=1:2", "must be KEY=FROM:TO:COUNT"),
        ("--grid friction.angel_deg=1:2:3", "did you mean friction.angle_deg"),
        ("--grid friction.angle_deg=1 --scheduler tcp://127.0.0.1:1 --workers 2", "leave out --workers"),
        ("--grid friction.angle_deg=1,2 --grid friction.angle_deg=3", "each key once"),
        ("--grid friction.angle_deg=8:12:9999 --grid arc.radius_m=1:9:9999", "at most 67108864"),
        ("--grid friction.angle_deg=1:2:1000000000000", "not enough memory"),
        ("--grid friction.angle_deg=1 --engine threads --workers 0", "--workers 0: must be at least 1"),
        ("--grid friction.angle_deg=1 --csv /no/such/place.csv", "there is no folder /no/such"),
        ("--samples 9 --uncertain friction.angle_deg=normal:1", "normal:mean:std, lognormal:mean"),
        ("--samples 9 --uncertain friction.angel_deg=normal:1:1", "did you mean friction.angle_deg"),
    ],
)
def test_what_sweep_refuses(more: str, told: str, refused: Any) -> None:
    assert told in refused("sweep vaiont", more)
