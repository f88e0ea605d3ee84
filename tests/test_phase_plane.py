"""Closed forms of phases of motion: proofs, plain integration with many digits, and the integrator in time."""

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import cache, partial
from types import SimpleNamespace
from typing import Any

import mpmath
import numpy as np
import pytest
from sympy import Add, hyper, lambdify

from derive.algebra import phase_plane
from derive.algebra.phase_plane import drive, q, sine, vers, x
from derive.check.proof import ProofError
from derive.flow import closed
from derive.flow.integrator import energy, hyperbolic, one_lane, recurrence, softening, swing, waves
from derive.flow.layout import STRIDE
from generated import layout as ix
from slipcircle import Arc, Scene, load, plan, solve
from slipcircle.core.problem.problem import problem_of
from slipcircle.derivatives import with_parameter_arrays
from tests.campaigns import estimates
from tests.support import lanes, oracle, taylor
from tests.support.phases import COUNT, EFFECTS, TURNING, in_time, random_scene

SOFTENING_LAWS = ("exponential", "hyperbolic")
TABLE: dict[str, Any] = {"law": "tabulated", "slip": [0.0, 0.5, 2.0, 30.0], "coefficient": [0.35, 0.3, 0.2, 0.14]}
DECIDED = [ix.STATUS, ix.PHASES, ix.TURNS, ix.DIRECTION, ix.LAST_WAY, ix.LIFTED, ix.PASSED]
MEASURED = [ix.REST_SINCE, ix.PEAK_TIME, ix.PEAK_ROTATION, ix.PEAK_OMEGA, ix.REACH_ROTATION, ix.REACH_TIME]
AT_END = [ix.END_ROTATION, ix.END_OMEGA, ix.END_RATE]


def agree(one: Any, other: Any, within: float) -> bool:
    measured = np.allclose(one[MEASURED], other[MEASURED], rtol=within, atol=0.0, equal_nan=True)
    return measured and bool(np.array_equal(one[DECIDED], other[DECIDED]))


@pytest.mark.parametrize("name", EFFECTS)
def test_phases_in_closed_form_are_those_integrated_in_time(name: str) -> None:
    """Reversals, lift-off, an upright chord, end times and initial velocities included."""
    every = slice(COUNT)
    compiled = lanes.BACKENDS[0]
    for end, which, backend in ((None, every, compiled), (12.0, every, compiled), (30.0, slice(8), "NumPy")):
        problem = lanes.posed(random_scene(EFFECTS[name], end), 1e-15)
        expected = lanes.integrate(in_time(problem), which)
        found = lanes.integrate(problem, which, backend)
        assert agree(found, expected, 1e-12)
        assert np.allclose(found[AT_END], expected[AT_END], rtol=1e-12, atol=1e-15)
        assert end or found[ix.STEPS].sum() < expected[ix.STEPS].sum()


@pytest.mark.parametrize("name", EFFECTS)
@pytest.mark.parametrize("backend", lanes.BACKENDS)
def test_states_at_output_times_are_those_integrated_in_time(name: str, backend: str) -> None:
    """Output times change no result, and one of them is a time of rest."""
    which = slice(COUNT if backend == "C" else 8)
    problem = lanes.posed(random_scene(EFFECTS[name], 30.0), 1e-15)
    ends = lanes.integrate(problem, which, backend)
    times = np.sort(np.append(np.linspace(0.0, 1.2 * ends[ix.REST_SINCE].min(), 12), ends[ix.REST_SINCE].min()))
    times = np.repeat(times[:, None], ends.shape[1], axis=1)
    states = []
    for posed in (problem, in_time(problem)):
        samples = lanes.OutputSamples(times, np.full((4, *times.shape), np.nan))
        found = lanes.integrate(posed, which, backend, samples=samples)
        states.append(samples.states)
        if posed is problem:
            assert agree(found, ends, 1e-12)
    assert np.allclose(states[0], states[1], rtol=1e-11, atol=1e-14)


