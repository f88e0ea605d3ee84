"""The documents are run: the README's Python, scene file and commands; its tables are true, links lead somewhere."""

import ast
import json
import re
import tomllib
from collections.abc import Iterator
from pathlib import Path
from urllib.parse import urlsplit

import numpy as np
import pytest
import test_accuracy
import test_kernels
import test_time_scenes

import generated
import slipcircle
from generated._compiled import LEVEL, LEVELS
from generated.effects import EFFECTS
from generated.tiers import BOUNDS
from slipcircle import Motion, load, solve
from slipcircle.__main__ import main
from slipcircle.outputs import plots
from slipcircle.studies.ladder import ladder

ROOT = Path(__file__).resolve().parent.parent
README = ROOT / "README.md"
TEXT = README.read_text(encoding="utf-8")
BLOCKS = re.findall(r"^```(\w*)\n(.*?)^```", TEXT, re.DOTALL | re.MULTILINE)


def test_python(capsys: pytest.CaptureFixture[str]) -> None:
    """What the README's code prints is what stands below each print; an error estimate may differ by machine."""
    for code in (text for kind, text in BLOCKS if kind == "python"):
        exec(code, {})
        shown = re.findall(r"^# (.*)", code, re.MULTILINE)
        found = capsys.readouterr().out.splitlines()
        assert len(shown) == len(found) == code.count("print(")
        for one, other in zip(shown, found, strict=True):
            assert one.partition("error")[0] == other.partition("error")[0]


def test_proved_bounds_of_the_readme() -> None:
    rows = [line.split("|")[1:-1] for line in TEXT.splitlines() if line.startswith("| `") and line.count("|") == 8]
    shown = {row[0].strip(" `"): float(row[5]) for row in rows}
    assert shown == {name: BOUNDS[name]["best"]["fused"][1] for name in shown}
    assert len(shown) == 5
    assert f"proved to {BOUNDS['polar_moment']['1e-6']['fused'][0]}" in TEXT


(SCENE,) = (text for kind, text in BLOCKS if kind == "toml")


def run(path: Path, capsys: pytest.CaptureFixture[str], text: str, *options: str) -> dict[str, str]:
    """Write a scene file and run it: what its table tells."""
    path.write_text(text, encoding="utf-8")
    assert main(["run", str(path), *options]) == 0
    lines = capsys.readouterr().out.splitlines()
    return dict(re.split(r"\s{2,}", line, maxsplit=1) for line in lines if re.search(r"\S\s{2,}\S", line))


