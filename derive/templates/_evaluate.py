"""How every generated function is called: types, broadcasting, domain, `out` and `where`, as NumPy's ufuncs do it."""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]


def evaluate(
    body: Callable[..., Array],
    inside: Callable[..., Any],
    safe: tuple[float, ...],
    args: tuple[Any, ...],
    out: NDArray[Any] | None,
    where: ArrayLike,
) -> Any:
    """Compute ``body(*args)`` in float64 and return it in the arguments' floating type.

    Parameters
    ----------
    body : callable
        Straight-line code over float64 arrays.
    inside : callable
        ``inside(eps, *args)`` is true in the domain; eps is that of the arguments' type.
    safe : tuple of float
        A point of the domain, which stands in for arguments outside it.
    args, out, where
        As NumPy's ufuncs take them.

    Raises
    ------
    TypeError
        For arguments that are not real numbers of at most 64 bits.
    """
    items = [x if isinstance(x, (bool, int, float)) and not isinstance(x, np.generic) else np.asarray(x) for x in args]
    kind = np.result_type(*items)
    if kind.kind in "biu":
        kind = np.dtype(np.float64)
    if kind.kind != "f" or kind.itemsize > 8:
        raise TypeError(f"arguments of type {kind} are not supported: give real numbers of at most 64 bits")
    values = [np.asarray(x, dtype=np.float64) for x in items]
    wanted = np.asarray(where, dtype=bool)
    with np.errstate(all="ignore"):  # a lane outside, or not asked for, may do what it likes here
        valid = inside(float(np.finfo(kind).eps), *values)
    use = valid & wanted
    if not np.all(use):
        values = [np.where(use, x, s) for x, s in zip(values, safe, strict=True)]
    with np.errstate(under="ignore"):  # a result that underflows is correctly rounded, or nearly so
        result = np.asarray(body(*values)).astype(kind, copy=False)
    if result.shape != use.shape or any(result is x for x in values):  # a body may leave out an argument, or return it
        result = np.broadcast_to(result, use.shape).copy()
    invalid = wanted & (~valid | np.isnan(result))
    if np.any(invalid):
        np.subtract(np.inf, np.inf)  # NumPy's own `invalid`, handled as np.errstate says
    if not np.all(use):
        result = np.where(use, result, kind.type(np.nan))
    if out is None:
        return result[()]
    np.copyto(out, result, where=wanted, casting="same_kind")
    return out
