"""Studies are conducted: samples of uncertain numbers, or a grid, cut into blocks, computed and added up."""

import hashlib
import math
import os
from collections.abc import Mapping
from concurrent.futures import Executor
from dataclasses import fields
from typing import IO, Any

import numpy as np

from slipcircle.base import VERSION
from slipcircle.base.checks import INFINITY, mistakes
from slipcircle.base.series import Series
from slipcircle.motion.plan import plan
from slipcircle.motion.quantities import OUTCOMES
from slipcircle.scene.numbers import Number, Uncertain, number_in, numbers_in
from slipcircle.scene.scene import Scene, checked
from slipcircle.scene.section import Section
from slipcircle.scene.varied import absent, along_means, value_in
from slipcircle.studies.design import METHODS, Design
from slipcircle.studies.engines import Folder, Progress, computed, stored
from slipcircle.studies.sampling import MOST_LATIN
from slipcircle.studies.study import Study

_KEEP = 2**20  # samples up to which they are kept by default
_BASE = 2**14
_MOST_GRID = 2**26
_MOST = 10**12


def _known(given: Any) -> Any:
    """A law, or what else is no number, as a folder remembers it and as JSON holds it."""
    if isinstance(given, Mapping):
        return {k: _known(v) for k, v in given.items()}
    if isinstance(given, Series):
        samples = hashlib.sha256(given.time.tobytes() + given.values.tobytes()).hexdigest()
        return {"samples": samples, "held": given.held}
    if isinstance(given, list | tuple | np.ndarray | np.generic):
        return np.asarray(given).tolist()
    if isinstance(given, str | float | int) or given is None:
        return given
    if not hasattr(given, "__qualname__"):
        return repr(given)
    if "<" in given.__qualname__:  # another one has the same name
        raise ValueError(
            "folder: a friction function that a later run is to know again needs a name of its own: define it with def "
            "in a module, or give a table"
        )
    return f"{given.__module__}.{given.__qualname__}"


def _whole(value: Any) -> bool:
    return isinstance(value, int | np.integer) and not isinstance(value, bool)


def _seed(rng: Any, folder: Any) -> int:
    """A seed from whatever NumPy takes as one; that of the folder's study where there is none."""
    if _whole(rng):
        if rng < 0:
            raise ValueError(f"rng = {rng!r}: a seed must be at least 0")
        return int(rng)
    if rng is None and folder is not None and (held := stored(folder)):
        return int(held["seed"])
    try:
        return int(np.random.default_rng(rng).integers(2**53))
    except (TypeError, ValueError) as error:
        raise ValueError(f"rng = {rng!r}: must be a seed, a whole number, or one of NumPy's generators") from error


