"""Selection of the compiled loops or of NumPy for a kernel, and of its tier of accuracy.

The environment variable ``SLIPCIRCLE_COMPILED=0`` asks for NumPy; so does it at install time for a pure wheel. The name
of a level, such as ``baseline``, asks for the loops of lesser processors.
"""

import os
import sys
import warnings
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from functools import cache, partial, update_wrapper
from importlib import import_module
from importlib.machinery import ModuleSpec
from importlib.util import find_spec
from typing import Any

import numpy as np

from generated._evaluate import HALF_PI, OWN, Array, check_items, evaluate, real
from generated.tiers import BOUNDS, DIGEST, LIMIT

Text = Callable[..., Array]
CHEAPEST_FIRST = ("1e-6", "1e-10", "best")
FREE_THREADED = "wheels have no binary for free-threaded Python; pip install --no-binary slipcircle slipcircle makes it"


def binary(name: str, digest: str) -> Any:
    """Return a compiled module of this package, or None if it is absent, disabled, or does not match.

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
    """Return whether this Python has no global interpreter lock, so that it cannot load the binaries of wheels."""
    return "free-threading" in sys.version


@cache
def _report_free_threads() -> None:
    """Warn, once for all modules, that a free-threaded Python has no binaries."""
    warnings.warn(f"NumPy serves, some thirty times slower: {FREE_THREADED}", RuntimeWarning, stacklevel=4)


def _is_cut_short(spec: ModuleSpec | None) -> bool:
    """Return whether a Linux binary is truncated before its final section table, so that loading it would crash."""
    if spec is None or spec.origin is None:
        return False
    with open(spec.origin, "rb") as file:
        head = file.read(64)
    table, size, count = (int.from_bytes(head[a:b], "little") for a, b in ((40, 48), (58, 60), (60, 62)))
    return head[:4] == b"\x7fELF" and os.stat(spec.origin).st_size < max(64, table + size * count)


def load(digest: str = DIGEST) -> dict[str, tuple[str, Mapping[str, Mapping[str, Any]]]]:
    """Return the levels that this processor supports, the fastest first, with the form of their programs and ufuncs.

    NumPy comes last and has no ufuncs.
    """
    found = binary("_kernels", digest)
    return (found.LEVELS if found else {}) | {"numpy": ("numpy", {})}


LEVELS = load()
_asked = os.environ.get("SLIPCIRCLE_COMPILED", "")
LEVEL = _asked if _asked in LEVELS else next(iter(LEVELS))


def direct(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return a public function whose calls with floats run in C without Python's interpreter, if it is compiled."""
    _, loops = LEVELS[LEVEL]
    best = loops.get("best", {}).get(function.__name__)
    return update_wrapper(import_module("generated._kernels").Direct(function, best), function) if best else function


def kernel(name: str, texts: Mapping[str, Text], level: str = LEVEL, both_ends: bool = False) -> Callable[..., Any]:
    """Return the implementation of a public function from its NumPy text of every tier.

    Of ``(alpha, out, where, accuracy)``, or with ``both_ends`` of ``(theta_1, theta_2, out, where, accuracy)``.
    """
    form, loops = LEVELS[level]
    # That of float32 is a type of the best one's.
    compiled: dict[str, Any] = {tier: loops.get(tier, {}).get(name) for tier in CHEAPEST_FIRST}
    best = compiled["float32"] = compiled["best"]
    cheapest = partial(_checked, name, form)
    general = partial(_general, name, texts, compiled, cheapest, _is_arc if both_ends else _inside)

    def of_alpha(alpha: Any, out: Any = None, where: Any = True, accuracy: float | None = None) -> Any:
        of = type(alpha)
        simple = best is not None and where is True and (out is None or type(out) is np.ndarray)
        if simple and (of in _SCALARS or (of is np.ndarray and alpha.dtype.char in "df")):
            loop = best
            if accuracy is not None:
                loop = compiled[cheapest("d" if of is float else alpha.dtype.char, accuracy)]
            return loop(alpha) if out is None else loop(alpha, out)
        return general((alpha,), out, where, accuracy)

    def of_ends(one: Any, two: Any, out: Any = None, where: Any = True, accuracy: float | None = None) -> Any:
        floats = type(one) is type(two) is float
        if floats and best is not None and where is True and out is None is accuracy:
            return best(one, two)
        return general((one, two), out, where, accuracy)

    return of_ends if both_ends else of_alpha


def _general(
    name: str,
    texts: Mapping[str, Text],
    compiled: Mapping[str, Any],
    cheapest: Callable[[str, float], str],
    inside: Callable[..., Any],
    args: tuple[Any, ...],
    out: Any,
    where: Any,
    accuracy: float | None,
) -> Any:
    """Compute arguments of any type, by the compiled loop of a tier, by its text, or as an array's library does."""
    if not OWN.issuperset(map(type, (*args, where))) or not isinstance(out, np.ndarray | None):
        return _elsewhere(name, texts, inside, args, out, where, accuracy)
    items, kind = real(name, args)
    tier = "float32" if kind.char == "f" and "float32" in texts else "best"
    if accuracy is not None:
        tier = cheapest(kind.char, accuracy)
    loop = compiled[tier]
    if loop is None or kind.char not in "df":
        return evaluate(name, texts[tier], inside, (0.5,) if len(args) == 1 else (4.0, 5.0), items, kind, out, where)
    return _masked(loop, [np.asarray(x, dtype=kind) for x in items], out, where)


