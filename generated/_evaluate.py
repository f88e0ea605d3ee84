# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: 331101e37c2bda783d64383cf4dcaaca5ca89d097abb151c6758752abcd898a4
"""Calls of generated functions: types, broadcasting, domain, `out` and `where`, as in NumPy's ufuncs."""

import warnings
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Out = NDArray[Any] | None  # where a result goes
HALF_PI = np.pi / 2
BLOCK = 8192  # elements whose intermediate values stay in the cache


def horner(x: Any, coefficients: Sequence[float]) -> Any:
    """Return the polynomial with these coefficients, lowest first."""
    result: Any = coefficients[-1]
    for c in coefficients[-2::-1]:
        result = result * x + c
    return result


def lost(a: Any, b: Any) -> Any:
    """Return the rounding error of a + b (TwoSum)."""
    total = a + b
    of_b = total - a
    return (a - (total - of_b)) + (b - of_b)


_NUMBERS = frozenset((bool, int, float, *np.sctypeDict.values()))
# Types of arguments that NumPy converts without losing a unit or a mask.
OWN = _NUMBERS | {np.ndarray, np.memmap, list, tuple, range}


def check_items(name: str, items: Sequence[Any]) -> None:
    """Raise a TypeError unless items, and those of lists among them, are numbers and NumPy arrays without a mask."""
    if _NUMBERS.issuperset(map(type, items)):
        return
    for x in items:
        if type(x) in (list, tuple):
            check_items(name, x)
        elif isinstance(x, np.ma.MaskedArray):
            how = "give x.filled(np.nan), or x.data with where=~x.mask"
            raise TypeError(f"{name}: masked arrays are not supported: {how}")
        elif type(x) not in OWN:
            kind = f"{type(x).__module__}.{type(x).__qualname__}".removeprefix("builtins.")
            how = "give real numbers or a NumPy array of them"
            raise TypeError(f"{name}: arguments of type {kind} are not supported: {how}")


def real(name: str, args: Sequence[Any]) -> tuple[list[Any], np.dtype[Any]]:
    """Return the arguments as arrays or Python's numbers, and the type of the result: real, at most 64 bits."""
    check_items(name, args)
    items = []
    for x in args:
        number = isinstance(x, (bool, int, float)) and not isinstance(x, np.generic)
        if isinstance(x, int) and not -(2**1023) < x < 2**1023:
            raise OverflowError(f"{name}: an integer of {x.bit_length()} bits is too large")
        items.append(float(x) if number else np.asarray(x))
    kind = np.result_type(*items)
    if kind.kind in "biu":
        kind = np.dtype(np.float64)
    if kind.kind != "f" or kind.itemsize > 8:
        raise TypeError(f"{name}: arguments of type {kind} are not supported: give real numbers of at most 64 bits")
    return items, kind


def evaluate(
    name: str,
    body: Callable[..., Array],
    inside: Callable[..., Any],
    safe: tuple[float, ...],
    items: Sequence[Any],
    kind: np.dtype[Any],
    out: Out,
    where: Any,
) -> Any:
    """Compute the text of a named function in float64, block by block, and return it in a floating type.

    ``inside(eps, *args)`` is true in the domain, with the eps of this type; ``safe``, a point of it, replaces arguments
    outside. `items`, `kind` are the results of `real`, `out` and `where` as in NumPy's ufuncs.
    """
    eps = float(np.finfo(kind).eps)
    arrays = [np.asarray(x) for x in (*items, np.asarray(where, dtype=bool))]
    result = np.empty(np.broadcast_shapes(*(x.shape for x in arrays)), kind)
    if result.size <= BLOCK:
        invalid = _block(body, inside, eps, safe, arrays, result)
    else:
        types = [*[np.float64] * len(items), np.bool_, kind]
        modes: Any = [*[["readonly"]] * len(arrays), ["writeonly"]]
        with np.nditer([*arrays, result], ["external_loop", "buffered"], modes, types, buffersize=BLOCK) as blocks:
            invalid = False
            for *values, part in blocks:
                invalid |= _block(body, inside, eps, safe, values, part)
    if invalid:
        _raise_invalid(name)
    if out is None:
        return result[()]
    np.copyto(out, result, where=arrays[-1], casting="same_kind")
    return out


def _raise_invalid(name: str) -> None:
    """Raise NumPy's `invalid` flag, handled as np.errstate requires, in the name of the function."""
    said = f"invalid value encountered in {name}"
    handling = np.geterr()["invalid"]
    if handling == "raise":
        raise FloatingPointError(said)
    if handling == "warn":
        warnings.warn(said, RuntimeWarning, stacklevel=4)
    else:
        np.subtract(np.inf, np.inf)


def _block(
    body: Callable[..., Array],
    inside: Callable[..., Any],
    eps: float,
    safe: tuple[float, ...],
    arrays: Sequence[NDArray[Any]],
    result: NDArray[Any],
) -> bool:
    """Compute one part of the result, and return whether a selected element is invalid."""
    values = [np.asarray(x, dtype=np.float64) for x in arrays[:-1]]
    selected = arrays[-1]
    with np.errstate(all="ignore"):  # elements outside, or not selected, may be anything here
        valid = inside(eps, *values)
    use = valid & selected
    whole = bool(np.all(use))
    if not whole:
        values = [np.where(use, x, s) for x, s in zip(values, safe, strict=True)]
    if len(values) == 1:  # slightly above pi/2 the kernels are computed at pi/2
        values = [np.minimum(HALF_PI, values[0])]
    # Underflow is rounded correctly, or nearly so; the limit friction of an arc without load is infinite.
    with np.errstate(divide="ignore", over="ignore", under="ignore"):
        result[...] = body(*values)
    if not whole:
        np.copyto(result, np.nan, where=~use)
    lost = np.isnan(result) & selected
    if not np.any(lost):
        return False
    for x in arrays[:-1]:  # NumPy's functions are silent of NaN
        lost = lost & (x == x)
    return bool(np.any(lost))
