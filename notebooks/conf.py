"""Sphinx configuration of the book, which `./run book` builds from this folder: notebooks as stored, and pages.

Two directives show output of the program. `{command}` runs a command line when the book is built and shows its output
and the picture that it draws; `{scene-keys}` is the reference of scene files. Scene files on a page (TOML blocks with a
caption) are available to the commands of that page.
"""

import contextlib
import io
import os
import re
import runpy
import shlex
import shutil
import sys
import tempfile
from html import escape
from itertools import pairwise
from pathlib import Path

from docutils import nodes
from docutils.parsers.rst import directives
from latex2mathml.converter import convert
from sphinx.util.docutils import SphinxDirective

import slipcircle
from slipcircle.workbench.outputs.guide import INDENT

project, author, release = "slipcircle", "The slipcircle authors", slipcircle.__version__
extensions = ["myst_nb", "numpydoc", "sphinx.ext.autodoc"]
copyright = author  # noqa: A001
html_theme, html_title, html_copy_source = "furo", f"slipcircle {release}", False
html_static_path, html_css_files = ["book.css"], ["book.css"]
exclude_patterns = ["*.png", "*.gif"]
nb_execution_mode = "off"  # the outputs are stored, and tests/test_notebooks.py compares them with a fresh run
nb_merge_streams, nb_render_markdown_format = True, "myst"
myst_enable_extensions = ["dollarmath", "amsmath", "deflist"]
myst_heading_anchors, myst_dmath_double_inline = 3, True
autodoc_typehints = "none"  # the numpydoc sections state the types
autodoc_member_order = "bysource"
add_module_names = False
numpydoc_show_class_members = False
nitpicky = True
html_math_renderer = "mathml"
FILES = "_files"  # files written by commands, beside the pages


class Command(SphinxDirective):
    """Directive for a command line, its output, and the picture or page that it writes."""

    required_arguments, final_argument_whitespace, has_content = 1, True, True
    option_spec = {"quiet": directives.flag, "markdown": directives.flag, "alt": directives.unchanged}

    def run(self):
        line = self.arguments[0]
        printed = run(line, Path(self.env.app.outdir) / FILES, self.env.metadata[self.env.docname].get("files", {}))
        if "markdown" in self.options:
            printed = re.sub("^#", "##", printed.partition("\n")[2], flags=re.MULTILINE)  # below the page's title
            return self.parse_text_to_nodes(printed, allow_section_headings=True)
        shown = f"$ {line}\n" + ("" if "quiet" in self.options else printed.rstrip() + "\n")
        block = nodes.literal_block(shown, shown, language="console")
        written = [f"{FILES}/{name}" for name in re.findall(r"--(?:plot|live|report) (\S+)", line)]
        return [block, *(nodes.raw("", self.shown(name), format="html") for name in written)]

    def shown(self, name):
        words = escape(self.options.get("alt", f"picture drawn by {self.arguments[0]}"), quote=True)
        if name.endswith(".html"):
            return f'<iframe class="slide" src="{name}" title="{words}" loading="lazy"></iframe>'
        return f'<a class="picture" href="{name}"><img src="{name}" alt="{words}" loading="lazy"></a>'


def run(line, folder, files):
    """Return the output of a command, run in a temporary folder with the given files, and keep the files it writes.

    A folder written with ``--out`` is available to later commands.
    """
    from slipcircle.__main__ import main

    words = shlex.split(line)
    folder.mkdir(parents=True, exist_ok=True)
    out, err, here = io.StringIO(), io.StringIO(), os.getcwd()
    with tempfile.TemporaryDirectory() as scratch:
        os.chdir(scratch)
        try:
            for name, text in files.items():
                Path(name).write_text(text, encoding="utf-8")
            for option, word in pairwise(words):
                if option != "--out" and (folder / word).is_dir():
                    shutil.copytree(folder / word, word)
            before = set(Path().iterdir())
            with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
                try:
                    status = main(words[1:]) if words[0] == "slipcircle" else run_module(words[2:])
                except SystemExit as leaving:  # after --help
                    status = leaving.code
            for path in set(Path().iterdir()) - before:
                if path.is_dir():
                    shutil.copytree(path, folder / path.name, dirs_exist_ok=True)
                else:
                    shutil.copy(path, folder)
        finally:
            os.chdir(here)
    if status:
        raise RuntimeError(f"{line}: {err.getvalue()}")
    return out.getvalue()


def run_module(words):
    """Run `python -m MODULE ...` in this process."""
    argv, sys.argv = sys.argv, words
    try:
        runpy.run_module(words[0], run_name="__main__", alter_sys=True)
    finally:
        sys.argv = argv


class SceneKeys(SphinxDirective):
    """Directive for the text of `slipcircle schema --text`, with its keys in tables."""

    def run(self):
        text = run("slipcircle schema --text", Path(self.env.app.outdir) / FILES, {})
        return self.parse_text_to_nodes("\n".join(sections(text)), allow_section_headings=True)


def sections(text):
    """Yield the Markdown of the guide, whose blocks have a heading and keys in the first columns and text beside them."""
    head, rest = text.split("\n\nAbove the first table\n")
    yield f"## Conventions\n\n```text\n{head}\n```\n"
    for block in ("Above the first table\n" + rest).split("\n\n"):
        lines = []  # name and words
        for line in block.rstrip().split("\n"):
            if line.strip().startswith("needed:"):
                lines.append(["", f"Needed{line.strip()[6:]}."])
            elif line.startswith(" " * INDENT):
                lines[-1][1] += f" {line.strip()}"
            else:
                name, _, words = line.strip().partition("  ")
                lines.append([name, words.strip()])
        (title, words), *keys = lines
        yield f"{'###' if block.startswith('  ') else '##'} {name_of(title)}\n\n{prose(words)}\n"
        if keys:
            yield "| key | value |\n|---|---|"
            yield from (f"| {name_of(name)} | {prose(words)} |" for name, words in keys if name)
            yield from (f"\n{prose(words)}" for name, words in keys if not name)
        yield ""


def name_of(title):
    """Return keys and tables as code and other words unchanged."""
    keys = re.fullmatch(r"\S+( or \S+)?|law = .*", title)
    return "`" + title.replace(" or ", "` or `") + "`" if keys else title


def prose(words):
    """Escape words for Markdown, except between backticks."""
    parts = words.split("`")
    parts[::2] = [re.sub(r"([\\*_|<\[\]])", r"\\\1", part) for part in parts[::2]]
    return "`".join(parts)


def math(display):
    """Return a visitor that writes mathematics as MathML, which needs no script and no network."""

    def visit(self, node):
        written = convert(node.astext(), display=display)
        self.body.append(f'<div class="math">{written}</div>' if display == "block" else written)
        raise nodes.SkipNode

    return visit


def keep_files(app, docname, source):
    """Keep the scene files of a page, by their captions, for its commands."""
    found = re.findall(r"```\{code-block\} toml\n:caption: (\S+)\n\n?(.*?)```", source[0], re.DOTALL)
    app.env.metadata[docname]["files"] = dict(found)


def setup(app):
    app.add_directive("command", Command)
    app.add_directive("scene-keys", SceneKeys)
    app.add_html_math_renderer("mathml", (math("inline"), None), (math("block"), None))
    app.connect("source-read", keep_files)
    os.environ["COLUMNS"] = "100"
    return {"parallel_read_safe": False}
