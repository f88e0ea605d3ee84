"""`slipcircle schema`: the reference of scene files, as a JSON Schema for editors or as text for people."""

import argparse

from slipcircle.workbench.outputs.tables import Answer


def options(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.set_defaults(json=True)
    text = "for people; by default a JSON Schema, for editors"
    parser.add_argument("--text", dest="json", action="store_false", help=text)


def run(options: argparse.Namespace) -> Answer:
    """Run the command."""
    from slipcircle.workbench.files.schema import schema
    from slipcircle.workbench.outputs.guide import guide

    return Answer(schema, [guide()])
