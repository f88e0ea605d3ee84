"""Stored promises: names of Python, commands, scene files and output for machines."""

from pathlib import Path

from tests.support import promises

ROOT = Path(__file__).parents[1]
STORED = {*promises.FILE.read_text("utf-8").splitlines()}
CHANGELOG = (ROOT / "CHANGELOG.md").read_text("utf-8")


def test_nothing_promised_is_gone_unannounced() -> None:
    """Promised names are present or announced as removed; new names belong to the next release."""
    assert promises.unannounced(STORED - promises.promises(), CHANGELOG) == set()


def test_only_a_removal_by_its_name_is_announced() -> None:
    gone = {"slipcircle.Motion.at(times)", "run --json peak.velocity", "slipcircle run --csv"}
    for name in gone:
        assert promises.unannounced(gone, f"### Removed\n\n- `{name}`; see `solve`.\n") == gone - {name}
        assert promises.unannounced(gone, f"### Added\n\n- `{name}`\n\n### Removed\n\n- `plan`\n") == gone
        assert promises.unannounced(gone, f"### Removed\n\n- {name}\n") == gone
    whole = "### Removed\n\n- `slipcircle.Motion.at`, `run --json peak`\n\n## [0.0.1]\n"
    assert promises.unannounced(gone, whole) == {"slipcircle run --csv"}


def test_the_list_has_names_of_every_kind() -> None:
    """The list has names of every kind, such as the README's."""
    assert {
        "generated.polar_moment(accuracy)",
        "slipcircle.Motion.slow_run_out",
        "slipcircle.Scene(friction)",
        "slipcircle.solve(scene)",
        "slipcircle.Status.RESTS",
        "slipcircle run --live",
        "scene vaiont",
        "[scene file].ground.height_m",
        "[friction_exponential].peak_deg",
        "run --json format",
        "run --json energy.residual",
        "run --csv velocity_m_s",
        "extra plot",
    } <= STORED
