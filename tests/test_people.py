"""What new users tripped over: commands of the README, true words for each mistake, one vocabulary, odd scene files."""

import ast
import json
import os
import re
import shlex
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from concurrent.futures import BrokenExecutor, CancelledError
from dataclasses import replace
from pathlib import Path
from random import Random
from typing import Any, assert_type

import fuzz_scenes
import numpy as np
import pytest

import generated
import slipcircle
from generated.effects import EFFECTS, LAWS
from slipcircle import Arc, Motion, Scene, Unattainable, backanalyse, ensemble, grid, load, plan, solve
from slipcircle.__main__ import main
from slipcircle.base.kinds import Array
from slipcircle.base.series import Series
from slipcircle.files.scenefile import shipped
from slipcircle.motion.quantities import known
from slipcircle.records.records import read_record
from slipcircle.scene.keys import tables_of

ROOT = Path(__file__).parents[1]
README = (ROOT / "README.md").read_text("utf-8")
VAIONT = load("vaiont")
ARC = "[arc]\nradius_m = 60\ntheta_1_deg = 215\ntheta_2_deg = 280\nunit_weight_kN_m3 = 19\n"
FRICTION = "[friction]\nangle_deg = 12\n"


@pytest.fixture
def run(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> Callable[..., tuple[int, str, str]]:
    """A command over a scene's text, with what it returns and says."""

    def command(text: str, *argv: str, name: str = "run") -> tuple[int, str, str]:
        path = tmp_path / "slope.toml"
        path.write_text(text, "utf-8")
        status = main([name, str(path), *argv])
        return status, *capsys.readouterr()

    return command


# --- 1, what was wrong or misleading ---------------------------------------------------------------------------------


def commands() -> list[str]:
    """The README's commands with the arguments that stand in their rows, optional ones too."""
    found = []
    for row in (line.split(" | ") for line in README.splitlines() if line.startswith("| `slipcircle")):
        base = row[0].strip("| `").replace("\\|", "|")
        options = re.findall(r"\[([^]]*)\]", base)
        plain = re.sub(r"\[[^]]*\]", "", base)
        more = [x for x in re.findall(r"`(--[^`]* [^`]*)`", row[1]) if "=" in x or "+-" in x]
        for extra in ["", *options, *more]:
            if extra.startswith("NAME") or plain.startswith("slipcircle cost"):
                continue
            rest = plain if "+-" not in extra else plain.partition(" --run-out-m")[0]
            first = extra.split("|")[0]
            found.append(f"{rest} {first}")
    return sorted(set(found))


def test_the_readme_has_its_commands() -> None:
    asked = commands()
    assert len(asked) > 15
    assert any("--field cohesion.cohesion_kPa" in c for c in asked)
    assert any("--correlation" in c for c in asked)


@pytest.mark.parametrize("line", commands())
def test_every_command_of_the_readme_runs(line: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
                                          capsys: pytest.CaptureFixture[str]) -> None:  # fmt: skip
    monkeypatch.chdir(tmp_path)
    Path("SLOPE.toml").write_text("[ground]\nheight_m = 10\nangle_deg = 26.6\nunit_weight_kN_m3 = 20\n[friction]\n"
                                  "angle_deg = 19.6\n[cohesion]\ncohesion_kPa = 3\n", "utf-8")  # fmt: skip
    if "--correlation" in line:
        drawn = "--uncertain friction.angle_deg=normal:10:1 --uncertain cohesion.cohesion_kPa=uniform:1:2"
        line = line.replace("vaiont", "wet-slope").replace("SCENE", "wet-slope") + f" {drawn}"
    elif "--samples" in line and "--uncertain" not in line:
        line += " --uncertain friction.angle_deg=normal:10:1"
    line = re.sub(r"\bN\b", "64", line.replace("SCENE ...", "SCENE")).replace("SCENE", "vaiont")
    assert main(shlex.split(line)[1:]) == 0, capsys.readouterr().err
    assert capsys.readouterr().out


def test_least_squares_of_the_readme() -> None:
    """It starts where something moves, meets both, and says what is hardly told; where nothing comes near, how far."""
    asked: dict[str, Any] = {"run_out": (400.0, 20.0), "duration": (40.0, 5.0),
                             "field": ["friction.angle_deg", "cohesion.cohesion_kPa"]}  # fmt: skip
    found = backanalyse(VAIONT, **asked)
    assert found.solutions[0].chi_square < 1.0
    assert solve(found.motion.plan.scene).run_out == pytest.approx(400.0, abs=20.0)
    assert any("cohesion.cohesion_kPa" in w and "told" in w for w in found.warnings)
    assert len(found.solutions) == 1
    with pytest.raises(Unattainable, match=r"the nearest is run_out = .* standard errors off"):
        backanalyse(load("wet-slope"), **asked)


ODD: dict[str, tuple[str, str]] = {
    "a list without times": (ARC + FRICTION + "[rotation]\n[pore_pressure]\npressure_kPa = [0, 20, 50]\n",
                             "pore_pressure.pressure_kPa = [0, 20, 50]: is a list, which needs its times"),
    "an empty list": (ARC + FRICTION + "[pore_pressure]\nratio = []\n", "pore_pressure.ratio = []: is a list, which"),
    "a list of times for one number": (ARC + FRICTION + "[pore_pressure]\nratio = 0.1\ntime_s = [0, 1]\n",
                                       "time_s and ratio or pressure: must be lists"),
    "a huge radius": (ARC.replace("= 60", "= 1e103") + FRICTION, "arc.radius_m = 1e+103: must be a number above 0 (m): "
                      "radius of the slip circle; between 1e-06 and 1e+20: is that another unit?"),
    "a tiny radius": (ARC.replace("= 60", "= 5e-324") + FRICTION, "arc.radius_m = 5e-324: must be a number above 0"),
    "a huge weight": (ARC.replace("= 19", "= 1e300") + FRICTION, "arc.unit_weight_kN_m3 = 1e+300: must be"),
    "a huge amplitude": (ARC + FRICTION + "[shaking]\npulse = 'sine'\namplitude_g = 1e25\nduration_s = 1\n",
                         "shaking.amplitude_g = 1e+25: must be a number: greatest k_h of the pulse, positive "
                         "down-slope; between -1e+12 and 1e+12"),
    "phi_deg": (ARC + "[friction]\nphi_deg = 12\n", "friction.phi_deg = 12: is unknown; did you mean angle_deg?"),
    "peak_deg": (ARC + "[friction]\npeak_deg = 12\n", "friction.peak_deg = 12: is unknown; it belongs to law = "),
    "a stiff layer": (ARC + FRICTION + "[rotation]\n[viscosity]\nviscosity_Pa_s = 1e12\nthickness_m = 0.01\n", "give"),
}  # fmt: skip


@pytest.mark.parametrize(("text", "said"), ODD.values(), ids=ODD)
def test_odd_numbers_are_refused_in_true_words(run: Any, text: str, said: str) -> None:
    for command in ("run", "plan", "sensitivity"):
        status, out, err = run(text, name=command)
        if command == "plan" and said == "give":  # a plan does not solve
            continue
        assert (status, out) == (1, "")
        assert said in err
        assert err.count("\n") == 1


def test_bounds_hold_in_python_too() -> None:
    """The same limits of each unit, from the one declaration."""
    for bad in (1e103, 5e-324):
        with pytest.raises(ValueError, match=r"radius = .*: must be a positive length in m, between 1e-06 and 1e\+20"):
            Arc(bad, 3.8, 4.9, 2e4)
    with pytest.raises(ValueError, match=r"cohesion = 1e\+30: must be .*, between 0 and 1e\+15"):
        Scene(VAIONT.arc, 0.1, {"cohesion": {"cohesion": 1e30}})
    tables = [e.parameters for e in EFFECTS.values()] + [law.parameters for law in LAWS.values()]
    for parameters in tables:
        assert all(p.upper < 1e21 for p in parameters if p.key and p.kind in ("number", "list", "series"))


@pytest.mark.parametrize("work", [solve, plan, lambda s: backanalyse(s, run_out=1.0), lambda s: ensemble(s, 3),
                                  lambda s: grid(s, {"friction": [1.0]})])  # fmt: skip
def test_a_name_is_no_scene(work: Callable[[Any], Any]) -> None:
    with pytest.raises(ValueError, match=r"scene = 'vaiont': must be a Scene; load\('vaiont'\)"):
        work("vaiont")


DRAWN = replace(VAIONT, uncertain={"friction.angle_deg": {"distribution": "normal", "mean": 10, "std": 1}})
ANY: Any = slipcircle  # whose types no checker holds
CHANGED: Any = replace


@pytest.mark.parametrize(
    ("work", "said"),
    [
        *((lambda x=x: ANY.load(x), "scene .*: must be the name of one that ships, or the path of its file")
          for x in (3, None, b"vaiont", ["a"], VAIONT)),
        *((lambda f=f, x=x: getattr(ANY, f)(x, 3), f"scene = {x}: must be a Scene; load")
          for f in ("ensemble", "grid") for x in (None, 3)),
        *((lambda x=x: ANY.solve(x), f"scene = {x}: must be a Scene; load") for x in (None, 3)),
        *((lambda x=x: ANY.solve(VAIONT, x), "accuracy = .*: must be a relative error") for x in ("a", 2, [1e-9])),
        (lambda: CHANGED(VAIONT, accuracy=[1e-9]), "accuracy = .*: must be a relative error"),
        *((lambda n=n: ANY.ensemble(DRAWN, 3, **{n: "a"}), f"{n} = 'a': must be")
          for n in ("method", "confidence", "size", "sensitivity", "correlation", "rng")),
        (lambda: ANY.grid(VAIONT, 3), "levels = 3: must be a mapping"),
        (lambda: ANY.grid(VAIONT, {"friction": ["a"]}), "friction: must be a list of numbers"),
        (lambda: ANY.backanalyse(VAIONT, run_out=300.0, field=3), "field = 3, bounds = None: must be a key"),
        (lambda: ANY.backanalyse(VAIONT, run_out=300.0, bounds=3), "bounds = 3: must be a key"),
        (lambda: CHANGED(VAIONT, uncertain=3), "uncertain = 3: must be a mapping"),
        (lambda: CHANGED(VAIONT.arc, given=3), "given = 3: must be a mapping"),
        (lambda: solve(VAIONT).to_dict("a"), "times = 'a': must be times in s"),
    ],
)  # fmt: skip
def test_a_call_of_the_wrong_kind_is_one_error(work: Callable[[], Any], said: str) -> None:
    with pytest.raises(ValueError, match=said) as found:
        work()
    assert "\n" not in str(found.value)


def test_a_number_of_samples_that_nothing_has(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["sweep", "vaiont", "--uncertain", "friction.angle_deg=normal:10:1", "--samples", "1e300"]) == 1
    assert "must be a whole number of samples, from 1 to 1e+12" in capsys.readouterr().err


def broken(_: Any) -> Any:
    raise KeyError("a")


@pytest.mark.parametrize(
    ("law", "said"),
    [
        (lambda s: np.nan * np.asarray(s), r"\(.*\) = nan: must be a number of at least 0"),
        (lambda s: np.where(np.asarray(s) > 100.0, np.nan, 0.2), r"\(1\d\d.*\) = nan"),
        (lambda s: 0.2 - np.asarray(s) / 100.0, r"\(2.*\) = -0\.\d+: must be a number of at least 0"),
        (lambda s: np.zeros(3), r"returns shape \(3,\) for an argument of shape"),
        (lambda s: 0.2 if s < 10 else 0.1, "must take an array of numbers and return one; it says ValueError"),
        (lambda s: "a", "must take an array of numbers and return one"),
        (lambda s: 1j * np.asarray(s), "it says ValueError: complex numbers"),
        (lambda: 0.2, "it says TypeError"),
        (broken, "it says KeyError"),
        (lambda s: np.inf + np.asarray(s), "= inf: must be"),
        (lambda s: 0.2 + 0.01 * np.random.default_rng().random(np.shape(s)), "changes too sharply"),
    ],
)
def test_a_bad_friction_function_is_one_error(law: Any, said: str) -> None:
    with pytest.raises(ValueError, match=f"^friction.*{said}"):
        solve(Scene(VAIONT.arc, law, ["rotation"]))


def test_what_was_diagnosed_wrongly(run: Any, capsys: pytest.CaptureFixture[str]) -> None:
    turning = ARC + FRICTION + "[rotation]\n"
    assert "friction is next" not in run("accuracy = 1e-30\n" + turning)[2]
    assert "no result in float64 is sure to less" in run("accuracy = 1e-30\n" + turning)[2]
    assert main(["backanalyse", "vaiont", "--duration-s", "-5"]) == 1
    assert "duration = -5.0: must be a positive number" in capsys.readouterr().err
    with pytest.raises(SystemExit):
        main(["backanalyse", "vaiont", "--run-out-m", "abc"])
    assert "abc: must be a number, or one with its error" in capsys.readouterr().err
    level = run(turning.replace("215", "260"))[1]
    assert re.search(r"factor of safety +infinite", level)
    stands = run(turning.replace("= 12", "= 42"))
    assert "after 0 s" not in "".join(stands[1:])
    assert "-0" not in stands[1].replace("e-0", "").replace("left-0", "")
    carried = run(turning + "[pore_pressure]\npressure_kPa = 500\n")
    assert "still moving" not in carried[1] or carried[0] == 1


def test_rows_without_an_answer_say_why(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["sweep", "vaiont", "--grid", "friction.angle_deg=1e-9,10"]) == 0
    out, err = capsys.readouterr()
    assert "endless" in out
    assert "1 of 2 samples have no answer and are left out: it never rests" in err


@pytest.fixture
def scheduler(engine: str) -> Iterator[list[str]]:
    """What an engine is told of its workers; of Dask a cluster on loopback."""
    if engine != "dask":
        yield ["--workers", "2"]
        return
    distributed = pytest.importorskip("distributed")
    with distributed.LocalCluster(
        n_workers=1, threads_per_worker=1, processes=True, host="127.0.0.1", dashboard_address=":0", silence_logs=50
    ) as cluster:
        yield ["--scheduler", cluster.scheduler_address]


@pytest.mark.parametrize("engine", ["serial", "threads", "processes", "dask"])
def test_ctrl_c_ends_every_engine(engine: str, scheduler: list[str], tmp_path: Path) -> None:
    """The signal goes to all processes, as from a terminal; what is kept begins when the first block is done."""
    line = ["sweep", "vaiont-rate", "--uncertain", "friction.peak_deg=normal:24:1", "--samples", "1e6", "--engine",
            engine, "--block", "256", *scheduler, "--resume", str(tmp_path)]  # fmt: skip
    process = subprocess.Popen([sys.executable, "-m", "slipcircle", *line], cwd=ROOT, start_new_session=True,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)  # fmt: skip
    try:
        while not list(tmp_path.glob("block-*")) and process.poll() is None:
            time.sleep(0.1)
        os.killpg(process.pid, signal.SIGINT)
        out, err = process.communicate(timeout=60)  # a guard; it takes a tenth of a second
    finally:
        if process.poll() is None:
            os.killpg(process.pid, signal.SIGKILL)
    assert (process.returncode, out) == (130, "")
    assert "interrupted; finished blocks are in" in err
    assert "Traceback" not in err


@pytest.mark.parametrize("gone", [BrokenExecutor, CancelledError])
def test_workers_that_are_gone(
    gone: type[Exception], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Of processes and of Dask."""

    def lost(*_: Any) -> None:
        raise gone

    monkeypatch.setattr("slipcircle.outputs.sweep._compute", lost)
    assert main(["sweep", "vaiont", "--grid", "friction.angle_deg=8,10"]) == 1
    assert "a worker died; with --resume FOLDER it could continue" in capsys.readouterr().err


@pytest.mark.parametrize("terminal", [True, False])
def test_no_command_is_silent(
    terminal: bool, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Whatever it computes, with a terminal or without."""
    from slipcircle import __main__ as line

    said = ""

    def work() -> int:
        nonlocal said
        deadline = time.monotonic() + 30.0
        while "work" not in said and time.monotonic() < deadline:
            time.sleep(0.02)
            said += capsys.readouterr().err
        return 0

    assert line.SILENT <= 5.0
    monkeypatch.setattr(sys.stderr, "isatty", lambda: terminal, raising=False)
    monkeypatch.setattr(line, "main", work)
    monkeypatch.setattr(line, "SILENT", 0.01)
    with pytest.raises(SystemExit):
        line.command()
    assert said.startswith(("\r\x1b[K" if terminal else "") + "slipcircle: at work for")
    monkeypatch.setattr(line, "main", lambda: 0)
    monkeypatch.setattr(line, "SILENT", 3600.0)
    capsys.readouterr()
    with pytest.raises(SystemExit):
        line.command()
    assert not capsys.readouterr().err


# --- 2, one vocabulary -----------------------------------------------------------------------------------------------

RECORD = Series(np.arange(0.0, 10.0, 0.01), 0.2 * np.sin(5 * np.arange(0.0, 10.0, 0.01)), held=False)


def shaken(**more: Any) -> Scene:
    return replace(load("newmark-pulse"), effects={"shaking": {"horizontal": RECORD, **more}}, end_time=None)


def test_what_shakes_varies_everywhere() -> None:
    """An amplitude, a scale or a peak: as if the record had been given so."""
    pulse = load("newmark-pulse")
    levels = [0.1, 0.3, 0.5]
    found = grid(pulse, {"shaking.amplitude_g": levels}).samples["run_out"]
    one = [solve(replace(pulse, effects={"shaking": {**pulse.called["shaking"], "amplitude": a}})) for a in levels]
    assert found == pytest.approx([abs(m.run_out) for m in one], rel=1e-9)
    assert backanalyse(pulse, run_out=one[1].run_out, field="shaking.amplitude_g").value == pytest.approx(0.3, rel=1e-9)
    given = solve(shaken())
    double = solve(replace(shaken(), effects={"shaking": {"horizontal": RECORD.scaled(2.0)}}))
    top = float(np.max(np.abs(RECORD.values)))
    for scene in (shaken(), shaken(scale=3.0), shaken(peak=0.7)):
        assert grid(scene, {"shaking.scale": [1, 2]}).samples["run_out"] == pytest.approx(
            [given.run_out, double.run_out], rel=1e-9)  # fmt: skip
        assert grid(scene, {"shaking.peak_g": [top, 2 * top]}).samples["run_out"] == pytest.approx(
            [given.run_out, double.run_out], rel=1e-9)  # fmt: skip
    assert solve(shaken(scale=np.array([1.0, 2.0]))).run_out == pytest.approx([given.run_out, double.run_out], rel=1e-9)
    drawn = replace(shaken(), uncertain={"shaking.peak_g": {"distribution": "uniform", "low": 0.2, "high": 0.4}})
    samples = ensemble(drawn, 16, 1).samples
    k = 3
    alone = solve(shaken(peak=float(samples["shaking.peak_g"][k])))
    assert samples["run_out"][k] == pytest.approx(abs(alone.run_out), rel=1e-8)
    with pytest.raises(ValueError, match="scale and peak exclude each other"):
        shaken(scale=1.0, peak=0.4)


def test_what_does_not_vary_says_what_does() -> None:
    with pytest.raises(ValueError, match=r"shaking.duration_s: the scene has no value .* shaking.amplitude_g"):
        grid(load("newmark-pulse"), {"shaking.duration_s": [1.0]})


def test_a_record_scaled_to_a_peak_in_a_file(run: Any, tmp_path: Path) -> None:
    (tmp_path / "r.csv").write_text(
        "".join(f"{t:.2f},{a:.6f}\n" for t, a in zip(RECORD.time, RECORD.values, strict=True))
    )
    text = ARC + "[friction]\nangle_deg = 30\n[shaking]\nrecord = 'r.csv'\nunits = 'g'\nholds = 'driving'\n"
    peak = json.loads(run(text + "peak_g = 0.4\n", "--json")[1])[0]
    scaled = json.loads(
        run(text + f"scale = {0.4 / float(np.max(np.abs(np.round(RECORD.values, 6))))!r}\n", "--json")[1]
    )[0]
    assert peak["run_out"] == pytest.approx(scaled["run_out"], rel=1e-9)
    assert peak["run_out"] > 0.0


def test_pairs_are_correlated() -> None:
    """The correlation of the normal scores is the one asked for; the marginals are what they were; linear too."""
    normal = {"distribution": "normal", "mean": 22, "std": 1}
    held = {"distribution": "lognormal", "mean": 5, "std": 2}
    drawn = replace(load("wet-slope"), uncertain={"friction.angle_deg": normal, "cohesion.cohesion_kPa": held})
    pair = ("friction.angle_deg", "cohesion.cohesion_kPa")
    found = ensemble(drawn, 4096, 1, method="sobol", correlation={pair: -0.6})
    free = ensemble(drawn, 4096, 1, method="sobol", sensitivity=0)
    x, y = (found.samples[k] for k in pair)
    assert np.corrcoef(x, np.log(y))[0, 1] == pytest.approx(-0.6, abs=0.01)
    assert (np.mean(x), np.std(x)) == pytest.approx((22.0, 1.0), rel=5e-3)
    assert np.mean(y) == pytest.approx(5.0, rel=1e-2)
    # friction and cohesion both hold: what varies against each other spreads less
    assert found.std("reach").value < free.std("reach").value
    assert found.linear["reach"].std < free.linear["reach"].std
    assert found.linear["reach"].std == pytest.approx(found.std("reach").value, rel=0.1)
    assert not found.sensitivity
    for wrong, said in (
        ({pair: 1.5}, "must be between -1 and 1"),
        ({("friction.angle_deg", "x"): 0.1}, "not uncertain"),
    ):
        with pytest.raises(ValueError, match=said):
            ensemble(drawn, 16, 1, correlation=wrong)


def test_one_spelling_of_run_out() -> None:
    for path in [*(ROOT / "slipcircle").rglob("*.py"), ROOT / "README.md"]:
        assert "runout" not in path.read_text("utf-8").lower(), path


def test_the_kernels_have_a_name_of_their_own() -> None:
    from slipcircle import kernels

    assert kernels.__all__ == generated.__all__
    assert all(getattr(kernels, n) is getattr(generated, n) for n in kernels.__all__)


def test_json_is_a_list_in_every_command(run: Any, capsys: pytest.CaptureFixture[str]) -> None:
    for line in ("run vaiont", "plan vaiont", "plan --all", "sensitivity vaiont", "backanalyse vaiont --run-out-m 400",
                 "sweep vaiont --grid friction.angle_deg=8,10", "search real-slope"):  # fmt: skip
        assert main([*line.split(), "--json"]) == 0
        assert isinstance(json.loads(capsys.readouterr().out), list), line


def test_an_old_folder_of_blocks_is_refused(tmp_path: Path) -> None:
    drawn = replace(VAIONT, uncertain={"friction.angle_deg": {"distribution": "normal", "mean": 10, "std": 1}})
    ensemble(drawn, 16, 1, folder=tmp_path)
    held = json.loads((tmp_path / "study.json").read_text())
    del held["correlation"]  # as it was before there were any
    (tmp_path / "study.json").write_text(json.dumps(held))
    with pytest.raises(ValueError, match="blocks of another study: correlation differ"):
        ensemble(drawn, 16, 1, folder=tmp_path)


def test_the_changelog_lists_what_was_renamed() -> None:
    text = (ROOT / "CHANGELOG.md").read_text("utf-8")
    for name in ("--runout-m", "--run-out-m", "shaking.peak_g", "slipcircle.kernels", "pydantic", "--polarities",
                 "--correlation"):  # fmt: skip
        assert name in text, name


# --- 3, results ------------------------------------------------------------------------------------------------------


def test_a_type_checker_tells_one_motion_from_many() -> None:
    """mypy holds the types, the run that they are true."""
    arc, mu = Arc(60.0, 3.8, 4.9, 2e4), np.array([0.1, 0.2])
    one = solve(Scene(arc, 0.2, {"rotation": {}, "pore_pressure": {"ratio": 0.1}}))
    assert_type(one, Motion[float])
    assert_type(solve(load("vaiont")), Motion[float])
    assert_type(solve(replace(VAIONT, friction=0.2)), Motion[float])
    assert_type(one.run_out, float)
    assert isinstance(one.run_out, float)
    many = solve(Scene(arc, mu, ["rotation"]))
    wide = solve(Scene(Arc(np.array([60.0, 70.0]), 3.8, 4.9, 2e4), 0.2, ["rotation"]))
    assert_type(many, Motion[Array])
    assert_type(wide, Motion[Array])
    assert_type(many.run_out, Array)
    for found in (many, wide):
        assert found.run_out.shape == (2,)
    law: dict[str, Any] = {"law": "exponential", "peak": 0.4, "residual": mu, "length": 1.0}
    scene: Scene = load("vaiont")
    assert_type(solve(Scene(arc, law, ["rotation"])), Motion[Any])  # which only running it tells
    assert_type(solve(replace(scene, friction=mu)), Motion[Any])
    with pytest.raises(ValueError, match="shapes do not fit together"):
        replace(load("vaiont"), friction=mu, initial_velocity=np.zeros(3))  # type: ignore[arg-type]


NOTHING = re.compile(r"(?<![\w.])-0(?:\.0*)?(?:e[-+]?\d+)?(?![.\d])")  # a negative zero
MANY_DIGITS = re.compile(r"\d\.\d{9}|\.0{7}")  # that nobody reads


@pytest.mark.parametrize("name", shipped())
def test_no_command_prints_a_negative_zero(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Tables, CSV, JSON and reports of every scene that ships; tables without more digits than people read."""
    monkeypatch.setattr("slipcircle.outputs.pictures.render", lambda *_: b"")
    key = "friction.angle_deg" if isinstance(load(name).friction, float) else "friction.peak_deg"
    drawn = f"--uncertain {key}=normal:22:1 --uncertain initial_velocity_m_s=normal:0:0.01 --samples 32 --seed 1"
    report = f"--csv {tmp_path}/a.csv --report {tmp_path}/a.html"
    for line in (
        f"run {name} --verbose {report}", f"run {name} --json", f"plan {name}" + " --ladder" * (name == "wet-slope"),
        f"sensitivity {name}", f"backanalyse {name} --field {key} --run-out-m 20+-1", f"search {name}",
        f"sweep {name} --grid {key}=5,20,44 --csv {tmp_path}/b.csv", f"sweep {name} {drawn} {report}",
    ):  # fmt: skip
        main(line.split())
        out, err = capsys.readouterr()
        assert "--json" in line or not MANY_DIGITS.search(out), line
        made = [re.sub(r'<data value="[^"]*">', "", p.read_text("utf-8")) for p in tmp_path.iterdir()]
        for text in (out, err, *made):
            assert not NOTHING.search(text), (line, NOTHING.search(text))


def test_digits_that_are_known() -> None:
    """Two of the error, and no sign of a zero; what is small by its power of ten."""
    assert [known(-0.001, 0.3), known(-1e-9, 0.3), known(12.3456, 0.012), known(1234.5, 96.0)] == [
        "0.00", "0.00", "12.346", "1234"]  # fmt: skip
    assert [known(5.6123e-10, 3.1e-11), known(-1e-13, 1e-10), known(5.0, 0.0)] == ["5.61e-10", "0", "5"]
    assert not NOTHING.search("left-0 1e-08 -0.5 -0.05e-3 2.5-0.3")
    assert all(NOTHING.search(x) for x in ("-0", "a -0.00 b", "[-0.0, 1]", "-0e+00"))


# --- 4, install and records ------------------------------------------------------------------------------------------


def test_the_readme_says_how_to_install() -> None:
    project = (ROOT / "pyproject.toml").read_text("utf-8")
    for extra in ("scenes", "plot", "dask", "derive"):
        assert f"`{extra}`" in README
        assert re.search(rf"^{extra} = ", project, re.MULTILINE)
    assert "pip install ." in README
    assert "Basic Geodynamics of Landslides: I. The Dynamic Slip Circle Method" in README


def test_on_numpy_alone(tmp_path: Path) -> None:
    """Tables without extras; what needs one says so before it computes."""
    path = tmp_path / "own.toml"
    path.write_text(ARC + FRICTION + "[rotation]\n", "utf-8")
    hidden = (
        "import sys; sys.modules.update({x: None for x in ('scipy', 'matplotlib', 'rich', 'dask', 'distributed')});"
    )
    work = "from slipcircle.motion import solver; solver.motion_of = None;"  # so that nothing can be computed
    line = "from slipcircle.__main__ import main; sys.exit(main(sys.argv[1:]))"

    def said(more: str, *argv: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run([sys.executable, "-c", hidden + more + line, *argv], cwd=ROOT, capture_output=True,
                              text=True, check=False)  # fmt: skip

    creep = tmp_path / "creep.toml"
    stiff = "[rotation]\n[viscosity]\nviscosity_Pa_s = 1e10\nthickness_m = 0.1\n"
    creep.write_text(f"end_time_s = 1e6\n{ARC}{FRICTION}{stiff}", "utf-8")
    made = tmp_path / "creep.csv"
    done = said("", "run", str(creep), "--csv", str(made))
    assert (done.returncode, done.stderr, made.exists()) == (0, "", True)
    plain: list[tuple[str, ...]] = [("run", str(path)), ("plan", str(path)), ("info",), ("schema",)]
    for argv in [*plain, ("run", str(path), "--json")]:
        done = said("", *argv)
        assert (done.returncode, done.stderr) == (0, ""), argv
    needing: list[tuple[str, tuple[str, ...]]] = [
        ("plot", ("run", str(path), "--plot", str(tmp_path / "a.png"))),
        ("plot", ("run", str(path), "--report", str(tmp_path / "a.html"))),
        ("scenes", ("sweep", str(path), "--samples", "9", "--uncertain", "friction.angle_deg=normal:10:1")),
    ]
    for extra, argv in needing:
        done = said(work, *argv)
        assert done.returncode == 1
        assert re.fullmatch(rf"slipcircle: .* pip install 'slipcircle\[{extra}\]'\n", done.stderr), done.stderr


@pytest.mark.parametrize(
    ("text", "more"),
    [
        ("Time (s),Acceleration (g's)\n0,0.1\n0.1,0.2\n0.2,0.3\n", {}),
        ("Time (s),Acceleration (%g)\n0,10\n0.1,20\n0.2,30\n", {}),
        ("# Kobe, 1995\ntime_s,acc_g\n0,0.1\n0.1,0.2\n0.2,0.3\n", {}),
        ("# Kobe, 1995\n0,0.1\n0.1,0.2\n0.2,0.3\n", {"units": "g"}),
        ("1995,1,17\n0,0.1\n0.1,0.2\n0.2,0.3\n", {"units": "g"}),
        ("time_s,acc_g\n0,0.1\n# lost\n0.1,0.2\n% x, 3\n0.2,0.3\n", {}),
        ("time_s,acc_g,\n0,0.1,\n0.1,0.2,\n0.2,0.3,\n", {}),
        ('"time_s","acc_g"\n"0","0.1"\n"0.1","0.2"\n"0.2","0.3"\n', {}),
        ("0.1 0.2 0.3\n", {"units": "g", "step": 0.1}),
        ("0.1, 0.2\n0.3\n", {"units": "g", "step": 0.1}),
        ("Kobe 1995\n! five a line\n0.1 0.2 0.3 0.1\n0.2\n", {"units": "g", "step": 0.1}),
    ],
)
def test_records_as_people_have_them(tmp_path: Path, text: str, more: dict[str, Any]) -> None:
    path = tmp_path / "r.csv"
    path.write_text(text, "utf-8")
    found = read_record(path, holds="driving", **more)
    assert found.values[:3] == pytest.approx([0.1, 0.2, 0.3], rel=1e-15)
    assert found.time[:3] == pytest.approx([0.0, 0.1, 0.2], rel=1e-15)


def test_a_line_is_named_below_comments(tmp_path: Path) -> None:
    path = tmp_path / "r.csv"
    path.write_text("time_s,acc_g\n# a, 1\n0,0.1\n# b\n0.1,nan\n0.2,0.3\n", "utf-8")
    with pytest.raises(ValueError, match=r"line 5: value = nan"):
        read_record(path, holds="driving")


def test_both_polarities_and_their_mean(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["run", "vaiont-shaken", "--polarities", "--json"]) == 0
    one, other, mean = json.loads(capsys.readouterr().out)
    scene = load("vaiont-shaken")
    given = {**scene.called["shaking"], "amplitude": -scene.called["shaking"]["amplitude"]}
    turned = solve(replace(scene, effects={**scene.called, "shaking": given}))
    assert other["run_out"] == pytest.approx(turned.run_out, rel=1e-12)
    assert mean["run_out"] == pytest.approx((one["run_out"] + other["run_out"]) / 2, rel=1e-15)
    assert main(["run", "vaiont", "--polarities"]) == 1
    assert "nothing shakes it" in capsys.readouterr().err


# --- odd scene files -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("part", range(10))
def test_odd_scene_files_end_in_an_answer_or_a_refusal(part: int, tmp_path: Path) -> None:
    """Two thousand in all; `python tests/fuzz_scenes.py 2000` draws others."""
    bad = fuzz_scenes.faults(range(200 * part, 200 * part + 200), 11, tmp_path, "run", 60.0)
    assert not bad, bad[0]


def test_the_fuzz_sees_faults(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A traceback, a NaN, a refusal with an interpreter's words, silence; and its files are many things."""
    path = tmp_path / "a.toml"
    path.write_text("x" * 2, "utf-8")
    for work, said in (
        (lambda argv: 1 / 0, "ZeroDivisionError"), (lambda argv: print("NaN") or 0, "prints"),
        (lambda argv: print("x is ambiguous", file=sys.stderr) or 1, "refuses with 1"),
        (lambda argv: 0, "says nothing"),
    ):  # fmt: skip
        monkeypatch.setattr(fuzz_scenes, "main", work)
        assert said in fuzz_scenes.fault(path)
    texts = [fuzz_scenes.toml(fuzz_scenes.document(Random(k))) for k in range(1000)]
    words = "nan inf \\u [[ 1e+300 distribution rate_weakening ground level_m critical search true"
    for word in words.split():
        assert any(word in text for text in texts), word


def test_there_is_one_check_of_keys() -> None:
    """No second model of a scene file: what a key may be is asked of the key alone."""
    assert tables_of("constant")["arc"].keys["radius_m"].wrong("1") == [("", "1")]
    source = ast.parse((ROOT / "slipcircle/files/scenefile.py").read_text("utf-8"))
    assert "pydantic" not in {a.name for n in ast.walk(source) if isinstance(n, ast.Import) for a in n.names}


def test_dir_has_what_all_has() -> None:
    assert {*slipcircle.__all__} <= {*dir(slipcircle)}
