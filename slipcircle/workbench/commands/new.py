"""`slipcircle new`: a commented scene file to start from."""

import argparse
import re
from pathlib import Path

from slipcircle.base import SCENE_FORMAT
from slipcircle.workbench.common import files
from slipcircle.workbench.files.shipped import find, shipped
from slipcircle.workbench.outputs.tables import Answer


def options(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("file", metavar="FILE", help="to write, such as slope.toml; is never overwritten")
    like = "the scene that ships to start from, by default real-slope; `slipcircle --help` lists them"
    parser.add_argument("--like", metavar="SCENE", default="real-slope", choices=shipped(), help=like)


def run(options: argparse.Namespace) -> Answer:
    """Run the command."""
    path = Path(options.file)
    files.check("new", {"FILE": options.file})
    text = find(options.like).read_text("utf-8")
    # It is named as its file from now on.
    scene = re.sub("^name = .*", f'format = "{SCENE_FORMAT}"', text, flags=re.MULTILINE)
    steps = f"wrote {path}: change its numbers, then `slipcircle run {path} --live {path.with_suffix('.html')}`"
    explained = "`slipcircle schema --text` explains every key and what else may be added"
    return Answer(lambda: {"file": options.file}, [steps, explained], (), {"file": lambda _: scene.encode()})
