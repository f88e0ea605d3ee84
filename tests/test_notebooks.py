"""The notebooks run from their tops, print what they hold, and their numbers are the package's.

``./run python tests/test_notebooks.py [NUMBER ...]`` stores fresh outputs, with the figures. The tests compare of
these what titles, axes and legends say, and do not compare what cells print whose ids start with "timed": it holds
measured times.
"""

import base64
import gc
import io
import json
import math
import os
import sys
import tempfile
import warnings
from collections.abc import Callable
from functools import cache, wraps
from pathlib import Path
from typing import Any
from unittest import mock

import matplotlib
import nbformat
import pytest
from matplotlib import pyplot as plt
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from derive import progress
from derive.check import certify
from derive.check.proof import ProofError
from derive.check.records import Record
from derive.flow.recurrences import OPERATIONS as SERIES
from generated.effects import EFFECTS, LAWS
from slipcircle import Status, load, solve
from slipcircle.base import progress as progress_of_commands
from slipcircle.workbench.cost import rows as cost
from slipcircle.workbench.outputs.pictures.plotstyle import figure_texts
from slipcircle.workbench.outputs.report import ASSUMED
from tests.support.outputs import QUICK, words_of

ROOT = Path(__file__).parents[1]
NOTEBOOKS = sorted((ROOT / "notebooks").glob("*.ipynb"))
undescribed: Any = FigureCanvasAgg.print_png
prove = certify.prove
METADATA = {
    "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
    "language_info": {"name": "python"},
}
each_notebook = pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)


@cache
def kernel() -> Any:
    """IPython in this process, which has most of what notebooks import, without history and settings of the user."""
    from ipykernel.inprocess.manager import InProcessKernelManager
    from traitlets.config import Config

    manager = InProcessKernelManager(config=Config(HistoryManager={"enabled": False}))
    manager.start_kernel()
    with warnings.catch_warnings(action="ignore"):  # the inline backend's, when it is made
        manager.kernel.shell.run_line_magic("matplotlib", "inline")
    return manager.kernel


def executed(source: str) -> list[Any]:
    """Return the outputs of a cell; all printed text is joined at its first place."""
    client = kernel().parent.client()
    client.start_channels()
    client.execute(source)
    for stream in (kernel().stdout, kernel().stderr):
        stream.flush()
    outputs: list[Any] = []
    for message in client.iopub_channel.get_msgs():
        if message["msg_type"] in ("stream", "display_data", "execute_result", "error"):
            output = nbformat.v4.output_from_msg(message)
            before = [other for other in outputs if other.get("name") == output.get("name", "")]
            if before:
                before[0].text += output.text
            else:
                outputs.append(output)
    client.stop_channels()
    return outputs


@cache
def blank() -> Any:
    """Return the canvas of the smallest picture."""
    return FigureCanvasAgg(Figure((1, 1), dpi=1))


def print_nothing(canvas: Any, target: Any, **more: Any) -> None:
    """Replace the drawing of a picture by its layout and texts."""
    if canvas.figure.get_layout_engine() is None or "draw" in vars(canvas.figure):  # as where it is laid out
        undescribed(canvas, io.BytesIO())
    undescribed(blank(), target, metadata={"Description": "\n".join(figure_texts(canvas.figure))})


@wraps(undescribed)
def print_png(canvas: Any, target: Any, **more: Any) -> None:
    """Pictures say in the file what their legends and axes say, as those of commands do."""
    undescribed(canvas, target, **more | {"metadata": {"Description": "\n".join(figure_texts(canvas.figure))}})


