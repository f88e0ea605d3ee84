"""Seen <= proved: every certified program on one set of inputs, against ball arithmetic, in fractional ulp.

    python -m tests.campaigns.seen [KERNEL ...] [--points 1000000]

prints for each kernel, tier, form and level of the processor the worst error, where it is (hexadecimal), what is proved
and the largest mean error of a bin. The exit status is 1 if more is seen than proved, or if a mean shows a bias.
"""

import argparse
import sys
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import cache, partial
from itertools import repeat
from typing import Any, NamedTuple

import numpy as np
from flint import arb
from numpy.typing import NDArray

from derive.approximate.programs import variants
from derive.check import truth
from derive.check.patches import QUARTER, SMALL, UNDERFLOW
from derive.check.records import TIERS, Record, read_records
from derive.check.truth import SEGMENTS, TOP
from generated import _compiled, kernels

Floats = NDArray[np.float64]
Numbers = NDArray[Any]  # of float64 or float32

CHEAP = ("1e-10", "1e-6")
INTERPRETED = 10  # the exact interpreter, which serves where there is no binary, takes every tenth input


@cache
def records() -> tuple[Record, ...]:
    """Return all certificates."""
    return tuple(read_records())


DEFINITIONS = {record["kernel"]: tuple(record["definition"]) for record in records()}
KERNELS = tuple(DEFINITIONS)
BASES = tuple(name for name, definition in DEFINITIONS.items() if len(definition) == 1)


# --- inputs ----------------------------------------------------------------------------------------------------------


def seams() -> list[float]:
    """Return the arguments at which a program selects another piece or its logarithm another exponent."""
    found = {TOP - 0.75 * 2.0**-k for k in range(53)}
    for record in records():
        constants = {i: value for i, (kind, _, value) in enumerate(record["operations"]) if kind == "const"}
        less = [args[1] for kind, args, _ in record["operations"] if kind == "less"]
        found |= {float.fromhex(constants[i]) for i in less}
    return sorted(found)


class Inputs(NamedTuple):
    """Half angles, and which of them are spread so evenly that a mean over them means something."""

    alpha: Floats
    even: NDArray[np.bool_]


def inputs(count: int = 1_000_000) -> Inputs:
    """Return the same inputs for every kernel, tier and form.

    Uniform in value, in bit patterns and in the exponent; dense towards pi/2, at the seams, around the witnesses of
    the certificates, and where results underflow. A third is rounded to float32, for which these are the inputs.
    """
    rng = np.random.default_rng(20241203)

    def near(places: Sequence[float], share: float) -> Floats:
        """Around some of these places, at distances of a unit in the last place to a hundredth."""
        n = int(share * count)
        signs = rng.choice([-1.0, 1.0], n)
        return np.asarray(rng.choice(places, n) * (1 + signs * 2.0 ** rng.uniform(-53, -7, n)))

    patterns = rng.integers(0, np.float64(TOP).view(np.int64), int(0.09 * count), endpoint=True)
    spread = [rng.uniform(0, TOP, int(0.30 * count)), 2.0 ** rng.uniform(-40, 0, int(0.15 * count))]
    dense = [
        patterns.view(np.float64),
        TOP - 2.0 ** rng.uniform(-53, 0, int(0.12 * count)),
        2.0 ** rng.uniform(-360, -319, int(0.04 * count)),
        near(seams(), 0.15),
        near([float.fromhex(r["witness"]["alpha"]) for r in records() if "witness" in r], 0.15),
    ]
    alpha = np.concatenate([*spread, *dense])
    single = alpha[::3].astype(np.float32)
    alpha[::3] = np.where(single > 0, single, alpha[::3])
    alpha = np.minimum(alpha, TOP)
    alpha[0] = np.float32(TOP)  # above pi/2, and an input of float32 alone
    return Inputs(alpha, np.arange(alpha.size) < sum(x.size for x in spread))


# --- the exact values ------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Reference:
    """Exact values over 2**scale as unevaluated sums of two doubles: 106 bits, and no underflow."""

    alpha: Floats
    scale: NDArray[np.int64]
    values: dict[str, tuple[Floats, Floats]]

    def take(self, which: Any) -> "Reference":
        """Return the reference at some of the inputs."""
        values = {name: (high[which], low[which]) for name, (high, low) in self.values.items()}
        return Reference(self.alpha[which], self.scale[which], values)


