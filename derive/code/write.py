"""The files of `generated`: their text, written atomically, or compared with what is there."""

import difflib
import hashlib
import os
import tempfile
from collections.abc import Iterable
from pathlib import Path

import sympy

from derive.algebra import sensitivity
from derive.algebra.integrate import Derivation
from derive.approximate.approximants import variants
from derive.check import certificates, certify
from derive.check.rounding import Record
from derive.code import emit, emit_c, functions, slopes
from derive.flow import emit as flow
from derive.flow import series

ROOT = Path(__file__).resolve().parent.parent.parent
FOLDER = ROOT / "generated"
TEMPLATES = Path(__file__).resolve().parent / "templates"
MEND = "python -m derive"
KERNELS = "Moments, weights and quotients of the arc, from their definitions."
MOTION = "The frozen slide under constant friction: angular velocity, rotation, acceleration, arrest."
BALANCE = "The balance of momentum and the energy in the phase plane, specialised to the effects that are present."
STABLE = "The kernels' forms without cancellation, each proved equal to its closed form, for comparison only."
SENSITIVITY = "Derivatives of the closed forms, of the balance and of the arc: what a small change makes of them."
PRINTED = "The paper's own forms, as printed, for comparison only: they cancel and overflow."


def files(derivations: list[Derivation], proved: list[Record]) -> dict[str, str]:
    """Text of every file of `generated`, by name, each under a header with the digest of the text below it."""
    kernels, motion = functions.kernels(derivations, proved), functions.motion()
    c_source = emit_c.source(variants())
    texts = {
        "_compiled.py": (TEMPLATES / "_compiled.py").read_text(encoding="utf-8"),
        "_evaluate.py": (TEMPLATES / "_evaluate.py").read_text(encoding="utf-8"),
        "balance.py": emit.plain_module(BALANCE, functions.balance()[0]),
        "effects.py": functions.effects_module(),
        "flow.py": flow.module(),
        "kernels.py": emit.module(KERNELS, kernels),
        "motion.py": emit.module(MOTION, motion),
        "_flow.c": walk_source(),
        "_kernels.c": c_source,
        "printed.py": emit.raw_module(PRINTED, [(p, f"{source}, as printed") for p, source in functions.printed()]),
        "series.py": series.numpy_text(),
        "sensitivity.py": emit.plain_module(SENSITIVITY, sensitivity.programs()),
        "slopes.py": slopes.module(),
        "stable.py": emit.raw_module(STABLE, functions.stable_forms()),
        "tiers.py": tiers_module(proved, digest_of(c_source)),
        "__init__.py": _package([f.program.name for f in kernels]),
        "py.typed": "",
    }  # fmt: skip
    texts |= certificates.files(proved)
    return {name: header(name, text) + text for name, text in sorted(texts.items())}


def walk_source() -> str:
    """The compiled walk, with the operations that it knows."""
    text = (TEMPLATES / "_flow.c").read_text(encoding="utf-8")
    made = {"CODES": series.c_enums(), "SERIES": series.c_series(), "CELL_OPERATIONS": series.c_cells()}
    for mark, lines in made.items():
        text = text.replace(f"@{mark}@\n", lines)
    return text


def header(name: str, text: str) -> str:
    """Who writes the file, with what, and the digest of the text below, which a binary made of it carries."""
    written = f"Written by `{MEND}` with SymPy {sympy.__version__}; do not edit."
    if name.endswith(".c"):
        return f'/* {written} */\n#define DIGEST "{digest_of(text)}"\n'
    return f"# {written}\n# sha256 of the text below: {digest_of(text)}\n" if name.endswith(".py") else ""


def digest_of(text: str) -> str:
    """Its sha256."""
    return hashlib.sha256(text.encode()).hexdigest()


# Ulps are the measure of these tiers: of a number in [1, 2), the relative error of one.
ULP = {"best": 2.0**-52, "float32": 2.0**-23}