def test_scene_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The file as it stands in the README, and with the arc of its comments: they run, and every effect is named."""
    path = tmp_path / "my-slope.toml"
    soil = SCENE[SCENE.index("[friction]") : SCENE.index("# [arc]")]
    of_arc = "".join(line[2:] for line in SCENE.splitlines(True) if re.match(r"# (\w+ = |\[\w+\] *(#|$))", line))
    for text in (SCENE, of_arc + soil):
        told = run(path, capsys, text)
        assert (told["moves"], told["comes to rest"]) == ("yes", "yes")
        motion = solve(load(str(path)))
        called = {"pore_pressure" if table == "water" else table for table in tomllib.loads(text)}
        assert motion.plan.effects == tuple(e for e in EFFECTS if e in called)
        assert all(f"[{e}]" in SCENE for e in motion.plan.left_out)  # in its comments
        assert main(["plan", "--ladder", str(path)]) == 0
        assert "my-slope" in capsys.readouterr().out


def test_from_a_profile_to_a_picture(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """One command tells of a slope in metres its factors, speed, run-out and where the toe rests, and draws them."""
    path, picture = tmp_path / "my-slope.toml", tmp_path / "my-slope.png"
    told = run(path, capsys, SCENE, "--plot", str(picture))
    assert all(told[n] for n in ("peak velocity", "duration", "factor of safety by Bishop's simplified method"))

    def place(*names: str) -> complex:
        return complex(*(float(x) for name in names for x in re.findall(r"[\d.]+", told[name])))

    centre, start = place("centre"), place("lower end of the slip surface, x and y")
    toe = place("x of the toe at the end", "y of the toe at the end")
    turned = place("run-out along the arc").real / place("radius").real  # clockwise, as it slides to the left
    assert abs(centre + (start - centre) * np.exp(-1j * turned) - toe) < 0.02  # of figures with two decimals
    assert picture.read_bytes().startswith(b"\x89PNG")
    axes = plots.overview(solve(load(str(path)))).axes
    (section,) = (ax for ax in axes if ax.get_xlabel() == "$x$ (m)")
    assert section.get_aspect() == 1.0  # true scale
    drawn = [p for line in section.lines for p in np.asarray(line.get_xydata()).tolist()]
    assert all(p in drawn for p in tomllib.loads(SCENE)["ground"]["points_m"][1:3])


def test_ladder_of_the_readme() -> None:
    """Peak, run-out and duration in the README's ladder are today's."""
    (shown,) = (text for _, text in BLOCKS if "effect added" in text)
    for rung in ladder(load("vaiont")):
        line = next(x for x in shown.splitlines() if x.strip().startswith(f"+ {rung.added}" if rung.added else "none"))
        run_out, peak, duration = (float(x) for x in re.findall(r"([\d.]+) (?:m/s|m|s)(?=\s)", line))
        assert np.allclose([peak, run_out, duration], [rung.peak_velocity, rung.run_out, rung.duration], rtol=2e-3)


def test_shape() -> None:
    assert len(TEXT.splitlines()) < 200


# --- what it was validated against -----------------------------------------------------------------------------------

# Rows of the table: what, against what, largest error, test.
VALIDATED = [line.split("|")[1:-1] for line in TEXT.splitlines() if re.search(r"\| \[`test_\w+`\]\(tests/", line)]


def test_every_row_of_the_validation_names_a_test_that_exists() -> None:
    assert len(VALIDATED) == 10
    for row in VALIDATED:
        ((name, file),) = re.findall(r"\[`(\w+)`\]\((\S+)\)", row[3])
        assert re.search(rf"^def {name}\(", (ROOT / file).read_text("utf-8"), re.MULTILINE), row


def energy_error(motion: Motion) -> float:
    energy = motion.energy_at(np.linspace(0.0, motion.duration, 9))
    return float(np.max(np.abs(energy.residual)) / max(np.max(np.abs(energy.work)), np.max(energy.dissipation)))


def test_the_largest_errors_are_those_of_the_readme() -> None:
    """Those that take seconds to find again. Rounding is not the same on every machine: within a factor of 3."""
    shown = {row[3].split("`")[1]: float(row[2].split()[0].rstrip(";")) for row in VALIDATED[:-1]}
    numbers = [k for k in test_accuracy.NUMBERS if not test_accuracy.near_limit(k)]
    numbers = [k for k in numbers if test_accuracy.ROWS[k]["reference"]["phases"] < test_accuracy.MANY]
    timed = [(test_time_scenes.solved(k), row["reference"]) for k, row in enumerate(test_time_scenes.ROWS)]
    found = {
        "test_true_errors_are_rounding": max(max(test_accuracy.error(k)) for k in numbers),
        "test_accuracy_is_what_the_user_gets": max(test_time_scenes.true_error(*pair) for pair in timed),
        "test_energy_balances_at_all_times": max(energy_error(motion) for motion, _ in timed),
    }
    if LEVELS[LEVEL][0] == "fused":
        alphas, kernel = test_kernels.angles(), generated.moment_of_inertia
        found["test_accuracy"] = test_kernels.errors(kernel, "moment_of_inertia", alphas)[0][0]
    for name, error in found.items():
        assert shown[name] / 3 < error < shown[name] * 3, (name, error)


# --- links -----------------------------------------------------------------------------------------------------------

LINK = re.compile(r"\]\(([^()\s]+)\)|(?<!\]\()(\bhttps?:/*[^\s<>\"'`]+)")  # [words](target), or a bare address


def documents() -> Iterator[tuple[Path, str]]:
    """Every text that a person reads: documents, notebooks' words, docstrings and comments, scene files."""
    yield from ((p, p.read_text("utf-8")) for p in [*ROOT.glob("*.md"), ROOT / "CITATION.cff", ROOT / "pyproject.toml"])
    for path in ROOT.glob("notebooks/*.ipynb"):
        cells = json.loads(path.read_text("utf-8"))["cells"]
        yield path, "\n".join("".join(c["source"]) for c in cells)
    for folder in ("derive", "slipcircle"):
        yield from ((p, p.read_text("utf-8")) for p in sorted((ROOT / folder).rglob("*.py")))
    yield from ((p, p.read_text("utf-8")) for p in ROOT.glob("slipcircle/scenes/*.toml"))


