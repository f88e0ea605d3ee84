"""Odd scene files: mutations of those that ship and of the guide's, through load, solve, table and JSON.

``python -m tests.campaigns.fuzz_scenes 2000 --seed 1`` runs so many; each ends in an answer or a refusal of its
mistakes, within five seconds of a processor, or is shown with its file.
"""

import contextlib
import copy
import io
import json
import math
import signal
import sys
import tempfile
import time
import tomllib
import traceback
import warnings
from collections.abc import Iterable
from pathlib import Path
from random import Random
from typing import Any

from generated.effects import LAWS
from slipcircle.__main__ import main
from slipcircle.base import VERSION
from slipcircle.workbench.files.keys import WITH_ARC, fitted
from slipcircle.workbench.files.shipped import find, shipped
from slipcircle.workbench.stability.stability import METHODS
from tests.campaigns import options

SECONDS = 5.0
SIZES = (0, -1, 1, 5e-324, 1e-300, 1e-100, 1e-12, 1e-6, 1e-3, 0.5, 3, 45, 89.999, 90, 180, 271, 1e3, 1e6, 1e9, 1e12,
         1e15, 1e25, 1e103, 1e300, 1.7e308, -1e-9, -30, -1e9, -1e300, 10**30, math.nan, math.inf,
         -math.inf)  # fmt: skip
ODD: tuple[Any, ...] = ("", "x", "1.0", "ñ\u202e\U0001f30b", "\x1b[31m", True, False, [], [0], [0, 20, 50], [[1]],
                        ["a"], {}, {"a": 1}, {"distribution": "normal", "mean": 10, "std": 1}, {"distribution": "nope"},
                        {"distribution": "uniform", "low": 1, "high": 0}, "record.csv", "../../etc", "a" * 300,
                        )  # fmt: skip
BASES: list[dict[str, Any]] = [tomllib.loads(find(name).read_text("utf-8")) for name in shipped()]


def number(rng: Random) -> Any:
    """Any number, mostly of a size that a slope may have."""
    kind = rng.random()
    if kind < 0.3:
        return rng.choice(SIZES)
    return rng.choice((1, -1, 1, 1)) * 10 ** rng.uniform(-3, 4) if kind < 0.7 else rng.uniform(0, 90)


def allowed(rng: Random, key: Any) -> float:
    """Return a number that a key may have, often of an odd size."""
    low, high = key.low, key.high
    wide = rng.random() < 0.3
    size = 10 ** (rng.uniform(-12, 20) if wide else rng.uniform(-2, 3))
    size = size if rng.random() < 0.8 or low >= 0.0 else -size
    if low < size < high:
        return size
    return max(low, -1e3) + (min(high, 1e3) - max(low, -1e3)) * rng.uniform(1e-3, 0.999)


def key_values(rng: Random, table: Any) -> dict[str, Any]:
    """Return a table with some of its keys."""
    found: dict[str, Any] = {}
    count = rng.randrange(2, 5)
    many = any(key.kind == "list" for key in table.keys.values()) and rng.random() < 0.5
    leave = {rng.choice(pair) for pair in table.one_of}
    need = leave | ({rng.choice([k for k in table.any_of if k != "record"])} if table.any_of else set())
    others = {k for pair in table.one_of for k in pair} - leave
    for name, key in table.keys.items():
        if name in others or not (not key.optional or name in need or (rng.random() < 0.3 and key.kind != "text")):
            continue
        if key.kind == "list" or (key.kind == "series" and many):
            values = [allowed(rng, key) for _ in range(count)]
            found[name] = sorted(values) if key.name in ("slip", "time", "speed") else values
            found[name] = [0.0, *found[name][1:]] if key.name == "slip" else found[name]
        elif key.kind in ("number", "series"):
            found[name] = allowed(rng, key)
        elif key.kind != "text":
            found[name] = rng.random() < 0.5 if key.kind == "flag" else rng.choice(key.kind.split("|"))
    if "pulse" in found:
        found = {k: v for k, v in found.items() if k in ("pulse", "amplitude_g", "vertical_amplitude_g", "two_way")}
        found |= {"amplitude_g": rng.uniform(-2, 2), "duration_s": 10 ** rng.uniform(-2, 2)}
    return found


