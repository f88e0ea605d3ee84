"""Command line: `slipcircle run SCENE...`, `plan`, `sweep`, `backanalyse`, ..., also as `python -m slipcircle`.

Results go to stdout, messages to stderr. Exit status: 0 done, 1 the input was refused, 2 a wrong call,
130 interrupted.
"""

import argparse
import json
import os
import shlex
import sys
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any

import slipcircle
from slipcircle import Motion, Scene, plan, solve
from slipcircle.inputs.scenefile import find, shipped
from slipcircle.outputs import files, tables

OBSERVED = (("runout", "m", "run-out along the arc"), ("peak-velocity", "m-s", "greatest velocity"),
            ("duration", "s", "time until it rested"))  # fmt: skip


def main(argv: Sequence[str] | None = None) -> int:
    """Run a command and return its exit status."""
    parser = argparse.ArgumentParser(prog="slipcircle", description=str(slipcircle.__doc__).partition("\n")[0])
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")
    which = f"one of {', '.join(shipped())}, or a TOML file"
    run = commands.add_parser("run", help="solve scenes and print their motion side by side")
    run.add_argument("scenes", nargs="+", metavar="SCENE", help=which)
    run.add_argument("--plot", metavar="FILE", help="draw section, motion and energy; .png, .svg, .pdf or .jpg")
    run.add_argument("--report", metavar="FILE", help="write a report for a reviewer, one HTML file")
    run.add_argument("--csv", metavar="FILE", help="write the motion over time, in SI units and full precision")
    planned = commands.add_parser("plan", help="how a scene will be solved, and what that costs")
    what = planned.add_mutually_exclusive_group(required=True)
    what.add_argument("scene", nargs="?", metavar="SCENE", help=which)
    what.add_argument("--all", action="store_true", help="operation counts of every combination of effects")
    planned.add_argument("--ladder", action="store_true", help="solve with the effects added one by one")
    swept = commands.add_parser("sweep", help="a scene on a grid of values, or for samples of its uncertain numbers")
    swept.add_argument("scene", metavar="SCENE", help=which)
    back = commands.add_parser("backanalyse", help="the friction, or another field, that explains an observed motion")
    back.add_argument("scene", metavar="SCENE", help=which)
    for option, unit, words in OBSERVED:
        back.add_argument(f"--{option}-{unit}", type=float, dest=option, metavar="X", help=f"observed {words}")
        back.add_argument(f"--sigma-{option}-{unit}", type=float, dest=f"sigma_{option}", metavar="X",
                          help="its standard error")  # fmt: skip
    back.add_argument("--field", default="friction", help="what is looked for: friction, cohesion...")
    commands.add_parser("schema", help="print the JSON Schema of scene files, for editors")
    cost = commands.add_parser("cost", help="measure here what each way to compute something costs, and its error")
    cost.add_argument("functions", nargs="*", metavar="NAME", help="a function or solver; by default all")
    cost.add_argument("--plot", metavar="FILE", help="draw error against time and error over alpha")
    cost.add_argument("--csv", metavar="FILE", help="write every row in full precision")
    info = commands.add_parser("info", help="versions and digests of what is installed")
    if "sweep" in (sys.argv[1:] if argv is None else argv):  # no other command needs what it loads
        from slipcircle.studies import sweep

        sweep.arguments(swept)
    for command in (run, planned, swept, back, cost, info):
        command.add_argument("--json", action="store_true", help="for machines: JSON, in SI units and radians")
    options = parser.parse_args(argv)
    options.line = shlex.join(["slipcircle", *(sys.argv[1:] if argv is None else argv)])
    try:
        chosen = {"run": _run, "plan": _plan, "sweep": _sweep, "backanalyse": _backanalyse, "schema": _schema,
                  "cost": _cost, "info": _info}  # fmt: skip
        chosen[options.command](options)
        if sys.stdout is not None:  # closed by the caller
            sys.stdout.flush()
    except OSError as error:
        if error.filename is None and sys.stdout is sys.__stdout__ and sys.stdout is not None:
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # or it is flushed again, and complains
        if isinstance(error, BrokenPipeError):  # the reader, such as head, has seen enough
            return 0
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
    files.check({f"--{kind}": path for kind, path in asked.items()}, [str(path) for path in paths])
    if options.plot or options.report:
        from slipcircle.outputs import pictures

        pictures.check(options.plot or "", len(paths))
    sources = [path.read_bytes() for path in paths] if options.report else []
    motions = [solve(Scene.load(name)) for name in options.scenes]
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
    rungs = chosen.ladder() if options.ladder else []
    if options.json:
        _print(tables.plan_record(chosen) | ({"ladder": [asdict(r) for r in rungs]} if options.ladder else {}))
    elif options.ladder:
        tables.show(tables.LADDER, tables.ladder_rows(rungs), title=chosen.scene.name)
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


def _backanalyse(options: argparse.Namespace) -> None:
    seen, given = {}, vars(options)
    for option, unit, _ in OBSERVED:
        value, sigma = given[option], given[f"sigma_{option}"]
        if value is None and sigma is not None:
            raise ValueError(f"--sigma-{option}-{unit}: needs --{option}-{unit}")
        seen[option.replace("-", "_")] = value if sigma is None else (value, sigma)
    found = slipcircle.backanalyse(Scene.load(options.scene), field=options.field, **seen)
    if options.json:
        _print(tables.backanalysis_record(found))
        return
    numbers = [f"solution {k}" for k in range(1, len(found.solutions) + 1)]
    head = numbers if len(numbers) > 1 else [found.motion.plan.scene.name]
    tables.show(["", *head], tables.backanalysis_rows(found), caption=f"by {found.method}")


def _schema(options: argparse.Namespace) -> None:
    from slipcircle.inputs.scenekeys import schema

    _print(schema())


def _cost(options: argparse.Namespace) -> None:
    from slipcircle.prices import cost, costtext

    found = cost.measure(options.functions or cost.NAMES, progress=sys.stderr)
    if options.csv:
        costtext.write_csv(found, options.csv)
    if options.plot:
        from slipcircle.prices.costplot import plot

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
    from slipcircle.info import facts

    found = facts()
    if options.json:
        _print(found)
    else:
        tables.show(["", ""], ([key, value] for key, value in found.items()))


if __name__ == "__main__":
    sys.exit(main())
