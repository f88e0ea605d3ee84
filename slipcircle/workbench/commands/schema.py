"""`slipcircle schema`: reference of scene files, as a JSON Schema for editors or as text."""

import argparse

from slipcircle.workbench.outputs.tables import Answer


def options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command to a parser."""
    parser.set_defaults(json=True)
    text = "print readable text; default: a JSON Schema, for editors"
    parser.add_argument("--text", dest="json", action="store_false", help=text)


def run(options: argparse.Namespace) -> Answer:
    """Run the command and return its answer."""
    from slipcircle.workbench.files.schema import schema
    from slipcircle.workbench.outputs.guide import guide

    return Answer(schema, [guide()])