def test_an_end_time_just_before_rest_keeps_the_digits_of_the_speed() -> None:
    """Near rest the speed is the net moment times the time that is left."""
    scene: Scene[Any] = Scene(Arc(1000.0, 4.0, 5.0, 20e3), 0.2, TURNING)
    left = 1e-6
    duration = solve(scene).duration
    problem = lanes.posed(replace(scene, end_time=np.repeat(duration - left, 2)), 1e-9)
    found = lanes.integrate(problem)[:, 0]
    per_second = scene.arc.time_scale
    assert found[ix.STATUS] == ix.ENDED
    assert found[ix.END_OMEGA] == pytest.approx(-found[ix.END_RATE] * (left / per_second), rel=1e-7)


@pytest.mark.parametrize("accuracy", [1e-3, 1e-6, 1e-9, 1e-12])
@pytest.mark.parametrize("law", ["", "exponential", "linear", "hyperbolic"])
def test_series_in_time_reach_the_requested_accuracy(law: str, accuracy: float) -> None:
    """Times of rests, peak speeds and run-outs in time are those in the rotation to rounding, lane by lane.

    Without friction, swings in both directions are equally fast.
    """
    for name in EFFECTS:
        scene = random_scene(EFFECTS[name], 30.0, law)
        expected = lanes.integrate(lanes.posed(scene, 1e-15))
        found = lanes.integrate(in_time(lanes.posed(scene, accuracy)))
        assert np.array_equal(found[ix.STATUS], expected[ix.STATUS])
        for place in (ix.REST_SINCE, ix.PEAK_OMEGA, ix.REACH_ROTATION):
            np.testing.assert_allclose(abs(found[place]), abs(expected[place]), rtol=accuracy, atol=1e-300)


@pytest.mark.parametrize("law", ["linear", "tabulated"])
@pytest.mark.parametrize("name", EFFECTS)
def test_phases_in_powers_of_the_rotation_are_those_integrated_in_time(name: str, law: str) -> None:
    """Friction softens in pieces; a third of the masses are pushed, in both directions."""
    for end, which, backend in ((None, slice(COUNT), lanes.BACKENDS[0]), (30.0, slice(8), "NumPy")):
        scene = random_scene(EFFECTS[name], end, softens="linear")
        if law == "tabulated":
            scene = replace(scene, friction=TABLE)
        problem = lanes.posed(scene, 1e-15)
        assert problem.program.by_rotation
        expected = lanes.integrate(in_time(problem), which)
        found = lanes.integrate(problem, which, backend)
        assert agree(found, expected, 1e-12)
        assert end or found[ix.STEPS].sum() < expected[ix.STEPS].sum()


@pytest.mark.parametrize("name", lanes.BACKENDS)
def test_a_speed_that_falls_before_it_rises_to_its_peak_within_a_step(name: str) -> None:
    """Friction that falls and rises with slip makes the speed of a pushed mass low and then high within one piece."""
    slip, coefficient = (
        [0.0, 85.2, 380.0, 385.7, 417.6, 440.6, 785.7],
        [0.096, 0.382, 0.117, 0.335, 0.181, 0.545, 0.139],
    )
    law: Any = {"law": "tabulated", "slip": slip, "coefficient": coefficient}
    effects: Any = TURNING | {"cohesion": {"cohesion": 445.0}, "drag": {"xi": np.linspace(600.0, 800.0, 8)}}
    scene: Scene[Any] = Scene(Arc(1475.6, 5.30215, 5.75488, 20e3), law, effects, 29.277992469160623)
    problem = lanes.posed(scene, 1e-13)
    assert agree(lanes.integrate(problem, slice(None), name), lanes.integrate(in_time(problem)), 1e-11)


@pytest.mark.parametrize("name", lanes.BACKENDS)
def test_a_step_of_uncertain_duration_is_halved(name: str) -> None:
    """Near the limit a second rest is close behind the start; steps in time would be twice as many."""
    law: Any = {"law": "linear", "peak": np.array([0.3, 0.35]), "residual": 0.14, "length": 1.0}
    problem = lanes.posed(replace(load("vaiont"), friction=law), 1e-9)
    assert lanes.integrate(problem, slice(None), name)[ix.STEPS].tolist() == [2, 3]


