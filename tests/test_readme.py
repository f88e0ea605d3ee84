"""README and the pages of the book: Python, scene files and commands run, tables are true, links lead somewhere."""

import json
import re
import tomllib
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import pytest

import generated
import slipcircle
from generated._compiled import LEVEL, LEVELS
from generated.effects import EFFECTS
from generated.tiers import BOUNDS
from slipcircle import load, solve
from slipcircle.workbench.cost import kernels, rows
from slipcircle.workbench.outputs.pictures import costplot
from slipcircle.workbench.outputs.pictures import files as pictures
from tests.support import accuracy, golden
from tests.support.kernels import angles, errors
from tests.support.motions import residual
from tests.support.outputs import QUICK, blocks, columns, words_of

ROOT = Path(__file__).resolve().parent.parent
README = ROOT / "README.md"
TEXT = README.read_text(encoding="utf-8")
PAGES = {path.stem: path.read_text(encoding="utf-8") for path in sorted((ROOT / "notebooks").glob("*.md"))}


EXAMPLES = [(name, code) for name, text in {"README": TEXT, **PAGES}.items() for code in blocks(text, "python")]


@pytest.mark.parametrize(("name", "code"), EXAMPLES, ids=[name for name, _ in EXAMPLES])
def test_python_examples_print_their_comments(name: str, code: str, capsys: pytest.CaptureFixture[str]) -> None:
    """Printed lines equal the comments below each print; an error estimate may differ by machine."""
    if "emcee" in code:
        pytest.importorskip("emcee", reason="the extra 'book' is not installed")
    exec(code, {})
    shown = re.findall(r"^# (.*)", code, re.MULTILINE)
    found = capsys.readouterr().out.splitlines()
    assert len(shown) == len(found) > 0
    for one, other in zip(shown, found, strict=True):
        assert one.partition("error")[0] == other.partition("error")[0]


def test_proved_bounds_of_the_page_on_accuracy() -> None:
    lines = PAGES["accuracy"].splitlines()
    rows = [line.split("|")[1:-1] for line in lines if line.startswith("| `") and line.count("|") == 8]
    shown = {row[0].strip(" `"): float(row[5]) for row in rows}
    assert shown == {name: BOUNDS[name]["best"]["fused"][1] for name in shown}
    assert len(shown) == 5
    of_ends = [line.split("|")[1:-1] for line in lines if line.startswith("| `") and line.count("|") == 7]
    assert len(of_ends) == 3
    for name, *_, relative in of_ends:
        assert float(relative) == BOUNDS[name.strip(" `")]["best"]["fused"][0]
    assert f"at most {shown['polar_moment']} ulp with FMA" in PAGES["accuracy"]
    assert f"proved to {BOUNDS['polar_moment']['1e-6']['fused'][0]}" in PAGES["accuracy"]


(SCENE,) = blocks(PAGES["quickstart"], "toml")


@pytest.fixture
def run(said: Any, tmp_path: Path) -> Callable[..., dict[str, str]]:
    """Return the rows that `run --verbose` prints of a scene file with this text."""

    def told(text: str, *options: object) -> dict[str, str]:
        path = tmp_path / "my-slope.toml"
        path.write_text(text, encoding="utf-8")
        return {label: "  ".join(cells) for label, cells in columns(said("run --verbose", path, *options)).items()}

    return told


def test_the_scene_file_of_the_quickstart_runs(tmp_path: Path, run: Any, said: Any) -> None:
    """The file of the quickstart, and with the arc of its comments: they run, and every effect is named."""
    path = tmp_path / "my-slope.toml"
    soil = SCENE[SCENE.index("[friction]") : SCENE.index("# [arc]")]
    of_arc = "".join(line[2:] for line in SCENE.splitlines(True) if re.match(r"# (\w+ = |\[\w+\] *(#|$))", line))
    for text in (SCENE, of_arc + soil):
        told = run(text)
        assert (told["moves"], told["comes to rest"]) == ("yes", "yes")
        motion = solve(load(str(path)))
        called = {"pore_pressure" if table == "water" else table for table in tomllib.loads(text)}
        assert motion.plan.effects == tuple(e for e in EFFECTS if e in called)
        assert all(f"[{e}]" in SCENE for e in motion.plan.left_out)  # in its comments
        assert "my-slope" in said("plan --ladder", path)


