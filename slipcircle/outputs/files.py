"""Files that a command writes: checked before the work begins, and never seen half written."""

import os
from collections.abc import Mapping, Sequence
from pathlib import Path

from slipcircle.checks import raise_all


def check(command: str, outputs: Mapping[str, str], inputs: Sequence[str] = ()) -> None:
    """See that files can be written.

    Parameters
    ----------
    command : str
        Whose options they are.
    outputs : mapping
        Paths by the option that names them.
    inputs : sequence of str
        Paths that are read and must not be written over.

    Raises
    ------
    ValueError
        Lists every path that cannot be written, and why.
    """
    found, taken = [], {os.path.realpath(path): "the scene file" for path in inputs}
    for option, name in outputs.items():
        path = Path(os.path.realpath(name))
        if _is_device(name):
            continue
        if path.is_dir() or not path.name or name.endswith(os.sep):
            found.append(f"{option} {name}: is a folder; give a file's name")
        elif not path.parent.is_dir():
            found.append(f"{option} {name}: there is no folder {Path(name).parent}")
        elif not os.access(path.parent, os.W_OK):
            found.append(f"{option} {name}: may not be written")
        elif str(path) in taken:
            found.append(f"{option} {name}: would overwrite {taken[str(path)]}")
        taken[str(path)] = option
    raise_all(command, found)


def write(name: str, content: bytes) -> None:
    """Write a file whole: a reader sees what was there before, or all of this.

    Raises
    ------
    ValueError
        If that fails.
    """
    path = Path(os.path.realpath(name))  # so that a link stays one
    part = path.with_name(f".{path.name[:200]}.{os.getpid()}.part")
    try:
        if _is_device(name):
            Path(name).write_bytes(content)
            return
        try:
            part.write_bytes(content)
            os.replace(part, path)
        finally:
            part.unlink(missing_ok=True)
    except OSError as error:
        raise ValueError(f"{name}: cannot be written: {error.strerror}") from error


def _is_device(name: str) -> bool:
    """Whether it is no file that could be replaced, such as a pipe or /dev/stdout."""
    return os.path.exists(name) and not os.path.isfile(name) and not os.path.isdir(name)