def test_estimates_see_the_error_of_series_in_the_rotation() -> None:
    """Water in polynomials of the rotation: a series may have small terms before a larger one, which all runs need."""
    cases = estimates.compared(2, seed=83)
    assert cases
    assert all(case.error <= case.estimate for case in cases)


@pytest.mark.parametrize("law", SOFTENING_LAWS)
@pytest.mark.parametrize("name", EFFECTS)
def test_softening_phases_in_closed_form_are_those_integrated_in_time(name: str, law: str) -> None:
    """Compare all motions, and within 1e-11 the motions without steps in time."""
    for end, which, backend in ((None, slice(COUNT), lanes.BACKENDS[0]), (30.0, slice(8), "NumPy")):
        scene = random_scene(EFFECTS[name], end, softens=law)
        expected = lanes.integrate(in_time(lanes.posed(scene, 1e-15)), which)
        steps = lanes.integrate(in_time(lanes.posed(scene, 1e-9)), which)[ix.STEPS]
        found = lanes.integrate(lanes.posed(scene, 1e-9), which, backend)
        assert agree(found, expected, 1e-8)
        at_once = (found[ix.STEPS] == found[ix.PHASES]) & (steps > found[ix.STEPS])
        assert end or at_once.any()
        assert agree(found[:, at_once], expected[:, at_once], 1e-11)


@pytest.mark.parametrize("law", SOFTENING_LAWS)
@pytest.mark.parametrize("name", EFFECTS)
def test_softening_phases_in_closed_form_are_accurate_to_rounding(name: str, law: str) -> None:
    """Single scenes, and ensembles of fine accuracy, have rules of more nodes."""
    scene = random_scene(EFFECTS[name], None, softens=law)
    problem = lanes.posed(scene, 1e-15)
    found, expected = lanes.integrate(problem), lanes.integrate(in_time(problem))
    at_once = found[ix.STEPS] < expected[ix.STEPS]
    assert at_once.sum() > 5
    assert agree(found[:, at_once], expected[:, at_once], 1e-14)


@pytest.mark.parametrize("law", SOFTENING_LAWS)
@pytest.mark.parametrize("length", [1.0, 20.0, 500.0])
def test_softening_ensembles_have_the_digits_of_a_plain_integration(length: float, law: str) -> None:
    """Vaiont at three frictions, the last one near the limit, by Taylor series in time with twenty digits."""
    vaiont: Scene[Any] = load("vaiont")
    peaks = np.tan(np.radians([10.0, 19.5, 22.7]))
    frictions = [{"law": law, "peak": peak, "residual": 0.14, "length": length} for peak in (peaks, *peaks)]
    found = solve(replace(vaiont, friction=frictions[0]), 1e-9).outcomes
    for lane, friction in enumerate(frictions[1:]):
        given = {"arc": oracle.plain(vaiont.arc), "effects": dict(vaiont.called), "initial_velocity": 0.0}
        exact = taylor.solve(given | {"friction": friction, "end_time": None}, digits=20)
        for name in ("run_out", "duration", "peak_velocity"):
            assert found[name][lane] == pytest.approx(float(exact[name]), rel=1e-10), name


@pytest.mark.parametrize("law", [{"law": "linear", "peak": 0.35, "residual": 0.14, "length": 20.0}, TABLE])
def test_pieces_have_the_digits_of_a_plain_integration(law: dict[str, Any]) -> None:
    """Vaiont with three cohesions, by Taylor series in time with twenty digits."""
    vaiont: Scene[Any] = load("vaiont")
    cohesions = np.array([0.0, 2e4, 1e5])
    effects = [TURNING | {"cohesion": {"cohesion": cohesion}} for cohesion in (cohesions, *cohesions)]
    found = solve(replace(vaiont, friction=law, effects=effects[0]), 1e-9).outcomes
    for lane, of_lane in enumerate(effects[1:]):
        given = {"arc": oracle.plain(vaiont.arc), "effects": of_lane, "initial_velocity": 0.0}
        exact = taylor.solve(given | {"friction": law, "end_time": None}, digits=20)
        for name in ("run_out", "duration", "peak_velocity"):
            assert found[name][lane] == pytest.approx(float(exact[name]), rel=1e-11), name


