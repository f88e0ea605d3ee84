# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: 98f107b7e22fb888da6250b0cd71dfb1b1277d233c51df7442f112dbfae446f4
"""Integrator of lanes in NumPy: steps, events, phases of slip and of rest, from the same text as the compiled one.

The text of the integrator is in `derive/flow/integrator`, for this module and for ``_flow.c``. A lane is a column of
``cells``, and `generated.layout` names the rows. Lanes are integrated side by side.
"""

from collections.abc import Mapping, Sequence
from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from generated import layout as ix
from generated.series import scalar_ops, series_ops

Floats = Any  # an array of float64
Mask = Any  # an array of truth values
Index = NDArray[np.intp]

ROUNDS = 10_000  # after which lanes that have ended make room at the latest
FIXED = 2.0**40
Program = Any
Log = list[tuple[int, float, float, float]]


class State(NamedTuple):
    """State of the motion: its cell, its register and the register of its rate."""

    cell: int
    register: int
    rate: int


class Table:
    """Table of the program with its data. `generated.layout` describes its cells."""

    def __init__(self, number: int, slot: Any, data: Any, before: "Table | None") -> None:
        self.number = number
        self.before: Any = before
        self.kind = ix.KINDS.index(slot.kind)
        self.register = slot.register
        self.cells = slot.cells
        self.degree = slot.degree
        self.data = data
        self.pieces = len(data.breaks)
        self.places = data.breaks
        self.heights = data.coefficients.ravel()
        self.terms = data.coefficients.shape[1]
        self.sine = data.sine
        self.open = data.open


class Lanes:
    """Lanes of a program during their integration: cells, including working cells, and registers."""

    def __init__(
        self,
        program: Program,
        tables: Sequence[Any],
        cells: Floats,
        columns: Index | None = None,
        samples: Any = None,
        log: Log | None = None,
    ) -> None:
        count = cells.shape[1]
        self.program = program
        working = np.zeros((-ix.PENDING, count))
        self.cells: Floats = np.concatenate([cells, working])  # cells in front are at negative places
        self.columns = np.arange(count) if columns is None else columns
        self.highest = int(cells[ix.ORDER].max(initial=0.0))
        self.registers = np.zeros((len(program.registers), self.highest + 2, count))
        self.roles = SimpleNamespace(**dict.fromkeys((x.removeprefix("cell_") for x in ix.ROLES), -1))
        self.roles.__dict__.update({x.removeprefix("cell_"): place for x, place in program.roles.items()})
        self.states = [State(*state) for state in program.states]
        self.tables = list[Table]()
        for number, (slot, data) in enumerate(zip(program.tables, tables, strict=True)):
            self.tables.append(Table(number, slot, data, self.tables[-1] if number else None))
        self.timed = sum(t.kind == ix.OF_TIME for t in self.tables)
        self.autonomous = program.autonomous
        self.by_rotation = program.by_rotation
        self.samples = samples
        self.sample_count = 0 if samples is None else len(samples.times)
        self.log = log
        self.logged = log is not None

    @property
    def stored(self) -> Floats:
        """Cells of the lanes without working cells."""
        return self.cells[: ix.PENDING]


# --- what the text asks of a program, of tables and of records --------------------------------------------------------


def none_of(s: Lanes) -> Mask:
    """Return the mask without lanes."""
    return np.zeros(s.cells.shape[1], dtype=bool)


def all_lanes(mask: Mask) -> bool:
    """Return whether a mask is true for all lanes."""
    return bool(np.all(mask))


def greatest(x: Floats) -> int:
    """Return the greatest integer."""
    return int(x.max())


def least(x: Floats) -> int:
    """Return the least integer."""
    return int(x.min())


def log2_of(x: Floats) -> Floats:
    """Return log2 |x| with 40 fractional bits, linear between powers of two and up to 0.09 too small."""
    bits = np.abs(x).view(np.int64) >> 12
    return bits.astype(np.float64)


def power_of_two(y: Floats) -> Floats:
    """Return the inverse of `log2_of`, except for the offset of the exponent."""
    bounded = np.clip(y, -1000.0 * FIXED, 1000.0 * FIXED)
    bits = np.rint(bounded + 1023.0 * FIXED)
    pattern = bits.astype(np.int64) << 12
    return pattern.view(np.float64)


def operate(s: Lanes, first: int, behind: int, by_rotation: int, moves: int) -> None:
    """Compute coefficients of every register from ``first`` on, and one more of the states of masses that move.

    In powers of the rotation, the square of omega is a state.
    """
    skipped = int(by_rotation and s.by_rotation == 2)
    for n in range(first, behind):
        series_ops(s.program.series[skipped:], s.registers, s.cells, n)
        if moves:
            for q in s.states:
                s.registers[q.register, n + 1] = s.registers[q.rate, n] * (1.0 / (n + 1))


def operate_later(s: Lanes, n: int) -> None:
    """Do nothing, since `operate` computes all registers."""


def prologue(s: Lanes, which: Mask) -> None:
    """Compute the numbers of phases that begin."""
    if np.all(which):
        scalar_ops(s.program.scalar, s.cells)
        return
    part = s.cells[:, which]
    scalar_ops(s.program.scalar, part)
    s.cells[:, which] = part


def breaks_at(s: Lanes, t: Table, piece: Floats) -> Floats:
    """Return the left end of a piece of each lane in the table's argument."""
    breaks = t.data.breaks
    pieces = piece_numbers(s, piece)
    return breaks[pieces] if breaks.ndim == 1 else breaks[pieces, s.columns]


def coefficients_at(s: Lanes, t: Table, piece: Floats, number: int) -> Floats:
    """Return a coefficient of a piece of each lane, in powers of the distance from its left end."""
    every = t.data.coefficients
    pieces = piece_numbers(s, piece)
    return every[pieces, number] if every.ndim == 2 else every[pieces, number, s.columns]


def last_quiet(s: Lanes, here: Mask, t: Table, before: Floats) -> Floats:
    """Return the last piece of a function of time through which each lane certainly rests.

    It rests on while the value that begins the following piece is in its quiet range, and that piece ends before a
    place.
    """
    piece = s.cells[t.cells + ix.PIECE].copy()
    rests = here
    while np.any(rests):
        height = coefficients_at(s, t, np.minimum(piece + 1.0, t.pieces - 1), 0)
        quiet = (s.cells[ix.QUIET_FROM] <= height) & (height <= s.cells[ix.QUIET_TO])
        ends = breaks_at(s, t, np.minimum(piece + 2.0, t.pieces - 1)) < before
        rests = rests & quiet & ends & (piece + 2.0 < t.pieces)
        piece = np.where(rests, piece + 1.0, piece)
    return piece


def jumps_at(s: Lanes, t: Table, piece: Floats) -> Floats:
    """Return the jump of a function of time at the left end of a piece of each lane."""
    return t.data.jumps[piece_numbers(s, piece)]


def piece_numbers(s: Lanes, piece: Floats) -> Index:
    """Return the number of a piece of each lane as an integer."""
    return np.broadcast_to(piece, s.columns.shape).astype(np.intp)


def note(s: Lanes, here: Mask, event: int) -> None:
    """Log an event of the first lane."""
    if s.log is None or not np.any(s.columns[here] == 0):
        return
    lane = np.flatnonzero(s.columns == 0)
    time, rotation, direction = s.cells[[ix.TIME, ix.ROTATION, ix.DIRECTION], lane].tolist()
    s.log.append((event, time, rotation, direction))


def sampled(s: Lanes, lane: int, begin: float, end: float) -> tuple[Floats, slice]:
    """Return the sample times of a lane between two times, since the first of them, and their indices.

    The end time belongs to the last interval.
    """
    times = s.samples.times[:, s.columns[lane] if s.samples.times.shape[1] > 1 else 0]
    first = int(np.searchsorted(times, begin))
    closed = s.cells[ix.END_TIME, lane] <= end < np.inf
    last = int(np.searchsorted(times, end, side="right" if closed else "left"))
    return times[first:last] - begin, slice(first, max(first, last))


def read_samples(s: Lanes, here: Mask, begin: Floats, end: Any, moving: int, top: int) -> None:
    """Evaluate the states at the sample times between two times, from series or at rest."""
    ends = np.broadcast_to(end, here.shape)
    registers = [q.register for q in s.states]
    for lane in np.flatnonzero(here).tolist():
        since, which = sampled(s, lane, float(begin[lane]), float(ends[lane]))
        if not since.size:
            continue
        if moving:
            paced = s.roles.pace >= 0
            if paced:
                passed = [variable_at(s, top, np.full(s.columns.size, t))[lane] for t in since]
                since = np.minimum(passed, s.cells[ix.STEP, lane])
            x, omega, *further = (value(s.registers[r, :, lane], top, since) for r in registers)
            rate = value(s.registers[s.roles.net, :, lane], top - 1, since)
            if paced:
                rate = rate / (1.0 + s.cells[s.roles.pace, lane] * omega)
        else:
            x = omega = rate = np.zeros_like(since)
            further = [np.full_like(since, s.cells[q.cell, lane]) for q in s.states[2:]]
        fill(s, lane, which, [x, omega, rate, *further])


def fill(s: Lanes, lane: int, which: slice, states: Sequence[Floats]) -> None:
    """Store rotation, angular velocity, its rate, slip and as many further states as there are rows."""
    x, omega, rate, *further = states
    direction = s.cells[ix.DIRECTION, lane]
    rotation = s.cells[ix.ROTATION, lane] + direction * x
    rows = [rotation, direction * omega, direction * rate, s.cells[ix.SLIP, lane] + x, *further]
    for row, values in zip(s.samples.states, rows, strict=False):
        row[which, s.columns[lane]] = values


def sample_time(s: Lanes, number: int) -> Floats:
    """Return a sample time of each lane."""
    times: Floats = s.samples.times[number]
    return times[s.columns] if times.size > 1 else np.full(s.columns.size, times[0])


def keep_sample(s: Lanes, here: Mask, number: int, x: Floats, omega: Floats, rate: Floats) -> None:
    """Store the states of lanes at a sample time."""
    for lane in np.flatnonzero(here).tolist():
        fill(s, lane, slice(number, number + 1), [x[lane], omega[lane], rate[lane]])


# --- the text of derive/flow/integrator ----------------------------------------------------------------------------

EPS = 2.220446049250313e-16
SINES = (0.0, 0.009607359798384776, 0.03806023374435662, 0.08426519384872735, 0.14644660940672624, 0.22221488349019888,
    0.3086582838174551, 0.40245483899193585, 0.4999999999999999)
COSINES = (0.5, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 0.5, 0.5, 0.9807852804032304, 0.9238795325112867, 0.8314696123025452,
    0.7071067811865476, 0.5555702330196022, 0.3826834323650898, 0.19509032201612828, 0.0, 0.25, 0.46193976625564337,
    0.3535533905932738, 0.1913417161825449, 0.0, -0.1913417161825449, -0.3535533905932738, -0.46193976625564337, -0.25,
    0.16666666666666666, 0.2771565374341817, 0.12756114412169658, -0.06503010733870943, -0.23570226039551587,
    -0.3269284268010768, -0.30795984417042893, -0.18519007767320073, 0.0, 0.125, 0.1767766952966369, 0.0,
    -0.1767766952966369, -0.25, -0.1767766952966369, 0.0, 0.1767766952966369, 0.125, 0.1, 0.11111404660392044,
    -0.07653668647301795, -0.1961570560806461, -0.1414213562373095, 0.03901806440322565, 0.18477590650225734,
    0.16629392246050906, 0.0, 0.08333333333333333, 0.06378057206084829, -0.11785113019775793, -0.15397992208521447, 0.0,
    0.15397992208521447, 0.11785113019775793, -0.06378057206084829, -0.08333333333333333, 0.07142857142857142,
    0.027870046002304038, -0.13198279035875524, -0.07936717614565746, 0.10101525445522108, 0.11878137318607788,
    -0.054669061766441394, -0.1401121829147472, 0.0, 0.0625, 0.0, -0.125, 0.0, 0.125, 0.0, -0.125, 0.0, 0.0625,
    0.05555555555555555, -0.021676702446236474, -0.10265328139014297, 0.06173002589106691, 0.07856742013183862,
    -0.09238551247806058, -0.042520381373898866, 0.10897614226702561, 0.0, 0.05, -0.038268343236508975,
    -0.07071067811865475, 0.09238795325112867, 0.0, -0.09238795325112867, 0.07071067811865475, 0.038268343236508975,
    -0.05, 0.045454545454545456, -0.050506384819963834, -0.03478940294228089, 0.08916229821847549, -0.0642824346533225,
    -0.017735483819648026, 0.08398904841011698, -0.07558814657295866, 0.0, 0.041666666666666664, -0.05892556509887897,
    0.0, 0.05892556509887897, -0.08333333333333333, 0.05892556509887897, 0.0, -0.05892556509887897,
    0.041666666666666664, 0.038461538461538464, -0.06395920094634963, 0.029437187105006906, 0.015006947847394482,
    -0.05439282932204212, 0.07544502156947927, -0.07106765634702206, 0.04273617177073863, 0.0, 0.03571428571428571,
    -0.06599139517937762, 0.05050762722761054, -0.027334530883220697, 0.0, 0.027334530883220697, -0.05050762722761054,
    0.06599139517937762, -0.03571428571428571, 0.03333333333333333, -0.06538568536021536, 0.061591968834085783,
    -0.05543130748683635, 0.047140452079103175, -0.037038015534640145, 0.02551222882433932, -0.013006021467741885, 0.0,
    0.03125, -0.0625, 0.0625, -0.0625, 0.0625, -0.0625, 0.0625, -0.0625, 0.03125)
ARCSINE = (1.0, 0.16666666666666666, 0.075, 0.044642857142857144, 0.030381944444444444, 0.022372159090909092,
    0.017352764423076924, 0.01396484375, 0.011551800896139705, 0.009761609529194078, 0.008390335809616815,
    0.0073125258735988454, 0.006447210311889649, 0.005740037670841924, 0.005153309682319905, 0.004660143486915096,
    0.004240907093679363, 0.003880964558837669, 0.0035692053938259347, 0.003297059503473485, 0.0030578216492580306)
LAST_OF_ARCSINE = 20
SHORTEST = 6
NODES = (0.033765242898423975, 0.16939530676686776, 0.38069040695840156, 0.6193095930415985, 0.8306046932331322,
    0.966234757101576, 0.009219682876640378, 0.047941371814762546, 0.11504866290284765, 0.20634102285669126,
    0.31608425050090994, 0.43738329574426554, 0.5626167042557344, 0.6839157494990901, 0.7936589771433087,
    0.8849513370971523, 0.9520586281852375, 0.9907803171233596, 0.0024063900014893447, 0.012635722014345263,
    0.0308627239986336, 0.056792236497799464, 0.08999900701304853, 0.12993790421072282, 0.17595317403151223,
    0.22728926430558022, 0.28310324618697746, 0.3424786601519183, 0.40444056626319186, 0.4679715535686972,
    0.5320284464313028, 0.5955594337368082, 0.6575213398480817, 0.7168967538130225, 0.7727107356944198,
    0.8240468259684878, 0.8700620957892772, 0.9100009929869515, 0.9432077635022005, 0.9691372760013663,
    0.9873642779856547, 0.9975936099985107, 0.0006144963737869658, 0.003234913866824618, 0.007937708138586574,
    0.014704203726876364, 0.023506148419784545, 0.034306654646722834, 0.047060431642215184, 0.06171398986287607,
    0.07820586918780326, 0.09646689798527869, 0.11642048374212982, 0.13798293453809268, 0.16106381018366805,
    0.1855663016117432, 0.21138763695801366, 0.2384195126388835, 0.2665485476245208, 0.2956567590046416,
    0.32562205685391965, 0.3563187563222722, 0.38761810480265546, 0.41938882196555416, 0.4514976503952687,
    0.4838099145185653, 0.5161900854814346, 0.5485023496047313, 0.5806111780344458, 0.6123818951973445,
    0.6436812436777277, 0.6743779431460803, 0.7043432409953584, 0.7334514523754792, 0.7615804873611165,
    0.7886123630419863, 0.8144336983882567, 0.8389361898163319, 0.8620170654619073, 0.8835795162578701,
    0.9035331020147213, 0.9217941308121967, 0.938286010137124, 0.9529395683577848, 0.9656933453532772,
    0.9764938515802155, 0.9852957962731237, 0.9920622918614135, 0.9967650861331754, 0.999385503626213)
SHARES = (0.17132449237917036, 0.3607615730481386, 0.46791393457269104, 0.46791393457269104, 0.3607615730481386,
    0.17132449237917036, 0.04717533638651183, 0.10693932599531843, 0.16007832854334622, 0.20316742672306592,
    0.2334925365383548, 0.24914704581340277, 0.24914704581340277, 0.2334925365383548, 0.20316742672306592,
    0.16007832854334622, 0.10693932599531843, 0.04717533638651183, 0.0123412297999872, 0.028531388628933663,
    0.04427743881741981, 0.05929858491543678, 0.0733464814110803, 0.08619016153195327, 0.09761865210411388,
    0.10744427011596563, 0.1155056680537256, 0.12167047292780339, 0.1258374563468283, 0.12793819534675216,
    0.12793819534675216, 0.1258374563468283, 0.12167047292780339, 0.1155056680537256, 0.10744427011596563,
    0.09761865210411388, 0.08619016153195327, 0.0733464814110803, 0.05929858491543678, 0.04427743881741981,
    0.028531388628933663, 0.0123412297999872, 0.0031533460523058385, 0.0073275539012762625, 0.01147723457923454,
    0.015579315722943849, 0.01961616045735553, 0.02357076083932438, 0.027426509708356948, 0.03116722783279809,
    0.03477722256477044, 0.03824135106583071, 0.04154508294346475, 0.04467456085669428, 0.04761665849249048,
    0.05035903555385447, 0.05289018948519367, 0.055199503699984165, 0.057277292100403214, 0.059114839698395635,
    0.06070443916589388, 0.062039423159892665, 0.06311419228625402, 0.06392423858464819, 0.06446616443595009,
    0.06473769681268392, 0.06473769681268392, 0.06446616443595009, 0.06392423858464819, 0.06311419228625402,
    0.062039423159892665, 0.06070443916589388, 0.059114839698395635, 0.057277292100403214, 0.055199503699984165,
    0.05289018948519367, 0.05035903555385447, 0.04761665849249048, 0.04467456085669428, 0.04154508294346475,
    0.03824135106583071, 0.03477722256477044, 0.03116722783279809, 0.027426509708356948, 0.02357076083932438,
    0.01961616045735553, 0.015579315722943849, 0.01147723457923454, 0.0073275539012762625, 0.0031533460523058385)
LAST_SHARES = (-0.3876791299527941, 1.1682732733664538, -1.7223019283558145, 1.7223019283558145, -1.1682732733664538,
    0.3876791299527941, -0.11253711127058313, 0.3787454113112651, -0.6920832471686439, 0.9888453586985653,
    -1.2179538033266577, 1.3423224756654495, -1.3423224756654495, 1.2179538033266577, -0.9888453586985653,
    0.6920832471686439, -0.3787454113112651, 0.11253711127058313, -0.030148844086217933, 0.10450373227140303,
    -0.20157312656922508, 0.31217774827820993, -0.42930015376012065, 0.546768530245034, -0.658980420783875,
    0.7608887698130468, -0.848074469558393, 0.9168449387260235, -0.9643317908246022, 0.9885732942601926,
    -0.9885732942601926, 0.9643317908246022, -0.9168449387260235, 0.848074469558393, -0.7608887698130468,
    0.658980420783875, -0.546768530245034, 0.42930015376012065, -0.31217774827820993, 0.20157312656922508,
    -0.10450373227140303, 0.03014884408621794, -0.007790034178160955, 0.027210382191082905, -0.053218548447853446,
    0.08410186396997915, -0.1187845228885847, 0.15643105228230791, -0.1963239421927137, 0.2378131591508195,
    -0.28029248353192465, 0.32318795454504484, -0.36595248109290257, 0.40806385480730345, -0.4490247379947773,
    0.488363825542185, -0.5256376989451522, 0.5604330646255685, -0.5923691692370727, 0.6211002458494637,
    -0.6463178840446435, 0.6677532432675436, -0.6851790473890056, 0.6984113123199125, -0.7073107694370226,
    0.711783956628457, -0.711783956628457, 0.7073107694370226, -0.6984113123199125, 0.6851790473890056,
    -0.6677532432675436, 0.6463178840446435, -0.6211002458494637, 0.5923691692370727, -0.5604330646255685,
    0.5256376989451522, -0.488363825542185, 0.4490247379947773, -0.40806385480730345, 0.36595248109290257,
    -0.32318795454504484, 0.28029248353192465, -0.2378131591508195, 0.19632394219271368, -0.15643105228230791,
    0.1187845228885847, -0.08410186396997914, 0.05321854844785345, -0.027210382191082915, 0.007790034178160959)
