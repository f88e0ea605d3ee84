"""Plant random faults in the runtime and see which the tests miss.

``python -m tests.campaigns.mutants --count 60 --seed 1`` plants so many. A fault is one changed node of a module's
syntax tree: a sign, a comparison, a constant, swapped arguments, a statement left out. Each is planted alone in a copy
of the project. It counts if it changes an answer (numbers of the golden scenes, ensembles, what the command line prints
and writes); then a test has to turn red that is green in the same copy without it. Asked are all files of tests that
know the package, those first that caught most. What hangs is caught. A verdict is printed when it falls, with the
counts so far; ``--only 7 12`` repeats single faults of the same seed, ``--tests test_arc.py`` asks fewer files. The
exit status is 1 below 90 per cent.
"""

import argparse
import ast
import compileall
import contextlib
import io
import json
import math
import os
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections import Counter
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path
from py_compile import PycInvalidationMode
from queue import Queue
from typing import Any, NamedTuple

ROOT = Path(__file__).parents[2]
COPIED = ("slipcircle", "generated", "derive", "tests", "notebooks")
FIRST = ("test_outputs", "test_records", "test_scenefile", "test_ensemble_states", "test_backanalysis", "test_ensemble")
# Slow, or of other things.
NEVER = ("test_house", "test_notebooks", "test_cost", "test_compiled", "test_build",
         "test_extending", "test_all_weights")  # fmt: skip
SLOW = 5  # times what the tree itself takes for its answers is a hang
HANG_S = 90  # of one test; the slowest takes a tenth of it
NUMBER = re.compile(r"(?<![\w.])[-+]?\d+\.?\d*(?:e[-+]?\d+)?")


COMMANDS = """run vaiont vaiont-softening wet-slope | run vaiont --json | run vaiont-shaken --json
run wet-slope --json
run newmark-pulse --csv {}/a.csv | run wet-slope vaiont-heated --csv {}/b.csv | run lifted.toml --json | run lifted.toml
run vaiont --report {}/c.html | plan vaiont-shaken | plan vaiont --json | plan wet-slope | sensitivity wet-slope
sensitivity vaiont --json | backanalyse vaiont --run-out-m 500+-20 --json | backanalyse wet-slope --run-out-m 6
backanalyse vaiont --run-out-m 700+-10 --peak-velocity-m-s 29+-1 --field friction --field initial_velocity=0:5
sweep vaiont --grid friction.angle_deg=8:24:9 --json
sweep wet-slope --samples 300 --seed 4 --uncertain pore_pressure.ratio=uniform:0:0.4
sweep vaiont --samples 128 --seed 1 --method sobol --uncertain friction.angle_deg=normal:12:1 --csv {}/d.csv
sweep vaiont --samples 64 --seed 1 --method latin-hypercube --uncertain friction.angle_deg=uniform:8:12 --sensitivity 16
sweep vaiont-softening --samples 64 --seed 2 --uncertain friction.length_m=lognormal:1:0.5 --json
run none | run broken.toml | schema --text"""
LIFTED = """name = "lifted"\nend_time_s = 3\n[arc]\nradius_m = 60\ntheta_1_deg = 220\ntheta_2_deg = 290
unit_weight_kN_m3 = 19\n[friction]\nangle_deg = 11\n[rotation]\n[pore_pressure]\npressure_kPa = 260\n"""


def answers() -> Iterator[tuple[str, Any]]:
    """Numbers and texts by a name, as the package in the path gives them."""
    from slipcircle.__main__ import main
    from tests.support import ensembles, golden

    for name in golden.rows():
        try:
            motion = golden.solved(name)
            numbers: Any = golden.numbers(motion, golden.times(motion))
        except Exception as error:
            numbers = repr(error)
        yield name, numbers
    for law in ensembles.LAWS[:5]:
        for effects in ensembles.EFFECTS[:8]:
            try:
                found = ensembles.together(ensembles.lanes(law, effects))
                both = [[getattr(s, f).tolist() for f in golden.STATE] for s in (found.end, found.peak)]
            except Exception as error:
                both = [[repr(error)]]
            yield f"lanes {law} {effects}", both
    with tempfile.TemporaryDirectory() as folder:
        here = Path(folder)
        (here / "lifted.toml").write_text(LIFTED, "utf-8")
        (here / "broken.toml").write_text(LIFTED.replace("radius_m = 60", "radius_m = -6\nbreadth = 1"), "utf-8")
        os.chdir(here)
        for line in re.split(r" \| |\n", COMMANDS):
            out = io.StringIO()
            with contextlib.redirect_stdout(out), contextlib.redirect_stderr(out):
                try:
                    status: Any = main(line.format(".").split())
                except (SystemExit, Exception) as error:
                    status = repr(error)
            yield line, [status, out.getvalue().replace(folder, ".")]
        for path in sorted(here.glob("*.csv")) + sorted(here.glob("*.html")):
            yield path.name, re.sub(r"(?s)<svg.*?</svg>|<img[^>]*>", "", path.read_text("utf-8"))


