"""Friction as a scene gives it, a number, a law by name from `generated.effects` or a function: names and mistakes."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from generated.effects import LAWS
from slipcircle.base.checks import mistakes


def law_mistakes(given: Any) -> list[str]:
    """A sentence for each mistake in a scene's friction."""
    if callable(given):
        return []
    if not isinstance(given, Mapping):
        return mistakes(
            {"friction": given},
            {"friction": (-5e-324, np.inf, "a friction coefficient, tan(phi): a number of at least 0")},
        )
    found = _named_mistakes(given, "friction", tuple(LAWS))
    if not found and "rate" in given:
        if "speed" in LAWS[given["law"]].depends_on or "time" in LAWS[given["law"]].depends_on:
            found.append(f"friction.rate: {given['law']} is no law of slip; leave one out")
        elif not isinstance(given["rate"], Mapping):
            found.append(f"friction.rate = {given['rate']!r}: must be a law of speed with its parameters")
        else:
            found += _named_mistakes(given["rate"], "friction.rate", RATE_LAWS)
    return found


RATE_LAWS = tuple(name for name, law in LAWS.items() if law.depends_on == ("speed",))


def _named_mistakes(given: Mapping[str, Any], path: str, known: tuple[str, ...]) -> list[str]:
    """A sentence for each mistake in a law by name."""
    name = given.get("law")
    if name not in known:
        return [f"{path}.law = {name!r}: must be one of {', '.join(known)}"]
    wanted = {p.name: p for p in LAWS[name].parameters}
    rest = {k: v for k, v in given.items() if k != "law" and (k, path) != ("rate", "friction")}
    found = [f"{path}.{n}: is missing: {p.help}" for n, p in wanted.items() if n not in rest]
    found += [f"{path}.{n}: is unknown; known are {', '.join(wanted)}" for n in rest if n not in wanted]
    bounds = {n: (p.lower, p.upper, f"{p.help}, {_range(p)}") for n, p in wanted.items() if n in rest}
    found += [f"{path}.{m}" for m in mistakes(rest, bounds)]
    first = wanted[next(iter(wanted))]
    if first.kind == "list" and not found:
        place, values = (np.asarray(given[n], dtype=float) for n in wanted)
        if place.ndim != 1 or place.shape != values.shape or place.size < 2:
            found.append(
                f"{path}.{first.name} and {path}.coefficient: must be two lists of equal length, two values at least"
            )
        elif name == "tabulated" and (place[0] != 0.0 or np.any(np.diff(place) <= 0.0)):
            found.append(f"{path}.slip: must start at 0 and increase")
        elif np.any(np.diff(place) <= 0.0):
            found.append(f"{path}.{first.name}: must increase")
    return found


def _range(p: Any) -> str:
    low = "at least 0" if p.lower < 0.0 else "positive"
    return f"{low}{' ' + p.unit if p.unit else ''}"


def law_names(given: Any) -> tuple[str, ...]:
    """The names of the law that a scene's ``friction`` stands for, and of the law of speed that multiplies it."""
    if callable(given):
        return ("callable",)
    if not isinstance(given, Mapping):
        return ("constant",)
    return (str(given["law"]), *([str(given["rate"]["law"])] if "rate" in given else []))


def law_depends(given: Any) -> tuple[str, ...]:
    """What the law that a scene's ``friction`` stands for depends on: some of slip, speed, time."""
    if callable(given):
        return ("slip",)
    if not isinstance(given, Mapping):
        return ()
    return LAWS[given["law"]].depends_on + (("speed",) if "rate" in given else ())
