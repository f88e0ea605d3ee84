"""`slipcircle search`: the critical circle of a slope and its factors of safety."""

import argparse
from functools import partial

from slipcircle.base.progress import announce, tracked
from slipcircle.workbench.commands.common import add_files, add_units
from slipcircle.workbench.files.scenefile import critical_of_file, with_circle
from slipcircle.workbench.outputs import tables
from slipcircle.workbench.outputs.pictures.files import picture
from slipcircle.workbench.outputs.tables import Answer, Files, ResultTable
from slipcircle.workbench.stability.factors import YIELD
from slipcircle.workbench.stability.stability import METHODS

SLOPE = "the name of a shipped scene, or the path of a TOML file with [ground] and soil"


def options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command to a parser."""
    parser.add_argument("scenes", nargs="+", metavar="SLOPE", help=SLOPE)
    parser.add_argument("--method", choices=METHODS, help="method to minimise; default bishop")
    least = "quantity to minimise: the factor of safety, or the yield coefficient, the k_h at which the mass slides"
    parser.add_argument("--least", choices=("factor", YIELD), default="factor", help=least)
    written = "a new scene file of the motion along the circle"
    add_units(parser)
    add_files(parser, "the section, the circle and the factors over centres", write=written)


def run(options: argparse.Namespace) -> Answer:
    """Run the command and return its answer."""
    for option, path in {"plot": next(iter(options.plot), ""), "write": options.write}.items():
        if path and len(options.scenes) > 1:
            raise ValueError(f"search: --{option} {path}: takes one slope; search the slopes in separate calls")
    if options.least == YIELD and options.method:
        raise ValueError(
            f"search: --method {options.method}: k_y is computed by the paper's method; leave --method out"
        )
    method = YIELD if options.least == YIELD else options.method
    searched = [critical_of_file(name, method, announce) for name in tracked(options.scenes, "slopes searched")]
    names, notes, circles, warnings = zip(*searched, strict=True)
    columns = [factors | circle for factors, circle in map(tables.stability_columns, circles)]
    note = "; ".join(f"{name}: {text}" for name, text in zip(names, notes, strict=True) if text)
    table = ResultTable(["", *names], tables.beside(columns), note=note)
    records = [
        {"scene": name} | circle.record() | {"warnings": lines}
        for name, circle, lines in zip(names, circles, warnings, strict=True)
    ]
    lines = [f"{name}: {line}" for name, of_slope in zip(names, warnings, strict=True) for line in of_slope]
    made: Files = {
        "plot": partial(picture, "search", (names[0], circles[0])),
        "write": lambda path: with_circle(options.scenes[0], circles[0], path).encode(),
    }
    return Answer(lambda: records, [table], lines, made)
