"""`slipcircle info`: what is installed, for a report of a problem."""

import argparse

from slipcircle.workbench.outputs.info import facts
from slipcircle.workbench.outputs.tables import Answer, Part

HELP = "versions and digests of what is installed"


def options(_: argparse.ArgumentParser) -> None:
    """Declare no options."""


def run(_: argparse.Namespace) -> Answer:
    """Run the command."""
    rows = facts()
    return Answer(lambda: rows, [Part([], list(rows.items()))])
