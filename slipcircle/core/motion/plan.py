"""How a scene will be solved. A plan depends on which effects and which law a scene has, never on their values."""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from math import prod
from typing import Any

from generated.effects import ALL_EFFECTS, EFFECTS
from slipcircle.base.checks import raise_all
from slipcircle.base.kinds import Names
from slipcircle.core.doors import room
from slipcircle.core.problem.problem import Recipe, order, recipe_of, solved_accuracy
from slipcircle.core.program.build import build_program
from slipcircle.core.program.program import Program
from slipcircle.core.scene.effects import OF_SOIL, without_soil
from slipcircle.core.scene.friction import law_depends, law_names
from slipcircle.core.scene.scene import Scene, accuracy_mistakes, checked

DEFAULT_ACCURACY = 1e-9
FLOW = "Taylor series in time, events as their roots"
WORDS = {"speed": "the speed"}
OF_SOILS = ("pore_pressure", "cohesion")  # effects that layered ground has by its soils and water level
STEPS = 8  # that a motion typically takes


@dataclass(frozen=True)
class Plan:
    """How a scene is solved.

    Attributes
    ----------
    scene : Scene
    effects, left_out : tuple of str
        Effects of the scene, and known effects that it does not use; soils have cohesion and pore pressure themselves.
    law : str
        The friction law.
    method, why : str
        The method, in words, and the reason for it.
    fragments : tuple of str
        Parts of `generated.flow` from which the program is assembled.
    operations : str
        Operations on series in one step, by kind.
    cost : int
        Typical number of floating-point operations of a solution.
    accuracy : float
        Requested relative error. It sets the order of the series of ensembles; a single scene is solved to rounding.
    """

    scene: Scene
    effects: Names
    left_out: Names
    law: str
    method: str
    why: str
    fragments: Names
    operations: str
    cost: int
    accuracy: float

    @property
    def equation(self) -> Any:
        """Equation of motion of this scene: its terms, and the values of its coefficients."""
        return room("equation").equation_of(self.scene, self.accuracy)


def plan(scene: Scene, accuracy: float | None = None) -> Plan:
    """How a scene is solved: its flow program, which contains only the effects of the scene.

    Parameters
    ----------
    scene : Scene
    accuracy : float, optional
        Requested relative error; by default that of the scene, or 1e-9.

    Raises
    ------
    ValueError
        If the accuracy is not between 0 and 1, or for an argument that is not a scene.
    """
    checked(scene, "plan")
    if accuracy is not None and not (isinstance(accuracy, float) and 0.0 < accuracy < 1.0):
        raise_all("plan", accuracy_mistakes(accuracy))
    if accuracy is None:
        accuracy = DEFAULT_ACCURACY if scene.accuracy is None else scene.accuracy
    recipe = recipe_of(scene.called, law_names(scene.friction))
    terms = order(solved_accuracy(accuracy, prod(scene.shape)))
    choice = _choice(recipe, law_depends(scene.friction), terms)
    return Plan(scene, **choice, accuracy=accuracy)


@cache
def _choice(recipe: Recipe, depends: Names, terms: int) -> dict[str, Any]:
    """What a plan is made of but for the scene's values, so that it is chosen once."""
    program = build_program(*recipe)
    effects = tuple(dict.fromkeys(map(without_soil, recipe.effects)))
    has_soils = "layered_strength" in effects
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
    reasons += [f"friction depends on {WORDS.get(x, x)}" for x in depends]
    return {
        "effects": effects,
        "left_out": tuple(e for e in EFFECTS if e not in effects and (e not in OF_SOILS or not has_soils)),
        "law": _law_in_words(recipe.laws),
        "method": FLOW,
        "why": "; ".join(reasons),
        "fragments": ("gravity", *recipe.effects, *recipe.laws, "balance"),
        "operations": counted(program),
        "cost": STEPS * flops(program, terms),
    }


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
