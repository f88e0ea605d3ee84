"""Scene files: what they may say, what is said when they are wrong, and their schema."""

import json
import re
import tomllib
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import slipcircle
from generated.effects import EFFECTS, LAWS
from slipcircle import Arc, Scene, load
from slipcircle.workbench.common.files import write_file as write_file
from slipcircle.workbench.files.keys import WITH_ARC, KeyTable, fitted
from slipcircle.workbench.files.loaded import stability_of
from slipcircle.workbench.files.scenefile import load as read
from slipcircle.workbench.files.schema import schema
from slipcircle.workbench.outputs.guide import guide

jsonschema: Any = import_module("jsonschema")  # comes with nbformat, untyped
FOLDER = Path(slipcircle.__file__).parent / "scenes"
ARC = "[arc]\nradius_m = 1492.6\ntheta_1_deg = 215.2\ntheta_2_deg = 276.9\nunit_weight_kN_m3 = 20\n"
FRICTION = "[friction]\nangle_deg = 10\n"
GIVEN = """[arc.given]
moment_of_inertia = 0.4376
radial_weight = 0.0870
weight_moment = 0.0387
resistance_factor = 0.1523
dynamic_coefficient = 0.468
"""
TABLE = "[friction]\nlaw = 'tabulated'\nslip_m = [0, 2, 5]\n"


@pytest.fixture
def file(tmp_path: Path) -> Path:
    return tmp_path / "slope.toml"


def written(file: Path, text: str) -> Scene:
    file.write_text(text, "utf-8")
    return read(file)


def sentences(file: Path, text: str) -> list[str]:
    """Return the sentences about a file without its name, with which each must begin."""
    with pytest.raises(ValueError, match=re.escape(str(file))) as caught:
        written(file, text)
    lines = str(caught.value).split("\n")
    assert all(line.startswith(f"{file}: ") for line in lines)
    return [line.removeprefix(f"{file}: ") for line in lines]


def tan(degrees: float) -> float:
    return float(np.tan(np.deg2rad(degrees)))


# --- what a file may say -------------------------------------------------------------------------------------------


def test_units_are_converted(file: Path) -> None:
    scene = written(file, f"""
        note = "all of it"
        initial_velocity_m_s = -2
        end_time_s = 60
        accuracy = 1e-6
        {ARC}
        gravity_m_s2 = 9.80665
        width_m = 12.5
        {FRICTION}
        [pore_pressure]
        ratio = 0.3
        pressure_kPa = 40
        [cohesion]
        cohesion_kPa = 0
        [drag]
        xi_m_s2 = 500
        [viscosity]
        viscosity_Pa_s = 1e6
        thickness_m = 0.2
        [thermal_pressurisation]
        pressurisation_MPa_K = 0.025
        heat_capacity_MJ_m3_K = 2.7
        thickness_m = 0.1
    """)  # fmt: skip
    arc = Arc(1492.6, float(np.deg2rad(215.2)), float(np.deg2rad(276.9)), 20e3, 9.80665, 12.5)
    heat = {"pressurisation": 0.025e6, "heat_capacity": 2.7e6, "thickness": 0.1}
    effects = {"pore_pressure": {"ratio": 0.3, "pressure": 40e3}, "cohesion": {"cohesion": 0.0}, "drag": {"xi": 500.0},
               "viscosity": {"viscosity": 1e6, "thickness": 0.2}, "thermal_pressurisation": heat}  # fmt: skip
    assert scene == Scene(arc, tan(10.0), effects, -2.0, 60.0, 1e-6, "slope", "all of it")


def test_only_arc_and_friction_are_needed(file: Path) -> None:
    scene = written(file, ARC + FRICTION)
    assert (scene.name, scene.called, scene.end_time, scene.accuracy) == ("slope", {}, None, None)
    assert (scene.initial_velocity, scene.arc.gravity, scene.arc.width) == (0.0, 9.81, 1.0)


