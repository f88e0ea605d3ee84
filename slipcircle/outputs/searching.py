"""`slipcircle search`: the critical circle of slopes, or the factors of a circle that their files give."""

import argparse
import sys
from functools import partial

from slipcircle.base import files
from slipcircle.files import slopefile
from slipcircle.files.scenefile import find
from slipcircle.outputs import pictures, slopeplot, tables
from slipcircle.scene.search import Critical
from slipcircle.scene.stability import METHODS


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("slopes", nargs="+", metavar="SLOPE", help="a scene that ships, by name, or the path "
                        "of a TOML file with [ground] and soil")  # fmt: skip
    parser.add_argument("--method", choices=METHODS, help="whose least factor is looked for; default bishop")
    parser.add_argument("--plot", metavar="FILE", action="append", default=[], help="draw the section, the circle and "
                        "the factors over centres; .png, .svg, .pdf or .jpg")  # fmt: skip


def found(file: slopefile.SlopeFile, method: str | None = None) -> Critical:
    """What is found of a slope's file, with its progress told."""
    try:
        return slopefile.judged(file, method, told=lambda line: say(f"{file.name}: {line}"))
    except ValueError as error:
        raise ValueError(f"{file.name}: {error}") from error


def say(line: str) -> None:
    """Progress, on stderr."""
    print(f"slipcircle: {line}", file=sys.stderr, flush=True)


def run(options: argparse.Namespace) -> list[Critical]:
    """Run the command: the result for each slope, shown as a table unless JSON is asked for."""
    if options.plot and len(options.slopes) > 1:
        raise ValueError(f"search: --plot {options.plot[0]}: shows one slope; search them one by one")
    read = [slopefile.read(find(name)) for name in options.slopes]
    results = [found(file, options.method) for file in read]
    for path in options.plot:
        draw = partial(slopeplot.searched, results[0])
        files.write(path, pictures.render(draw, (9.0, 6.0), path))
    for file, result in zip(read, results, strict=True):
        if result.warning:
            say(f"{file.name}: {result.warning}")
    if not options.json:
        columns = [tables.stability_column(found) for found in results]
        tables.show(["", *(f.name for f in read)], tables.beside(columns),
                    caption="; ".join(f"{f.name}: {f.note}" for f in read if f.note))  # fmt: skip
    return results