def run(path: Path, first: str = "", draw: Callable[..., None] = print_png) -> Any:
    """Return the notebook, run from its top, after what is to be run ``first``; nothing volatile is left in it.

    Lines of progress are no output: how many there are depends on the machine.
    """
    notebook = nbformat.read(path, as_version=4)
    with (
        tempfile.TemporaryDirectory() as folder,
        mock.patch.dict(os.environ, IPYTHONDIR=folder, PYDEVD_DISABLE_FILE_VALIDATION="1"),
        pytest.MonkeyPatch.context() as patch,
        matplotlib.rc_context(),
    ):
        patch.setitem(sys.modules, "__main__", sys.modules["__main__"])  # IPython puts its namespace there
        patch.chdir(folder)
        patch.setattr(FigureCanvasAgg, "print_png", draw)
        patch.setattr(gc, "collect", lambda *_: 0)  # twice in every reset
        patch.setattr(progress, "FIRST", math.inf)
        patch.setattr(progress_of_commands, "_SELDOM", math.inf)
        matplotlib.rcdefaults()
        assert not executed(f"%reset -f\n{first}")
        for cell in notebook.cells:
            cell.metadata = {"tags": cell.metadata.tags} if "tags" in cell.metadata else {}
            if cell.cell_type == "code":
                cell.execution_count, cell.outputs = None, executed(cell.source)
                failed = [output for output in cell.outputs if output.output_type == "error"]
                assert not failed, "\n".join(failed[0].traceback)  # as of a picture that cannot be displayed
                for output in cell.outputs:
                    if output.output_type == "execute_result":
                        output.execution_count = None
        plt.switch_backend("agg")
    notebook.metadata = METADATA
    return notebook


def texts(cell: Any) -> list[Any]:
    """Return the texts of a cell by stream and display; of a picture, the texts of its axes and legends."""
    said = []
    for output in cell.get("outputs", []):
        if output.output_type == "stream":
            said.append({output.name: output.text})
        else:
            data = output.get("data", {})
            said.append({kind: pictured(text) if kind == "image/png" else text for kind, text in data.items()})
    return said


def pictured(image: str) -> Any:
    return words_of(base64.b64decode(image))


def pictures(cell: Any) -> list[Any]:
    """Return the texts of a cell's pictures."""
    return [said["image/png"] for said in texts(cell) if "image/png" in said]


@cache
def stored(name: str) -> Any:
    """Return the notebook as it is kept; that a fresh run prints the same has its own test."""
    return nbformat.read(ROOT / "notebooks" / name, as_version=4)


def key_numbers(name: str) -> Any:
    """Return the numbers that the notebook's last cell prints."""
    return json.loads(printed(stored(name), "key-numbers"))


def printed(notebook: Any, cell_id: str) -> str:
    """Return the printed text of the cell with this id."""
    (cell,) = (cell for cell in notebook.cells if cell.id == cell_id)
    return "".join(output.text for output in cell.outputs if output.output_type == "stream")


@cache
def outcome(record: str) -> float | ProofError:
    """Return the outcome of proving a certificate; two notebooks show the same certificates."""
    try:
        return prove(json.loads(record))
    except ProofError as refusal:
        return refusal


def prove_once(record: Record) -> float:
    if isinstance(found := outcome(json.dumps(record)), ProofError):
        raise found
    return found


