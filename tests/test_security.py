"""Promises of SECURITY.md on files by others: each is refused in one sentence, or is an ordinary text."""

import base64
import csv
import hashlib
import io
import os
import re
import time
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from slipcircle import LayeredSection, Scene, load, solve
from slipcircle.base.text import clean
from slipcircle.workbench.common import files
from slipcircle.workbench.common.markup import escaped
from slipcircle.workbench.files.shipped import find
from slipcircle.workbench.outputs.page import live
from slipcircle.workbench.outputs.report import report
from tests.support.outputs import tree

SHAKEN = find("shaken-slope").read_text("utf-8")
NESTED = {
    "lists": "a = " + 10_000 * "[" + 10_000 * "]",
    "keys": "a" + 9_999 * ".a" + " = 1",
    "tables": "[a" + 9_999 * ".a" + "]",
    "inline": "a = " + 10_000 * "{b = " + "1" + 10_000 * "}",
}


@pytest.mark.parametrize("text", NESTED.values(), ids=NESTED)
def test_nesting_is_refused(text: str, tmp_path: Path, refused: Any) -> None:
    path = tmp_path / "scene.toml"
    path.write_text(text, "utf-8")
    assert "nested too deeply" in (said := refused("run", path)) or "is not TOML" in said
    assert len(said) < 300


def test_a_file_of_50_mb_is_refused_unread(tmp_path: Path, refused: Any) -> None:
    path = tmp_path / "scene.toml"
    path.write_text("a = [" + 12_500_000 * "1.0," + "]", "utf-8")
    start = time.process_time()
    for command in ("run", "search", "sweep --samples 2"):
        assert "is too large: must be at most 10 MB" in refused(command, path)
    assert time.process_time() - start < 5.0
    assert "is too large" in refused("run /dev/zero --report", tmp_path / "a.html")
    assert not (tmp_path / "a.html").exists()


def test_a_record_is_a_file_of_some_size(tmp_path: Path, refused: Any) -> None:
    path = tmp_path / "scene.toml"
    os.mkfifo(tmp_path / "pipe")
    with open(tmp_path / "many.csv", "wb") as many:
        many.write(20_000_000 * b"0\n")
    start = time.process_time()
    for name, words in (
        ("/dev/zero", "is not a file"),
        ("pipe", "is not a file"),
        (".", "is not a file"),
        ("../../../../../../../etc", "is not a file"),
        ("many.csv", "has 2e+07 numbers: must be at most 1.7e+07"),
    ):
        of_record = f"record = '{name}'\nstep_s = 0.01\nunits = 'g'\nholds = 'ground'\n"
        path.write_text(SHAKEN.partition("pulse =")[0] + of_record, "utf-8")
        assert words in refused("run", path)
    assert time.process_time() - start < 10.0


def sealed(page: str) -> Any:
    """Return the page as XML: it loads nothing, runs and styles nothing but what its policy knows, and is small."""
    root = tree(page)
    attributes = [(name, value) for e in root.iter() for name, value in e.attrib.items()]
    assert not {e.tag for e in root.iter()} & {"link", "iframe", "object", "embed", "base"}
    assert not [name for name, _ in attributes if name.startswith("on") or name == "style"]
    assert all(v.startswith(("data:image/svg+xml;base64,", "#")) for k, v in attributes if k in ("src", "href"))
    assert not re.search(r"url\((?!#)|@import|https?://(?!www.w3.org/2000/svg')", page)
    (policy,) = (e.get("content") for e in root.iter("meta") if e.get("http-equiv") == "Content-Security-Policy")
    assert policy.startswith("default-src 'none';")
    assert "unsafe" not in policy.replace("'wasm-unsafe-eval'", "")  # which compiles WebAssembly alone
    for text in re.findall(r"<(?:style|script)>(.*?)</(?:style|script)>", page, re.S):
        assert base64.b64encode(hashlib.sha256(text.encode()).digest()).decode() in policy
    assert len(page.encode()) < 300_000
    return root


