"""Hard scenes: where a straightforward solver loses its digits, its way, or its patience.

Each is data: what it is, and why it is hard. The answers are `taylor`'s; where a steady speed or a strong brake would
take a million steps, closed forms of the balance at 60 digits, time by quadrature at 30.
"""

import itertools
import math
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import mpmath
import numpy as np
import pytest
from flint import arb, ctx
from mpmath import mpf

from slipcircle import Arc, Motion, solve
from tests.support import accuracy, golden, oracle, taylor
from tests.support.combinations import softening
from tests.support.lanes import BACKENDS, backend
from tests.support.motions import finite

TURNING: dict[str, Any] = {"rotation": {}}
BRAKED: dict[str, Any] = {"rotation": {}, "centripetal": {}}
FROZEN: dict[str, Any] = {}


def arc(dip_deg: float, half: float) -> dict[str, Any]:
    middle = 1.5 * math.pi - math.radians(dip_deg)
    return {"radius": 1500.0, "theta_1": middle - half, "theta_2": middle + half, "unit_weight": 20e3, "gravity": 9.81}


SLOPE = arc(25.0, 0.5)


class Ulps(NamedTuple):
    """Friction so many units in the last place above the printed limit friction."""

    many: int


class Hard(NamedTuple):
    """Why a scene is hard, and its data; ``says`` is what the error says, for one that is to be refused."""

    why: str
    arc: Mapping[str, Any]
    friction: Any
    effects: Mapping[str, Any] = TURNING
    velocity: float = 0.0
    end: float | None = None
    says: str = ""
    tolerance: float = 1e-12

    @property
    def data(self) -> golden.Data:
        friction = self.friction
        if isinstance(friction, Ulps):
            friction = abs(float(Arc(**dict(self.arc)).dimensionless.limit_friction))
            for _ in range(abs(self.friction.many)):
                friction = float(np.nextafter(friction, math.copysign(math.inf, self.friction.many)))
        return golden.scene(friction, self.effects, self.velocity, self.end, **self.arc)