def differ(one: Any, other: Any) -> bool:
    """Whether two answers differ by more than rounding, which residuals are all, and by the time that it took."""
    if isinstance(one, dict) and isinstance(other, dict):
        return one.keys() != other.keys() or any(differ(one[k], other[k]) for k in one)
    if isinstance(one, list) and isinstance(other, list):
        return len(one) != len(other) or any(map(differ, one, other))
    if isinstance(one, str) and isinstance(other, str):
        if one == other:
            return False
        texts = [[x for x in t.splitlines() if "residual" not in x and " a second, in " not in x] for t in (one, other)]
        lines = list(zip(*texts, strict=False))
        return len(texts[0]) != len(texts[1]) or any(
            NUMBER.sub("#", a) != NUMBER.sub("#", b)
            or any(differ(float(x), float(y)) for x, y in zip(NUMBER.findall(a), NUMBER.findall(b), strict=True))
            for a, b in lines
        )
    if isinstance(one, float) and isinstance(other, float):
        return not (
            one == other or (one != one and other != other) or math.isclose(one, other, rel_tol=1e-8, abs_tol=1e-11)
        )
    return bool(one != other)


# --- faults ----------------------------------------------------------------------------------------------------------

OPERATORS: dict[type, type] = {ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult,
                               ast.Lt: ast.Gt, ast.Gt: ast.LtE, ast.LtE: ast.Lt, ast.GtE: ast.Lt, ast.Eq: ast.NotEq,
                               ast.NotEq: ast.Eq, ast.And: ast.Or, ast.Or: ast.And, ast.Is: ast.IsNot,
                               ast.IsNot: ast.Is, ast.In: ast.NotIn, ast.NotIn: ast.In}  # fmt: skip


class Fault(NamedTuple):
    path: str
    place: int  # among the module's changes
    line: int
    words: str
    reach: range  # its lines in the normal form of the module


def normal(text: str) -> str:
    """The form that planting gives a module, so that the fault alone is what differs from the tree that is measured."""
    return ast.unparse(ast.parse(text))


def changes(tree: ast.AST) -> Iterator[tuple[ast.AST, str, Callable[[], None]]]:
    """Every fault that a tree may get: where, what it is called, and what plants it."""
    texts = {id(n.value) for n in ast.walk(tree) if isinstance(n, ast.Expr) and isinstance(n.value, ast.Constant)}
    typing = {id(n) for a in ast.walk(tree) for field in ("annotation", "returns")
              if (part := getattr(a, field, None)) for n in ast.walk(part)}  # fmt: skip
    for node in ast.walk(tree):
        if id(node) in typing:
            continue
        match node:
            case ast.BinOp(op=op) | ast.BoolOp(op=op) | ast.AugAssign(op=op) if type(op) in OPERATORS:
                yield node, "operator", lambda n=node, o=op: setattr(n, "op", OPERATORS[type(o)]())  # type: ignore[misc]
            case ast.Compare(ops=[op]) if type(op) in OPERATORS:
                yield node, "comparison", lambda n=node, o=op: setattr(n, "ops", [OPERATORS[type(o)]()])  # type: ignore[misc]
            case ast.Constant(value=bool() as value):
                yield node, "flag", lambda n=node, v=value: setattr(n, "value", not v)  # type: ignore[misc]
            case ast.Constant(value=int() | float() as value) if id(node) not in texts:
                yield node, "constant", lambda n=node, v=value: setattr(n, "value", 2 * v if v > 2 else v + 1)  # type: ignore[misc]
            case ast.UnaryOp(op=ast.USub()):
                yield node, "sign", lambda n=node: setattr(n, "op", ast.UAdd())  # type: ignore[misc]
            case ast.Call(args=[first, second, *rest]):
                yield node, "arguments", lambda n=node, a=[second, first, *rest]: setattr(n, "args", a)  # type: ignore[misc]
            case ast.If(test=test) | ast.IfExp(test=test):
                yield node, "condition", lambda n=node, t=test: setattr(n, "test", ast.UnaryOp(ast.Not(), t))  # type: ignore[misc]
        for body in (getattr(node, field, None) for field in ("body", "orelse")):
            for k, line in enumerate(body if isinstance(body, list) else []):
                plain = isinstance(line, ast.Expr) and id(line.value) not in texts
                if (
                    plain
                    or isinstance(line, ast.AugAssign | ast.Raise)
                    or (isinstance(line, ast.If) and not line.orelse)
                ):
                    yield line, "left out", lambda b=body, k=k: b.__setitem__(k, ast.Pass())  # type: ignore[misc]