def test_a_byte_order_mark_and_windows_line_ends(file: Path) -> None:
    expected = written(file, ARC + FRICTION)
    file.write_bytes(("\ufeff" + ARC + FRICTION).replace("\n", "\r\n").encode())
    assert read(file) == expected


@pytest.mark.parametrize(
    ("text", "friction"),
    [
        ("angle_deg = 20", tan(20.0)),
        ("law = 'constant'\ncoefficient = 0.5", 0.5),
        ("law = 'linear'\npeak = 0.4\nresidual_deg = 10\nlength_m = 2",
         {"law": "linear", "peak": 0.4, "residual": tan(10.0), "length": 2.0}),
        ("law = 'tabulated'\nslip_m = [0, 2.5]\nangle_deg = [20, 8]",
         {"law": "tabulated", "slip": (0, 2.5), "coefficient": (tan(20.0), tan(8.0))}),
    ],
)  # fmt: skip
def test_friction_is_an_angle_or_a_coefficient(file: Path, text: str, friction: Any) -> None:
    assert written(file, f"{ARC}[friction]\n{text}\n").friction == friction


def test_every_law_and_effect_can_be_asked_for(file: Path) -> None:
    """A file written from nothing but the schema: with numbers, and with distributions in their place."""
    whole = schema()
    texts = {"number": "0.5", "array": "[0, 0.5]"}
    drawn = "{ distribution = 'uniform', low = 0.4, high = 0.6 }"

    def definition(part: dict[str, Any]) -> dict[str, Any]:
        return dict(whole["$defs"][part["$ref"].rpartition("/")[2]])

    def first_needed(condition: dict[str, Any]) -> str:
        return condition["required"][0] if "required" in condition else first_needed(next(iter(condition.values()))[0])

    def table(path: str, part: dict[str, Any]) -> str:
        lines = [f"[{path}]"]
        for key in map(first_needed, part.get("allOf", [])):
            row = {"type": "number"} | part["properties"][key]
            text = json.dumps(row["const"]) if "const" in row else texts[row["type"]]
            lines.append(f"{key} = {text if key != 'speed_m_s' else '[0.1, 0.5]'}")  # of which the logarithm is taken
        return "\n".join([*lines, ""])

    pulse = "[shaking]\npulse = 'half-sine'\namplitude_g = 0.1\nduration_s = 2\n"  # a pulse needs more than its name
    parts = {n: whole["properties"][n] for n in EFFECTS}
    parts["cohesion"] = definition(parts["cohesion"]["anyOf"][0])
    effects = [pulse if n == "shaking" else table(n, parts[n]) for n in EFFECTS]
    for law in whole["properties"]["friction"]["anyOf"]:
        text = "\n".join([ARC, table("friction", definition(law)), *effects])
        scene, uncertain = written(file, text), written(file, text.replace(" 0.5\n", f" {drawn}\n"))
        assert list(scene.called) == list(uncertain.called) == list(EFFECTS)
        assert valid(tomllib.loads(file.read_text("utf-8")))
        assert not scene.uncertain
        assert len(uncertain.uncertain) == text.count(" 0.5\n") > 0


# --- what is refused -----------------------------------------------------------------------------------------------