def bad_links(path: Path, text: str) -> list[str]:
    """Links that lead nowhere here, and addresses that are none, or not https."""
    found = []
    for relative, address in LINK.findall(text):
        target = relative or address.rstrip(".,;)")
        if ":" in target:
            parts = urlsplit(target)
            good = parts.scheme == "https" and re.fullmatch(r"([a-z0-9-]+\.)+[a-z]{2,}", parts.netloc) is not None
        else:
            good = path.suffix == ".py" or (path.parent / target.partition("#")[0]).exists()
        found += [] if good else [target]
    return found


def test_links() -> None:
    seen = {str(p.relative_to(ROOT)): bad_links(p, text) for p, text in documents()}
    assert not {name: links for name, links in seen.items() if links}
    assert len(seen) > 100
    assert any("https://" in text for _, text in documents())


@pytest.mark.parametrize("link", ["[a](missing.md)", "http://example.org/a", "[a](https://here/a)", "https:/a.org/x"])
def test_a_link_that_leads_nowhere_is_seen(link: str) -> None:
    assert bad_links(README, f"See {link}.")


def test_headings_that_links_point_at() -> None:
    """Anchors in the README's own links are headings of it."""
    heads = {re.sub(r"[^\w -]", "", h.lower()).replace(" ", "-") for h in re.findall(r"^#+ (.*)", TEXT, re.MULTILINE)}
    assert set(re.findall(r"\]\(#([^)]+)\)", TEXT)) <= heads


# --- what stands beside the README -----------------------------------------------------------------------------------


def test_citation() -> None:
    """Its keys are those that the format asks for, and what it shares with the project's file is the same there."""
    text, project = (ROOT / "CITATION.cff").read_text("utf-8"), tomllib.loads((ROOT / "pyproject.toml").read_text())
    keys = dict(re.findall(r"^([a-z-]+):[ ]?(.*)", text, re.MULTILINE))
    assert {"cff-version", "message", "title", "authors"} <= set(keys)
    known = project["project"]
    assert keys["cff-version"] == "1.2.0"
    assert keys["version"].strip('"') == known["version"] == slipcircle.__version__
    assert keys["license"] == known["license"]
    assert re.findall(r"^  - name: \"(.*)\"", text, re.MULTILINE) == [a["name"] for a in known["authors"]]
    assert re.findall(r"^  - (?!name|type)\"?(.*?)\"?$", text, re.MULTILINE) == known["keywords"]
    assert re.search(r"^references:\n  - type: generic\n    title: .*Dynamic Slip Circle Method", text, re.MULTILINE)


def test_every_module_says_what_lives_there() -> None:
    for folder in ("derive", "slipcircle", "generated", "tests"):
        for path in sorted((ROOT / folder).rglob("*.py")):
            assert ast.get_docstring(ast.parse(path.read_text("utf-8"))), path
