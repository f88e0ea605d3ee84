"""The notebooks run in a fresh kernel, print what they hold, and their numbers are the package's.

``./run python tests/test_notebooks.py`` stores fresh outputs, with the figures, which the tests do not compare.
"""

import json
import os
import sys
import tempfile
from functools import cache
from pathlib import Path
from typing import Any

import nbformat
import oracle
import pytest
from nbclient import NotebookClient

import generated

ROOT = Path(__file__).parents[1]
NOTEBOOKS = sorted((ROOT / "notebooks").glob("*.ipynb"))
METADATA = {
    "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
    "language_info": {"name": "python"},
}
each_notebook = pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)


@cache
def run(path: Path) -> Any:
    """The notebook, run in a fresh kernel that knows no settings of the user; nothing volatile is left in it."""
    notebook = nbformat.read(path, as_version=4)
    with tempfile.TemporaryDirectory() as folder:
        # The kernel draws inline whatever the backend here, and keeps no history.
        env = {name: value for name, value in os.environ.items() if name not in ("MPLBACKEND", "MATPLOTLIBRC")}
        env |= {"IPYTHONDIR": folder, "PYTHONPATH": str(ROOT), "PYTHONWARNINGS": "default"}
        client = NotebookClient(
            notebook,
            timeout=60,
            kernel_name="python3",
            record_timing=False,
            coalesce_streams=True,
            extra_arguments=["--log-level=ERROR"],
            resources={"metadata": {"path": folder}},
        )
        client.execute(env=env)
    notebook.metadata = METADATA
    for cell in notebook.cells:
        cell.metadata = {}
        if cell.cell_type == "code":
            cell.execution_count = None
            for output in cell.outputs:
                output.pop("execution_count", None)
                if output.output_type == "execute_result":
                    output.execution_count = None
    return notebook


def texts(cell: Any) -> list[Any]:
    """What a cell says, stream by stream and display by display; of a picture, only that it is there."""
    said = []
    for output in cell.get("outputs", []):
        if output.output_type == "stream":
            said.append({output.name: output.text})
        else:
            data = output.get("data", {})
            said.append({kind: "" if kind.startswith("image/") else text for kind, text in data.items()})
    return said


def printed(notebook: Any, cell_id: str) -> str:
    """What the cell of this id printed."""
    (cell,) = (cell for cell in notebook.cells if cell.id == cell_id)
    return "".join(output.text for output in cell.outputs if output.output_type == "stream")


@each_notebook
def test_outputs_are_those_of_a_fresh_run(path: Path) -> None:
    stored, fresh = nbformat.read(path, as_version=4), run(path)
    stale = "stale; to store fresh outputs: ./run python tests/test_notebooks.py"
    for old, new in zip(stored.cells, fresh.cells, strict=True):
        assert texts(old) == texts(new), f"{path.name}, cell {old.id}: {stale}"
        assert not any("stderr" in said for said in texts(new)), f"{path.name}, cell {new.id} warns"


@each_notebook
def test_source_diffs_well(path: Path) -> None:
    notebook = nbformat.read(path, as_version=4)
    nbformat.validate(notebook)
    assert (notebook.nbformat, notebook.nbformat_minor) == (4, 5)
    assert notebook.metadata == METADATA
    assert not any(cell.metadata or cell.get("execution_count") for cell in notebook.cells)
    assert path.read_text(encoding="utf-8") == written(notebook)
    for cell in notebook.cells:
        for output in cell.get("outputs", []):
            assert len(output.get("data", {}).get("image/png", "")) < 80_000, "60 kB, in base 64"


def test_key_numbers_of_the_derivation() -> None:
    notebook = run(ROOT / "notebooks" / "1_derivation.ipynb")
    numbers = json.loads(printed(notebook, "key-numbers"))
    assert set(numbers) == {"C_r", "closed_form", "operations", "appendix_I_operations"}
    assert len(numbers["C_r"]) == 5
    for alpha, text in numbers["C_r"].items():
        reference = oracle.kernel("radial_weight_amplitude", float(alpha))
        assert oracle.ulps(float(text), reference) <= 0.5 + 1e-9
        assert oracle.ulps(float(generated.radial_weight_amplitude(float(alpha))), reference) < 16
    doc = " ".join((generated.radial_weight_amplitude.__doc__ or "").split())
    assert f"C_r = {numbers['closed_form']} " in doc
    assert f"Operations: {numbers['operations']}." in doc
    before, after = numbers["appendix_I_operations"]
    assert before > 50 * after
    assert "one line, as it stands: finite at 61 of 62 angles" in printed(notebook, "picture")
    assert "generated: error below 16 ulp everywhere: True" in printed(notebook, "picture")
    assert "as checked in: True" in printed(notebook, "source")
    assert "Vaiont: 2.413 MPa" in printed(notebook, "use")


def written(notebook: Any) -> str:
    """Its text, as these files are written."""
    return str(nbformat.writes(notebook)) + "\n"


if __name__ == "__main__":
    for notebook_path in NOTEBOOKS:
        notebook_path.write_text(written(run(notebook_path)), encoding="utf-8", newline="\n")
        print(f"stored {notebook_path.relative_to(ROOT)}", file=sys.stderr)
