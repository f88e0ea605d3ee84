"""Stability and warnings of scenes and motions loaded from files."""

from slipcircle.base.kinds import Names
from slipcircle.core import Motion, Scene, lazy_import
from slipcircle.workbench.files.numbers import by_name
from slipcircle.workbench.stability.critical import Critical, SlopeScene


def stability_of(scene: Scene) -> Critical | None:
    """Return the factors of safety of a scene's circle; None for a scene without a slope."""
    return scene.stability if isinstance(scene, SlopeScene) else None


def warnings_of(motion: Motion) -> Names:
    """Return warnings about a single motion and its circle, with the keys and units of scene files."""
    scene = motion.plan.scene

    def written(name: str, value: float) -> str:
        number = by_name(scene)[name]
        return f"{number.key} = {float(number.from_si(value)):.6g} {number.written}".rstrip()

    stability = stability_of(scene)
    of_circle = [stability.warning] if stability and stability.warning else []
    of_file = scene.remarks if isinstance(scene, SlopeScene) else ()
    return (*of_file, *of_circle, *lazy_import("warnings").collect_warnings(motion, written))
