"""Energy balance and phases of a motion."""

from dataclasses import dataclass
from typing import Any, NamedTuple


@dataclass(frozen=True)
class Energy:
    """Energy balance from the start to one or several times, J.

    Attributes
    ----------
    kinetic_start, kinetic_end, work, dissipation
        Kinetic energies, work of gravity and shaking, and energy dissipated by all resistance, integrated with the
        motion.
    """

    kinetic_start: Any
    kinetic_end: Any
    work: Any
    dissipation: Any

    @property
    def residual(self) -> Any:
        """Work of gravity - change of kinetic energy - dissipation."""
        return self.work - (self.kinetic_end - self.kinetic_start) - self.dissipation


class Phase(NamedTuple):
    """Motion in one direction between two standstills.

    Start and end in s, rotation at the start in rad, and direction (1 down-slope, -1 up-slope).
    """

    start: float
    end: float
    rotation: float
    direction: int