LIMIT = "the drive is a difference that has lost all digits but the last; naively moves or not, by rounding"
NEAR = "and naively E = P(x) - P(0) exp(-q x) is zero throughout to rounding: no motion, or noise"
SHARP = "friction falls within a path that no step resolves"
CASES: dict[str, Hard] = {
    "no friction": Hard("q = 0: 1/q, and no rest; naively divides by zero, or runs for ever", SLOPE, 0.0),
    "no friction, centripetal": Hard("the brake is there, and 0; naively 0/0 in exp(-q x)/q", SLOPE, 0.0, BRAKED),
    "hardly any friction": Hard("q is 1e-300: q**2 underflows; naively 1/q overflows", SLOPE, 1e-300, BRAKED, end=60.0),
    "at the limit": Hard(LIMIT, SLOPE, Ulps(0)),
    "an ulp above the limit": Hard(LIMIT, SLOPE, Ulps(1)),
    "an ulp below the limit": Hard(NEAR, SLOPE, Ulps(-1), tolerance=1e-11),
    "an ulp below the limit, frozen": Hard(NEAR, SLOPE, Ulps(-1), FROZEN, end=20.0, tolerance=1e-11),
    "an ulp below the limit, centripetal": Hard(NEAR, SLOPE, Ulps(-1), BRAKED, tolerance=1e-11),
    "a thousand ulps below": Hard(NEAR, SLOPE, Ulps(-1000), BRAKED, tolerance=1e-11),
    "an ulp below, thin arc": Hard(NEAR, arc(25.0, 1e-06), Ulps(-1), tolerance=1e-11),
    "an ulp below, half disc": Hard(NEAR, arc(25.0, math.pi / 2), Ulps(-1), BRAKED, tolerance=1e-11),
    "an ulp below, leaning back": Hard(NEAR, arc(-25.0, 0.5), Ulps(-1), tolerance=1e-11),
    "against the fall": Hard(
        "stops, turns back, and friction turns with it; naively friction keeps its sign at the turn and drives",
        SLOPE, 0.2, BRAKED, velocity=-40.0),
    "against the fall, stays": Hard(
        "stops above its start, and the resistance holds it; naively chatters about omega = 0",
        SLOPE, 0.6, velocity=-40.0),
    "a breath against the fall": Hard("turns after 1e-17 m; naively never sees the first phase",
        SLOPE, 0.2, BRAKED, velocity=-1e-08),
    "softens in a picometre": Hard(SHARP, SLOPE, softening("exponential", 0.4, 0.2, 1e-12)),
    "softens in a picometre, centripetal": Hard(SHARP, SLOPE, softening("exponential", 0.4, 0.2, 1e-12), BRAKED),
    "linear in a picometre": Hard(SHARP, SLOPE, softening("linear", 0.4, 0.2, 1e-12)),
    "hyperbolic in a picometre": Hard(SHARP, SLOPE, softening("hyperbolic", 0.4, 0.2, 1e-12)),
    "held by a peak of a picometre": Hard(
        "stable, though next to nothing holds it; naively looks at the residual friction, and runs",
        SLOPE, softening("exponential", 0.6, 0.1, 1e-12)),
    "softens in a million kilometres": Hard("the fall of friction is 1e-7 of it; naively 1 - exp(-s/l) keeps 9 digits",
        SLOPE, softening("exponential", 0.2, 0.0, 1e9)),
    "softens in a thousand million km": Hard(
        "the fall of friction is 1e-10 of it; naively 1 - exp(-s/l) keeps 6 digits",
        SLOPE, softening("exponential", 0.2, 0.0, 1e12)),
    "linear in a thousand million km": Hard("a kink beyond the moon's orbit; naively a table up to the kink",
        SLOPE, softening("linear", 0.2, 0.2, 1e12)),
    "level": Hard("no drive: J_theta is a rounding error; naively divides by J_theta", arc(0.0, 0.5), 0.3),
    "level, pushed": Hard("friction alone; naively F = resistance/0", arc(0.0, 0.5), 0.3, BRAKED, velocity=20.0),
    "level, pushed, no friction": Hard("neither drive nor friction: a pendulum from its lowest point; naively 0/0",
        arc(0.0, 0.5), 0.0, velocity=20.0),
    "all but upright": Hard("J_r is a rounding error of C_r; naively limit friction by tan of a rounded dip",
        arc(90.0 - 1e-09, 0.5), 0.3, tolerance=1e-11),
    "all but upright, leaning back": Hard("a limit friction of 6000; naively a sign of psi",
        arc(-89.99, 0.3), 0.5, BRAKED),
    "leaning back": Hard("the other way round; naively stops at once: the drive is negative",
        arc(-25.0, 0.5), 0.1, BRAKED),
    "a microradian": Hard("the moments are 1e-20, differences of 1e-6; naively NaN: 0/0 in Theta*",
        arc(25.0, 5e-07), 0.2, BRAKED),
    "half disc": Hard("artanh(sin alpha) is infinite; naively inf * 0", arc(40.0, math.pi / 2), 0.2, BRAKED),
    "arrest in a microsecond": Hard("the whole motion takes 4e-8 s", SLOPE, 3.0, BRAKED, velocity=1e-06),
    "arrest in a microsecond, frozen": Hard("the whole motion takes 4e-8 s",
        SLOPE, 3.0, {"centripetal": {}}, velocity=1e-06),
    "arrest in 1e-250 s": Hard("omega**2 is denormal; naively omega**2 = 0: never moved",
        SLOPE, 3.0, BRAKED, velocity=1e-150),
    "water carries all but 1e-12": Hard("1 - r_u is all that friction has; naively 1 - r_u in single precision",
        SLOPE, 0.5, {"rotation": {}, "pore_pressure": {"ratio": 1 - 1e-12}}, end=100.0),
    "water carries all but 1e-2, centripetal": Hard("friction by speed alone; naively clamps at zero",
        SLOPE, 0.5, {"rotation": {}, "centripetal": {}, "pore_pressure": {"ratio": 1 - 0.01}}),
    "a nanosecond": Hard("the rotation is 1e-22; naively cosh(x) - 1 = 0", SLOPE, 0.2, BRAKED, end=1e-09),
    "thirty years": Hard("rests after a minute; naively 1e9 s of steps", SLOPE, 0.2, BRAKED, end=1e9),
    "thirty years, frozen": Hard("at its terminal velocity after a minute; naively cosh overflows",
        SLOPE, 0.2, {"centripetal": {}}, end=1e9),
    "thirty years, frozen, softening": Hard("slides 1e18 m; naively a grid to 1e18 m",
        SLOPE, softening("exponential", 0.3, 0.2, 2.0), FROZEN, end=1e9),
    "thirty years, hyperbolic, terminal": Hard(
        "E is the small difference of drive and brake, for 30 years; naively refines until memory ends",
        SLOPE, softening("hyperbolic", 0.3, 0.2, 0.001), {"centripetal": {}}, end=1e9, tolerance=1e-9),
    "swings for thirty years": Hard("25 million swings; naively does them all", SLOPE, 0.0, end=1e9, says="end_time"),
    "swings until worn out": Hard("millions of swings until friction has won; naively does them all",
        SLOPE, 1e-07, end=1e9, says="end_time"),
    "floats": Hard("water carries it wherever it goes: it never rests; naively swings for ever",
        SLOPE, 0.5, {"rotation": {}, "pore_pressure": {"pressure": 1e9}}),
    "thrown over": Hard("the chord would stand upright; naively a negative normal stress",
        SLOPE, 0.2, BRAKED, velocity=500.0, says="initial_velocity"),
    "faster than light": Hard("omega**2 overflows; naively inf - inf",
        SLOPE, 0.2, FROZEN, velocity=1e+200, end=1.0, says="initial_velocity"),
    "never rests": Hard("frozen, and below its limit; naively runs for ever", SLOPE, 0.2, FROZEN, says="end_time"),
}  # fmt: skip


