"""Handler for Ctrl-C while the command loads modules: it prints one line and exits with status 130."""

import os
import signal
import sys

INTERRUPTED = 130  # exit status
_COMMANDS = ("-m", "slipcircle")  # how Python names them


def _end(*_: object) -> None:
    """Print that the command was interrupted and exit with status 130."""
    os.write(2, b"\nslipcircle: interrupted\n")
    os._exit(INTERRUPTED)


def allow_interrupts() -> None:
    """Let Ctrl-C raise `KeyboardInterrupt` again, after the modules of the command are loaded."""
    if signal.getsignal(signal.SIGINT) is _end:
        signal.signal(signal.SIGINT, signal.default_int_handler)


_is_command = os.path.basename(sys.argv[0]) in _COMMANDS
_is_default = signal.getsignal(signal.SIGINT) is signal.default_int_handler
if _is_command and _is_default:
    signal.signal(signal.SIGINT, _end)
