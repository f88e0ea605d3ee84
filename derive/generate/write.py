"""Files of `generated`: their text, written atomically or compared with the present files."""

import difflib
import os
import re
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path

from sympy import Expr, __version__

from derive.algebra import integrate
from derive.approximate import certificates, shapes
from derive.approximate.programs import parts_of_ends, variants, variants_of_ends
from derive.check.ends import LIMIT
from derive.check.proof import ProofError
from derive.check.records import Record, promised, read_records
from derive.code import emit
from derive.declare.quantities import QUOTIENTS
from derive.flow import layout, module, restricted, restricted_c, restricted_numpy, series, straight
from derive.generate import browser, effects, emit_c, functions, slopes
from derive.kinds import TextDict, TextMap, Texts, ValueDict
from derive.stages import RECORD, digest_of, stage

ROOT = Path(__file__).resolve().parent.parent.parent
FOLDER = ROOT / "generated"
MEND = "python -m derive"


def flow_files() -> TextDict:
    """Return the files that depend on `derive.flow` and the declared laws and effects, by name."""
    integrator = restricted.integrator()
    text = {"INTEGRATOR": restricted_c.c_functions(integrator), "PROCESSOR": emit.PROCESSOR}
    c_flow = emit.filled("_flow.c", layout.c() | series.c_operations() | straight.c_programs() | text)
    texts = {
        "layout.py": layout.python(),
        "effects.py": effects.effects_module(),
        "flow.py": module.flow_module(),
        "_flow.c": c_flow,
        "series.py": series.numpy_text(digest_of(c_flow)),
        "integrator.py": emit.filled("_integrator.py.in", {"INTEGRATOR": restricted_numpy.numpy_functions(integrator)}),
        "program.py": module.linker_module(),
    }
    written = _written(texts)
    return written | {browser.NAME: browser.browser_text(written["_flow.c"], FOLDER / browser.NAME)}


def kernel_files() -> TextDict:
    """Return all other files by name: the kernels are approximated and certified as far as no certificate serves."""
    kernels = shapes.kernels()
    stage("kernels", "definition", lambda: sum(map(shapes.agree, kernels)), "{} comparisons with the checker's")
    proved = stage("kernels", "certify", lambda: certificates.records(variants(), read_records()), "")
    proved += stage("both ends", "certify", lambda: certificates.of_ends(proved), "")
    return stage("kernels", "emit", lambda: _kernel_texts(proved), "")


def slope_files() -> TextDict:
    """Return the file that depends on `derive.algebra.slopes`, by name."""
    return _written({"slopes.py": slopes.slopes_module()})


def _kernel_texts(proved: list[Record]) -> TextDict:
    """Return all files that do not depend on `derive.flow`, from the records of the kernels."""
    kernels = functions.public_functions(proved)
    closed = integrate.closed_forms()
    c_kernels = emit_c.source((*variants(), *variants_of_ends()), functions.comments(kernels, proved))
    texts = {
        "_compiled.py": emit.filled("_compiled.py"),
        "definitions.py": definitions_module(closed),
        "_evaluate.py": emit.filled("_evaluate.py"),
        "kernels.pyi": emit.stub(kernels),
        "kernels.py": emit.functions_module(
            "Moments, weights and quotients of the arc, from their definitions.", kernels, parts_of_ends()
        ),
        "_kernels.c": c_kernels,
        "tiers.py": tiers_module(proved, digest_of(c_kernels)),
        "__init__.py": _package([f.program.name for f in kernels]),
        "py.typed": "",
    }
    printed = [(p, f"{source}, as printed") for p, source in functions.printed()]
    comparison = "The paper's own forms, as printed, for comparison only: they cancel and overflow."
    texts["printed.py"] = emit.raw_module(comparison, printed, "generated.printed")
    return _written(texts | certificates.files(proved))


def _written(texts: TextMap) -> TextDict:
    """Return texts with wrapped lines and headers."""
    wrapped = {name: emit.wrapped(text) if name.endswith(".py") else text for name, text in texts.items()}
    return {name: header(name, text) + text for name, text in wrapped.items()}


def header(name: str, text: str) -> str:
    """Return the header of a file: its origin, and the digest of its text, which a compiled binary contains.

    It is empty unless the name is that of a C or Python file.
    """
    written = f"Written by `{MEND}` with SymPy {__version__}; do not edit."
    if name.endswith(".c"):
        return f'/* {written} */\n#define DIGEST "{digest_of(text)}"\n'
    if name.endswith((".py", ".pyi")):
        return f"# {written}\n# sha256 of the text below: {digest_of(text)}\n"
    return ""


def tiers_module(records: Iterable[Record], digest: str) -> str:
    """Return the module with the proved bounds for the runtime, and the digest of the C source to which they apply."""
    kernels: dict[str, ValueDict] = {}
    # Relative error of one ulp in [1, 2).
    ulps = {"ulp": 2.0**-52, "ulp of float32": 2.0**-23}
    for record in records:
        bound, unit = promised(record)
        ulp = ulps.get(unit)
        forms = kernels.setdefault(record["kernel"], {}).setdefault(record["tier"], {})
        forms[record["form"]] = (bound * ulp, bound) if ulp else (bound, None)
    lines = []
    for kernel, tiers in kernels.items():
        lines.append(f"    {kernel!r}: {{\n")
        lines += [f"        {t!r}: {forms!r},\n" for t, forms in tiers.items()]
        lines.append("    },\n")
    return (
        '"""Proved error bounds of the kernels, and the digest of the C source that they speak of."""\n\n'
        f'DIGEST = "{digest}"\nLIMIT = {LIMIT!r}  # of an end of an arc, rad\n\n'
        "# kernel -> tier -> form of the program -> (relative error, error in ulp where that is the measure).\n"
        f"BOUNDS: dict[str, dict[str, dict[str, tuple[float, float | None]]]] = {{\n{''.join(lines)}}}\n"
    )