def answer(name: str) -> tuple[bool, tuple[mpf, ...]]:
    """Whether it comes to rest; run-out in m, duration in s and greatest speed in m/s."""
    case = CASES[name]
    if name == "floats":  # nothing presses anywhere
        return answer("no friction")
    if name in ("thirty years, frozen", "thirty years, hyperbolic, terminal"):  # at its terminal velocity
        m = oracle.numbers(Arc(**SLOPE))
        brake, time = mpf(0.2) * m["polar"], mpf(1e9) / m["scale"]
        rate = mpmath.sqrt(brake * (m["fall"] * mpmath.sin(m["dip"]) - mpf(0.2) * m["press"] * mpmath.cos(m["dip"])))
        turned, omega = mpmath.log(mpmath.cosh(rate * time)) / brake, rate / brake * mpmath.tanh(rate * time)
        return False, (turned * m["radius"], mpf(1e9), omega * m["radius"] / m["scale"])
    with ctx.workprec(400):
        p = taylor.Problem(case.data)
        if isinstance(case.friction, Ulps):  # the printed limit decides: the dip that has it exactly
            printed = arb(abs(float(Arc(**dict(case.arc)).dimensionless.limit_friction)))
            p.dip = p.lean = (printed * p.press / p.fall).atan() * (1 if p.dip > 0 else -1)
        found = taylor.Solution(p, 26, 22)
        record = found.record()
    return found.arrested, tuple(mpf(record[n]) for n in ("run_out", "duration", "peak_velocity"))


@pytest.mark.parametrize(
    ("name", "integrator"),
    [(name, x) for k, name in enumerate(CASES) for x in BACKENDS if x == BACKENDS[0] or k % 8 == 3],
)
def test_hard_scene(name: str, integrator: str) -> None:
    with backend(integrator):
        answered(name)