MISTAKES = [
    (ARC.replace("1492.6", "{ distribution = 'gauss' }") + FRICTION,
     "arc.radius_m: distribution = 'gauss': must be one of normal, lognormal, uniform, triangular, truncated_normal"),
    (f"angle_deg = 10\n{ARC}[friction]\n", "angle_deg = 10: is unknown; did you mean angle_deg in [friction]?"),
    (ARC.replace("radius_m", "radius") + FRICTION, "arc.radius = 1492.6: is unknown; did you mean radius_m?"),
    (ARC + "end_time_s = 30\n" + FRICTION,
     "arc.end_time_s = 30: is unknown; did you mean end_time_s above the first table?"),
    ("unit_weight_kN_m3 = 20\n" + ARC.replace("unit_weight_kN_m3 = 20\n", "") + FRICTION,
     "unit_weight_kN_m3 = 20: is unknown; did you mean unit_weight_kN_m3 in [arc]?"),
    (ARC + FRICTION + "[rotation]\nspeed = 1\n", "rotation.speed = 1: is unknown; this table has no keys"),
    (ARC + FRICTION + "[drag]\nxi_m_s2 = 1\nqqq = 1979-05-27\n",
     'drag.qqq = "1979-05-27": is unknown; known are xi_m_s2'),
    (ARC, "friction: is missing: friction on the slip surface, a table [friction]"),
    (ARC + "[friction]\n", "friction: angle_deg or coefficient is missing: friction coefficient, tan(phi)"),
    (ARC + FRICTION + "coefficient = 0.2\n", "friction: angle_deg and coefficient exclude each other; remove one"),
    (ARC + "[friction]\nangle_deg = 95\n", "friction.angle_deg = 95: must be a number at least 0 and below 90 (deg): "),
    (ARC + "[friction]\nlaw = 'exponentail'\npeak = 1\nresidual = 0\nlength_m = 1\n",
     'friction.law = "exponentail": must be one of constant, exponential, linear, hyperbolic, tabulated, '
     "rate_weakening, rate_tabulated, prescribed: friction law; did you mean exponential?"),
    (ARC + "[friction]\nlaw = 'linear'\npeak = 1\nresidual_deg = 8\n",
     "friction.length_m: is missing: slip over which friction falls, a number above 0 (m)"),
    (ARC + TABLE + "angle_deg = [20, 'x', 5]\n", 'friction.angle_deg[1] = "x": must be a list of numbers at least 0'),
    (ARC + TABLE + "angle_deg = [20, 10]\n", "friction.slip_m and friction.angle_deg: must be two lists of equal"),
    (ARC + TABLE.replace("2, 5", "5, 2") + "angle_deg = [20, 9, 8]\n", "friction.slip_m: must start at 0 and increase"),
    ("friction = 0.2\n" + ARC, "friction = 0.2: must be a table [friction]: friction on the slip surface"),
    *((ARC.replace("1492.6", x) + FRICTION, f"arc.radius_m = {x}: must be a number above 0 (m)")
      for x in ("true", "nan", "[1, 2]")),
    (ARC.replace("1492.6", "1" * 400) + FRICTION, f"arc.radius_m = {'1' * 57}...: must be a number above 0 (m)"),
    (ARC.replace("1492.6", "1e103") + FRICTION, "arc.radius_m = 1e+103: must be a number above 0 (m): radius of the "
     "slip circle; between 1e-06 and 1e+20: is that another unit?"),
    (ARC.replace("215.2", "276.9") + FRICTION, "arc.theta_2_deg = 276.9 deg: must be above theta_1_deg = 276.9 deg"),
    (ARC.replace("215.2", "15.2").replace("276.9", "76.9") + FRICTION,
     "arc.theta_1_deg = 15.2 deg, theta_2_deg = 76.9 deg: there is no normal load"),
    (ARC + FRICTION + "[observed]\nreach_m = 450\n", "observed.reach_m = 450: is unknown; use run_out_m, which is the"),
    (ARC + FRICTION + "[observed]\nrun_out_m = [450, 300]\n", "observed.run_out_m = [450, 300]: must be a number, or"),
    (ARC + GIVEN + FRICTION + "[rotation]\n", "arc.given: belongs to the initial position and cannot"),
    (ARC + FRICTION + "[pore_pressure]\nratio = 1\n", "pore_pressure.ratio = 1: must be a number at least 0 and below"),
    (ARC + FRICTION + "[pore_pressure]\npressure_kPa = [0, 20, 50]\n",
     "pore_pressure.pressure_kPa = [0, 20, 50]: is a list, which needs a list of times"),
    (ARC + FRICTION + "[pore_pressure]\nratio = 0.1\ntime_s = [0, 1]\n",
     "pore_pressure.time_s and ratio or pressure_kPa: must be lists"),
    (ARC + FRICTION + "[shaking]\npulse = 'sine'\n", "shaking.amplitude_g is missing: a pulse needs it"),
    (ARC + FRICTION + "peak_deg = 12\n", "friction.peak_deg = 12: is unknown; it belongs to law = exponential or"),
    (ARC + "[friction]\ncoefficient = 10\n",
     "friction.coefficient = 10: must be a number at least 0: friction coefficient, tan(phi); an angle? say angle_deg"),
    (ARC.replace("= 20\n", "= 19500\n") + FRICTION,
     "arc.unit_weight_kN_m3 = 19500: must be a number above 0 (kN/m3): unit weight, at most 1000; was 19.5 kN"),
    (ARC + FRICTION + "[cohesion]\ncohesion_kPa = 1e307\n",
     "cohesion.cohesion_kPa = 1e+307: must be a number at least 0 (kPa): "),
    ("[arc\n", "is not TOML: Expected ']' at the end of a table declaration (at line 1, column 5)"),

]  # fmt: skip


