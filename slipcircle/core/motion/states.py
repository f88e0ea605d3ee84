"""Status of a motion at its end."""

from enum import IntEnum
from functools import lru_cache
from typing import Any, Self

import numpy as np

from generated import layout as ix
from slipcircle.base.arrays import INFINITY, choose
from slipcircle.core.lazy import lazy_import


class Status(IntEnum):
    """Status of a motion at its end."""

    words: str  #: status in words
    reason: str  #: reason for a missing result, empty otherwise

    def __new__(cls, number: int, words: str = "", reason: str = "") -> Self:
        """Create a member with its description and the reason for a missing result."""
        status = int.__new__(cls, number)
        status._value_ = number
        status.words = words
        status.reason = reason
        return status

    RESTS = 0, "comes to rest"  #: the mass moved, and came to rest without turning back
    STAYS = 1, "does not move"  #: the mass does not move
    #: the mass still moves at its end time. Without an end time, friction is too small to stop it within 2,000 swings;
    #: duration, end and run-out are then taken at its first turning point
    MOVING = 2, "still moving"
    TURNED = 3, "comes to rest after turning back"  #: the mass turned back at least once, and came to rest
    #: the mass approaches its equilibrium ever more slowly through a viscous layer; its run-out is at the equilibrium
    CREEPS = 4, "creeps to its equilibrium"
    #: no result: the chord stands upright and the mass would hang over
    UPRIGHT = 5, "turns over", "the chord is vertical, and the mass would overhang"
    #: no result: the mass never rests, or turns back more than 2,000 times before its end time
    ENDLESS = 6, "never rests", "it never rests, or turns back too often"
    FAILED = 7, "overflow", "overflow"  #: no result: overflow
    #: no result: the numbers are not a valid scene
    INVALID = (
        8,
        "invalid",
        ("its numbers are not a valid scene: an angle below its bound, say, or a circle that misses the ground"),
    )
    #: no result: the starting method gives no factor of safety for its circle
    UNSTARTED = 9, "no starting factor", "the starting method gives this circle no factor of safety"
    #: no result: standing water comes to cover the whole mass, or leaves it
    DROWNED = 10, "drowns or emerges", "standing water comes to cover the whole mass, or leaves it, during the motion"


ANSWERED = (Status.RESTS, Status.STAYS, Status.MOVING, Status.TURNED, Status.CREEPS)
# Status of a lane that moved, by the status of its integration.
STATUS_OF_END = np.full(ix.NEED + 1, Status.FAILED, np.int8)
STATUS_OF_END[[ix.ARRESTED, ix.PAUSED, ix.ENDED, ix.STOPPED, ix.UPRIGHT, ix.TOO_LONG]] = (
    Status.RESTS,
    Status.RESTS,
    Status.MOVING,
    Status.MOVING,
    Status.UPRIGHT,
    Status.ENDLESS,
)


# Numbers of statuses, as attributes of an enumeration take a third of a microsecond in Python 3.11.
_RESTS, _STAYS, _, _TURNED, CREEPS, _, _, _, _INVALID, _UNSTARTED, _DROWNED = map(int, Status)
STATUSES = tuple(Status)  # by number


def _of_end(ended: Any, has_turned: Any, creeps: Any, is_still: Any, is_unstarted: Any) -> Any:
    """Return the number of a `Status` from the status of the integration and four traits of the motion."""
    status = STATUS_OF_END[np.asarray(ended, np.intp)]
    status[(status == _RESTS) & has_turned] = _TURNED
    status[creeps] = CREEPS
    status[(status <= CREEPS) & is_still & (ended != ix.STOPPED)] = _STAYS
    np.copyto(status, _UNSTARTED, where=is_unstarted)
    return status


@lru_cache(maxsize=256)
def _of_single_end(*traits: Any) -> int:
    return int(_of_end(*map(np.atleast_1d, traits))[0])


def statuses(final: Any, invalid: Any, scene: Any) -> Any:
    """Return the status of each lane (scene of an ensemble) as a number of `Status`.

    ``final`` are the final cells, (cells, *shape), and ``invalid`` is a mask of lanes that are not valid scenes.
    """
    ended = final[ix.STATUS]
    of_end = _of_end if isinstance(ended, np.ndarray) else _of_single_end
    strength = scene.strength_factor
    creeps = final[ix.TIME] == INFINITY
    status = of_end(ended, final[ix.TURNS] > 0.0, creeps, final[ix.PHASES] == 0.0, strength != strength)
    if scene.arc.in_standing_water:
        answered = status <= CREEPS
        rotations = final[ix.REACH_ROTATION], final[ix.END_ROTATION]
        drowned = lazy_import("standing").comes_to_cover(scene.arc, *rotations)
        status = choose(answered & drowned, _DROWNED, status)
    return status if invalid is False else choose(invalid, _INVALID, status)
