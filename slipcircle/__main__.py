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
from typing import TypeVar

import slipcircle
from slipcircle import Motion, Scene, load, plan, solve
from slipcircle.base.text import shown
from slipcircle.workbench.common import files
from slipcircle.workbench.common.quantities import OUTCOMES, plain, record
from slipcircle.workbench.files.scenefile import critical_of_file, find, shipped
from slipcircle.workbench.files.variation import other_way
from slipcircle.workbench.outputs import pictures, tables
from slipcircle.workbench.outputs.options import times
from slipcircle.workbench.outputs.tables import Answer, Part, say
from slipcircle.workbench.outputs.trace import csv
from slipcircle.workbench.stability.stability import METHODS

T = TypeVar("T")
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
        _tell(options.work(options), options.json)
        if sys.stdout is not None:  # closed by the caller
            sys.stdout.flush()
    except OSError as error:
        if error.filename is None and sys.stdout is sys.__stdout__ and sys.stdout is not None:
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # or it is flushed again, and complains
        if not isinstance(error, BrokenPipeError):  # nobody reads on, as with `| head`
            say(f"{error.filename or 'the output'}: {error.strerror or error}")
        return 1
    except MemoryError as error:
        say(f"not enough memory: {error}")
        return 1
    except (ValueError, ImportError) as error:
        say(str(error))
        return 1
    except KeyboardInterrupt:
        resume = getattr(options, "resume", None)
        kept = f"; finished blocks are in {resume}, and the same command continues from them" if resume else ""
        print(file=sys.stderr)
        say(f"interrupted{kept}")
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


def _tell(found: Answer, as_json: bool) -> None:
    if as_json:
        print(json.dumps(plain(found.record()), indent=2, allow_nan=False))
        return
    for part in found.parts:
        print(part) if isinstance(part, str) else tables.show(*part)
    for warning in found.warnings:
        say(warning)


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

    def command(name: str, work: Callable[[argparse.Namespace], Answer] | None, said: str) -> argparse.ArgumentParser:
        added = commands.add_parser(name, help=said, description=f"{said[0].upper()}{said[1:]}.")
        added.set_defaults(work=work)
        if name != "schema":
            added.add_argument("--json", action="store_true", help="for machines: JSON, in SI units and radians")
        return added

    def study(name: str, said: str) -> argparse.ArgumentParser:
        added = command(name, None, said)
        if name in argv:  # no other command needs what it loads
            loaded = import_module(f"slipcircle.workbench.outputs.{name}")
            loaded.arguments(added)
            added.set_defaults(work=loaded.run)
        return added

    def writes(parser: argparse.ArgumentParser, drawn: str, **more: str) -> None:
        parser.add_argument("--plot", metavar="FILE", action="append", default=[], help=f"draw {drawn}")
        for name, what in more.items():
            parser.add_argument(f"--{name}", metavar="FILE", help=f"write {what}")

    pictured, reviewed = "; .png, .svg, .pdf or .jpg", "a report for a reviewer, one HTML file"
    run = command("run", _run, "solve scenes and print their motion side by side")
    run.add_argument("scenes", nargs="+", metavar="SCENE", help=which)
    run.add_argument("--verbose", action="store_true", help="all numbers, the arc's coefficients too")
    run.add_argument(
        "--polarities",
        action="store_true",
        help="each shaken scene also with its horizontal shaking turned around, and the mean of both",
    )
    writes(
        run,
        f"section, motion and energy{pictured}, and the slide itself as .gif; may be given more than once",
        report=reviewed,
        csv="the motion over time, in SI units and full precision",
    )
    run.add_argument(
        "--times",
        type=times,
        metavar="FROM:TO:STEP",
        help="times of --csv in s, by default 401 even ones from start to end: 0:60:1",
    )
    planned = command("plan", _plan, "how a scene will be solved, and what that costs")
    what = planned.add_mutually_exclusive_group(required=True)
    what.add_argument("scene", nargs="?", metavar="SCENE", help=which)
    what.add_argument("--all", action="store_true", help="operation counts of every combination of effects")
    planned.add_argument("--ladder", action="store_true", help="solve with the effects added one by one")
    writes(planned, f"the ladder{pictured}")
    swept = study("sweep", "a scene on a grid of values, or for samples of its uncertain numbers")
    writes(
        swept,
        f"exceedance curves and which unknown matters, or a grid of one or two numbers{pictured}",
        report=reviewed,
        csv="one table of all results",
        npz="all results as NumPy arrays, the samples where kept",
    )
    slope = command("search", _search, "the critical circle of a slope, and its factors of safety by three methods")
    slope.add_argument(
        "scenes",
        nargs="+",
        metavar="SLOPE",
        help="a scene that ships, by name, or the path of a TOML file with [ground] and soil",
    )
    slope.add_argument("--method", choices=METHODS, help="whose least factor is looked for; default bishop")
    writes(slope, f"the section, the circle and the factors over centres{pictured}")
    back = study("backanalyse", "the friction, or another number, that explains an observed motion")
    writes(back, f"what was observed over the fields{pictured}")
    slopes = command("sensitivity", _sensitivity, "exact derivatives of the motion by each number of a scene")
    writes(slopes, f"what a change of each number changes{pictured}")
    for one in (swept, back, slopes):
        one.add_argument("scene", metavar="SCENE", help=which)
    schema = command("schema", _schema, "what a scene file may say: every effect, law, key and unit")
    schema.add_argument(
        "--text", dest="json", action="store_false", help="for people; by default a JSON Schema, for editors"
    )
    cost = command("cost", _cost, "measure here what each way to compute something costs, and its error")
    cost.add_argument("functions", nargs="*", metavar="NAME", help="a function or solver; by default all")
    writes(cost, f"error against time and error over alpha{pictured}", csv="every row in full precision")
    command("info", _info, "versions and digests of what is installed")
    return parser