@pytest.mark.parametrize(("text", "said"), MISTAKES, ids=[said[:40] for _, said in MISTAKES])
def test_one_mistake_is_one_sentence(file: Path, text: str, said: str) -> None:
    found = sentences(file, text)
    assert len(found) == 1
    assert found[0].startswith(said)


def test_all_mistakes_are_listed(file: Path) -> None:
    """Faults of keys, tables, distributions, the arc and the law are listed with their places; none hides another."""
    found = sentences(file, """
        end_time_s = "30 s"
        accuracy = 2
        acuracy = 1
        [arc]
        radius_m = { distribution = 'lognormall', mean = 2, std = 1 }
        theta_1_deg = nan
        unit_weight_kN_m3 = { distribution = "triangular", low = 18, mode = 30, high = 23 }
        [friction]
        law = "exponential"
        peak_deg = 95
        peak = 0.4
        residual_deg = { distribution = 'uniform', low = 5, high = 'x', top = 1 }
        [pore_pressure]
        [shakin]
        [cohesion]
        cohesion_kPa = { distribution = "uniform", low = -1, high = 5 }
        [drag]
        xi_m_s2 = true
    """)  # fmt: skip
    starts = (
        'end_time_s = "30 s":', "accuracy = 2:", "acuracy = 1: is unknown; did you mean accuracy?",
        "arc.radius_m: distribution = 'lognormall': must be one of normal, ", "arc.theta_1_deg = nan:",
        "arc.unit_weight_kN_m3: mode must be from low to high", "friction.peak_deg = 95:", "shakin = {}:",
        "arc.theta_2_deg: is missing", "friction.length_m: is missing", "friction: peak_deg and peak exclude",
        "friction.residual_deg: top: is unknown; known are low, high", "drag.xi_m_s2 = true:",
        "friction.residual_deg: high = 'x': must be a finite number", "pore_pressure: ratio or pressure_kPa or record ",
        "cohesion.cohesion_kPa: reaches down to -1, and must stay above 0",
    )  # fmt: skip
    assert sorted(found) == sorted(next((m for m in found if m.startswith(start)), start) for start in starts)
    arc, friction = sentences(file, ARC.replace("215.2", "300") + TABLE.replace("5]", "1]") + "angle_deg = [9, 8, 7]\n")
    assert arc.startswith("arc.theta_2_deg = 276.9 deg: must be above theta_1_deg = 300 deg")
    assert friction.startswith("friction.slip_m: must start at 0 and increase")
    found = sentences(file, "radius_m = 5\n" + ARC.replace("radius_m = 1492.6\n", ""))
    assert [m.partition(":")[0] for m in found] == ["radius_m = 5", "friction"]
    assert [m.partition(" ")[0] for m in sentences(file, "")] == ["arc:", "friction:"]
    assert sentences(file, FRICTION + "[ark]\n") == ["ark = {}: is unknown; did you mean arc?"]