HOSTILE = "</title></script><script>alert(1)</script><b> \"'& \x08 \ud800 ]]> \N{SNOWMAN}"


@pytest.mark.usefixtures("unseen")
def test_pages_need_nothing_else_and_names_are_texts_on_them() -> None:
    """Names of scenes, soils, cases and commands are texts on pages, also of a mass that does not move."""
    layered = load("layered-slope")
    assert isinstance(layered.arc, LayeredSection)
    layers = [(replace(soil, name=HOSTILE + soil.name), top) for soil, top in layered.arc.layers]
    slides = solve(replace(layered, arc=replace(layered.arc, layers=layers), name=HOSTILE, note=HOSTILE))
    stays = solve(Scene(load("vaiont").arc, 0.9, ["rotation"], name=HOSTILE))
    clean = HOSTILE.replace("\x08", "\ufffd").replace("\ud800", "\ufffd")
    file = "# " + HOSTILE.replace("\x08", "").replace("\ud800", "") + "\n"
    root = sealed(report([slides, stays], [file.encode(), b""], f"run {HOSTILE}"))
    assert [h.text for h in root.iter("h2")] == [clean, clean, "To repeat it"]
    assert {f"run {clean}", file} <= {pre.text for pre in root.iter("pre")}
    assert "does not move" in [cell.text for cell in root.iter("td")]
    shown = sealed(live.page(slides))
    assert clean in "".join(shown.itertext())
    for page, scripts in ((root, 4), (shown, 3)):  # the data of each slide, the engine, and the program
        assert len(list(page.iter("script"))) == scripts
        assert not list(page.iter("b"))


@pytest.mark.usefixtures("unseen")
def test_pages_are_all_that_is_written(tmp_path: Path, said: Any) -> None:
    pages = {tmp_path / "live.html", tmp_path / "report.html"}
    said("run layered-slope", *(part for page in sorted(pages) for part in (f"--{page.stem}", page)))
    assert {*tmp_path.iterdir()} == pages


@pytest.mark.parametrize(
    ("text", "cell"),
    [
        ("=1+1", "'=1+1"),
        ("+cmd|' /C calc'!A0", "'+cmd|' /C calc'!A0"),
        ("-2+3", "'-2+3"),
        ("@SUM(A1)", "'@SUM(A1)"),
        ("\t=1", "' =1"),
        ("-2.5e-3", "-2.5e-3"),
        ("-inf", "-inf"),
        ("clay - wet", "clay - wet"),
        ("a\x1b[31m\x07\u202eb\x9d", "a\ufffd[31m\ufffd\ufffdb\ufffd"),
    ],
)
def test_texts_in_tables_and_pages_are_neither_formulas_nor_control_characters(text: str, cell: str) -> None:
    head, row = csv.reader(io.StringIO(files.csv_table([text], [[text]]).decode(), newline=""))
    assert head == row == [cell]
    assert files.csv_table(["a"], [[-1.5, None]]) == b"a\n-1.5,\n"
    assert all(c.isprintable() or c in "\t\n\r" for c in escaped(text))
    assert clean(text).isprintable()


def test_csv_of_scenes_with_names_that_are_formulas(tmp_path: Path, said: Any) -> None:
    """Names that are formulas are texts in the first column of several scenes."""
    paths = [tmp_path / "one.toml", tmp_path / "other.toml"]
    for path, name in zip(paths, ("=HYPERLINK(1)", "a\\u001bb"), strict=True):
        path.write_text(find("vaiont").read_text("utf-8").replace('"vaiont"', f'"{name}"', 1), "utf-8")
    said("run", *paths, "--csv", tmp_path / "a.csv")
    names = {row.partition(",")[0] for row in (tmp_path / "a.csv").read_text("utf-8").splitlines()[1:]}
    assert names == {"'=HYPERLINK(1)", "a\ufffdb"}