def section(rng: Random) -> dict[str, Any]:
    """Return a real slope in place of an arc: ground, circle, often water and what limits a search; either facing."""
    size, side = 10 ** rng.uniform(-1, 3), rng.choice((1, -1))
    height, run = size * rng.uniform(0.2, 1), size * rng.uniform(0, 2)
    rough = sorted(rng.uniform(0, 1) for _ in range(rng.choice((0, 0, 1, 3))))
    x = [-2 * size, 0, *(run * s for s in rough), run, run + 3 * size]
    y = [0, 0, *(height * (s + rng.uniform(-0.2, 0.2)) for s in rough), height, height]
    points = sorted([side * a, b] for a, b in zip(x, y, strict=True))
    ground: dict[str, Any] = {"unit_weight_kN_m3": rng.uniform(10, 30), "points_m": points}
    if rng.random() < 0.2:
        ground = {"unit_weight_kN_m3": 20, "height_m": height, "angle_deg": rng.uniform(5, 90)}
    if rng.random() < 0.3:
        ground["base_m"] = -rng.uniform(-0.1, 1) * size
    ends = sorted([[side * rng.uniform(-1, 0) * size, 0.0], [side * (run + rng.uniform(0, 1) * size), height]])
    kind, deep = rng.random(), rng.uniform(0.02, 0.6) * size
    circle: dict[str, Any] = {"through_m": ends, "depth_m": deep}
    if kind < 0.12:
        circle = {"critical": rng.choice([*METHODS])}
    elif kind < 0.3:
        circle = {"centre_m": [side * run / 2, 2 * size], "radius_m": rng.uniform(1, 3) * size}
    elif kind < 0.5:
        circle = {"through_m": ends, rng.choice(("radius_m", "touching_m")): rng.uniform(-1, 4) * size}
    found = {"ground": ground, "circle": circle}
    if rng.random() < 0.4:
        found["water"] = {
            "level_m": [[a, b - rng.uniform(-0.05, 0.5) * size] for a, b in points[:: rng.choice((1, 2))]]
        }
    if "critical" in circle and rng.random() < 0.4:
        found["search"] = {"depth_m": 0.1 * deep, "k_h": rng.uniform(-0.2, 0.5)}
    return found


def document(rng: Random) -> dict[str, Any]:
    """Return a scene that ships, or one of random tables and numbers; then some mistakes."""
    found = copy.deepcopy(rng.choice(BASES))
    if rng.random() < 0.6:
        law = rng.choice([*LAWS])
        tables = fitted(WITH_ARC, {"friction": {"law": law}})
        arc = {"radius_m": 10 ** rng.uniform(0, 4), "theta_1_deg": rng.uniform(180, 250),
               "theta_2_deg": rng.uniform(255, 340), "unit_weight_kN_m3": rng.uniform(10, 30)}  # fmt: skip
        found = {"arc": arc} if rng.random() < 0.7 else section(rng)
        found["friction"] = key_values(rng, tables["friction"]) | {"law": law}
        for name in tables:
            if name not in ("", "arc", "arc.given", "friction", "friction.rate") and rng.random() < 0.25:
                found[name] = key_values(rng, tables[name])
        if rng.random() < 0.5:
            found = {"end_time_s": 10 ** rng.uniform(-1, 3)} | found
    for _ in range(rng.choice((0, 0, 0, 1, 1, 2, 3))):
        mutate(rng, found)
    return found