def faults() -> Iterator[Fault]:
    """Every fault of the package."""
    for path in sorted((ROOT / "slipcircle").rglob("*.py")):
        text = path.read_text("utf-8")
        given, written = (changes(ast.parse(t)) for t in (text, normal(text)))
        for place, ((old, words, _), (new, _, _)) in enumerate(zip(given, written, strict=True)):
            words = f"{words}: {ast.unparse(old).partition(chr(10))[0][:70]}"
            reach = range(new.lineno, new.end_lineno + 1)  # type: ignore[attr-defined]
            yield Fault(str(path.relative_to(ROOT)), place, old.lineno, words, reach)  # type: ignore[attr-defined]


def planted(fault: Fault) -> str:
    tree = ast.parse((ROOT / fault.path).read_text("utf-8"))
    list(changes(tree))[fault.place][2]()
    return ast.unparse(ast.fix_missing_locations(tree))


# --- the work --------------------------------------------------------------------------------------------------------


def copied(folder: Path) -> Path:
    for name in COPIED:
        shutil.copytree(ROOT / name, folder / name, ignore=shutil.ignore_patterns("__pycache__", ".*"))
    for path in (p for p in ROOT.iterdir() if p.is_file()):
        shutil.copy(path, folder)
    for path in (folder / "slipcircle").rglob("*.py"):
        path.write_text(normal(path.read_text("utf-8")), "utf-8")
    compileall.compile_dir(folder, quiet=1, invalidation_mode=PycInvalidationMode.CHECKED_HASH)
    return folder


def run(folder: Path, limit: float | None, *argv: str) -> tuple[int | None, str]:
    """Exit status, none of a hang, and output of a Python in the copy, which is ended with all that it started."""
    env = os.environ | {"PYTHONPATH": str(folder), "PYTHONDONTWRITEBYTECODE": "1", "OMP_NUM_THREADS": "1"}
    with tempfile.TemporaryFile("w+") as out:
        child = subprocess.Popen([sys.executable, *argv], cwd=folder, env=env, stdin=subprocess.DEVNULL, stdout=out,
                                 stderr=subprocess.DEVNULL, start_new_session=True)  # fmt: skip
        try:
            status: int | None = child.wait(limit)
        except subprocess.TimeoutExpired:
            status = None
        finally:
            with contextlib.suppress(ProcessLookupError):
                os.killpg(child.pid, signal.SIGKILL)
            child.wait()
        out.seek(0)
        return status, out.read()


def probed(folder: Path, limit: float | None = None, what: str = "--answers") -> Any:
    status, text = run(folder, limit, "-m", "tests.campaigns.mutants", what)
    return json.loads(text) if status == 0 else None


def tested(folder: Path, *names: str) -> tuple[bool, str]:
    """Whether tests are green, and the function of the first that is not."""
    hang = ("-o", f"faulthandler_timeout={HANG_S}", "-o", "faulthandler_exit_on_timeout=true")
    status, text = run(folder, None, "-m", "pytest", "-x", "-q", "-p", "no:cacheprovider", *hang, *names)
    red = re.search(r"^(?:FAILED|ERROR) (tests/[^\s\[]*)", text, re.MULTILINE)
    return status == 0, red[1] if red else ""