def test_the_earthquake_of_the_readme(run: Any) -> None:
    """The scene file runs, and the lines below it are printed."""
    (scene,) = blocks(TEXT, "toml")
    printed = run(scene)
    shown = {label: cells for block in blocks(TEXT, "") for label, cells in columns(block).items()}
    assert len(shown) == 3
    assert {label: "  ".join(cells) for label, cells in shown.items()}.items() <= printed.items()


@pytest.mark.usefixtures("unseen")
def test_the_commands_of_the_readme(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, said: Any) -> None:
    """The lines below each command are printed, from a new file to a back-analysed friction."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(pictures, "picture", lambda *_: b"GIF")
    called, printed = [], [""]
    for line in blocks(TEXT, "console")[0].splitlines():
        if line.startswith("$ ./run slipcircle "):
            words = line.partition("#")[0].removeprefix("$ ./run slipcircle ")
            called.append(words.partition(" ")[0])
            printed = said(words).splitlines()
        else:
            assert line in printed
    assert called == ["new", "search", "run", "backanalyse"]


def test_the_picture_of_what_accuracy_costs_is_drawn_so_today(monkeypatch: pytest.MonkeyPatch) -> None:
    """Titles, axes and legends are current, with a compiler that has FMA."""
    if LEVELS[LEVEL][0] == "fused":
        for name, value in QUICK.items():
            monkeypatch.setattr(rows, name, value)
        measured = kernels.of_kernel("polar_moment")
        today = words_of(pictures.render(lambda f: costplot.frontier(measured, f.add_subplot()), costplot.SIZE, "png"))
        assert words_of((ROOT / "notebooks/frontier.png").read_bytes()) == today
        assert "polar_moment, filled on the frontier" in today


def commands() -> list[str]:
    """Return the commands of the book's table with the arguments that stand in their rows, optional ones too."""
    found = set()
    for row in (x.split(" | ") for x in PAGES["commands"].splitlines() if x.startswith("| `slipcircle")):
        base = row[0].strip("| `").replace("\\|", "|")
        plain = re.sub(r"\[[^]]*\]", "", base)
        more = [x for x in re.findall(r"`(--[^`]* [^`]*)`", row[1]) if "=" in x or "+-" in x]
        for extra in ["", *re.findall(r"\[([^]]*)\]", base), *more]:
            if extra != "NAME":
                rest = plain if "+-" not in extra else plain.partition(" --run-out-m")[0]
                found.add(f"{rest.removeprefix('slipcircle ')} {extra.split('|')[0]}")
    return sorted(found)


@pytest.mark.parametrize("line", commands())
def test_every_command_of_the_table_runs(line: str, tmp_path: Path, monkeypatch: Any, said: Any) -> None:
    monkeypatch.chdir(tmp_path)
    for name, value in QUICK.items():
        monkeypatch.setattr(rows, name, value)
    Path("SLOPE.toml").write_text("[ground]\nheight_m = 10\nangle_deg = 26.6\nunit_weight_kN_m3 = 20\n[friction]\n"
                                  "angle_deg = 19.6\n[cohesion]\ncohesion_kPa = 3\n", "utf-8")  # fmt: skip
    Path("FOLDER").mkdir()
    Path("FOLDER/quake.csv").write_text("time_s,k_h_g\n0,0\n0.5,0.3\n1,-0.3\n1.5,0\n", "utf-8")
    line = line.replace("FOLDER ...", "FOLDER")
    if "--correlation" in line:
        drawn = "--uncertain friction.angle_deg=normal:10:1 --uncertain cohesion.cohesion_kPa=uniform:1:2"
        line = line.replace("vaiont", "wet-slope").replace("SCENE", "wet-slope") + f" {drawn}"
    elif "--samples" in line and "--uncertain" not in line:
        line += " --uncertain friction.angle_deg=normal:10:1"
    assert said(re.sub(r"\bN\b", "64", line.replace("SCENE ...", "SCENE")).replace("SCENE", "vaiont"))


# --- what it was validated against -----------------------------------------------------------------------------------

# Rows of the table: what, against what, largest error, test.
VALIDATED = [
    line.split("|")[1:-1]
    for line in PAGES["validation"].splitlines()
    if re.search(r"\| \[`test_\w+`\]\(\.\./tests/", line)
]


def test_every_row_of_the_validation_names_a_test_that_exists() -> None:
    assert len(VALIDATED) == 15
    numbers = [row[2].strip() for row in VALIDATED]
    assert all(row.split("|")[3].strip() in numbers for row in TEXT.splitlines() if re.search(r"\| .*\de-\d", row))
    for row in VALIDATED:
        ((name, file),) = re.findall(r"\[`(\w+)`\]\((\S+)\)", row[3])
        assert re.search(rf"^def {name}\(", (ROOT / "notebooks" / file).read_text("utf-8"), re.MULTILINE), row


