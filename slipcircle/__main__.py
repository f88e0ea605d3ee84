"""Command line: `slipcircle run SCENE...`, `plan`, `sweep`, `backanalyse`, ..., also as `python -m slipcircle`.

Results go to stdout, messages to stderr; the exit status is what `EPILOG` says.
"""

import argparse
import json
import os
import re
import shlex
import sys
from collections.abc import Callable, Sequence
from dataclasses import asdict
from pathlib import Path
from textwrap import wrap
from typing import Any, TypeVar

import slipcircle
from slipcircle import Motion, Scene, solve
from slipcircle.base import files
from slipcircle.files.scenefile import find, shipped
from slipcircle.outputs import tables
from slipcircle.scene import plan

T = TypeVar("T")
OBSERVED = (("runout", "m", "run-out along the arc"), ("peak-velocity", "m-s", "greatest velocity"),
            ("duration", "s", "time until it rested"))  # fmt: skip
EPILOG = """\
scenes that ship:
  {}
  or a TOML file of your own: `slipcircle schema --text` explains its keys

exit status: 0 done, 1 the input was refused, 2 a wrong call, 130 interrupted
"""


def main(argv: Sequence[str] | None = None) -> int:
    """Run a command and return its exit status."""
    names = "\n  ".join(wrap(", ".join(shipped()), 76, break_on_hyphens=False))
    parser = argparse.ArgumentParser(
        "slipcircle",
        description="\n".join(wrap(str(slipcircle.__doc__).partition("\n")[0], 78)),
        epilog=EPILOG.format(names),
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND", title="commands")
    which = "a scene that ships, by name (`slipcircle --help` lists them), or the path of a TOML file"

    def command(name: str, words: str) -> argparse.ArgumentParser:
        return commands.add_parser(name, help=words, description=f"{words[0].upper()}{words[1:]}.")

    run = command("run", "solve scenes and print their motion side by side")
    run.add_argument("scenes", nargs="+", metavar="SCENE", help=which)
    run.add_argument("--plot", metavar="FILE", help="draw section, motion and energy; .png, .svg, .pdf or .jpg, and "
                     "the slide itself as .gif")  # fmt: skip
    run.add_argument("--report", metavar="FILE", help="write a report for a reviewer, one HTML file")
    run.add_argument("--csv", metavar="FILE", help="write the motion over time, in SI units and full precision")
    planned = command("plan", "how a scene will be solved, and what that costs")
    what = planned.add_mutually_exclusive_group(required=True)
    what.add_argument("scene", nargs="?", metavar="SCENE", help=which)
    what.add_argument("--all", action="store_true", help="operation counts of every combination of effects")
    planned.add_argument("--ladder", action="store_true", help="solve with the effects added one by one")
    swept = command("sweep", "a scene on a grid of values, or for samples of its uncertain numbers")
    swept.add_argument("scene", metavar="SCENE", help=which)
    back = command("backanalyse", "the friction, or another field, that explains an observed motion")
    back.add_argument("scene", metavar="SCENE", help=which)
    for option, unit, words in OBSERVED:
        back.add_argument(f"--{option}-{unit}", type=_observed, dest=option.replace("-", "_"), metavar="X[+-S]",
                          help=f"observed {words}, and its standard error: 400+-20")  # fmt: skip
    back.add_argument("--field", action="append", metavar="NAME[=LOW:HIGH]", help="what is looked for, by default "
                      "friction, and between which values, in SI units; several for several observations")  # fmt: skip
    slopes = command("sensitivity", "exact derivatives of the motion by each number of a scene")
    slopes.add_argument("scene", metavar="SCENE", help=which)
    schema = command("schema", "what a scene file may say: every effect, law, key and unit")
    schema.add_argument("--text", action="store_true", help="for people; by default a JSON Schema, for editors")
    cost = command("cost", "measure here what each way to compute something costs, and its error")
    cost.add_argument("functions", nargs="*", metavar="NAME", help="a function or solver; by default all")
    cost.add_argument("--plot", metavar="FILE", help="draw error against time and error over alpha")
    cost.add_argument("--csv", metavar="FILE", help="write every row in full precision")
    info = command("info", "versions and digests of what is installed")
    if "sweep" in (sys.argv[1:] if argv is None else argv):  # no other command needs what it loads
        from slipcircle.studies import sweep

        sweep.arguments(swept)
    for parsed in (run, planned, swept, back, slopes, cost, info):
        parsed.add_argument("--json", action="store_true", help="for machines: JSON, in SI units and radians")
    options = parser.parse_args(argv)
    options.line = shlex.join(["slipcircle", *(sys.argv[1:] if argv is None else argv)])
    try:
        chosen = {"run": _run, "plan": _plan, "sweep": _sweep, "backanalyse": _backanalyse,
                  "sensitivity": _sensitivity, "schema": _schema, "cost": _cost, "info": _info}  # fmt: skip
        chosen[options.command](options)
        if sys.stdout is not None:  # closed by the caller
            sys.stdout.flush()
    except OSError as error:
        if error.filename is None and sys.stdout is sys.__stdout__ and sys.stdout is not None:
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # or it is flushed again, and complains
        if not isinstance(error, BrokenPipeError):  # nobody reads on, as with `| head`
            print(f"slipcircle: {error.filename or 'the output'}: {error.strerror or error}", file=sys.stderr)
        return 1
    except MemoryError as error:
        print(f"slipcircle: not enough memory: {error}", file=sys.stderr)
        return 1
    except (ValueError, ImportError) as error:
        print(f"slipcircle: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        resume = getattr(options, "resume", None)
        kept = f"; finished blocks are in {resume}, and the same command continues from them" if resume else ""
        print(f"\nslipcircle: interrupted{kept}", file=sys.stderr)
        return 130
    return 0


def _print(record: Any) -> None:
    print(json.dumps(record, indent=2, allow_nan=False))


def _run(options: argparse.Namespace) -> None:
    paths = [find(name) for name in options.scenes]
    asked = {kind: path for kind in ("plot", "report", "csv") if (path := getattr(options, kind)) is not None}
    files.check("run", {f"--{kind}": path for kind, path in asked.items()}, [str(path) for path in paths])
    if options.plot or options.report:
        from slipcircle.outputs import pictures

        pictures.check("run", options.plot or "", len(paths))
    sources = [path.read_bytes() for path in paths] if options.report else []
    motions = [_speaking_of(Scene.load(name), solve) for name in options.scenes]
    for path, content in [(path, _content(kind, path, motions, sources, options)) for kind, path in asked.items()]:
        files.write(path, content)
    if options.json:
        found = [tables.motion_record(m) for m in motions]
        _print(found[0] if len(found) == 1 else found)
        return
    alike = len({m.duration for m in motions}) == 1
    rows = zip(*(tables.motion_column(m, alike) for m in motions), strict=True)
    tables.show(
        ["", *(m.plan.scene.name for m in motions)],
        ([column[0][0], *(cell for _, cell in column)] for column in rows),
        caption="; ".join(f"{m.plan.scene.name}: {m.plan.scene.note}" for m in motions),
    )
    for m in motions:
        drawn = [u.key for u in m.plan.scene.uncertain.values()]
        more = [f"solved at the median of {', '.join(drawn)}; sweep draws them"] if drawn else []
        for warning in (*m.warnings, *more):
            print(f"slipcircle: {m.plan.scene.name}: {warning}", file=sys.stderr)


def _speaking_of(scene: Scene, work: Callable[[Scene], T]) -> T:
    """What the work makes of a scene; an error says of which, and names the key of its file."""
    try:
        return work(scene)
    except ValueError as error:
        raise ValueError(f"{scene.name}: {re.sub('end_time(?!_)', 'end_time_s', str(error))}") from error


def _content(kind: str, path: str, motions: list[Motion], sources: list[bytes], options: argparse.Namespace) -> bytes:
    """A file that `run` writes."""
    if kind == "csv":
        from slipcircle.outputs.trace import csv

        return csv(motions).encode()
    if kind == "plot":
        from slipcircle.outputs.pictures import overview

        return overview(motions, Path(path).suffix[1:].lower())
    from slipcircle.outputs.report import report

    return report(motions, sources, options.line).encode()


def _plan(options: argparse.Namespace) -> None:
    if options.all:
        rows = tables.combination_rows()
        if options.json:
            _print([dict(zip(tables.ALL, row, strict=True)) for row in rows])
        else:
            tables.show(tables.ALL, rows, title="Floating-point operations of each combination of effects")
        return
    chosen = plan(Scene.load(options.scene))
    rungs = _speaking_of(chosen.scene, lambda _: chosen.ladder()) if options.ladder else []
    if options.json:
        _print(tables.plan_record(chosen) | ({"ladder": [asdict(r) for r in rungs]} if options.ladder else {}))
    elif options.ladder:
        tables.show(tables.LADDER, tables.ladder_rows(rungs), title=chosen.scene.name, tight=True)
    else:
        tables.show(["", chosen.scene.name], tables.plan_rows(chosen))


def _sweep(options: argparse.Namespace) -> None:
    from slipcircle.studies import sweep

    found = sweep.run(options)
    if options.json:
        _print(sweep.record(found))
        return
    sweep.show(found)
    for warning in found.warnings:
        print(f"slipcircle: {found.scene.name}: {warning}", file=sys.stderr)


def _observed(text: str) -> float | tuple[float, float]:
    """400, or 400+-20."""
    value, *error = text.replace("\N{PLUS-MINUS SIGN}", "+-").split("+-")
    if not error:
        return float(value)
    (sigma,) = error
    return float(value), float(sigma)


def _backanalyse(options: argparse.Namespace) -> None:
    fields, bounds = [], {}
    for text in options.field or ["friction"]:
        name, given, between = text.partition("=")
        fields.append(name)
        if given:
            try:
                low, high = map(float, between.split(":"))
            except ValueError:
                raise ValueError(f"--field {text}: must be NAME or NAME=LOW:HIGH, such as friction=0.1:0.3") from None
            bounds[name] = low, high
    seen = {option.replace("-", "_"): vars(options)[option.replace("-", "_")] for option, _, _ in OBSERVED}
    if all(value is None for value in seen.values()):
        options_ = [f"--{option}-{unit}" for option, unit, _ in OBSERVED]
        raise ValueError(f"backanalyse: nothing observed: give one of {', '.join(options_)}")
    found = slipcircle.backanalyse(Scene.load(options.scene), field=fields, bounds=bounds, **seen)
    if options.json:
        _print(tables.backanalysis_record(found))
        return
    numbers = [f"solution {k}" for k in range(1, len(found.solutions) + 1)]
    head = numbers if len(numbers) > 1 else [found.motion.plan.scene.name]
    tables.show(["", *head], tables.backanalysis_rows(found), caption=f"by {found.method}")
    for warning in found.warnings:
        print(f"slipcircle: {found.motion.plan.scene.name}: {warning}", file=sys.stderr)


def _sensitivity(options: argparse.Namespace) -> None:
    motion = solve(Scene.load(options.scene))
    found, name = motion.sensitivity(), motion.plan.scene.name
    if options.json:
        _print({"scene": name} | tables.sensitivity_record(found))
        return
    tables.show(
        ["by", "value", *(tables.words(n, unit) for n, unit in found.outputs.items())],
        [["", "", *(f"{found.at[n]:.6g}" for n in found.outputs)], *tables.sensitivity_rows(found)],
        name, "change per unit of the key, and in brackets in per cent per per cent of it",
    )  # fmt: skip
    if not motion.moves:
        print(f"slipcircle: {name}: does not move, so that small changes change nothing", file=sys.stderr)


def _schema(options: argparse.Namespace) -> None:
    if options.text:
        from slipcircle.outputs.guide import guide

        print(guide())
        return
    from slipcircle.files.scenekeys import schema

    _print(schema())


def _cost(options: argparse.Namespace) -> None:
    from slipcircle.cost import cost, costtext

    found = cost.measure(options.functions or cost.NAMES, progress=sys.stderr)
    if options.csv:
        costtext.write_csv(found, options.csv)
    if options.plot:
        from slipcircle.cost.costplot import plot

        plot(found, options.plot)
    if options.json:
        _print({"machine": costtext.machine(), "rows": [costtext.record(row) for row in found]})
        return
    for name in dict.fromkeys(row.function for row in found):
        rows = [row for row in found if row.function == name]
        tables.show(*costtext.table(rows), title=name, tight=True)
        print(costtext.verdict(rows) + "\n")
    print(costtext.wrapped([*costtext.NOTES, f"{costtext.machine()}."]))


def _info(options: argparse.Namespace) -> None:
    from slipcircle.outputs.info import facts

    found = facts()
    if options.json:
        _print(found)
    else:
        tables.show(["", ""], ([key, value] for key, value in found.items()))


if __name__ == "__main__":
    sys.exit(main())