@each_notebook
def test_outputs_are_those_of_a_fresh_run(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for name, value in QUICK.items():
        monkeypatch.setattr(cost, name, value)
    monkeypatch.setattr(certify, "prove", prove_once)
    # Pictures are laid out once, not a first time to see how large they are.
    once = "%config InlineBackend.print_figure_kwargs = {'bbox_inches': None}"
    kept, fresh = stored(path.name), run(path, once, print_nothing)
    stale = "stale; to store fresh outputs: ./run python tests/test_notebooks.py"
    for old, new in zip(kept.cells, fresh.cells, strict=True):
        timed = old.id.startswith("timed")
        shown, again = (pictures(cell) if timed else texts(cell) for cell in (old, new))
        assert shown == again, f"{path.name}, cell {old.id}: {stale}"
        assert not any("stderr" in said for said in texts(new)), f"{path.name}, cell {new.id} warns"


@each_notebook
def test_source_diffs_well(path: Path) -> None:
    notebook = nbformat.read(path, as_version=4)
    nbformat.validate(notebook)
    assert (notebook.nbformat, notebook.nbformat_minor) == (4, 5)
    assert notebook.metadata == METADATA
    assert path.read_text(encoding="utf-8") == written(notebook)
    assert not any(cell.get("execution_count") for cell in notebook.cells)
    hidden = {cell.id: cell.metadata.pop("tags", []) for cell in notebook.cells}  # what the book folds away
    assert hidden["imports"] == ["hide-input"]
    assert hidden["key-numbers"] == ["hide-cell"]
    assert not any(cell.metadata for cell in notebook.cells)
    for cell in notebook.cells:
        for output in cell.get("outputs", []):
            assert len(output.get("data", {}).get("image/png", "")) < 80_000, "60 kB, in base 64"


def test_the_method_names_every_effect_law_and_operation() -> None:
    notebook = stored("0_the_method.ipynb")
    shown = "".join(str(texts(cell)) for cell in notebook.cells)
    assert all(f"| `{name}` |" in shown for name in (*EFFECTS, *LAWS, *SERIES, *Status.__members__))
    cited = shown + "".join(cell.source for cell in notebook.cells)
    assert all(claim in cited for claim in ("(1.1)", "(2.20)", "(3.11)", "(3.13)", "(3.20)", "(3.21)", *ASSUMED))


@pytest.mark.parametrize(
    ("name", "cell", "words", "times"),
    [("0_the_method", "frozen", "True", 2), ("0_the_method", "frozen", "as printed it does: False", 1),
     ("1_derivation", "picture", "one line, as it stands: finite at 31 of 32 angles", 1),
     ("1_derivation", "picture", "certified kernel: within its proved bound everywhere: True", 1),
     ("1_derivation", "source", "as checked in: True", 1),
     ("1_derivation", "certificate", "of these programs: True", 1), ("1_derivation", "certificate", "refused", 2),
     ("3_what_accuracy_costs", "accuracy", "True", 3),
     ("3_what_accuracy_costs", "accuracy", "refused: radial_weight_amplitude cannot promise", 1),
     ("3_what_accuracy_costs", "certificate", "refused,", 2)],
)  # fmt: skip
def test_cells_confirm_what_their_text_claims(name: str, cell: str, words: str, times: int) -> None:
    assert printed(stored(f"{name}.ipynb"), cell).count(words) == times


def test_key_numbers_of_the_slope() -> None:
    numbers, scene = key_numbers("6_from_a_slope_to_a_slide.ipynb"), load("real-slope")
    assert numbers["factors"]["bishop"] == 0.985  # as converged by others
    motion = solve(scene)
    shown = [motion.peak.velocity, motion.duration, motion.journey.run_out]
    assert numbers["slides"]["bishop"][2:] == pytest.approx(shown, abs=6e-5)
    title = stored("6_from_a_slope_to_a_slide.ipynb").cells[0].source
    for words in (f"**{shown[0]:.1f} m/s**", f"**{shown[1]:.1f} s**", f"**{shown[2]:.1f} m**", "**0.985**", "0.942"):
        assert words in title
    assert numbers["moving"] == pytest.approx(0.59, abs=0.005)  # as its title says
    strips, _, uniform = numbers["closures"].values()
    assert uniform[0] / strips[0] == pytest.approx(1.14, abs=0.005)  # as its text says
    total = numbers["total_index"]
    assert max(total, key=total.get) == "cohesion.cohesion_kPa"  # which decides most, as its last section says


def written(notebook: Any) -> str:
    """Return the text of a notebook in its stored format."""
    return str(nbformat.writes(notebook)) + "\n"


if __name__ == "__main__":
    for notebook_path in [p for p in NOTEBOOKS if not sys.argv[1:] or p.name[0] in sys.argv[1:]]:
        notebook_path.write_text(written(run(notebook_path)), encoding="utf-8", newline="\n")
        print(f"stored {notebook_path.relative_to(ROOT)}", file=sys.stderr)