NEXT_SHARES = (0.6506981459528086, -1.3904518577536216, 0.739753711800813, 0.739753711800813, -1.3904518577536216,
    0.6506981459528086, 0.2108819967832719, -0.6537305004446008, 1.0172337816331414, -1.108736299700892,
    0.8552761124501606, -0.3209250907210808, -0.3209250907210808, 0.8552761124501606, -1.108736299700892,
    1.0172337816331414, -0.6537305004446008, 0.2108819967832719, 0.05870297804143083, -0.1992967279249246,
    0.37003878592342787, -0.5414071368112371, 0.6887484365130017, -0.7917585973595219, 0.8355933145971909,
    -0.8119664459895835, 0.7197832151957603, -0.565132082012826, 0.3605908690393087, -0.12389660921202703,
    -0.12389660921202703, 0.3605908690393087, -0.565132082012826, 0.7197832151957603, -0.8119664459895835,
    0.8355933145971909, -0.7917585973595219, 0.6887484365130017, -0.5414071368112371, 0.37003878592342787,
    -0.1992967279249246, 0.058702978041430834, 0.015395378857163742, -0.05349347277944267, 0.10363303001903507,
    -0.16152034625672088, 0.22399186460403825, -0.28829564702411775, 0.3519075741302629, -0.4124853958917247,
    0.4678720159660525, -0.5161184901411058, 0.5555142313787836, -0.5846181008158503, 0.6022867338773646,
    -0.6076977904534808, 0.6003665987606669, -0.5801551888747979, 0.5472731144586855, -0.5022697983595777,
    0.44601843579385353, -0.3796917587665565, 0.30473021064864453, -0.2228033001446087, 0.13576509711972842,
    -0.04560499610629582, -0.04560499610629582, 0.13576509711972842, -0.2228033001446087, 0.30473021064864453,
    -0.3796917587665565, 0.44601843579385353, -0.5022697983595777, 0.5472731144586855, -0.5801551888747979,
    0.6003665987606669, -0.6076977904534808, 0.6022867338773646, -0.5846181008158503, 0.5555142313787836,
    -0.5161184901411058, 0.4678720159660525, -0.4124853958917247, 0.3519075741302629, -0.28829564702411775,
    0.22399186460403825, -0.16152034625672088, 0.10363303001903508, -0.05349347277944268, 0.015395378857163744)
RATIO = 0.25
RATIO_TO_ROUNDING = 0.18
LAST_STEP = 9.313225746154785e-10
MOST_ITERATIONS = 200
ROUNDING = 1.3877787807814457e-17
LARGEST = 1099511627776000.0
TIE = 5.684341886080802e-14
CLOSEST = 1e-300
SURE = 0.9999990463256836
SIXTH = 0.16666666666666666
ROUNDINGS = 134217728.0
FAR = 1e+300
TOP = 7
SHORT = 0.0078125
PRESSED = 0.01
SURELY = 4.0
BEYOND = 1.125
LONGEST = 1.0
REACH = 4.0
STRAIGHT = 16.0
NEWTON = 3
NEAREST = 0.9
EVEN = 9.5367431640625e-07
FINEST = 17
CLOSER = 2.9802322387695312e-08
MOST_HALVINGS = 30
BRIEFEST = 1e-07
LAST = 7
VERSINE = (0.5, -0.041666666666666664, 0.001388888888888889, -2.48015873015873e-05, 2.755731922398589e-07,
    -2.08767569878681e-09, 1.1470745597729725e-11, -4.779477332387385e-14)
LAG = (0.16666666666666666, -0.008333333333333333, 0.0001984126984126984, -2.7557319223985893e-06,
    2.505210838544172e-08, -1.6059043836821613e-10, 7.647163731819816e-13, -2.8114572543455206e-15)
FADING = (0.5, -0.16666666666666666, 0.041666666666666664, -0.008333333333333333, 0.001388888888888889,
    -0.0001984126984126984, 2.48015873015873e-05, -2.7557319223985893e-06, 2.755731922398589e-07,
    -2.505210838544172e-08, 2.08767569878681e-09, -1.6059043836821613e-10, 1.1470745597729725e-11,
    -7.647163731819816e-13, 4.779477332387385e-14)
HALF = 12
LEAST = 1e-100
SHIFT = 5
FIRST = 6
POLE = 7
POWER = 8
LOAD = 33
NET = 36
TERMS = 8
GREATEST = 0.0625
DRIVEN = 1024.0
ALIKE = 3.814697265625e-06
BETWEEN = 0.24
BENT = 0.325
CLOSER_TO_POLE = 3.0
LEAST_EXPONENT = -0.5
COMPLETE = 6.0
CONSTANT = 8
SINE = 16
VERS = 24
PI = 3.141592653589793
QUARTER = 0.7853981633974483
PAIRS = 8
LONG = 17
LAST_WAVE = 5.684341886080802e-14
MOST_CORRECTIONS = 12
LAST_OF_NEWTON = 1.4901161193847656e-08
OMEGA_THERE = 1
RATE_THERE = 2
ANGLE_THERE = 3
SLOPE_THERE = 4
FARTHEST = 3.14
FADED = 2.0
LAST_OF_HALLEY = 3.814697265625e-06
CLEAR = 0.01
CLOSE_TO_REST = 9.094947017729282e-13
LEAST_DURATION = 1.5
NEAR_MIDDLE = 0.85
TOUCHES = 2.0
TOGETHER = 1e-09
INFINITY = np.inf


def value(p: Floats, n: int, t: Floats) -> Floats:
    """Return the value at time t of the polynomial with coefficients p[0] to p[n], by Horner's scheme."""
    total = p[n]
    for k in range(n - 1, 0 - 1, -1):
        total = total * t + p[k]
    return total


def increment(p: Floats, n: int, t: Floats) -> Floats:
    """Return the value minus the constant term, without cancellation."""
    return t * value(p[1:], n - 1, t) if n > 0 else 0.0


def value_and_slope(p: Floats, n: int, t: Floats) -> tuple[Floats, Floats]:
    """Return the value and the derivative at a time."""
    total = p[n]
    slope: Floats = 0.0
    for k in range(n - 1, 0 - 1, -1):
        slope = slope * t + total
        total = total * t + p[k]
    return (total, slope)


def differentiate(rates: Floats, p: Floats, n: int) -> None:
    """Compute the coefficients of the derivative."""
    for k in range(1, n + 1):
        rates[k - 1] = p[k] * float(k)


def shift(p: Floats, n: int, by: Floats) -> None:
    """Shift a polynomial to another origin: Taylor's shift by Horner's scheme."""
    for first in range(n - 1 + 1):
        for j in range(n - 1, first - 1, -1):
            p[j] = p[j] + by * p[j + 1]


def inside_or_middle(at: Floats, low: Floats, high: Floats) -> Floats:
    """Return a place if it lies between two bounds, otherwise their middle."""
    return np.where((at >= low) & (at <= high), at, 0.5 * (low + high))


def bracketed_root(p: Floats, n: int, low: Floats, at_low: Floats, high: Floats, at_high: Floats,
        which: Mask) -> Floats:
    """Return a root between bounds at which values have opposite signs."""
    falls = at_low > 0.0
    share = at_low / (at_low - at_high)
    chord = low + (high - low) * share
    at = inside_or_middle(chord, low, high)
    count = 0
    while np.any(which) and count < MOST_ITERATIONS:
        residual, slope = value_and_slope(p, n, at)
        beyond = (residual > 0.0) != falls
        low = np.where(beyond, low, at)
        high = np.where(beyond, at, high)
        following = inside_or_middle(at - residual / slope, low, high)
        following = np.where(residual == 0.0, at, following)
        change = np.abs(following - at)
        at = np.where(which, following, at)
        which = which & (change > LAST_STEP * np.abs(following))
        count = count + 1
    return at


def first_root(p: Floats, n: int, h: Floats, which: Mask) -> Floats:
    """Return the first zero in (0, h] of initially positive polynomials, infinity without a zero."""
    high = h
    last, slope = value_and_slope(p, n, h)
    crosses = which & ((last < 0.0) | (last == 0.0) & (p[0] > 0.0))
    dips = which & np.logical_not(crosses) & (p[1] < 0.0) & (slope > 0.0)
    if np.any(dips):
        rates = np.zeros((ix.STRIDE, p.shape[1]))
        differentiate(rates, p, n)
        lowest = bracketed_root(rates, n - 1, 0.0, rates[0], h, slope, dips)
        least = value(p, n, lowest)
        terms = np.abs(p[n])
        for k in range(n - 1, 0 - 1, -1):
            terms = terms * h + np.abs(p[k])
        below = dips & (least < -4.0 * EPS * terms)
        high = np.where(below, lowest, high)
        last = np.where(below, least, last)
        crosses = crosses | below
    root: Floats = INFINITY
    if np.any(crosses):
        root = np.where(crosses, bracketed_root(p, n, 0.0, p[0], high, last, crosses), root)
    return root


def margin_of(e: Floats, p: Floats, n: int, sign: Floats, constant: Floats, divided: Mask) -> None:
    """Compute the coefficients of sign p + constant, divided by the time if its root at 0 is to be removed."""
    for k in range(n + 1):
        e[k] = sign * p[k]
    e[0] = e[0] + constant
    if np.any(divided):
        for k in range(n - 1 + 1):
            e[k] = np.where(divided, e[k + 1], e[k])
        e[n] = np.where(divided, 0.0, e[n])


def crossing(p: Floats, n: int, t: Floats, sign: Floats, constant: Floats, divided: Mask, here: Mask) -> Floats:
    """Return the first time in (0, t] at which sign p + constant falls through zero, infinity without a zero."""
    last, slope = value_and_slope(p, n, t)
    falls_and_rises = (sign * p[1] < 0.0) & (sign * slope > 0.0)
    asked = here & ((sign * last + constant <= 0.0) | falls_and_rises | divided)
    at: Floats = INFINITY
    if np.any(asked):
        e = np.zeros((ix.STRIDE, p.shape[1]))
        margin_of(e, p, n, sign, constant, divided)
        at = first_root(e, n, t, asked)
    return at


def falling_root(p: Floats, n: int, t: Floats, last: Floats, slope: Floats, here: Mask) -> Floats:
    """Return the zero in (0, t] at which polynomials become negative, possibly beyond a maximum, otherwise infinity."""
    touches = p[0] == 0.0
    positive = (p[0] > 0.0) | touches & (p[1] > 0.0)
    dips = (p[1] < 0.0) & (slope > 0.0)
    falls = here & positive & ((last < 0.0) | dips)
    e = np.zeros((ix.STRIDE, p.shape[1]))
    root: Floats = INFINITY
    if np.any(falls):
        margin_of(e, p, n, 1.0, 0.0, touches)
        root = first_root(e, n, t, falls)
    rises = (p[0] < 0.0) & (p[1] > 0.0)
    hump = here & rises & (last < 0.0) & (slope < 0.0)
    if np.any(hump):
        differentiate(e, p, n)
        top = bracketed_root(e, n - 1, 0.0, e[0], t, slope, hump)
        most = value(p, n, top)
        hump = hump & (most > 0.0)
        if np.any(hump):
            root = np.where(hump, bracketed_root(p, n, top, most, t, last, hump), root)
    return root


def end_of_piece(s: Lanes, t: Table, piece: Floats) -> Floats:
    """Return the end of a piece in the table's argument, infinity for the last piece."""
    last: Floats = float(t.pieces - 1)
    following = breaks_at(s, t, np.minimum(piece + 1.0, last))
    return np.where(piece < last, following, INFINITY)


def piece_at(s: Lanes, here: Mask, t: Table, first: Floats, argument: Floats, included: Mask) -> Floats:
    """Return the piece that contains an argument, searched from a first piece on."""
    piece = 1.0 * first
    goes_on = here
    while np.any(goes_on):
        end = end_of_piece(s, t, piece)
        ends_there = included & (end == argument)
        goes_on = goes_on & (end < INFINITY) & ((end < argument) | ends_there)
        piece = np.where(goes_on, piece + 1.0, piece)
    return piece


def value_within(s: Lanes, t: Table, piece: Floats, local: Floats) -> Floats:
    """Return a function of time, a sine or a straight line, at a distance from the left end of a piece."""
    c = s.cells
    height = coefficients_at(s, t, piece, 0)
    change = coefficients_at(s, t, piece, 1) * local
    value = height + change
    if t.sine:
        value = height * np.sin(change + coefficients_at(s, t, piece, 2))
    return c[t.cells + ix.SCALED_BY] * value


def since_break(s: Lanes, t: Table) -> Floats:
    """Return the distance of the current time from the left end of its piece, in the table's argument."""
    c = s.cells
    return c[ix.TIME] * c[t.cells + ix.SCALE] - breaks_at(s, t, c[t.cells + ix.PIECE])


def value_now(s: Lanes, t: Table) -> Floats:
    """Return a function of time at the current time."""
    c = s.cells
    local = since_break(s, t)
    return value_within(s, t, c[t.cells + ix.PIECE], local)


def expand_sine(s: Lanes, t: Table) -> None:
    """Compute the series of a sine about the current time, as its increment since the phase began."""
    c = s.cells
    size = coefficients_at(s, t, c[t.cells + ix.PIECE], 0) * c[t.cells + ix.SCALED_BY]
    rate = coefficients_at(s, t, c[t.cells + ix.PIECE], 1)
    angle = rate * since_break(s, t) + coefficients_at(s, t, c[t.cells + ix.PIECE], 2)
    now = np.sin(angle)
    slope = np.cos(angle)
    for j in range(1, s.highest + 1):
        size = size * (rate * c[t.cells + ix.SCALE] * (1.0 / j))
        s.registers[t.register][j] = size * slope
        before = now
        now = slope
        slope = -before


def rise_of_step(s: Lanes, t: Table) -> Floats:
    """Return the rise of a function of time over a step: of a sine by all terms, whatever the other lanes' orders."""
    c = s.cells
    last = s.highest if t.sine else 1
    return increment(s.registers[t.register], last, c[ix.STEP])


def rise_of_sine(s: Lanes, t: Table, local: Floats, past: Floats) -> Floats:
    """Return the rise of a sine over a distance ahead of a place in its piece: 2 A sin(r/2) cos(angle + r/2)."""
    c = s.cells
    rate = coefficients_at(s, t, c[t.cells + ix.PIECE], 1)
    half = 0.5 * rate * past
    angle = rate * local + coefficients_at(s, t, c[t.cells + ix.PIECE], 2)
    change = 2.0 * np.sin(half) * np.cos(angle + half)
    return c[t.cells + ix.SCALED_BY] * coefficients_at(s, t, c[t.cells + ix.PIECE], 0) * change


def find_end_of_piece(s: Lanes, here: Mask, t: Table, local: Floats) -> None:
    """Compute the end of the piece of a function of time and the increment there, from a distance from its left end."""
    c = s.cells
    if not np.any(here):
        return
    end = end_of_piece(s, t, c[t.cells + ix.PIECE])
    now = breaks_at(s, t, c[t.cells + ix.PIECE]) + local
    past = np.where(end < INFINITY, end - now, 0.0)
    slope = coefficients_at(s, t, c[t.cells + ix.PIECE], 1) * c[t.cells + ix.SCALED_BY]
    rise = slope * past
    if t.sine:
        rise = rise_of_sine(s, t, local, past)
    c[t.cells + ix.RISE] = np.where(here, slope * c[t.cells + ix.SCALE], c[t.cells + ix.RISE])
    c[t.cells + ix.UPPER] = np.where(here, end / c[t.cells + ix.SCALE], c[t.cells + ix.UPPER])
    c[t.cells + ix.LOWER] = np.where(here, c[t.cells + ix.INC] + rise, c[t.cells + ix.LOWER])
    c[t.cells + ix.WAY] = np.where(here, c[t.cells + ix.WAY] + np.abs(rise), c[t.cells + ix.WAY])


def enter_piece(s: Lanes, here: Mask, t: Table) -> None:
    """Enter the piece that contains the current time, without a value that is carried."""
    c = s.cells
    if not np.any(here):
        return
    now = c[ix.TIME] * c[t.cells + ix.SCALE]
    piece = piece_at(s, here, t, c[t.cells + ix.PIECE], now * (1.0 + 2.0 * EPS), here)
    c[ix.SCALE_BEFORE] = np.where(here, np.where(piece > c[t.cells + ix.PIECE], INFINITY, c[ix.SCALE_BEFORE]),
        c[ix.SCALE_BEFORE])
    c[t.cells + ix.PIECE] = np.where(here, piece, c[t.cells + ix.PIECE])
    c[t.cells + ix.WAY] = np.where(here, 0.0, c[t.cells + ix.WAY])
    c[t.cells + ix.VALUE] = np.where(here, value_now(s, t), c[t.cells + ix.VALUE])
    find_end_of_piece(s, here, t, since_break(s, t))


def begin_in_time(s: Lanes, here: Mask, t: Table) -> None:
    """Begin a phase: increments of a function of time are counted from now. It may jump at the left end of a piece."""
    c = s.cells
    if not np.any(here):
        return
    c[t.cells + ix.VALUE] = np.where(here, c[t.cells + ix.VALUE] + c[t.cells + ix.INC], c[t.cells + ix.VALUE])
    c[t.cells + ix.LOWER] = np.where(here, c[t.cells + ix.LOWER] - c[t.cells + ix.INC], c[t.cells + ix.LOWER])
    c[t.cells + ix.INC] = np.where(here, 0.0, c[t.cells + ix.INC])
    c[t.cells + ix.WAY] = np.where(here, np.abs(c[t.cells + ix.LOWER]), c[t.cells + ix.WAY])
    enter_piece(s, here & (c[t.cells + ix.UPPER] <= c[ix.TIME]), t)


def pass_break(s: Lanes, here: Mask, t: Table) -> None:
    """Enter the next piece of a function of time. If its value jumps, the contact must be checked."""
    c = s.cells
    if not np.any(here):
        return
    last: Floats = float(t.pieces - 1)
    piece = np.minimum(c[t.cells + ix.PIECE] + 1.0, last)
    jump = jumps_at(s, t, piece) * c[t.cells + ix.SCALED_BY]
    there = value_within(s, t, piece, 0.0)
    way = c[t.cells + ix.WAY] + np.abs(jump)
    rounding = np.abs(there) + np.abs(c[t.cells + ix.VALUE])
    is_long = way > rounding
    carried = c[t.cells + ix.LOWER] + jump
    c[ix.PENDING] = np.where(here, np.where(jump != 0.0, ix.DISCONTINUITY, c[ix.PENDING]), c[ix.PENDING])
    c[t.cells + ix.PIECE] = np.where(here, piece, c[t.cells + ix.PIECE])
    c[t.cells + ix.INC] = np.where(here, np.where(is_long, there - c[t.cells + ix.VALUE], carried), c[t.cells + ix.INC])
    c[t.cells + ix.WAY] = np.where(here, np.where(is_long, rounding, way), c[t.cells + ix.WAY])
    find_end_of_piece(s, here, t, 0.0)


def pass_breaks(s: Lanes, here: Mask) -> None:
    """Enter the next piece of each function of time that has a break now."""
    c = s.cells
    if not np.any(here):
        return
    for t in s.tables:
        if t.kind == ix.OF_TIME:
            pass_break(s, here & (c[t.cells + ix.UPPER] <= c[ix.TIME]), t)


def still_changes(s: Lanes) -> Mask:
    """Return whether a force will still change while lanes rest."""
    c = s.cells
    changes = none_of(s)
    for t in s.tables:
        if t.kind == ix.OF_TIME:
            changes = changes | (c[t.cells + ix.UPPER] < INFINITY)
    return changes


def next_break(s: Lanes) -> Floats:
    """Return the next time at which a function of time has a break."""
    c = s.cells
    time: Floats = INFINITY
    for t in s.tables:
        if t.kind == ix.OF_TIME:
            time = np.minimum(c[t.cells + ix.UPPER], time)
    return time


def develop(s: Lanes, here: Mask, t: Table, local: Floats, unit: Floats) -> None:
    """Compute the value at the start of a phase and the coefficients about it."""
    c = s.cells
    if not np.any(here):
        return
    terms = np.zeros((ix.STRIDE, s.registers[0].shape[1]))
    for j in range(t.terms - 1 + 1):
        terms[j] = coefficients_at(s, t, c[t.cells + ix.PIECE], j)
    shift(terms, t.terms - 1, local)
    factor = 1.0 * c[t.cells + ix.SCALED_BY]
    c[t.cells + ix.VALUE] = np.where(here, factor * terms[0], c[t.cells + ix.VALUE])
    for j in range(1, t.degree + 1):
        factor = factor * unit
        coefficient = factor * terms[j] if j < t.terms else 0.0
        c[t.cells + ix.Q1 + (j - 1)] = np.where(here, coefficient, c[t.cells + ix.Q1 + (j - 1)])


def begin_in_rotation(s: Lanes, here: Mask, t: Table) -> None:
    """Select the piece of a function of the rotation ahead in the direction of travel, which may be either."""
    c = s.cells
    if not np.any(here):
        return
    forward = c[ix.DIRECTION] > 0.0
    c[t.cells + ix.PIECE] = np.where(here, piece_at(s, here, t, 0.0, c[ix.ROTATION], forward), c[t.cells + ix.PIECE])
    local = c[ix.ROTATION] - breaks_at(s, t, c[t.cells + ix.PIECE])
    ahead = end_of_piece(s, t, c[t.cells + ix.PIECE]) - c[ix.ROTATION]
    behind = np.where(c[t.cells + ix.PIECE] > 0.0, local, INFINITY)
    c[t.cells + ix.UPPER] = np.where(here, np.where(forward, ahead, behind), c[t.cells + ix.UPPER])
    develop(s, here, t, local, c[ix.DIRECTION])


def begin_in_slip(s: Lanes, here: Mask, t: Table) -> None:
    """Select the piece of a function of slip, which ends ahead even if another function has just passed a break."""
    c = s.cells
    if not np.any(here):
        return
    edge = breaks_at(s, t, c[t.cells + ix.PIECE])
    local = np.maximum(c[ix.SLIP] * c[t.cells + ix.SCALE] - edge, 0.0)
    ahead = end_of_piece(s, t, c[t.cells + ix.PIECE]) - edge - local
    c[t.cells + ix.UPPER] = np.where(here, np.maximum(ahead / c[t.cells + ix.SCALE], EPS * c[ix.SLIP]),
        c[t.cells + ix.UPPER])
    develop(s, here, t, local, c[t.cells + ix.SCALE])


