"""Searches for critical circles of scene files, of which many tests load the same, once in each process."""

import pickle
from collections.abc import Callable
from typing import Any

from slipcircle.base.kinds import Tell


def once(search: Callable[..., Any]) -> Callable[..., Any]:
    """Return a search that repeats the result and the lines of progress of an earlier one with equal arguments."""
    found: dict[bytes, tuple[Any, list[str]]] = {}

    def searched(*given: Any, tell: Tell = lambda _: None, **limits: Any) -> Any:
        key = pickle.dumps((given, limits))
        if key not in found:
            lines: list[str] = []
            found[key] = search(*given, tell=lines.append, **limits), lines
        result, lines = found[key]
        for line in lines:
            tell(line)
        return result

    return searched
