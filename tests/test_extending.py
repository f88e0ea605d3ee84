"""A law, an effect and a moment are added by the instructions of `derive`, in a copy, and used there.

A new kind of mass is a class, here an arc with a rigid load on top. `python -m tests.campaigns.all_weights` declares
all 15 weights that a moment may have.
"""

import json
import math
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest
from flint import arb_series
from scipy.optimize import brentq

from slipcircle import Arc, Scene, Section, Status, solve
from slipcircle.core import number
from slipcircle.core.scene.dimensionless import Dimensionless
from slipcircle.core.scene.mass import MomentCoefficients
from slipcircle.workbench.studies.ensemble import grid
from tests.campaigns import all_weights
from tests.campaigns.all_weights import run
from tests.support import golden, taylor
from tests.support.along_the_arc import first_slide
from tests.support.outputs import blocks
from tests.support.pieces import Pieces

# ``At the end of ``LAWS`` in ``derive/declare/effects.py``::``, and what stands indented below.
STEP = re.compile(r"[Aa]t the end of\s+``(\w+)`` in\s+``(\S+)``::\n\n((?: {4}.*\n)+)")
SLOPE = {"radius_m": 100.0, "theta_1_deg": 205.0, "theta_2_deg": 285.0, "unit_weight_kN_m3": 19.0}
SOFTENING = {"peak": 0.35, "residual": 0.2, "length": 1.5}
SUCTION = 12e3
# Also right: a function that no law of the package has, and an effect with a state that friction feeds.
MORE = {
    "LAWS": """
    Law("smooth", "residual + (peak - residual) (1 - tanh(slip/length))", _SOFTENING,
        _R + (_P - _R) * (1 - sp.tanh(SLIP / _L))),
""",
    "EFFECTS": """
    Effect("crushing", "grains break, and the pore pressure grows with rotation and friction", (
        Parameter("gain", "Pa", "its rise in a rotation of 1 at a friction coefficient of 1", "gain_kPa",
                  sp.Symbol("crushing_gain", real=True), VALUE / REFERENCE),),
           pressure=sp.Symbol("crushed", real=True), states=(sp.Symbol("crushed", real=True),),
           growth=sp.Symbol("crushing_gain", real=True) * MU),
""",
}


PAGE = (Path(__file__).parents[1] / "notebooks" / "extending.md").read_text("utf-8")


def follow(root: Path) -> list[str]:
    """Do what the docstring of `derive` and the page say to a copy of the repository; the names that were added to."""
    steps = STEP.findall((root / "derive" / "__init__.py").read_text("utf-8"))
    steps += re.findall(r"At the end of `(\w+)` in `(\S+)`[^`]*:\n\n```text\n(.*?)```", PAGE, re.DOTALL)
    for name, file, code in steps:
        code += MORE.get(name, "").lstrip("\n")
        lines = (root / file).read_text("utf-8").splitlines(keepends=True)
        start = next(k for k, line in enumerate(lines) if re.match(rf"(def )?{name}\b", line))
        end = next(k for k in range(start + 1, len(lines)) if re.match(r" *[)}]( |$)", lines[k]))
        (root / file).write_text("".join([*lines[:end], code, *lines[end:]]), "utf-8")
    return [name for name, _, _ in steps]


# Fast to compile rather than fast, which are the same numbers, and bounds that are proved but not as small as can be.
# That float32 is rounded correctly is not proved in the copy (`tests.campaigns.all_weights` does it), and neither is
# what depends on no new declaration: programs of known effects and laws, and the integrals of known moments.
QUICKLY = """
import gc
from functools import partial
gc.disable()
from derive import build
from derive.check import certify, midpoints
build.build = partial(build.build, flags=("-O0", *build.FLAGS[1:]))
certify.HALVINGS = 100
midpoints.hard = lambda record: []
from derive.algebra import dynamics, integrate, phase_plane, pieces, slopes
from derive.declare.effects import EFFECTS, LAWS
from derive.declare.quantities import MOMENTS
from derive.flow import closed, linked, recurrences, sliding
few = *(effect for effect in EFFECTS if not effect.parameters), *EFFECTS[-2:]
linked.prove = partial(linked.prove, few, (LAWS[0], next(law for law in LAWS if law.kinks), *LAWS[-2:]))
added = tuple(one.name for one in (*EFFECTS[-2:], *LAWS[-2:]))
cases = linked.cases
linked.cases = lambda *of: [case for case in cases(*of) if any(x.name.startswith(added) for xs in case for x in xs)]
compare, continuous = integrate.compare, integrate._check_continuity
integrate._check_continuity = lambda *_: None
for moment in MOMENTS[:-1]:
    integrate.derive(moment)
integrate._check_continuity = continuous
integrate.compare = lambda of, digits: compare(of, digits) if of.moment == MOMENTS[-1] else "a known difference"
for part in (dynamics, phase_plane, pieces, slopes, closed, recurrences, sliding):
    part.prove = list
"""
HARD_CASES = """
from derive.judge.hard import hard_cases
print(*(case.why for case in hard_cases() if case.function == "area"), sep="\\n")
"""