# --- E and the duration, with many digits ----------------------------------------------------------------------------


@cache
def regular_energy() -> Callable[..., Any]:
    """Return E as a function of mpmath, regular at q = 0."""
    terms = [factor * function for factor, function in zip(phase_plane.constant(), phase_plane.BASIS, strict=True)]
    terms[1] = phase_plane.constant()[1] * x**2 * hyper([1], [3], -q * x) / 2
    return lambdify((x, drive, sine, vers, q), Add(*terms), "mpmath")


def energy_at(at: Any, numbers: Sequence[Any], softens: Sequence[Any] = ()) -> Any:
    """Return E at a rotation as a number of mpmath, from drive, sine, vers and q.

    ``softens`` are slope, brake, load, load_sine and load_vers of exponential softening.
    """
    numbers = [mpmath.mpf(number) for number in numbers]
    if not softens:
        return regular_energy()(at, *numbers)
    fall = mpmath.exp(-softens[0] * at)
    total = mpmath.mpf(0)
    for j, problem in enumerate(phase_plane.softening()):
        numbers_of = lambdify((drive, sine, vers, q, *phase_plane.SOFTENING), [*problem.values()], "mpmath")
        of_term = numbers_of(*numbers, *softens)
        term = fall**j * energy_at(at, of_term)
        total += term
        if j > 1 and abs(term) <= mpmath.eps * abs(total):
            break
    return mpmath.exp(softens[1] * fall / softens[0]) * total


def by_quadrature(numbers: Any, at: Any, softens: Any = (1, 0, 0, 0, 0), law: str = "exponential") -> Any:
    """E by the integrating factor of the linear equation, of a law of softening if there are numbers for it."""
    drive, sine, vers, q = map(mpmath.mpf, numbers)
    slope, brake, load, load_sine, load_vers = map(mpmath.mpf, softens)

    def left(x: Any) -> Any:
        return mpmath.exp(-slope * x) if law == "exponential" else 1 / (1 + slope * x)

    def weighted(x: Any) -> Any:
        s, v = mpmath.sin(x), 1 - mpmath.cos(x)
        net = drive + sine * s + vers * v + left(x) * (load + load_sine * s + load_vers * v)
        since = left(at) - left(x) if law == "exponential" else mpmath.log(left(at) / left(x))
        return 2 * net * mpmath.exp(q * (x - at) + brake / slope * since)

    return mpmath.quad(weighted, [0, at], method="gauss-legendre")


CONSTANT = (0.02, -0.9, -0.02, 0.3)


@pytest.mark.parametrize("q", [0.0, 1e-12, 0.3, 2.0])
def test_e_under_constant_friction_solves_the_equation(q: float) -> None:
    numbers = (*CONSTANT[:3], q)
    with mpmath.workdps(30):
        for at in (1e-6, 0.04, 1.5):
            exact = by_quadrature(numbers, mpmath.mpf(at))
            assert abs(energy_at(mpmath.mpf(at), numbers) / exact - 1) < 1e-20
            e, b = [0.0] * 5, [0.0] * 4
            energy.factors(e, *numbers)
            energy.functions(b, at, q)
            assert energy.energy(e, b) == pytest.approx(float(exact), rel=1e-14)


@pytest.mark.parametrize("distance", [0.0, 1e-10, -1e-6, 0.3])
@pytest.mark.parametrize("order", [1, 2])
def test_e_under_exponential_softening_passes_resonances(order: int, distance: float) -> None:
    """The plain series divides by zero where q is a multiple of the decay, 2 k = n R/length."""
    q = 0.6
    softens = (q / order * (1 + mpmath.mpf(distance)), 0.4, 0.05, 0.3, -0.1)
    with mpmath.workdps(25):
        found = energy_at(mpmath.mpf(0.7), (*CONSTANT[:3], q), softens)
        assert abs(found / by_quadrature((*CONSTANT[:3], q), mpmath.mpf(0.7), softens) - 1) < 1e-16


SOFTENING = (8.0, 0.1, -0.09, 0.2, -0.1)  # slope, brake, load, load_sine, load_vers


