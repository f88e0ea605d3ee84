"""`slipcircle cost`: cost and accuracy of all methods, measured on this machine."""

import argparse
import sys
from functools import partial

from slipcircle.workbench.commands.common import add_files
from slipcircle.workbench.common import files
from slipcircle.workbench.outputs import pictures
from slipcircle.workbench.outputs.tables import Answer

HELP = "measure here what each way to compute something costs, and its error"


def options(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("functions", nargs="*", metavar="NAME", help="a function or solver; by default all")
    add_files(parser, "error against time and error over alpha", csv="every row in full precision")


def run(options: argparse.Namespace) -> Answer:
    """Run the command."""
    from slipcircle.workbench.cost import cost, costplot, costtext
    from slipcircle.workbench.outputs.info import machine

    rows = cost.measure(options.functions or cost.NAMES, partial(print, file=sys.stderr, flush=True))
    if options.csv:
        files.write(options.csv, costtext.table_csv(rows))
    for path in options.plot:
        files.write(path, pictures.render(partial(costplot.overview, rows), costplot.size(rows), path))
    measured_on = machine()
    records = [costtext.record(row) for row in rows]
    return Answer(lambda: {"machine": measured_on, "rows": records}, costtext.parts(rows, measured_on))