def begin_in_speed(s: Lanes, here: Mask, t: Table) -> None:
    """Select the piece of a polynomial of the logarithm of the speed. Piece 0, below the first speed, is constant."""
    c = s.cells
    if not np.any(here):
        return
    edge = breaks_at(s, t, c[t.cells + ix.PIECE])
    speed = c[ix.OMEGA] * c[t.cells + ix.SCALE]
    varies = c[t.cells + ix.PIECE] > 0.0
    moves = varies & (speed > 0.0)
    ratio = np.where(moves, speed / np.where(moves, edge, 1.0), 1.0)
    c[t.cells + ix.UPPER] = np.where(here, end_of_piece(s, t, c[t.cells + ix.PIECE]) / c[t.cells + ix.SCALE],
        c[t.cells + ix.UPPER])
    c[t.cells + ix.LOWER] = np.where(here, np.where(varies, edge / c[t.cells + ix.SCALE], 0.0), c[t.cells + ix.LOWER])
    develop(s, here, t, np.log(ratio), 1.0)


def begin_pieces(s: Lanes, here: Mask) -> None:
    """Begin a phase: compute the ends of each table's piece, its value, and its coefficients."""
    if not np.any(here):
        return
    for t in s.tables:
        if t.kind == ix.OF_TIME:
            begin_in_time(s, here, t)
        if t.kind == ix.OF_ROTATION:
            begin_in_rotation(s, here, t)
        if t.kind == ix.OF_SLIP:
            begin_in_slip(s, here, t)
        if t.kind == ix.OF_SPEED:
            begin_in_speed(s, here, t)


def find_pieces(s: Lanes, here: Mask) -> None:
    """Find the pieces that contain slip and speed."""
    c = s.cells
    if not np.any(here):
        return
    for t in s.tables:
        if t.kind == ix.OF_SLIP:
            c[t.cells + ix.PIECE] = np.where(here, piece_at(s, here, t, 0.0, c[ix.SLIP] * c[t.cells + ix.SCALE], here),
                c[t.cells + ix.PIECE])
        if t.kind == ix.OF_SPEED:
            c[t.cells + ix.PIECE] = np.where(here, piece_at(s, here, t, 0.0, c[ix.OMEGA] * c[t.cells + ix.SCALE], here),
                c[t.cells + ix.PIECE])


def begin_series(s: Lanes) -> None:
    """Set order 0 of the registers that do not result from operations."""
    c = s.cells
    for q in s.states:
        s.registers[q.register][0] = c[q.cell]
    for t in s.tables:
        if t.kind == ix.OF_TIME:
            s.registers[t.register][0] = c[t.cells + ix.INC]


def per_time(s: Lanes, rate: Floats, omega: Floats) -> Floats:
    """Return a rate by time from a rate by tau, the variable of a step, where dt = (1 + pace omega) dtau."""
    c = s.cells
    if s.roles.pace >= 0:
        return rate / (1.0 + c[s.roles.pace] * omega)
    return rate


def find_clock(s: Lanes, t: Floats, top: int) -> None:
    """Compute the time since the beginning of a step as a series in tau."""
    c = s.cells
    t[0] = 0.0
    for k in range(top - 1 + 1):
        t[k + 1] = c[s.roles.pace] * s.registers[s.roles.omega][k] * (1.0 / (k + 1))
    t[1] = 1.0 + t[1]


def elapsed(s: Lanes, top: int, at: Floats) -> Floats:
    """Return the time since the beginning of a step from its variable."""
    if s.roles.pace >= 0:
        t = np.zeros((ix.STRIDE, s.registers[0].shape[1]))
        find_clock(s, t, top)
        return value(t, top, at)
    return at


def variable_at(s: Lanes, top: int, time: Floats) -> Floats:
    """Return the variable of a step from the time since its beginning, infinite if the step does not last so long."""
    c = s.cells
    if s.roles.pace >= 0:
        left = np.zeros((ix.STRIDE, s.registers[0].shape[1]))
        find_clock(s, left, top)
        limited = time < INFINITY
        margin_of(left, left, top, -1.0, np.where(limited, time, 0.0), none_of(s))
        return first_root(left, top, c[ix.STEP], limited)
    return np.where(time <= c[ix.STEP], time, INFINITY)


def evaluate(s: Lanes) -> None:
    """Compute order 0 of all registers. Rates of states are per time."""
    c = s.cells
    begin_series(s)
    operate(s, 0, 1, False, False)
    operate_later(s, 1)
    for q in s.states:
        s.registers[q.rate][0] = per_time(s, s.registers[q.rate][0], c[ix.OMEGA])


def normal_force(s: Lanes) -> Floats:
    """Return the normal force on the slip surface from order 0. Contact is lost if it is negative."""
    c = s.cells
    force = c[s.roles.normal0].copy()
    if s.roles.normal >= 0:
        force = s.registers[s.roles.normal][0].copy()
    return force


def find_negligible(s: Lanes, here: Mask) -> None:
    """Compute the size of the last terms over the largest term of a step that a break cuts short, factor^order."""
    c = s.cells
    if not np.any(here):
        return
    negligible: Floats = 1.0
    for n in range(1, s.highest + 1):
        negligible = np.where(c[ix.ORDER] >= float(n), negligible * c[ix.FACTOR], negligible)
    c[ix.NEGLIGIBLE] = np.where(here, np.maximum(negligible, ROUNDING), c[ix.NEGLIGIBLE])


def truncate(p: Floats, order: Floats, top: int) -> None:
    """Set the coefficients of a series from each lane's order on to zero."""
    for n in range(least(order), top - 1 + 1):
        p[n] = np.where(order > float(n), p[n], 0.0)


def cut(s: Lanes, order: Floats, top: int) -> None:
    """Truncate the series of the states, and those that events use, at each lane's order."""
    for q in s.states:
        truncate(s.registers[q.register][1:], order, top)
    truncate(s.registers[s.roles.net], order, top)
    if s.roles.normal >= 0:
        truncate(s.registers[s.roles.normal], order, top)
    if s.roles.upright >= 0:
        truncate(s.registers[s.roles.upright], order, top)


def begin_expansion(s: Lanes, which: Mask, top: int, at_rest: int) -> None:
    """Set order 0 of the registers that do not result from operations, and the series of functions of time."""
    c = s.cells
    begin_series(s)
    if at_rest:
        for q in s.states:
            for n in range(1, top + 1):
                s.registers[q.register][n] = 0.0
    for t in s.tables:
        if t.kind == ix.OF_TIME:
            s.registers[t.register][1] = c[t.cells + ix.RISE]
        if t.sine:
            expand_sine(s, t)
    c[ix.LARGEST_OMEGA] = 0.0 if at_rest else np.abs(s.registers[s.roles.omega][0])


def next_term_counts(s: Lanes, n: int, power: Floats, at_rest: int) -> Mask:
    """Return whether coefficient n times a power of the step is significant beside the largest term so far."""
    c = s.cells
    omega = s.registers[s.roles.net] if at_rest else s.registers[s.roles.omega]
    term = np.abs(omega[n]) * power
    largest = 1.0 * c[ix.LARGEST_OMEGA]
    negligible = (term <= c[ix.NEGLIGIBLE] * largest) & (largest > 0.0) & (largest < INFINITY)
    c[ix.LARGEST_OMEGA] = np.maximum(term, largest)
    return np.logical_not(negligible)


def expand(s: Lanes, room: Floats, which: Mask, at_rest: int) -> int:
    """Compute the series of all registers, of states to one order more than of rates; return the highest order."""
    c = s.cells
    order = np.where(which, c[ix.ORDER], 1.0)
    top = greatest(order)
    alike = all_lanes(order == float(top))
    begin_expansion(s, which, top, at_rest)
    first = c[ix.LARGEST_OMEGA].copy()
    power = 1.0 if at_rest else room
    in_a_row: Floats = 0.0
    n = 0
    if not s.timed:
        operate(s, 0, top, False, True)
        n = top
    computed = 0
    while n < top:
        if n == computed:
            computed = min(n + 2, top)
            operate(s, n, computed, False, not at_rest)
        counts = next_term_counts(s, n if at_rest else n + 1, power, at_rest)
        power = power * room
        in_a_row = np.where(counts, 0.0, in_a_row + 1.0)
        enough = np.where(c[ix.LARGEST_OMEGA] > first, 3.0, 2.0)
        ends = (in_a_row >= (2.0 if at_rest else enough)) & (order > float(n)) & which
        if n >= 2 and np.any(ends):
            order = np.where(ends, np.minimum(order, float(n + 1)), order)
            alike = False
            if not np.any(order > float(n + 1)):
                top = n + 1
        n = n + 1
    operate_later(s, top)
    if not alike:
        cut(s, order, top)
    c[ix.SERIES_ORDER] = order
    c[ix.STEP] = room
    return top


def longest_step(s: Lanes, p: Floats, top: int, order: Floats) -> Floats:
    """Return the longest step at the end of which each of the last four terms is small beside one of the first five."""
    c = s.cells
    first = np.zeros((ix.STRIDE, p.shape[1]))
    comparable = p[0] != 0.0
    for k in range(4 + 1):
        first[k] = log2_of(p[k])
        comparable = comparable | (p[k] != 0.0)
    one: Floats = 1.0
    share = log2_of(c[ix.FACTOR]) - log2_of(one)
    lowest: Floats = LARGEST
    for n in range(max(least(order) - 3, 5), top + 1):
        last = log2_of(p[n]) - float(n) * share
        most: Floats = -LARGEST
        for k in range(4 + 1):
            most = np.maximum((first[k] - last) * (1.0 / (n - k)), most)
        among_last = (order >= float(n)) & (order <= float(n + 3))
        counts = comparable & among_last & (p[n] != 0.0)
        lowest = np.where(counts & (most < lowest), most, lowest)
    return power_of_two(lowest)


def keep_faster(s: Lanes, here: Mask, speed: Floats, time: Floats, x: Floats, rate: Floats) -> None:
    """Record a candidate for the greatest speed in the current step if it exceeds the record."""
    c = s.cells
    if not np.any(here):
        return
    faster = here & (speed > np.abs(c[ix.PEAK_OMEGA]))
    if np.any(faster):
        begins = c[ix.PEAK_TIME] == c[ix.TIME]
        clearly = speed > (1.0 + TIE) * np.abs(c[ix.PEAK_OMEGA])
        faster = faster & (begins | clearly)
        c[ix.PEAK_OMEGA] = np.where(here, np.where(faster, c[ix.DIRECTION] * speed, c[ix.PEAK_OMEGA]), c[ix.PEAK_OMEGA])
        c[ix.PEAK_TIME] = np.where(here, np.where(faster, time, c[ix.PEAK_TIME]), c[ix.PEAK_TIME])
        c[ix.PEAK_ROTATION] = np.where(here, np.where(faster, c[ix.ROTATION] + c[ix.DIRECTION] * x,
            c[ix.PEAK_ROTATION]), c[ix.PEAK_ROTATION])
        c[ix.PEAK_RATE] = np.where(here, np.where(faster, c[ix.DIRECTION] * rate, c[ix.PEAK_RATE]), c[ix.PEAK_RATE])


def update_reach(s: Lanes, here: Mask) -> None:
    """Record the current rotation if it is the greatest from the start."""
    c = s.cells
    if not np.any(here):
        return
    rotation = c[ix.ROTATION] + c[ix.DIRECTION] * c[ix.X]
    here = here & (np.abs(rotation) > np.abs(c[ix.REACH_ROTATION]))
    c[ix.REACH_ROTATION] = np.where(here, rotation, c[ix.REACH_ROTATION])
    c[ix.REACH_TIME] = np.where(here, c[ix.TIME], c[ix.REACH_TIME])


def note_lift_off(s: Lanes, here: Mask) -> None:
    """Log the loss of contact with the slip surface."""
    c = s.cells
    if not np.any(here):
        return
    if s.logged:
        note(s, here, ix.NOTE_LIFTS)
    here = here & (c[ix.LIFT_TIME] != c[ix.LIFT_TIME])
    c[ix.LIFT_TIME] = np.where(here, c[ix.TIME], c[ix.LIFT_TIME])


def advance_origin(s: Lanes, here: Mask) -> None:
    """Reset the origin of rotation and slip to the current position, where another phase begins."""
    c = s.cells
    if not np.any(here):
        return
    c[ix.ROTATION] = np.where(here, c[ix.ROTATION] + c[ix.DIRECTION] * c[ix.X], c[ix.ROTATION])
    c[ix.SLIP] = np.where(here, c[ix.SLIP] + c[ix.X], c[ix.SLIP])
    c[ix.X] = np.where(here, 0.0, c[ix.X])


def face(s: Lanes, here: Mask, side: Floats) -> None:
    """Set the direction of travel at a standstill."""
    c = s.cells
    if not np.any(here):
        return
    c[ix.X] = np.where(here, 0.0, c[ix.X])
    c[ix.OMEGA] = np.where(here, 0.0, c[ix.OMEGA])
    c[ix.DIRECTION] = np.where(here, side, c[ix.DIRECTION])
    c[ix.LIFTED] = np.where(here, 0.0, c[ix.LIFTED])


def start(s: Lanes, here: Mask) -> None:
    """Start lanes with a velocity or at rest."""
    c = s.cells
    if not np.any(here):
        return
    c[ix.DIRECTION] = np.where(here, np.where(c[ix.OMEGA] < 0.0, -1.0, 1.0), c[ix.DIRECTION])
    c[ix.OMEGA] = np.where(here, np.abs(c[ix.OMEGA]), c[ix.OMEGA])
    c[ix.X] = np.where(here, 0.0, c[ix.X])
    c[ix.LIFTED] = np.where(here, 0.0, c[ix.LIFTED])
    c[ix.FACED] = np.where(here, 0.0, c[ix.FACED])
    moves = c[ix.OMEGA] > 0.0
    c[ix.PENDING] = np.where(here, np.where(moves, ix.START_MOVING, ix.RESOLVE), c[ix.PENDING])
    c[ix.CLOCKED] = np.where(here, 0.0, c[ix.CLOCKED])
    c[ix.NEGLIGIBLE] = np.where(here, ROUNDING, c[ix.NEGLIGIBLE])
    if s.timed:
        find_negligible(s, here)
    find_pieces(s, here)


def count_phase(s: Lanes, here: Mask) -> None:
    """Count a phase that begins in the current direction."""
    c = s.cells
    if not np.any(here):
        return
    turns = c[ix.LAST_WAY] * c[ix.DIRECTION] < 0.0
    c[ix.PHASES] = np.where(here, c[ix.PHASES] + 1.0, c[ix.PHASES])
    c[ix.TURNS] = np.where(here, c[ix.TURNS] + np.where(turns, 1.0, 0.0), c[ix.TURNS])
    c[ix.LAST_WAY] = np.where(here, c[ix.DIRECTION], c[ix.LAST_WAY])


def start_moving(s: Lanes, here: Mask, rate: Floats) -> None:
    """Start slip in the current direction."""
    c = s.cells
    if not np.any(here):
        return
    c[ix.STATUS] = np.where(here, ix.MOVING, c[ix.STATUS])
    c[ix.PASSED] = np.where(here, ix.NOTHING, c[ix.PASSED])
    count_phase(s, here)
    if s.logged:
        note(s, here, ix.NOTE_BEGINS)
    note_lift_off(s, here & (c[ix.LIFTED] > 0.0))
    keep_faster(s, here, c[ix.OMEGA], c[ix.TIME], c[ix.X], rate)
    c[ix.PENDING] = np.where(here, ix.READY, c[ix.PENDING])


def stay(s: Lanes, here: Mask, status: Floats) -> None:
    """Keep lanes at rest until their end."""
    c = s.cells
    if not np.any(here):
        return
    c[ix.STATUS] = np.where(here, status, c[ix.STATUS])
    c[ix.END_ROTATION] = np.where(here, c[ix.ROTATION], c[ix.END_ROTATION])
    c[ix.END_OMEGA] = np.where(here, 0.0, c[ix.END_OMEGA])
    c[ix.END_RATE] = np.where(here, 0.0, c[ix.END_RATE])
    c[ix.DIRECTION] = np.where(here, 0.0, c[ix.DIRECTION])
    c[ix.REST_SINCE] = np.where(here, np.where(c[ix.REST_SINCE] > c[ix.END_TIME], c[ix.END_TIME], c[ix.REST_SINCE]),
        c[ix.REST_SINCE])
    c[ix.PENDING] = np.where(here, ix.READY, c[ix.PENDING])
    for_ever: Floats = INFINITY
    if s.sample_count:
        read_samples(s, here, c[ix.TIME], for_ever, 0, 0)


def may_start(s: Lanes) -> Mask:
    """Return whether masses at rest may start in their direction. Shaking starts a one-way mass only down-slope."""
    c = s.cells
    pull = c[s.roles.driving_moment].copy()
    down_slope = (pull > 0.0) | (pull == 0.0) & (c[ix.DIRECTION] > 0.0)
    return (c[ix.ONE_WAY] == 0.0) | down_slope


def never_rests(s: Lanes) -> Mask:
    """Return whether masses swing for ever, because almost no force presses on them at their lowest point."""
    c = s.cells
    load = c[s.roles.normal_load].copy()
    slope = c[s.roles.normal_load_slope].copy()
    square = load * load + slope * slope
    most = np.sqrt(square)
    least = c[s.roles.normal0] + (most - load)
    carried = least <= ix.CARRIED * most
    return (c[ix.FIRST_ONLY] == 1.0) | carried & np.logical_not(still_changes(s))


def stick(s: Lanes, here: Mask) -> None:
    """Keep masses at rest, until a force changes or for good."""
    c = s.cells
    if not np.any(here):
        return
    changes = still_changes(s)
    stay(s, here & np.logical_not(changes), ix.ARRESTED)
    here = here & changes
    c[ix.STATUS] = np.where(here, ix.RESTING, c[ix.STATUS])
    c[ix.PENDING] = np.where(here, ix.READY, c[ix.PENDING])
    note_lift_off(s, here & (c[ix.LIFTED] > 0.0))
    here = here & np.logical_not(may_start(s))
    c[ix.DIRECTION] = np.where(here, -c[ix.DIRECTION], c[ix.DIRECTION])
    c[ix.PENDING] = np.where(here, ix.BEGIN_PHASE, c[ix.PENDING])


def rest_one_way(s: Lanes, here: Mask) -> None:
    """Let masses that moved down-slope stick, since they do not turn back, in the direction in which they may start."""
    c = s.cells
    if not np.any(here):
        return
    may = may_start(s)
    stick(s, here & may)
    here = here & np.logical_not(may)
    face(s, here, -c[ix.DIRECTION])
    c[ix.PENDING] = np.where(here, ix.RESOLVE, c[ix.PENDING])


def resolve_stick_or_slip(s: Lanes, here: Mask) -> None:
    """Start slip in the current direction, otherwise in the other direction if it is allowed, otherwise stick."""
    c = s.cells
    if not np.any(here):
        return
    terms = np.abs(c[s.roles.driving]) + c[s.roles.resisting]
    unsure = EPS * (terms + c[s.roles.mu] * np.abs(c[s.roles.normal0]))
    of_weight = (c[s.roles.driving] == c[s.roles.driving_moment]) & (c[s.roles.normal0] == c[s.roles.normal_load])
    of_weight = of_weight & (c[s.roles.resisting] == 0.0)
    refined = (c[ix.LIMIT_REST] * c[s.roles.drive] != 0.0) & of_weight
    unsure = np.maximum(np.where(refined, c[s.roles.drive_scale], unsure), CLOSEST)
    may = here & may_start(s)
    margin = np.abs(c[s.roles.drive]) / unsure
    c[ix.CLOSE] = np.where(here, np.where(may, np.minimum(c[ix.CLOSE], margin), c[ix.CLOSE]), c[ix.CLOSE])
    starts = may & (c[s.roles.drive] > 0.0)
    start_moving(s, starts, c[s.roles.drive])
    here = here & np.logical_not(starts)
    c[ix.FACED] = np.where(here, c[ix.FACED] + 1.0, c[ix.FACED])
    stays_down = may & (c[ix.ONE_WAY] > 0.0)
    sticks = here & ((c[ix.FACED] > 1.0) | stays_down)
    stick(s, sticks)
    face(s, here & np.logical_not(sticks), -c[ix.DIRECTION])


def resolve_standstill(s: Lanes, here: Mask) -> None:
    """Decide whether masses at a standstill, or at the start, stop, stick or slip."""
    c = s.cells
    if not np.any(here):
        return
    stops = here & (c[ix.FIRST_ONLY] > 0.0) & (c[ix.PHASES] > 0.0)
    if np.any(stops):
        stops = stops & never_rests(s)
        stay(s, stops, ix.STOPPED)
        here = here & np.logical_not(stops)
    one_way = here & (c[ix.PENDING] == ix.REST)
    rest_one_way(s, one_way)
    resolve_stick_or_slip(s, here & np.logical_not(one_way))