def reached(folder: Path) -> list[str]:
    """The lines of the package that the answers run, ``path:line``."""
    found: dict[str, None] = {}

    def follow(frame: Any, event: str, _: Any) -> Any:
        if not frame.f_code.co_filename.startswith(f"{folder}/slipcircle/"):
            return None
        if event == "line":
            found[f"{frame.f_code.co_filename[len(str(folder)) + 1 :]}:{frame.f_lineno}"] = None
        return follow

    threading.settrace(follow)
    sys.settrace(follow)
    dict(answers())
    sys.settrace(None)
    return list(found)


def judged(folder: Path, fault: Fault, good: dict[str, Any], limit: float, files: list[str], seen: Counter[str]) -> str:
    """What became of a fault: no answer changed, caught by which test, or SURVIVED."""
    target = folder / fault.path
    whole, begin = target.read_text("utf-8"), time.monotonic()
    try:
        target.write_text(planted(fault), "utf-8")
        found = probed(folder, limit)
        changed = [k for k in good if differ(good[k], found.get(k))] if found else ["everything"]
        if not changed:
            return "no answer changed"
        skip: list[str] = []
        while True:
            target.write_text(planted(fault), "utf-8")
            near = {name for name in files if Path(fault.path).stem in (ROOT / name).read_text("utf-8")}
            green, name = tested(folder, *skip, *sorted(files, key=lambda f: (f not in near, -seen[f])))
            if green:
                return f"SURVIVED, skipped {skip}, changes {len(changed)} answers: {changed[:4]}"
            target.write_text(whole, "utf-8")
            if not name or tested(folder, name)[0]:
                seen[name.partition("::")[0]] += 1
                return f"caught by {name or 'a hang'} after {time.monotonic() - begin:.0f} s"
            skip.append(f"--deselect={name}")  # red without the fault too
    finally:
        target.write_text(whole, "utf-8")


def main() -> int:
    parser = argparse.ArgumentParser(description=str(__doc__).partition("\n")[0])
    parser.add_argument("--count", type=int, default=60)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", type=int, nargs="+", help="these of them alone, by number")
    parser.add_argument("--tests", nargs="+", default=["test_*.py"], help="files of tests asked, all unless given")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--answers", action="store_true", help="print the answers of this tree, and do nothing else")
    parser.add_argument("--lines", action="store_true", help="print the lines that they run, and do nothing else")
    options = parser.parse_args()
    if options.answers or options.lines:
        print(json.dumps(reached(ROOT) if options.lines else dict(answers())))
        return 0
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(options.jobs) as pool:
        free: Queue[Path] = Queue()
        for k in range(options.jobs):
            free.put(first := copied(Path(folder) / f"{k}"))

        def away(work: Callable[..., Any], *arguments: Any) -> Any:
            here = free.get()
            try:
                return work(here, *arguments)
            finally:
                free.put(here)

        lines, begin = set(probed(first, None, "--lines")), time.monotonic()
        places = [f for f in faults() if any(f"{f.path}:{line}" in lines for line in f.reach)]
        one, two = probed(first), probed(first)
        limit = SLOW * (time.monotonic() - begin)
        good = {k: v for k, v in one.items() if not differ(v, two[k])}  # what holds no time of this run
        random.Random(options.seed).shuffle(places)
        chosen = {k: f for k, f in enumerate(places[: options.count]) if k in (options.only or range(options.count))}
        able = {p for word in options.tests for p in (ROOT / "tests").glob(word) if p.stem not in NEVER}
        known = [p.stem for p in able if "slipcircle" in p.read_text("utf-8")]
        order = [stem for stem in FIRST if stem in known] + sorted({*known} - {*FIRST})
        files = [f"tests/{stem}.py" for stem in order]
        seen: Counter[str] = Counter()
        assert tested(first, files[0])[0], f"{files[0]} is red without a fault"
        falls = {pool.submit(away, judged, f, good, limit, files, seen): (k, f) for k, f in chosen.items()}
        caught = counted = 0
        for fall in as_completed(falls):
            (k, fault), verdict = falls[fall], fall.result()
            caught += verdict.startswith("caught")
            counted += not verdict.startswith("no answer")
            print(f"{k} {fault.path}:{fault.line}: {fault.words}: {verdict} [{caught} of {counted}]", flush=True)
    print(f"{counted} of {len(falls)} faults change an answer; {caught} are caught, {counted - caught} survive")
    return int(caught < 0.9 * counted)


if __name__ == "__main__":
    sys.exit(main())
