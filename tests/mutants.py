"""Plant random faults in the runtime and see which the tests miss: ``python tests/mutants.py --count 60 --seed 1``.

A fault is one changed node of a module's syntax tree: a sign, a comparison, a constant, swapped arguments, a statement
left out. Each is planted alone in a copy of the project. It counts if it changes an answer (numbers of the golden
scenes, ensembles, what the command line prints and writes); then the tests have to turn red: fast ones first, and of
what survives those, all that know the package. What hangs counts as caught. The exit status is 1 below 90 per cent.
"""

import argparse
import ast
import contextlib
import io
import json
import math
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from queue import Queue
from typing import Any, NamedTuple

ROOT = Path(__file__).parents[1]
COPIED = ("slipcircle", "generated", "derive", "tests", "notebooks")
FAST = ("test_golden", "test_borders", "test_outputs", "test_ensemble_states", "test_cli", "test_scenefile")
# Slow, or of other things.
NEVER = ("test_house", "test_notebooks", "test_cost", "test_cost_scenes", "test_compiled", "test_build",
         "test_extending", "test_all_weights")  # fmt: skip
SLOW = 5  # times what the tree itself takes for its answers is a hang; for its tests, this many times more
NUMBER = re.compile(r"(?<![\w.])[-+]?\d+\.?\d*(?:e[-+]?\d+)?")


# --- answers ---------------------------------------------------------------------------------------------------------

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
    import golden
    import test_ensemble_states as ensembles

    from slipcircle.__main__ import main

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
    path: Path
    line: int
    words: str
    source: str


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


def faults(count: int, seed: int, run: dict[str, list[int]]) -> list[Fault]:
    """Random ones, every place that the answers pass as likely as any other."""
    rng, places = random.Random(seed), []
    for name, lines in run.items():
        tree, passed = ast.parse((ROOT / name).read_text("utf-8")), set(lines)
        for k, (node, _, _) in enumerate(changes(tree)):
            if passed.intersection(range(node.lineno, node.end_lineno + 1)):  # type: ignore[attr-defined]
                places.append((name, k))
    found = []
    for name, k in rng.sample(places, count):
        tree = ast.parse((ROOT / name).read_text("utf-8"))
        node, words, plant = list(changes(tree))[k]
        before, line = ast.unparse(node).partition("\n")[0][:70], node.lineno  # type: ignore[attr-defined]
        plant()
        found.append(Fault(Path(name), line, f"{words}: {before}", ast.unparse(ast.fix_missing_locations(tree))))
    return found


# --- the work --------------------------------------------------------------------------------------------------------


def copied(folder: Path) -> Path:
    for name in COPIED:
        shutil.copytree(ROOT / name, folder / name, ignore=shutil.ignore_patterns("__pycache__", ".*"))
    for path in (p for p in ROOT.iterdir() if p.is_file()):
        shutil.copy(path, folder)
    return folder


def run(folder: Path, limit: float, *argv: str) -> subprocess.CompletedProcess[str] | None:
    """A Python in the copy; None if it takes too long."""
    env = os.environ | {"PYTHONPATH": str(folder), "PYTHONDONTWRITEBYTECODE": "1", "OMP_NUM_THREADS": "1"}
    try:
        return subprocess.run([sys.executable, *argv], cwd=folder, env=env, capture_output=True, text=True,
                              timeout=None if limit == math.inf else limit, stdin=subprocess.DEVNULL,
                              check=False)  # fmt: skip
    except subprocess.TimeoutExpired:
        return None


def passed(folder: Path) -> dict[str, list[int]]:
    """The lines of the package that the answers run, by file."""
    found: dict[str, set[int]] = {}
    home = f"{folder}/slipcircle/"

    def follow(frame: Any, event: str, _: Any) -> Any:
        if not frame.f_code.co_filename.startswith(home):
            return None
        if event == "line":
            found.setdefault(frame.f_code.co_filename[len(str(folder)) + 1 :], set()).add(frame.f_lineno)
        return follow

    sys.settrace(follow)
    dict(answers())
    sys.settrace(None)
    return {name: sorted(lines) for name, lines in sorted(found.items())}


def probed(folder: Path, limit: float, what: str = "--answers") -> dict[str, Any] | None:
    done = run(folder, limit, "tests/mutants.py", what)
    return json.loads(done.stdout) if done and not done.returncode else None


def judged(folder: Path, fault: Fault, good: dict[str, Any], limit: float) -> str:
    """What became of a fault: no answer changed, caught by which test, or SURVIVED."""
    target = folder / fault.path
    whole = target.read_text("utf-8")
    target.write_text(fault.source, "utf-8")
    try:
        found = probed(folder, limit)
        changed = [k for k in good if differ(good[k], found.get(k))] if found else ["everything"]
        if not changed:
            return "no answer changed"
        every = {p.stem for p in (folder / "tests").glob("test_*.py") if "slipcircle" in p.read_text("utf-8")}
        for names in (FAST, sorted(every - {*FAST, *NEVER})):
            files = [f"tests/{n}.py" for n in names if (folder / f"tests/{n}.py").exists()]
            done = run(folder, SLOW * limit, "-m", "pytest", "-x", "-q", "-p", "no:cacheprovider", *files)
            if done is None:
                return "caught: hangs"
            if done.returncode:
                red = re.search(r"^(?:FAILED|ERROR) tests/([^ \[]*)", done.stdout, re.MULTILINE)
                return f"caught by {red[1] if red else 'the import'}"
        return f"SURVIVED, changes {len(changed)} answers: {', '.join(changed[:3])}"
    finally:
        target.write_text(whole, "utf-8")


def main() -> int:
    parser = argparse.ArgumentParser(description=str(__doc__).partition("\n")[0])
    parser.add_argument("--count", type=int, default=60)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--answers", action="store_true", help="print the answers of this tree, and do nothing else")
    parser.add_argument("--lines", action="store_true", help="print the lines that they run, and do nothing else")
    options = parser.parse_args()
    if options.answers or options.lines:
        sys.path[:0] = [str(ROOT), str(ROOT / "tests")]
        print(json.dumps(passed(ROOT) if options.lines else dict(answers())))
        return 0
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(options.jobs) as pool:
        free: Queue[Path] = Queue()
        for k in range(options.jobs):
            free.put(copied(Path(folder) / f"{k}"))
        begin = time.monotonic()
        one, two = (probed(Path(folder) / "0", math.inf) for _ in range(2))
        assert one, "the tree itself gives no answers"
        assert two
        limit = SLOW * (time.monotonic() - begin) / 2
        good = {k: v for k, v in one.items() if not differ(v, two[k])}  # what holds no time of this run

        def work(fault: Fault) -> str:
            here = free.get()
            try:
                return judged(here, fault, good, limit)
            finally:
                free.put(here)

        lines = probed(Path(folder) / "0", math.inf, "--lines") or {}
        chosen, verdicts = faults(options.count, options.seed, lines), []
        for fault, verdict in zip(chosen, pool.map(work, chosen), strict=True):
            verdicts.append(verdict)
            print(f"{fault.path}:{fault.line}: {fault.words}: {verdict}", flush=True)
    caught = sum(v.startswith("caught") for v in verdicts)
    counted = sum(not v.startswith("no answer") for v in verdicts)
    print(f"{counted} of {len(verdicts)} faults change an answer; {caught} are caught, {counted - caught} survive")
    return int(caught < 0.9 * counted)


if __name__ == "__main__":
    sys.exit(main())