def definitions_module(closed: Mapping[str, Expr]) -> str:
    """Return the module with the definition of each function of alpha, for comparison with other computations."""
    over = {name: re.sub(r"\b(sin|cos|atanh)\(", r"m.\1(", str(x).replace("alpha", "x")) for name, x in closed.items()}
    forms = [f"    {name!r}: lambda m, x: {text},\n" for name, text in over.items()]
    quotients = [f"    {q.name!r}: ({q.numerator!r}, {q.denominator!r}),\n" for q in QUOTIENTS]
    return (
        '"""Closed forms and quotients that define the functions of alpha."""\n\n'
        "from collections.abc import Callable\nfrom typing import Any\n\n"
        "# Over any arithmetic m that has sin, cos and atanh.\n"
        f"CLOSED: dict[str, Callable[[Any, Any], Any]] = {{\n{''.join(forms)}}}\n\n"
        f"QUOTIENTS = {{\n{''.join(quotients)}}}\n"
    )


def _package(names: Texts) -> str:
    """Return the text of `generated/__init__.py`, which imports the functions of these names."""
    listed = "".join(f"    {n},\n" for n in sorted(names))
    quoted = "".join(f'    "{n}",\n' for n in sorted(names))
    return (
        '"""Generated functions of the dynamic slip circle method: NumPy only, derived from the definitions."""\n\n'
        f"from generated.kernels import (\n{listed})\n\n"
        '# Tells this package from any other of the same name.\n__project__ = "slipcircle"\n\n'
        f"__all__ = [\n{quoted}]\n"
    )


def present_files(folder: Path = FOLDER) -> TextDict:
    """Return the text of each file; caches, binaries, the record of a run and files of a killed build are left out."""
    return {
        str(path.relative_to(folder)): path.read_text(encoding="utf-8")
        for path in sorted(folder.rglob("*"))
        if path.is_file()
        and "__pycache__" not in path.parts
        and path.suffix not in (".so", ".pyd", ".dylib", ".o")
        and path.name != RECORD.name
    }


# Script of a separate process that imports every module of a new tree.
_IMPORT = """
import importlib, pathlib, sys
sys.path[:0] = sys.argv[1:]
for path in sorted(pathlib.Path(sys.argv[1], "generated").glob("*.py")):
    importlib.import_module("generated." + path.stem)
import slipcircle.workbench.files.keys
"""


def importable(parent: Path) -> None:
    """Import the package `generated` of a folder in a separate process, or raise `ProofError` with Python's message."""
    command = [sys.executable, "-I", "-B", "-c", _IMPORT, str(parent), str(ROOT)]
    alone = os.environ | {"SLIPCIRCLE_COMPILED": "0"}
    done = subprocess.run(command, env=alone, capture_output=True, text=True, check=False)
    if done.returncode:
        raise ProofError("generated: import", done.stderr.strip().splitlines()[-1], "no error")


def write(texts: TextDict, folder: Path = FOLDER, tried: Callable[[Path], None] = lambda _: None) -> Texts:
    """Write a new tree beside the folder, apply ``tried`` to it, replace changed files, and return their names.

    ``texts`` are the texts of all files by name, and files without a text are removed. ``tried`` receives the tree's
    parent folder and raises an error if the tree is wrong.
    """
    folder.mkdir(exist_ok=True)
    old = present_files(folder)
    names = sorted(texts.keys() | old.keys())
    changed = [name for name in names if texts.get(name) != old.get(name)]
    if not changed:
        return []
    with tempfile.TemporaryDirectory(dir=folder.parent, prefix=".") as beside:
        tree = Path(beside) / folder.name
        for name, text in texts.items():
            (tree / name).parent.mkdir(parents=True, exist_ok=True)
            (tree / name).write_text(text, encoding="utf-8", newline="\n")
        tried(tree.parent)
        for name in changed:
            (folder / name).parent.mkdir(exist_ok=True)
            if name in texts:
                os.replace(tree / name, folder / name)
            else:
                (folder / name).unlink()
    return changed


def difference(texts: TextDict, folder: Path = FOLDER) -> str:
    """Return a unified diff from the folder's files to the given texts by name, empty if they are identical."""
    present_texts = present_files(folder) if folder.is_dir() else {}
    diff = ""
    for name in sorted(texts.keys() | present_texts.keys()):
        old = present_texts.get(name)
        new = texts.get(name)
        if old == new:
            continue
        source = "/dev/null" if old is None else f"generated/{name}"
        target = "/dev/null" if new is None else f"derived/{name}"
        before, after = ((text or "").splitlines(keepends=True) for text in (old, new))
        diff += "".join(difflib.unified_diff(before, after, source, target)) or f"--- {source}\n+++ {target}\n"
    return diff
