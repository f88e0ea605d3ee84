"""Plant random faults in `slipcircle` and `derive`, and count those that no test notices.

``python -m tests.campaigns.mutants 100 --seed 1`` plants so many, one at a time, in a copy of the project. A fault is
one changed node of a module's syntax tree: an operator, a comparison, a constant, a sign, swapped arguments, a negated
condition, a missing statement. First all tests run once with ``pytest-cov``, which has to be installed, to find the
lines that each test reaches. ``--map FILE`` stores them for the next run. The tests that reach each file are stored by
`tests.support.reach` for ``./run test --of``. A fault is caught if one of the tests that reach its line fails; they run
in the order of their duration. A test that hangs has failed. A fault that survives changes no answer (numbers of the
golden scenes and ensembles, output and files of commands) or shows a gap in the tests.
"""

import ast
import contextlib
import io
import json
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

import numpy as np

from tests.campaigns import options
from tests.support import reach

ROOT = Path(__file__).parents[2]
PACKAGES = ("slipcircle", "derive")
NOT_OF_BEHAVIOUR = ("test_architecture", "test_book")  # style and layout, which every change of a tree can offend
AT_IMPORT = "import"  # in the place of a test
HANG_S = 120  # of one test; the slowest takes a fifth of it
LIMIT_S = 900  # of all tests of one fault
NUMBER = re.compile(r"(?<![\w.])[-+]?\d+\.?\d*(?:e[-+]?\d+)?")
COMMANDS = """run vaiont vaiont-softening wet-slope layered-slope | run vaiont --json | run vaiont-shaken --json
run newmark-pulse --csv a.csv | run wet-slope vaiont-heated --csv b.csv | plan vaiont-shaken | plan vaiont --json
sensitivity vaiont --json | search weak-toe --json | backanalyse vaiont --run-out-m 500+-20 --json
backanalyse vaiont --run-out-m 700+-10 --peak-velocity-m-s 29+-1 --field friction --field initial_velocity=0:5
sweep vaiont --grid friction.angle_deg=8:24:9 --json | sweep weak-toe --grid layers.2.top_m=1:2:3 --json
sweep wet-slope --samples 300 --seed 4 --uncertain pore_pressure.ratio=uniform:0:0.4
sweep vaiont --samples 128 --seed 1 --method sobol --uncertain friction.angle_deg=normal:12:1 --csv d.csv
run none | schema --text"""


def answers() -> Iterator[tuple[str, Any]]:
    """Numbers and texts by a name, as the packages on the path give them."""
    from slipcircle import solve
    from slipcircle.__main__ import main
    from tests.support import ensembles, golden

    for name in golden.rows():
        motion = golden.solved(name)
        yield name, golden.numbers(motion, golden.times(motion))
    for name, scene in ensembles.SCENES.items():
        motion = solve(scene)
        yield f"lanes {name}", [getattr(motion.end, part).tolist() for part in golden.STATE]
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        for line in re.split(r" \| |\n", COMMANDS):
            printed = io.StringIO()
            with contextlib.redirect_stdout(printed), contextlib.redirect_stderr(io.StringIO()):
                status = main(line.split())
            yield line, [status, printed.getvalue().replace(folder, ".")]
        for path in sorted(Path(folder).glob("*.csv")):
            yield path.name, path.read_text("utf-8")


def differ(one: Any, other: Any) -> bool:
    """Whether two answers differ by more than rounding: their words, or numbers at the same place."""
    texts = [json.dumps(answer) for answer in (one, other)]
    if NUMBER.sub("#", texts[0]) != NUMBER.sub("#", texts[1]):
        return True
    first, second = ([float(number) for number in NUMBER.findall(text)] for text in texts)
    return not np.allclose(first, second, rtol=1e-8, atol=1e-11)


# --- faults ----------------------------------------------------------------------------------------------------------

OPERATORS: dict[type, type] = {ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult,
                               ast.Lt: ast.Gt, ast.Gt: ast.LtE, ast.LtE: ast.Lt, ast.GtE: ast.Lt, ast.Eq: ast.NotEq,
                               ast.NotEq: ast.Eq, ast.And: ast.Or, ast.Or: ast.And, ast.Is: ast.IsNot,
                               ast.IsNot: ast.Is, ast.In: ast.NotIn, ast.NotIn: ast.In}  # fmt: skip


