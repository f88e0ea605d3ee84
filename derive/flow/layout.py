"""Numbers shared by the integrators in C and in NumPy, declared once: the cells of a lane, and their codes."""

from typing import NamedTuple

from derive.kinds import TextDict, TextMap

# First cells of every program, in this order, with their meaning: those from which results are computed, and others.
RESULTS = {
    "TIME": "t* at the start of the next step",
    "STATUS": "state of the lane",
    "PHASES": "phases ended",
    "END_TIME": "latest end, t*",
    "FIRST_ONLY": "1 if the first standstill ends it",
    "LIMIT": "limit friction of weight alone at the start",
    "LIMIT_REST": "exact limit friction minus LIMIT where the friction is close to it, otherwise 0",
    "PEAK_TIME": "t* of the greatest speed",
    "PEAK_ROTATION": "rotation then, signed",
    "PEAK_OMEGA": "omega* then, signed",
    "PEAK_RATE": "d omega*/dt* then, signed",
    "REACH_TIME": "t* of the greatest rotation from the start",
    "REACH_ROTATION": "that rotation, signed",
    "END_ROTATION": "rotation at the end, signed",
    "END_OMEGA": "omega* then, signed",
    "END_RATE": "d omega*/dt* then, signed",
    "CLOSE": "least margin of a decision at rest, over its terms",
    "REST_SINCE": "t* of the standstill since which it rests",
    "TURNS": "phases against the direction of the preceding phase",
    "STEPS": "steps since the last rest or break",
}
CELLS = RESULTS | {
    "ROTATION": "rotation where the phase began, signed",
    "SLIP": "slip over the radius where the phase began",
    "DIRECTION": "direction of travel, 1 or -1; 0 at rest",
    "LIFTED": "1 if contact with the slip surface is lost, else 0",
    "ORDER": "order of its series",
    "FACTOR": "ratio of consecutive terms of a series at the end of a step",
    "ONE_WAY": "1 if shaking may start it down-slope only",
    "LIFT_TIME": "t* of the first lift-off",
    "PASSED": "event at which the phase began",
    "LAST_WAY": "direction of the last phase",
    "NEGLIGIBLE": "last terms of the series of a step that is cut short, over the largest",
    "x": "rotation since the phase began, in the direction of travel",
    "omega": "its rate, omega*",
}
# Cells of a table, from its first cell on. The coefficients of its piece follow each other.
TABLE = {
    "PIECE": "number of its piece",
    "VALUE": "value where the phase began",
    "INC": "increment of a function of time since",
    "UPPER": "end of the piece",
    "LOWER": "beginning of the piece of a function of speed",
    "SCALE": "its argument over that of the program",
    "SCALED_BY": "factor of its values",
    "WAY": "path of a function of time, to which the rounding of its increment is proportional",
    "RISE": "rate of a linear function of time",
    "Q1": "first coefficient after the value",
}
STATUS = {
    "START": "not begun",
    "MOVING": "moving",
    "RESTING": "at rest, and may start again",
    "ARRESTED": "at rest for good",
    "PAUSED": "at rest at its end time, beyond which something still changes",
    "ENDED": "at its end time",
    "STOPPED": "at its first standstill, as nothing brings it to rest",
    "UPRIGHT": "the chord is upright",
    "TOO_LONG": "too many steps or turns",
    "FAILED": "overflow",
    "NEED": "a table of a Python function must be extended",
}
PASSED = {
    "NOTHING": "its events have no root at the start",
    "LIFT": "lifted or landed",
    "FASTER": "into the next piece of a function of speed",
    "SLOWER": "into the one before",
}
EVENTS = {
    "NONE": "the step has its full length",
    "STANDSTILL": "the speed falls to zero",
    "LIFT_OFF": "the normal force on the slip surface changes its sign: lift-off or landing",
    "CHORD_UPRIGHT": "the chord stands upright",
    "START": "slip begins at rest",
    "LIMIT": "a function of time has a break, or the end time is reached",
    "ENDLESS": "the motion continues for ever",
    "BREAKPOINT": "the upper edge of the first table's piece; then its lower edge, and those of the next tables",
}
# Cells of a lane during its integration, before the other cells: they begin at -len(WORKING).
WORKING = {
    "PENDING": "action required before its next step",
    "FACED": "directions checked since its standstill",
    "SUDDEN": "1 if slip begins at a jump of forces, else 0",
    "RATE_BEFORE": "d omega*/dt* where the phase before ended",
    "DRIVE_BEFORE": "the drive of that phase",
    "SCALE_BEFORE": "the size of the terms of that drive",
    "SERIES_ORDER": "order of the series of this step",
    "LARGEST_OMEGA": "largest term of the series of omega so far, at rest of the net moment",
    "STEP": "length of this step, up to its first event",
    "EVENT": "that event",
    "START_DIRECTION": "of slip that begins at the end of a rest",
    "QUIET_FROM": "least value of the function of time, without its factor, at which it certainly stays at rest",
    "QUIET_TO": "greatest such value",
    "SINE_X": "sine of the rotation of a mass that passes a record by short series",
    "VERSINE_X": "1 - cosine of this rotation",
    "CLOCKED": "1 if its steps are series in time to the end, although series in the rotation exist",
}
PENDING = {
    "READY": "nothing",
    "START_MOVING": "to begin with a velocity",
    "RESOLVE": "whether it sticks or slips",
    "START_AGAIN": "to slip from rest under forces that change",
    "ENTER_PHASE": "to go on in another phase",
    "DISCONTINUITY": "whether it has contact, as forces have jumped",
    "BEGIN_PHASE": "the numbers of its phase",
    "REST": "rest of a one-way mass at its standstill",
}
NOTES = {"BEGINS": "a phase", "STANDS": "still", "LIFTS": "off", "LANDS": "again"}
KINDS = ("slip", "speed", "time", "rotation")  # arguments of tables
# Registers and cells of a program that the integrator reads, the last ones where phases have a closed form: factors of
# sin(x), 1 - cos(x) and omega^2, then of exp(rate x) - 1 or 1/(1 + per_pole x) - 1 and its products with these, and
# its derivative at the start; at last of the change of the only function of time, the record.
ROLES = (
    "x",
    "omega",
    "net",
    "normal",
    "upright",
    "square",
    "cell_drive",
    "cell_drive_scale",
    "cell_normal0",
    "cell_driving_moment",
    "cell_normal_load",
    "cell_normal_load_slope",
    "cell_driving_moment_slope",
    "cell_driving",
    "cell_resisting",
    "cell_mu",
    "cell_pace",
    "cell_net_sine",
    "cell_net_vers",
    "cell_net_square",
    "cell_normal_sine",
    "cell_normal_vers",
    "cell_normal_square",
    "cell_upright_sine",
    "cell_upright_vers",
    "cell_net_loss",
    "cell_net_loss_sine",
    "cell_net_loss_vers",
    "cell_net_loss_square",
    "cell_loss_rate",
    "cell_per_pole",
    *(f"cell_{force}_record{factor}" for force in ("net", "normal") for factor in ("", "_sine", "_vers")),
)
HIGHEST = 40  # order of a series
STRIDE = HIGHEST + 2  # distance of registers: states have one more coefficient, followed by zero
# Ratio of consecutive terms at the end of a step: the truncation error of a series of order n is RATIO^n. It is smaller
# for single scenes, because coefficients of high order overflow and extrema within a step are lost in the rounding of
# its terms.
RATIOS = {"RATIO": 0.25, "RATIO_TO_ROUNDING": 0.18}
# Greatest numbers for a lane, without breaks of functions of time. A step that changes the speed by less than a share
# is shortened by a fast transient (the motion is stiff), and counts as several steps.
LIMITS = {"MOST_STEPS": 200_000, "STIFF_STEP": 20, "MOST_TURNS": 2000}
# A mass whose weight is carried except for a share swings for ever: friction reduces the width of each swing by 2 mu
# times this share, so that it would need more swings than are integrated. A speed that changes by less than the last
# share in a step has settled. States during a motion differ by the spread of times at the peak velocity, times BETWEEN:
# in 325 scenes by up to 2.1 times the spread of results, for which estimates have room. LEAST_SIZE is a divisor for 0.
SHARES = {"STIFF_CHANGE": 1e-3, "CARRIED": 1e-3, "SETTLED": 2.0**-46, "BETWEEN": 2.0, "LEAST_SIZE": 1e-300}


