"""`slipcircle new`: write a commented scene file to start from."""

import argparse
import re
from pathlib import Path

from slipcircle.base import SCENE_FORMAT
from slipcircle.workbench.common import files
from slipcircle.workbench.files.shipped import find, shipped
from slipcircle.workbench.outputs.tables import Answer


def options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command to a parser."""
    parser.add_argument(
        "file", metavar="FILE", help="new scene file, such as slope.toml; an existing file is not overwritten"
    )
    like = "shipped scene to copy (default real-slope); `slipcircle --help` lists them"
    parser.add_argument("--like", metavar="SCENE", default="real-slope", choices=shipped(), help=like)


def run(options: argparse.Namespace) -> Answer:
    """Run the command and return its answer."""
    path = Path(options.file)
    files.check_outputs("new", {"FILE": options.file})
    text = find(options.like).read_text("utf-8")
    # Without a name of its own, the scene is named after its file.
    scene = re.sub("^name = .*", f'format = "{SCENE_FORMAT}"', text, flags=re.MULTILINE)
    steps = f"wrote {path}: change its numbers, then `slipcircle run {path} --live {path.with_suffix('.html')}`"
    explained = "`slipcircle schema --text` explains all keys, including those that the file does not use"
    return Answer(lambda: {"file": options.file}, [steps, explained], (), {"file": lambda _: scene.encode()})