def softening_lanes(numbers: Sequence[float], softens: Sequence[float], law: str = "exponential") -> Any:
    """Return the cells of a lane with a law of softening, from the numbers of `energy_at`."""
    values = dict(zip(closed.PROBLEM, (*numbers, *softens), strict=True))
    return closed.lane(values, softens[0] if law == "hyperbolic" else 0)


@pytest.mark.parametrize("law", SOFTENING_LAWS)
@pytest.mark.parametrize("softens", [SOFTENING, (8.0, 0.0, *SOFTENING[2:]), (1.0, 0.06, 0.02, -0.1, 0.1)])
def test_e_under_softening_solves_the_equation(softens: Any, law: str) -> None:
    """E by quadrature of the definition, and its derivatives by differences with thirty digits."""
    numbers = (0.1, *CONSTANT[1:])
    s, e, f = softening_lanes(numbers, softens, law), [0.0] * STRIDE, [0.0] * STRIDE
    softening.softening_factors(s, e)
    with mpmath.workdps(30):
        for at in (1e-4, 0.04, 0.3):
            exact = partial(by_quadrature, numbers, softens=softens, law=law)
            softening.evaluate_at(s, e, f, at)
            expected = [exact(mpmath.mpf(at)), *(mpmath.diff(exact, at, order) for order in (1, 2))]
            assert f[5:8] == pytest.approx([float(x) for x in expected], rel=1e-12)


@pytest.mark.parametrize("law", SOFTENING_LAWS)
@pytest.mark.parametrize("distance", [1e-3, 1e-7, 1e-12])
def test_e_near_the_end_of_a_phase_has_no_rounding_error(distance: float, law: str) -> None:
    """Friction still softens at the end, which is the number next to the zero of E."""
    numbers = (0.1, *CONSTANT[1:])
    s, e, back, f = softening_lanes(numbers, SOFTENING, law), *([0.0] * STRIDE for _ in range(3))
    softening.softening_factors(s, e)
    with mpmath.workdps(40):
        end = mpmath.findroot(lambda x: by_quadrature(numbers, x, SOFTENING, law), 0.2)
        softening.softening_functions(s, e, f, float(end))
        softening.factors_about_end(s, back, e, f)
        exact = by_quadrature(numbers, end - mpmath.mpf(distance), SOFTENING, law)
    past = -math.log1p(-distance / (float(end) + 1.0 / s.per_pole)) if s.has.per_pole else distance
    assert softening.energy_past(s, back, f, past, float(end), 1) == pytest.approx(float(exact), rel=1e-13)


@pytest.mark.parametrize("slope", [1 + 1e-12, 0.5 + 1e-12, 1.9, 2.1])
def test_the_plain_series_is_not_used_near_resonances(slope: float) -> None:
    """The integrator divides by q - slope and q - 2 slope, in units of q, and has no digits where these are small."""
    numbers, softens = (0.1, -0.9, 0.1, 0.6), (0.6 * slope, 0.01, -0.05, 0.2, -0.1)
    s, e, f = softening_lanes(numbers, softens), [0.0] * STRIDE, [0.0] * STRIDE
    softening.softening_factors(s, e)
    softening.evaluate_at(s, e, f, 0.2)
    exact = float(by_quadrature(numbers, mpmath.mpf(0.2), softens))
    assert (abs(f[5] / exact - 1) < 1e-12) == (slope > 1.5)
    assert softening.series_suffices(s, e) == (slope > 2)


def test_slow_starts_under_softening_friction_and_cohesion_keep_the_closed_form() -> None:
    """Durations that a rule leaves uncertain, as many near the limit of a slope, follow from one of more nodes."""
    slope: Scene[Any] = load("real-slope")
    peaks = np.asarray(slope.numbers["friction.peak"]) * np.linspace(0.98, 1.0, 40)
    scenes, invalid = with_parameter_arrays(slope, {"friction.peak": peaks})
    found = lanes.integrate(problem_of(plan(scenes, 1e-9), invalid))
    expected = lanes.integrate(in_time(problem_of(plan(scenes, 1e-15), invalid)))
    assert np.mean(found[ix.STEPS] <= 1.0) > 0.9
    for place in (ix.REST_SINCE, ix.PEAK_OMEGA, ix.PEAK_TIME, ix.REACH_ROTATION):
        np.testing.assert_allclose(found[place], expected[place], rtol=1e-9)


