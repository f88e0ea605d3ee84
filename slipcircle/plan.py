"""How a scene will be solved. A plan depends on which effects a scene has, never on their values."""

from dataclasses import dataclass

from generated.effects import EFFECTS, SPECIALISED
from slipcircle.checks import mistakes, raise_all
from slipcircle.scene import ACCURACY, Scene

DEFAULT_ACCURACY = 1e-9


@dataclass(frozen=True)
class Plan:
    """The way to a scene's motion.

    Attributes
    ----------
    scene : Scene
    effects, left_out : tuple of str
        Effects used, and known effects that the scene does not call for.
    method : str
        What is done, in words.
    prefix : str
        Of the generated functions that serve this combination of effects.
    functions : tuple of str
        Their names in `generated.motion`.
    operations : str
        What one evaluation of all of them takes.
    accuracy : float
        Relative error that was asked for.
    """

    scene: Scene
    effects: tuple[str, ...]
    left_out: tuple[str, ...]
    method: str
    prefix: str
    functions: tuple[str, ...]
    operations: str
    accuracy: float


def plan(scene: Scene, accuracy: float | None = None) -> Plan:
    """Choose the cheapest method that is exact for the scene's combination of effects.

    Parameters
    ----------
    scene : Scene
    accuracy : float, optional
        Relative error asked for; by default the scene's own, or 1e-9.

    Raises
    ------
    ValueError
        If the accuracy is not between 0 and 1.
    """
    wanted = accuracy if accuracy is not None else scene.accuracy if scene.accuracy is not None else DEFAULT_ACCURACY
    raise_all("plan", mistakes({"accuracy": wanted}, {"accuracy": ACCURACY}))
    effects = tuple(e for e in EFFECTS if e in scene.effects)
    chosen = SPECIALISED[effects]
    return Plan(
        scene, effects, tuple(e for e in EFFECTS if e not in effects), "closed form in time", chosen.prefix,
        chosen.functions, chosen.operations, wanted,
    )  # fmt: skip
