"""The entries of the state of lanes as attributes, so that equations read like equations."""

from typing import Any, Protocol

from generated import layout as ix
from slipcircle.base.kinds import Floats


class HasCells(Protocol):
    """What has entries: rows of an array, a column for each lane."""

    @property
    def cells(self) -> Floats: ...


class Entry:
    """An entry by name: ``state.omega`` is the row ``state.cells[ix.OMEGA]``, a view; assigning fills it."""

    def __init__(self, row: int) -> None:
        self.row = row

    def __get__(self, holder: HasCells, owner: object = None) -> Floats:
        row: Floats = holder.cells[self.row]
        return row

    def __set__(self, holder: HasCells, values: Any) -> None:
        holder.cells[self.row] = values


class LaneEntries:
    """Lanes as columns of cells; each attribute is an entry of the state, one number of each lane.

    `generated.layout` says what it holds.
    """

    cells: Floats
    time = Entry(ix.TIME)  # t* at the start of the next step
    rotation = Entry(ix.ROTATION)  # rotation where the phase began, signed
    slip = Entry(ix.SLIP)  # slip over the radius where the phase began
    direction = Entry(ix.DIRECTION)  # of travel, 1 or -1; 0 at rest
    lifted = Entry(ix.LIFTED)  # 1 where nothing presses on the slip surface, else 0
    status = Entry(ix.STATUS)  # what the lane is doing
    steps = Entry(ix.STEPS)  # steps taken
    phases = Entry(ix.PHASES)  # phases ended
    order = Entry(ix.ORDER)  # of its series
    factor = Entry(ix.FACTOR)  # length of a step over the radius of convergence
    end_time = Entry(ix.END_TIME)  # t* at which it ends at the latest
    one_way = Entry(ix.ONE_WAY)  # 1 where shaking may start it down-slope only
    first_only = Entry(ix.FIRST_ONLY)  # 1 where the first standstill ends it
    passed = Entry(ix.PASSED)  # what the phase began by passing
    peak_time = Entry(ix.PEAK_TIME)  # t* of the greatest speed
    peak_rotation = Entry(ix.PEAK_ROTATION)  # rotation then, signed
    peak_omega = Entry(ix.PEAK_OMEGA)  # omega* then, signed
    peak_rate = Entry(ix.PEAK_RATE)  # d omega*/dt* then, signed
    reach_time = Entry(ix.REACH_TIME)  # t* of the greatest rotation from the start
    reach_rotation = Entry(ix.REACH_ROTATION)  # that rotation, signed
    end_rotation = Entry(ix.END_ROTATION)  # rotation at the end, signed
    end_omega = Entry(ix.END_OMEGA)  # omega* then, signed
    end_rate = Entry(ix.END_RATE)  # d omega*/dt* then, signed
    close = Entry(ix.CLOSE)  # least margin of a decision at rest, over its terms
    lift_time = Entry(ix.LIFT_TIME)  # t* of the first lift-off
    rest_since = Entry(ix.REST_SINCE)  # t* of the standstill that it rests from
    turns = Entry(ix.TURNS)  # phases that began against the one before
    last_way = Entry(ix.LAST_WAY)  # direction of the last phase
    x = Entry(ix.X)  # rotation since the phase began, in the direction of travel
    omega = Entry(ix.OMEGA)  # its rate, omega*