def _ready(options: argparse.Namespace) -> None:
    """See that all files of a command can be written and its pictures drawn, before the work."""
    asked = {f"--{k}": path for k in ("plot", "report", "csv", "npz") if (path := getattr(options, k, None))}
    given = vars(options)
    names = given.get("scenes") or [name for name in [given.get("scene")] if name]
    files.check(options.command, asked, [str(find(name)) for name in names])
    if "--plot" in asked or "--report" in asked:
        for path in options.plot or [""]:
            pictures.check(options.command, path, len(names))


# --- run and plan ----------------------------------------------------------------------------------------------------


def _run(options: argparse.Namespace) -> Answer:
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
        made[options.csv] = csv(motions, options.times)
    for path in options.plot:
        made[path] = pictures.picture("motions", motions, path)
    if options.report:
        from slipcircle.workbench.outputs.report import report

        made[options.report] = report(motions, sources, options.line).encode()
    for path, content in made.items():
        files.write(path, content)
    pairs = zip(motions[::2], motions[1::2], strict=True) if options.polarities else ()
    means = {  # of the outcomes' sizes
        f"{one.plan.scene.name} mean": {n: (abs(one.outcomes[n]) + abs(other.outcomes[n])) / 2 for n in OUTCOMES}
        for one, other in pairs
    }
    columns = [tables.motion_column(m, options.verbose) for m in motions]
    columns += [{q.label: f"{shown(mean[n])} {q.unit}" for n, q in OUTCOMES.items()} for mean in means.values()]
    note = "; ".join(f"{s.name}: {s.note}" for s in scenes if s.note)
    return Answer(
        lambda: [*map(record, motions), *({"scene": name} | mean for name, mean in means.items())],
        [Part(["", *(s.name for s in scenes), *means], tables.beside(columns), note=note)],
        _warnings(motions),
    )


