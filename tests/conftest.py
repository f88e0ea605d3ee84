"""What every test starts from, and how the command line is asked in this process."""

import gc
import json
import shlex
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from flint import ctx

from slipcircle.__main__ import main

# What takes longest goes first, so that no worker is left alone with it.
LONGEST = (
    "test_what_is_added",
    "test_mypy",
    "test_generated_is_up_to_date",
    "test_verify",
    "2_the_paper",
    "1_derivation",
    "3_what_accuracy",
    "fresh_run",
    "test_ctrl_c",
    "test_it_builds",
    "test_jax",
)


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Then the files that derive, in one process as far as it gets: they share what `derive` computes once."""
    derive = {path for path in {item.path for item in items} if "\nfrom derive" in path.read_text("utf-8")}

    def place(item: pytest.Item) -> int:
        last = len(LONGEST) + (item.path not in derive)
        return next((k for k, part in enumerate(LONGEST) if part in item.nodeid), last)

    items.sort(key=place)
    if {item.path for item in items} >= {*Path(__file__).parent.glob("test_*.py")}:  # all tests: each name is one's
        assert {place(item) for item in items} >= {*range(len(LONGEST))}, LONGEST


def pytest_configure() -> None:
    """Imports and collected tests are hardly ever garbage, but looking for it takes a fourth of their time."""
    gc.disable()


def pytest_collection_finish() -> None:
    """Modules stay until the end, so no later collection examines them; and collections are rare."""
    gc.freeze()
    gc.set_threshold(100_000, 20, 20)
    gc.enable()


@pytest.fixture(autouse=True)
def precision() -> Iterator[None]:
    """Ball arithmetic's working precision, one number for the whole process, is after each test what it was before."""
    before = ctx.prec
    yield
    ctx.prec = before


@pytest.fixture
def asked(capsys: pytest.CaptureFixture[str]) -> Callable[..., tuple[int, str, str]]:
    """A command's exit status, output and messages; its line in one text or several, paths as they are."""

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
    """What a command prints, which must end well."""

    def ask(*parts: object) -> str:
        status, out, err = asked(*parts)
        assert status == 0, err
        return out

    return ask


@pytest.fixture
def records(said: Callable[..., str]) -> Callable[..., list[Any]]:
    """What a command prints with ``--json``: a list of JSON as its standard has it, without NaN and Infinity."""

    def refuse(text: str) -> None:
        pytest.fail(f"{text} is no JSON")

    def ask(*parts: object) -> list[Any]:
        found = json.loads(said(*parts, "--json"), parse_constant=refuse)
        assert isinstance(found, list)
        return found

    return ask


@pytest.fixture
def refused(asked: Callable[..., tuple[int, str, str]]) -> Callable[..., str]:
    """The message of a command that refuses what it is given, a line for each mistake; it prints nothing else."""

    def ask(*parts: object) -> str:
        status, out, err = asked(*parts)
        assert (status, out, err[-1:]) == (1, "", "\n")
        assert all(line.startswith("slipcircle: ") for line in err.splitlines())
        return err

    return ask


@pytest.fixture
def unseen(monkeypatch: pytest.MonkeyPatch) -> None:
    """Pictures cost most of the time; where they are not what is tested, they are empty."""
    monkeypatch.setattr(
        "slipcircle.workbench.outputs.pictures.files.render", lambda *_: b"<svg xmlns='http://www.w3.org/2000/svg'/>"
    )