class Fault(NamedTuple):
    path: str
    place: int  # among the module's changes
    lines: range
    words: str


def changes(tree: ast.AST) -> Iterator[tuple[ast.AST, str, Callable[[], None]]]:
    """Yield every fault that a tree can get: its node, its name, and the function that plants it."""
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
                effect = isinstance(line, ast.Expr) and id(line.value) not in texts
                guard = isinstance(line, ast.If) and not line.orelse
                if effect or guard or isinstance(line, ast.AugAssign | ast.Raise):
                    yield line, "missing", lambda b=body, k=k: b.__setitem__(k, ast.Pass())  # type: ignore[misc]


def faults() -> Iterator[Fault]:
    """Yield every fault of the packages, except in templates, which are parts of `generated`."""
    for path in sorted(path for package in PACKAGES for path in (ROOT / package).rglob("*.py")):
        found = [] if "templates" in path.parts else changes(ast.parse(path.read_text("utf-8")))
        for place, (node, kind, _) in enumerate(found):
            words = f"{kind}: {ast.unparse(node).partition(chr(10))[0][:70]}"
            lines = range(node.lineno, node.end_lineno + 1)  # type: ignore[attr-defined]
            yield Fault(str(path.relative_to(ROOT)), place, lines, words)


def planted(fault: Fault) -> str:
    tree = ast.parse((ROOT / fault.path).read_text("utf-8"))
    list(changes(tree))[fault.place][2]()
    return ast.unparse(ast.fix_missing_locations(tree))


# --- the work --------------------------------------------------------------------------------------------------------


def copied(folder: Path) -> Path:
    """Return a copy of the project, its compiled modules included."""
    ignored = shutil.ignore_patterns("__pycache__", ".git", ".venv", ".*_cache")
    return shutil.copytree(ROOT, folder, ignore=ignored)


def run(folder: Path, limit: float | None, *argv: str | Path) -> str | None:
    """Output of a Python in the copy, or else its errors; none if it hangs. All that it started is ended too."""
    env = os.environ | {"PYTHONPATH": str(folder), "PYTHONDONTWRITEBYTECODE": "1", "OMP_NUM_THREADS": "1"}
    limited = ["timeout", "-k", "1", str(limit)] if limit else []
    command = [*limited, sys.executable, *argv]
    done = subprocess.run(command, cwd=folder, env=env, capture_output=True, text=True, errors="replace", check=False)
    return None if limit and done.returncode in (124, 137) else done.stdout or done.stderr


def _last(printed: str | None) -> str:
    """Return the last line of an output."""
    return (printed or "").strip().rpartition("\n")[2]


def measured_tests(folder: Path, jobs: int) -> dict[str, Any]:
    """Seconds of each test, and the tests that reach each line ``path:line``; a fixture counts for all of its file."""
    ignored = [f"--ignore=tests/{name}.py" for name in NOT_OF_BEHAVIOUR]
    cover = [*(f"--cov={package}" for package in PACKAGES), "--cov-context=test", "--cov-report="]
    pytest = ("-m", "pytest", "-q", "-p", "no:cacheprovider", "-n", f"{jobs}", "--durations=0", "--durations-min=0.0")
    printed = run(folder, None, *pytest, *cover, *ignored, "tests") or ""
    print(_last(printed), file=sys.stderr)
    told = run(folder, None, "-m", "coverage", "json", "--show-contexts", "-o", "map.json")
    if not (folder / "map.json").exists():
        sys.exit(f"no test was measured: {_last(told) or _last(printed)}; is pytest-cov installed?")
    seconds: dict[str, float] = {}
    for duration, test in re.findall(r"^([\d.]+)s \w+ +(tests/\S+?)(?:\[.*)?$", printed, re.MULTILINE):
        seconds[test] = seconds.get(test, 0.0) + float(duration)
    reached: dict[str, list[str]] = {}
    for path, of_file in json.loads((folder / "map.json").read_text("utf-8"))["files"].items():
        for line, contexts in of_file["contexts"].items():
            tests = {re.split(r"[\[|]", context)[0] for context in contexts}
            fixtures = {context.partition("::")[0] for context in contexts if context.endswith("|setup")}
            tests |= {test for test in seconds if test.partition("::")[0] in fixtures}
            at_import = {AT_IMPORT} if "" in contexts else set()
            reached[f"{path}:{line}"] = sorted(tests & seconds.keys() | at_import)
    return {"seconds": seconds, "reached": reached}