def _warnings(motions: Sequence[Motion]) -> Iterator[str]:
    for m in motions:
        scene = m.plan.scene
        drawn = ", ".join(u.key for u in scene.uncertain.values())
        more = [f"solved at the median of {drawn}; sweep draws them"] if drawn else []
        yield from (f"{scene.name}: {warning}" for warning in (*m.warnings, *more))


def _speaking_of(scene: Scene, work: Callable[[Scene], T]) -> T:
    """What the work makes of a scene; an error says of which, and names the key of its file."""
    try:
        return work(scene)
    except ValueError as error:
        raise ValueError(f"{scene.name}: {re.sub('end_time(?!_)', 'end_time_s', str(error))}") from error


def _plan(options: argparse.Namespace) -> Answer:
    if options.all:
        every = tables.combinations_part()
        return Answer(lambda: [dict(zip(every.head, row, strict=True)) for row in every.rows], [every])
    if options.plot and not options.ladder:
        raise ValueError("plan: --plot: draws the ladder; give --ladder as well")
    chosen = plan(load(options.scene))
    found = vars(chosen) | {"scene": chosen.scene.name}
    if not options.ladder:
        return Answer(lambda: [found], [tables.plan_part(chosen)])
    from slipcircle.workbench.studies.ladder import ladder

    rungs = _speaking_of(chosen.scene, ladder)
    pictures.write(options.plot, "ladder", rungs)
    return Answer(
        lambda: [found | {"ladder": [asdict(r) for r in rungs]}], [tables.ladder_part(rungs, chosen.scene.name)]
    )


def _search(options: argparse.Namespace) -> Answer:
    if options.plot and len(options.scenes) > 1:
        raise ValueError(f"search: --plot {options.plot[0]}: shows one slope; search them one by one")
    names, notes, found = zip(*(critical_of_file(name, options.method, say) for name in options.scenes), strict=True)
    pictures.write(options.plot, "search", found[0])
    for name, circle in zip(names, found, strict=True):
        if circle.warning:
            say(f"{name}: {circle.warning}")
    columns = [tables.stability_column(circle) for circle in found]
    note = "; ".join(f"{name}: {text}" for name, text in zip(names, notes, strict=True) if text)
    return Answer(
        lambda: [circle.record() for circle in found], [Part(["", *names], tables.beside(columns), note=note)]
    )


# --- about a scene, and about itself ---------------------------------------------------------------------------------


def _sensitivity(options: argparse.Namespace) -> Answer:
    motion = solve(load(options.scene))
    found, name = motion.sensitivity(), motion.plan.scene.name
    keys = {n: number.key for n, number in found.keys.items()}
    pictures.write(options.plot, "sensitivity", found)
    return Answer(
        lambda: [{"scene": name} | vars(found) | {"keys": keys, "elasticities": found.elasticities}],
        [tables.sensitivity_part(found, name)],
        [f"{name}: {warning}" for warning in found.warnings],
    )


def _schema(_: argparse.Namespace) -> Answer:
    from slipcircle.workbench.files.keys import schema
    from slipcircle.workbench.outputs.guide import guide

    return Answer(schema, [guide()])


def _cost(options: argparse.Namespace) -> Answer:
    from slipcircle.workbench.cost import cost, costplot, costtext
    from slipcircle.workbench.outputs.info import machine

    found = cost.measure(options.functions or cost.NAMES, partial(print, file=sys.stderr, flush=True))
    if options.csv:
        files.write(options.csv, costtext.table_csv(found))
    for path in options.plot:
        files.write(path, pictures.render(partial(costplot.overview, found), costplot.size(found), path))
    beside = machine()
    return Answer(
        lambda: {"machine": beside, "rows": [costtext.record(row) for row in found]}, costtext.parts(found, beside)
    )


def _info(_: argparse.Namespace) -> Answer:
    from slipcircle.workbench.outputs.info import facts

    found = facts()
    return Answer(lambda: found, [Part([], list(found.items()))])


if __name__ == "__main__":
    command()