def carry_net_moment(s: Lanes, here: Mask, net: Floats) -> None:
    """Begin a phase in motion with the drive computed anew or continued, whichever is more accurate."""
    c = s.cells
    if not np.any(here):
        return
    c[ix.PENDING] = np.where(here, ix.READY, c[ix.PENDING])
    change = net - c[s.roles.drive]
    terms = np.abs(c[ix.RATE_BEFORE]) + np.abs(change) + np.abs(c[ix.DRIVE_BEFORE])
    carried = c[ix.SCALE_BEFORE] + EPS * terms
    here = here & (carried < c[s.roles.drive_scale])
    c[s.roles.drive] = np.where(here, c[s.roles.drive] + (c[ix.RATE_BEFORE] - net), c[s.roles.drive])
    c[s.roles.drive_scale] = np.where(here, carried, c[s.roles.drive_scale])


def resolve_pending(s: Lanes, waits: Mask, net: Floats, force: Floats) -> None:
    """Begin the phases for which lanes wait, from their net moments and normal forces."""
    c = s.cells
    enters = waits & (c[ix.PENDING] == ix.ENTER_PHASE)
    begins = waits & (c[ix.PENDING] == ix.BEGIN_PHASE)
    moving = waits & (c[ix.PENDING] == ix.START_MOVING)
    again = waits & (c[ix.PENDING] == ix.START_AGAIN)
    decides = waits & np.logical_not(enters | begins | moving | again)
    by_force = moving & (force < 0.0)
    at_rest = again | decides
    by_load = at_rest & (c[s.roles.normal0] <= 0.0)
    lifts = (by_force | by_load) & (c[ix.LIFTED] == 0.0)
    c[ix.LIFTED] = np.where(lifts, 1.0, c[ix.LIFTED])
    c[ix.PENDING] = np.where(begins, ix.READY, c[ix.PENDING])
    carry_net_moment(s, enters, net)
    starts = (moving | again) & np.logical_not(lifts)
    if np.any(starts):
        level = again & starts & (c[ix.SUDDEN] <= 0.0)
        c[s.roles.drive] = np.where(level, 0.0, c[s.roles.drive])
        start_moving(s, starts, np.where(again, c[s.roles.drive], net))
    resolve_standstill(s, decides & np.logical_not(lifts))


def on_discontinuity(s: Lanes, here: Mask, force: Floats) -> None:
    """Decide about contact after a jump of forces. If contact changes, another phase begins."""
    c = s.cells
    if not np.any(here):
        return
    lifted = np.where(force < 0.0, 1.0, 0.0)
    same = c[ix.LIFTED] == lifted
    note_lift_off(s, here & (lifted > c[ix.LIFTED]))
    c[ix.PENDING] = np.where(here, np.where(same, ix.READY, ix.BEGIN_PHASE), c[ix.PENDING])
    c[ix.LIFTED] = np.where(here, lifted, c[ix.LIFTED])
    advance_origin(s, here & np.logical_not(same))


def begin_phases(s: Lanes) -> None:
    """Begin all pending phases, until every lane is ready for a step."""
    c = s.cells
    sudden = c[ix.PENDING] == ix.DISCONTINUITY
    if np.any(sudden):
        evaluate(s)
        force = normal_force(s)
        on_discontinuity(s, sudden, force)
    waits = c[ix.PENDING] != ix.READY
    while np.any(waits):
        begin_pieces(s, waits)
        prologue(s, waits)
        if np.any((c[ix.PENDING] == ix.START_MOVING) | (c[ix.PENDING] == ix.ENTER_PHASE)):
            evaluate(s)
        force = normal_force(s)
        net = s.registers[s.roles.net][0].copy()
        resolve_pending(s, waits, net, force)
        waits = c[ix.PENDING] != ix.READY


def begin_here(s: Lanes, here: Mask) -> None:
    """Begin a phase in the current state. Its prologue follows."""
    c = s.cells
    if not np.any(here):
        return
    c[ix.X] = np.where(here, 0.0, c[ix.X])
    find_pieces(s, here)
    begin_pieces(s, here)


def stand_before(s: Lanes, here: Mask, t: Table, piece: Floats, now: Floats) -> None:
    """Place lanes at the left end of a piece, which they have not entered yet."""
    c = s.cells
    if not np.any(here):
        return
    c[ix.TIME] = np.where(here, now, c[ix.TIME])
    c[t.cells + ix.PIECE] = np.where(here, piece - 1.0, c[t.cells + ix.PIECE])
    c[t.cells + ix.WAY] = np.where(here, INFINITY, c[t.cells + ix.WAY])


def keep_quiet(s: Lanes, here: Mask, t: Table, p: Floats, sign: Floats, terms: Floats) -> None:
    """Bound the values of the function of time, without its factor, for which sign p certainly keeps its sign."""
    c = s.cells
    if not np.any(here):
        return
    now = (c[t.cells + ix.VALUE] + c[t.cells + ix.INC]) / c[t.cells + ix.SCALED_BY]
    rise = c[t.cells + ix.RISE] / c[t.cells + ix.SCALED_BY]
    level = c[t.cells + ix.RISE] == 0.0
    way = sign * p[1] * rise
    room = SURE * p[0] * rise / p[1]
    bound = np.where(level, now, now - room)
    straight = (p[2] == 0.0) & (c[ix.SERIES_ORDER] <= 4.0)
    rounding = ROUNDINGS * terms
    sure = straight & (sign * p[0] > rounding) & (c[ix.LIFTED] == 0.0)
    c[ix.QUIET_FROM] = np.where(here, np.where(level | (way > 0.0), np.maximum(bound, c[ix.QUIET_FROM]),
        c[ix.QUIET_FROM]), c[ix.QUIET_FROM])
    c[ix.QUIET_TO] = np.where(here, np.where(level | (way < 0.0), np.minimum(bound, c[ix.QUIET_TO]), c[ix.QUIET_TO]),
        c[ix.QUIET_TO])
    c[ix.QUIET_TO] = np.where(here, np.where(sure, c[ix.QUIET_TO], -INFINITY), c[ix.QUIET_TO])


def look_for_quiet(s: Lanes, here: Mask) -> None:
    """Find the range of one function of time in which the mass certainly stays at rest in its direction."""
    c = s.cells
    if not np.any(here):
        return
    terms_of_normal = EPS * (np.abs(c[s.roles.normal_load]) + np.abs(c[s.roles.normal_load_slope]))
    for t in s.tables:
        if t.kind == ix.OF_TIME and t.terms == 2:
            keep_quiet(s, here, t, s.registers[s.roles.net], -1.0, c[s.roles.drive_scale])
            if s.roles.normal >= 0:
                keep_quiet(s, here, t, s.registers[s.roles.normal], 1.0, terms_of_normal)


def latest_end(s: Lanes, t: Table) -> Floats:
    """Return the place in a record, up to rounding, at which the end time is reached."""
    c = s.cells
    return c[ix.END_TIME] * c[t.cells + ix.SCALE] * (1.0 - 4.0 * EPS)


def rest_through(s: Lanes, here: Mask, t: Table) -> None:
    """Pass the pieces through which masses certainly rest, as both end values are in the quiet range."""
    c = s.cells
    if not np.any(here):
        return
    piece = last_quiet(s, here, t, latest_end(s, t))
    passes = here & (piece > c[t.cells + ix.PIECE])
    now = breaks_at(s, t, piece) / c[t.cells + ix.SCALE]
    if s.sample_count:
        read_samples(s, passes, c[ix.TIME], now, 0, 0)
    stand_before(s, passes, t, piece, now)


def enter_pieces(s: Lanes, here: Mask) -> None:
    """Enter the next pieces of functions of time, or those after all pieces in which masses certainly rest."""
    if not np.any(here):
        return
    for t in s.tables:
        if s.timed == 1 and t.kind == ix.OF_TIME and (t.terms == 2):
            rest_through(s, here, t)
    pass_breaks(s, here)


def path(time: Floats, omega: Floats, net: Floats, rise: Floats) -> Floats:
    """Return the path over the length of a piece after a time at a speed, with a net moment that rises linearly."""
    by_rise = SIXTH * time * rise
    by_net = 0.5 * net + by_rise
    mean = omega + time * by_net
    return time * mean


def standstill(omega: Floats, net: Floats, rise: Floats) -> Floats:
    """Return the first time at which a falling speed is zero."""
    square = net * net
    decrease = 2.0 * rise * omega
    left = np.maximum(square - decrease, 0.0)
    root = np.sqrt(left)
    falls = net <= 0.0
    over = np.where(falls, 2.0 * omega, net + root)
    under = np.where(falls, root - net, 0.0 - rise)
    return over / under


def end_slide(s: Lanes, here: Mask, t: Table, piece: int, x: Floats, omega: Floats) -> None:
    """Place lanes at the left end of a piece, at rest or in motion. Another phase begins there."""
    c = s.cells
    if not np.any(here):
        return
    c[ix.X] = np.where(here, x, c[ix.X])
    c[ix.OMEGA] = np.where(here, omega, c[ix.OMEGA])
    c[ix.STEPS] = np.where(here, 0.0, c[ix.STEPS])
    c[ix.PASSED] = np.where(here, ix.NOTHING, c[ix.PASSED])
    moves = omega > 0.0
    c[ix.STATUS] = np.where(here, np.where(moves, ix.MOVING, ix.RESTING), c[ix.STATUS])
    c[ix.TIME] = np.where(here, np.where(moves, c[ix.TIME], c[ix.REST_SINCE]), c[ix.TIME])
    update_reach(s, here & np.logical_not(moves))
    advance_origin(s, here)
    stand_before(s, here, t, float(piece), t.places[piece] / c[t.cells + ix.SCALE])
    pass_break(s, here, t)
    c[ix.PENDING] = np.where(here, ix.BEGIN_PHASE, c[ix.PENDING])


def pass_part(s: Lanes, here: Mask, now: Floats, length: Floats, span: Floats, omega: Floats, net: Floats,
        rise: Floats) -> tuple[Floats, Floats]:
    """Pass a part of a piece in which the net moment keeps its sign; return the speed at its end and the path."""
    c = s.cells
    mean = net + 0.5 * span * rise
    end = omega + span * mean
    moves = omega > 0.0
    goes_on = end > 0.0
    count_phase(s, here & goes_on & np.logical_not(moves))
    time = 1.0 * span
    stops = here & moves & np.logical_not(goes_on)
    if np.any(stops):
        time = np.where(stops, standstill(omega, net, rise), span)
        c[ix.REST_SINCE] = np.where(here, np.where(stops, now + length * time, c[ix.REST_SINCE]), c[ix.REST_SINCE])
    way = path(time, omega, net, rise)
    slides = moves | goes_on
    return (np.where(goes_on, end, 0.0), np.where(slides, way, 0.0))


def pass_change(s: Lanes, here: Mask, now: Floats, length: Floats, x: Floats, omega: Floats, net: Floats,
        after: Floats) -> tuple[Floats, Floats]:
    """Pass a piece in which lanes start, stop, or have their greatest or lowest speed."""
    rise = after - net
    changes = here & ((net > 0.0) != (after > 0.0))
    share = np.where(changes, -net / rise, 1.0)
    speed, way = pass_part(s, here, now, length, share, omega, net, rise)
    until = now + length * share
    keep_faster(s, changes & (net > 0.0), speed, until, x + length * way, 0.0)
    end, further = pass_part(s, changes, until, length, 1.0 - share, speed, 0.0, rise)
    return (np.where(changes, end, speed), way + np.where(changes, further, 0.0))


def pass_piece(s: Lanes, here: Mask, now: Floats, length: Floats, x: Floats, omega: Floats, net: Floats,
        after: Floats) -> tuple[Floats, Floats]:
    """Return the speed at the end of a piece and the path over its length; lanes outside the mask ``here`` rest."""
    twice = net + after
    by_rates = net + twice
    end = np.where(here, omega + 0.5 * twice, 0.0)
    way = np.where(here, omega + SIXTH * by_rates, 0.0)
    changes = (net > 0.0) != (after > 0.0)
    moves = (omega > 0.0) & (end > 0.0)
    turns = here & (changes | np.logical_not(moves))
    if np.any(turns):
        speed, further = pass_change(s, turns, now, length, x, omega, net, after)
        end = np.where(turns, speed, end)
        way = np.where(turns, further, way)
    return (end, way)


def passes(s: Lanes, t: Table, piece: int, before: Floats) -> Mask:
    """Return the lanes for which a piece ends before a place and not at the last break, where the record may jump."""
    inside = none_of(s)
    if piece + 2 < t.pieces:
        inside = t.places[piece + 2] < before
    return inside


def end_of(s: Lanes, t: Table, piece: int, per: Floats) -> Floats:
    """Return the time at which a piece ends, where ``per`` is 1 over the scale."""
    return t.places[piece + 1] * per


def height_after(s: Lanes, t: Table, piece: int) -> Floats:
    """Return the value of a record, without its factor, at the right end of a piece."""
    return t.heights[2 * piece + 2]


def rests_through(s: Lanes, t: Table, piece: int, before: Floats) -> Mask:
    """Return the lanes that certainly rest in a piece if they rest at its left end, and that do not leave after it."""
    c = s.cells
    height = height_after(s, t, piece)
    quiet = (c[ix.QUIET_FROM] <= height) & (height <= c[ix.QUIET_TO])
    return quiet & (t.places[piece + 2] < before)


def last_at_rest(s: Lanes, on: Mask, t: Table, piece: int, before: Floats) -> int:
    """Return the last piece through which all lanes certainly rest, from a piece at rest on."""
    last = piece
    while last + 3 < t.pieces and (not np.any(on & np.logical_not(rests_through(s, t, last + 1, before)))):
        last = last + 1
    return last


def keep_sliding(s: Lanes, on: Mask, t: Table, piece: int, before: Floats, press: Floats, x: Floats,
        omega: Floats) -> Mask:
    """End the slide of lanes that may lift or end in the next piece, and return the other lanes."""
    inside = passes(s, t, piece, before) & (press > 0.0)
    leaves = on & np.logical_not(inside)
    end_slide(s, leaves, t, piece, x, omega)
    return on & inside


def slide(s: Lanes, here: Mask, t: Table, first: int, slope: Floats, base: Floats, grip: Floats,
        weight: Floats) -> None:
    """Move lanes at rest through the pieces of a record, exactly: omega is quadratic in time, and x cubic."""
    c = s.cells
    if not np.any(here):
        return
    per = 1.0 / c[t.cells + ix.SCALE]
    before = latest_end(s, t)
    piece = first
    now = c[ix.TIME].copy()
    net = s.registers[s.roles.net][0].copy()
    omega: Floats = 0.0
    x: Floats = 0.0
    on = here
    while np.any(on):
        until = end_of(s, t, piece, per)
        after = base + slope * height_after(s, t, piece)
        drives = (net > 0.0) | (after > 0.0)
        acts = on & ((omega > 0.0) | drives)
        if np.any(acts):
            length = until - now
            at_first = length * net
            at_last = length * after
            speed, way = pass_piece(s, acts, now, length, x, omega, at_first, at_last)
            omega = speed
            x = x + length * way
        if not np.any(acts):
            piece = last_at_rest(s, on, t, piece, before)
            until = end_of(s, t, piece, per)
            after = base + slope * height_after(s, t, piece)
        now = until
        net = after
        piece = piece + 1
        press = weight + grip * height_after(s, t, piece)
        on = keep_sliding(s, on, t, piece, before, press, x, omega)


def slide_together(s: Lanes, here: Mask, t: Table) -> Mask:
    """Move lanes that rest in the same piece, down-slope; return lanes that follow in a later round."""
    c = s.cells
    net = s.registers[s.roles.net]
    slope = net[1] / c[t.cells + ix.RISE]
    origin = c[t.cells + ix.VALUE] + c[t.cells + ix.INC]
    base = net[0] - slope * origin
    grip: Floats = 0.0
    if s.roles.normal >= 0:
        grip = s.registers[s.roles.normal][1] / c[t.cells + ix.RISE]
    force = normal_force(s)
    weight = force - grip * origin
    straight = net[2] == 0.0
    forward = here & straight & (c[t.cells + ix.RISE] != 0.0)
    piece = greatest(np.where(forward, c[t.cells + ix.PIECE], -1.0))
    same = c[t.cells + ix.PIECE] == float(piece)
    there = forward & same
    if np.any(there):
        ahead = c[t.cells + ix.VALUE] + c[t.cells + ix.LOWER]
        press = weight + grip * ahead
        before = latest_end(s, t)
        inside = there & passes(s, t, piece, before) & (press > 0.0)
        by_height = slope * c[t.cells + ix.SCALED_BY]
        grip_by_height = grip * c[t.cells + ix.SCALED_BY]
        slide(s, inside, t, piece, by_height, base, grip_by_height, weight)
    return forward & np.logical_not(there)


def enter_phase(s: Lanes, here: Mask, rate: Floats) -> None:
    """Begin another phase in motion: lanes enter another piece of a table, are lifted or land."""
    c = s.cells
    if not np.any(here):
        return
    c[ix.RATE_BEFORE] = np.where(here, rate, c[ix.RATE_BEFORE])
    c[ix.DRIVE_BEFORE] = np.where(here, c[s.roles.drive], c[ix.DRIVE_BEFORE])
    c[ix.SCALE_BEFORE] = np.where(here, c[s.roles.drive_scale], c[ix.SCALE_BEFORE])
    advance_origin(s, here)
    c[ix.PENDING] = np.where(here, ix.ENTER_PHASE, c[ix.PENDING])


def on_standstill(s: Lanes, here: Mask) -> None:
    """Bring lanes to a standstill, reversed unless they are one-way, so that rounding cannot continue their motion."""
    c = s.cells
    if not np.any(here):
        return
    advance_origin(s, here)
    update_reach(s, here)
    c[ix.REST_SINCE] = np.where(here, c[ix.TIME], c[ix.REST_SINCE])
    if s.logged:
        note(s, here, ix.NOTE_STANDS)
    c[ix.FACED] = np.where(here, 1.0, c[ix.FACED])
    one_way = c[ix.ONE_WAY] > 0.0
    face(s, here, np.where(one_way, c[ix.DIRECTION], -c[ix.DIRECTION]))
    c[ix.PENDING] = np.where(here, np.where(one_way, ix.REST, ix.RESOLVE), c[ix.PENDING])


def change_contact(s: Lanes, here: Mask) -> None:
    """Lose or regain contact with the slip surface."""
    c = s.cells
    if not np.any(here):
        return
    c[ix.LIFTED] = np.where(here, 1.0 - c[ix.LIFTED], c[ix.LIFTED])
    c[ix.PASSED] = np.where(here, ix.LIFT, c[ix.PASSED])
    note_lift_off(s, here & (c[ix.LIFTED] > 0.0))


def on_breakpoint(s: Lanes, here: Mask, t: Table, upwards: Mask) -> None:
    """Place lanes exactly at an edge of a table of slip, speed or rotation, in the next piece."""
    c = s.cells
    if not np.any(here):
        return
    if t.kind == ix.OF_ROTATION:
        forward = c[ix.DIRECTION] > 0.0
        c[ix.ROTATION] = np.where(here, np.where(forward, end_of_piece(s, t, c[t.cells + ix.PIECE]), breaks_at(s, t,
            c[t.cells + ix.PIECE])), c[ix.ROTATION])
        return
    if t.kind == ix.OF_SPEED:
        c[ix.OMEGA] = np.where(here, np.where(upwards, c[t.cells + ix.UPPER], c[t.cells + ix.LOWER]), c[ix.OMEGA])
        c[ix.PASSED] = np.where(here, np.where(upwards, ix.FASTER, ix.SLOWER), c[ix.PASSED])
    c[t.cells + ix.PIECE] = np.where(here, c[t.cells + ix.PIECE] + np.where(upwards, 1.0, -1.0), c[t.cells + ix.PIECE])
    if t.kind == ix.OF_SLIP:
        c[ix.SLIP] = np.where(here, breaks_at(s, t, c[t.cells + ix.PIECE]) / c[t.cells + ix.SCALE], c[ix.SLIP])
    if t.open:
        here = here & upwards & (c[t.cells + ix.PIECE] == float(t.pieces - 1))
        c[ix.STATUS] = np.where(here, ix.NEED, c[ix.STATUS])
        c[ix.PENDING] = np.where(here, ix.READY, c[ix.PENDING])


def on_breakpoints(s: Lanes, here: Mask, rate: Floats) -> None:
    """Pass edges of tables of slip, speed or rotation."""
    c = s.cells
    if not np.any(here):
        return
    enter_phase(s, here, rate)
    for t in s.tables:
        upper = ix.EVENT_BREAKPOINT + 2 * t.number
        upwards = c[ix.EVENT] == float(upper)
        downwards = c[ix.EVENT] == float(upper + 1)
        on_breakpoint(s, here & (upwards | downwards), t, upwards)


def end_motion(s: Lanes, here: Mask, rate: Floats, status: Floats) -> None:
    """End moving lanes at their end time or with an upright chord."""
    c = s.cells
    if not np.any(here):
        return
    c[ix.STATUS] = np.where(here, status, c[ix.STATUS])
    c[ix.END_ROTATION] = np.where(here, c[ix.ROTATION] + c[ix.DIRECTION] * c[ix.X], c[ix.END_ROTATION])
    c[ix.END_OMEGA] = np.where(here, c[ix.DIRECTION] * c[ix.OMEGA], c[ix.END_OMEGA])
    c[ix.END_RATE] = np.where(here, c[ix.DIRECTION] * rate, c[ix.END_RATE])
    update_reach(s, here)


