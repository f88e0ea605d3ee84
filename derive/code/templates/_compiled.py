"""What computes a kernel of alpha: the compiled loops where they are there and fit, else NumPy; and at which tier.

The environment variable ``SLIPCIRCLE_COMPILED=0`` asks for NumPy; so does it at install time for a pure wheel. The name
of a level, such as ``baseline``, asks for the loops of lesser processors.
"""

import os
import warnings
from collections.abc import Callable, Mapping, Sequence
from functools import cache, partial
from importlib import import_module
from importlib.machinery import ModuleSpec
from importlib.util import find_spec
from typing import Any

import numpy as np

from generated._evaluate import BLOCK, Array, evaluate, real
from generated.tiers import BOUNDS, DIGEST, LIMIT

Text = Callable[..., Array]
CHEAPEST_FIRST = ("1e-6", "1e-10", "best")
HALF_PI = np.pi / 2
FREE_THREADED = "wheels have no binary for free-threaded Python; pip install --no-binary slipcircle slipcircle makes it"


def binary(name: str, digest: str) -> Any:
    """A compiled module of this package; None if there is none, if NumPy is asked for, or if it does not fit.

    One that was made from another source, or with float flags under which the proofs do not hold, is refused with a
    warning.
    """
    if os.environ.get("SLIPCIRCLE_COMPILED") == "0":
        return None
    try:
        if _is_cut_short(find_spec(f"generated.{name}")):
            raise ImportError("the file is cut short")
        found = import_module(f"generated.{name}")
    except ModuleNotFoundError:
        if is_free_threaded():
            _report_free_threads()
        return None
    except (ImportError, OSError) as error:
        fault = f"it cannot be loaded ({error})"
    else:
        if digest != found.DIGEST:
            fault = "it was built from another source"
        elif unsafe := getattr(found, "UNSAFE", None):
            fault = f"it was built with unsafe float flags ({unsafe})"
        else:
            return found
    warnings.warn(
        f"generated.{name} is refused, NumPy serves: {fault}; run `python -m derive.build` or install again",
        RuntimeWarning,
        stacklevel=3,
    )
    return None


def is_free_threaded() -> bool:
    """Whether this Python is built without the global interpreter lock: it cannot load the binaries of wheels."""
    return bool(import_module("sysconfig").get_config_var("Py_GIL_DISABLED"))


@cache
def _report_free_threads() -> None:
    """Warn, once for all modules, that a free-threaded Python has no binaries."""
    warnings.warn(f"NumPy serves, some thirty times slower: {FREE_THREADED}", RuntimeWarning, stacklevel=4)


def _is_cut_short(spec: ModuleSpec | None) -> bool:
    """Whether a binary of Linux ends before its table of sections, which comes last: to load it would be a crash."""
    if spec is None or spec.origin is None:
        return False
    with open(spec.origin, "rb") as file:
        head = file.read(64)
    table, size, count = (int.from_bytes(head[a:b], "little") for a, b in ((40, 48), (58, 60), (60, 62)))
    return head[:4] == b"\x7fELF" and os.stat(spec.origin).st_size < max(64, table + size * count)


def load(digest: str = DIGEST) -> dict[str, tuple[str, Mapping[str, Mapping[str, Any]]]]:
    """The levels that can run here, the fastest first: level -> (form of its programs, tier -> kernel -> ufunc).

    NumPy comes last and has no ufuncs.
    """
    found = binary("_kernels", digest)
    return (found.LEVELS if found else {}) | {"numpy": ("numpy", {})}


LEVELS = load()
_asked = os.environ.get("SLIPCIRCLE_COMPILED", "")
LEVEL = _asked if _asked in LEVELS else next(iter(LEVELS))


