"""Studies are conducted: samples of uncertain numbers, or a grid, cut into blocks, computed and added up."""

import hashlib
import json
import math
import os
from collections.abc import Mapping
from dataclasses import fields
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from slipcircle.base import VERSION
from slipcircle.base.checks import INFINITY, mistakes, raise_all
from slipcircle.base.series import Series
from slipcircle.core import Scene, Section, arc_numbers, checked, parameter_value, plan
from slipcircle.workbench.common.quantities import OUTCOMES
from slipcircle.workbench.files.numbers import Number, Uncertain, by_name, listed, number_in, uncertain_numbers
from slipcircle.workbench.files.variation import along_means
from slipcircle.workbench.studies.design import METHODS, REPLICATES, Design
from slipcircle.workbench.studies.engines import Folder, Progress, as_executor, engine, run_blocks, stored
from slipcircle.workbench.studies.sampling import MOST_LATIN
from slipcircle.workbench.studies.study import Study

_KEEP = 2**20  # samples up to which they are kept by default
_BASE = 2**14
_MOST_GRID = 2**26
_MOST = 10**12
_OUTSIDE = 1e-4  # of a distribution, that may lie out of a number's bounds; such samples are counted apart


def _known(given: Any) -> Any:
    """What JSON cannot hold, as a folder remembers it."""
    if isinstance(given, Mapping):
        return dict(given)
    if isinstance(given, Series):
        samples = hashlib.sha256(given.time.tobytes() + given.values.tobytes()).hexdigest()
        return {"samples": samples, "held": given.held}
    if isinstance(given, np.ndarray | np.generic):
        return given.tolist()
    if "<" in getattr(given, "__qualname__", ""):  # another one has the same name
        raise ValueError(
            "folder: a friction function that a later run is to know again needs a name of its own: define it with def "
            "in a module, or give a table"
        )
    return f"{given.__module__}.{given.__qualname__}" if hasattr(given, "__qualname__") else repr(given)


def _whole(value: Any) -> bool:
    return isinstance(value, int | np.integer) and not isinstance(value, bool)


def _seed(rng: Any, folder: Any) -> int:
    """A seed from whatever NumPy takes as one; that of the folder's study where there is none."""
    if rng is None and folder is not None and (held := stored(folder)):
        return int(held["seed"])
    try:
        made = np.random.default_rng(rng)
        return int(rng) if _whole(rng) else int(made.integers(2**53))
    except (TypeError, ValueError) as error:
        raise ValueError(
            f"rng = {rng!r}: must be a seed, a whole number of at least 0, or one of NumPy's generators"
        ) from error