def settle(s: Lanes, here: Mask, rate: Floats) -> None:
    """Apply the consequences of the event that ends a step."""
    c = s.cells
    if not np.any(here):
        return
    c[ix.STATUS] = np.where(here, np.where(c[ix.EVENT] == ix.EVENT_ENDLESS, ix.TOO_LONG, c[ix.STATUS]), c[ix.STATUS])
    limits = here & (c[ix.EVENT] == ix.EVENT_LIMIT)
    pass_breaks(s, limits & (c[ix.TIME] < c[ix.END_TIME]))
    end_motion(s, limits & (c[ix.TIME] >= c[ix.END_TIME]), rate, ix.ENDED)
    on_standstill(s, here & (c[ix.EVENT] == ix.EVENT_STANDSTILL))
    lifts = here & (c[ix.EVENT] == ix.EVENT_LIFT_OFF)
    change_contact(s, lifts)
    if s.logged:
        note(s, lifts & (c[ix.LIFTED] == 0.0), ix.NOTE_LANDS)
    enter_phase(s, lifts, rate)
    end_motion(s, here & (c[ix.EVENT] == ix.EVENT_CHORD_UPRIGHT), rate, ix.UPRIGHT)
    on_breakpoints(s, here & (c[ix.EVENT] >= ix.EVENT_BREAKPOINT), rate)


def consider(s: Lanes, here: Mask, at: Floats, event: int) -> None:
    """Shorten the step to an event at a time, infinite without an event."""
    c = s.cells
    if not np.any(here):
        return
    c[ix.EVENT] = np.where(here, np.where(at <= c[ix.STEP], float(event), c[ix.EVENT]), c[ix.EVENT])
    c[ix.STEP] = np.where(here, np.minimum(at, c[ix.STEP]), c[ix.STEP])


def reach_limit(s: Lanes, here: Mask, room: Floats, top: int) -> None:
    """Shorten the step to the time left, up to a break of a function of time or the end time."""
    c = s.cells
    if not np.any(here):
        return
    reaches = here & (room < INFINITY)
    if np.any(reaches):
        at = variable_at(s, top, room)
        reaches = reaches & (at < INFINITY)
        c[ix.STEP] = np.where(here, np.where(reaches, at, c[ix.STEP]), c[ix.STEP])
    c[ix.EVENT] = np.where(here, np.where(reaches, ix.EVENT_LIMIT, ix.EVENT_NONE), c[ix.EVENT])


def find_standstill(s: Lanes, here: Mask, top: int) -> None:
    """Find the time at which the speed becomes zero."""
    c = s.cells
    if not np.any(here):
        return
    omega = s.registers[s.roles.omega]
    net = s.registers[s.roles.net]
    last = value(omega, top, c[ix.STEP])
    from_rest = omega[0] == 0.0
    decelerates = net[0] < 0.0
    falls_from_rest = from_rest & (decelerates | (net[0] == 0.0) & (net[1] <= 0.0))
    dips = decelerates & (value(net, top - 1, c[ix.STEP]) > 0.0)
    asked = here & ((last <= 0.0) | dips | falls_from_rest)
    if np.any(asked):
        e = np.zeros((ix.STRIDE, s.registers[0].shape[1]))
        margin_of(e, omega, top, 1.0, 0.0, from_rest)
        for _ in range(1, 2 + 1):
            margin_of(e, e, top, 1.0, 0.0, from_rest & (e[0] == 0.0))
        at = first_root(e, top, c[ix.STEP], asked)
        vanishes = from_rest & (e[0] == 0.0) & (last == 0.0)
        at_once = asked & ((e[0] < 0.0) | vanishes)
        consider(s, here, np.where(at_once, 0.0, at), ix.EVENT_STANDSTILL)


def find_crossing(s: Lanes, here: Mask, p: Floats, n: int, sign: Floats, constant: Floats, passed: Mask,
        event: int) -> None:
    """Find the time at which sign p + constant falls through zero, unless the phase began with this event."""
    c = s.cells
    if not np.any(here):
        return
    at = crossing(p, n, c[ix.STEP], sign, constant, passed, here)
    consider(s, here, at, event)


def find_contact_change(s: Lanes, here: Mask, top: int) -> None:
    """Find the time at which contact with the slip surface is lost or regained."""
    c = s.cells
    if not np.any(here):
        return
    if s.roles.normal >= 0:
        sign = np.where(c[ix.LIFTED] > 0.0, -1.0, 1.0)
        passed = c[ix.PASSED] == ix.LIFT
        find_crossing(s, here, s.registers[s.roles.normal], top - 1, sign, 0.0, passed, ix.EVENT_LIFT_OFF)


def find_edges(s: Lanes, here: Mask, t: Table, top: int, by_rotation: int) -> None:
    """Find the time at which an edge of a table's piece is passed. The last piece may have no upper edge."""
    c = s.cells
    if not np.any(here):
        return
    ends = here & (c[t.cells + ix.UPPER] < FAR)
    upper = np.minimum(c[t.cells + ix.UPPER], FAR)
    event = ix.EVENT_BREAKPOINT + 2 * t.number
    if t.kind == ix.OF_SPEED:
        omega = s.registers[s.roles.omega]
        slower = c[ix.PASSED] == ix.SLOWER
        find_crossing(s, ends, omega, top, -1.0, upper, slower, event)
        varies = here & (c[t.cells + ix.LOWER] > 0.0)
        faster = c[ix.PASSED] == ix.FASTER
        find_crossing(s, varies, omega, top, 1.0, -c[t.cells + ix.LOWER], faster, event + 1)
        return
    if by_rotation:
        ahead = upper - c[ix.X]
        consider(s, here, np.where(ends, ahead, INFINITY), event)
        return
    find_crossing(s, ends, s.registers[s.roles.x], top, -1.0, upper, none_of(s), event)


def find_events(s: Lanes, here: Mask, top: int, by_rotation: int) -> None:
    """Find the first event of the step. Of simultaneous events the last one in the order of the search is used."""
    c = s.cells
    if not np.any(here):
        return
    find_standstill(s, here, top)
    if s.roles.upright >= 0:
        find_crossing(s, here, s.registers[s.roles.upright], top - 1, 1.0, 0.0, none_of(s), ix.EVENT_CHORD_UPRIGHT)
    for t in s.tables:
        if t.kind != ix.OF_TIME:
            follows = t.number > 0 and t.kind == ix.OF_ROTATION
            known = follows and t.before.kind == ix.OF_ROTATION
            if known:
                known = not np.any(here & (np.minimum(c[t.cells + ix.UPPER], FAR) != c[t.before.cells + ix.UPPER]))
            if not known:
                find_edges(s, here, t, top, by_rotation)
    find_contact_change(s, here, top)


def choose_step(s: Lanes, here: Mask, top: int) -> None:
    """Shorten the step to the longest one that the series of the states allow, except where series end early."""
    c = s.cells
    if not np.any(here):
        return
    complete = here & (c[ix.SERIES_ORDER] == c[ix.ORDER])
    if np.any(complete):
        step: Floats = INFINITY
        for q in s.states:
            decides = (q.register == s.roles.x) == (s.roles.pace >= 0)
            if decides:
                step = np.minimum(longest_step(s, s.registers[q.register], top, c[ix.SERIES_ORDER]), step)
        c[ix.STEP] = np.where(here, np.where(complete, np.minimum(step, c[ix.STEP]), c[ix.STEP]), c[ix.STEP])


def advance_further(s: Lanes, here: Mask, top: int) -> None:
    """Advance the states besides rotation and speed, and the functions of time, by the step."""
    c = s.cells
    if not np.any(here):
        return
    for q in s.states:
        further = not (q.register == s.roles.x or q.register == s.roles.omega)
        if further:
            c[q.cell] = np.where(here, c[q.cell] + increment(s.registers[q.register], top, c[ix.STEP]), c[q.cell])
    for t in s.tables:
        if t.kind == ix.OF_TIME:
            c[t.cells + ix.INC] = np.where(here, c[t.cells + ix.INC] + rise_of_step(s, t), c[t.cells + ix.INC])


def find_endless(s: Lanes, here: Mask, room: Floats) -> None:
    """End motions that continue for ever."""
    c = s.cells
    if not np.any(here):
        return
    change = s.registers[s.roles.net][0] * c[ix.STEP]
    settled = change >= -ix.SETTLED * s.registers[s.roles.omega][0]
    unopposed = np.abs(c[s.roles.drive]) <= ix.SETTLED * c[s.roles.drive_scale]
    uneventful = c[ix.EVENT] == ix.EVENT_NONE
    here = here & uneventful & (settled | unopposed) & (room == INFINITY) & (c[ix.LIFTED] == 0.0)
    c[ix.EVENT] = np.where(here, ix.EVENT_ENDLESS, c[ix.EVENT])
    c[ix.STEP] = np.where(here, 0.0, c[ix.STEP])


def keep_peak(s: Lanes, here: Mask, top: int, rate: Floats, slope: Floats) -> None:
    """Record the greatest speed within the step, where the net moment falls through zero."""
    c = s.cells
    if not np.any(here):
        return
    net = s.registers[s.roles.net]
    at = falling_root(net, top - 1, c[ix.STEP], rate, slope, here)
    peaks = at < INFINITY
    if np.any(peaks):
        since = elapsed(s, top, at)
        time = c[ix.TIME] + since
        speed = value(s.registers[s.roles.omega], top, at)
        x = value(s.registers[s.roles.x], top, at)
        rate_there = value(net, top - 1, at)
        keep_faster(s, peaks, speed, time, x, rate_there)


def arrive(s: Lanes, here: Mask, until: Floats, rate: Floats) -> None:
    """Let a step end at the time ``until``, count it, and apply its consequences."""
    c = s.cells
    if not np.any(here):
        return
    keep_faster(s, here, c[ix.OMEGA], until, c[ix.X], rate)
    c[ix.TIME] = np.where(here, until, c[ix.TIME])
    change = np.abs(s.registers[s.roles.net][0]) * c[ix.STEP]
    steady = (change < ix.STIFF_CHANGE * s.registers[s.roles.omega][0]) & (c[ix.EVENT] == ix.EVENT_NONE)
    steps = c[ix.STEPS] + np.where(steady, ix.STIFF_STEP, 1.0)
    c[ix.STEPS] = np.where(here, np.where(c[ix.EVENT] == ix.EVENT_LIMIT, 0.0, steps), c[ix.STEPS])
    c[ix.PASSED] = np.where(here, ix.NOTHING, c[ix.PASSED])
    settle(s, here & (c[ix.EVENT] != ix.EVENT_NONE), rate)


def make_step(s: Lanes, here: Mask) -> None:
    """Make one step of moving lanes."""
    c = s.cells
    if not np.any(here):
        return
    limit = np.minimum(next_break(s), c[ix.END_TIME])
    room = limit - c[ix.TIME]
    top = expand(s, room, here, 0)
    choose_step(s, here, top)
    reach_limit(s, here, room, top)
    find_events(s, here, top, False)
    if s.autonomous:
        find_endless(s, here, room)
    step = c[ix.STEP].copy()
    net = s.registers[s.roles.net]
    omega = s.registers[s.roles.omega]
    x = s.registers[s.roles.x]
    rate: Floats = 0.0
    slope: Floats = 0.0
    faster: Floats = 0.0
    farther: Floats = 0.0
    for k in range(top - 1, 0 - 1, -1):
        slope = slope * step + rate
        rate = rate * step + net[k]
        faster = faster * step + omega[k + 1]
        farther = farther * step + x[k + 1]
    keep_peak(s, here, top, rate, slope)
    time = c[ix.TIME] + elapsed(s, top, step)
    until = np.where(c[ix.EVENT] == ix.EVENT_LIMIT, limit, time)
    if s.sample_count:
        read_samples(s, here, c[ix.TIME], until, 1, top)
    c[ix.OMEGA] = np.where(here, c[ix.OMEGA] + step * faster, c[ix.OMEGA])
    c[ix.X] = np.where(here, c[ix.X] + step * farther, c[ix.X])
    advance_further(s, here, top)
    rate = per_time(s, rate, c[ix.OMEGA])
    arrive(s, here, until, rate)


def at_rotation(s: Lanes, constant: Floats, sine: Floats, versine: Floats) -> Floats:
    """Return a sum with sine and 1 - cosine of the current rotation."""
    c = s.cells
    turned = sine * c[ix.SINE_X] + versine * c[ix.VERSINE_X]
    return constant + turned


def net_at_rest(s: Lanes) -> tuple[Floats, Floats]:
    """Return the net moment of a mass at rest where its phase began, and its rate with the function of time."""
    c = s.cells
    moment = at_rotation(s, c[s.roles.drive], c[s.roles.net_sine], c[s.roles.net_vers])
    return (moment, at_rotation(s, c[s.roles.net_record], c[s.roles.net_record_sine], c[s.roles.net_record_vers]))


def force_at_rest(s: Lanes) -> tuple[Floats, Floats]:
    """Return the normal force of a mass at rest where its phase began, and its rate with the function of time."""
    c = s.cells
    force = at_rotation(s, c[s.roles.normal0], c[s.roles.normal_sine], c[s.roles.normal_vers])
    return (force, at_rotation(s, c[s.roles.normal_record], c[s.roles.normal_record_sine],
        c[s.roles.normal_record_vers]))


def coefficient_of_product(p: Floats, q: Floats, n: int) -> Floats:
    """Return coefficient n of the product of two series."""
    total: Floats = 0
    for k in range(n + 1):
        total = total + p[k] * q[n - k]
    return total


def expand_piece(s: Lanes, e: Floats, rise: Floats, sine: Floats, versine: Floats) -> None:
    """Compute the series of a piece from the factors of 1, sin(x) and 1 - cos(x), and from their rates."""
    c = s.cells
    x = s.registers[s.roles.x]
    omega = s.registers[s.roles.omega]
    net = s.registers[s.roles.net]
    x[0] = c[ix.X]
    omega[0] = c[ix.OMEGA]
    sine[0] = c[ix.SINE_X]
    versine[0] = c[ix.VERSINE_X]
    for n in range(TOP - 1 + 1):
        total = e[1] * sine[n] + e[2] * versine[n] + c[s.roles.net_square] * coefficient_of_product(omega, omega, n)
        if n == 0:
            total = total + e[0]
        if n == 1:
            total = total + rise[0]
        if n > 0:
            total = total + (rise[1] * sine[n - 1] + rise[2] * versine[n - 1])
        net[n] = total
        x[n + 1] = omega[n] * (1.0 / (n + 1))
        omega[n + 1] = total * (1.0 / (n + 1))
        along = omega[n] - coefficient_of_product(versine, omega, n)
        sine[n + 1] = along * (1.0 / (n + 1))
        versine[n + 1] = coefficient_of_product(sine, omega, n) * (1.0 / (n + 1))


def find_factors(s: Lanes, t: Table, factors: Floats, rise: Floats) -> None:
    """Compute the factors of 1, sin(x) and 1 - cos(x) in the net moment, and their rates."""
    c = s.cells
    rise[0] = c[s.roles.net_record] * c[t.cells + ix.RISE]
    rise[1] = c[s.roles.net_record_sine] * c[t.cells + ix.RISE]
    rise[2] = c[s.roles.net_record_vers] * c[t.cells + ix.RISE]
    factors[0] = c[s.roles.drive] + c[s.roles.net_record] * c[t.cells + ix.INC]
    factors[1] = c[s.roles.net_sine] + c[s.roles.net_record_sine] * c[t.cells + ix.INC]
    factors[2] = c[s.roles.net_vers] + c[s.roles.net_record_vers] * c[t.cells + ix.INC]


def pass_events(s: Lanes, here: Mask, left: Floats) -> Floats:
    """Shorten a step to a standstill, record a peak within it, and return the rate of the speed at its end."""
    c = s.cells
    omega = s.registers[s.roles.omega]
    net = s.registers[s.roles.net]
    c[ix.STEP] = np.where(here, left, c[ix.STEP])
    c[ix.EVENT] = np.where(here, ix.EVENT_NONE, c[ix.EVENT])
    loss = left * np.minimum(net[0], 0.0)
    bend = left * left * np.abs(omega[2])
    slow = here & (omega[0] > 0.0) & (omega[0] + loss <= 2.0 * bend)
    find_standstill(s, slow, TOP)
    step = c[ix.STEP].copy()
    rate, slope = value_and_slope(net, TOP - 1, step)
    most = omega[0] + step * net[0]
    peaks = here & (rate <= 0.0) & (net[0] > 0.0) & (most > np.abs(c[ix.PEAK_OMEGA]))
    keep_peak(s, peaks, TOP, rate, slope)
    return rate


def move_within(s: Lanes, here: Mask, t: Table) -> None:
    """Move lanes to the end of a piece, or to a standstill within it."""
    c = s.cells
    if not np.any(here):
        return
    factors = np.zeros((ix.STRIDE, s.registers[0].shape[1]))
    rise = np.zeros((ix.STRIDE, s.registers[0].shape[1]))
    sine = np.zeros((ix.STRIDE, s.registers[0].shape[1]))
    versine = np.zeros((ix.STRIDE, s.registers[0].shape[1]))
    find_factors(s, t, factors, rise)
    expand_piece(s, factors, rise, sine, versine)
    rate = pass_events(s, here, c[t.cells + ix.UPPER] - c[ix.TIME])
    step = c[ix.STEP].copy()
    omega = s.registers[s.roles.omega]
    speed = omega[0] + increment(omega, TOP, step)
    stops = here & ((c[ix.EVENT] == ix.EVENT_STANDSTILL) | (speed <= 0.0))
    c[ix.X] = np.where(here, c[ix.X] + increment(s.registers[s.roles.x], TOP, step), c[ix.X])
    c[ix.OMEGA] = np.where(here, np.where(stops, 0.0, speed), c[ix.OMEGA])
    c[ix.SINE_X] = np.where(here, c[ix.SINE_X] + increment(sine, TOP, step), c[ix.SINE_X])
    c[ix.VERSINE_X] = np.where(here, c[ix.VERSINE_X] + increment(versine, TOP, step), c[ix.VERSINE_X])
    c[t.cells + ix.INC] = np.where(here, c[t.cells + ix.INC] + step * c[t.cells + ix.RISE], c[t.cells + ix.INC])
    then = np.where(stops, c[ix.TIME] + step, c[t.cells + ix.UPPER])
    keep_faster(s, here, c[ix.OMEGA], then, c[ix.X], rate)
    c[ix.REST_SINCE] = np.where(here, np.where(stops, then, c[ix.REST_SINCE]), c[ix.REST_SINCE])
    c[ix.TIME] = np.where(here, then, c[ix.TIME])


def fits(s: Lanes, t: Table) -> Mask:
    """Return whether masses are pressed through a piece, for which the series suffice, and not at the lowest place."""
    c = s.cells
    last: Floats = float(t.pieces - 1)
    beyond = breaks_at(s, t, np.minimum(c[t.cells + ix.PIECE] + 2.0, last))
    inside = (c[t.cells + ix.PIECE] + 1.0 < last) & (beyond < INFINITY) & (c[t.cells + ix.UPPER] < c[ix.END_TIME])
    size = c[s.roles.driving_moment] + np.abs(c[s.roles.driving_moment_slope])
    drives = size * c[ix.X] < 0.5 * c[s.roles.driving_moment]
    length = c[t.cells + ix.UPPER] - c[ix.TIME]
    turning = np.abs(c[s.roles.net_record_sine]) + np.abs(c[s.roles.net_record_vers])
    moments = np.abs(c[s.roles.net_sine]) + np.abs(c[s.roles.net_vers]) + turning * np.abs(c[t.cells + ix.LOWER])
    path = length * (c[ix.OMEGA] + 32.0 * length * moments)
    terms = np.abs(c[s.roles.normal_load]) + np.abs(c[s.roles.normal_load_slope])
    force, by_record = force_at_rest(s)
    return inside & drives & (path < SHORT) & (force + by_record * c[t.cells + ix.LOWER] > PRESSED * terms)


def wait_for_start(s: Lanes, here: Mask, t: Table) -> Mask:
    """Advance lanes at rest to the start of their motion, and return the lanes that start in the piece they reach."""
    c = s.cells
    net = s.registers[s.roles.net]
    normal = s.registers[s.roles.normal]
    moment, by_record = net_at_rest(s)
    force, force_by_record = force_at_rest(s)
    net[0] = moment + by_record * c[t.cells + ix.INC]
    net[1] = by_record * c[t.cells + ix.RISE]
    net[2] = 0.0
    normal[0] = force + force_by_record * c[t.cells + ix.INC]
    normal[1] = force_by_record * c[t.cells + ix.RISE]
    normal[2] = 0.0
    c[ix.QUIET_FROM] = np.where(here, -INFINITY, c[ix.QUIET_FROM])
    c[ix.QUIET_TO] = np.where(here, INFINITY, c[ix.QUIET_TO])
    look_for_quiet(s, here)
    enter_pieces(s, here)
    now = np.minimum(moment + by_record * c[t.cells + ix.INC], 0.0)
    then = moment + by_record * c[t.cells + ix.LOWER]
    starts = here & (then > SURELY * c[s.roles.drive_scale]) & fits(s, t)
    share = np.where(starts, now / (now - then), 0.0)
    c[ix.TIME] = np.where(here, c[ix.TIME] + share * (c[t.cells + ix.UPPER] - c[ix.TIME]), c[ix.TIME])
    c[t.cells + ix.INC] = np.where(here, c[t.cells + ix.INC] + share * (c[t.cells + ix.LOWER] - c[t.cells + ix.INC]),
        c[t.cells + ix.INC])
    return starts


