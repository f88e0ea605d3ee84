"""`slipcircle search`: the critical circle of slopes, or the factors of a circle that their files give."""

import argparse
from collections.abc import Callable
from functools import partial

from slipcircle.base import files
from slipcircle.files.scenefile import searched
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


def run(options: argparse.Namespace, say: Callable[[str], None]) -> list[Critical]:
    """Run the command, its progress told: the result for each slope, shown as a table unless JSON is asked for."""
    if options.plot and len(options.slopes) > 1:
        raise ValueError(f"search: --plot {options.plot[0]}: shows one slope; search them one by one")
    every = [searched(slope, options.method, say) for slope in options.slopes]
    names, results = [name for name, _, _ in every], [found for _, _, found in every]
    for path in options.plot:
        draw = partial(slopeplot.searched, results[0])
        files.write(path, pictures.render(draw, (9.0, 6.0), path))
    for name, found in zip(names, results, strict=True):
        if found.warning:
            say(f"{name}: {found.warning}")
    if not options.json:
        tables.show(["", *names], tables.beside([tables.stability_column(found) for found in results]),
                    caption="; ".join(f"{name}: {note}" for name, note, _ in every if note))  # fmt: skip
    return results