def ensemble(
    scene: Scene, n: int, rng: Any = None, executor: Executor | None = None, *, method: str = "monte-carlo",
    sensitivity: int | None = None, keep: bool | None = None, size: int | None = None, confidence: float = 0.95,
    accuracy: float | None = None, folder: str | os.PathLike[str] | None = None, progress: IO[str] | None = None,
    correlation: Mapping[tuple[str, str], float] | None = None,
) -> Study:  # fmt: skip
    """Study a scene: solve it for samples of its uncertain numbers.

    Parameters
    ----------
    scene : Scene
        With ``uncertain`` numbers, of which the others are none; independent but for ``correlation``.
    n : int
        How many samples.
    rng : int, SeedSequence or Generator, optional
        The seed, or what one is drawn from; the same seed gives the same bits with any executor.
    executor : concurrent.futures.Executor, optional
        Where blocks are computed: threads, processes, or ``client.get_executor()`` of Dask; by default here.
    method : str, optional
        "monte-carlo"; "sobol": 16 independently scrambled sequences, whose spread gives the intervals, best for n of 16
        times a power of two; or "latin-hypercube", in memory, whose intervals are those of Monte Carlo: too wide.
    sensitivity : int, optional
        Base points of the sensitivity indices, each of which takes the number of inputs and 2 more scenes; by default
        16384, n if that is fewer, and 0 where there is one input.
    keep : bool, optional
        Whether to keep the samples, by default up to 2**20 of them. Otherwise they are counted in bins of a relative
        width of 1/1024, and a million or a hundred million take the same memory.
    size : int, optional
        Samples of a block, a power of two; by default so that there are eight blocks at least, which show how the
        results converge, and up to 16384, 65536 beyond 2**22 samples, and 262144 beyond 2**28, where many machines may
        work and each block costs the scheduler some milliseconds. Few where each scene costs as much.
    confidence : float, optional
        Of all intervals.
    accuracy : float, optional
        Relative error asked for of each solution; by default the scene's own, or 1e-9.
    folder : path, optional
        Where finished blocks are kept, and found by a later call that continues.
    progress : stream, optional
        Where to tell the rate and the time left.
    correlation : mapping, optional
        Of the normal scores of two uncertain numbers (a Gaussian copula), by their keys: ``{("friction.angle_deg",
        "cohesion.cohesion_kPa"): -0.5}``. Sensitivity indices are of independent inputs, and there are none then.

    Raises
    ------
    ValueError
        If no number is uncertain, if the scene is of arrays, or for a folder that holds another study.

    Examples
    --------
    >>> from slipcircle import ensemble, load
    >>> from dataclasses import replace
    >>> angle = {"distribution": "normal", "mean": 10, "std": 1}
    >>> found = ensemble(replace(load("vaiont"), uncertain={"friction.angle_deg": angle}), 1000, rng=1)
    >>> found.moving.value
    1.0
    """
    said = []
    if checked(scene, "ensemble").shape:
        said.append("a scene of arrays is solved as it is: use solve")
    if not scene.uncertain:
        said.append("no number is uncertain: give Scene(uncertain=...), --uncertain, or a distribution in its file")
    if not _whole(n) or not 1 <= n <= _MOST:
        said.append(f"n = {n!r}: must be a whole number of samples, from 1 to {_MOST:.0e}")
    elif method == "latin-hypercube" and n > MOST_LATIN:
        said.append(f"n = {n}: a Latin hypercube is held in memory, so {MOST_LATIN} at most; take method='sobol'")
    if method not in METHODS:
        said.append(f"method = {method!r}: must be one of {', '.join(METHODS)}")
    if not isinstance(confidence, float) or not 0.0 < confidence < 1.0:
        said.append(f"confidence = {confidence!r}: must be between 0 and 1")
    if size is not None and (not _whole(size) or size < 4 or size & (size - 1)):
        said.append(f"size = {size!r}: must be a power of two, 4 at least")
    if sensitivity is not None and (not _whole(sensitivity) or not 0 <= sensitivity <= 2**22 or sensitivity == 1):
        said.append(f"sensitivity = {sensitivity!r}: must be 0, or 2 to {2**22} base points")
    if said:
        raise ValueError("ensemble: " + "; ".join(said))
    seed, n, drawn, scene = _seed(rng, folder), int(n), dict(scene.uncertain), along_means(scene)
    base = (min(_BASE, n) if len(drawn) > 1 and n > 1 else 0) if sensitivity is None else sensitivity
    if not isinstance(correlation, Mapping | None):
        raise ValueError(f"ensemble: correlation = {correlation!r}: must be a mapping from pairs of keys to numbers")
    pairs = _pairs(drawn, correlation or {})
    if pairs and sensitivity:
        raise ValueError(
            "ensemble: sensitivity indices are of independent inputs; leave out correlation or sensitivity"
        )
    base = 0 if pairs else base
    design = Design(scene, plan(scene, accuracy).accuracy, {k: u.number for k, u in drawn.items()}, drawn, (), method,
                    n, base, n <= _KEEP if keep is None else keep, pairs)  # fmt: skip
    if np.linalg.eigvalsh(design.correlations)[0] <= 1e-12:
        raise ValueError("ensemble: correlation: these do not go together: no numbers have all of them")
    return conduct(design, seed, size or _size(n // design.replicates), executor, confidence, folder, progress)


def _pairs(
    drawn: Mapping[str, Uncertain], given: Mapping[tuple[str, str], float]
) -> tuple[tuple[str, str, float], ...]:
    """Correlated inputs by their names."""
    names = {u.key: n for n, u in drawn.items()} | {n: n for n in drawn}
    said, found = [], list[tuple[str, str, float]]()
    for pair, value in given.items():
        if unknown := [k for k in pair if k not in names]:
            said.append(f"correlation: {', '.join(unknown)} is not uncertain; known are {', '.join(names)}")
        elif len(pair) != 2 or names[pair[0]] == names[pair[1]] or not -1.0 < value < 1.0:
            said.append(f"correlation of {' and '.join(pair)} = {value!r}: must be between -1 and 1, of two numbers")
        else:
            found.append((names[pair[0]], names[pair[1]], float(value)))
    if said:
        raise ValueError("ensemble: " + "; ".join(said))
    return tuple(found)


def _size(n: int) -> int:
    """Samples of a block, of n in a sequence."""
    return min(max(2 ** max(n // 8, 1).bit_length() // 2, 256), 2**14 if n <= 2**22 else 2**16 if n <= 2**28 else 2**18)


def grid(
    scene: Scene, levels: Mapping[str, Any], executor: Executor | None = None, *, accuracy: float | None = None,
    folder: str | os.PathLike[str] | None = None, progress: IO[str] | None = None,
) -> Study:  # fmt: skip
    """Solve a scene at every combination of given values; ``samples`` has them, the last key's fastest.

    Parameters
    ----------
    scene : Scene
    levels : mapping
        Values by key, ``{"friction.angle_deg": [8, 10, 12]}``, in the key's unit.
    executor, accuracy, folder, progress
        As of `ensemble`.
    """
    checked(scene, "grid")
    if not isinstance(levels, Mapping):
        raise ValueError(f"grid: levels = {levels!r}: must be a mapping from keys to lists of numbers")
    inputs: dict[str, Number] = {}
    said: list[str] = []
    for path, values in levels.items():
        try:
            number = number_in(scene, path)
        except ValueError as error:
            said.append(str(error))
            continue
        if value_in(scene, number) is None:
            said.append(absent(scene, path))
        elif number.name in inputs:
            said.append(f"{path}: {inputs[number.name].key} says the same")
        elif np.ndim(values) != 1 or mistakes({path: values}, {path: (-INFINITY, INFINITY, "")}) or not np.size(values):
            said.append(f"{path}: must be a list of numbers")
        inputs[number.name] = number
    said += ["a scene of arrays is solved as it is: use solve"] if scene.shape else []
    n = math.prod(np.size(x) for x in levels.values())
    if n > _MOST_GRID:
        said.append(f"{n} combinations: they are held in memory, so {_MOST_GRID} at most; draw samples instead")
    if said or not levels:
        raise ValueError("grid: " + ("; ".join(said) or "no values are given"))
    axes = tuple(np.asarray(v, dtype=np.float64) for v in levels.values())
    design = Design(scene, plan(scene, accuracy).accuracy, inputs, {}, axes, "grid", n, 0, True)
    return conduct(design, 0, _size(n), executor, 0.95, folder, progress)


def conduct(
    design: Design, seed: int, size: int, executor: Executor | None, confidence: float,
    folder: str | os.PathLike[str] | None, progress: IO[str] | None,
) -> Study:  # fmt: skip
    """Compute a design's blocks and add them up."""
    kept = Folder(folder, _described(design, seed, size)) if folder is not None else None
    found = Study(design, seed, size, confidence)
    told = Progress(sum(design.scenes(k, size) for k in range(design.blocks(size))), progress) if progress else None
    found._merge(computed(design, seed, size, executor, kept, told or (lambda scenes, old: None)))
    return found


def _described(design: Design, seed: int, size: int) -> dict[str, Any]:
    """What tells one study from another, as a folder remembers it."""
    scene = design.scene
    section = {f.name: getattr(scene.arc, f.name) for f in fields(scene.arc)} if isinstance(scene.arc, Section) else {}
    told = numbers_in(scene.arc) if section else {}
    return {
        "slipcircle": VERSION, "outcomes": list(OUTCOMES), "accuracy": design.accuracy,
        "numbers": {n: _known(v) for n, v in sorted(scene.numbers.items()) if n not in told},
        "given": _known(scene.arc.given or {}),
        "section": _known(section),
        "friction": _known(scene.friction), "effects": _known(scene.called),
        "inputs": [u.key for u in design.inputs.values()], "drawn": [u.record for u in design.drawn.values()],
        "levels": [x.tolist() for x in design.levels], "method": design.method, "samples": design.n,
        "sensitivity_base": design.base, "keep": design.keep, "seed": seed,
        "block": size, "correlation": [list(x) for x in design.correlation],
    }  # fmt: skip
