"""The integrator compiled for a browser belongs to the text beside it; no compiler is needed to see that."""

import base64
import gzip
from pathlib import Path

import pytest

import generated
from derive.check.proof import ProofError
from derive.generate import browser

HELD = Path(generated.__file__).with_name(browser.NAME)
SOURCE = HELD.with_name("_flow.c").read_text("utf-8")


def test_the_bytes_belong_to_the_text_the_flags_and_the_compiler(monkeypatch: pytest.MonkeyPatch) -> None:
    digest, text, end = HELD.read_text("utf-8").split("\n")
    assert digest == browser.source_digest(SOURCE) != browser.source_digest(SOURCE + " ")
    assert end == ""
    module = gzip.decompress(base64.b64decode(text, validate=True))
    assert module.startswith(b"\0asm\1\0\0\0")
    assert all(name in module for name in (b"integrate", b"room", b"leave", b"memory"))
    assert f"\nziglang=={browser.COMPILER}\n" in (HELD.parents[1] / "constraints.txt").read_text("utf-8")
    monkeypatch.setattr(browser, "COMPILER", "0.1")
    assert browser.source_digest(SOURCE) != digest


def test_other_bytes_take_the_compiler_that_is_pinned(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Whether this machine has none or another one; bytes that are valid need none."""
    monkeypatch.setattr(browser, "find_spec", lambda _: True)
    monkeypatch.setattr(browser, "version", lambda _: "0.1")
    assert browser.browser_text(SOURCE, HELD) == HELD.read_text("utf-8")
    for source, present in ((SOURCE + " ", HELD), (SOURCE, tmp_path / "none")):
        with pytest.raises(ProofError, match="ziglang"):
            browser.browser_text(source, present)
