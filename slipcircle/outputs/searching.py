"""`slipcircle search`: the critical circle of slopes, or the factors of a circle that their files give."""

import argparse
import sys
from typing import Any

from slipcircle.base import files
from slipcircle.files import slopefile
from slipcircle.files.scenefile import find
from slipcircle.outputs import pictures, tables
from slipcircle.scene.search import Critical, at_circle, critical
from slipcircle.scene.stability import METHODS

_NAMES = {"paper": "the paper's method (mean normal stress)", "ordinary": "the ordinary method (Fellenius)",
          "bishop": "Bishop's simplified method"}  # fmt: skip


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("slopes", nargs="+", metavar="SLOPE", help="a scene that ships, by name, or the path "
                        "of a TOML file with [ground] and soil")  # fmt: skip
    parser.add_argument("--method", choices=METHODS, help="whose least factor is looked for; default bishop")
    parser.add_argument("--plot", metavar="FILE", help="draw the section, the circle and the factors over centres; "
                        ".png, .svg, .pdf or .jpg")  # fmt: skip


def found(file: slopefile.SlopeFile, method: str | None = None) -> Critical:
    """The critical circle of a slope's file; where it gives a circle, the factors of that one."""
    chosen = method or file.method
    if file.section is not None:
        return at_circle(file.slope, file.section, chosen)
    try:
        return critical(file.slope, chosen, **file.limits, told=lambda line: say(f"{file.name}: {line}"))
    except ValueError as error:
        raise ValueError(f"{file.name}: {error}") from error


def say(line: str) -> None:
    """Progress, on stderr."""
    print(f"slipcircle: {line}", file=sys.stderr, flush=True)


def run(options: argparse.Namespace) -> list[Critical]:
    """Run the command: the result for each slope, shown as a table unless JSON is asked for."""
    if options.plot:
        files.check("search", {"--plot": options.plot}, options.slopes)
        pictures.check("search", options.plot, 1 if len(options.slopes) == 1 else 10**6)
    read = [slopefile.read(find(name)) for name in options.slopes]
    results = [found(file, options.method) for file in read]
    if options.plot:
        from slipcircle.outputs import slopeplot  # asks for Matplotlib

        def draw(figure: Any) -> None:
            slopeplot.searched(read[0].slope, results[0], figure)

        files.write(options.plot, pictures.render(draw, (9.0, 6.0), options.plot))
    for file, result in zip(read, results, strict=True):
        if result.warning:
            say(f"{file.name}: {result.warning}")
    if not options.json:
        tables.show(["", *(f.name for f in read)], _rows(results),
                    caption="; ".join(f"{f.name}: {f.note}" for f in read if f.note))  # fmt: skip
    return results


def _column(found: Critical) -> list[tuple[str, str]]:
    """What is said of one slope: words and value."""

    def point(xy: tuple[float, float]) -> str:
        return f"{xy[0]:.4g}, {xy[1]:.4g} m"

    factors = [(f"factor of safety by {_NAMES[m]}", "refused" if v is None else f"{v:.4f}")
               for m, v in found.factor_of_safety.items()]  # fmt: skip
    searched = found.tried > 1
    return [
        *factors,
        ("circle", f"least factor by {found.method}" if searched else "as given"),
        ("centre", point(found.centre)), ("radius", f"{found.radius:.4g} m"),
        ("entry", point(found.entry)), ("exit", point(found.exit)),
        ("slides to the", {1: "right", -1: "left"}.get(found.facing, "neither side: nothing drives it")),
        ("circles tried, refused", f"{found.tried}, {found.refused}"),
        ("arc under negative normal stress", f"{100 * found.negative:.1f} %"),
    ]  # fmt: skip


def _rows(results: list[Critical]) -> Any:
    """Of a table with a column for each slope."""
    return ([cells[0][0], *(value for _, value in cells)] for cells in zip(*map(_column, results), strict=True))
