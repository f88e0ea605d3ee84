"""Fixtures of all tests, and the order of the tests."""

import gc
import json
import shlex
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from flint import ctx

from slipcircle.__main__ import main

# The longest tests run first, so that no worker is left alone with one.
LONGEST = (
    "test_what_is_added",
    "test_mypy",
    "test_generated_is_up_to_date",
    "test_verify",
    "2_the_paper",
    "1_derivation",
    "3_what_accuracy",
    "fresh_run",
    "test_engines",
    "test_it_builds",
    "test_jax",
)


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Run the longest tests first, then the files that import `derive`.

    Tests of `derive` run in one process where possible, as they share what `derive` computes once.
    """
    derive = {path for path in {item.path for item in items} if "\nfrom derive" in path.read_text("utf-8")}

    def place(item: pytest.Item) -> int:
        last = len(LONGEST) + (item.path not in derive)
        return next((k for k, part in enumerate(LONGEST) if part in item.nodeid), last)

    items.sort(key=place)
    if not config.getoption("of", None) and {item.path for item in items} >= {
        *Path(__file__).parent.glob("test_*.py")
    }:  # all tests
        assert {place(item) for item in items} >= {*range(len(LONGEST))}, LONGEST


def pytest_configure() -> None:
    """Disable garbage collection during collection, of which it would take a fourth of the time."""
    gc.disable()


def pytest_collection_finish() -> None:
    """Exempt imported modules from garbage collection, and make collections rare."""
    gc.freeze()
    gc.set_threshold(100_000, 20, 20)
    gc.enable()


@pytest.hookimpl(trylast=True)
def pytest_unconfigure() -> None:
    """Exempt what the tests left from a second collection, as pytest has just made one."""
    gc.freeze()


@pytest.fixture(autouse=True)
def precision() -> Iterator[None]:
    """Restore the working precision of ball arithmetic, which is shared by the process, after each test."""
    before = ctx.prec
    yield
    ctx.prec = before


@pytest.fixture
def asked(capsys: pytest.CaptureFixture[str]) -> Callable[..., tuple[int, str, str]]:
    """Return a function that runs a command line, in one text or several, and returns status, output and messages."""

    def ask(*parts: object) -> tuple[int, str, str]:
        capsys.readouterr()
        try:
            status = main([w for part in parts for w in (shlex.split(part) if isinstance(part, str) else [str(part)])])
        except SystemExit as leaving:
            status = int(str(leaving.code))
        return status, *capsys.readouterr()

    return ask


@pytest.fixture
def said(asked: Callable[..., tuple[int, str, str]]) -> Callable[..., str]:
    """Return a function that runs a command, which must succeed, and returns its output."""

    def ask(*parts: object) -> str:
        status, out, err = asked(*parts)
        assert status == 0, err
        return out

    return ask


@pytest.fixture
def records(said: Callable[..., str]) -> Callable[..., list[Any]]:
    """Return a function that runs a command with ``--json`` and returns its list, without NaN and Infinity."""

    def refuse(text: str) -> None:
        pytest.fail(f"{text} is no JSON")

    def ask(*parts: object) -> list[Any]:
        found = json.loads(said(*parts, "--json"), parse_constant=refuse)
        assert isinstance(found, list)
        return found

    return ask


@pytest.fixture
def refused(asked: Callable[..., tuple[int, str, str]]) -> Callable[..., str]:
    """Return a function that runs a command, which must fail with one line for each mistake, and returns the lines."""

    def ask(*parts: object) -> str:
        status, out, err = asked(*parts)
        assert (status, out, err[-1:]) == (1, "", "\n")
        assert all(line.startswith("slipcircle: ") for line in err.splitlines())
        return err

    return ask


@pytest.fixture
def unseen(monkeypatch: pytest.MonkeyPatch) -> None:
    """Replace pictures by empty ones and give live pages one slider; both take most of the time of other outputs.

    The slider is short, so that it has interpolants.
    """
    from slipcircle.workbench.outputs.page import model  # which loads much

    monkeypatch.setattr(model, "SHARES", model.SHARES[-1:])
    monkeypatch.setattr(model, "interpolates", lambda scene, sliders, *most: not sliders[1:])
    monkeypatch.setattr(
        "slipcircle.workbench.outputs.pictures.files.render", lambda *_: b"<svg xmlns='http://www.w3.org/2000/svg'/>"
    )