def answered(name: str) -> None:
    """The right answer, within its tolerance; or the right refusal."""
    case = CASES[name]
    scene = golden.built(name, case.data)
    if case.says:
        with pytest.raises(ValueError, match=f"^{case.says}( =|:)"):
            solve(scene)
        return
    motion = solve(scene)
    finite(motion)
    with mpmath.workdps(60):
        rests, right = answer(name)
        assert (motion.arrested, motion.moves) == (rests, right[1] > 0)
        for found, exact in zip((motion.run_out, motion.duration, abs(motion.peak.velocity)), right, strict=True):
            error = abs(mpf(float(found)) - (exact if found == motion.run_out else abs(exact)))
            assert error <= case.tolerance * abs(exact), (found, exact)


# --- friction that rises, or settles after much higher values --------------------------------------------------------


def tan(degrees: float) -> float:
    return math.tan(math.radians(degrees))


def scene(first: float, second: float, friction: Any, velocity: float = 0.0, end: float | None = None,
          effects: Mapping[str, Any] = TURNING) -> golden.Data:  # fmt: skip
    """A large arc between two angles in degrees."""
    arc = {"radius": 1000.0, "theta_1": math.radians(first), "theta_2": math.radians(second)}
    return golden.scene(friction, effects, velocity, end, **arc, unit_weight=2e4)


def table(*rows: tuple[float, float]) -> dict[str, Any]:
    slip, coefficient = zip(*rows, strict=True)
    return {"law": "tabulated", "slip": list(slip), "coefficient": list(coefficient)}


def strengthening(number: int) -> golden.Data:
    """A pushed mass whose friction grows from just below its limit, so that it is fastest just after its start."""
    rng = np.random.default_rng([20261121, number])
    first = rng.uniform(200.0, 235.0)
    second = first + rng.uniform(40.0, 70.0)
    m = oracle.moments(scene(first, second, 0.0)["arc"])
    limit = float(m["fall"] / m["press"] * m["dip"].tan())
    friction = {"law": ("linear", "linear", "hyperbolic")[number % 3],
                "peak": limit * (1 - 10 ** rng.uniform(-2.5, -0.7)),
                "residual": tan(rng.uniform(40.0, 60.0)), "length": float(10 ** rng.uniform(-2.5, -0.5))}  # fmt: skip
    return scene(first, second, friction, float(10 ** rng.uniform(-1.0, 0.3)))


SCENES: dict[str, golden.Data] = {
    "fastest just after its start": scene(
        229.0, 289.0, {"law": "linear", "peak": tan(10.4), "residual": tan(45.0), "length": 0.1}, 0.1
    ),
    "friction settles after a thousand millions": scene(240.0, 300.0, table((0.0, 1e9), (1e-9, 0.3)), 10.0),
    "friction settles after a peak of as much": scene(240.0, 300.0, table((0.0, 0.3), (1e-9, 1e9), (2e-9, 0.3)), 10.0),
    "friction settles after a smooth fall": scene(
        240.0, 300.0, {"law": "linear", "peak": 1e8, "residual": 0.25, "length": 1e-9}, 8.0
    ),
    **{f"strengthening {k}": strengthening(k) for k in (0, 1, 2, 5, 36)},
}


@pytest.mark.parametrize("name", SCENES)
def test_estimate_is_at_least_the_true_error(name: str) -> None:
    motion = solve(golden.built(name, SCENES[name]))
    assert isinstance(motion, Motion)
    wanted = taylor.solve(SCENES[name], [0.1, 0.4, 0.8])
    assert (motion.moves, motion.arrested) == (wanted["moves"], wanted["arrested"])
    error = max(accuracy.true_error(motion, wanted))
    assert error <= motion.error_estimate, f"{error:.1e} beside {motion.error_estimate:.1e}"
    assert motion.error_estimate < 1e-9


# --- in the phase plane ----------------------------------------------------------------------------------------------