def extended(root: Path) -> list[str]:
    """Make the copy; why the area has hard cases."""
    all_weights.copy(root)
    assert follow(root) == ["LAWS", "EFFECTS", "MOMENTS", "RESULTS"]
    return run(root, "-c", QUICKLY + all_weights.DERIVE + HARD_CASES).splitlines()


class Extended(taylor.Problem):
    """Suction is water that pulls; the new law is the old one with a square."""

    def __init__(self, scene: Any) -> None:
        super().__init__(scene)
        power = scene["power"]
        peak, residual, length = (taylor.number(SOFTENING[x]) for x in ("peak", "residual", "length"))
        if power:
            self.slip = Pieces((), (lambda s: arb_series([peak - residual]) / (s * (self.radius / length) + 1) ** power
                                    + residual,))  # fmt: skip


def scene_file(law: str, centripetal: bool) -> str:
    """Return a scene with this law and suction."""
    lines = ["[arc]", *(f"{k} = {v}" for k, v in SLOPE.items()), "[friction]", f'law = "{law}"']
    lines += [*(f"{k}{'_m' * (k == 'length')} = {v}" for k, v in SOFTENING.items()), "[rotation]"]
    lines += ["[centripetal]"] * centripetal + ["[suction]", f"suction_kPa = {SUCTION / 1e3}", ""]
    return "\n".join(lines)


def check_scene(plan: str, result: str, law: str, power: int, centripetal: bool) -> None:
    """Check that the scene uses the new law and the new effect."""
    (planned,) = json.loads(plan)
    assert planned["law"] == law
    assert {law, "suction"} <= {term["effect"] for term in planned["equation"]["terms"]}
    assert planned["effects"][-1] == "suction"
    (motion,) = json.loads(result)
    effects = {"rotation": {}, "pore_pressure": {"pressure": -SUCTION}} | ({"centripetal": {}} if centripetal else {})
    radius, *ends = (SLOPE[k] for k in ("radius_m", "theta_1_deg", "theta_2_deg"))
    first, second = map(math.radians, ends)
    given = golden.scene(SOFTENING | {"law": "exponential"}, effects, radius=radius, theta_1=first, theta_2=second)
    exact = taylor.solve(given | {"power": power}, digits=16, problem=Extended)
    for found, name in ((motion["peak"]["velocity"], "peak_velocity"), (motion["run_out"], "run_out")):
        assert found == pytest.approx(float(exact[name]), rel=1e-11)


def check_schema(schema: str, guide: str) -> None:
    """Check that schema and guide contain the additions."""
    whole = json.loads(schema)
    assert {"required": ["suction_kPa"]} in whole["properties"]["suction"]["allOf"][0]["anyOf"]
    assert "friction_inverse_square" in whole["$defs"]
    assert "adds -suction* to u" in guide
    assert "suction* = suction/sigma_ref" in guide
    assert 'law = "inverse_square"' in guide


