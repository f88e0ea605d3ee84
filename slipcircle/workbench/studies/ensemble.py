"""Ensembles and grids: solve a scene for samples of uncertain parameters, or for a grid of values."""

import json
import math
from collections.abc import Mapping
from contextlib import nullcontext
from dataclasses import replace
from typing import IO, Any

import numpy as np

from generated.effects import Parameter
from slipcircle.base import VERSION
from slipcircle.base.arrays import array_of
from slipcircle.base.errors import mistakes, raise_all
from slipcircle.base.kinds import Floats, PathName, TextPair, ValueDict, Values
from slipcircle.base.progress import Progress
from slipcircle.core import Scene, checked_scene, plan
from slipcircle.derivatives import parameter_value
from slipcircle.workbench.common.distributions import special
from slipcircle.workbench.common.identity import content_digest
from slipcircle.workbench.files.keys import Key
from slipcircle.workbench.files.loaded import stability_of
from slipcircle.workbench.files.numbers import Uncertain, by_name, listed, number_in, uncertain_numbers
from slipcircle.workbench.files.variation import along_means
from slipcircle.workbench.studies.design import REPLICATES, Design
from slipcircle.workbench.studies.engines import Store, as_executor, compute, open_executor, stored
from slipcircle.workbench.studies.groundmotions import ground_motions
from slipcircle.workbench.studies.settings import OF_ARRAYS, setting_mistakes, whole
from slipcircle.workbench.studies.study import Study

_BASE = 2**14
_MOST_GRID = 2**26


def _known(value: Any) -> Any:
    """Return the JSON form of a value that JSON cannot represent, for the description of a study."""
    if isinstance(value, Mapping):
        return dict(value)
    if isinstance(value, np.ndarray | np.generic):
        return value.tolist()
    try:
        return {"object": getattr(value, "__qualname__", type(value).__qualname__), "content": content_digest(value)}
    except ValueError as error:
        raise ValueError(f"folder: {error}") from error


def _seed(rng: Any, folder: Any) -> int:
    """Return the seed for NumPy's generators given as ``rng``, by default the seed of the study in the folder."""
    if rng is None and folder is not None and (held := stored(folder)):
        return int(held["seed"])
    try:
        made = np.random.default_rng(rng)
        return int(rng) if whole(rng) else int(made.integers(2**53))
    except (TypeError, ValueError) as error:
        raise ValueError(
            f"rng = {rng!r}: must be a seed, a whole number of at least 0, or one of NumPy's generators"
        ) from error


def ensemble(
    scene: Scene,
    n: int = 1,
    rng: Any = None,
    executor: Any = None,
    *,
    method: str = "monte-carlo",
    sensitivity: int | None = None,
    size: int | None = None,
    confidence: float = 0.95,
    accuracy: float | None = None,
    folder: PathName | None = None,
    progress: IO[str] | None = None,
    correlation: Mapping[TextPair, float] | None = None,
    search_each: bool = False,
    records: Any = None,
    polarities: bool = False,
    scales: Any = None,
    scale_to_pga: Any = None,
    thresholds: Any = None,
    strict: bool = False,
) -> Study:
    """Return the study of a scene solved for samples of its uncertain parameters, also under each record of a suite.

    Parameters
    ----------
    scene, n
        A scene with ``uncertain`` parameters, independent except for ``correlation``, and the number of samples.
    rng, executor : int, SeedSequence or Generator; concurrent.futures.Executor or dask.distributed.Client, optional
        Seed; results are bitwise the same with any executor. Executor of the blocks; by default threads.
    method, sensitivity : str and int, optional
        "monte-carlo"; or "sobol": 16 independently scrambled sequences, whose spread gives the intervals. Base points
        of the sensitivity indices, each with (inputs + 2) scenes; by default n, at most 16384.
    size : int, optional
        Samples of a block, a power of two, by default for at least eight blocks.
    confidence, accuracy : float, optional
        Confidence of all intervals; relative error of each solution, by default the scene's, or 1e-9.
    folder, progress : path and stream, optional
        Folder of finished blocks, from which a later call continues; stream for the progress.
    correlation, search_each : mapping and bool, optional
        Correlation of the normal scores (a Gaussian copula) by pairs of keys; whether the critical circle is also
        searched for every sample, for factors of safety only: motions use the circle of the means.
    records, polarities
        Ground motions that replace the scene's own shaking: a `Suite`, paths as for `read_suite`, or `Series` in a
        sequence or mapping by name. Whether each record is also used with reversed sign.
    scales, scale_to_pga : float or array_like, optional
        Scale factors of the records; or peak accelerations over gravity to which each record is scaled.
    thresholds, strict : array_like and bool, optional
        Displacements, m, for exceedance and fragility; whether a file without a record is an error, not a warning.

    Examples
    --------
    >>> from dataclasses import replace
    >>> from slipcircle import ensemble, load
    >>> angle = {"friction.angle_deg": {"distribution": "normal", "mean": 10, "std": 1}}
    >>> ensemble(replace(load("vaiont"), uncertain=angle), 1000, rng=1).moving.value
    1.0
    """
    return conduct(_design(scene, rng, accuracy, folder, records, locals()), executor, confidence, folder, progress)