def kernel(name: str, texts: Mapping[str, Text], level: str = LEVEL, both_ends: bool = False) -> Callable[..., Any]:
    """The function behind a public one, from its NumPy text of every tier.

    Of ``(alpha, out, where, accuracy)``, or with ``both_ends`` of ``(theta_1, theta_2, out, where, accuracy)``.
    """
    form, loops = LEVELS[level]
    # That of float32 is a type of the best one's.
    compiled: dict[str, Any] = {tier: loops.get(tier, {}).get(name) for tier in CHEAPEST_FIRST}
    best = compiled["float32"] = compiled["best"]
    cheapest = partial(_checked, name, cache(partial(_cheapest, name, form)))
    numpy = partial(_numpy_of_ends if both_ends else _numpy, name)
    general = partial(_general, name, texts, compiled, cheapest, numpy)

    def of_alpha(alpha: Any, out: Any = None, where: Any = True, accuracy: float | None = None) -> Any:
        of = type(alpha)
        simple = best is not None and where is True
        if simple and (of in _SCALARS or (of is np.ndarray and alpha.dtype.char in "df")):
            loop = best
            if accuracy is not None:
                loop = compiled[cheapest("d" if of is float else alpha.dtype.char, accuracy)]
            return loop(alpha) if out is None else loop(alpha, out)
        if _is_foreign(alpha):
            return _elsewhere(name, texts, alpha, out, where, accuracy)
        return general((alpha,), out, where, accuracy)

    def of_ends(one: Any, two: Any, out: Any = None, where: Any = True, accuracy: float | None = None) -> Any:
        return general((one, two), out, where, accuracy)

    return of_ends if both_ends else of_alpha


def _general(
    name: str,
    texts: Mapping[str, Text],
    compiled: Mapping[str, Any],
    cheapest: Callable[[str, float], str],
    numpy: Callable[..., Any],
    args: tuple[Any, ...],
    out: Any,
    where: Any,
    accuracy: float | None,
) -> Any:
    """Any arguments that NumPy takes, by the compiled loop of a tier or by its text."""
    items, kind = real(name, args)
    tier = "float32" if kind.char == "f" and "float32" in texts else "best"
    if accuracy is not None:
        tier = cheapest(kind.char, accuracy)
    loop = compiled[tier]
    if loop is None or kind.char not in "df":
        return numpy(texts[tier], items, kind, out, where)
    arrays = [np.asarray(x, dtype=kind) for x in items]
    return _masked(loop, arrays, out, where)


def _is_foreign(alpha: Any) -> bool:
    """Whether it is an array of another library."""
    return not isinstance(alpha, np.ndarray | np.generic) and any(hasattr(alpha, x) for x in _PROTOCOLS)


def _checked(name: str, cheapest: Callable[[str, float], str], kind: str, accuracy: float) -> str:
    """The cheapest tier, of one number only."""
    if not isinstance(accuracy, _NUMBERS):
        raise TypeError(f"{name}: accuracy is one number, a relative error above 0, not {accuracy!r}")
    return cheapest(kind, accuracy)


def _cheapest(name: str, form: str, kind: str, accuracy: float) -> str:
    """The cheapest tier that is proved to meet a relative error in a float format.

    Plain operations are the same in NumPy and in C; NumPy has a form of its own only where its text calls a library.
    """
    if not accuracy > 0:
        raise ValueError(f"{name}: accuracy is a relative error above 0, not {accuracy!r}")
    limit = "nothing is proved"
    proved = BOUNDS.get(name, {})
    tiers = {"d": CHEAPEST_FIRST, "f": ("float32",)}.get(kind, ())
    for tier in tiers:
        forms = proved.get(tier, {})
        bound = forms.get(form, forms.get("plain"))
        if bound is None:
            continue
        if bound[0] <= accuracy:
            return tier
        limit = f"the best tier is proved to {bound[0]:.3g}"
    raise ValueError(f"{name} cannot promise a relative error of {accuracy!r} here: {limit}")


def _masked(loop: Any, args: Sequence[Array], out: Any, where: Any) -> Any:
    """A compiled loop where a mask is true; elsewhere `out` keeps what it holds, and without one there is NaN."""
    if where is True:
        return loop(*args) if out is None else loop(*args, out)
    mask = np.asarray(where, dtype=bool)
    if out is not None:
        return loop(*args, out, where=mask)
    shape = np.broadcast_shapes(mask.shape, *(x.shape for x in args))
    empty = np.full(shape, np.nan, args[0].dtype)
    return loop(*args, empty, where=mask)[()]


_NUMBERS = (int, float, np.integer, np.floating)
_SCALARS = frozenset((float, np.float64, np.float32))


