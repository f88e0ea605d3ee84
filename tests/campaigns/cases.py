"""Verdicts on the cases of notebooks/cases: what comes out of the method beside what was observed or published.

``python -m tests.campaigns.cases`` prints them as Markdown, which the book shows. The rule: *inside* the observed
interval; *within a factor of 2* of its ends; *outside*; or *outside the method*, where the case says why it does not
apply, and the program what it answers.
"""

import tomllib
from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

from slipcircle import Status, load, solve
from tests.campaigns import layered_benchmarks

FOLDER = Path(__file__).parents[2] / "notebooks/cases"
# What may be observed: its words, and how it is read off a motion.
OBSERVABLE: Mapping[str, tuple[str, Callable[[Any], float]]] = {
    "run_out_m": ("run-out, m", lambda motion: motion.run_out),
    "toe_run_out_m": ("run-out of the toe, m", lambda motion: motion.journey.run_out),
    "peak_velocity_m_s": ("peak velocity, m/s", lambda motion: motion.peak.velocity),
    "duration_s": ("duration, s", lambda motion: motion.duration),
    "factor_of_safety": ("factor of safety", lambda motion: motion.factor_of_safety),
    "ordinary_factor": (
        "factor of safety, the ordinary method",
        lambda motion: motion.plan.scene.stability.factors_of_safety["ordinary"],
    ),
}
Row = tuple[str, str, float | None]  # a key, in words, what comes out


def mistakes(case: Mapping[str, Any]) -> Iterator[str]:
    """Return a line for each mistake in a case."""
    name = case.get("name", "a case without a name")
    if not case.get("source"):
        yield f"{name}: source is missing: name the public text that its numbers come from"
    for key, interval in case.get("observed", {}).items():
        if key not in OBSERVABLE:
            yield f"{name}: observed.{key}: is unknown; known are {', '.join(OBSERVABLE)}"
        elif len(interval) != 2 or not 0.0 <= interval[0] <= interval[1]:
            yield f"{name}: observed.{key} = {interval}: must be two numbers of at least 0, the lower one first"


def verdict(value: float, low: float, high: float) -> str:
    """Return the verdict on an interval of computed values by the rule of the page on cases."""
    if low <= value <= high:
        return "inside"
    return "within a factor of 2" if low / 2 <= value <= 2 * high else "outside"


def computed(case: Mapping[str, Any]) -> tuple[list[Row], str]:
    """Return observed quantities by key, each in words and as computed, and the warnings and refusals of the program.

    A published factor is set beside that of Bishop's method, and that of the paper's, from which motions start.
    """
    if "benchmark" in case:
        (given,) = (g for g in layered_benchmarks.CASES if g["name"] == case["benchmark"])
        factors = layered_benchmarks.solved(given).factors_of_safety
        methods = (("Bishop", "bishop"), ("the paper's method", "paper"))
        return [("factor_of_safety", f"factor of safety, {words}", factors[name]) for words, name in methods], ""
    path = FOLDER / f"{case['scene']}.toml"
    try:
        motion: Any = solve(load(path if path.exists() else case["scene"]))
    except ValueError as error:
        says = str(error).replace(str(path), path.name).partition("\n")[0]
        return [(key, OBSERVABLE[key][0], None) for key in case["observed"]], says
    says = "" if motion.status in (Status.RESTS, Status.STAYS) else f"{motion.status.words}: nothing holds it"
    return [(key, OBSERVABLE[key][0], float(OBSERVABLE[key][1](motion))) for key in case["observed"]], says


def judged(case: Mapping[str, Any], rows: Iterable[Row]) -> Iterator[tuple[str, str, str, str, str]]:
    """Return for each observed quantity its words, the interval, the computed value, their ratio and the verdict."""
    for key, words, value in rows:
        low, high = case["observed"][key]
        shown, ratio, decided = "none", "", "outside the method"
        if value is not None:
            shown, ratio = f"{value:.5g}", f"{200 * value / (low + high):.0f} %" if low else ""
            decided = decided if "outside" in case else verdict(value, low, high)
        yield words, f"{low:.7g} to {high:.7g}", shown, ratio, decided


def read(text: str) -> dict[str, list[dict[str, Any]]]:
    """Return the cases, and those that are missing.

    Raises
    ------
    ValueError
        Lists what is wrong with them, one line each.
    """
    cases = tomllib.loads(text)
    if found := [line for case in cases["case"] for line in mistakes(case)]:
        raise ValueError("\n".join(found))
    return cases


def report(cases: Mapping[str, Any]) -> Iterator[str]:
    """Lines of Markdown."""
    yield "# Cases\n\n## Verdicts\n"
    yield "| case | quantity | observed or published | computed | of the middle | verdict |\n|---|---|---|---|---|---|"
    solved = [(case, *computed(case)) for case in cases["case"]]
    for case, rows, _ in solved:
        for row in judged(case, rows):
            yield f"| {' | '.join([case['name'], *row])} |"
    yield "\n## Where the method does not apply\n"
    for case, _, says in solved:
        if "outside" in case:
            yield f"- **{case['name']}**: {case['outside']}." + (f" The program: `{says}`" if says else "")
    yield "\n## Sources\n"
    yield from (f"- **{case['name']}**: {case['source']}." for case in cases["case"])
    yield "\n## Not included, and what is missing\n"
    yield from (f"- **{entry['name']}**: {entry['missing']}." for entry in cases["missing"])


if __name__ == "__main__":
    print("\n".join(report(read((FOLDER / "cases.toml").read_text("utf-8")))))
