"""Options shared by commands, checks before the computation, and error messages that name the scene."""

import argparse
from collections.abc import Callable
from typing import TypeVar

from slipcircle.base.inputerror import InputError
from slipcircle.base.text import PRINTED
from slipcircle.core import Scene
from slipcircle.workbench.common import files
from slipcircle.workbench.common.units import SYSTEMS
from slipcircle.workbench.files.scenefile import units_of_files
from slipcircle.workbench.files.shipped import find
from slipcircle.workbench.outputs.pictures.files import check_picture

T = TypeVar("T")
SCENE = "a scene that ships, by name (`slipcircle --help` lists them), or the path of a TOML file"
PICTURE_TYPES = "; .png, .svg, .pdf or .jpg"
REPORT = "a report for a reviewer, one HTML file"


def add_scene(parser: argparse.ArgumentParser) -> None:
    """Add the positional argument SCENE, one scene, to a parser."""
    parser.add_argument("scene", metavar="SCENE", help=SCENE)


def add_files(parser: argparse.ArgumentParser, picture: str, **tables: str) -> None:
    """Add options that name output files: ``--plot`` for a picture, and an option for each table by its name.

    Parameters
    ----------
    parser : argparse.ArgumentParser
    picture : str
        Subject of the picture, for the help text.
    **tables : str
        Content of each further file by the name of its option, for the help text.
    """
    parser.add_argument("--plot", metavar="FILE", action="append", default=[], help=f"draw {picture}{PICTURE_TYPES}")
    for name, content in tables.items():
        parser.add_argument(f"--{name}", metavar="FILE", help=f"write {content}")


def check_files(options: argparse.Namespace) -> None:
    """Raise ValueError before the computation if an output file cannot be written or a picture cannot be drawn."""
    values = vars(options)
    written = ("plot", "report", "csv", "npz", "live", "fragility", "write")
    outputs = {f"--{name}": values[name] for name in written if values.get(name)}
    scenes = values.get("scenes") or [name for name in [values.get("scene")] if name]
    files.check_outputs(options.command, outputs, [str(find(name)) for name in scenes])
    if "--plot" in outputs or "--report" in outputs:
        for path in options.plot or [""]:
            check_picture(options.command, path, len(scenes))


def add_units(parser: argparse.ArgumentParser) -> None:
    """Declare the option that selects the units of output."""
    units = "units of tables, pictures and reports, by default [output] units of the scene file, or SI"
    parser.add_argument("--units", type=str.upper, choices=SYSTEMS, help=units)


def choose_units(options: argparse.Namespace) -> None:
    """Select the units of output that the options give, or else the scene files.

    Another value of ``units`` is that of records and remains.
    """
    values = vars(options)
    scenes = values.get("scenes") or [name for name in [values.get("scene")] if name]
    system = (values.get("units") or "").upper()
    if system in SYSTEMS:
        options.units = None
    chosen = {system} & {*SYSTEMS} or units_of_files(scenes) or {"SI"}
    if len(chosen) > 1:
        raise ValueError(f"{options.command}: the scene files select different units of output; give --units SI or US")
    PRINTED.set(SYSTEMS[chosen.pop()])


def with_scene_context(scene: Scene, work: Callable[[Scene], T]) -> T:
    """Return ``work(scene)``; a ValueError is raised again with the scene's name and the key in its file."""
    try:
        return work(scene)
    except InputError as error:
        raise ValueError(error.worded(lambda name: {"end_time": "end_time_s"}.get(name, name), scene.name)) from error
    except ValueError as error:
        raise ValueError(f"{scene.name}: {error}") from error
