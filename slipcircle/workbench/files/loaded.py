"""Factors of safety and warnings of a scene or a motion, if it has a slope."""

from slipcircle.core import Motion, Scene, lazy_import
from slipcircle.workbench.files.numbers import by_name
from slipcircle.workbench.stability.critical import Critical, SlopeScene


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
    return (*of_file, *of_circle, *lazy_import("warnings").collect_warnings(motion, written))