def leave_series(s: Lanes, here: Mask, since: Floats) -> None:
    """Leave moving lanes to the integration in time, and begin another phase for lanes that rest after a motion."""
    c = s.cells
    if not np.any(here):
        return
    moves = c[ix.OMEGA] > 0.0
    c[ix.STATUS] = np.where(here, np.where(moves, ix.MOVING, ix.RESTING), c[ix.STATUS])
    here = here & np.logical_not(moves) & (c[ix.TIME] > since)
    c[ix.STEPS] = np.where(here, 0.0, c[ix.STEPS])
    update_reach(s, here)
    advance_origin(s, here)
    c[ix.PENDING] = np.where(here, ix.BEGIN_PHASE, c[ix.PENDING])


def turn_through(s: Lanes, here: Mask, t: Table) -> None:
    """Move lanes at rest through the pieces of a record, down-slope, as far as the series of a piece fit."""
    c = s.cells
    if not np.any(here):
        return
    c[ix.SINE_X] = np.where(here, 0.0, c[ix.SINE_X])
    c[ix.VERSINE_X] = np.where(here, 0.0, c[ix.VERSINE_X])
    since = c[ix.TIME].copy()
    while np.any(here):
        moves = here & (c[ix.OMEGA] > 0.0)
        rests = here & (c[ix.OMEGA] == 0.0)
        starts = none_of(s)
        if np.any(rests):
            starts = wait_for_start(s, rests, t)
        goes = starts | moves & fits(s, t)
        leave_series(s, here & np.logical_not(goes), since)
        count_phase(s, starts & goes)
        here = goes
        move_within(s, here, t)
        pass_break(s, here & (c[ix.TIME] == c[t.cells + ix.UPPER]), t)


def has_recurrence(s: Lanes) -> int:
    """Return whether the net moment has this form."""
    return s.roles.net_sine >= 0 and (not s.roles.loss_rate >= 0)


def expand_force(s: Lanes, p: Floats, start: Floats, sine: Floats, vers: Floats, top: int) -> None:
    """Compute the series of start + sine sin(x) + vers (1 - cos(x))."""
    p[0] = start
    p[1] = sine
    p[2] = 0.5 * vers
    for n in range(3, top + 1):
        p[n] = -p[n - 2] * (1.0 / n * (1.0 / (n - 1)))


def complete_net(s: Lanes, weight: Floats, n: int) -> None:
    """Add the parts that E and its weight cause to coefficient n of net moment and weight."""
    c = s.cells
    e = s.registers[s.roles.omega]
    net = 1.0 * s.registers[s.roles.net][n]
    for t in s.tables:
        most = min(t.degree, n)
        for k in range(1, most + 1):
            net = net + c[t.cells + ix.Q1 + (k - 1)] * weight[n - k]
    s.registers[s.roles.net][n] = net + c[s.roles.net_square] * e[n]
    weight[n] = weight[n] + c[s.roles.net_loss_square] * e[n]


def expand_contact(s: Lanes, top: int) -> None:
    """Compute the series of the normal force and of the dip of the chord."""
    c = s.cells
    if s.roles.normal >= 0:
        normal = s.registers[s.roles.normal]
        expand_force(s, normal, c[s.roles.normal0], c[s.roles.normal_sine], c[s.roles.normal_vers], top)
        for n in range(top - 1 + 1):
            normal[n] = normal[n] + c[s.roles.normal_square] * s.registers[s.roles.omega][n]
    if s.roles.upright >= 0:
        expand_force(s, s.registers[s.roles.upright], c[s.roles.normal_load], c[s.roles.upright_sine],
            c[s.roles.upright_vers], top)


def look_for_end(s: Lanes, room: Floats) -> Floats:
    """Return the path beyond which a step in rotation is useless, as the mass rests, and store the size of terms."""
    c = s.cells
    e = s.registers[s.roles.omega]
    product = e[0] * e[2]
    square = e[1] * e[1] - 4.0 * product
    root = np.sqrt(np.maximum(square, 0.0))
    end = (e[1] + root) / (-2.0 * e[2])
    nearer = np.minimum(BEYOND * end, room)
    path = np.where(e[2] < 0.0, nearer, room)
    largest = np.maximum(np.abs(e[2]), path * np.abs(e[3]))
    largest = np.maximum(np.abs(e[1]), path * largest)
    c[ix.LARGEST_OMEGA] = np.maximum(np.abs(e[0]), path * largest)
    return path


def integrate_in_rotation(s: Lanes, weight: Floats, n: int) -> None:
    """Compute coefficient n of the net moment and n + 1 of the states."""
    e = s.registers[s.roles.omega]
    if has_recurrence(s):
        complete_net(s, weight, n)
    if not has_recurrence(s):
        if s.roles.square >= 0:
            s.registers[s.roles.square][n] = e[n]
        operate(s, n, n + 1, True, False)
        s.registers[s.roles.x][n + 1] = 1.0 if n == 0 else 0.0
    e[n + 1] = s.registers[s.roles.net][n] * (2.0 * (1.0 / (n + 1)))


def expand_in_rotation(s: Lanes, room: Floats, which: Mask) -> int:
    """Compute the series of a step up to ``room``, or the estimated end of motion, and return their highest order."""
    c = s.cells
    early = True
    for t in s.tables:
        early = early and t.kind != ix.OF_ROTATION
    order = np.where(which, c[ix.ORDER], 3.0)
    top = greatest(order)
    weight = np.zeros((ix.STRIDE, s.registers[0].shape[1]))
    recurs = has_recurrence(s)
    begin_series(s)
    if recurs:
        expand_force(s, s.registers[s.roles.net], c[s.roles.drive], c[s.roles.net_sine], c[s.roles.net_vers], top)
        expand_force(s, weight, c[s.roles.net_loss], c[s.roles.net_loss_sine], c[s.roles.net_loss_vers], top)
    last: Floats = 0.0
    power: Floats = 0.0
    goes_on = which
    n = 0
    while n < top and np.any(goes_on):
        integrate_in_rotation(s, weight, n)
        n = n + 1
        power = power * c[ix.STEP]
        counts = which
        if early and n > 3:
            counts = next_term_counts(s, n, power, False)
        if n == 3:
            c[ix.STEP] = look_for_end(s, room)
            power = c[ix.STEP] * c[ix.STEP] * c[ix.STEP]
        last = np.where(counts, float(n), last)
        goes_on = goes_on & (last > float(n - 2))
    order = np.where(last < order - 1.0, np.maximum(last, 3.0), order)
    top = greatest(order)
    if recurs:
        expand_contact(s, top)
    if not recurs:
        operate_later(s, top)
    cut(s, order, top)
    c[ix.SERIES_ORDER] = order
    return top


def integral(p: Floats, n: int, k_first: int, most: Floats, side: Floats, first: Floats, span: Floats,
        per: Floats) -> Floats:
    """Return the integral of v dv/(sqrt(E) (1 + per v^2)^2) over a path by a rule, infinite if it is uncertain."""
    total: Floats = 0.0
    last: Floats = 0.0
    last_but_one: Floats = 0.0
    near_second = np.any(per > 0.0)
    for k in range(k_first, 2 * k_first + SHORTEST - 1 + 1):
        past = span * NODES[k]
        v = first + past
        square = v * v
        share: Floats = 1.0
        if near_second:
            share = 1.0 / (1.0 + per * square)
        y = past * (first + v) * share
        speed = np.sqrt(value(p, n, side * y))
        slowness = v * (share * share) / speed
        total = total + SHARES[k] * slowness
        last = last + LAST_SHARES[k] * slowness
        last_but_one = last_but_one + NEXT_SHARES[k] * slowness
    accurate = np.abs(last) + np.abs(last_but_one) <= most * total
    return np.where(accurate, total, INFINITY)


def time_over(p: Floats, n: int, fine: int, way: Floats, beyond: Floats, per: Floats) -> Floats:
    """Return the time over a path that begins at the distance ``beyond`` from a rest, infinite if it is uncertain."""
    size = np.abs(way)
    side = np.where(way < 0.0, -1.0, 1.0)
    first = np.sqrt(beyond)
    left = 1.0 - per * size
    stretch = 1.0 + per * beyond
    final = np.sqrt((beyond + size) / left)
    span = size * stretch / (left * (first + final))
    most: Floats = CLOSER if fine else EVEN
    rule = 3 * SHORTEST if fine else SHORTEST
    moves = size > 0.0
    is_short = moves & (size <= beyond) & (per == 0.0)
    total: Floats = INFINITY
    if np.any(is_short):
        total = np.where(is_short, integral(p, n, 0, most, side, first, span, per), total)
    remains = moves & (total == INFINITY)
    if np.any(remains):
        total = np.where(remains, integral(p, n, rule, most, side, first, span, per), total)
    return np.where(moves, span * stretch * total, 0.0)


def distance_of_rest(p: Floats, n: int, side: Floats, far: Floats) -> Floats:
    """Return the distance at which the polynomial E has a zero, by Newton's method as far as it converges."""
    distance = -side * p[0] / p[1]
    for _ in range(1, NEWTON + 1):
        at, slope = value_and_slope(p, n, side * distance)
        change = -side * at / slope
        converges = np.abs(change) < 0.5 * distance
        distance = np.where(converges, distance + change, distance)
    nearest = np.minimum(distance, far)
    return np.where(distance >= 0.0, nearest, far)


def expand_about_end(s: Lanes, p: Floats, n: int) -> None:
    """Compute E as a polynomial of the distance from the end of the step."""
    c = s.cells
    e = s.registers[s.roles.omega]
    for k in range(n + 1):
        p[k] = e[k]
    shift(p, n, c[ix.STEP])
    stands = c[ix.EVENT] == ix.EVENT_STANDSTILL
    p[0] = np.where(stands, 0.0, p[0])


def rest_ahead(s: Lanes, peaks: Mask, to_end: Floats, path: Floats) -> Floats:
    """Return 1 over the distance of the rest ahead, beyond a peak or estimated from E, or 0 if the path is too long."""
    c = s.cells
    e = s.registers[s.roles.omega]
    by_bend = np.maximum(-e[2] / e[1], 0.0)
    ahead = np.where(peaks, 1.0 / (c[ix.STEP] + to_end), by_bend)
    near = (e[1] > 0.0) & (ahead * path < NEAREST)
    return np.where(near, ahead, 0.0)


def times_of_step(s: Lanes, here: Mask, top: int, peak: Floats) -> tuple[Floats, Floats]:
    """Return the durations of the parts of a step before and after its greatest speed, infinite if uncertain."""
    c = s.cells
    e = s.registers[s.roles.omega]
    step = c[ix.STEP].copy()
    peaks = peak < INFINITY
    far = STRAIGHT * step
    fine = s.highest > FINEST
    rises = e[1] > 0.0
    of_end = np.zeros((ix.STRIDE, s.registers[0].shape[1]))
    to_end = 1.0 * far
    falls = none_of(s)
    nears = here & (peaks | np.logical_not(rises))
    if np.any(nears):
        expand_about_end(s, of_end, top)
        to_end = distance_of_rest(of_end, top, 1.0, far)
        falls = here & np.logical_not(peaks) & np.logical_not(rises) & (of_end[1] < 0.0)
    behind = distance_of_rest(e, top, -1.0, far)
    behind = np.where(rises, behind, far)
    path = np.minimum(peak, step)
    ahead = rest_ahead(s, peaks, to_end, path)
    after: Floats = 0.0
    if np.any(peaks):
        back = np.where(peaks, peak - step, 0.0)
        from_end = np.where(rises, 1.0 / (step + behind), 0.0)
        after = time_over(of_end, top, fine, back, to_end, from_end)
    for k in range(top + 1):
        of_end[k] = np.where(falls, of_end[k], e[k])
    beyond = np.where(falls, to_end, behind)
    path = np.where(falls, -step, path)
    before = time_over(of_end, top, fine, path, beyond, ahead)
    return (before, after)


def way_ahead(s: Lanes) -> Floats:
    """Return the rotation up to which a step may go: to the next edge of a table."""
    c = s.cells
    room = LONGEST + c[ix.X]
    for t in s.tables:
        if t.kind == ix.OF_SLIP or t.kind == ix.OF_ROTATION:
            room = np.minimum(c[t.cells + ix.UPPER] - c[ix.X], room)
    return room


def shorten(s: Lanes, here: Mask) -> None:
    """Shorten a step where the square of the speed bends upwards, so that a second rest behind is not too near."""
    c = s.cells
    if not np.any(here):
        return
    e = s.registers[s.roles.omega]
    bends = here & (e[2] > 0.0) & (e[1] >= 0.0)
    by_slope = e[1] / e[2]
    by_speed = np.sqrt(e[0] / e[2])
    most = REACH * (by_slope + by_speed)
    shorter = np.minimum(most, c[ix.STEP])
    c[ix.STEP] = np.where(here, np.where(bends, shorter, c[ix.STEP]), c[ix.STEP])


def complete(s: Lanes, here: Mask, top: int, peak: Floats, before: Floats, until: Floats) -> None:
    """Bring lanes to the end of their step at the time ``until``, by the greatest speed after the time ``before``."""
    c = s.cells
    if not np.any(here):
        return
    net = s.registers[s.roles.net]
    e = s.registers[s.roles.omega]
    step = c[ix.STEP].copy()
    rate = value(net, top - 1, step)
    peaks = here & (peak < INFINITY)
    if np.any(peaks):
        there = np.where(peaks, peak, 0.0)
        speed = np.sqrt(value(e, top, there))
        slope = value(net, top - 1, there)
        keep_faster(s, peaks, speed, c[ix.TIME] + before, c[ix.X] + there, slope)
    c[ix.X] = np.where(here, c[ix.X] + step, c[ix.X])
    square = e[0] + increment(e, top, step)
    c[ix.OMEGA] = np.where(here, np.sqrt(np.maximum(square, 0.0)), c[ix.OMEGA])
    arrive(s, here, until, rate)
    if has_recurrence(s):
        enter_phase(s, here & (c[ix.EVENT] == ix.EVENT_NONE), rate)


def turn_on(s: Lanes, here: Mask) -> None:
    """Make one step of moving lanes in powers of the rotation."""
    c = s.cells
    if not np.any(here):
        return
    omega = 1.0 * c[ix.OMEGA]
    c[ix.OMEGA] = np.where(here, omega * omega, c[ix.OMEGA])
    room = way_ahead(s)
    top = expand_in_rotation(s, room, here)
    choose_step(s, here, top)
    shorten(s, here)
    c[ix.EVENT] = np.where(here, ix.EVENT_NONE, c[ix.EVENT])
    find_events(s, here, top, True)
    peak: Floats = INFINITY
    before: Floats = 0.0
    after: Floats = 0.0
    unsure = here
    count = 0
    while np.any(unsure) and count <= MOST_HALVINGS:
        rate, slope = value_and_slope(s.registers[s.roles.net], top - 1, c[ix.STEP])
        peak = falling_root(s.registers[s.roles.net], top - 1, c[ix.STEP], rate, slope, here)
        before, after = times_of_step(s, here, top, peak)
        unsure = here & np.logical_not(before + after < INFINITY)
        c[ix.STEP] = np.where(here, np.where(unsure, 0.5 * c[ix.STEP], c[ix.STEP]), c[ix.STEP])
        c[ix.EVENT] = np.where(here, np.where(unsure, ix.EVENT_NONE, c[ix.EVENT]), c[ix.EVENT])
        count = count + 1
    duration = before + after
    until = c[ix.TIME] + duration
    stands = (c[ix.STEP] == 0.0) & (c[ix.EVENT] == ix.EVENT_STANDSTILL)
    regular = (duration > BRIEFEST) | stands
    fits = here & regular & (until < c[ix.END_TIME])
    c[ix.OMEGA] = np.where(here, omega, c[ix.OMEGA])
    c[ix.CLOCKED] = np.where(here, np.where(fits, 0.0, 1.0), c[ix.CLOCKED])
    complete(s, fits, top, peak, before, until)


def turned(x: Floats) -> tuple[Floats, Floats]:
    """Return x - sin(x) and 1 - cos(x), for |x| <= pi, from a quarter of the angle, doubled twice."""
    h = 0.25 * x
    square = h * h
    lag: Floats = LAG[LAST]
    versine: Floats = VERSINE[LAST]
    for k in range(LAST - 1, 0 - 1, -1):
        lag = lag * square + LAG[k]
        versine = versine * square + VERSINE[k]
    lag = lag * square * h
    versine = versine * square
    for _ in range(1, 2 + 1):
        sine = h - lag
        change = sine * versine
        lag = 2.0 * (lag + change)
        versine = 2.0 * (sine * sine)
        h = 2.0 * h
    return (lag, versine)


def faded(y: Floats) -> Floats:
    """Return (y - 1 + exp(-y))/y^2, for 0 <= y <= 2, from a quarter of y, doubled twice."""
    h = 0.25 * y
    square = h * h
    even: Floats = FADING[2 * LAST]
    odd: Floats = FADING[2 * LAST - 1]
    for k in range(LAST - 1, 1 - 1, -1):
        even = even * square + FADING[2 * k]
        odd = odd * square + FADING[2 * k - 1]
    part = FADING[0] + h * odd + square * even
    for _ in range(1, 2 + 1):
        lost = 1.0 - h * part
        part = 0.5 * part + 0.25 * lost * lost
        h = 2.0 * h
    return part


def factors(e: Floats, drive: Floats, sine: Floats, vers: Floats, q: Floats) -> None:
    """Compute the factors of E, followed by q."""
    square = q * q
    share = 2.0 / (1.0 + square)
    e[0] = 2.0 * drive
    e[3] = share * (vers - sine * q)
    e[2] = share * (sine + vers * q)
    e[1] = -q * (e[3] + e[0])
    e[4] = q


def functions(f: Floats, x: Floats, q: Floats) -> None:
    """Compute the four functions of which E is the sum."""
    lag, versine = turned(x)
    f[0] = x
    f[1] = x * x * faded(q * x)
    f[2] = versine
    f[3] = lag


def energy(e: Floats, f: Floats) -> Floats:
    """Return E from its factors and its functions."""
    faded_part = e[1] * f[1]
    turned_part = e[2] * f[2] + e[3] * f[3]
    return e[0] * f[0] + (faded_part + turned_part)


def force_at(start: Floats, sine: Floats, vers: Floats, f: Floats) -> Floats:
    """Return start + sine sin + vers (1 - cos) at the rotation at which ``f`` has the functions of E."""
    sine_there = sine * (f[0] - f[3])
    return start + (sine_there + vers * f[2])


def look_back(back: Floats, first: int, drive: Floats, sine: Floats, vers: Floats, f: Floats) -> None:
    """Compute drive, sine and vers of the negative moment as a function of the distance from the end of a phase."""
    sine_end = f[0] - f[3]
    cosine = 1.0 - f[2]
    change = sine * sine_end + vers * f[2]
    back[first] = -(drive + change)
    back[first + 1] = sine * cosine + vers * sine_end
    back[first + 2] = sine * sine_end - vers * cosine


def mirror(back: Floats, drive: Floats, sine: Floats, vers: Floats, q: Floats, f: Floats) -> None:
    """Compute the factors of E about the end of a phase, from the four functions there."""
    look_back(back, 0, drive, sine, vers, f)
    factors(back, back[0], back[1], back[2], -q)


def reverse(f: Floats, q: Floats) -> None:
    """Replace the functions for q by those for -q."""
    y = q * f[0]
    bend = q * q * f[1]
    faded_by = 1.0 - y + bend
    square = f[0] * f[0]
    rest = square - f[1] - y * f[1]
    f[1] = rest / faded_by


def expand_right_side(s: Lanes, e: Floats, drive: Floats) -> None:
    """Compute the power series of the right-hand side. ``drive`` is the net moment with the load at the beginning."""
    q = e[4]
    sine = e[NET + 1] + e[FIRST] * e[LOAD + 1]
    vers = e[NET + 2] + e[FIRST] * e[LOAD + 2]
    fading: Floats = 2.0
    even: Floats = 2.0
    odd: Floats = 0.0
    before: Floats = 0.0
    for k in range(2 * HALF + 1):
        versine = fading - even
        whole = drive * fading + (sine * odd + vers * versine)
        e[POWER + k] = e[POLE] * whole + before
        before = e[NET] * fading + (e[NET + 1] * odd + e[NET + 2] * versine)
        of_sine = odd * q + even
        of_cosine = even * q - odd
        fading = fading * q * (1.0 / (k + 1))
        even = of_cosine * (1.0 / (k + 1))
        odd = of_sine * (1.0 / (k + 1))


def hyperbolic_factors(s: Lanes, e: Floats, q: Floats, drive: Floats) -> None:
    """Compute -w/p and the power series. ``drive`` is the net moment with the load at the beginning."""
    e[0] = 2.0 * e[NET]
    e[4] = q
    e[SHIFT] = np.where(e[SHIFT] == 0.0, LEAST, e[SHIFT])
    expand_right_side(s, e, drive)
    higher: Floats = 0.0
    for k in range(2 * HALF, 1 - 1, -1):
        per = 1.0 / (e[SHIFT] + float(k))
        shrink = float(k + 1) * e[POLE] * per
        higher = e[POWER + k] * per - shrink * higher
        e[POWER + k] = higher
    weight = e[POWER] - e[POLE] * higher
    e[POWER] = -weight / e[SHIFT]


def hyperbolic_energy(e: Floats, f: Floats, passed: Floats) -> Floats:
    """Return E, and compute x in place 0, where the logarithm of 1 + x/pole is ``passed``."""
    x = e[POLE] * np.expm1(passed)
    f[0] = x
    square = x * x
    even = e[POWER + 2 * HALF]
    odd = e[POWER + 2 * HALF - 1]
    for k in range(HALF - 1, 1 - 1, -1):
        even = even * square + e[POWER + 2 * k]
        odd = odd * square + e[POWER + 2 * k - 1]
    series = x * (odd + x * even)
    singular = e[POWER] * np.expm1(-e[SHIFT] * passed)
    return (1.0 + np.expm1(-e[4] * x)) * (series + singular)


