"""What SECURITY.md promises of files that somebody else made: each is one sentence, soon, or a text like any other."""

import os
import time
from pathlib import Path
from typing import Any

import pytest

from slipcircle.workbench.files.scenefile import find
from tests.support.outputs import tree

LAYERED = find("layered-slope").read_text("utf-8")
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
    start = time.monotonic()
    for command in ("run", "search", "sweep --samples 2"):
        assert "is too large: must be at most 10 MB" in refused(command, path)
    assert time.monotonic() - start < 5.0
    assert "is too large" in refused("run /dev/zero --report", tmp_path / "a.html")
    assert not (tmp_path / "a.html").exists()


def test_a_record_is_a_file_of_some_size(tmp_path: Path, refused: Any) -> None:
    path = tmp_path / "scene.toml"
    os.mkfifo(tmp_path / "pipe")
    with open(tmp_path / "many.csv", "wb") as many:
        many.write(100_000_000 * b"0\n")
    start = time.monotonic()
    for name, words in (
        ("/dev/zero", "is not a file"),
        ("pipe", "is not a file"),
        (".", "is not a file"),
        ("../../../../../../../etc", "is not a file"),
        ("many.csv", "holds 1e+08 numbers: must be at most 1.7e+07"),
    ):
        of_record = f"record = '{name}'\nstep_s = 0.01\nunits = 'g'\nholds = 'ground'\n"
        path.write_text(SHAKEN.partition("pulse =")[0] + of_record, "utf-8")
        assert words in refused("run", path)
    assert time.monotonic() - start < 10.0


@pytest.mark.usefixtures("unseen")
def test_names_are_texts_on_a_page(tmp_path: Path, said: Any) -> None:
    script = "<script>alert(1)</script>"
    text = LAYERED.replace("[soils.clay", f'[soils."{script}"').replace('soil = "clay"', f'soil = "{script}"')
    path = tmp_path / "scene.toml"
    path.write_text(text.replace('name = "layered-slope"', f'name = "{script}"'), "utf-8")
    pages = [tmp_path / "live.html", tmp_path / "report.html"]
    before = {*tmp_path.iterdir()}
    said("run", path, "--live", pages[0], "--report", pages[1])
    assert {*tmp_path.iterdir()} == before | {*pages}
    for page in pages:
        html = page.read_text("utf-8")
        assert "alert(1)" in html
        assert script not in html
        assert len(list(tree(html).iter("script"))) == 2  # the slide's data and its program
        assert "default-src 'none'" in html