def check_moment(root: Path) -> None:
    """Check the area of a circle's segment, of thin masses and of the half disc, within 5 ulp, and its certificate."""
    alpha = [0.0, 1e-300, 1e-100, 1e-5, 0.1, 0.5385, 1.0, np.pi / 2]
    code = f"from generated import area; print(*(float(x).hex() for x in area({alpha})))"
    found = [float.fromhex(x) for x in run(root, "-W", "error", "-c", code).split()]
    with mpmath.workdps(650):
        exact = [mpmath.mpf(a) - mpmath.sin(2 * mpmath.mpf(a)) / 2 for a in alpha]
        assert all(abs(x - e) <= 5 * float(np.spacing(x)) for x, e in zip(found, exact, strict=True))
    records = json.loads((root / "generated" / "certificates" / "area.json").read_text("utf-8"))["certificates"]
    assert {(r["tier"], r["form"]) for r in records} == {
        (tier, form) for tier in ("best", "1e-10", "1e-6") for form in ("fused", "plain")
    }  # without one for float32 the best serves
    single = np.array([0.0, 1e-5, 0.1, 0.5385, 1.0], np.float32)
    code = f"import numpy as np; from generated import area; print(*area(np.array({single.tolist()}, np.float32)))"
    with mpmath.workdps(50):
        exact = [mpmath.mpf(a) - mpmath.sin(2 * mpmath.mpf(a)) / 2 for a in single.tolist()]
        for x, e in zip(map(np.float32, run(root, "-c", code).split()), exact, strict=True):
            assert abs(float(x) - e) <= 0.501 * float(np.spacing(x))
    assert all(r["definition"] == ["r^1"] for r in records)
    assert max(r["bound"] for r in records if (r["tier"], r["form"]) == ("best", "fused")) <= 1


# A law or an effect, its lines in a scene file, its friction after a slip, and its gain of the pore pressure, in SI
# units.
Friction = Callable[[float], float]
MOTIONS: dict[str, tuple[str, Friction, float]] = {
    "smooth": ("peak = 0.35\nresidual = 0.2\nlength_m = 1.5", lambda s: 0.2 + 0.15 * (1 - math.tanh(s / 1.5)), 0.0),
    "crushing": ("gain_kPa = 100", lambda s: 0.25, 1e5),
}


def motion_file(name: str, keys: str) -> str:
    """Return a mass that turns, with this law or this effect."""
    arc = "\n".join(["[arc]", *(f"{k} = {v}" for k, v in SLOPE.items())])
    effect = f"[friction]\ncoefficient = 0.25\n[{name}]" if f'Effect("{name}"' in MORE["EFFECTS"] else ""
    return "\n".join([arc, "[rotation]", effect or f'[friction]\nlaw = "{name}"', keys])


def integrated(friction: Friction, gain: float) -> tuple[float, float]:
    """Return peak velocity and run-out by plain integration, with weights that are sums over small pieces."""
    radius, first, last, _ = RIGHT
    of_arc = (last - first) * radius**2
    level, upright = (np.array(turned(x, HOUSE | {"load": 0.0})) for x in (0.0, np.pi / 2))
    inertia = level[2]

    def rate(t: float, y: Any) -> list[float]:
        rotation, omega, pressure = y
        drive, press, _ = level * math.cos(rotation) + upright * math.sin(rotation)
        mu = friction(radius * rotation)
        return [omega, (drive - mu * (press - pressure * of_arc)) / inertia, gain * mu * omega]

    rotation, _, omega = first_slide(rate, [0.0] * 3)
    return radius * omega, radius * rotation


def check_page(root: Path, scene: str, printed: str) -> None:
    """Check that the page's scene and commands are the ones that are run here."""
    _, _, examples = PAGE.partition("## A result")
    _, shown = blocks(examples, "text")
    assert shown == scene
    (console,) = blocks(examples, "console")
    ran, code, value = re.fullmatch(
        r"\$ slipcircle run new.toml\n(.*)\$ python -c \"(.*)\"\n(.*)\n", console, re.DOTALL
    ).groups()  # type: ignore[union-attr]
    assert {*ran.splitlines()} <= {*printed.splitlines()}
    assert run(root, "-c", code) == value + "\n"


# Several commands in one interpreter, which print what they said as a list.
COMMANDS = """
import contextlib, io, json, sys
from slipcircle.__main__ import main
said = []
for line in sys.argv[1:]:
    with contextlib.redirect_stdout(io.StringIO()) as printed:
        main(line.split())
    said.append(printed.getvalue())
from slipcircle.workbench.cost.kernels import KERNELS
print(json.dumps([*said, "area" in KERNELS]))
"""