def proofs() -> list[Record]:
    """The record of every variant: one that is there holds as long as its operations do (`prove` proves it again)."""
    there = [record for path in sorted((FOLDER / "certificates").glob("*.json")) for record in certify.read(path)]
    return certificates.records(variants(), there)


def tiers_module(records: Iterable[Record], digest: str) -> str:
    """What the run time must know of the proofs, and of which C source they speak."""
    kernels: dict[str, dict[str, dict[str, tuple[float, float | None]]]] = {}
    for r in records:
        bound, ulp = r["bound"], ULP.get(r["tier"])
        forms = kernels.setdefault(r["kernel"], {}).setdefault(r["tier"], {})
        forms[r["form"]] = (bound * ulp, bound) if ulp else (bound, None)
    lines = []
    for kernel, tiers in kernels.items():
        lines += [f"    {kernel!r}: {{\n", *(f"        {t!r}: {forms!r},\n" for t, forms in tiers.items()), "    },\n"]
    return (
        '"""Proved error bounds of the kernels, and the digest of the C source that they speak of."""\n\n'
        f'DIGEST = "{digest}"\n\n'
        "# kernel -> tier -> form of the program -> (relative error, error in ulp where that is the measure).\n"
        "# What is not here is sampled only.\n"
        f"BOUNDS: dict[str, dict[str, dict[str, tuple[float, float | None]]]] = {{\n{''.join(lines)}}}\n"
    )


def _package(names: list[str]) -> str:
    listed = "".join(f"    {n},\n" for n in sorted(names))
    quoted = "".join(f'    "{n}",\n' for n in sorted(names))
    return (
        '"""Generated functions of the dynamic slip circle method: NumPy only, derived from the definitions."""\n\n'
        f"from generated.kernels import (\n{listed})\n\n"
        '# Tells this package from any other of the same name.\n__project__ = "slipcircle"\n\n'
        f"__all__ = [\n{quoted}]\n"
    )


def present(folder: Path = FOLDER) -> dict[str, str]:
    """Text of the files that are there; caches and built binaries do not count."""
    return {
        str(path.relative_to(folder)): path.read_text(encoding="utf-8")
        for path in sorted(folder.rglob("*"))
        if path.is_file() and "__pycache__" not in path.parts and path.suffix not in (".so", ".pyd", ".dylib")
    }


def write(wanted: dict[str, str], folder: Path = FOLDER) -> list[str]:
    """Write the files that differ, each by a temporary file that replaces it, and remove the ones that are not wanted.

    Returns
    -------
    list of str
        Names of the files that changed.
    """
    folder.mkdir(exist_ok=True)
    there = present(folder)
    changed = [name for name in sorted(wanted.keys() | there.keys()) if wanted.get(name) != there.get(name)]
    for name in changed:
        if name not in wanted:
            (folder / name).unlink()
            continue
        (folder / name).parent.mkdir(exist_ok=True)
        handle, temporary = tempfile.mkstemp(dir=folder, prefix=".", suffix=".tmp")
        try:
            with os.fdopen(handle, "w", encoding="utf-8", newline="\n") as file:
                file.write(wanted[name])
            os.chmod(temporary, 0o644)
            os.replace(temporary, folder / name)
        except BaseException:
            Path(temporary).unlink(missing_ok=True)
            raise
    return changed


def difference(wanted: dict[str, str], folder: Path = FOLDER) -> str:
    """A unified diff from what is there to what is wanted; empty when they agree in contents and set of files."""
    there = present(folder) if folder.is_dir() else {}
    found = []
    for name in sorted(wanted.keys() | there.keys()):
        old, new = there.get(name), wanted.get(name)
        if old == new:
            continue
        source = "/dev/null" if old is None else f"generated/{name}"
        target = "/dev/null" if new is None else f"derived/{name}"
        before, after = ((text or "").splitlines(keepends=True) for text in (old, new))
        found.append("".join(difflib.unified_diff(before, after, source, target)) or f"--- {source}\n+++ {target}\n")
    return "".join(found)