def reference(alpha: Floats, names: Sequence[str] = KERNELS, processes: int = 1) -> Reference:
    """Return exact values from closed forms in ball arithmetic, and near 0 from Taylor series with their remainder."""
    # A base quantity is of the order of alpha**3; to scale a result by more than this might overflow.
    scale = np.maximum(3 * np.frexp(alpha)[1].astype(np.int64), -1060)
    parts = np.array_split(np.arange(alpha.size), max(1, alpha.size // 20_000))
    work = ([alpha[p] for p in parts], [scale[p] for p in parts], repeat(tuple(names)))
    if processes > 1:
        with ProcessPoolExecutor(processes) as pool:
            found = list(pool.map(_exact, *work))
    else:
        found = list(map(_exact, *work))
    table = np.concatenate(found)
    return Reference(alpha, scale, {name: (table[:, 2 * i], table[:, 2 * i + 1]) for i, name in enumerate(names)})


def _exact(alpha: Floats, scale: NDArray[np.int64], names: Sequence[str]) -> Floats:
    """High and low part of every kernel, a row for an input."""
    bases = sorted({statement for name in names for statement in DEFINITIONS[name]})
    rows = []
    with truth.working(truth.BITS):
        half_pi = arb.pi() / 2
        models = {name: truth.kernel_model(name, SEGMENTS[0]) for name in bases}
        for number, exponent in zip(alpha.tolist(), scale.tolist(), strict=True):
            x, row = arb(number), []
            if number < SMALL:  # everything over alpha**3
                found = {name: m.main(x) + m.last * x**m.power for name, m in models.items()}
                factor = x * x * x * arb(2) ** -exponent
            else:
                end = number > TOP
                s, c = (arb(1), arb(0)) if end else x.sin_cos()
                h = arb(0) if end else -((half_pi - x) / 2).tan().log()
                found = {name: truth.exactly(name, half_pi if end else x, s, c, h) for name in bases}
                factor = arb(2) ** -exponent
            for name in names:
                above, *below = DEFINITIONS[name]
                value = found[above] / found[below[0]] if below else found[above] * factor
                assert number == 0 or value.rel_accuracy_bits() > 110
                high = float(value)
                row += [high, float(value - high)]
            rows.append(row)
    return np.array(rows)


def errors(record: Record, values: Numbers, at: Reference) -> Floats:
    """Signed errors in the unit of the certificate's claims: as `derive.check.certify` means them."""
    high, low = at.values[record["kernel"]]
    scale = np.zeros_like(at.scale) if len(record["definition"]) > 1 else at.scale
    distance = np.ldexp(values.astype(np.float64), -scale) - high - low
    single = record["tier"] == "float32"
    least = np.ldexp(1.0, (-149 if single else -1074) - scale)
    if record["tier"] in CHEAP:
        unit = np.where(at.alpha < UNDERFLOW, record["bound"] * high + least, high)
    else:
        mantissa, exponent = np.frexp(high)
        below_a_power_of_two = (mantissa == 0.5) & (low <= 0)
        unit = np.maximum(np.ldexp(1.0, exponent - (24 if single else 53) - below_a_power_of_two), least)
    return np.where(np.isfinite(values), distance / unit, np.inf)


# --- what runs -------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Run:
    """A certified program, and what computes it here."""

    record: Record
    level: str
    call: Callable[[Any], Any]
    step: int = 1  # between the inputs that it takes

    @property
    def kind(self) -> type[np.floating[Any]]:
        """The format of its inputs and results."""
        return np.float32 if self.record["tier"] == "float32" else np.float64


def runs(kernel: str) -> Iterator[Run]:
    """Yield every certified program of a kernel at every level that runs it, by its public call or interpreted.

    What float32 returns is rounded correctly; its certificate's claims are of the double before.
    """
    rounded = dict.fromkeys(("bound", "bound_to_quarter_pi", "bound_underflow"), 0.5)
    mine = [r for r in records() if r["kernel"] == kernel]
    for certificate in mine:
        record = certificate | rounded if "hard" in certificate else certificate
        tier, form = record["tier"], record["form"]
        of_numpy = "numpy" if any((r["tier"], r["form"]) == (tier, "numpy") for r in mine) else "plain"
        levels = [name for name, (f, _) in _compiled.LEVELS.items() if form == (of_numpy if name == "numpy" else f)]
        for level in levels:
            call = _compiled.kernel(kernel, kernels.TEXTS[kernel], level)
            yield Run(record, level, partial(call, accuracy=record["bound"]) if tier in CHEAP else call)
        if not levels:
            yield Run(record, "exact", partial(interpret, kernel, tier, form), INTERPRETED)


def interpret(kernel: str, tier: str, form: str, alpha: Numbers) -> Numbers:
    """Return a program in exact arithmetic, rounded once an operation."""
    (program,) = [v.program for v in variants() if (v.kernel, v.tier, v.form) == (kernel, tier, form)]
    with np.errstate(under="ignore"):  # correctly rounded, and silent in what it stands for
        return program.run(np.minimum(alpha.astype(np.float64), TOP)).astype(alpha.dtype)


# --- what is seen ----------------------------------------------------------------------------------------------------

# Bins for the mean error: binades, then 64 equal parts of the domain.
BINS = np.array([*(2.0**k for k in range(-40, -5)), *(TOP * k / 64 for k in range(1, 65))])
CHANCE = 4.0  # standard errors of a mean


def biased(record: Record) -> float:
    """Return the mean error in ulp from which a program leans to one side.

    Sums over many arcs grow with the mean error, and otherwise with the root of their number. A fused program takes its
    roundings back, all but the last; a plain one leans by its constants, such as 2/3, which are wrong by up to half an
    ulp. Errors of approximation are far below an ulp.
    """
    if record["tier"] == "float32":
        return 0.01
    return 0.1 if record["form"] == "fused" else 0.6


class Mean(NamedTuple):
    """Mean error of a bin beyond correct rounding in ulp, its standard deviation by chance, and the bin's first input.

    Correct rounding has a mean error too, where results hardly change or move in step with their inputs.
    """

    error: float
    chance: float
    start: float


@dataclass(frozen=True)
class Seen:
    """The worst error under each claim of a certificate with its input, and the worst mean (None: errors do lean)."""

    run: Run
    worst: dict[str, tuple[float, float]]
    mean: Mean | None

    @property
    def faults(self) -> list[str]:
        """Return a sentence for each error that exceeds its bound."""
        r = self.run.record
        name = f"{r['kernel']}, {r['tier']}, {r['form']}, {self.run.level}"
        found = [
            f"{name}: {error:.4g} seen at {alpha.hex()}, {claim} is {r[claim]}"
            for claim, (error, alpha) in self.worst.items()
            if not error <= r[claim]
        ]
        if self.mean and not abs(self.mean.error) - self.mean.chance <= biased(r):
            found.append(f"{name}: the mean error is {self.mean.error:.3g} ulp from {self.mean.start:.3g} on")
        return found


def claims(record: Record, alpha: Floats) -> dict[str, NDArray[np.bool_]]:
    """Return the claims of a certificate, and the inputs that each one is about."""
    tiny = (alpha < UNDERFLOW) & (record["bound_underflow"] > 0)
    found = {"bound": ~tiny, "bound_to_quarter_pi": ~tiny & (alpha <= QUARTER), "bound_underflow": tiny}
    return {claim: which for claim, which in found.items() if which.any()}


def measure(run: Run, at: Reference, even: NDArray[np.bool_], climbs: int = 12) -> Seen:
    """Run a program on all inputs of its format, and search around so many of the worst ones and the witness."""
    own = at.alpha.astype(run.kind) == at.alpha if run.kind is np.float32 else at.alpha <= TOP
    own[np.arange(own.size) % run.step > 0] = False
    at, even = at.take(own), even[own]
    error = _errors(run, at)
    worst = {}
    for claim, which in claims(run.record, at.alpha).items():
        starts = worst_places(at.alpha[which], np.abs(error[which]))[: max(1, climbs // run.step)]
        if claim == "bound" and "witness" in run.record and "hard" not in run.record:
            starts = np.append(starts, float.fromhex(run.record["witness"]["alpha"]))
        worst[claim] = climb(run, claim, starts)
    worst["bound"] = max(worst["bound"], worst["bound_to_quarter_pi"])  # which are some of the same inputs
    leans = run.record["tier"] in CHEAP  # as every approximation does between two of its zeros
    beyond = (error - errors(run.record, rounded(run, at), at))[even]
    return Seen(run, worst, None if leans else mean(beyond, at.alpha[even]))


def rounded(run: Run, at: Reference) -> Numbers:
    """Return the exact values, rounded correctly; where they do not underflow."""
    high, _ = at.values[run.record["kernel"]]
    scale = 0 if len(run.record["definition"]) > 1 else at.scale
    return np.ldexp(high, scale).astype(run.kind)


def _errors(run: Run, at: Reference) -> Floats:
    """No exception and no warning inside the domain, underflow included."""
    with np.errstate(all="raise"):
        values = run.call(at.alpha.astype(run.kind))
    return errors(run.record, values, at)


def worst_places(alpha: Floats, error: Floats) -> Floats:
    """Return the worst input of each of 64 parts of the domain, the worst of these first."""
    parts = [p for p in np.array_split(np.argsort(alpha), 64) if p.size]
    tops = np.array([p[np.argmax(error[p])] for p in parts])
    return np.asarray(alpha[tops[np.argsort(-error[tops])]])


def climb(run: Run, claim: str, starts: Floats) -> tuple[float, float]:
    """Return the worst error found from these inputs by steps of ever fewer units in the last place, and its input."""
    worst = np.full(starts.size, -1.0)
    for step in (2.0**k for k in range(30, -1, -2)):
        ulp = np.spacing(starts.astype(run.kind)).astype(np.float64)
        near = starts[:, None] + step * ulp[:, None] * np.arange(-20, 21)
        near = np.clip(near, 0.0, TOP).astype(run.kind).astype(np.float64)
        near = np.where(near <= TOP, near, starts[:, None])
        which = claims(run.record, near).get(claim, np.zeros(near.shape, dtype=bool))
        found = np.abs(_errors(run, reference(near.ravel(), (run.record["kernel"],)))).reshape(near.shape)
        found = np.where(which, found, -1.0)
        k = np.argmax(found, axis=1)[:, None]
        better = np.take_along_axis(found, k, 1)[:, 0] > worst
        worst = np.where(better, np.take_along_axis(found, k, 1)[:, 0], worst)
        starts = np.where(better, np.take_along_axis(near, k, 1)[:, 0], starts)
    top = int(np.argmax(worst))
    return float(worst[top]), float(starts[top])


def mean(error: Floats, alpha: Floats) -> Mean:
    """Return the mean error of the bin farthest beyond chance; bins with fewer than 20 inputs are left out."""
    use = (alpha >= BINS[0]) & np.isfinite(error)
    error, alpha = error[use], alpha[use]
    place = np.searchsorted(BINS, alpha, side="right") - 1
    count, total, square = (np.bincount(place, w, BINS.size) for w in (None, error, error**2))
    full = np.flatnonzero(count >= 20)
    average = total[full] / count[full]
    chance = CHANCE * np.sqrt(np.maximum(square[full] / count[full] - average**2, 0.0) / count[full])
    k = int(np.argmax(np.abs(average) - chance))
    return Mean(float(average[k]), float(chance[k]), float(BINS[full[k]]))


def table(names: Iterable[str], at: Reference, even: NDArray[np.bool_]) -> Iterator[tuple[str, list[str]]]:
    """Lines of the table, each with its faults."""
    yield f"{'kernel':<31} {'tier':<7} {'form':<5} {'level':<8} {'mean':>8}  seen and proved of each claim, at", []
    for run in (run for kernel in names for run in runs(kernel)):
        seen, r = measure(run, at, even), run.record
        bias = f"{seen.mean.error:>8.4f}" if seen.mean else " " * 8
        worst = (f"{claim} {e:.4g} <= {r[claim]:.3g} at {x.hex()}" for claim, (e, x) in seen.worst.items())
        line = f"{r['kernel']:<31} {r['tier']:<7} {r['form']:<5} {run.level:<8} {bias}  "
        yield f"{line}{', '.join(worst)} {'ulp of float32' if 'hard' in r else TIERS[r['tier']].unit}", seen.faults


def main(arguments: Sequence[str] | None = None) -> int:
    """Return the command; its exit status."""
    parser = argparse.ArgumentParser(description="Worst errors seen, beside what is proved.")
    parser.add_argument("kernels", nargs="*", metavar="KERNEL", help=f"of {', '.join(KERNELS)}; default: all")
    parser.add_argument("--points", type=int, default=1_000_000, help="number of inputs (default: 1000000)")
    chosen = parser.parse_args(arguments)
    names = chosen.kernels or KERNELS
    if wrong := set(names) - set(KERNELS):
        parser.error(f"unknown: {', '.join(sorted(wrong))}")
    start, given = time.perf_counter(), inputs(chosen.points)
    faults = []
    for line, found in table(names, reference(given.alpha, names, processes=2), given.even):
        print(line, flush=True)
        faults += found
    what = f"{given.alpha.size} inputs and a search around the worst"
    print(*faults, f"{what}, {len(faults)} faults, {time.perf_counter() - start:.0f} s", sep="\n")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