def factors_of_terms(e: Floats, q: Floats, rate: Floats) -> None:
    """Compute the factors of all terms from the numbers of the net moment without the load, and of the load."""
    factors(e, e[NET], e[NET + 1], e[NET + 2], q)
    part = np.zeros((ix.STRIDE, e.shape[1]))
    weight: Floats = 1.0
    for j in range(1, TERMS + 1):
        before = weight
        weight = weight * e[SHIFT] / float(-j)
        drive = weight * e[NET] + before * e[LOAD]
        sine = weight * e[NET + 1] + before * e[LOAD + 1]
        vers = weight * e[NET + 2] + before * e[LOAD + 2]
        faster = q + float(j) * rate
        factors(part, drive, sine, vers, faster)
        e[CONSTANT + j] = (part[0] + part[3]) / part[4]
        e[SINE + j] = part[3]
        e[VERS + j] = part[2]


def factors_of_law(s: Lanes, e: Floats, q: Floats, rate: Floats, drive: Floats) -> None:
    """Compute the factors of E from the numbers of the net moment and of the load. ``drive`` is their sum."""
    if s.roles.per_pole >= 0:
        hyperbolic_factors(s, e, q, drive)
        return
    factors_of_terms(e, q, rate)


def softening_factors(s: Lanes, e: Floats) -> None:
    """Compute the factors of E."""
    c = s.cells
    e[SHIFT] = 2.0 * c[s.roles.net_loss_square] / c[s.roles.loss_rate]
    e[FIRST] = 1.0
    e[LOAD] = c[s.roles.net_loss]
    e[LOAD + 1] = c[s.roles.net_loss_sine]
    e[LOAD + 2] = c[s.roles.net_loss_vers]
    e[NET] = c[s.roles.drive] - c[s.roles.net_loss]
    e[NET + 1] = c[s.roles.net_sine] - c[s.roles.net_loss_sine]
    e[NET + 2] = c[s.roles.net_vers] - c[s.roles.net_loss_vers]
    e[POLE] = -1.0 / c[s.roles.loss_rate]
    q = 2.0 * (c[s.roles.net_loss_square] - c[s.roles.net_square])
    factors_of_law(s, e, q, c[s.roles.loss_rate], c[s.roles.drive])


def factors_about_end(s: Lanes, back: Floats, e: Floats, f: Floats) -> None:
    """Compute the factors of E as a function of the distance from the end of a phase, from the functions there."""
    c = s.cells
    back[SHIFT] = e[SHIFT]
    back[FIRST] = 1.0 + f[4]
    look_back(back, LOAD, e[LOAD], e[LOAD + 1], e[LOAD + 2], f)
    look_back(back, NET, e[NET], e[NET + 1], e[NET + 2], f)
    back[POLE] = -e[POLE] - f[0]
    drive = back[NET] + back[FIRST] * back[LOAD]
    factors_of_law(s, back, -e[4], -c[s.roles.loss_rate], drive)


def series_suffices(s: Lanes, e: Floats) -> Mask:
    """Return whether the series is as accurate as the order of a lane requires, and no term is in resonance."""
    c = s.cells
    driven = np.abs(c[s.roles.net_loss]) <= DRIVEN * c[s.roles.drive]
    if s.roles.per_pole >= 0:
        return driven & (e[SHIFT] > LEAST_EXPONENT)
    converges = np.abs(e[SHIFT]) <= GREATEST
    resonates = 2.0 * e[4] + c[s.roles.loss_rate] >= 0.0
    return driven & converges & np.logical_not(resonates)


def softening_functions(s: Lanes, e: Floats, f: Floats, x: Floats) -> None:
    """Compute the functions of which E consists, the last one what friction has lost, such as exp(-slope x) - 1."""
    c = s.cells
    functions(f, x, np.abs(e[4]))
    if s.roles.per_pole >= 0:
        change = c[s.roles.loss_rate] * x
        f[4] = change / (1.0 - change)
        return
    f[4] = np.expm1(c[s.roles.loss_rate] * x)


def count_from_end(s: Lanes, back: Floats, f: Floats, x: Floats) -> None:
    """Change the functions of a distance from the end of a phase to those of E there, at the rotation ``x``."""
    c = s.cells
    reverse(f, -back[4])
    f[4] = -f[4] * (1.0 + np.expm1(c[s.roles.loss_rate] * x))


def softening_energy(e: Floats, f: Floats) -> Floats:
    """Return E from its factors and its functions."""
    first = e[FIRST]
    left = first + f[4]
    above: Floats = 0.0
    constant: Floats = 0.0
    of_sine: Floats = 0.0
    of_vers: Floats = 0.0
    for j in range(TERMS, 1 - 1, -1):
        above = above * first + e[CONSTANT + j]
        constant = constant * left + above
        of_sine = of_sine * left + e[SINE + j]
        of_vers = of_vers * left + e[VERS + j]
    sine = f[0] - f[3]
    turned_part = left * (of_vers * f[2] - of_sine * sine)
    terms = f[4] * constant + turned_part
    shift = e[SHIFT] * left
    grown: Floats = 0.0
    for k in range(LAST, 0 - 1, -1):
        grown = FADING[k] - grown * shift
    square = shift * shift
    grown = 1.0 + (shift + square * grown)
    lost = f[0] - e[4] * f[1]
    faded_part = e[4] * (above * first) * lost
    return grown * (energy(e, f) + (terms + faded_part))


def passed_to(s: Lanes, x: Floats) -> Floats:
    """Return the variable of the rules: the rotation, or under hyperbolic friction the logarithm from its pole."""
    c = s.cells
    if s.roles.per_pole >= 0:
        return np.log1p(c[s.roles.per_pole] * x)
    return x


def energy_at(s: Lanes, e: Floats, f: Floats, x: Floats) -> Floats:
    """Compute the functions of which E consists, and return E."""
    if s.roles.loss_rate >= 0:
        softening_functions(s, e, f, x)
        return hyperbolic_energy(e, f, passed_to(s, x)) if s.roles.per_pole >= 0 else softening_energy(e, f)
    functions(f, x, e[4])
    return energy(e, f)


def evaluate_at(s: Lanes, e: Floats, f: Floats, x: Floats) -> None:
    """Compute the functions of which E consists, and from place 5 on E and its first three derivatives."""
    c = s.cells
    drive = 1.0 * c[s.roles.drive]
    of_sine = 1.0 * c[s.roles.net_sine]
    of_vers = 1.0 * c[s.roles.net_vers]
    of_square = 1.0 * c[s.roles.net_square]
    by_loss: Floats = 0.0
    f[5] = energy_at(s, e, f, x)
    if s.roles.loss_rate >= 0:
        left = 1.0 + f[4]
        rate = c[s.roles.loss_rate] * left
        if s.roles.per_pole >= 0:
            rate = rate * left
        weight = force_at(c[s.roles.net_loss], c[s.roles.net_loss_sine], c[s.roles.net_loss_vers], f)
        by_loss = rate * (weight + c[s.roles.net_loss_square] * f[5])
        drive = drive + f[4] * c[s.roles.net_loss]
        of_sine = of_sine + f[4] * c[s.roles.net_loss_sine]
        of_vers = of_vers + f[4] * c[s.roles.net_loss_vers]
        of_square = of_square + f[4] * c[s.roles.net_loss_square]
    sine = f[0] - f[3]
    cosine = 1.0 - f[2]
    twice = 2.0 * of_square
    f[6] = 2.0 * force_at(drive, of_sine, of_vers, f) + twice * f[5]
    f[7] = 2.0 * (of_sine * cosine + of_vers * sine + by_loss) + twice * f[6]
    f[8] = 2.0 * (of_vers * cosine - of_sine * sine) + twice * f[7]


def energy_past(s: Lanes, e: Floats, f: Floats, past: Floats, end: Floats, part: int) -> Floats:
    """Return E at a distance from rest in the variable of the rules, and compute dx by this variable in place 5."""
    f[5] = 1.0
    if s.roles.per_pole >= 0:
        at = hyperbolic_energy(e, f, -past if part else past)
        f[5] = np.abs(e[POLE] + f[0])
        return at
    softening_functions(s, e, f, past)
    if part:
        count_from_end(s, e, f, end - past)
    return softening_energy(e, f)


def at_node(s: Lanes, e: Floats, end: Floats, unit: Floats, bend: Floats, node: Floats, part: int) -> tuple[Floats,
        Floats]:
    """Return E and the integrand at a node of `time_of_part`, with its arguments."""
    here = unit * (node * node)
    other = 1.0 + bend * (1.0 - node)
    share = 1.0 / (here + other * other)
    past = end * (here * share)
    f = np.zeros((ix.STRIDE, e.shape[1]))
    energy_there = energy_past(s, e, f, past, end, part)
    return (energy_there, share * share * (other * node) * f[5] / np.sqrt(energy_there))


def time_of_part(s: Lanes, e: Floats, end: Floats, unit: Floats, bend: Floats, part: int, closer: int) -> Floats:
    """Return the time before the greatest speed, or with ``part`` 1 after it, infinite if it is uncertain."""
    total: Floats = 0.0
    last: Floats = 0.0
    last_but_one: Floats = 0.0
    lower: Floats = 0.0
    longest = closer and part == 0
    k_first = 7 * SHORTEST if longest else 3 * SHORTEST if closer == part else SHORTEST
    for k in range(k_first, 2 * k_first + SHORTEST - 1 + 1):
        at, slowness = at_node(s, e, end, unit, bend, NODES[k], part)
        total = np.where(at > lower, total + SHARES[k] * slowness, INFINITY)
        lower = at
        last = last + LAST_SHARES[k] * slowness
        last_but_one = last_but_one + NEXT_SHARES[k] * slowness
    most: Floats = CLOSER if s.highest > FINEST else ALIKE
    uneven = np.abs(last) + np.abs(last_but_one)
    accurate = uneven <= most * total
    time = end * unit * (1.0 + bend) * total
    return np.where(accurate, time, INFINITY)


def duration_of_softening(s: Lanes, e: Floats, f: Floats, end: Floats, peak: Floats, closer: int) -> tuple[Floats,
        Floats]:
    """Return the times from rest to the greatest speed and to the end, infinite if they are uncertain."""
    c = s.cells
    to_peak = passed_to(s, peak)
    to_end = passed_to(s, end)
    unit = to_peak / (to_end - to_peak)
    softened = 1.0 - peak * c[s.roles.loss_rate]
    usual = np.where(c[ix.FACTOR] < BETWEEN, RATIO_TO_ROUNDING, RATIO)
    change = c[ix.FACTOR] / usual
    bend = change * BENT * np.sqrt(softened)
    if s.roles.per_pole >= 0:
        bend = change * CLOSER_TO_POLE
        reach = end + e[POLE]
        complete = (1.0 + e[4] * e[4]) * (reach * reach) < COMPLETE
        to_end = np.where(complete, to_end, INFINITY)
    before = time_of_part(s, e, to_end, unit, bend, 0, closer)
    back = np.zeros((ix.STRIDE, e.shape[1]))
    factors_about_end(s, back, e, f)
    after = time_of_part(s, back, to_end, 1.0 / unit, change - 1.0, 1, closer)
    return (before, before + after)


def mean_of(both: Floats, pairs: int, by: int) -> Floats:
    """Return the mean of the integrand by the trapezoidal rule of twice so many intervals, of every node in ``by``."""
    ends = both[0] + both[PAIRS]
    total = 0.5 * ends
    for k in range(1, pairs - 1 + 1):
        total = total + both[k * by]
    return total / float(2 * pairs)


def find_waves(w: Floats, here: Mask, both: Floats, odd: Floats, pairs: int, by: int) -> None:
    """Compute the coefficients of the time as a series in u and sines of 2 u from the nodes of a rule."""
    if not np.any(here):
        return
    scale: Floats = 1.0 / float(pairs)
    w[0] = np.where(here, mean_of(both, pairs, by), w[0])
    for j in range(1, pairs + 1):
        of_odd: Floats = 0.0
        of_even: Floats = 0.0
        even_row = 2 * j * (PAIRS + 1)
        odd_row = even_row - (PAIRS + 1)
        for k in range(pairs + 1):
            node = k * by
            of_odd = of_odd + COSINES[odd_row + node] * odd[node]
            of_even = of_even + COSINES[even_row + node] * both[node]
        last: Floats = 0.5 if j == pairs else 1.0
        w[2 * j - 1] = np.where(here, scale * of_odd, w[2 * j - 1])
        w[2 * j] = np.where(here, scale * last * of_even, w[2 * j])


def time_at(w: Floats, u: Floats, place: Floats, sine: Floats) -> tuple[Floats, Floats]:
    """Return the time since rest at the rotation end sin(u)^2, and its derivative by u."""
    top = 2 * PAIRS if np.any(w[LONG] > 0.0) else PAIRS
    twice = -2.0 * place
    cosine = -place
    sine_before: Floats = 0.0
    cosine_before: Floats = 1.0
    time = 2.0 * w[0] * u
    slope = 2.0 * w[0]
    for m in range(1, top + 1):
        time = time + w[m] * sine
        slope = slope + float(2 * m) * w[m] * cosine
        sine_after = twice * sine - sine_before
        cosine_after = twice * cosine - cosine_before
        sine_before = sine
        cosine_before = cosine
        sine = sine_after
        cosine = cosine_after
    return (time, slope)


def time_to(w: Floats, x: Floats, end: Floats) -> Floats:
    """Return the time from rest to a rotation, with u from the series of the arcsine."""
    left = end - x
    place = (x - left) / end
    sine = 2.0 * np.sqrt(x * left) / end
    z = place / np.sqrt(2.0 + 2.0 * sine)
    square = z * z
    total: Floats = 0.0
    for k in range(LAST_OF_ARCSINE, 0 - 1, -1):
        total = total * square + ARCSINE[k]
    time, _ = time_at(w, QUARTER + z * total, place, sine)
    return time


def is_uneven(w: Floats, n: int) -> Mask:
    """Return whether the last two coefficients of the series of the time are not negligible."""
    last = np.abs(w[n - 1]) + np.abs(w[n])
    return np.logical_not(last <= LAST_WAVE * w[0])


def find_state(s: Lanes, there: Floats, here: Mask, e: Floats, back: Floats, w: Floats, end: Floats,
        time: Floats) -> None:
    """Compute the rotation, the angular velocity and its rate at a time since rest, where lanes of the mask move."""
    c = s.cells
    if not np.any(here):
        return
    u = there[ANGLE_THERE]
    slope: Floats = 1.0
    lag, versine = turned(2.0 * u)
    asked = here
    count = 0
    while np.any(asked) and count < MOST_CORRECTIONS:
        then, slope = time_at(w, u, versine - 1.0, 2.0 * u - lag)
        change = (time - then) / slope
        u = np.where(asked, u + change, u)
        asked = asked & (np.abs(change) > LAST_OF_NEWTON * u)
        lag, versine = turned(2.0 * u)
        count = count + 1
    there[ANGLE_THERE] = u
    there[SLOPE_THERE] = slope
    x = 0.5 * end * versine
    f = np.zeros((ix.STRIDE, there.shape[1]))
    functions(f, x, e[4])
    square = energy(e, f)
    there[0] = x
    there[RATE_THERE] = force_at(c[s.roles.drive], c[s.roles.net_sine], c[s.roles.net_vers],
        f) + c[s.roles.net_square] * square
    late = versine > 1.0
    if np.any(here & late):
        _, versine_back = turned(PI - 2.0 * u)
        functions(f, 0.5 * end * versine_back, e[4])
        reverse(f, e[4])
        square = np.where(late, energy(back, f), square)
    there[OMEGA_THERE] = np.sqrt(square)


def keep_samples(s: Lanes, here: Mask, e: Floats, back: Floats, w: Floats, end: Floats, until: Floats) -> None:
    """Store the states at the output times within a phase, which ends at the time ``until``."""
    c = s.cells
    if not np.any(here):
        return
    there = np.zeros((ix.STRIDE, e.shape[1]))
    there[ANGLE_THERE] = 0.0
    there[SLOPE_THERE] = 2.0 * w[0]
    before = c[ix.TIME].copy()
    k = 0
    while k < s.sample_count:
        time = sample_time(s, k)
        inside = here & (time >= c[ix.TIME]) & (time < until)
        if np.any(inside):
            ahead = (time - before) / there[SLOPE_THERE]
            there[ANGLE_THERE] = np.where(inside, there[ANGLE_THERE] + ahead, there[ANGLE_THERE])
            before = np.where(inside, time, before)
            find_state(s, there, inside, e, back, w, end, time - c[ix.TIME])
            keep_sample(s, inside, k, there[0], there[OMEGA_THERE], there[RATE_THERE])
        k = k + 1


def end_of_swing(s: Lanes, e: Floats, sine: Floats, which: Mask) -> Floats:
    """Return the first positive zero of E, by Halley's method on E/x, or a rotation beyond the farthest."""
    falls_by = 0.5 * (e[4] * e[0]) - sine
    x = e[0] / falls_by
    f = np.zeros((ix.STRIDE, e.shape[1]))
    count = 0
    while np.any(which) and count < MOST_CORRECTIONS:
        inside = (x > 0.0) & (x < FARTHEST)
        x = np.where(inside, x, FARTHEST)
        evaluate_at(s, e, f, x)
        at = f[5]
        falls = f[6] * x - at
        bends = f[7] * (x * x) - 2.0 * falls
        steepness = 2.0 * falls * falls - at * bends
        change = 2.0 * at * falls * x / steepness
        x = np.where(which, x - change, x)
        which = which & (np.abs(change) > LAST_OF_HALLEY * x)
        count = count + 1
    return np.where(which, 2.0 * FARTHEST, x)


def peak_of_cubic(rise: Floats, fall: Floats, end: Floats) -> Floats:
    """Return the rotation of the greatest speed if E is a cubic with these slopes at both of its zeros."""
    square = rise * rise + fall * (fall - rise)
    falls_by = 2.0 * rise - fall + np.sqrt(square)
    return end * rise / falls_by


def peak_of_swing(s: Lanes, e: Floats, f: Floats, x: Floats, end: Floats, which: Mask) -> Floats:
    """Return the rotation of the greatest speed, by Halley's method on the derivative of E from a rotation ``x`` on."""
    low: Floats = 0.0
    high = end
    count = 0
    while np.any(which) and count < 2 * MOST_CORRECTIONS:
        evaluate_at(s, e, f, x)
        slope = f[6]
        low = np.where(slope > 0.0, x, low)
        high = np.where(slope > 0.0, high, x)
        twice = 2.0 * f[7]
        following = x - slope * twice / (twice * f[7] - slope * f[8])
        following = inside_or_middle(following, low, high)
        change = following - x
        bend = f[7] * change
        f[9] = np.where(which, f[5] + change * (slope + 0.5 * bend), f[9])
        f[10] = np.where(which, slope + bend, f[10])
        x = np.where(which, following, x)
        which = which & (np.abs(change) > LAST_OF_NEWTON * x)
        count = count + 1
    return x


def stays_positive(start: Floats, sine: Floats, vers: Floats, f: Floats) -> Mask:
    """Return whether start + sine sin + vers (1 - cos) is positive and concave over a rotation up to half a turn."""
    at_end = force_at(start, sine, vers, f)
    cosine = 1.0 - f[2]
    change = sine * (f[0] - f[3])
    concave = (vers <= 0.0) & (vers * cosine <= change)
    return (start > 0.0) & (at_end > 0.0) & concave


def has_closed_form(s: Lanes, f: Floats, q: Floats) -> Mask:
    """Return whether phases up to a rotation have the closed form, from the functions of E there."""
    c = s.cells
    end = f[0]
    near = (end < FARTHEST) & (q >= 0.0) & (q * end < FADED)
    upright = stays_positive(c[s.roles.normal_load], c[s.roles.upright_sine], c[s.roles.upright_vers], f)
    pressed = stays_positive(c[s.roles.normal0], c[s.roles.normal_sine], c[s.roles.normal_vers], f)
    return near & (c[s.roles.normal_square] >= 0.0) & upright & pressed


def add_node(e: Floats, back: Floats, end: Floats, both: Floats, odd: Floats, k: int) -> None:
    """Compute sum and difference of the integrand at a node and at its mirror image, the same node from the end."""
    x = end * SINES[k]
    f = np.zeros((ix.STRIDE, e.shape[1]))
    functions(f, x, e[4])
    left = end - x
    room = x * left
    near = np.sqrt(room / energy(e, f))
    reverse(f, e[4])
    far = np.sqrt(room / energy(back, f))
    both[k] = near + far
    odd[k] = near - far


def duration_of_swing(e: Floats, back: Floats, end: Floats, w: Floats, which: Mask) -> Floats:
    """Return the time from rest to rest, infinite if it is uncertain, and compute the time as a series in ``w``."""
    both = np.zeros((ix.STRIDE, e.shape[1]))
    odd = np.zeros((ix.STRIDE, e.shape[1]))
    near = np.sqrt(end / e[0])
    far = np.sqrt(end / back[0])
    both[0] = near + far
    odd[0] = near - far
    for k in range(1, 4 + 1):
        add_node(e, back, end, both, odd, 2 * k)
    for m in range(LONG + 1):
        w[m] = 0.0
    find_waves(w, which, both, odd, 4, 2)
    unsure = which & is_uneven(w, 8)
    if np.any(unsure):
        for k in range(1, 4 + 1):
            add_node(e, back, end, both, odd, 2 * k - 1)
        find_waves(w, unsure, both, odd, 8, 1)
        w[LONG] = np.where(unsure, 1.0, 0.0)
        unsure = unsure & is_uneven(w, 16)
    return np.where(unsure, INFINITY, PI * w[0])