class Numbered(NamedTuple):
    """Enumeration with its title, the prefix of its members, and the first number."""

    words: str
    prefix: str
    first: int
    members: TextMap


# Enumerations by their names in the text of the integrator.
NUMBERED = {
    "Cell": Numbered("Cells of a lane, first in every program", "", 0, {x.upper(): CELLS[x] for x in CELLS}),
    "Working": Numbered("Cells of a lane while it is integrated, in front of these", "", -len(WORKING), WORKING),
    "Part": Numbered("Cells of a table", "", 0, TABLE),
    "Kind": Numbered("Arguments of tables", "OF_", 0, {x.upper(): f"a function of {x}" for x in KINDS}),
    "Status": Numbered("State of a lane", "", 0, STATUS),
    "Passed": Numbered("Event at which its phase began", "", 0, PASSED),
    "Pending": Numbered("Action required before its next step", "", 0, PENDING),
    "Event": Numbered("Events that end a step", "EVENT_", -1, EVENTS),
    "Note": Numbered("Logged events of the first lane", "NOTE_", 1, NOTES),
}


def python() -> str:
    """Return the module `generated.layout`."""
    parts = ['"""Places and meanings of the numbers of a lane, the same in NumPy and in C."""\n\n']
    for words, prefix, start, names in NUMBERED.values():
        rows = "".join(f"{prefix}{x} = {k}  # {meaning}\n" for k, (x, meaning) in enumerate(names.items(), start))
        parts.append(f"# {words}.\n{rows}\n")
    given = {"CELLS": (*CELLS,), "TABLE": (*TABLE,), "KINDS": KINDS, "ROLES": ROLES} | RATIOS | LIMITS | SHARES
    given |= {"STRIDE": STRIDE, "RESULTS": len(RESULTS)}
    return "".join((*parts, *(f"{x} = {y!r}\n" for x, y in given.items())))


def c() -> TextDict:
    """Return the same for the compiled integrator, and the members of the struct of a program's roles, by mark."""
    rows = []
    for _, prefix, start, names in NUMBERED.values():
        row = [f"{prefix}{x}" for x in names]
        if start:
            row[0] += f" = {start}"
        rows.append(row)
    rows.append([f"{x} = {y}" for x, y in LIMITS.items()])
    enums = [f"enum {{ {', '.join(row)} }};\n" for row in rows]
    shares = [f"#define {x} {y}\n" for x, y in SHARES.items()]
    return {
        "CELLS": "".join(enums + shares),
        "SIZES": f"HIGHEST = {HIGHEST}, STRIDE = {STRIDE}, CELLS = {len(CELLS)}, RESULTS = {len(RESULTS)}, "
        f"PARTS = {len(TABLE) - 1}, REGISTER_ROLES = {sum(not x.startswith('cell_') for x in ROLES)}",
        "ROLES": f"    int32_t {', '.join(x.removeprefix('cell_') for x in ROLES)};\n",
    }