def _design(scene: Scene, rng: Any, accuracy: float | None, folder: Any, records: Any, arguments: Values) -> Design:
    """Return the design of an ensemble; ValueError names all invalid settings.

    ``arguments`` are all arguments of `ensemble` by name.
    """
    raise_all("ensemble", setting_mistakes(scene, arguments, records))
    drawn = uncertain_numbers(scene)
    n = int(arguments["n"])
    method = arguments["method"]
    correlation = arguments["correlation"] or {}
    means = along_means(scene)
    matrix = _correlation(drawn, correlation)
    inputs = {k: u.number for k, u in drawn.items()}
    base = arguments["sensitivity"]
    if base is None:
        base = min(_BASE, n) if len(drawn) > 1 and n > 1 and not correlation and records is None else 0
    tolerance = plan(means, accuracy).accuracy
    seed = _seed(rng, folder)
    size = int(arguments["size"] or _size(n, method))
    each = arguments["search_each"]
    design = Design(means, tolerance, inputs, drawn, (), method, n, base, matrix, seed, size, each)
    if records is None:
        return design
    special()  # needed at the end; if missing, fail before hours of solving
    unshaken, motions = ground_motions(means, inputs, records, arguments)
    return replace(design, scene=unshaken, records=motions)


def _correlation(drawn: Mapping[str, Uncertain], by_pair: Mapping[TextPair, float]) -> Floats:
    """Return the correlation matrix of all inputs, (inputs, inputs), from correlations by pairs of keys or names.

    ``drawn`` are the uncertain inputs by name.
    """
    keys = [*(u.key for u in drawn.values()), *drawn]
    matrix = np.eye(len(drawn))
    mistakes = []
    for pair, value in by_pair.items():
        places = {keys.index(k) % len(drawn) for k in pair if k in keys}
        if unknown := [k for k in pair if k not in keys]:
            mistakes.append(f"correlation: {', '.join(unknown)} is not uncertain; known are {', '.join(keys)}")
        elif len(places) != 2 or not -1.0 < value < 1.0:
            words = " and ".join(pair)
            mistakes.append(f"correlation of {words} = {value!r}: must be between -1 and 1, of two numbers")
        else:
            one, other = places
            matrix[one, other] = matrix[other, one] = value
    raise_all("ensemble", mistakes)
    if np.linalg.eigvalsh(matrix).min(initial=1.0) <= 1e-12:
        raise ValueError("ensemble: correlation: these are inconsistent: no numbers can have all of them")
    return matrix


