"""Command line: `slipcircle run SCENE...`, `plan`, `sweep`, `backanalyse`, ..., also as `python -m slipcircle`.

Results go to stdout, messages to stderr; the exit status is what `EPILOG` says.
"""

import argparse
import json
import os
import re
import shlex
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import asdict
from functools import partial
from importlib import import_module
from textwrap import wrap
from threading import Event, Thread, active_count
from typing import Any, TypeVar

import numpy as np

import slipcircle
from slipcircle import Motion, Scene, load, plan, solve
from slipcircle.base import files
from slipcircle.files.scenefile import find, shipped
from slipcircle.motion.quantities import OUTCOMES, plain, record, shown, words
from slipcircle.outputs import tables
from slipcircle.scene.varied import other_way

T = TypeVar("T")
MOST_TIMES = 1_000_000
SILENT = 5.0  # s, at most
INTERRUPTED = 130
EPILOG = """\
scenes that ship:
  {}
  or a TOML file of your own: `slipcircle schema --text` explains its keys

exit status: 0 done, 1 the input was refused, 2 a wrong call, 130 interrupted
"""


def main(argv: Sequence[str] | None = None) -> int:
    """Run a command and return its exit status."""
    argv = sys.argv[1:] if argv is None else argv
    options = _parser(argv).parse_args(argv)
    options.line = shlex.join(["slipcircle", *argv])
    try:
        _ready(options)
        options.work(options)
        if sys.stdout is not None:  # closed by the caller
            sys.stdout.flush()
    except OSError as error:
        if error.filename is None and sys.stdout is sys.__stdout__ and sys.stdout is not None:
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # or it is flushed again, and complains
        if not isinstance(error, BrokenPipeError):  # nobody reads on, as with `| head`
            _say(f"{error.filename or 'the output'}: {error.strerror or error}")
        return 1
    except MemoryError as error:
        _say(f"not enough memory: {error}")
        return 1
    except (ValueError, ImportError) as error:
        _say(str(error))
        return 1
    except KeyboardInterrupt:
        resume = getattr(options, "resume", None)
        kept = f"; finished blocks are in {resume}, and the same command continues from them" if resume else ""
        print(file=sys.stderr)
        _say(f"interrupted{kept}")
        return INTERRUPTED
    return 0


def command() -> None:
    """What the shell calls: it is heard from, and interrupted it waits for no thread that still computes."""
    with _heard(SILENT):
        status = main()
    if status == INTERRUPTED and active_count() > 1:
        os._exit(status)
    sys.exit(status)


@contextmanager
def _heard(seconds: float) -> Iterator[None]:
    """Tell that the work goes on: on one line of a terminal, elsewhere on lines ever farther apart."""
    done, began = Event(), time.monotonic()
    terminal = sys.stderr is not None and sys.stderr.isatty()
    before, after, rarer = ("\r\x1b[K", "\r", 1.0) if terminal else ("", "\n", 2.0)

    def tell(wait: float = seconds) -> None:
        while not done.wait(wait):
            said = f"slipcircle: at work for {time.monotonic() - began:.0f} s; Ctrl-C ends it"
            print(f"{before}{said}", end=after, file=sys.stderr, flush=True)
            wait *= rarer

    Thread(target=tell, daemon=True).start()
    try:
        yield
    finally:
        done.set()


def _say(message: str) -> None:
    print(f"slipcircle: {tables.clean(message)}", file=sys.stderr)


