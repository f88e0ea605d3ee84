"""Random scenes stored with their motion to 20 and 30 digits; ``tests.campaigns.references`` draws other scenes.

Of the 400 scenes 300 depend on position and velocity, and 100 on time, rates or heat. `taylor` solved each scene
twice, by series of different length at different precision, and the digits agreed. `test_accuracy` solves six scenes
again; ``python -m tests.support.references`` solves all, and stores the answers.
"""

from collections.abc import Callable
from pathlib import Path
from typing import Any

from flint import arb, ctx

from tests.support import golden, taylor
from tests.support.taylor import Unfit

FILE = Path(__file__).with_name("references.json")
STEADY = {"frozen": 60, "constant": 100, "exponential": 50, "linear": 28, "hyperbolic": 28, "tabulated": 34}
TIMED = {"viscous": 10, "pulse": 14, "series": 14, "rate": 12, "rate table": 8, "prescribed": 8, "product": 8,
         "heated": 10, "water": 6, "all": 10}  # fmt: skip
NEAR = {"frozen": 4, "constant": 10, "exponential": 4, "tabulated": 2}  # the first of each, next to the limit
LIFTED = 6  # the last with constant friction: pushed up-slope, so that water carries them for a while
SHARES = (0.137, 0.391, 0.618, 0.874)  # of the duration, at which scenes of time are compared


def digits(group: str) -> int:
    """Return the number of known digits of a group's motions."""
    return 30 if group in STEADY else 20


def agree(one: Any, two: Any, digits: int) -> bool:
    """Whether two answers are the same to within their last digits; places and speeds beside the greatest."""
    with ctx.workprec(256):

        def near(a: str, b: str, size: str) -> bool:
            return bool(abs(arb(a) - arb(b)) <= abs(arb(size)) * arb(10) ** (2 - digits))

        sizes = {"displacement": one["run_out"], "velocity": one["peak_velocity"]}
        return one.keys() == two.keys() and all(
            near(one[k], two[k], one[k]) if isinstance(one[k], str)
            else all(near(a, b, sizes[k]) for a, b in zip(one[k], two[k], strict=True)) if k in sizes
            else one[k] == two[k]
            for k in one if k != "peak_time"
        )  # fmt: skip


def first_fit(draw: Callable[[], dict[str, Any]], digits: int, *problem: Any, **limits: Any) -> dict[str, Any]:
    """Return the first random scene that moves and comes to an end, and its motion, which longer series confirm."""
    for _ in range(1000):
        try:
            scene = draw()
            found, longer = (taylor.solve(scene, SHARES, d, *problem, **limits) for d in (digits, digits + 4))
        except Unfit:
            continue
        if found["moves"] and agree(found, longer, digits):
            return {"scene": scene, "reference": found}
    raise RuntimeError("no scene fits")


def main() -> None:
    golden.write(FILE, (row | {"reference": taylor.solve(row["scene"], row["shares"], digits(row["group"]))}
                        for row in golden.read(FILE)))  # fmt: skip


if __name__ == "__main__":
    main()
