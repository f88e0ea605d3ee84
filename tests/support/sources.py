"""Modules of the repository as text and syntax nodes, each read once."""

import ast
from functools import cache
from pathlib import Path


@cache
def parsed(path: Path) -> tuple[str, list[ast.AST]]:
    """Return the text of a module, and all its syntax nodes, the module first."""
    text = path.read_text("utf-8")
    return text, [*ast.walk(ast.parse(text))]
