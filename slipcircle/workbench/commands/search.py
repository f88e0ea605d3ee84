"""`slipcircle search`: the circle along which a slope fails first, and its factors of safety."""

import argparse
from functools import partial

from slipcircle.base.progress import say, track
from slipcircle.workbench.commands.common import add_files, add_units
from slipcircle.workbench.files.scenefile import critical_of_file, with_circle
from slipcircle.workbench.outputs import pictures, tables
from slipcircle.workbench.outputs.tables import Answer, Files, Part
from slipcircle.workbench.stability.factors import YIELD
from slipcircle.workbench.stability.stability import METHODS

SLOPE = "a scene that ships, by name, or the path of a TOML file with [ground] and soil"


def options(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("scenes", nargs="+", metavar="SLOPE", help=SLOPE)
    parser.add_argument("--method", choices=METHODS, help="method to minimise; default bishop")
    least = "what is least on the circle: the factor of safety, or the yield coefficient, the k_h that makes it slide"
    parser.add_argument("--least", choices=("factor", YIELD), default="factor", help=least)
    written = "a scene file of the motion along the circle, which must not exist yet"
    add_units(parser)
    add_files(parser, "the section, the circle and the factors over centres", write=written)


def run(options: argparse.Namespace) -> Answer:
    """Run the command."""
    for option, path in {"plot": next(iter(options.plot), ""), "write": options.write}.items():
        if path and len(options.scenes) > 1:
            raise ValueError(f"search: --{option} {path}: is for one slope; search them one by one")
    if options.least == YIELD and options.method:
        raise ValueError(f"search: --method {options.method}: k_y is by the paper's method; leave it out")
    method = YIELD if options.least == YIELD else options.method
    searched = [critical_of_file(name, method, say) for name in track(options.scenes, "slopes searched")]
    names, notes, circles, warnings = zip(*searched, strict=True)
    columns = [factors | circle for factors, circle in map(tables.stability_columns, circles)]
    note = "; ".join(f"{name}: {text}" for name, text in zip(names, notes, strict=True) if text)
    table = Part(["", *names], tables.beside(columns), note=note)
    records = [
        {"scene": name} | circle.record() | {"warnings": lines}
        for name, circle, lines in zip(names, circles, warnings, strict=True)
    ]
    lines = [f"{name}: {line}" for name, of_slope in zip(names, warnings, strict=True) for line in of_slope]
    made: Files = {
        "plot": partial(pictures.picture, "search", (names[0], circles[0])),
        "write": lambda path: with_circle(options.scenes[0], circles[0], path).encode(),
    }
    return Answer(lambda: records, [table], lines, made)
