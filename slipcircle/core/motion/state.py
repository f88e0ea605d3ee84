"""State of a motion at a time."""

from collections.abc import Callable
from dataclasses import InitVar, dataclass, field
from typing import Any


@dataclass(frozen=True)
class State:
    """State of a motion at one or several times, positive down-slope.

    Attributes
    ----------
    time, rotation, angular_velocity, velocity, displacement, acceleration, normal_stress
        s, rad, rad/s, m/s and m along the arc, m/s^2 along the arc, Pa (computed on first use).

    Notes
    -----
    ``normal_stress`` is the mean total normal stress over the arc, including water pressure, by (2.20) from the weight
    in its position with free water above it, the rotation and shaking. It does not depend on the layers below the arc.
    `slipcircle.layers.mean_normal_stress` returns the means over parts of the arc.
    """

    time: Any
    rotation: Any
    angular_velocity: Any
    velocity: Any
    displacement: Any
    acceleration: Any
    normal_stress: Any = field(init=False)
    stress: InitVar[Callable[[], Any]] = field(kw_only=True)

    def __post_init__(self, stress: Callable[[], Any]) -> None:
        """Store the function that computes the normal stress when it is requested."""
        object.__setattr__(self, "_stress", stress)

    def __getattr__(self, name: str) -> Any:
        """Return the normal stress, computed at its first use, since the program must be evaluated for it."""
        if name != "normal_stress":
            raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")
        object.__setattr__(self, name, self._stress())
        return self.normal_stress
