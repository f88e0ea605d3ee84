"""Three weights, drawn at random, are declared in a copy: what follows (`python tests/all_weights.py`: all 15)."""

import json
import random
from pathlib import Path

import all_weights


def test_three_weights_give_everything(tmp_path: Path) -> None:
    """Closed form, certificates within the goals, and no error beside quadrature that is more than proved.

    The search judges fewer shapes than it may, and nothing is compiled, as either takes its time.
    """
    drawn = random.SystemRandom().sample(all_weights.WEIGHTS, 3)
    found = all_weights.follow(tmp_path, drawn, "--trials", "14", SLIPCIRCLE_COMPILED="0")
    assert set(found) == set(map(all_weights.kernel, drawn))
    assert not all_weights.faults(found), drawn
    for weight in drawn:
        path = tmp_path / "generated" / "certificates" / f"{all_weights.kernel(weight)}.json"
        bounds = {(r["tier"], r["form"]): r["bound"] for r in json.loads(path.read_text("utf-8"))["certificates"]}
        assert bounds["best", "fused"] <= 1, weight


def test_a_changed_weight_changes_the_kernel(tmp_path: Path) -> None:
    """r**2 in the place of r**3: another closed form, another program, another certificate."""
    all_weights.copy(tmp_path)
    path = tmp_path / "derive" / "declare" / "quantities.py"
    path.write_text(path.read_text("utf-8").replace('"3.12", r**3', '"3.12", r**2'), "utf-8")
    code = (
        "from derive.approximate import programs, shapes; from derive.approximate.programs import variants; "
        "shapes.records().setdefault(('r^2', 'r^2'), shapes.records()['r^2 cos u', 'r^3']); "
        "shapes.records().setdefault(('r^2 cos u', 'r^2'), shapes.records()['r^2 cos u', 'r^3']); "
        "shapes.records().setdefault(('r^1 cos u', 'r^2'), shapes.records()['r^1 cos u', 'r^3']); "
        "found = {v.kernel: v for v in variants() if (v.tier, v.form) == ('best', 'fused')}; "
        "print(found['moment_of_inertia'].program.ops == found['polar_moment'].program.ops, "
        "*found['moment_of_inertia'].definition)"
    )
    done = all_weights.run(tmp_path, "-c", code)
    assert done.stdout.split() == ["True", "r^2"], done.stderr
