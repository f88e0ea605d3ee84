"""Tests by the files that they reach, and the option ``--of FILE`` of ``./run test``, a plugin of pytest.

``python -m tests.campaigns.mutants 0 --map FILE`` writes the map, ``reach.json``.
"""

import json
from collections.abc import Iterable, Mapping
from itertools import groupby
from pathlib import Path

import pytest

FILE = Path(__file__).with_name("reach.json")
ROOT = FILE.parents[2]


def write(reached: Mapping[str, Iterable[str]]) -> None:
    """Store the tests that reach each file: their names once, then for each file ranges of their numbers."""
    names = sorted({test for tests in reached.values() for test in tests})
    number = {name: k for k, name in enumerate(names)}
    rows = [f"{json.dumps(file)}: {json.dumps(_ranges(sorted(number[t] for t in reached[file])))}" for file in reached]
    text = ',\n"'.join(f'{test}"' for test in names)
    FILE.write_text(f'{{"tests": ["{text}],\n"files": {{\n' + ",\n".join(sorted(rows)) + "\n}}\n", "utf-8")


def _ranges(numbers: list[int]) -> str:
    """Return whole numbers in order as text, such as "0-3 7"."""
    runs = [[k for _, k in run] for _, run in groupby(enumerate(numbers), key=lambda pair: pair[1] - pair[0])]
    return " ".join(f"{run[0]}-{run[-1]}" if run[1:] else f"{run[0]}" for run in runs)


def tests_of(files: Iterable[str]) -> tuple[set[str], set[str]]:
    """Return the tests that reach one of the files, and all tests of the map.

    Raises
    ------
    ValueError
        If no test is known to reach a file.
    """
    stored = json.loads(FILE.read_text("utf-8"))
    names, chosen = stored["tests"], set[str]()
    for file in files:
        path = Path(file).resolve()
        name = path.relative_to(ROOT).as_posix() if path.is_relative_to(ROOT) else file
        if name not in stored["files"]:
            raise ValueError(
                f"--of {file}: no test is known to reach it; give a module of slipcircle or derive, "
                "run all tests, or write the map again with: python -m tests.campaigns.mutants 0 --map FILE"
            )
        for run in stored["files"][name].split():
            first, _, last = run.partition("-")
            chosen |= {*names[int(first) : int(last or first) + 1]}
    return chosen, {*names}


def pytest_addoption(parser: pytest.Parser) -> None:
    """Add ``--of FILE``, which may be repeated."""
    parser.addoption("--of", action="append", metavar="FILE", help="run the tests that reach this file, and new tests")


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Deselect the tests that are known to reach none of the files of ``--of``."""
    if files := config.getoption("of"):
        try:
            chosen, known = tests_of(files)
        except ValueError as error:
            raise pytest.UsageError(str(error)) from None
        others = [item for item in items if item.nodeid.partition("[")[0] in known - chosen]
        config.hook.pytest_deselected(items=others)
        items[:] = [item for item in items if item not in {*others}]