def _numpy(name: str, text: Text, items: Sequence[Any], kind: np.dtype[Any], out: Any, where: Any) -> Any:
    """By blocks; those that lie in [0, pi/2], as a rule, need no masks."""
    body = partial(_clipped, text)
    if where is not True:
        return evaluate(name, body, _inside, (0.5,), tuple(items), out, where)
    alpha = np.asarray(items[0], dtype=kind)
    result = np.empty(alpha.shape, kind)
    flat = alpha.reshape(-1)
    values = result.reshape(-1)
    with np.errstate(under="ignore"):  # an underflow is correctly rounded, or nearly so
        for start in range(0, flat.size, BLOCK):
            block = flat[start : start + BLOCK]
            inside = block.min() >= 0.0 and float(block.max()) <= HALF_PI  # in float64: float32's pi/2 lies above
            if inside:
                part = text(block.astype(np.float64, copy=False))
            else:
                part = evaluate(name, body, _inside, (0.5,), (block,), None, True)
            values[start : start + BLOCK] = part
    if out is None:
        return result[()]
    np.copyto(out, result, casting="same_kind")
    return out


def _numpy_of_ends(name: str, text: Text, items: Sequence[Any], _: np.dtype[Any], out: Any, where: Any) -> Any:
    """Where nothing presses on an arc its limit friction is infinite, without a flag."""

    def body(theta_1: Array, theta_2: Array) -> Array:
        with np.errstate(divide="ignore", over="ignore", under="ignore"):
            return text(theta_1, theta_2)

    return evaluate(name, body, _is_arc, (4.0, 5.0), tuple(items), out, where)


def _is_arc(eps: float, theta_1: Array, theta_2: Array) -> Any:
    alpha = 0.5 * theta_2 - 0.5 * theta_1
    near = (theta_1 >= -LIMIT) & (theta_2 <= LIMIT)
    ordered = theta_2 >= theta_1
    return near & ordered & (alpha <= HALF_PI * (1.0 + 4.0 * eps))


def _inside(eps: float, alpha: Array) -> Any:
    return (alpha >= 0.0) & (alpha <= HALF_PI * (1.0 + 4.0 * eps))


def _clipped(text: Text, alpha: Array) -> Array:
    return text(np.minimum(HALF_PI, alpha))


# --- arrays of other libraries ---------------------------------------------------------------------------------------

_PROTOCOLS = ("__array_namespace__", "__array_ufunc__")


class _Space:
    """The functions of an array library that traces. At a tie, minimum and maximum pass on the whole slope."""

    def __init__(self, functions: Any) -> None:
        self._functions = functions

    def __getattr__(self, name: str) -> Any:
        return getattr(self._functions, name)

    def minimum(self, a: Any, b: Any) -> Any:
        a, b = (b, a) if isinstance(a, float) else (a, b)
        return self.where(a > b, b, a)

    def maximum(self, a: Any, b: Any) -> Any:
        a, b = (b, a) if isinstance(a, float) else (a, b)
        return self.where(a < b, b, a)


def _elsewhere(name: str, texts: Mapping[str, Text], alpha: Any, out: Any, where: Any, accuracy: float | None) -> Any:
    """The kernel of an array of another library, as an array of that library."""
    call = getattr(import_module("generated.kernels"), name)  # the public function travels to other processes by name
    if out is not None or where is not True:
        raise TypeError(f"`out` and `where` are for NumPy's arrays, not for {type(alpha).__name__}")
    if hasattr(alpha, "dimensionality"):  # pint: radians and degrees are dimensionless, a length is an error
        return type(alpha)(call(alpha.to("dimensionless").magnitude, accuracy=accuracy))
    if not hasattr(alpha, "__array_namespace__"):  # dask, xarray, pandas: as if this were a ufunc
        ufunc = partial(call, accuracy=accuracy)
        ufunc.__dict__.update(__name__="kernel", nin=1, nout=1, signature=None)
        result = alpha.__array_ufunc__(ufunc, "__call__", alpha)
        if result is NotImplemented:
            raise TypeError(f"arguments of type {type(alpha).__name__} are not supported")
        return result
    if accuracy is not None:
        raise ValueError(f"nothing is proved in the arithmetic of {alpha.__array_namespace__().__name__}")
    xp = _Space(alpha.__array_namespace__())
    alpha = alpha * 1.0  # of integers, the library's own float
    eps = float(xp.finfo(alpha.dtype).eps)
    single = eps > 2.0**-52 and "float32" in texts
    value = texts["float32" if single else "best"](xp.minimum(alpha, HALF_PI), xp)
    return xp.where(_inside(eps, alpha), value, np.nan)