def rest(s: Lanes, here: Mask, rate: Floats, lost: Floats, f: Floats) -> None:
    """Let masses at a standstill stick, without the numbers of another phase, if they clearly do not turn back."""
    c = s.cells
    if not np.any(here):
        return
    force = force_at(c[s.roles.normal0], c[s.roles.normal_sine], c[s.roles.normal_vers], f)
    resistance = c[s.roles.resisting] + c[s.roles.mu] * force - lost
    driving = rate + resistance
    terms = np.abs(driving) + resistance + np.abs(lost)
    excess = driving + resistance
    free = (c[ix.ONE_WAY] == 0.0) & (c[ix.FIRST_ONLY] == 0.0)
    clear = excess > CLEAR * terms
    here = here & free & clear
    margin = excess / (EPS * terms)
    c[ix.CLOSE] = np.where(here, np.minimum(c[ix.CLOSE], margin), c[ix.CLOSE])
    stick(s, here)


def rest_softened(s: Lanes, here: Mask, f: Floats) -> None:
    """Let masses stick at the end of a phase in which friction has softened, if they clearly do not turn back."""
    c = s.cells
    if not np.any(here):
        return
    lost = f[4] * force_at(c[s.roles.net_loss], c[s.roles.net_loss_sine], c[s.roles.net_loss_vers], f)
    rate = lost + force_at(c[s.roles.drive], c[s.roles.net_sine], c[s.roles.net_vers], f)
    rest(s, here, rate, lost, f)


def pass_peak(s: Lanes, here: Mask, f: Floats, peak: Floats, before: Floats) -> None:
    """Record the greatest speed, which lanes reach after the time ``before``."""
    c = s.cells
    if not np.any(here):
        return
    speed = np.sqrt(f[9])
    then = c[ix.TIME] + before
    keep_faster(s, here, speed, then, peak, 0.5 * f[10])


def finish(s: Lanes, here: Mask, end: Floats, duration: Floats) -> None:
    """Bring lanes to rest at the end of their phase."""
    c = s.cells
    if not np.any(here):
        return
    c[ix.X] = np.where(here, end, c[ix.X])
    c[ix.OMEGA] = np.where(here, 0.0, c[ix.OMEGA])
    c[ix.TIME] = np.where(here, c[ix.TIME] + duration, c[ix.TIME])
    c[ix.STEPS] = np.where(here, c[ix.STEPS] + 1.0, c[ix.STEPS])
    c[ix.PASSED] = np.where(here, ix.NOTHING, c[ix.PASSED])
    on_standstill(s, here)


def end_within(s: Lanes, here: Mask, e: Floats, back: Floats, w: Floats, end: Floats) -> None:
    """End lanes at their end time within a phase."""
    c = s.cells
    if not np.any(here):
        return
    there = np.zeros((ix.STRIDE, e.shape[1]))
    time = c[ix.END_TIME] - c[ix.TIME]
    there[ANGLE_THERE] = 0.5 * time / w[0]
    find_state(s, there, here, e, back, w, end, time)
    c[ix.X] = np.where(here, there[0], c[ix.X])
    c[ix.OMEGA] = np.where(here, there[OMEGA_THERE], c[ix.OMEGA])
    rate = there[RATE_THERE]
    c[ix.TIME] = np.where(here, c[ix.END_TIME], c[ix.TIME])
    c[ix.STEPS] = np.where(here, 0.0, c[ix.STEPS])
    keep_faster(s, here, c[ix.OMEGA], c[ix.TIME], c[ix.X], rate)
    end_motion(s, here, rate, ix.ENDED)


def complete_swing(s: Lanes, fits: Mask, e: Floats, back: Floats, f: Floats, at_peak: Floats, end: Floats,
        peak: Floats) -> Mask:
    """Complete phases under constant friction, up to rest or the end time, and return these lanes."""
    c = s.cells
    w = np.zeros((ix.STRIDE, e.shape[1]))
    off_middle = np.abs(2.0 * peak - end)
    fits = fits & (off_middle < NEAR_MIDDLE * end)
    duration = duration_of_swing(e, back, end, w, fits)
    before = time_to(w, peak, end)
    until = c[ix.TIME] + duration
    rests = fits & (until < c[ix.END_TIME])
    ends = fits & (until < INFINITY) & (until > c[ix.END_TIME] * (1.0 + CLOSE_TO_REST))
    if s.sample_count:
        keep_samples(s, rests | ends, e, back, w, end, until)
    pass_peak(s, rests | ends & (c[ix.TIME] + before < c[ix.END_TIME]), at_peak, peak, before)
    finish(s, rests, end, duration)
    rest(s, rests, -0.5 * back[0], 0.0, f)
    end_within(s, ends, e, back, w, end)
    return rests | ends


def complete_softening(s: Lanes, fits: Mask, e: Floats, f: Floats, at_peak: Floats, end: Floats, peak: Floats) -> Mask:
    """Complete phases under softening laws, up to rest before the end time, and return these lanes."""
    c = s.cells
    least = LEAST_DURATION * end / np.sqrt(at_peak[9])
    fits = fits & (c[ix.TIME] + least < c[ix.END_TIME])
    if not np.any(fits):
        return fits
    fine = s.highest > FINEST
    before, duration = duration_of_softening(s, e, f, end, peak, fine)
    unsure = fits & (duration == INFINITY)
    if not fine and np.any(unsure):
        sooner, sure = duration_of_softening(s, e, f, end, peak, 1)
        before = np.where(unsure, sooner, before)
        duration = np.where(unsure, sure, duration)
    fits = fits & (c[ix.TIME] + duration < c[ix.END_TIME])
    pass_peak(s, fits, at_peak, peak, before)
    finish(s, fits, end, duration)
    rest_softened(s, fits, f)
    return fits


def swing(s: Lanes, which: Mask) -> Mask:
    """Complete the phases that begin at rest and in contact, where they have a closed form, and return these lanes."""
    c = s.cells
    rests = (c[ix.X] == 0.0) & (c[ix.OMEGA] == 0.0)
    fits = which & rests & (c[s.roles.drive] > 0.0) & (c[ix.LIFTED] == 0.0)
    if not np.any(fits):
        return fits
    softens = s.roles.loss_rate >= 0
    e = np.zeros((ix.STRIDE, s.registers[0].shape[1]))
    back = np.zeros((ix.STRIDE, s.registers[0].shape[1]))
    f = np.zeros((ix.STRIDE, s.registers[0].shape[1]))
    sine = c[s.roles.net_sine].copy()
    if softens:
        softening_factors(s, e)
        fits = fits & series_suffices(s, e)
        sine = c[s.roles.net_sine] - c[s.roles.net_loss_sine]
    if not softens:
        factors(e, c[s.roles.drive], sine, c[s.roles.net_vers], -2.0 * c[s.roles.net_square])
    q = e[4]
    end = end_of_swing(s, e, sine, fits)
    farthest = np.minimum(end, FARTHEST)
    peak = 0.5 * end
    if softens:
        softening_functions(s, e, f, farthest)
    if not softens:
        functions(f, farthest, q)
        mirror(back, c[s.roles.drive], sine, c[s.roles.net_vers], q, f)
        peak = peak_of_cubic(e[0], back[0], end)
        fits = fits & (back[0] > 0.0)
    fits = fits & has_closed_form(s, f, q)
    if not np.any(fits):
        return fits
    at_peak = np.zeros((ix.STRIDE, s.registers[0].shape[1]))
    peak = peak_of_swing(s, e, at_peak, peak, end, fits)
    if softens:
        return complete_softening(s, fits, e, f, at_peak, end, peak)
    return complete_swing(s, fits, e, back, f, at_peak, end, peak)


def look_ahead(s: Lanes, here: Mask, room: Floats) -> None:
    """Find the next change of a mass at rest in its direction, if it precedes the changes that are known already."""
    c = s.cells
    if not np.any(here):
        return
    top = expand(s, room, here, 1)
    net = s.registers[s.roles.net]
    complete = here & (c[ix.SERIES_ORDER] == c[ix.ORDER])
    if np.any(complete):
        step = longest_step(s, net, top - 1, c[ix.SERIES_ORDER] - 1.0)
        c[ix.STEP] = np.where(here, np.where(complete, np.minimum(step, c[ix.STEP]), c[ix.STEP]), c[ix.STEP])
    touches = np.abs(net[0]) <= TOUCHES * c[s.roles.drive_scale]
    jumps = (net[0] > 0.0) & np.logical_not(touches)
    at_once = jumps | touches & (net[1] > 0.0)
    later = crossing(net, top - 1, c[ix.STEP], -1.0, 0.0, touches, here & np.logical_not(at_once))
    at = np.where(at_once, 0.0, later)
    consider(s, here, at, ix.EVENT_START)
    sooner = at <= c[ix.STEP]
    c[ix.START_DIRECTION] = np.where(here, np.where(sooner, c[ix.DIRECTION], c[ix.START_DIRECTION]),
        c[ix.START_DIRECTION])
    c[ix.SUDDEN] = np.where(here, np.where(sooner, np.where(jumps, 1.0, 0.0), c[ix.SUDDEN]), c[ix.SUDDEN])
    look_for_quiet(s, here)
    known = 1.0 * c[ix.STEP]
    c[ix.STEP] = np.where(here, np.minimum(known * (1.0 + TOGETHER), room), c[ix.STEP])
    find_contact_change(s, here, top)
    c[ix.STEP] = np.where(here, np.where(c[ix.EVENT] == ix.EVENT_LIFT_OFF, c[ix.STEP], known), c[ix.STEP])


def turn_back(s: Lanes, here: Mask) -> None:
    """Reverse the direction at rest."""
    c = s.cells
    if not np.any(here):
        return
    c[ix.DIRECTION] = np.where(here, -c[ix.DIRECTION], c[ix.DIRECTION])
    c[ix.PENDING] = np.where(here, ix.BEGIN_PHASE, c[ix.PENDING])


def start_again(s: Lanes, here: Mask) -> None:
    """Start slip from rest."""
    c = s.cells
    if not np.any(here):
        return
    face(s, here, c[ix.START_DIRECTION])
    c[ix.PENDING] = np.where(here, ix.START_AGAIN, c[ix.PENDING])


def leave_rest(s: Lanes, here: Mask, limit: Floats) -> None:
    """Advance to the first change: start of slip, change of contact, break or end."""
    c = s.cells
    if not np.any(here):
        return
    lifts = c[ix.EVENT] == ix.EVENT_LIFT_OFF
    starts = c[ix.EVENT] == ix.EVENT_START
    breaks = c[ix.EVENT] == ix.EVENT_LIMIT
    until = np.where(breaks, limit, c[ix.TIME] + c[ix.STEP])
    for_ever = np.logical_not(starts) & np.logical_not(until < INFINITY)
    if s.sample_count:
        read_samples(s, here, c[ix.TIME], np.minimum(until, c[ix.END_TIME]), 0, 0)
    least = TOGETHER * until
    rested = starts & (c[ix.STEP] > least)
    c[ix.STEPS] = np.where(here, np.where(breaks | rested, 0.0, c[ix.STEPS] + 1.0), c[ix.STEPS])
    c[ix.PASSED] = np.where(here, ix.NOTHING, c[ix.PASSED])
    ends = here & (for_ever | (until >= c[ix.END_TIME]))
    c[ix.TIME] = np.where(here, np.where(for_ever, c[ix.TIME], np.minimum(until, c[ix.END_TIME])), c[ix.TIME])
    stay(s, ends, np.where(for_ever, ix.ARRESTED, ix.PAUSED))
    here = here & np.logical_not(ends)
    start_again(s, here & starts)
    change_contact(s, here & lifts)
    c[ix.PENDING] = np.where(here, np.where(lifts, ix.BEGIN_PHASE, c[ix.PENDING]), c[ix.PENDING])
    enter_pieces(s, here & breaks)


def rest_to_change(s: Lanes, here: Mask, limit: Floats, room: Floats) -> None:
    """Advance lanes at rest to the next break, or to the start of motion, which is found in the other direction too."""
    c = s.cells
    if not np.any(here):
        return
    both = here & (c[ix.ONE_WAY] == 0.0)
    if np.any(both):
        turn_back(s, both)
        begin_phases(s)
        look_ahead(s, both, c[ix.STEP])
    for t in s.tables:
        if t.kind == ix.OF_TIME:
            c[t.cells + ix.INC] = np.where(here, c[t.cells + ix.INC] + rise_of_step(s, t), c[t.cells + ix.INC])
    reaches = (c[ix.EVENT] == ix.EVENT_NONE) & (c[ix.STEP] >= room)
    c[ix.EVENT] = np.where(here, np.where(reaches, ix.EVENT_LIMIT, c[ix.EVENT]), c[ix.EVENT])
    leave_rest(s, here, limit)


def rest_on(s: Lanes, here: Mask) -> None:
    """Advance lanes at rest under changing forces to the next break, or to the start of motion."""
    c = s.cells
    if not np.any(here):
        return
    limit = next_break(s)
    room = np.where(limit < INFINITY, limit - c[ix.TIME], 1.0)
    c[ix.EVENT] = np.where(here, ix.EVENT_NONE, c[ix.EVENT])
    c[ix.QUIET_FROM] = np.where(here, -INFINITY, c[ix.QUIET_FROM])
    c[ix.QUIET_TO] = np.where(here, INFINITY, c[ix.QUIET_TO])
    look_ahead(s, here, room)
    later = none_of(s)
    for t in s.tables:
        alone = s.autonomous == 2 and s.timed == 1
        linear = not s.sample_count and (not s.logged) and (t.terms == 2)
        if (alone or s.roles.net_record >= 0) and linear and (t.kind == ix.OF_TIME) and (not t.sine):
            down_slope = here & (c[ix.ONE_WAY] > 0.0) & (c[ix.DIRECTION] > 0.0) & (c[ix.LIFTED] == 0.0)
            if s.roles.net_record >= 0:
                turn_through(s, down_slope, t)
            if not s.roles.net_record >= 0:
                later = slide_together(s, down_slope, t)
    stays = here & (c[ix.STATUS] == ix.RESTING) & (c[ix.PENDING] == ix.READY)
    rest_to_change(s, stays & np.logical_not(later), limit, room)


def stop_endless(s: Lanes, here: Mask) -> None:
    """Stop lanes with too many steps since they last rested or passed a break, too many turns, or overflow."""
    c = s.cells
    if not np.any(here):
        return
    going = c[ix.STATUS] <= ix.RESTING
    most = np.where(c[ix.OMEGA] > 0.0, ix.MOST_STEPS, float(2 * ix.MOST_STEPS))
    too_long = c[ix.STEPS] > most
    if not s.timed:
        too_long = too_long | (c[ix.TURNS] > ix.MOST_TURNS)
    total = c[ix.TIME] + c[ix.X] + c[ix.OMEGA] + c[ix.ROTATION]
    overflows = going & (total - total != 0.0)
    c[ix.STATUS] = np.where(here, np.where(going & too_long, ix.TOO_LONG, c[ix.STATUS]), c[ix.STATUS])
    c[ix.STATUS] = np.where(here, np.where(overflows, ix.FAILED, c[ix.STATUS]), c[ix.STATUS])


def advance(s: Lanes, here: Mask) -> None:
    """Complete phases in closed form, and make one step of the other moving lanes or of the lanes at rest."""
    c = s.cells
    if not np.any(here):
        return
    moving = here & (c[ix.STATUS] == ix.MOVING)
    resting = here & (c[ix.STATUS] == ix.RESTING)
    complete = s.roles.net_sine >= 0 and (not (s.sample_count and s.roles.loss_rate >= 0))
    for t in s.tables:
        complete = complete and t.kind != ix.OF_SLIP and (t.kind != ix.OF_TIME)
    if complete:
        moving = moving & np.logical_not(swing(s, moving))
    if s.by_rotation and (not s.sample_count):
        turning = moving & (c[ix.CLOCKED] == 0.0)
        if has_recurrence(s):
            turning = turning & (c[ix.X] == 0.0)
        turn_on(s, turning)
        moving = moving & np.logical_not(turning & (c[ix.CLOCKED] == 0.0))
    if np.count_nonzero(moving) > np.count_nonzero(resting):
        make_step(s, moving)
    if np.count_nonzero(resting) >= np.count_nonzero(moving):
        rest_on(s, resting)
    begin_phases(s)
    stop_endless(s, here)


# --- ensembles --------------------------------------------------------------------------------------------------------


def load(s: Lanes) -> None:
    """Start lanes that have not begun, and begin their pending phases."""
    begun = s.cells[ix.STATUS] == ix.START
    if np.any(begun):
        start(s, begun)
    begin_phases(s)


def integrate(
    program: Program,
    tables: Sequence[Any],
    cells: Floats,
    samples: Any = None,
    log: Log | None = None,
    shared: Any = (),
) -> None:
    """Integrate every lane until it rests, ends or fails.

    Parameters
    ----------
    program : generated.program.Program
    tables : sequence of slipcircle.tables.tables.Data
        For each table of the program.
    cells : ndarray
        (cells, lanes), changed in place: where each lane begins and, then, where it is. Its status says how it ended.
    samples : Samples, optional
        What to read off on the way.
    log : list, optional
        Takes the events of the first lane: kind, time, rotation, direction.
    shared : ndarray, optional
        (cells,), with which all lanes begin, except for those cells that are not a number here.
    """
    if len(shared):
        alike = shared == shared
        cells[alike] = shared[alike, None]
    live = np.flatnonzero(cells[ix.STATUS] <= ix.RESTING)
    with np.errstate(all="ignore"):
        while live.size:
            status = cells[ix.STATUS, live]
            alike = live[status == status[0]]  # lanes that move and lanes that rest take different steps
            s = Lanes(program, tables, cells[:, alike], alike, samples, log)
            load(s)
            for _ in range(ROUNDS):
                status = s.cells[ix.STATUS]
                if np.count_nonzero(status <= ix.RESTING) <= alike.size // 2:
                    break  # those that have ended make room
                if np.count_nonzero(status == status[0]) <= alike.size // 2:
                    break
                advance(s, status <= ix.RESTING)
            cells[:, alike] = s.stored
            live = live[cells[ix.STATUS, live] <= ix.RESTING]


def integrate_runs(program: Program, tables: Sequence[Any], start: Mapping[str, float], moves: Floats) -> Any:
    """Integrate runs of one motion; return the final cells of the first run, a list, and the `spreads` of all.

    Parameters
    ----------
    program, tables
        Arguments of `integrate`.
    start : mapping
        Initial cells by name.
    moves : ndarray
        Factors and summands of the cells in each run, (2, cells, runs).

    Returns
    -------
    tuple or None
        None if a run has not ended.
    """
    column = np.zeros((len(program.cells), 1))
    for name in start.keys() & program.places.keys():
        column[program.places[name]] = start[name]
    cells = column * moves[0] + moves[1]
    integrate(program, tables, cells)
    if np.any(cells[ix.STATUS] >= ix.TOO_LONG):
        return None
    return cells[: ix.RESULTS, 0].tolist(), spreads(cells)


def spreads(cells: Floats) -> tuple[float, ...]:
    """Return relative differences of runs of a motion from the first run, from their final cells, (cells, runs).

    They are the greatest differences of duration, run-out and peak velocity, and of states during the motion, which
    differ by the spread of times, at the peak velocity, or by the spread of rotations. All are infinite if a run ends
    otherwise.
    """
    rests = (cells[ix.STATUS] >= ix.ARRESTED) & (cells[ix.STATUS] <= ix.ENDED)
    unlike = (cells[ix.STATUS] != cells[ix.STATUS, 0]) & ~(rests & rests[0])
    moves = cells[ix.PHASES] > 0.0
    if np.any(unlike | (moves != moves[0])):
        return (np.inf,) * 4
    ended = (cells[ix.STATUS] == ix.ENDED) & (cells[ix.TIME, 0] < np.inf)
    times = np.where(ended, cells[ix.END_TIME], cells[ix.REST_SINCE])
    results = np.array([times, cells[ix.REACH_ROTATION], abs(cells[ix.PEAK_OMEGA]), cells[ix.END_ROTATION]])
    first = abs(results[:, 0])
    sizes = np.maximum(first, ix.LEAST_SIZE)
    with np.errstate(invalid="ignore"):  # of times, which may be infinite
        most = np.fmax.reduce(abs(results - results[:, :1]), axis=1)
    states = max(ix.BETWEEN * most[0] * first[2], most[3]) / sizes[1]
    return (*(most / sizes)[:3].tolist(), float(states))


def registers(program: Program, tables: Sequence[Any], cells: Floats) -> Floats:
    """Return registers in the current states of lanes, (registers, lanes)."""
    s = Lanes(program, tables, cells)
    with np.errstate(all="ignore"):
        evaluate(s)
    return s.registers[:, 0]


def begin_phase(program: Program, tables: Sequence[Any], cells: Floats) -> Floats:
    """Begin a phase in the current state and direction of each lane, and return its registers.

    The cells of a phase are filled in place.
    """
    s = Lanes(program, tables, cells)
    with np.errstate(all="ignore"):
        every = np.ones(cells.shape[1], dtype=bool)
        begin_here(s, every)
        prologue(s, every)
        evaluate(s)
    cells[:] = s.stored
    return s.registers[:, 0]
