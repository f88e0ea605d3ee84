"""The book: it builds without a warning, every command of its pages runs, and every link of it leads somewhere."""

import io
import re
import runpy
from html import unescape
from importlib.util import find_spec
from pathlib import Path
from typing import Any
from urllib.parse import unquote, urlsplit

import pytest

ROOT = Path(__file__).parents[1]
# Found, not imported, as the import would take a tenth of the time in which all tests are collected.
pytestmark = pytest.mark.skipif(not (find_spec("myst_nb") and find_spec("furo")), reason="no extra 'book'")


TAG = re.compile(r"<\w[^<>]*>")
LINK, PLACE = (re.compile(rf'\s(?:{names})="([^"]*)"') for names in ("href|src", "id|name"))


class Links:
    """Links and pictures of a page, and the places in it that links may name."""

    def __init__(self, text: str) -> None:
        tags = "".join(TAG.findall(text))
        self.targets = {unescape(target) for target in LINK.findall(tags) if target}
        self.places = {unescape(place) for place in PLACE.findall(tags)}


@pytest.mark.filterwarnings("ignore")  # of other packages
def test_it_builds_without_a_warning_and_no_link_is_broken(tmp_path: Path, monkeypatch: Any, unseen: None) -> None:
    """Pictures are left empty and the paper is not judged again: other tests do both. No word is indexed."""
    from sphinx.application import Sphinx
    from sphinx.search import SearchLanguage

    monkeypatch.setattr(SearchLanguage, "split", lambda *_: [])
    monkeypatch.setattr(runpy, "run_module", lambda *_, **__: print("# Verdicts\n\n## Of one claim"))
    warnings, pages = io.StringIO(), tmp_path / "book"
    book = ROOT / "notebooks"
    app = Sphinx(book, book, pages, tmp_path / "trees", "html", status=None, warning=warnings)
    app.build()
    assert warnings.getvalue() == ""
    links = {path.name: Links(path.read_text("utf-8")) for path in pages.glob("*.html")}
    assert {f"{path.stem}.html" for path in (*book.glob("*.md"), *book.glob("*.ipynb"))} <= links.keys()
    broken = {
        (name, target)
        for name, page in links.items()
        for target in page.targets
        if leads_nowhere(name, target, links, pages)
    }
    assert not broken


def leads_nowhere(name: str, target: str, links: dict[str, Links], pages: Path) -> bool:
    """Whether a link from this page inside the book names a file or a place that is not there."""
    parts = urlsplit(target)
    if parts.scheme or target in ("#", ""):
        return False
    page = parts.path or name
    return not (pages / page).exists() or bool(parts.fragment and unquote(parts.fragment) not in links[page].places)