def braked(given: golden.Data) -> tuple[mpf, mpf, mpf]:
    """Return run-out, duration and peak velocity of a mass under drag; E = omega^2 is elementary in the rotation x.

    E' + q E = 2 (fall sin(dip - x) - mu press cos(dip - x)), in digits enough for E near its zeros.
    """
    with ctx.workprec(260):
        p = taylor.Problem(given)
        numbers = (p.fall, p.press, p.polar, p.drag, p.dip, p.omega, p.scale)
        fall, press, polar, drag, dip, omega, scale = (mpf(x.mid().str(70, radius=False)) for x in numbers)
    mu, radius = mpf(given["friction"]), mpf(given["arc"]["radius"])
    q = 2 * (mu * polar + drag)

    def forced(x: mpf) -> mpf:
        across, along = mpmath.sin(dip - x), mpmath.cos(dip - x)
        return 2 * (fall * (q * across + along) - mu * press * (q * along - across)) / (q * q + 1)

    def energy(x: mpf) -> mpf:
        return forced(x) + (omega**2 - forced(mpf(0))) * mpmath.exp(-q * x)

    def slope(x: mpf) -> mpf:
        return 2 * (fall * mpmath.sin(dip - x) - mu * press * mpmath.cos(dip - x)) - q * energy(x)

    def root(f: Callable[[mpf], mpf], low: mpf, high: mpf) -> mpf:
        return mpmath.findroot(f, (low, high), solver="bisect", maxsteps=220, verify=False)

    fastest = root(slope, mpf(0), 80 / q)
    end = root(energy, 2 * fastest + mpf(10) ** -40, mpf(2))
    crowded = [mpf(0), *itertools.takewhile(lambda share: share < 0.5, (4**k / (16 + 16 * q * end) for k in range(99)))]
    inner = [mpmath.asin(mpmath.sqrt(share)) for share in crowded]  # x = end sin^2; E changes over 1/q at both ends
    edges = [*inner, *(mpmath.pi / 2 - s for s in reversed(inner))]
    duration = mpmath.quad(lambda s: end * mpmath.sin(2 * s) / mpmath.sqrt(energy(end * mpmath.sin(s) ** 2)), edges,
                           method="gauss-legendre", maxdegree=4)  # fmt: skip
    return end * radius, duration * scale, mpmath.sqrt(energy(fastest)) * radius / scale


BRAKES = {  # of what drag; how near, where not just within the estimate
    "strong": (scene(230.0, 280.0, 0.2, effects=TURNING | {"drag": {"xi": 1e-2}}), 1.0),
    "as strong as no soil has": (scene(243.0, 244.0, tan(12.0), effects=TURNING | {"drag": {"xi": 1e-3}}), 1.0),
    # The speed is held from the first micrometres on, and forgets nothing else.
    "steep": (Hard("", arc(80.0, 0.3), 0.3, TURNING | {"drag": {"xi": 1e-4}}).data, 1e-12),
    # E is rounded drive over brake, its slope nothing but rounding.
    "beyond reason": (Hard("", SLOPE, 0.2, TURNING | {"drag": {"xi": 1e-10}}).data, 1e-9),
    # The start's speed is gone within a micrometre.
    "moving": (Hard("", SLOPE, 0.2, TURNING | {"drag": {"xi": 1e-4}}, 1.0).data, 1e-11),
}


@pytest.mark.parametrize("name", BRAKES)
def test_a_drag_that_takes_up_the_drive(name: str) -> None:
    """Speed is the balance of drive and drag all the way."""
    given, nearest = BRAKES[name]
    motion = solve(golden.built(name, given))
    estimate = motion.error_estimate
    finite(motion)
    with mpmath.workdps(60):
        wanted = braked(given)
        assert motion.arrested
        for found, exact in zip((motion.run_out, motion.duration, float(motion.peak.velocity)), wanted, strict=True):
            error = float(abs(mpf(found) / exact - 1))
            assert error <= (estimate if nearest == 1.0 else nearest), f"{error:.1e} beside {estimate:.1e}"
