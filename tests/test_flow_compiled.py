"""The compiled integrator beside the one in NumPy: the same lanes, whatever their neighbours, wherever interrupted."""

import os
import platform
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import slipcircle
from generated import integrator as in_numpy
from generated import layout as ix
from slipcircle.core.integrator.compiled import encoded
from slipcircle.tables import Series
from tests.support.lanes import (
    BACKENDS,
    BINARY,
    COUNTED,
    RESULTS,
    OutputSamples,
    Program,
    backend,
    compiled,
    integrate,
    needs_binary,
    posed,
)
from tests.support.problems import LANES, MU, PUSHED, SCENES, SHAKEN, TURNING, problem

pytestmark = needs_binary


@pytest.mark.parametrize("name", SCENES)
def test_a_lane_is_the_same_alone_in_any_order_and_when_interrupted(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    bound = problem(name)
    whole, order = integrate(bound), np.random.default_rng(1).permutation(LANES)
    assert np.array_equal(integrate(bound, order), whole[:, order], equal_nan=True)
    alone = [integrate(bound, [k])[:, 0] for k in range(LANES)]
    assert np.array_equal(np.array(alone).T, whole, equal_nan=True)
    monkeypatch.setattr(compiled, "ROUNDS", 2)
    assert np.array_equal(integrate(bound), whole, equal_nan=True)


@pytest.mark.parametrize("start", [{}, {"omega": 0.0}, {"omega": -0.1}], ids=["pushed", "from rest", "up-slope"])
@pytest.mark.parametrize("name", SCENES)
def test_lanes_that_share_cells_are_the_same_as_with_their_own(
    name: str, start: dict[str, float], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Numbers that all lanes share at the start are computed once, also if lanes are not solved or are interrupted."""
    bound = problem(name)
    bound.start = {**bound.start, **start}
    failed = np.arange(LANES) % 19 == 18
    bound.begin_with(STATUS=np.where(failed, ix.FAILED, ix.START), LAST_WAY=np.linspace(-1.0, 1.0, LANES))
    expected = integrate(bound)
    for rounds in (compiled.ROUNDS, 2):
        monkeypatch.setattr(compiled, "ROUNDS", rounds)
        cells, shared = bound.sparse_cells()
        shared[ix.STATUS] = np.nan
        assert np.count_nonzero(np.isnan(shared)) < 8
        compiled.integrate(bound.program, bound.tables(), cells, shared=shared)
        assert np.array_equal(cells[RESULTS][:, ~failed], expected[:, ~failed], equal_nan=True)


def alike(one: Any, other: Any, within: float) -> None:
    """Compare the states: counts and decisions exactly, other numbers to rounding."""
    for row, (a, b) in enumerate(zip(one, other, strict=True)):
        same = (a == b) | (np.isnan(a) & np.isnan(b))
        if row in COUNTED:
            assert np.all(same), row
        size = np.max(np.abs(a[np.isfinite(a)]), initial=1.0 if row in (ix.PEAK_RATE, ix.END_RATE) else 1e-300)
        assert np.all(np.abs(a[~same] - b[~same]) <= within * size), row


@pytest.mark.parametrize("name", SCENES)
def test_the_integrator_in_numpy_is_the_same(name: str) -> None:
    bound = problem(name)
    alike(integrate(bound), integrate(bound, name="NumPy"), 1e-11)


@pytest.mark.parametrize("name", SCENES)
def test_the_registers_are_those_of_numpy(name: str) -> None:
    """Registers of all lanes equal NumPy's where a phase begins and after it."""
    bound, found = problem(name), []
    for module in (compiled, in_numpy):
        cells = bound.cells()
        begun = module.begin_phase(bound.program, bound.tables(), cells)
        found.append([*begun, *module.registers(bound.program, bound.tables(), cells)])
    np.testing.assert_allclose(found[0], found[1], rtol=1e-12, atol=1e-14)


@pytest.mark.parametrize("name", SCENES)
def test_every_kind_of_processor_gives_the_same(name: str) -> None:
    bound = problem(name)
    for level in BINARY.LEVELS:
        alike(integrate(bound), integrate(bound, level=level), 1e-12)


FRICTION: dict[str, Any] = {
    "constant": MU,
    "exponential": {"law": "exponential", "peak": MU, "residual": 0.7 * MU, "length": 20.0},
    "rate": {"law": "rate_weakening", "peak": MU, "residual": 0.7 * MU, "velocity": 1.0},
}
ONE_WAY, TWO_WAYS = {"horizontal": SHAKEN["horizontal"]}, SHAKEN
STRAIGHT: dict[str, tuple[str, dict[str, Any]]] = {
    "": ("vaiont", {}),
    "level of water": ("valley-side", {}),
    "record": ("vaiont", {"shaking": ONE_WAY}),
    "record, two directions": ("vaiont", {"shaking": TWO_WAYS}),
    "cohesion": ("vaiont", {"cohesion": {"cohesion": 2e5}}),
}


def interpreted(program: Program) -> bytes:
    """Return a program with its last operation twice, which no function has."""
    code = np.frombuffer(encoded(program), np.int32)
    end = 9 + len(ix.ROLES) + int(code[5:8].sum())
    again = code[end - 8 : end]  # a sum of two terms
    longer = np.concatenate([code[:end], again, code[end:]])
    longer[7] += 8
    return longer.tobytes()


@pytest.mark.parametrize("of", STRAIGHT)
@pytest.mark.parametrize("law", FRICTION)
def test_a_straight_line_program_has_the_bits_of_its_interpretation(law: str, of: str, monkeypatch: Any) -> None:
    name, called = STRAIGHT[of]
    slide: Any = slipcircle.load(name)
    scene = replace(slide, friction=FRICTION[law], effects=TURNING | called, initial_velocity=PUSHED)
    bound = posed(scene, 1e-11)
    # Cohesion is a cell: the first one serves. Constant friction alone has none, as it is solved in the phase plane.
    number = list(STRAIGHT).index(of) % 4 + 4 * list(FRICTION).index(law) - 1
    own = {level for level in BINARY.LEVELS if level != "baseline" or platform.machine() not in ("x86_64", "AMD64")}
    chosen = next(level for level, kind in BINARY.LEVELS.items() if kind == compiled.widest())
    way = "straight-line" if chosen in own and number >= 0 else "interpreted"
    assert slipcircle.plan(scene).method.endswith(f"; {way}")
    for level, kind in BINARY.LEVELS.items():
        assert BINARY.straight_line(encoded(bound.program), kind) == (number if level in own else -1)
        assert BINARY.straight_line(interpreted(bound.program), kind) == -1
        straight = integrate(bound, level=level)
        with monkeypatch.context() as patched:
            patched.setattr(compiled, "encoded", interpreted)
            assert np.array_equal(integrate(bound, level=level), straight, equal_nan=True)


def test_samples_and_notes_are_those_of_numpy() -> None:
    bound = problem("record")
    unit = float(np.asarray(slipcircle.load("vaiont").arc.time_scale))
    times = np.tile(np.linspace(0.0, 30.0, 61)[:, None] / unit, (1, LANES))
    states, notes = [], []
    for name in BACKENDS:
        samples, log = OutputSamples(times, np.full((4, 61, LANES), np.nan)), list[Any]()
        integrate(bound, name=name, samples=samples, log=log)
        states.append(samples.states)
        notes.append([(k, round(t, 9)) for k, t, *_ in log if k in (ix.NOTE_BEGINS, ix.NOTE_STANDS)])
    assert np.all(np.isfinite(states))
    # The rate leaps where a sample meets a standstill or a break.
    for row in (0, 1, 3):
        one, other = states[0][row], states[1][row]
        assert np.max(np.abs(one - other)) <= 1e-10 * np.max(np.abs(one))
    assert notes[0] == notes[1]


@pytest.mark.parametrize("name", BACKENDS)
def test_friction_that_falls_below_the_smallest_numbers(name: str) -> None:
    """It softens a thousand times over, to 2^-1022 and below, which counts as zero: the run-out is the residual's."""
    slide: slipcircle.Scene[Any] = slipcircle.load("vaiont")
    residual = np.tan(np.radians(14.0))
    law: dict[str, Any] = {"law": "exponential", "peak": 1.001 * residual, "residual": residual, "length": 0.005}
    with backend(name):
        softened = slipcircle.solve(replace(slide, friction=law))
        unsoftened = slipcircle.solve(replace(slide, friction=residual))
    assert softened.run_out > 1000 * 0.005
    assert softened.run_out == pytest.approx(unsoftened.run_out, rel=1e-6)
    least = np.nextafter(0.0, 1.0, dtype=np.float64)
    assert least + least > 0.0  # for everybody else they are numbers


@pytest.mark.parametrize(("last", "pulse"), [(1.0, 0), (1.0 + 1e-11, 11)])
def test_of_equal_peaks_the_earliest_is_reported(last: float, pulse: int) -> None:
    """A block under twelve equal pulses, each from rest, in lanes of different friction: rounding decides nothing."""
    slide: Any = slipcircle.load("vaiont")
    period = 3.0
    times = np.add.outer(period * np.arange(12), [0.0, 0.4, 0.9]).ravel()
    amplitudes = 0.3 * np.repeat([1.0, last], [11, 1])
    record = Series(times, np.multiply.outer(amplitudes, [0.0, 1.0, 0.0]).ravel(), held=False)
    friction = np.linspace(0.6, 0.65, 24)
    bound = posed(slipcircle.Scene(slide.arc, friction, {"shaking": {"horizontal": record}}), 1e-9)
    unit = float(np.asarray(slide.arc.time_scale))
    finals = [integrate(bound, level=level) for level in BINARY.LEVELS] + [integrate(bound, name="NumPy")]
    for final in finals:
        assert set(final[ix.PEAK_TIME] * unit // period) == {pulse}


def test_threads_walk_side_by_side() -> None:
    bound = problem("softening")
    with ThreadPoolExecutor(2) as pool:
        halves = list(pool.map(lambda half: integrate(bound, half), (slice(18), slice(18, None))))
    assert np.array_equal(np.concatenate(halves, axis=1), integrate(bound), equal_nan=True)


# Runs of a motion by cells in which they differ, and their relative differences: of duration, run-out, peak velocity,
# and states, by twice the spread of times at the peak velocity, or by the spread of rotations.
RUNS: dict[str, tuple[dict[int, list[float]], tuple[float, ...]]] = {
    "equal": ({}, (0.0, 0.0, 0.0, 0.0)),
    "times": ({ix.REST_SINCE: [8.0, 8.0, 10.0]}, (0.25, 0.0, 0.0, 2 * 2.0 * 3.0 / 4.0)),
    "rotations": ({ix.END_ROTATION: [3.0, 1.0, 4.0]}, (0.0, 0.0, 0.0, 0.5)),
    "results": ({ix.REACH_ROTATION: [4.0, 5.0, 3.5], ix.PEAK_OMEGA: [3.0, -3.0, -1.5]}, (0.0, 0.25, 0.5, 0.0)),
    "ended": ({ix.STATUS: [ix.ENDED, ix.ARRESTED, ix.PAUSED]}, (0.2, 0.0, 0.0, 2 * 2.0 * 3.0 / 4.0)),
    "otherwise": ({ix.STATUS: [ix.ARRESTED, ix.UPRIGHT, ix.ARRESTED]}, (np.inf,) * 4),
    "still": ({ix.PHASES: [0.0, 0.0, 1.0]}, (np.inf,) * 4),
}


@pytest.mark.parametrize("name", RUNS)
def test_spreads_of_runs(name: str) -> None:
    cells = np.zeros((len(ix.CELLS), 3))
    usual = {ix.STATUS: ix.ARRESTED, ix.PHASES: 1.0, ix.END_TIME: 10.0, ix.REST_SINCE: 8.0, ix.REACH_ROTATION: 4.0}
    for cell, values in (usual | {ix.PEAK_OMEGA: 3.0, ix.END_ROTATION: 3.0} | RUNS[name][0]).items():
        cells[cell] = values
    for module in (compiled, in_numpy):
        assert module.spreads(cells) == pytest.approx(RUNS[name][1], rel=1e-15)


@pytest.mark.parametrize("name", ["constant", "softening"])
def test_runs_of_a_motion_are_lanes(name: str) -> None:
    """The cells of runs are products and sums of one lane's, and are integrated as lanes are."""
    bound = problem(name)
    start = {key: value[0] if isinstance(value, np.ndarray) else value for key, value in bound.start.items()}
    moves = np.zeros((2, len(bound.program.cells), 3))
    moves[0] = 1.0 + np.array([0.0, 1e-3, 2e-3])
    moves[0, len(bound.program.cells) - len(bound.program.constants) :] = 1.0
    moves[0, ix.ORDER], moves[1, ix.ORDER] = 1.0, [0.0, 1.0, 2.0]
    column = np.zeros((len(bound.program.cells), 1))
    for key in start.keys() & bound.program.places.keys():
        column[bound.program.places[key]] = start[key]
    lanes = column * moves[0] + moves[1]
    compiled.integrate(bound.program, bound.tables(), lanes)
    for module in (compiled, in_numpy):
        final, spreads = module.integrate_runs(bound.program, bound.tables(), start, moves)
        within = 0.0 if module is compiled else 1e-11
        alike(np.array(final)[:, None], lanes[: len(final), :1], within)
        assert spreads == pytest.approx(in_numpy.spreads(lanes), rel=1e3 * within)
    with pytest.raises(ValueError, match="not those of as many lanes"):
        compiled.integrate_runs(bound.program, bound.tables(), start, moves[:, 1:].copy())
    with pytest.raises(TypeError, match="real number"):
        compiled.integrate_runs(bound.program, bound.tables(), start | {"ORDER": None}, moves)


MALFORMED = {  # integers of a program by their places, and what they become
    "cells": (0, -1), "no cells": (0, 0), "made": (1, 10**6), "registers": (2, 10**8), "fewer registers": (2, 3),
    "states": (3, 10**8), "no states": (3, 0), "tables": (4, 10**8), "numbers": (5, -4), "series": (6, 2**31 - 1),
    "later": (7, 3), "a register of a role": (10, 5), "a cell of a role": (16, 10**7),
}  # fmt: skip
OF_TABLE = [  # integers of the last table, by their places from the end, and what they become
    (-4, -1), (-4, 4), (-3, -2), (-3, 5), (-3, ix.STRIDE * 10**5), (-2, -1), (-2, -(2**31)), (-2, 10**4),
    (-2, 2**31 - 1), (-1, -1), (-1, ix.STRIDE), (-1, 2**31 - 1),
]  # fmt: skip


@pytest.mark.parametrize("name", ["constant", "record", "softening"])
def test_malformed_integers_are_refused(name: str) -> None:
    """No size, place or number of lanes leads beyond what there is."""
    bound = problem(name)
    code, nothing = np.frombuffer(encoded(bound.program), np.int32), np.empty(0)
    pieces, cells, widest = compiled._pieces(bound.tables(), LANES), bound.cells(), compiled.widest()

    def call(code: Any = code, tables: Any = pieces, begin: int = 0, end: int = LANES, times: Any = nothing,
             outputs: Any = nothing) -> None:  # fmt: skip
        BINARY.integrate(code.tobytes(), tables, cells.copy(), begin, end, 2, times, outputs, nothing, widest, nothing)

    call()
    malformed = [*MALFORMED.values()]
    if pieces:  # its cells may end where those of the program do, but not one later
        last = len(cells) - (len(ix.TABLE) - 1) - code[-1]
        malformed += [*OF_TABLE, (-2, last + 1)]
        fitting = code.copy()
        fitting[-2] = last
        call(fitting)
    for place, value in malformed:
        changed = code.copy()
        changed[place] = value
        with pytest.raises(ValueError, match="do not fit"):
            call(changed)
        assert BINARY.straight_line(changed.tobytes(), widest) == -1
    for length in range(len(code)):  # also within the sizes
        assert BINARY.straight_line(code[:length].tobytes(), widest) == -1
    rng = np.random.default_rng(56)
    for _ in range(300):  # whatever it says, nothing outside is read
        changed = code.copy()
        changed[rng.integers(9, len(code), 2)] = rng.choice([-(2**31), -1, 0, 3, 41, 42, 10**4, 2**31 - 1], 2)
        with suppress(ValueError):
            call(changed)
    samples, states = np.zeros((5, LANES)), np.zeros((4, 5, LANES))
    bad: list[dict[str, Any]] = [
        {"begin": 3, "end": 2}, {"begin": -1}, {"times": samples}, {"times": samples, "outputs": states[:3].copy()},
        {"times": samples[:, :2].copy(), "outputs": states}, {"outputs": np.zeros(1)},
    ]  # fmt: skip
    for table in pieces[:1]:
        odd = {0: table[0][:1].copy(), 1: table[1][:1].copy(), 2: nothing, 3: 2**31 - 1, 4: 2**62}
        bad += [{"tables": ((*table[:k], x, *table[k + 1 :]), *pieces[1:])} for k, x in (*odd.items(), (3, -1))]
    for arguments in bad:
        with pytest.raises(ValueError, match="not those of as many lanes"):
            call(**arguments)


ALONE = """
import numpy as np
from tests.support import lanes, phases
for law in ("", "linear", "exponential", "hyperbolic"):
    problem = lanes.posed(phases.random_scene({}, None, law))
    together = lanes.integrate(problem)
    for k in range(phases.COUNT):
        assert np.array_equal(lanes.integrate(problem, [k])[:, 0], together[:, k], equal_nan=True), (law, k)
"""


def test_what_memory_contained_changes_no_bit() -> None:
    """The free lanes of a vector compute with anything; with glibc, new memory is full of one byte here."""
    subprocess.run([sys.executable, "-c", ALONE], env=os.environ | {"MALLOC_PERTURB_": "1"}, check=True)


def test_a_binary_of_another_source_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(compiled, "DIGEST", "of another")
    with pytest.warns(RuntimeWarning, match="built from another source; run `python -m derive.build`"):
        assert compiled.module.__wrapped__() is None