def test_what_is_added_is_everywhere(tmp_path: Path) -> None:
    """Additions appear everywhere; in one test, as making the copy takes long."""
    *_, why = extended(tmp_path)
    assert why == "the result is denormal"
    (tmp_path / "new.toml").write_text(scene_file("inverse_square", True), "utf-8")
    (tmp_path / "old.toml").write_text(scene_file("exponential", False), "utf-8")
    lines = ["run new.toml", "plan new.toml --json", "run new.toml --json", "plan old.toml --json",
             "run old.toml --json", "schema", "schema --text"]  # fmt: skip
    for name, (keys, *_) in MOTIONS.items():
        (tmp_path / f"{name}.toml").write_text(motion_file(name, keys), "utf-8")
        lines.append(f"run {name}.toml --json")
    said = json.loads(run(tmp_path, "-c", COMMANDS, *lines))
    printed, plan_new, run_new, plan_old, run_old, schema, guide, *motions, priced = said
    assert priced
    for text, (name, (_, friction, gain)) in zip(motions, MOTIONS.items(), strict=True):
        (motion,) = json.loads(text)
        seen = motion["peak"]["velocity"], motion["run_out"]
        assert seen == pytest.approx(integrated(friction, gain), rel=1e-9), name
    check_scene(plan_new, run_new, "inverse_square", 2, True)
    check_scene(plan_old, run_old, "exponential", 0, False)
    check_schema(schema, guide)
    check_moment(tmp_path)
    check_page(tmp_path, scene_file("inverse_square", True), printed)


# --- a new kind of mass ----------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class LoadedArc(Arc):
    """An arc with a rigid load on top, such as a house: N/m, at x and y from the centre, m."""

    load: Any = field(default=0.0, metadata=number("N/m", -1.0, 1e12, help="weight of the load"))
    x: float = 0.0
    y: float = 0.0

    @cached_property
    def bare(self) -> Arc:
        return Arc(self.radius, self.theta_1, self.theta_2, self.unit_weight, self.gravity, self.width)

    @cached_property
    def moment_coefficients(self) -> MomentCoefficients:
        arc, bare = self.bare.moment_coefficients, self.bare.dimensionless.moment_of_inertia
        weight = self.load / (self.unit_weight * self.radius**2)
        x, y = self.facing * self.x / self.radius, self.y / self.radius
        distance = np.hypot(x, y)
        parts = (
            arc.driving_moment * bare - weight * x,
            arc.driving_moment_slope * bare - weight * y,
            arc.normal_load * bare - weight * y / distance,
            arc.normal_load_slope * bare + weight * x / distance,
            arc.resistance_factor * bare,
            arc.polar_moment * bare + weight * distance,
        )
        over_inertia = [part / self.dimensionless.moment_of_inertia for part in parts]
        return MomentCoefficients(*[*over_inertia, parts[0] / parts[2], 1.0])

    @cached_property
    def dimensionless(self) -> Dimensionless:
        arc, weight = self.bare.dimensionless, self.load / (self.unit_weight * self.radius**2)
        inertia = arc.moment_of_inertia + weight * (self.x**2 + self.y**2) / self.radius**2
        return replace(arc, moment_of_inertia=inertia)


@dataclass(frozen=True)
class WidenedSection(Section):
    """A section that stands for a longer mass: m beyond its width at both ends."""

    beyond: Any = field(default=0.0, metadata=number("m", -1.0, 1e3, help="length beyond the width"))


def test_a_number_of_a_new_section_may_be_an_array() -> None:
    ground = [[-100, 20], [0, 20], [40, 0], [100, 0]]
    section = WidenedSection(ground, centre=[22, 38], radius=38.0, unit_weight=20e3, beyond=[0.0, 1.0, 2.0])
    both = solve(Scene(section, 0.2, ["rotation"], accuracy=1e-13))
    bare = solve(Scene(Section(ground, [22, 38], 38.0, 20e3), 0.2, ["rotation"]))
    assert both.shape == (3,)
    assert both.run_out == pytest.approx(bare.run_out, rel=1e-11)


HOUSE: Any = {"load": 4e6, "x": -70.0, "y": -40.0}
RIGHT, MU = (100.0, math.radians(205.0), math.radians(285.0), 19e3), 0.25


