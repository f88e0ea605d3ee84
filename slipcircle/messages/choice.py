"""Description of a plan: friction law, method, and the reasons for the method."""

from collections.abc import Iterator
from functools import cache
from typing import NamedTuple

from generated.effects import ALL_EFFECTS
from generated.program import OF_SOIL, Recipe
from slipcircle.core.integrator.compiled import encoded, level, module, widest
from slipcircle.core.problem.plan import Plan
from slipcircle.core.scene.effects import without_soil
from slipcircle.core.scene.laws import depends_on

_SOILS = "the strength of the soils"
WORDS = {"speed": "the speed", "layered_strength": _SOILS, "soil_friction": _SOILS}


class PlanWords(NamedTuple):
    """Description of a plan by friction law, method and reasons."""

    law: str
    method: str
    why: str


def words_of(plan: Plan) -> PlanWords:
    """Return the description of a plan, with "straight-line" or "interpreted" for its program in the integrator."""
    law, why = _words(plan.recipe)
    program = plan.program
    variable = "tau" if "cell_pace" in program.roles else "the rotation" if program.by_rotation else "time"
    closed = "closed form from rest, otherwise " if "cell_net_sine" in program.roles and not program.tables else ""
    binary = module()
    is_straight = binary is not None and binary.straight_line(encoded(program), widest()) >= 0
    way = "straight-line" if is_straight else "interpreted"
    return PlanWords(law, f"{closed}Taylor series in {variable}, events as their roots; {way}", why)


def describe_integrator() -> str:
    """Return the description of the integrator: compiler, vector level, lanes at a time, kind of programs."""
    kind = level()
    if not kind:
        return "NumPy, not compiled"
    binary = module()
    lanes, straight = binary.TRAITS[kind]
    way = "common programs straight-line" if straight else "interpreted"
    return f"compiled ({binary.COMPILER}), {kind}, {lanes} lanes, {way}"


@cache
def _words(recipe: Recipe) -> tuple[str, str]:
    """Return the friction law of the plans with a recipe, and the reasons for their method."""
    effects = tuple(dict.fromkeys(map(without_soil, recipe.effects)))
    symbols = {*map(without_soil, recipe.moving)}
    of_rotation = []
    of_time = set()
    for effect in effects:
        for p in ALL_EFFECTS[effect].parameters:
            if p.symbol not in symbols:
                continue
            if p.kind == "rotation":
                of_rotation.append(WORDS.get(effect, effect))
            elif p.kind == "series":
                of_time.add(effect)
    reasons = list[str]()
    for effect in effects:
        reasons += _reasons(effect, effect in of_time)
    reasons += [f"{e} depends on the rotation" for e in dict.fromkeys(of_rotation)]
    reasons += [f"friction depends on {WORDS.get(x, x)}" for x in depends_on(recipe.of_friction)]
    # The friction law, or the laws of the soils, and the law of speed as a product.
    of_soils = [without_soil(law) for law in recipe.of_friction if OF_SOIL in law]
    factors = [law for law in recipe.of_friction if OF_SOIL not in law]
    if of_soils:
        factors.insert(0, f"{', '.join(dict.fromkeys(of_soils))} by soil")
    law = " times ".join(factors)
    return law, "; ".join(reasons)


def _reasons(effect: str, in_time: bool) -> Iterator[str]:
    """Yield the reasons for an integration: an effect turns the mass, or depends on a variable.

    ``effect`` is its name, and ``in_time`` is true if one of its parameters changes with time.
    """
    declared = ALL_EFFECTS[effect]
    for variable in declared.depends_on:
        if variable == "time" and not in_time:
            continue
        yield f"{effect} turns the mass" if declared.turns else f"{effect} depends on {WORDS.get(variable, variable)}"