def _size(n: int, method: str) -> int:
    """Return the number of samples in a block, a power of two, for ``n`` samples by a method of `METHODS` or a grid."""
    each = max(n // (REPLICATES if method == "sobol" else 1), 1)
    most = 2**14 if each <= 2**22 else 2**16 if each <= 2**28 else 2**18
    return min(max(2 ** max(each // 8, 1).bit_length() // 2, 256), most)


def grid(
    scene: Scene,
    levels: Values,
    executor: Any = None,
    *,
    accuracy: float | None = None,
    folder: PathName | None = None,
    progress: IO[str] | None = None,
) -> Study:
    """Return the study of a scene solved at every combination of given values; the last key varies fastest.

    Parameters
    ----------
    scene : Scene
    levels : mapping
        Values by key, ``{"friction.angle_deg": [8, 10, 12]}``, in the key's unit.
    executor, accuracy, folder, progress
        As for `ensemble`.
    """
    checked_scene(scene, "grid")
    if not isinstance(levels, Mapping):
        raise ValueError(f"grid: levels = {levels!r}: must be a mapping from keys to lists of numbers")
    faults = [] if levels else ["no values are given"]
    inputs: dict[str, Key] = {}
    for path, values in levels.items():
        try:
            number = varied_number(scene, path, values)
            if number.name in inputs:
                raise ValueError(f"{path}: {inputs[number.name].key} says the same")
            inputs[number.name] = number
        except ValueError as error:
            faults.append(str(error))
    n = math.prod(array_of(values).size for values in levels.values())
    if n > _MOST_GRID:
        faults.append(f"{n} combinations: a grid is held in memory, at most {_MOST_GRID}; use samples instead")
    raise_all("grid", ([OF_ARRAYS] if scene.shape else []) + faults)
    axes = tuple(np.asarray(values, float) for values in levels.values())
    accuracy = plan(scene, accuracy).accuracy
    design = Design(scene, accuracy, inputs, {}, axes, "grid", n, 0, np.eye(len(inputs)), 0, _size(n, "grid"))
    return conduct(design, executor, 0.95, folder, progress)


def varied_number(scene: Scene, path: str, values: Any) -> Key:
    """Return the parameter of a scene for a key, after a check that it can take a list of values."""
    number = number_in(scene, path)
    if parameter_value(scene, number.name) is None:
        keys = by_name(scene)
        has = listed([keys[name].key for name in scene.numbers])
        raise ValueError(f"{path}: the scene has no value of it to vary; it has {has}")
    array = array_of(values)
    if array.ndim != 1 or mistakes({path: values}, {path: Parameter(path)}) or not array.size:
        raise ValueError(f"{path}: must be a list of numbers")
    return number


def conduct(
    design: Design, executor: Any, confidence: float, folder: PathName | None, progress: IO[str] | None
) -> Study:
    """Compute the blocks of a design and return the study of their results.

    ``confidence`` is that of intervals, ``folder`` the place of finished blocks, and ``progress`` a stream; both may be
    None.
    """
    store = Store(design, lambda: _described(design), folder)
    with open_executor() if executor is None else nullcontext(as_executor(executor)) as workers:
        if progress is None:
            compute(design, workers, store)
        else:
            with Progress(math.prod(design.shape), "scenes", progress) as shown:
                compute(design, workers, store, shown)
            print(shown.text(), file=progress, flush=True)
    return Study(design, confidence, store.values, store.damaged)


def _described(design: Design) -> ValueDict:
    """Return the description that identifies a study in its folder."""
    scene = design.scene
    searched = stability_of(scene) if design.with_factors else None
    described = {
        "slipcircle": VERSION,
        "outputs": [*design.outputs],
        "factors": "each" if design.search_each else "means",
        "accuracy": design.accuracy,
        "search": [searched.slope, searched.method, searched.limits] if searched else [],
        "mass": scene.arc,
        "numbers": scene.numbers,
        "friction": scene.friction,
        "effects": scene.effects,
        "start": getattr(scene, "start", ""),
        "inputs": design.keys,
        "drawn": [u.record for u in design.drawn.values()],
        "distributions": [u.given for u in design.drawn.values()],
        "levels": design.levels,
        "method": design.method,
        "samples": design.n,
        "sensitivity_base": design.base,
        "seed": design.seed,
        "block": design.size,
        "correlation": design.correlation,
    }
    if records := design.records:
        described |= {
            "records": [entry.measures.digest for entry in records.suite],
            "shaking": records.shaking,
            "polarities": records.polarities,
            "scale_to_pga" if records.to_pga else "scales": records.scales,
        }
    return dict(json.loads(json.dumps(described, default=_known)))
