"""A scene of a real slope together with the factors of safety of its circle."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from slipcircle.base.kinds import Numbers
from slipcircle.core import Motion, Scene, room
from slipcircle.workbench.files.numbers import by_name

if TYPE_CHECKING:
    from slipcircle.workbench.stability.search import Critical


@dataclass(frozen=True)
class SlopeScene(Scene[Numbers]):
    """A scene with the factors of safety of its circle, as returned by `load`; its motion does not depend on them.

    Attributes
    ----------
    stability : Critical, optional
        Factors of safety of the section's circle, and how it was found.
    remarks : tuple of str
        Interpretations of the file that may not be intended.
    """

    stability: Critical | None = None
    remarks: tuple[str, ...] = ()


def stability_of(scene: Scene) -> Critical | None:
    """The factors of safety of a scene's circle, or None."""
    return scene.stability if isinstance(scene, SlopeScene) else None


def warnings_of(motion: Motion) -> tuple[str, ...]:
    """Warnings about a single motion, whose numbers have the keys and units of files, and about its circle."""
    scene = motion.plan.scene

    def written(name: str, value: float) -> str:
        number = by_name(scene)[name]
        return f"{number.key} = {float(number.from_si(value)):.6g} {number.unit}".rstrip()

    stability = stability_of(scene)
    of_circle = [stability.warning] if stability and stability.warning else []
    of_file = scene.remarks if isinstance(scene, SlopeScene) else ()
    return (*of_file, *of_circle, *room("warnings").collect_warnings(motion, written))