def tests_near(fault: Fault, measured: dict[str, Any]) -> list[str]:
    """Return the tests that reach a fault, the quickest first; for what imports run, then all others.

    What `derive` keeps in caches counts for the first test that asks for it: all tests of the package follow.
    """
    seconds, reached = measured["seconds"], measured["reached"]
    package = fault.path.partition("/")[0]
    near = set().union(*(reached.get(f"{fault.path}:{line}", ()) for line in fault.lines))
    beside = set().union(*(tests for line, tests in reached.items() if line.startswith(f"{package}/")))
    if package == "derive":
        chosen = beside
    else:
        chosen = near if near and AT_IMPORT not in near else seconds.keys()
    return sorted(chosen - {AT_IMPORT}, key=lambda test: (test not in near, test not in beside, seconds[test]))


def judged(folder: Path, fault: Fault, measured: dict[str, Any], good: dict[str, Any]) -> str:
    """Return the verdict on a fault: the test that caught it, no changed answer, or SURVIVED."""
    near, target = tests_near(fault, measured), folder / fault.path
    begin = time.monotonic()
    try:
        target.write_text(planted(fault), "utf-8")
        hang = ("-o", f"faulthandler_timeout={HANG_S}", "-o", "faulthandler_exit_on_timeout=true")
        (folder / "chosen").write_text("\n".join(near), "utf-8")
        pytest = ("-m", "pytest", "-x", "-q", "-p", "no:cacheprovider", *hang, "@chosen")
        printed = run(folder, LIMIT_S, *pytest)
        took = f"{time.monotonic() - begin:.0f} s, {len(near)} tests"
        if printed is None:
            return f"not decided within the limit ({took})"
        if not re.search(r"^\d+ (passed|skipped)", printed, re.MULTILINE):
            red = re.search(r"^(?:FAILED|ERROR) (tests/[^\s\[]*)", printed, re.MULTILINE)
            return f"caught by {red[1] if red else 'a hang or crash'} ({took})"
        text = run(folder, LIMIT_S, "-m", "tests.campaigns.mutants", "--answers")
        found = json.loads(text) if text else {}
        changed = [name for name in good if name not in found or differ(good[name], found[name])]
        return f"SURVIVED, changes {changed[:4]} ({took})" if changed else f"survived, no answer changed ({took})"
    finally:
        shutil.copy(ROOT / fault.path, target)


def main() -> int:
    chosen = options(__doc__, 100, "--answers", jobs={"type": int, "default": 2},
                     map={"type": Path, "help": "lines that each test reaches; written if absent"})  # fmt: skip
    if chosen.answers:  # those of this tree, and nothing else
        print(json.dumps(dict(answers())))
        return 0
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(chosen.jobs) as pool:
        copies: Queue[Path] = Queue()
        for k in range(chosen.jobs):
            copies.put(first := copied(Path(folder) / f"{k}"))
        if chosen.map and chosen.map.exists():
            measured = json.loads(chosen.map.read_text("utf-8"))
        else:
            measured = measured_tests(first, chosen.jobs)
            of_files: dict[str, set[str]] = {}
            for line, tests in measured["reached"].items():
                of_files.setdefault(line.rpartition(":")[0], set()).update(tests)
            reach.write({file: tests - {AT_IMPORT} for file, tests in of_files.items()})
        if chosen.map:
            chosen.map.write_text(json.dumps(measured), "utf-8")
        good = json.loads(run(first, None, "-m", "tests.campaigns.mutants", "--answers") or "{}")
        places = list(faults())
        random.Random(chosen.seed).shuffle(places)

        def judged_in_a_copy(fault: Fault) -> str:
            copy = copies.get()
            try:
                verdict = judged(copy, fault, measured, good)
            finally:
                copies.put(copy)
            print(f"{fault.path}:{fault.lines[0]}: {fault.words}: {verdict}", flush=True)
            return verdict.partition(" ")[0]

        verdicts = list(pool.map(judged_in_a_copy, places[: chosen.count]))
    caught, survived = verdicts.count("caught"), verdicts.count("SURVIVED")
    print(f"{caught} caught, {survived} SURVIVED, {verdicts.count('survived,')} survive but change no answer")
    return int(caught < 0.9 * (caught + survived))


if __name__ == "__main__":
    sys.exit(main())
