"""Record of the compiler's last run: what is unchanged is not derived again, and a change of anything misses it."""

import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest

from derive import __main__ as command
from derive import stages
from derive.check.proof import ProofError
from derive.generate import write

TEXTS = {"a.py": "1", "b.py": "2"}
SOURCES = ("code/templates/_flow.c", "declare/quantities.py", "flow/link/linker.py", "check/losses.py", "__main__.py")


@pytest.fixture
def copy(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """Return the compiler elsewhere, with the record of a run."""
    ignored = shutil.ignore_patterns("__pycache__")
    shutil.copytree(stages.ROOT / "derive", tmp_path / "derive", ignore=ignored)
    monkeypatch.setattr(stages, "ROOT", tmp_path)
    monkeypatch.setattr(stages, "RECORD", tmp_path / "stages.json")
    stages.save(TEXTS)
    assert stages.record(TEXTS) == stages.recorded()
    yield tmp_path / "derive"
    assert stages.record(TEXTS) == stages.recorded()


@pytest.mark.parametrize("source", SOURCES)
def test_a_changed_source_misses_the_record(copy: Path, source: str) -> None:
    text = (copy / source).read_text("utf-8")
    (copy / source).write_text(f"{text}\n", "utf-8")
    assert stages.record(TEXTS) != stages.recorded()
    (copy / source).write_text(text, "utf-8")
    (copy / "new.py").write_text("", "utf-8")
    assert stages.record(TEXTS) != stages.recorded()
    (copy / "new.py").unlink()


def test_changed_files_and_libraries_miss_the_record(copy: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for texts in ({**TEXTS, "b.py": "3"}, {"a.py": "1"}, {**TEXTS, "c.py": ""}):
        assert stages.record(texts) != stages.recorded()
    with monkeypatch.context() as changed:
        changed.setattr(stages, "version", lambda _: "1.13.3")
        assert stages.record(TEXTS) != stages.recorded()


@pytest.mark.parametrize("text", ["", "<<<<<<< HEAD\n{}", None])
def test_without_a_record_everything_is_derived(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, text: str | None
) -> None:
    """A record that cannot be read is like none."""

    def derived() -> dict[str, str]:
        raise ProofError("derived", "it")

    monkeypatch.setattr(command, "derive_all", derived)
    monkeypatch.setattr(stages, "RECORD", tmp_path / "stages.json")
    stages.save(write.present_files())
    assert command.main(["--check"]) == 0
    stages.RECORD.unlink()
    if text is not None:
        stages.RECORD.write_text(text, "utf-8")
    assert stages.recorded() == {}
    assert command.main(["--check"]) == 1


def test_other_versions_are_named_before_anything_is_derived(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    recorded = stages.recorded()["versions"]
    written = recorded["sympy"]
    monkeypatch.setattr(stages, "version", lambda x: "1.13.3" if x == "sympy" else recorded[x])
    monkeypatch.setattr(command, "generate", lambda *_: 0)
    assert command.main([]) == 0
    remedy = f"pip install sympy=={written}"
    assert capsys.readouterr().err == f"SymPy 1.13.3 is installed, but SymPy {written} wrote generated/: {remedy}\n"
    assert command.main(["theorem", "--friction-deg", "89"]) == 0
    assert not capsys.readouterr().err