def turned(rotation: float, house: Mapping[str, float]) -> tuple[float, float, float]:
    """Weight moment, normal load and moment of inertia, SI, after a rotation: the arc and the house in small pieces."""
    radius, first, last, weight = RIGHT
    half = (last - first) / 2
    nodes, shares = np.polynomial.legendre.leggauss(60)
    angle, of_angle = (first + last) / 2 + half * nodes, half * shares
    inner = np.cos(half) / np.cos(half * nodes)
    r = (inner + 1) / 2 + (1 - inner) / 2 * nodes[:, None]
    piece = of_angle * (1 - inner) / 2 * shares[:, None] * r * weight * radius**2  # N/m
    r, angle = (
        np.append(r, math.hypot(house["x"], house["y"]) / radius),
        np.append(np.broadcast_to(angle, r.shape), math.atan2(house["y"], house["x"])),
    )
    piece = np.append(piece, house["load"])
    at = angle + rotation
    return (
        float(np.sum(piece * r * radius * -np.cos(at))),
        float(np.sum(piece * -np.sin(at))) * radius,
        float(np.sum(piece * (r * radius) ** 2)) / 9.81,
    )


@pytest.mark.parametrize("house", [HOUSE, {**HOUSE, "load": 0.0}, {"load": 9e6, "x": -15.0, "y": -60.0}])
def test_a_new_mass_is_one_class(house: Any) -> None:
    """It turns as the balance of energy of its pieces says, in both directions of the slope, and in an ensemble."""

    def net(rotation: float) -> float:
        drive, load, _ = turned(rotation, house)
        return drive - MU * load

    def energy(rotation: float) -> float:
        nodes, shares = np.polynomial.legendre.leggauss(30)
        return rotation / 2 * sum(s * net(rotation * (1 + x) / 2) for x, s in zip(nodes, shares, strict=True))

    fastest = brentq(net, 0.0, 1.5, xtol=1e-15)
    rests = brentq(energy, fastest, 3.0, xtol=1e-15)
    _, _, inertia = turned(0.0, house)
    motion = solve(Scene(LoadedArc(*RIGHT, **house), MU, ["rotation"]))
    assert motion.end.rotation == pytest.approx(rests, rel=1e-11)
    assert motion.peak.angular_velocity == pytest.approx(math.sqrt(2 * energy(fastest) / inertia), rel=1e-11)
    radius, first, last, weight = RIGHT
    mirrored = LoadedArc(radius, 3 * math.pi - last, 3 * math.pi - first, weight, **{**house, "x": -house["x"]})
    assert solve(Scene(mirrored, MU, ["rotation"])).run_out == pytest.approx(motion.run_out, rel=1e-12)
    loads = np.array([0.0, house["load"]])
    both = solve(Scene(LoadedArc(*RIGHT, **{**house, "load": loads}), MU, ["rotation"], accuracy=1e-13))
    bare = solve(Scene(Arc(*RIGHT), MU, ["rotation"]))
    assert both.run_out == pytest.approx([bare.run_out, motion.run_out], rel=1e-11)
    assert both[1].run_out == pytest.approx(motion.run_out, rel=1e-11)
    by_name = grid(motion.plan.scene, {"load": [*loads, -5.0]}, accuracy=1e-13).samples
    assert by_name["run_out"][:2] == pytest.approx(both.run_out, rel=1e-11)
    assert [Status(status) == Status.INVALID for status in by_name["status"]] == [False, False, True]
    drive, load, _ = turned(0.0, house)
    for friction, moves in ((drive / load * (1 - 1e-4), True), (drive / load * (1 + 1e-4), False)):
        close = solve(Scene(LoadedArc(*RIGHT, **house), friction, ["rotation"]))
        assert close.moves == moves
        assert close.limit_friction == pytest.approx(drive / load, rel=1e-12)
    if house["load"]:
        step = 1e-4 * house["load"]
        low, high = (solve(Scene(LoadedArc(*RIGHT, **{**house, "load": house["load"] + by}), MU, ["rotation"]))
                     for by in (-step, step))  # fmt: skip
        slope = (high.run_out - low.run_out) / (2 * step)
        assert motion.sensitivity().derivative("run_out", "load") == pytest.approx(slope, rel=1e-6)
        assert str(motion.sensitivity())
