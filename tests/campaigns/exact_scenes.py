"""Answers to the scenes and sections of the price list, to 24 digits: scenes by Taylor series, sections by strips.

``python -m tests.campaigns.exact_scenes`` writes them; `test_cost` makes some of them again.
"""

import json
from typing import Any

from slipcircle.workbench.cost import sections
from slipcircle.workbench.cost.scenes import ANSWERS, CASES, scene
from tests.support import oracle, taylor
from tests.support.strips import integrals


def texts(name: str, friction: float) -> tuple[str, ...]:
    """Run-out, peak velocity and duration as decimals."""
    asked: Any = scene(name, friction)
    effects: dict[str, Any] = dict(asked.called)
    if "shaking" in effects:
        record = effects["shaking"]["horizontal"]
        effects["shaking"] = {"time": record.time.tolist(), "horizontal": record.values.tolist()}
    given = {"arc": oracle.plain(asked.arc), "friction": asked.friction, "effects": effects, "initial_velocity": 0.0}
    found = taylor.solve(given | {"end_time": asked.end_time}, digits=24)
    return tuple(found[key] for key in ("run_out", "peak_velocity", "duration"))


def written(known: dict[str, dict[str, Any]]) -> str:
    """The file of the answers to these frictions, as it is to be."""
    made = {name: {mu: texts(name, float(mu)) for mu in of} for name, of in known.items()}
    return json.dumps(made, indent=1) + "\n"


def measures() -> str:
    """The file of the measures of sections, as it is to be, by strips in ball arithmetic."""
    found = (
        integrals(sections.GROUND.tolist(), (x, y), r) for x, y, r, *_ in sections.drawn(sections.COUNT).T.tolist()
    )
    texts = zip(*([v.mid().str(24, radius=False) for v in one.values()] for one in found), strict=True)
    return json.dumps([*texts], indent=1) + "\n"


if __name__ == "__main__":
    known = json.loads(ANSWERS.read_text("utf-8"))
    # A new case takes the frictions of another.
    ANSWERS.write_text(written({name: known.get(name, known["constant friction"]) for name in CASES}), "utf-8")
    sections.ANSWERS.write_text(measures(), "utf-8")