def _parser(argv: Sequence[str]) -> argparse.ArgumentParser:
    """Every command with its options."""
    names = "\n  ".join(wrap(", ".join(shipped()), 76, break_on_hyphens=False))
    parser = argparse.ArgumentParser(
        "slipcircle",
        description="\n".join(wrap(str(slipcircle.__doc__).partition("\n")[0], 78)),
        epilog=EPILOG.format(names),
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--version", action="version", version=f"slipcircle {slipcircle.__version__}")
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND", title="commands")
    which = "a scene that ships, by name (`slipcircle --help` lists them), or the path of a TOML file"

    def command(name: str, work: Callable[[argparse.Namespace], None], said: str) -> argparse.ArgumentParser:
        added = commands.add_parser(name, help=said, description=f"{said[0].upper()}{said[1:]}.")
        added.set_defaults(work=work)
        if name != "schema":
            added.add_argument("--json", action="store_true", help="for machines: JSON, in SI units and radians")
        return added

    def plot(parser: argparse.ArgumentParser, what: str, more: str = "") -> None:
        parser.add_argument("--plot", metavar="FILE", action="append", default=[],
                            help=f"draw {what}; .png, .svg, .pdf or .jpg{more}")  # fmt: skip

    run = command("run", _run, "solve scenes and print their motion side by side")
    run.add_argument("scenes", nargs="+", metavar="SCENE", help=which)
    run.add_argument("--verbose", action="store_true", help="all numbers, the arc's coefficients too")
    plot(run, "section, motion and energy", ", and the slide itself as .gif; may be given more than once")
    run.add_argument("--polarities", action="store_true", help="each shaken scene also with its horizontal shaking "
                     "turned around, and the mean of both")  # fmt: skip
    run.add_argument("--report", metavar="FILE", help="write a report for a reviewer, one HTML file")
    run.add_argument("--csv", metavar="FILE", help="write the motion over time, in SI units and full precision")
    run.add_argument("--times", type=_times, metavar="FROM:TO:STEP", help="times of --csv in s, by default 401 even "
                     "ones from start to end: 0:60:1")  # fmt: skip
    planned = command("plan", _plan, "how a scene will be solved, and what that costs")
    what = planned.add_mutually_exclusive_group(required=True)
    what.add_argument("scene", nargs="?", metavar="SCENE", help=which)
    what.add_argument("--all", action="store_true", help="operation counts of every combination of effects")
    planned.add_argument("--ladder", action="store_true", help="solve with the effects added one by one")
    plot(planned, "the ladder")
    swept = command("sweep", _sweep, "a scene on a grid of values, or for samples of its uncertain numbers")
    swept.add_argument("scene", metavar="SCENE", help=which)
    searched = command("search", _search, "the critical circle of a slope, and its factors of safety by three methods")
    back = command("backanalyse", _backanalyse, "the friction, or another number, that explains an observed motion")
    back.add_argument("scene", metavar="SCENE", help=which)
    plot(back, "what was observed over the fields")
    for one, module in ((swept, "sweep"), (searched, "searching"), (back, "backanalysing")):
        if one.prog.split()[-1] in argv:  # no other command needs what it loads
            import_module(f"slipcircle.outputs.{module}").arguments(one)
    slopes = command("sensitivity", _sensitivity, "exact derivatives of the motion by each number of a scene")
    slopes.add_argument("scene", metavar="SCENE", help=which)
    plot(slopes, "what a change of each number changes")
    schema = command("schema", _schema, "what a scene file may say: every effect, law, key and unit")
    schema.add_argument("--text", action="store_true", help="for people; by default a JSON Schema, for editors")
    cost = command("cost", _cost, "measure here what each way to compute something costs, and its error")
    cost.add_argument("functions", nargs="*", metavar="NAME", help="a function or solver; by default all")
    plot(cost, "error against time and error over alpha")
    cost.add_argument("--csv", metavar="FILE", help="write every row in full precision")
    command("info", _info, "versions and digests of what is installed")
    return parser


def _print(found: Any) -> None:
    print(json.dumps(plain(found), indent=2, allow_nan=False))


def _ready(options: argparse.Namespace) -> None:
    """See that all files of a command can be written and its pictures drawn, before the work."""
    asked = {f"--{k}": path for k in ("plot", "report", "csv", "npz") if (path := getattr(options, k, None))}
    given = vars(options)
    names = given.get("scenes") or given.get("slopes") or [name for name in [given.get("scene")] if name]
    files.check(options.command, asked, [str(find(name)) for name in names])
    if "--plot" in asked or "--report" in asked:
        from slipcircle.outputs import pictures

        for path in options.plot or [""]:
            pictures.check(options.command, path, len(given.get("scenes", names[:1])))


def _draw(paths: Sequence[str], what: str, found: Any) -> None:
    for path in paths:
        from slipcircle.outputs import pictures

        files.write(path, getattr(pictures, what)(found, path))


# --- run and plan ----------------------------------------------------------------------------------------------------


def _run(options: argparse.Namespace) -> None:
    paths = [find(name) for name in options.scenes]
    if options.times is not None and not options.csv:
        raise ValueError("run: --times: are the rows of a CSV file; give --csv FILE as well")
    sources = [path.read_bytes() for path in paths] if options.report else []
    scenes = [load(name) for name in options.scenes]
    if options.polarities:
        scenes = [way for scene in scenes for way in (scene, other_way(scene))]
        sources = [source for source in sources for _ in range(2)]
    motions = [_speaking_of(scene, solve) for scene in scenes]
    made: dict[str, bytes] = {}  # all before the first is written
    if options.csv:
        from slipcircle.outputs.trace import csv

        made[options.csv] = csv(motions, options.times)
    for path in options.plot:
        from slipcircle.outputs import pictures

        made[path] = pictures.overview(motions, path)
    if options.report:
        from slipcircle.outputs.report import report

        made[options.report] = report(motions, sources, options.line).encode()
    for path, content in made.items():
        files.write(path, content)
    means = _means(motions) if options.polarities else {}
    if options.json:
        _print([*(record(m) for m in motions), *({"scene": name} | mean for name, mean in means.items())])
        return
    columns = [tables.motion_column(m, options.verbose) for m in motions]
    columns += [{q.label: f"{shown(mean[n])} {q.unit}" for n, q in OUTCOMES.items()} for mean in means.values()]
    tables.show(
        ["", *(m.plan.scene.name for m in motions), *means],
        tables.beside(columns),
        caption="; ".join(f"{m.plan.scene.name}: {m.plan.scene.note}" for m in motions if m.plan.scene.note),
    )
    for m in motions:
        drawn = [u.key for u in m.plan.scene.uncertain.values()]
        more = [f"solved at the median of {', '.join(drawn)}; sweep draws them"] if drawn else []
        for warning in (*m.warnings, *more):
            _say(f"{m.plan.scene.name}: {warning}")


def _means(motions: Sequence[Motion]) -> dict[str, dict[str, float]]:
    """Outcomes of both polarities, their sizes' mean, by a name of each pair."""
    pairs = zip(motions[::2], motions[1::2], strict=True)
    return {
        f"{one.plan.scene.name} mean": {
            n: (abs(float(one.outcomes[n])) + abs(float(other.outcomes[n]))) / 2 for n in OUTCOMES
        } for one, other in pairs
    }  # fmt: skip


def _speaking_of(scene: Scene, work: Callable[[Scene], T]) -> T:
    """What the work makes of a scene; an error says of which, and names the key of its file."""
    try:
        return work(scene)
    except ValueError as error:
        raise ValueError(f"{scene.name}: {re.sub('end_time(?!_)', 'end_time_s', str(error))}") from error


def _times(text: str) -> Any:
    """0:60:1 as times from 0 to 60 s."""
    try:
        first, last, step = map(float, text.split(":"))
        count = np.floor((last - first) / step * (1 + 1e-12)) + 1
        if not (0.0 <= first <= last and 0.0 < step and count <= MOST_TIMES):
            raise ValueError
    except (ValueError, ZeroDivisionError):
        said = f"{text}: must be FROM:TO:STEP in s, such as 0:60:1, at most {MOST_TIMES} times"
        raise argparse.ArgumentTypeError(said) from None
    return first + step * np.arange(int(count))


def _plan(options: argparse.Namespace) -> None:
    if options.all:
        rows = tables.combination_rows()
        if options.json:
            _print([dict(zip(tables.COMBINATIONS, row, strict=True)) for row in rows])
        else:
            tables.show(tables.COMBINATIONS, rows)
        return
    if options.plot and not options.ladder:
        raise ValueError("plan: --plot: draws the ladder; give --ladder as well")
    chosen = plan(load(options.scene))
    if options.ladder:
        from slipcircle.studies.ladder import ladder

        rungs = _speaking_of(chosen.scene, ladder)
        _draw(options.plot, "ladder", rungs)
    if options.json:
        _print([tables.plan_record(chosen) | ({"ladder": [asdict(r) for r in rungs]} if options.ladder else {})])
    elif options.ladder:
        tables.show(tables.LADDER, tables.ladder_rows(rungs), chosen.scene.name)
    else:
        tables.show(["", chosen.scene.name], tables.plan_rows(chosen))


# --- studies ---------------------------------------------------------------------------------------------------------


def _sweep(options: argparse.Namespace) -> None:
    from slipcircle.outputs import sweep

    found = sweep.run(options)
    if options.json:
        _print([sweep.record(found)])
        return
    sweep.show(found)
    for warning in found.warnings:
        _say(f"{found.scene.name}: {warning}")


def _search(options: argparse.Namespace) -> None:
    from slipcircle.outputs import searching

    found = searching.run(options, _say)
    if options.json:
        _print([f.record() for f in found])


def _backanalyse(options: argparse.Namespace) -> None:
    from slipcircle.outputs import backanalysing

    found = backanalysing.run(options)
    _draw(options.plot, "backanalysis", found)
    if options.json:
        _print([backanalysing.record(found)])
        return
    backanalysing.show(found)
    for warning in found.warnings:
        _say(f"{found.motion.plan.scene.name}: {warning}")


def _sensitivity(options: argparse.Namespace) -> None:
    motion = solve(load(options.scene))
    found, name = motion.sensitivity(), motion.plan.scene.name
    _draw(options.plot, "sensitivity", found)
    if options.json:
        _print([{"scene": name} | tables.sensitivity_record(found)])
        return
    tables.show(
        ["by", "value", *(words(n, unit) for n, unit in found.outputs.items())], tables.sensitivity_rows(found), name,
        "change per unit of the key, and in brackets in per cent per per cent of it",
    )  # fmt: skip
    for warning in found.warnings:
        _say(f"{name}: {warning}")


# --- about itself ----------------------------------------------------------------------------------------------------


def _schema(options: argparse.Namespace) -> None:
    if options.text:
        from slipcircle.outputs.guide import guide

        print(guide())
        return
    from slipcircle.files.scenekeys import schema

    _print(schema())


def _cost(options: argparse.Namespace) -> None:
    from slipcircle.cost import cost, costtext
    from slipcircle.outputs.info import machine

    found = cost.measure(options.functions or cost.NAMES, progress=sys.stderr)
    if options.csv:
        files.write(options.csv, costtext.table_csv(found))
    for path in options.plot:
        from slipcircle.cost import costplot
        from slipcircle.outputs import pictures

        files.write(path, pictures.render(partial(costplot.overview, found), costplot.size(found), path))
    if options.json:
        _print({"machine": machine(), "rows": [costtext.record(row) for row in found]})
        return
    for name in dict.fromkeys(row.function for row in found):
        rows = [row for row in found if row.function == name]
        tables.show(*costtext.table(rows), title=name)
        print(costtext.verdict(rows) + "\n")
    print(costtext.wrapped([*costtext.NOTES, f"{machine()}."]))


def _info(options: argparse.Namespace) -> None:
    from slipcircle.outputs.info import facts

    found = facts()
    if options.json:
        _print(found)
    else:
        tables.show(["", ""], list(found.items()))


if __name__ == "__main__":
    command()
