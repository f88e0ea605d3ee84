"""Prose: no docstring begins like a continued name, and few nouns are replaced by pronouns."""

import ast
import io
import re
import tokenize
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

from tests.support.sources import parsed

ROOT = Path(__file__).parents[1]
FRAGMENT = re.compile(
    "(Of|As|At|From|By|In|On|Over|With|Without|For|To|Until|Beyond|Before|After|Above|Below|Between|Beside|Also|And|Where|"
    r"Which|What|That|Those|These|Such|Its|Their|The same|Each|Every|All|Is|Are)\b"
)
PATTERNS = {
    "what for a noun": r"\b(what|whatever) (is|are|it|they|has|have|was|were|a|an|the|each|every|no|nobody|goes|stands|"
    r"follows|remains)\b",
    "everyday verb": r"\b(stands?|holds?|goes|is said|are said|is told|is asked|are asked|is kept|are kept) "
    r"(for|in|at|by|of|on|to|with|beside)\b",
    "that or those for a noun": r"\b(that|those) (of|in|from|by|with|which)\b",
}
AT_MOST = {"what for a noun": 20, "everyday verb": 20, "that or those for a noun": 100}


def sources(suffix: str) -> list[Path]:
    folders = [ROOT / name for name in ("slipcircle", "derive", "notebooks")]
    return sorted(path for folder in folders for path in folder.rglob(f"*{suffix}"))


def docstrings(path: Path) -> Iterator[str]:
    for node in parsed(path)[1]:
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef) and (text := ast.get_docstring(node)):
            yield text


@cache
def prose(path: Path) -> tuple[str, ...]:
    """Return strings and comments of several words in Python, and lines outside code blocks in pages."""
    text = path.read_text("utf-8")
    if path.suffix == ".md":
        return tuple(re.sub(r"```.*?```", "", text, flags=re.DOTALL).splitlines())
    strings = [node.value for node in parsed(path)[1] if isinstance(node, ast.Constant)]
    tokens = tokenize.generate_tokens(io.StringIO(text).readline)
    comments = [token.string for token in tokens if token.type == tokenize.COMMENT]
    return tuple(line for line in (*strings, *comments) if isinstance(line, str) and line.count(" ") >= 3)


def test_no_docstring_begins_with_a_preposition_or_pronoun() -> None:
    found = [
        f"{path.name}: {text[:60]}"
        for path in [*sources(".py"), *(ROOT / "tests").rglob("*.py")]
        for text in docstrings(path)
        if FRAGMENT.match(text)
    ]
    assert found == []


@pytest.mark.parametrize("pattern", PATTERNS)
def test_nouns_and_technical_verbs_are_written_out(pattern: str) -> None:
    expression = re.compile(PATTERNS[pattern], re.IGNORECASE)
    files = [*sources(".py"), *sources(".md"), ROOT / "README.md"]
    places = [f"{path.name}: {text[:60]}" for path in files for text in prose(path) for _ in expression.findall(text)]
    assert len(places) <= AT_MOST[pattern], places
