"""`slipcircle search`: the critical circle of slopes, or the factors of a circle that their files give."""

import argparse

from slipcircle.files.scenefile import searched
from slipcircle.outputs import pictures
from slipcircle.outputs.tables import Answer, Part, beside, say, stability_column
from slipcircle.scene.stability import METHODS


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("slopes", nargs="+", metavar="SLOPE", help="a scene that ships, by name, or the path "
                        "of a TOML file with [ground] and soil")  # fmt: skip
    parser.add_argument("--method", choices=METHODS, help="whose least factor is looked for; default bishop")


def run(options: argparse.Namespace) -> Answer:
    """Run the command, its progress told."""
    if options.plot and len(options.slopes) > 1:
        raise ValueError(f"search: --plot {options.plot[0]}: shows one slope; search them one by one")
    names, notes, found = zip(*(searched(slope, options.method, say) for slope in options.slopes), strict=True)
    pictures.write(options.plot, "search", found[0])
    for name, circle in zip(names, found, strict=True):
        if circle.warning:
            say(f"{name}: {circle.warning}")
    note = "; ".join(f"{name}: {text}" for name, text in zip(names, notes, strict=True) if text)
    return Answer(
        lambda: [circle.record() for circle in found],
        [Part(["", *names], beside([stability_column(circle) for circle in found]), note=note)],
    )
