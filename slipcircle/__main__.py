"""Command line: `slipcircle run SCENE...`, `schema`, `cost`, `info`, also as `python -m slipcircle`.

Results go to stdout, messages to stderr. Exit status: 0 done, 1 the input was refused, 2 a wrong call.
"""

import argparse
import json
import sys
from collections.abc import Iterable, Sequence
from dataclasses import asdict
from typing import Any

import numpy as np

import slipcircle
from slipcircle import Motion, Scene, solve
from slipcircle.friction import friction
from slipcircle.scenefile import shipped
from slipcircle.scenekeys import schema


def main(argv: Sequence[str] | None = None) -> int:
    """Run a command and return its exit status."""
    parser = argparse.ArgumentParser(prog="slipcircle", description=str(slipcircle.__doc__).partition("\n")[0])
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")
    run = commands.add_parser("run", help="solve scenes and print their motion side by side")
    run.add_argument("scenes", nargs="+", metavar="SCENE", help=f"one of {', '.join(shipped())}, or a TOML file")
    commands.add_parser("schema", help="print the JSON Schema of scene files, for editors")
    cost = commands.add_parser("cost", help="measure here what each way to compute a function costs, and its error")
    cost.add_argument("functions", nargs="*", metavar="FUNCTION", help="by default all")
    info = commands.add_parser("info", help="versions and digests of what is installed")
    for command in (run, cost, info):
        command.add_argument("--json", action="store_true", help="for machines: JSON, in SI units and radians")
    options = parser.parse_args(argv)
    try:
        {"run": _run, "schema": _schema, "cost": _cost, "info": _info}[options.command](options)
    except (ValueError, ImportError) as error:
        print(f"slipcircle: {error}", file=sys.stderr)
        return 1
    return 0


def _run(options: argparse.Namespace) -> None:
    scenes = [Scene.load(name) for name in options.scenes]
    motions = [solve(scene) for scene in scenes]
    if options.json:
        found = [motion_record(m) for m in motions]
        print(json.dumps(found[0] if len(found) == 1 else found, indent=2))
        return
    alike = len({m.duration for m in motions}) == 1
    rows = zip(*(_column(m, alike) for m in motions), strict=True)
    table(
        ["", *(m.plan.scene.name for m in motions)],
        ([column[0][0], *(cell for _, cell in column)] for column in rows),
        caption="; ".join(f"{m.plan.scene.name}: {m.plan.scene.note}" for m in motions),
    )


def _schema(options: argparse.Namespace) -> None:
    print(json.dumps(schema(), indent=2))


def _column(motion: Motion, alike: bool) -> list[tuple[str, str]]:
    """The table of one motion: label and value of each row; labels name times if all motions last alike."""
    arc, law = motion.plan.scene.arc, friction(motion.plan.scene.friction)
    d, mu = arc.dimensionless, float(law.coefficient(0.0))
    shared = [
        ("Theta*", f"{d.moment_of_inertia:.5f}"), ("J_r", f"{d.radial_weight:.5f}"),
        ("J_theta", f"{d.weight_moment:.5f}"), ("lambda", f"{d.resistance_factor:.5f}"),
        ("A", f"{d.dynamic_coefficient:.5f}"),
        ("method", motion.plan.method + ("" if "rotation" in motion.plan.effects else ", frozen geometry")),
        ("effects", ", ".join(motion.plan.effects) or "none"),
        ("left out", ", ".join(motion.plan.left_out) or "none"),
        ("friction angle", f"{np.degrees(np.arctan(mu)):.2f} deg" + ("" if law.constant else f" at first, {law.law}")),
        ("limit friction angle", f"{np.degrees(np.arctan(motion.limit_friction)):.2f} deg"),
        ("normal stress at start", f"{arc.static_normal_stress / 1e6:.3f} MPa"),
        ("moves", "yes" if motion.moves else "no"),
        ("duration", f"{motion.duration:.2f} s"),
    ]  # fmt: skip
    times = {"1/3": 1 / 3 * motion.duration, "2/3": 2 / 3 * motion.duration}
    states = [(f"after {t:.4g} s" if alike else f"after {part}", motion.at(t)) for part, t in times.items()]
    for label, state in [*states, ("at the end", motion.end)]:
        shared += [
            (f"velocity {label}", f"{state.velocity:.2f} m/s"),
            (f"displacement {label}", f"{state.displacement:.1f} m"),
            (f"rotation {label}", f"{np.degrees(state.rotation):.2f} deg"),
        ]
    return [
        *shared,
        ("peak velocity", f"{motion.peak.velocity:.2f} m/s"),
        ("comes to rest", "yes" if motion.arrested else "no, still moving at the end"),
    ]


def motion_record(motion: Motion) -> dict[str, Any]:
    """A motion as JSON holds it: SI units, radians, full precision."""
    scene, law = motion.plan.scene, friction(motion.plan.scene.friction)
    return {
        "scene": scene.name,
        "note": scene.note,
        "effects": list(motion.plan.effects),
        "left_out": list(motion.plan.left_out),
        "method": motion.plan.method,
        "friction": float(law.coefficient(0.0)) if law.constant else {"law": law.law} | dict(law.parameters),
        "limit_friction": motion.limit_friction,
        "dimensionless": {k: float(v) for k, v in asdict(scene.arc.dimensionless).items()},
        "moves": motion.moves,
        "arrested": motion.arrested,
        "duration": motion.duration,
        "run_out": motion.run_out,
        "peak": {k: float(v) for k, v in asdict(motion.peak).items()},
        "end": {k: float(v) for k, v in asdict(motion.end).items()},
        "energy": asdict(motion.energy) | {"residual": motion.energy.residual},
    }


def _cost(options: argparse.Namespace) -> None:
    from slipcircle import cost

    found = cost.measure(options.functions or list(cost.FUNCTIONS), progress=sys.stderr)
    if options.json:
        # JSON knows no infinity: the error of a way that fails somewhere is null.
        rows = [asdict(row) | {"error": row.error if np.isfinite(row.error) else None} for row in found]
        print(json.dumps({"machine": cost.machine(), "rows": rows}, indent=2))
        return
    for name in dict.fromkeys(row.function for row in found):
        table(cost.COLUMNS, cost.cells([row for row in found if row.function == name]), title=name)
    print(f"{cost.machine()}.\nbeaten: by that way, which is at least as accurate and over {cost.BEATEN} times faster.")


def _info(options: argparse.Namespace) -> None:
    from slipcircle.info import facts

    found = facts()
    if options.json:
        print(json.dumps(found, indent=2))
        return
    table(["", ""], ([key, value] for key, value in found.items()))


def table(head: Sequence[str], rows: Iterable[Sequence[str]], title: str = "", caption: str = "") -> None:
    """Print a table on stdout, at most 100 columns wide; plain text where stdout is no terminal."""
    try:
        from rich.console import Console
        from rich.table import Table
    except ImportError as error:
        raise ImportError("tables need rich: pip install 'slipcircle[scenes]', or ask for --json") from error
    shown = Table(
        *head, title=title or None, title_justify="left", title_style="bold", caption=caption or None,
        caption_justify="left", caption_style="", box=_box(), show_header=any(head),
    )  # fmt: skip
    for row in rows:
        shown.add_row(*row)
    console = Console(highlight=False)
    console.width = min(console.width, 100) if console.is_terminal else 100
    console.print(shown)


def _box() -> Any:
    from rich import box

    return box.SIMPLE_HEAD


if __name__ == "__main__":
    sys.exit(main())