@pytest.mark.parametrize("degree", [2 * one_lane.SHORTEST - 1, 2 * one_lane.SHORTEST - 2])
def test_both_last_coefficients_of_an_integrand_decide(degree: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """The integrand is 1 + c P(v), with a polynomial of Legendre that the rule just resolves."""
    nodes = np.array(one_lane.NODES[one_lane.SHORTEST : 3 * one_lane.SHORTEST])
    unit = 1e-3
    share = 1 / (unit * nodes**2 + 1)
    for part, uncertain in ((1e-7, False), (1e-4, True)):
        integrand = 1 + part * np.polynomial.Legendre.basis(degree)(2 * nodes - 1)
        energies = iter((share**2 * nodes / integrand) ** 2)
        monkeypatch.setattr(softening, "softening_functions", lambda *_: None)
        monkeypatch.setattr(softening, "softening_energy", lambda *_, given=energies: next(given))
        monkeypatch.setattr(softening, "count_from_end", lambda *_: None)
        lane = SimpleNamespace(highest=17, has=SimpleNamespace(per_pole=False))
        time = softening.time_of_part(lane, [], 1.0, unit, 0.0, 1, 0)
        assert time == (math.inf if uncertain else pytest.approx(2 * unit, rel=1e-6))


SWINGS = [(0.05 * share, -0.9, -0.05 * share, 0.3) for share in (1e-9, 0.5)]
SWINGS += [(0.3, -0.45, -0.1, 0.8), (0.25, -0.45, -0.1, 0.3)]  # up to 0.9 and 1.1 rad


@pytest.mark.parametrize("numbers", SWINGS)
def test_a_phase_keeps_its_digits(numbers: tuple[float, float, float, float]) -> None:
    """A phase, with a tiny drive or of a long way, has its rotation and times by quadrature with thirty digits."""
    e, back = [0.0] * 5, [0.0] * 5
    of_drive, of_sine, of_vers, decay = numbers
    s = SimpleNamespace(drive=of_drive, net_sine=of_sine, net_vers=of_vers, net_square=-decay / 2)
    s.has = SimpleNamespace(loss_rate=False)
    energy.factors(e, *numbers)
    end = swing.end_of_swing(s, e, numbers[1], True)
    b = [0.0] * 4
    energy.functions(b, end, numbers[3])
    energy.mirror(back, *numbers, b)
    at_peak, w = [0.0] * STRIDE, [0.0] * STRIDE
    peak = swing.peak_of_swing(s, e, at_peak, 0.5 * end, end, True)
    duration = swing.duration_of_swing(e, back, end, w, True)
    before = waves.time_to(w, peak, end)
    there = [0.0] * STRIDE
    with mpmath.workdps(60):
        given = [mpmath.mpf(x) for x in numbers]
        exact = mpmath.findroot(lambda x: energy_at(x, given) / x, end)
        top = mpmath.findroot(lambda x: mpmath.diff(partial(energy_at, numbers=given), x), peak)

        def spent(u: Any) -> Any:
            x = exact * mpmath.sin(u) ** 2
            return exact * mpmath.sin(2 * u) / mpmath.sqrt(abs(energy_at(x, given)))

        whole = mpmath.quad(spent, [0, mpmath.pi / 4, mpmath.pi / 2])
        part = mpmath.quad(spent, [0, mpmath.asin(mpmath.sqrt(top / exact))])
        for share in (0.1, 0.6, 0.99):
            time = share * duration
            there[waves.ANGLE_THERE] = 0.5 * time / w[0]
            waves.find_state(s, there, True, e, back, w, end, time)
            place = mpmath.mpf(there[0])
            since = mpmath.quad(spent, [0, mpmath.asin(mpmath.sqrt(place / exact))])
            speed, rate = (
                mpmath.sqrt(energy_at(place, given)),
                mpmath.diff(partial(energy_at, numbers=given), place) / 2,
            )
            assert time == pytest.approx(float(since), rel=2e-14)
            assert there[1:3] == pytest.approx([float(speed), float(rate)], rel=1e-13)
        greatest, bend = energy_at(top, given), mpmath.diff(partial(energy_at, numbers=given), top, 2)
    found = (end, duration, peak, before, at_peak[9])
    assert found == pytest.approx([float(x) for x in (exact, whole, top, part, greatest)], rel=2e-14)
    assert abs(at_peak[10]) <= 1e-14 * abs(bend) * peak


def test_the_derivatives_of_e_under_constant_friction_are_those_of_its_closed_form() -> None:
    """Differences with thirty digits, up to the third one, which shortens the search for the peak."""
    numbers, f = (0.3, -0.45, -0.1, 0.8), [0.0] * STRIDE
    e = [0.0] * 5
    s = SimpleNamespace(drive=0.3, net_sine=-0.45, net_vers=-0.1, net_square=-0.4, has=SimpleNamespace(loss_rate=False))
    energy.factors(e, *numbers)
    softening.evaluate_at(s, e, f, 0.7)
    with mpmath.workdps(30):
        exact = partial(energy_at, numbers=[mpmath.mpf(x) for x in numbers])
        expected = [float(mpmath.diff(exact, 0.7, order)) for order in range(4)]
    assert f[5:9] == pytest.approx(expected, rel=1e-14)


def test_a_time_that_the_rules_do_not_resolve_is_uncertain() -> None:
    e, back = [1.0, 0.0, 0.0, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0, 0.0]
    duration = swing.duration_of_swing(e, back, 1.0, [0.0] * STRIDE, True)  # E = x from rest and from the end
    assert duration == math.inf


def test_functions_without_cancellation() -> None:
    for angle in (1e-9, 0.1, 1.0, 3.14):
        with mpmath.workdps(40):
            exact = (angle - mpmath.sin(angle), 1 - mpmath.cos(angle))
            y = mpmath.mpf(min(angle, 2.0))
            fading = float((y - 1 + mpmath.exp(-y)) / y**2)
        assert energy.turned(angle) == pytest.approx([float(v) for v in exact], rel=4e-15)
        assert energy.faded(float(y)) == pytest.approx(fading, rel=1e-15)


# --- faults ----------------------------------------------------------------------------------------------------------


def test_a_fault_of_the_closed_form_is_not_proved(monkeypatch: pytest.MonkeyPatch) -> None:
    right, softens, complete = energy.factors, softening.softening_factors, recurrence.complete_net

    def wrong(e: Any, *problem: Any) -> None:
        right(e, *problem)
        e[1] = -e[1]

    def wrong_term(s: Any, e: Any) -> None:
        softens(s, e)
        e[softening.SINE + 2] = -e[softening.SINE + 2]

    def wrong_series(s: Any, e: Any) -> None:
        softens(s, e)
        e[hyperbolic.POWER + 2 * hyperbolic.HALF] *= 1 + 1e-9

    def wrong_weight(s: Any, weight: Any, n: int) -> None:
        complete(s, weight, n)
        weight[n] *= 1.01 if n == 1 else 1

    faults: list[tuple[Any, str, Any, str]] = [
        (softening, "softening_factors", wrong_term, "E under softening friction in the integrator"),
        (softening, "softening_factors", wrong_series, "E under hyperbolic friction in the integrator"),
        (recurrence, "complete_net", wrong_weight, "E in a piece of a table in the integrator"),
        (energy, "factors", wrong, "E in the integrator"),
    ]
    for module, name, fault, claim in faults:
        with monkeypatch.context() as patch:
            patch.setattr(module, name, fault)
            with pytest.raises(ProofError, match=claim):
                closed.prove()
        monkeypatch.setattr(closed, "_prove_softening", lambda: None)  # it takes longest, and its fault comes first
    monkeypatch.setattr(phase_plane, "NET", phase_plane.NET + phase_plane.x)
    with pytest.raises(ProofError, match="term 0 under softening"):
        phase_plane.prove()
