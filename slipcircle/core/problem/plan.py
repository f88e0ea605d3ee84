"""How a scene will be solved. A plan depends on which effects and which law a scene has, never on their values."""

from dataclasses import dataclass
from typing import Any

from generated.effects import EFFECTS
from generated.program import Program, Recipe
from slipcircle.base.checks import raise_all
from slipcircle.base.kinds import Names
from slipcircle.core.doors import room
from slipcircle.core.program import build_program
from slipcircle.core.scene.effects import in_order, symbols_of
from slipcircle.core.scene.scene import Scene, accuracy_mistakes, checked

DEFAULT_ACCURACY = 1e-9


@dataclass(frozen=True)
class Plan:
    """How a scene is solved.

    Attributes
    ----------
    scene : Scene
    recipe : Recipe
        Effects, laws and parameters that its program is made from.
    accuracy : float
        Requested relative error. It sets the order of the series of ensembles; a single scene is solved to rounding.
    effects, left_out : tuple of str
        Effects of the scene, and known effects that it does not use; soils have cohesion and pore pressure themselves.
    law : str
        The friction law.
    method, why : str
        The method, in words, and the reason for it.
    fragments : tuple of str
        Parts of `generated.flow` from which the program is assembled.
    """

    scene: Scene
    recipe: Recipe
    accuracy: float

    @property
    def program(self) -> Program:
        """Its operations, linked once for all scenes with this recipe."""
        return build_program(self.recipe)

    @property
    def effects(self) -> Names:
        return tuple(effect for effect in self.recipe.effects if effect in EFFECTS)

    @property
    def left_out(self) -> Names:
        known = (*self.effects, *self.scene.arc.own_effects)
        return tuple(effect for effect in EFFECTS if effect not in known)

    @property
    def fragments(self) -> Names:
        return ("gravity", *self.recipe.effects, *self.recipe.laws, "balance")

    @property
    def law(self) -> str:
        return str(self._words.law)

    @property
    def method(self) -> str:
        return str(self._words.method)

    @property
    def why(self) -> str:
        return str(self._words.why)

    @property
    def _words(self) -> Any:
        return room("plan").words_of(self)

    @property
    def equation(self) -> Any:
        """Equation of motion of this scene: its terms, and the values of its coefficients."""
        return room("equation").equation_of(self)


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
    raise_all("plan", accuracy_mistakes(accuracy))
    if accuracy is None:
        accuracy = DEFAULT_ACCURACY if scene.accuracy is None else scene.accuracy
    return Plan(scene, recipe_of(scene), float(accuracy))


def recipe_of(scene: Scene) -> Recipe:
    """What the program of a scene is made from."""
    effects = in_order(tuple(scene.called))
    moving: list[str] = []
    absent: list[str] = []
    for effect in effects:
        parameters = scene.called[effect]
        for name, symbol in symbols_of(effect).items():
            value = parameters.get(name)
            if value is None:
                absent.append(symbol)
            elif callable(value):
                moving.append(symbol)
    if "layered_strength" in effects and "shaking" not in effects:
        absent += ["k_h", "k_v"]  # which its terms contain, too
    laws = tuple([name for name, _ in scene.laws])
    return Recipe(effects, laws, tuple(moving), tuple(absent))
