"""Output files of commands: checked before the computation, and replaced only when complete."""

import csv
import io
import os
import tempfile
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import IO, Any

from slipcircle.base.errors import raise_all
from slipcircle.base.kinds import PathName, Texts, Values
from slipcircle.base.text import clean

_HTML, _CSV = (".html", ".htm", ".xhtml", ""), (".csv", ".txt", "")
ENDINGS = {"--report": _HTML, "--live": _HTML, "--csv": _CSV, "--fragility": _CSV, "--npz": (".npz", "")}
ENDINGS |= {"--write": (".toml", "")}
NEW = ("FILE", "--write")  # options of files that are never overwritten


def check_outputs(command: str, outputs: Mapping[str, str | Texts], inputs: Sequence[str] = ()) -> None:
    """Check that the output files of a command, by option, can be written and are not among its input files.

    Raises
    ------
    ValueError
        Lists every path that cannot be written, with the reason.
    """
    mistakes, taken = [], {os.path.realpath(path): "the scene file" for path in inputs}
    named = [(o, name) for o, paths in outputs.items() for name in ([paths] if isinstance(paths, str) else paths)]
    for option, name in named:
        path = Path(os.path.realpath(name))
        if _is_device(name):
            continue
        if fault := _fault(option, name, path, taken.get(str(path), "")):
            mistakes.append(f"{option} {name}: {fault}")
        taken[str(path)] = option
    raise_all(command, mistakes)


def _fault(option: str, name: str, path: Path, other: str) -> str:
    """Return the reason why an output file cannot be written, empty if it can.

    ``path`` is its real path, and ``other`` another file of the command with this path, if there is one.
    """
    suffix = path.suffix.lower()
    if path.is_dir() or not path.name or name.endswith(os.sep):
        return "is a folder; give a file's name"
    if not path.parent.is_dir():
        return f"there is no folder {Path(name).parent}"
    if not os.access(path.parent, os.W_OK):
        return "may not be written"
    if other:
        return f"would overwrite {other}"
    if option in NEW and os.path.lexists(name):
        return "is there already; give another name, or remove it first"
    if suffix not in ENDINGS.get(option, (suffix,)):
        return f"cannot be written in this format; give a name that ends in {ENDINGS[option][0]}"
    return ""


@contextmanager
def replacing(name: PathName) -> Iterator[IO[bytes]]:
    """Open a binary file for writing, which replaces an existing file only when complete; an error changes nothing.

    A link remains a link, and devices such as /dev/stdout are written to directly. An error of the system, such as a
    full disk, becomes a ValueError that names the file.
    """
    try:
        if _is_device(name):
            with open(name, "wb") as device:
                yield device
            return
        path = Path(os.path.realpath(name))
        with tempfile.NamedTemporaryFile(dir=path.parent, prefix=f".{path.name[:200]}.", delete=False) as file:
            try:
                yield file
                file.flush()
                os.fsync(file.fileno())
                file.close()
                umask = os.umask(0)
                os.umask(umask)
                os.chmod(file.name, 0o666 & ~umask)  # as any other file
                os.replace(file.name, path)
            except BaseException:
                os.unlink(file.name)
                raise
    except OSError as error:
        raise ValueError(f"{name}: cannot be written: {error.strerror}") from error


def write_file(name: PathName, content: bytes) -> None:
    """Write a file atomically, so that a reader sees either the old or the complete new content.

    Raises
    ------
    ValueError
        If the file cannot be written.
    """
    with replacing(name) as file:
        file.write(content)


def csv_table(head: Iterable[str], rows: Iterable[Iterable[Any]]) -> bytes:
    """Return head and rows of a table as the bytes of a CSV file, in full precision; None becomes an empty cell.

    A text that a spreadsheet would take for a formula begins with an apostrophe.
    """
    text = io.StringIO()
    out = csv.writer(text, lineterminator="\n")
    for row in (head, *rows):
        out.writerow([_cell(value) if isinstance(value, str) else value for value in row])
    return text.getvalue().encode()


def _cell(text: str) -> str:
    """Return a text as a cell of a table, protected against interpretation as a formula."""
    text = clean(text)
    try:
        float(text)
    except ValueError:
        return f"'{text}" if text.lstrip().startswith(("=", "+", "-", "@")) else text
    return text


def npz_content(named: Values) -> bytes:
    """Return arrays by name as the bytes of an NPZ file, which `numpy.load` reads."""
    import numpy as np

    content = io.BytesIO()
    np.savez(content, **named)
    return content.getvalue()


def _is_device(name: PathName) -> bool:
    """Return whether a path cannot be replaced, such as a pipe or /dev/stdout."""
    return os.path.exists(name) and not os.path.isfile(name) and not os.path.isdir(name)


def files_in(paths: Iterable[PathName]) -> Sequence[Path]:
    """Return the files, and all files in the folders (sorted), without repeated and hidden files."""
    files: dict[Path, None] = {}
    for path in map(Path, paths):
        inside = sorted(path.rglob("*")) if path.is_dir() else [path]
        hidden = [any(part.startswith(".") for part in file.relative_to(path).parts) for file in inside]
        files |= dict.fromkeys(file for file, is_hidden in zip(inside, hidden, strict=True) if not is_hidden)
    return [path for path in files if not path.is_dir()]
