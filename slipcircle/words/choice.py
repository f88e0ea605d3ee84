"""A plan in words: the law, the method and the reason for it, and what a step costs."""

from collections.abc import Iterator
from functools import cache
from math import prod
from typing import NamedTuple

from generated.effects import ALL_EFFECTS
from slipcircle.base.kinds import Names
from slipcircle.core.problem.plan import Plan, Recipe
from slipcircle.core.problem.problem import order, solved_accuracy
from slipcircle.core.program.program import Program, build_program
from slipcircle.core.scene.effects import OF_SOIL, without_soil
from slipcircle.core.scene.friction import depends_on

FLOW = "Taylor series in time, events as their roots"
WORDS = {"speed": "the speed"}
STEPS = 8  # that a motion typically takes


class PlanWords(NamedTuple):
    """What `Plan` says of itself."""

    law: str
    method: str
    why: str
    operations: str
    cost: int


def words_of(plan: Plan) -> PlanWords:
    """What a plan says in words."""
    terms = order(solved_accuracy(plan.accuracy, prod(plan.scene.shape)))
    return _words(plan.recipe, plan.effects, terms)


@cache
def _words(recipe: Recipe, effects: Names, terms: int) -> PlanWords:
    program = build_program(*recipe)
    symbols = {*map(without_soil, recipe.moving)}
    of_rotation = list[str]()
    of_time = dict[str, None]()
    for effect in effects:
        for p in ALL_EFFECTS[effect].parameters:
            if p.symbol not in symbols:
                continue
            if p.kind == "rotation":
                of_rotation.append(effect)
            elif p.kind == "series":
                of_time[effect] = None
    reasons = list[str]()
    for effect in effects:
        reasons += _reasons(effect, effect in of_time)
    reasons += [f"{e} depends on time" for e in of_time if "time" not in ALL_EFFECTS[e].depends_on]
    reasons += [f"{e} depends on the rotation" for e in dict.fromkeys(of_rotation)]
    reasons += [f"friction depends on {WORDS.get(x, x)}" for x in depends_on(recipe.laws)]
    law = _law_in_words(recipe.laws)
    return PlanWords(law, FLOW, "; ".join(reasons), counted(program), STEPS * flops(program, terms))


def _law_in_words(laws: Names) -> str:
    """The friction law, or those of soils, times the law of speed."""
    of_soils = [without_soil(law) for law in laws if OF_SOIL in law]
    factors = [law for law in laws if OF_SOIL not in law]
    if of_soils:
        factors.insert(0, f"{', '.join(dict.fromkeys(of_soils))} by soil")
    return " times ".join(factors)


def _reasons(effect: str, in_time: bool) -> Iterator[str]:
    """What asks for an integration: that an effect turns the mass, or what it depends on."""
    declared = ALL_EFFECTS[effect]
    for variable in declared.depends_on:
        if variable == "speed squared" or (variable == "time" and not in_time):
            continue
        yield f"{effect} turns the mass" if declared.turns else f"{effect} depends on {WORDS.get(variable, variable)}"


def step_operations(effects: Names, laws: Names, moving: Names) -> str:
    """The operations on series of one step under effects and laws by name; ``moving`` symbols change in time."""
    return counted(build_program(effects, laws, moving))


def counted(program: Program) -> str:
    """The operations on series of one step, by kind."""
    kinds = [op[0] for op in program.series]
    return ", ".join(f"{kinds.count(k)} {k}" for k in sorted(set(kinds)))


def flops(program: Program, order: int) -> int:
    """Floating-point operations of one step: products take as many terms as their coefficient has factors."""
    per_order = {"sqr": order, "turn": 4 * order, "tim": 1, "ramp": 0}
    total = 0
    for kind, *names in program.series:
        if kind == "lin":
            terms = names[-1]
            total += (order + 1) * 2 * len(terms)
        else:
            total += (order + 1) * per_order.get(kind, 2 * order)
    return total