def test_the_command_line_says_the_same(file: Path, said: Any, refused: Any) -> None:
    assert json.loads(said("schema")) == schema()
    assert said("schema --text") == f"{guide()}\n"
    file.write_text(ARC.replace("1492.6", "0"), "utf-8")
    told = refused("run", file)
    assert told.startswith(f"slipcircle: {file}: arc.radius_m = 0: must be ")
    assert f" {file}: friction: is missing" in told


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("viaont", "scene 'viaont' is unknown; known are layered-slope, .*, wet-slope; did you mean vaiont?"),
        ("", "scene '' is unknown; known are .*"),
        ("wet_slope.toml", "wet_slope.toml: there is no such file; did you mean wet-slope?"),
        ("no/where", "no/where: there is no such file"),
        ("a" * 5000, "scene 'a*' is unknown; known are .*"),
    ],
)
def test_a_scene_that_is_not_there(name: str, said: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    with pytest.raises(ValueError, match=said.replace("?", r"\?") + "$"):
        load(name)


def test_a_file_that_is_no_text(file: Path) -> None:
    file.write_bytes(b"name = '\xff'")
    with pytest.raises(ValueError, match=r"is not UTF-8 text: invalid start byte at byte 8$"):
        load(file)


# --- schema --------------------------------------------------------------------------------------------------------


def valid(document: Any) -> bool:
    return bool(jsonschema.Draft202012Validator(schema()).is_valid(document))


def test_the_schema_is_one_and_the_shipped_files_obey_it() -> None:
    jsonschema.Draft202012Validator.check_schema(schema())
    for path in FOLDER.glob("*.toml"):
        assert valid(tomllib.loads(path.read_text("utf-8"))), path.name


def test_the_schema_refuses_what_reading_refuses(file: Path) -> None:
    """But for what needs the mechanics, and for numbers that JSON does not have."""
    beyond = ("arc.theta", "arc.given: belongs", "shaking.amplitude_g is missing", "is not TOML", "friction.slip",
              "pore_pressure.pressure_kPa = [", "pore_pressure.ratio = []", "pore_pressure.time_s and",
              "observed.run")  # fmt: skip
    for text, said in MISTAKES:
        if not said.startswith(beyond) and not re.search(r"= (nan|inf|1{57})", said):
            assert not valid(tomllib.loads(text)), said


def tables_of(law: str) -> dict[str, KeyTable]:
    return fitted(WITH_ARC, {"friction": {"law": law}})


def test_every_key_has_a_title_and_says_what_is_allowed() -> None:
    keys = [(key, row) for law in LAWS for table in tables_of(law).values() for key, row in table.keys.items()]
    for key, row in keys:
        assert row.help, key
        assert row.allowed, key
        unit = re.search(r"_(deg|kPa|m|s|m_s|m_s2|kN_m3)$", key)
        assert not unit or row.allowed.endswith(")"), key


def test_the_guide_has_every_law_effect_and_key_and_fits_a_page() -> None:
    lines = guide().splitlines()
    assert max(map(len, lines)) <= 100
    heads = {key for line in lines for key in line[:28].strip().split(" or ")}
    assert {f'law = "{law}"' for law in LAWS} | {f"[{effect}]" for effect in EFFECTS} <= heads
    assert {key for law in LAWS for table in tables_of(law).values() for key in table.keys} - {"law"} <= heads


def test_the_formulas_of_the_guide_give_the_numbers_that_are_used() -> None:
    """The printed formulas that make parameters dimensionless give the values that are used."""
    names = {"alpha": "half_angle", "g": "gravity", "R": "radius", "rho": "density", "sigma_ref": "reference_stress",
             "Theta": "Theta", "gradient": "gradient",
             "strength_factor": "strength_factor"}  # fmt: skip
    scales = {name: 1.0 + 0.37 * k for k, name in enumerate((*names.values(), "thickness", "heat_capacity", "cover"))}
    known = scales | {short: scales[name] for short, name in names.items()} | {"sqrt": np.sqrt}
    formulas = [(effect, f.split("* = ")) for effect in EFFECTS.values() for f in effect.formulas if "* = " in f]
    assert len(formulas) == 8
    for effect, (symbol, formula) in formulas:
        (p,) = (p for p in effect.parameters if p.symbol == symbol)
        product = re.sub(r"(?<=[\w)]) (?=[\w(])", "*", formula)
        assert np.isclose(eval(product, known | {p.name: 7.0}), p.dimensionless(7.0, scales), rtol=1e-14)


def test_a_scene_is_found_by_its_name_without_toml(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("my-slope.toml").write_text(f"{ARC}\n{FRICTION}\n", "utf-8")
    Path("folder").mkdir()
    assert read("my-slope").name == "my-slope"
    for name in (".", "folder"):
        with pytest.raises(ValueError, match=rf"{re.escape(name)}: is a folder; give a scene's file"):
            read(name)


def test_a_full_disk_names_the_file() -> None:
    with pytest.raises(ValueError, match=r"/dev/full: cannot be written: No space"):
        write_file("/dev/full", b"x" * 99)


THREE_MISTAKES = """
[ground]
points_m = [[0, 0], [20, 0], [54, 17], [90, 17]]
unit_weight_kN_m3 = 18.7
[circle]
critical = "Bishop"
[friction]
phi_deg = 27
[cohesion]
c_kPa = 10
kappa = 2
"""


def test_several_mistakes_are_lines_of_their_own(tmp_path: Path, refused: Any) -> None:
    """Mistakes of a file and of a command line are separate lines."""
    path = tmp_path / "m1.toml"
    path.write_text(THREE_MISTAKES, "utf-8")
    assert refused("run", path).splitlines() == [
        f"slipcircle: {path}: friction.phi_deg = 27: is unknown; did you mean angle_deg?",
        f"slipcircle: {path}: cohesion.c_kPa = 10: is unknown; did you mean cohesion_kPa?",
        f"slipcircle: {path}: cohesion.kappa = 2: is unknown; known are law, cohesion_kPa, cohesion_per_m_kPa, datum_m",
    ]
    told = refused("sweep vaiont --grid friction.angle_deg=1:2 --grid arc.radius_m=x").splitlines()
    assert [line.split()[2] for line in told] == ["friction.angle_deg=1:2:", "arc.radius_m=x:"]


def test_words_of_a_file_in_capitals(tmp_path: Path) -> None:
    path = tmp_path / "slope.toml"
    text = THREE_MISTAKES.replace("phi", "angle").replace("c_kPa", "cohesion_kPa").replace("kappa = 2", "")
    factors = []
    for word in ("bishop", "Bishop", "BISHOP"):
        path.write_text(text.replace("Bishop", word), "utf-8")
        stability = stability_of(load(path))
        assert stability is not None
        factors.append((stability.method, stability.factors_of_safety["bishop"]))
    assert len({*factors}) == 1


@pytest.mark.parametrize("name", ["sheet.csv", "profile.dxf", "points.txt", "book.xlsx"])
def test_a_table_in_place_of_a_scene(name: str, tmp_path: Path, refused: Any) -> None:
    """The message says where points and records belong; a scene with a mistake has none of it."""
    content = {"sheet.csv": b"x,y\n0,1\n", "profile.dxf": b"0\nSECTION\n", "points.txt": b"0 1\n2 3\n"}
    path = tmp_path / name
    path.write_bytes(content.get(name, b"PK\x03\x04\xff\xfe"))
    told = refused("run", path)
    advice = "put the name of a profile (.csv, .dxf) into points_file of [ground]"
    assert f"`slipcircle new slope.toml` writes a scene: {advice}" in told
    other = tmp_path / "slope.toml"
    other.write_bytes(path.read_bytes())
    assert "slipcircle new" not in refused("run", other)