def mutate(rng: Random, given: dict[str, Any]) -> None:
    """One mistake, or another number."""
    held, names = given, list(given)
    while names:
        name = rng.choice(names)
        if not isinstance(held[name], dict) or rng.random() < 0.15:
            break
        held, names = held[name], list(held[name])
    what = rng.random()
    if not names or what < 0.1:
        held[rng.choice(["phi_deg", "radius", "ñ", "", "end_time_s", "gaps", "rate", "a.b", "angle_deg"])] = number(rng)
    elif what < 0.2:
        del held[name]
    elif what < 0.35:
        held[name] = copy.deepcopy(rng.choice(ODD))
    elif what < 0.4:
        deep: Any = 1
        for _ in range(rng.choice((3, 30, 300))):
            deep = [deep] if rng.random() < 0.5 else {"a": deep}
        held[name] = deep
    elif what < 0.5 and isinstance(held[name], list):
        held[name] = [*held[name][: rng.randrange(3)], number(rng)]
    elif isinstance(held[name], int | float) and rng.random() < 0.5:
        held[name] = held[name] * 10 ** rng.uniform(-3, 3)
    elif not isinstance(held[name], str) or rng.random() < 0.3:
        held[name] = number(rng)


def toml(value: Any, top: bool = True) -> str:
    """Return a document as TOML: tables inline below the first level."""
    if isinstance(value, dict):
        if top:
            plain = {k: v for k, v in value.items() if not isinstance(v, dict)}
            lines = [f"{json.dumps(k)} = {toml(v, False)}" for k, v in plain.items()]
            for k in value.keys() - plain.keys():
                lines += [f"[{json.dumps(k)}]", *(f"{json.dumps(n)} = {toml(v, False)}" for n, v in value[k].items())]
            return "\n".join(lines) + "\n"
        return "{" + ", ".join(f"{json.dumps(k)} = {toml(v, False)}" for k, v in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(toml(v, False) for v in value) + "]"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=True).replace("\\ud83c\\udf0b", "\\U0001f30b")
    if isinstance(value, float) and not math.isfinite(value):
        return repr(value)
    return str(value).lower() if isinstance(value, bool) else repr(value)


class Late(BaseException):
    """The time is up."""


def _late(*_: Any) -> None:
    raise Late


def fault(path: Path, command: str = "run", seconds: float = SECONDS) -> str:
    """Return the fault in the answer to a scene file, or an empty text if it is answered or refused correctly."""
    out, err = io.StringIO(), io.StringIO()
    started = time.process_time()
    signal.signal(signal.SIGPROF, _late)
    signal.setitimer(signal.ITIMER_PROF, 4 * seconds)
    try:
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err), warnings.catch_warnings():
            warnings.simplefilter("error")
            status = main([command, str(path), *(["--json"] if len(path.read_bytes()) % 2 else [])])
    except Late:
        return f"takes over {4 * seconds:.0f} s"
    except BaseException:
        return traceback.format_exc(limit=-4)
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0.0)
    took, said = time.process_time() - started, err.getvalue()
    if took > seconds:
        return f"takes {took:.1f} s"
    if status == 0:
        bad = [word for word in (" nan", "NaN", "Infinity") if word in out.getvalue()]
        return f"prints {bad}" if bad else "" if out.getvalue() else "says nothing"
    wrong = [
        word
        for word in ("array", "ambiguous", "math domain", "object", "NoneType", "float()", "'>' not")
        if word in said
    ]
    return f"refuses with {status}: {said[-300:]}" if status != 1 or not said or wrong or out.getvalue() else ""


def faults(which: Iterable[int], seed: int, folder: Path, command: str = "run",
           seconds: float = SECONDS) -> list[tuple[int, str, str]]:  # fmt: skip
    """Return number, file and fault of the scenes with a bad answer."""
    found = []
    for k in which:
        path = folder / "odd.toml"
        text = toml(document(Random(f"{seed} {k}")))
        path.write_text(text, "utf-8")
        if said := fault(path, command, seconds):
            found.append((k, text, said))
    return found


if __name__ == "__main__":
    asked = options(__doc__, 2000)
    begun = time.monotonic()
    with tempfile.TemporaryDirectory() as place:
        bad = faults(range(asked.count), asked.seed, Path(place))
    for number_, text_, said_ in bad:
        print(f"--- {number_}\n{text_}\n{said_}\n")
    print(
        f"slipcircle {VERSION}: {asked.count} scene files, {len(bad)} answered badly, {time.monotonic() - begun:.0f} s"
    )
    sys.exit(bool(bad))
