"""Command line: `slipcircle run SCENE...`, `plan`, `sweep`, ..., also as `python -m slipcircle`.

The commands are modules of `slipcircle.workbench.commands`; this module runs them and prints their answers. Results are
printed to stdout, messages to stderr. `ABOUT` lists the exit statuses.
"""

import argparse
import os
import shlex
import sys
from collections.abc import Sequence
from contextvars import copy_context
from importlib import import_module
from io import StringIO
from textwrap import wrap
from threading import active_count
from typing import TYPE_CHECKING

import slipcircle
from slipcircle.base.loading import INTERRUPTED, allow_interrupts
from slipcircle.base.progress import announce, say_later
from slipcircle.workbench.commands import COMMANDS, GROUPS
from slipcircle.workbench.files.shipped import shipped

if TYPE_CHECKING:
    from slipcircle.workbench.outputs.tables import Answer

TO_TRY = """\
Try:
  slipcircle run vaiont                        solve a shipped slide
  slipcircle new slope.toml                    write a commented scene to edit
  slipcircle run slope.toml --live slope.html  solve it; the page shows the slide in a browser
`slipcircle --help` lists all commands and scenes.
"""
SILENT = 2.0  # s, at most
ABOUT = """\
Speed, run-out and time to rest of a mass that failed along a slip circle.

{}
shipped scenes:
  {}
  or your own TOML file: `slipcircle schema --text` explains its keys

exit status: 0 success, 1 invalid input, 2 invalid call, 130 interrupted
"""


def main(argv: Sequence[str] | None = None) -> int:
    """Run a command from its arguments, by default ``sys.argv[1:]``, and return its exit status."""
    argv = sys.argv[1:] if argv is None else argv
    if not argv:
        print(TO_TRY, end="")
        return 0
    options = argparse.Namespace()
    try:
        options = _parser(argv[0]).parse_args(argv)
        options.line = shlex.join(["slipcircle", *argv])
        copy_context().run(_answer, options)  # in which the units of output are selected
        if sys.stdout is not None:  # closed by the caller
            sys.stdout.flush()
    except OSError as error:
        _report_output_error(error)
    except MemoryError as error:
        announce(f"not enough memory: {error}")
    except (ValueError, ImportError) as error:
        announce(str(error))
    except KeyboardInterrupt:
        folder = getattr(options, "resume", None)
        kept = f"; finished blocks are in {folder}, and the same command continues from them" if folder else ""
        announce(f"interrupted{kept}", "\n")
        return INTERRUPTED
    else:
        return 0
    return 1


def command() -> None:
    """Run the command line and exit with its status.

    Long computations are announced. An interrupted process does not wait for threads that still compute.
    """
    sys.stderr = sys.stderr or StringIO()  # closed by the caller, which not every argparse expects
    computing = say_later(SILENT)
    allow_interrupts()
    status = main()
    computing.cancel()
    if status == INTERRUPTED and active_count() > 1:
        os._exit(status)
    sys.exit(status)


def _parser(called: str) -> argparse.ArgumentParser:
    """Return the parser of all commands; only the called command's module is imported, for its options."""
    groups = ""
    for title, commands in GROUPS.items():
        groups += "\n".join([f"{title}:", *(f"  {name:<13}{words}" for name, words in commands.items()), ""])
    names = "\n  ".join(wrap(", ".join(shipped()), 76, break_on_hyphens=False))
    parser = argparse.ArgumentParser(
        "slipcircle",
        usage="slipcircle COMMAND ...",
        description=ABOUT.format(groups, names),
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--version", action="version", version=f"slipcircle {slipcircle.__version__}")
    subparsers = parser.add_subparsers(
        prog="slipcircle", dest="command", required=True, metavar="COMMAND", help=argparse.SUPPRESS
    )
    for name, words in COMMANDS.items():
        added = subparsers.add_parser(name, description=f"{words[0].upper()}{words[1:]}.")
        if name == called:
            module = import_module(f"slipcircle.workbench.commands.{name}")
            added.add_argument("--json", action="store_true", help="for machines: JSON, in SI units and radians")
            module.options(added)
            added.set_defaults(run=module.run)
    return parser


def _answer(options: argparse.Namespace) -> None:
    """Run a command, write its files and print its answer."""
    from slipcircle.workbench.commands.common import check_files, choose_units

    check_files(options)
    choose_units(options)
    answer = options.run(options)
    _write(answer, options)
    _print(answer, options.json)


def _write(answer: "Answer", options: argparse.Namespace) -> None:
    """Write the files that the options name; the content of all files is complete before the first is written."""
    from slipcircle.workbench.common import files

    contents = {}
    for option, content in answer.files.items():
        named = getattr(options, option) or []
        for path in [named] if isinstance(named, str) else named:
            contents[path] = content(path)
    for path, written in contents.items():
        files.write_file(path, written)
        if options.command != "new" and os.path.isfile(path):
            announce(f"wrote {path}")


def _print(answer: "Answer", as_json: bool) -> None:
    """Print an answer as JSON, or as tables; its warnings are printed to stderr."""
    from slipcircle.workbench.common.quantities import json_text
    from slipcircle.workbench.outputs import tables

    if as_json:
        print(json_text(answer.record()))
        return
    for part in answer.parts:
        print(part) if isinstance(part, str) else tables.show(*part)
    for warning in answer.warnings:
        announce(warning)


def _report_output_error(error: OSError) -> None:
    """Report which output failed. A closed pipe, as after ``| head``, is not reported."""
    if error.filename is None and sys.stdout is sys.__stdout__ and sys.stdout is not None:
        # Otherwise the interpreter flushes it again at exit, and fails.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    if not isinstance(error, BrokenPipeError):
        announce(f"{error.filename or 'the output'}: {error.strerror or error}")


if __name__ == "__main__":
    command()