def test_the_largest_errors_are_those_of_the_table() -> None:
    """Errors that can be computed in seconds are within a factor of 3, as rounding depends on the machine.

    Processors that round products and sums apart, or NumPy, may well err less.
    """
    shown = {row[3].split("`")[1]: float(row[2].split()[0].rstrip(";")) for row in VALIDATED[:-1]}
    numbers = [k for k in accuracy.NUMBERS if not accuracy.near_limit(k)]
    numbers = [k for k in numbers if accuracy.ROWS[k]["reference"]["phases"] < accuracy.MANY]
    found = {
        "test_true_errors_are_rounding": max(max(accuracy.error(k)) for k in numbers),
        "test_accuracy_is_what_the_user_gets": max(max(accuracy.error(k)) for k in accuracy.TIMED),
        "test_energy_balances_and_adds_up": max(residual(golden.solved(name)) for name in list(golden.rows())[::6]),
    }
    fused = LEVELS[LEVEL][0] == "fused"
    if fused:
        alphas, kernel = angles(), generated.moment_of_inertia
        found["test_accuracy"] = errors(kernel, "moment_of_inertia", alphas)[0][0]
    for name, error in found.items():
        assert error < shown[name] * 3, (name, error)
        assert not fused or shown[name] / 3 < error, (name, error)


# --- links -----------------------------------------------------------------------------------------------------------

LINK = re.compile(r"\]\((?!\?)([^()\s]+)\)|(?<!\]\()(\bhttps?:/*[^\s<>\"'`]+)")  # [words](target), or a bare address


def documents() -> Iterator[tuple[Path, str]]:
    """Yield every text for readers: documents, texts of notebooks, docstrings, comments, scene files."""
    documents = ("*.md", "notebooks/*.md", "CITATION.cff", "pyproject.toml")
    kinds = (*documents, "slipcircle/scenes/*.toml", "derive/**/*.py", "slipcircle/**/*.py")
    yield from ((path, path.read_text("utf-8")) for kind in kinds for path in sorted(ROOT.glob(kind)))
    for path in ROOT.glob("notebooks/*.ipynb"):
        cells = json.loads(path.read_text("utf-8"))["cells"]
        yield path, "\n".join("".join(c["source"]) for c in cells)


def is_good(path: Path, target: str) -> bool:
    """Whether a link leads to a file here, or is an address, by https."""
    if ":" in target:
        parts = urlsplit(target)
        return parts.scheme == "https" and re.fullmatch(r"([a-z0-9-]+\.)+[a-z]{2,}", parts.netloc) is not None
    return path.suffix == ".py" or (path.parent / target.partition("#")[0]).exists()


def test_links_lead_to_files_or_https_addresses() -> None:
    links = [(path, a or b.rstrip(".,;)")) for path, text in documents() for a, b in LINK.findall(text)]
    assert not [link for link in links if not is_good(*link)]
    assert any(target.startswith("https://") for _, target in links)


def test_the_page_on_developing_lists_every_file_of_tests() -> None:
    assert {path.stem for path in (ROOT / "tests").glob("test_*.py")} <= {
        *re.findall("`(test_\\w+)`", PAGES["developing"])
    }


def test_headings_that_links_point_at() -> None:
    """Anchors in the README's own links are headings of it."""
    heads = {re.sub(r"[^\w -]", "", h.lower()).replace(" ", "-") for h in re.findall(r"^#+ (.*)", TEXT, re.MULTILINE)}
    assert set(re.findall(r"\]\(#([^)]+)\)", TEXT)) <= heads


def test_the_citation_agrees_with_the_project() -> None:
    """Entries shared with the project's file are equal."""
    text, project = (ROOT / "CITATION.cff").read_text("utf-8"), tomllib.loads((ROOT / "pyproject.toml").read_text())
    keys, known = dict(re.findall(r"^([a-z-]+):[ ]?(.*)", text, re.MULTILINE)), project["project"]
    assert keys["version"].strip('"') == known["version"] == slipcircle.__version__
    assert keys["license"] == known["license"]
    assert re.findall(r"^  - name: \"(.*)\"", text, re.MULTILINE) == [a["name"] for a in known["authors"]]