def ensemble(
    scene: Scene,
    n: int,
    rng: Any = None,
    executor: Any = None,
    *,
    method: str = "monte-carlo",
    sensitivity: int | None = None,
    keep: bool | None = None,
    size: int | None = None,
    confidence: float = 0.95,
    accuracy: float | None = None,
    folder: str | os.PathLike[str] | None = None,
    progress: IO[str] | None = None,
    correlation: Mapping[tuple[str, str], float] | None = None,
) -> Study:
    """Study a scene: solve it for samples of its uncertain numbers.

    Parameters
    ----------
    scene : Scene
        With ``uncertain`` numbers, of which the others are none; independent but for ``correlation``.
    n : int
        How many samples.
    rng : int, SeedSequence or Generator, optional
        The seed, or what one is drawn from; the same seed gives the same bits with any executor.
    executor : concurrent.futures.Executor or dask.distributed.Client, optional
        Where blocks are computed; by default in threads, one for each processor.
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
    plain = checked(scene, "ensemble").shape == ()
    within = _whole(n) and 1 <= n <= _MOST
    raise_all(
        "ensemble",
        [
            said
            for right, said in (
                (plain, "a scene of arrays is solved as it is: use solve"),
                (
                    scene.uncertain,
                    "no number is uncertain: give Scene(uncertain=...), --uncertain, or a distribution in its file",
                ),
                (within, f"n = {n!r}: must be a whole number of samples, from 1 to {_MOST:.0e}"),
                (
                    method != "latin-hypercube" or not within or n <= MOST_LATIN,
                    f"n = {n}: a Latin hypercube is held in memory, so {MOST_LATIN} at most; take method='sobol'",
                ),
                (method in METHODS, f"method = {method!r}: must be one of {', '.join(METHODS)}"),
                (
                    isinstance(confidence, float) and 0.0 < confidence < 1.0,
                    f"confidence = {confidence!r}: must be between 0 and 1",
                ),
                (
                    size is None or (_whole(size) and size >= 4 and not size & (size - 1)),
                    f"size = {size!r}: must be a power of two, 4 at least",
                ),
                (
                    sensitivity is None or (_whole(sensitivity) and 0 <= sensitivity <= 2**22 and sensitivity != 1),
                    f"sensitivity = {sensitivity!r}: must be 0, or 2 to {2**22} base points",
                ),
                (
                    isinstance(correlation, Mapping | None),
                    f"correlation = {correlation!r}: must be a mapping from pairs of keys to numbers",
                ),
                (
                    not correlation or not sensitivity,
                    "sensitivity indices are of independent inputs; leave out correlation or sensitivity",
                ),
            )
            if not right
        ],
    )
    seed, n, drawn = _seed(rng, folder), int(n), uncertain_numbers(scene)
    raise_all("ensemble", _truncated(drawn))
    scene = along_means(scene)
    matrix = _correlation(drawn, correlation or {})
    base = sensitivity
    if base is None:
        base = min(_BASE, n) if len(drawn) > 1 and n > 1 and not correlation else 0
    design = Design(
        scene,
        plan(scene, accuracy).accuracy,
        {k: u.number for k, u in drawn.items()},
        drawn,
        (),
        method,
        n,
        base,
        n <= _KEEP if keep is None else keep,
        matrix,
        seed,
        size or _size(n, method),
    )
    return conduct(design, executor, confidence, folder, progress)


def _truncated(drawn: Mapping[str, Uncertain]) -> list[str]:
    """A sentence for each distribution of which much lies where there is no scene: it is truncated only by name."""
    found = []
    for uncertain in drawn.values():
        number, distribution = uncertain.number, uncertain.distribution
        outside = float(distribution.cdf(number.low) + 1.0 - distribution.cdf(number.high))
        if outside > _OUTSIDE:
            found.append(
                f"{number.key}: {100 * outside:.2g} % of its distribution lies outside of {number.low:g} to "
                f"{number.high:g}, where there is no scene; truncate it by name: truncated_normal with low and high"
            )
    return found


def _correlation(drawn: Mapping[str, Uncertain], given: Mapping[tuple[str, str], float]) -> NDArray[np.float64]:
    """Of all inputs, from pairs of their keys or names."""
    names, keys = [*drawn], [u.key for u in drawn.values()]
    known, found, said = [*keys, *names], np.eye(len(drawn)), list[str]()
    for pair, value in given.items():
        at = [known.index(k) % len(drawn) for k in pair if k in known]
        if unknown := [k for k in pair if k not in known]:
            said.append(f"correlation: {', '.join(unknown)} is not uncertain; known are {', '.join(known)}")
        elif len(at) != 2 or at[0] == at[1] or not -1.0 < value < 1.0:
            said.append(f"correlation of {' and '.join(pair)} = {value!r}: must be between -1 and 1, of two numbers")
        else:
            found[at, at[::-1]] = value
    raise_all("ensemble", said)
    if np.linalg.eigvalsh(found)[0] <= 1e-12:
        raise ValueError("ensemble: correlation: these do not go together: no numbers have all of them")
    return found


def _size(n: int, method: str) -> int:
    """Samples of a block."""
    each = max(n // (REPLICATES if method == "sobol" else 1), 1)  # of a sequence
    most = 2**14 if each <= 2**22 else 2**16 if each <= 2**28 else 2**18
    return min(max(2 ** max(each // 8, 1).bit_length() // 2, 256), most)


def grid(
    scene: Scene,
    levels: Mapping[str, Any],
    executor: Any = None,
    *,
    accuracy: float | None = None,
    folder: str | os.PathLike[str] | None = None,
    progress: IO[str] | None = None,
) -> Study:
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
    said = ["a scene of arrays is solved as it is: use solve"] if scene.shape else []
    for path, values in levels.items():
        try:
            number = number_in(scene, path)
        except ValueError as error:
            said.append(str(error))
            continue
        if parameter_value(scene, number.name) is None:
            has = listed([by_name(scene)[n].key for n in scene.numbers])
            said.append(f"{path}: the scene has no value of it to vary; it has {has}")
        elif number.name in inputs:
            said.append(f"{path}: {inputs[number.name].key} says the same")
        elif np.ndim(values) != 1 or mistakes({path: values}, {path: (-INFINITY, INFINITY, "")}) or not np.size(values):
            said.append(f"{path}: must be a list of numbers")
        inputs[number.name] = number
    n = math.prod(np.size(x) for x in levels.values())
    if n > _MOST_GRID:
        said.append(f"{n} combinations: they are held in memory, so {_MOST_GRID} at most; draw samples instead")
    raise_all("grid", said if levels else ["no values are given"])
    axes = tuple(np.asarray(v, dtype=np.float64) for v in levels.values())
    design = Design(
        scene,
        plan(scene, accuracy).accuracy,
        inputs,
        {},
        axes,
        "grid",
        n,
        0,
        True,
        np.eye(len(inputs)),
        0,
        _size(n, "grid"),
    )
    return conduct(design, executor, 0.95, folder, progress)


def conduct(
    design: Design, executor: Any, confidence: float, folder: str | os.PathLike[str] | None, progress: IO[str] | None
) -> Study:
    """Compute a design's blocks and add them up."""
    blocks = Folder(folder, _described(design)) if folder is not None else None
    scenes = design.n + design.base * (len(design.inputs) + 2)
    shown = Progress(scenes, progress) if progress else None
    if executor is not None:
        return Study(design, confidence, run_blocks(design, as_executor(executor), blocks, shown))
    with engine("threads") as threads:
        return Study(design, confidence, run_blocks(design, threads, blocks, shown))


def _described(design: Design) -> dict[str, Any]:
    """What tells one study from another, as a folder remembers it."""
    scene, arc = design.scene, design.scene.arc
    section = {f.name: getattr(arc, f.name) for f in fields(arc)} if isinstance(arc, Section) else {}
    described = {
        "slipcircle": VERSION,
        "outcomes": [*OUTCOMES],
        "accuracy": design.accuracy,
        "section": section,
        "numbers": {n: v for n, v in scene.numbers.items() if not section or n not in arc_numbers(arc)},
        "given": arc.given or {},
        "friction": scene.friction,
        "effects": scene.called,
        "inputs": [u.key for u in design.inputs.values()],
        "drawn": [u.record for u in design.drawn.values()],
        "levels": design.levels,
        "method": design.method,
        "samples": design.n,
        "sensitivity_base": design.base,
        "keep": design.keep,
        "seed": design.seed,
        "block": design.size,
        "correlation": design.correlation,
    }
    return dict(json.loads(json.dumps(described, default=_known)))