def _checked(name: str, form: str, kind: str, accuracy: float) -> str:
    """Return the cheapest tier for a single number."""
    if not isinstance(accuracy, _NUMBERS):
        raise TypeError(f"{name}: accuracy is one number, a relative error above 0, not {accuracy!r}")
    return _cheapest(name, form, kind, accuracy)


@cache
def _cheapest(name: str, form: str, kind: str, accuracy: float) -> str:
    """Return the cheapest tier that is proved to satisfy a relative error in a float format.

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
    """Apply a compiled loop where a mask is true. Elsewhere `out` is unchanged, or NaN without `out`."""
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


def _is_arc(eps: float, theta_1: Array, theta_2: Array) -> Any:
    alpha = 0.5 * theta_2 - 0.5 * theta_1
    near = (theta_1 >= -LIMIT) & (theta_2 <= LIMIT)
    ordered = theta_2 >= theta_1
    return near & ordered & (alpha <= HALF_PI * (1.0 + 4.0 * eps))


def _inside(eps: float, alpha: Array) -> Any:
    return (alpha >= 0.0) & (alpha <= HALF_PI * (1.0 + 4.0 * eps))


# --- arrays of other libraries ---------------------------------------------------------------------------------------

# Libraries whose arrays keep their type; of several arguments, the first library here decides.
LIBRARIES = ("xarray", "pandas", "pint", "dask", "jax", "jaxlib")


class _Space:
    """Functions of a tracing array library. At a tie, minimum and maximum propagate the complete derivative."""

    def __init__(self, functions: Any, least: float) -> None:
        self._functions = functions
        self._least = least  # normal number of the float type

    def __getattr__(self, name: str) -> Any:
        return getattr(self._functions, name)

    def minimum(self, a: Any, b: Any) -> Any:
        a, b = (b, a) if isinstance(a, float) else (a, b)
        return self.where(a > b, b, a)

    def maximum(self, a: Any, b: Any) -> Any:
        a, b = (b, a) if isinstance(a, float) else (a, b)
        if isinstance(b, float) and b > 0.0:
            b = max(b, self._least)
        return self.where(a < b, b, a)


def _library(x: Any) -> int:
    """Return the rank of an array's library, or the number of libraries if it belongs to none of them."""
    modules = [base.__module__ for base in type(x).__mro__]
    roots = {module.partition(".")[0] for module in modules}
    for rank, library in enumerate(LIBRARIES):
        if library in roots:
            return rank
    return len(LIBRARIES)


def _elsewhere(
    name: str,
    texts: Mapping[str, Text],
    inside: Callable[..., Any],
    args: tuple[Any, ...],
    out: Any,
    where: Any,
    accuracy: float | None,
) -> Any:
    """Compute a function of arrays of other libraries, as an array of the library that ranks first."""
    check_items(name, [x for x in args if _library(x) == len(LIBRARIES)])
    if out is not None or where is not True:
        raise TypeError(f"{name}: `out` and `where` are supported for numbers and NumPy arrays only")
    first = min(args, key=_library)
    library = LIBRARIES[_library(first)]
    # The public function travels to other processes by its name.
    call = partial(getattr(import_module("generated.kernels"), name), accuracy=accuracy)
    if library == "pint":  # radians and degrees are dimensionless, a length is an error
        numbers = []
        for x in args:
            has_unit = hasattr(x, "dimensionality")
            numbers.append(x.to("dimensionless").magnitude if has_unit else x)
        return type(first)(call(*numbers))
    if library in ("xarray", "pandas", "dask"):  # as if this were a ufunc
        count = len(args)
        call.__dict__.update(__name__="kernel", nin=count, nout=1, signature=None)
        result: Any = NotImplemented
        if hasattr(first, "__len__") and hasattr(first, "__array_ufunc__"):  # not the missing number of pandas
            with suppress(NotImplementedError):
                result = first.__array_ufunc__(call, "__call__", *args)
        if result is NotImplemented:
            names = [type(x).__name__ for x in args]
            kinds = " and ".join(names)
            raise TypeError(f"{name}: {library} does not support arguments of type {kinds} here")
        return result
    if accuracy is not None:
        raise ValueError(f"{name}: nothing is proved in the arithmetic of {library}; leave out accuracy")
    return _traced(name, texts, inside, args)


def _traced(name: str, texts: Mapping[str, Text], inside: Callable[..., Any], args: tuple[Any, ...]) -> Any:
    """Compute a function in the arithmetic of an array library that traces."""
    (traced, *_) = [x for x in args if hasattr(x, "__array_namespace__")]
    library = traced.__array_namespace__()
    given = [library.asarray(x) * 1.0 for x in args]  # of integers, the library's own float
    values = given
    kind = library.result_type(*values)
    if not library.isdtype(kind, "real floating"):
        raise TypeError(f"{name}: arguments of type {kind} are not supported: give real numbers")
    limits = library.finfo(kind)
    eps = float(limits.eps)
    tiny = float(limits.tiny)
    xp = _Space(library, tiny)
    text = texts["best"]  # that of float32 needs the range of float64
    if len(values) == 1:
        (alpha,) = values
        values = [xp.minimum(HALF_PI, alpha)]
    value = text(*values, xp)
    is_inside = inside(eps, *given)
    return xp.where(is_inside, value, np.nan)
