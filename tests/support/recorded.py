"""Recorded answers of references that take long to compute.

The key of an answer is a digest of the question and of the source that answers it, without its comments: where either
changes, the answer is computed. One of 32 recorded answers is computed again in every run, and compared. After a change
of a reference, delete ``recorded.jsonl`` and run all tests with the environment variable ``RECORD``, which records.
"""

import hashlib
import json
import os
import re
import sys
from collections.abc import Callable
from functools import cache, wraps
from pathlib import Path
from typing import ParamSpec, TypeVar, cast

from tests.support import oracle

P = ParamSpec("P")
T = TypeVar("T")
HERE = Path(__file__).parent
FILE = HERE / "recorded.jsonl"
SOURCES = tuple(HERE / f"{name}.py" for name in ("oracle", "pieces", "section_references", "taylor"))
DECLARED = oracle.WEIGHTS, oracle.WHOLE, oracle.QUOTIENTS
COMMENTS = re.compile(r'(?s:""".*?""")|#.*|\s+')


@cache
def answers() -> dict[str, object]:
    """Return the recorded answers by their keys."""
    return dict(map(json.loads, FILE.read_text("utf-8").splitlines())) if FILE.exists() else {}


@cache
def digest(path: Path) -> str:
    """Return a digest of a file without its comments."""
    return hashlib.sha256(COMMENTS.sub(" ", path.read_text("utf-8")).encode()).hexdigest()


def recorded(function: Callable[P, T]) -> Callable[P, T]:
    """Return recorded answers of a function; answers are JSON, and exceptions are not recorded."""

    @wraps(function)
    def answer(*given: P.args, **named: P.kwargs) -> T:
        classes = [x for x in (*given, *named.values(), function) if hasattr(x, "__module__")]
        files = {*SOURCES, *(Path(str(sys.modules[x.__module__].__file__)) for x in classes)}
        question = repr((DECLARED, function.__qualname__, given, sorted(named.items())))
        key = hashlib.sha256("".join([question, *map(digest, sorted(files))]).encode()).hexdigest()[:24]
        known = answers().get(key)
        if known is not None and int(key, 16) % 32:
            return cast(T, known)
        found = function(*given, **named)
        if known is None and "RECORD" in os.environ:
            with FILE.open("a", encoding="utf-8") as file:
                file.write(json.dumps([key, found]) + "\n")
        assert known in (None, found), f"not as recorded: {question}"
        return found

    return answer
