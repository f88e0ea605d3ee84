"""Method of solution of a scene, which depends on its effects and laws but not on their values."""

from dataclasses import dataclass
from functools import lru_cache, partial
from typing import Any

from generated.effects import EFFECTS
from generated.flow import FRAGMENTS
from generated.program import Program, Recipe, build, fragments_of
from slipcircle.base.errors import raise_all
from slipcircle.base.kinds import Names
from slipcircle.core.lazy import lazy_import
from slipcircle.core.scene.effects import in_order
from slipcircle.core.scene.scene import Scene, accuracy_mistakes, checked_scene

DEFAULT_ACCURACY = 1e-9


@lru_cache(maxsize=256)
def build_program(recipe: Recipe, outputs: Names = ()) -> Program:
    """Return the program of a scene, linked from the effects and laws that its ``recipe`` names.

    ``outputs`` are further outputs: registers such as ``mu``, ``pressing`` or ``friction``, and "energy" for the states
    ``work`` and ``dissipation``.
    """
    further = tuple(name for name in outputs if name in FRAGMENTS)
    registers = tuple(name for name in outputs if name not in FRAGMENTS)
    return build(recipe, partial(fragments_of, FRAGMENTS), registers, further)


@dataclass
class Plan:
    """Method of solution of a scene.

    Attributes
    ----------
    scene : Scene
    recipe : Recipe
        Effects, laws and parameters from which its program is linked.
    accuracy : float
        Requested relative error. It sets the order of the series of ensembles. A single scene is solved to rounding.
    """

    scene: Scene
    recipe: Recipe
    accuracy: float

    @property
    def program(self) -> Program:
        """Program of the scene, linked once for all scenes with this recipe."""
        return build_program(self.recipe)

    @property
    def effects(self) -> Names:
        """Names of the effects of the scene, without effects that its soils add."""
        return tuple(effect for effect in self.recipe.effects if effect in EFFECTS)

    @property
    def left_out(self) -> Names:
        """Names of effects that the scene does not use. Cohesion and pore pressure given by soils count as used."""
        included = (*self.effects, *self.scene.arc.own_effects)
        return tuple(effect for effect in EFFECTS if effect not in included)

    @property
    def fragments(self) -> Names:
        """Names of the parts of `generated.flow` from which the program is linked."""
        return ("gravity", *self.recipe.effects, *self.recipe.laws, "balance")

    @property
    def law(self) -> str:
        """Friction law in words, such as a product of a law of slip and a law of speed."""
        return str(self._words.law)

    @property
    def method(self) -> str:
        """Description of the method."""
        return str(self._words.method)

    @property
    def why(self) -> str:
        """Reasons for the method in words, separated by semicolons."""
        return str(self._words.why)

    @property
    def _words(self) -> Any:
        return lazy_import("plan").words_of(self)

    @property
    def equation(self) -> Any:
        """Equation of motion of this scene: its terms, and the values of its coefficients."""
        return lazy_import("equation").equation_of(self)


def plan(scene: Scene, accuracy: float | None = None) -> Plan:
    """Return the method of solution of a scene, whose program contains only the effects of the scene.

    Parameters
    ----------
    scene : Scene
    accuracy : float, optional
        Requested relative error, by default the scene's or 1e-9.

    Raises
    ------
    ValueError
        If the accuracy is not between 0 and 1, or the argument is not a scene.
    """
    checked_scene(scene, "plan")
    if accuracy is None:
        accuracy = DEFAULT_ACCURACY if scene.accuracy is None else scene.accuracy
    else:
        raise_all("plan", accuracy_mistakes(accuracy))
    return Plan(scene, recipe_of(scene), float(accuracy))


def recipe_of(scene: Scene) -> Recipe:
    """Return the names of effects and laws, and the symbols of parameters that vary or are absent.

    The program of a scene is linked from them.
    """
    called = scene.called
    effects, parameters = in_order(tuple(called))
    moving: list[str] = []
    absent: list[str] = []
    for effect, name, symbol in parameters:
        value = called[effect].get(name)
        if value is None:
            absent.append(symbol)
        elif callable(value):
            moving.append(symbol)
    if "layered_strength" in effects and "shaking" not in effects:
        absent += ["k_h", "k_v"]  # which its terms contain, too
    return Recipe(effects, tuple(scene.laws), tuple(moving), tuple(absent))
