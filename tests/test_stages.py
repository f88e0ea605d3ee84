"""Records of the compiler's stages: a changed input misses its record, and nothing else does."""

import shutil
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
import sympy as sp

from derive import __main__ as command
from derive import stages
from derive.algebra import integrate
from derive.declare.effects import EFFECTS, LAWS, SECTION_EFFECTS
from derive.declare.quantities import MOMENTS

CASE = (EFFECTS[:1], LAWS[:1])
STAGES: dict[str, tuple[str, str, tuple[Any, ...]]] = {
    "declare": ("derive.guards", "check_alone", LAWS[:1]),
    "integrate": ("derive.algebra.integrate", "recorded", MOMENTS[:1]),
    "balance": ("derive.flow.linked", "prove_case", CASE),
    "series": ("derive.flow.recurrences", "prove", (6,)),
    "flow files": ("derive.generate.write", "flow_files", (LAWS, EFFECTS, SECTION_EFFECTS)),
    "kernel files": ("derive.generate.write", "kernel_files", ()),
    "both ends": ("derive.check.losses", "certificate", ("J_r", {"bound": 1.0})),
}
FILES = ("flow files", "kernel files")
LAW = '    Law("another", "peak", _SOFTENING[:1], coefficient=_P),\n)  # fmt: skip'
MOMENT = '    Moment("area", "S*", r, "area"),\n)  # fmt: skip'
# Place of a change: text that is replaced, and the stages that run again.
CHANGES = {
    "derive/code/templates/_flow.c": ("return", " return", {"declare", *FILES}),
    "derive/declare/effects.py": (")  # fmt: skip", LAW, {"kernel files"}),
    "derive/declare/quantities.py": (")  # fmt: skip", MOMENT, {"kernel files"}),
    "derive/flow/link/linker.py": ("def ", "def  ", {"balance", *FILES}),
    "derive/flow/integrator/step.py": ("if ", "if  ", {*FILES}),
    "derive/algebra/prove.py": ("def ", "def  ", {*STAGES} - {"both ends"}),
    "derive/check/losses.py": ("def ", "def  ", {"both ends", *FILES}),
    "derive/judge/verify.py": ("def ", "def  ", set[str]()),
}


def forget() -> None:
    for cached in (stages._needs, stages.sources, stages._text, stages._own):
        cached.cache_clear()


@pytest.fixture
def copy(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """Return the compiler elsewhere."""
    ignored = shutil.ignore_patterns("__pycache__")
    shutil.copytree(stages.ROOT / "derive", tmp_path / "derive", ignore=ignored)
    monkeypatch.setattr(stages, "ROOT", tmp_path)
    forget()
    yield tmp_path
    forget()


def digests() -> dict[str, str]:
    forget()
    return {name: stages.inputs(*stage) for name, stage in STAGES.items()}


def test_each_change_runs_the_stages_that_depend_on_it(copy: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    before = digests()
    for place, (old, new, changed) in CHANGES.items():
        path = copy / place
        text = path.read_text("utf-8")
        path.write_text(text.replace(old, new, 1), "utf-8")
        after = digests()
        assert {name for name in STAGES if after[name] != before[name]} == changed, place
        path.write_text(text, "utf-8")
    assert digests() == before
    module, name, (moment,) = STAGES["integrate"]
    assert stages.inputs(module, name, (replace(moment, weight=2 * moment.weight),)) != before["integrate"]
    module, name, (laws, *effects) = STAGES["flow files"]
    for others in ((laws[:-1], *effects), (laws, *effects[::-1]), (laws, effects[0], effects[1][:-1])):
        assert stages.inputs(module, name, others) != before["flow files"]
    monkeypatch.setattr(stages, "version", lambda _: "1.13.3")
    assert not {*digests().values()} & {*before.values()}


@pytest.mark.parametrize("fault", ["a file was edited", "a file is missing", "a source was edited", "none"])
def test_only_files_that_match_their_record_are_kept(fault: str, monkeypatch: pytest.MonkeyPatch) -> None:
    run = stages.Stages(again=True)
    texts = {"a.py": "1", "b.py": "2"}
    monkeypatch.setattr(integrate, "written", lambda _: texts, raising=False)
    work = "derive.algebra.integrate:written"
    assert run.files("all", work, {}) == texts
    run.known = dict(run.records)
    present = dict(texts)
    if fault == "a file was edited":
        present["b.py"] = "3"
    elif fault == "a file is missing":
        del present["b.py"]
    elif fault == "a source was edited":
        monkeypatch.setattr(stages, "inputs", lambda *_: "another digest")
    again = {"a.py": "derived again"}
    monkeypatch.setattr(integrate, "written", lambda _: again)
    assert run.files("all", work, present) == (texts if fault == "none" else again)


def test_a_recorded_derivation_is_the_derivation() -> None:
    for moment in MOMENTS:
        right = integrate.derivation(moment)
        integrate._DERIVED[moment] = right
        record = integrate.recorded(moment)
        integrate._DERIVED.clear()
        integrate.restore(moment, record)
        restored = integrate.derive(moment)
        assert restored == right
        assert [*map(hash, sp.preorder_traversal(restored.closed))] == [*map(hash, sp.preorder_traversal(right.closed))]
        assert integrate._DERIVED.pop(moment) is not right


def test_other_versions_are_named_before_anything_is_derived(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    written = stages.Stages().written_with["sympy"]
    monkeypatch.setattr(stages, "version", lambda x: "1.13.3" if x == "sympy" else stages.Stages().written_with[x])
    monkeypatch.setattr(command, "generate", lambda *_: 0)
    assert command.main([]) == 0
    remedy = f"pip install sympy=={written}"
    assert capsys.readouterr().err == f"SymPy 1.13.3 is installed, but SymPy {written} wrote generated/: {remedy}\n"
    assert command.main(["theorem", "--friction-deg", "89"]) == 0
    assert not capsys.readouterr().err
