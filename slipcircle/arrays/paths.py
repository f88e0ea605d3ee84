"""Phases of many lanes whose friction changes with slip: E = omega**2 by quadrature along the path, panel by panel.

E' = 2 (drive - brake E) is linear, so on a panel E exp(B) grows by the integral of 2 drive exp(B), where B is that of
2 brake. All of it, and the time, is integrated at the Gauss-Legendre nodes of the panel, whose error at its end is
about the square of what the series in between leave out: so a panel ends where the mass is fastest, where its time is
over and where it stands still, and nothing is read off inside. Every lane has panels of its own, which end at the
law's kinks, and grow and shrink with the last terms of their series; all lanes step together.
"""

import math
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from slipcircle.arrays.panels import (
    FROM_REST,
    INTEGRALS,
    LAST,
    LAST_FROM_REST,
    LAST_TO_REST,
    NODES,
    RATES,
    SHARES,
    SLOPE,
    TO_REST,
    TURN,
    WEIGHTS,
    rises,
    span_of,
    turned,
    way_of,
)  # fmt: skip
from slipcircle.friction import Friction

Floats = NDArray[np.float64]
Mask = NDArray[np.bool_]
Indices = NDArray[np.intp]

_ON, _PEAK, _END, _CUT = range(4)  # what a panel is laid for: the way on, the greatest speed, standstill, end of time
_NEVER = -1.0  # a standstill that is not reached in time
_CLOSE = 1e-7  # of a panel's width: so far off may its end be, which the slopes there mend to the square
_MOST = 100  # panels tried for a lane
_FIRST, _WIDEST = 2.2, 3.0  # widths of panels, in the variable of `span_of`
_STRIP = 1024  # lanes whose nodes stay in the cache together


def _some(values: Mapping[str, Any], k: Any) -> dict[str, Any]:
    return {n: v[k] if isinstance(v, np.ndarray) and v.ndim else v for n, v in values.items()}


class Panel(NamedTuple):
    """What the trial of a panel gives, by lanes; ``last`` is E at its end."""

    width: Floats
    span: Floats
    last: Floats
    rate: Floats  # d(omega)/dt there
    drive: Floats  # there
    stretch: Floats  # of x by the share, there
    lowest: Floats  # E
    slowest: Floats  # d(omega)/dt
    took: Floats
    off: Floats  # how much further the end should be
    tail: Floats  # of the time's series
    coarse: Floats  # of that of E'


def _doubt(g: Mapping[str, Any], s: Mapping[str, Any], p: Panel) -> Any:
    """What a panel adds to `Paths.doubt`; where E is small, it is so in proportion to x, or the panel ends there."""
    energy = np.where(s["wish"] == _END, s["energy"], np.minimum(s["energy"], p.last))
    return p.took * np.where(energy > 0.0, s["right"] / energy, 0.5 / np.maximum(g["drive"], 1e-300))


class Paths:
    """Phases of lanes, from their start to their standstill or the end of their time; all dimensionless.

    Parameters
    ----------
    given : mapping
        By name, arrays of one length or numbers, in the direction of travel. Of the start: ``start``, E; ``drive``,
        ``mu``, ``slip`` in m, ``left``, the time that is left; ``fall``, ``fall_slope``, ``press``, ``press_slope`` as
        in `Balance.position`. Of the balance: ``constant`` and ``brake`` without friction, ``brake_rise`` with it,
        ``share`` and ``water``, of which normal = share press - water; ``radius``, ``furthest``.
    law : callable
        The `Friction` of some lanes.
    turns, braked : bool
        Whether the mass turns as it slides, and whether there is a brake.
    accuracy : float
        Relative error that the times may have.

    Attributes
    ----------
    end, energy, rate, duration : ndarray
        Rotation where the phase ends, E, d(omega)/dt and the time since its start there.
    peak, top, peak_time : ndarray
        Rotation at which the mass is fastest, E there, and when.
    mu, missing : ndarray
        Friction at the end; what is estimated to be missing from the time, relative.
    doubt : ndarray
        By how much the time changes with the drive: the integral of x/E over it, from panel to panel.
    good, cut : ndarray of bool
        Whether the lane was solved, and whether its time was over before it stood still.
    """

    def __init__(
        self, given: Mapping[str, Any], law: Callable[[Indices], Friction], turns: bool, braked: bool, accuracy: float
    ) -> None:
        self._law, self._turns, self._braked = law, turns, braked
        self._resolved = min(max(math.sqrt(0.1 * accuracy), 3e-8), 1e-5)  # of a panel's series, the last terms
        n = len(given["start"])
        self.end, self.energy, self.rate, self.duration, self.peak, self.peak_time = np.zeros((6, n))
        self.mu, self.missing, self.doubt = np.zeros((3, n))
        self.top, (self.good, self.cut) = given["start"].copy(), np.zeros((2, n), bool)
        self._given, self._lanes = dict(given), np.arange(n)
        self._nodes = np.empty((3, NODES + 1, n))  # of the panels tried: E, d(omega)/dt, and the time by the share
        self._now = self._first_panels()
        for _ in range(_MOST):
            going = np.flatnonzero(self._step())
            if not len(going):
                break
            if len(going) < len(self._lanes):
                self._lanes, self._now = self._lanes[going], _some(self._now, going)
                self._given = _some(self._given, going)

    # -- laying panels

    def _first_panels(self) -> dict[str, Any]:
        """Where the paths begin, and how far to go before anything changes much."""
        g, law = self._given, self._law(self._lanes)
        start, drive, brake = g["start"], g["drive"], g["brake"] + g["mu"] * g["brake_rise"]
        scale = np.minimum(law.scale, g["radius"])
        falls = law.drop(g["slip"], 1e-6 * scale) / (1e-6 * scale) * g["radius"]
        change = falls * (g["share"] * g["press"] - g["water"]) - 2 * brake * drive
        if self._turns:
            change = change - g["fall_slope"] + g["mu"] * g["share"] * g["press_slope"]
        paces = (scale / g["radius"], np.abs(drive / change), 0.5 * start / np.abs(drive), 0.5 / brake, g["furthest"])
        pace = np.ones_like(start)
        for p in paces:
            pace = np.where((p > 0.0) & (p < pace), p, pace)
        sinh = np.where(start > 0.0, pace, 0.0)
        begin = {
            "x": 0.0, "sinh": sinh, "cosh": pace, "slip": g["slip"], "energy": start, "time": 0.0, "drive": drive,
            "mu": g["mu"], "rate": drive - brake * start, "right": way_of(_FIRST, sinh, pace), "ahead": np.nan,
            "missing": 0.0, "doubt": 0.0, "wish": np.int8(_ON),
        }  # fmt: skip
        s: dict[str, Any] = {n: np.array(np.broadcast_to(v, start.shape)) for n, v in begin.items()}
        return s | self._ends_within(s, law)

    def _ends_within(self, s: Mapping[str, Any], law: Friction) -> dict[str, Any]:
        """Panels that end at the law's next kink at the latest, and where the path ends; and the slip at a kink."""
        g, right, kink = self._given, np.minimum(s["right"], self._given["furthest"]), np.full(s["x"].shape, np.inf)
        if self._turns:
            right = np.minimum(right, s["x"] + TURN)
        for k in law.kinks:
            kink = np.where((k > s["slip"]) & (k < kink), k, kink)
        place = (kink - g["slip"]) / g["radius"]
        beyond = place <= right
        wish = np.where(beyond & (place < right), np.int8(_ON), s["wish"])
        return {"right": np.where(beyond, place, right), "edge": np.where(beyond, kink, np.nan), "wish": wish}

    # -- panels

    def _try(self, k: slice) -> tuple[Floats, ...]:
        """Integrate along the panels of some lanes."""
        g, s, n = _some(self._given, k), _some(self._now, k), NODES
        ends = s["wish"] == _END
        some_end = bool(np.any(ends))
        share, stretch = (t[:, ends.view(np.int8)] if some_end else t[:, :1] for t in (SHARES, RATES))
        width, sinh, cosh = s["right"] - s["x"], s["sinh"], s["cosh"]
        span = span_of(width, sinh, cosh)
        grown = np.expm1(span * share)
        bent = grown * grown
        bent /= grown + 1.0
        bent *= 0.5  # cosh - 1, as in `way_of`
        past = sinh * grown + (cosh - sinh) * bent
        jacobian = (sinh + cosh * grown + (sinh - cosh) * bent) * (span * stretch)
        fallen = self._law(self._lanes[k]).drop(s["slip"], g["radius"] * past)
        drive = s["drive"]
        if self._turns:
            cos, sin = np.cos(s["x"]), np.sin(s["x"])
            pressed = g["share"] * (g["press"] * cos - g["press_slope"] * sin)
            tilted = g["share"] * (g["press_slope"] * cos + g["press"] * sin)
            tilt = g["fall_slope"] * cos + g["fall"] * sin - s["mu"] * tilted
            sine, lift = turned(past)
            normal = (pressed - g["water"]) - pressed * lift - tilted * sine
            drive = drive - (drive + (g["constant"] - s["mu"] * g["water"])) * lift - tilt * sine + fallen * normal
        else:
            drive = drive + fallen * (g["share"] * g["press"] - g["water"])
        energy, rates, pace = (a[:, k] for a in self._nodes)
        push = 2.0 * drive[:n] * jacobian[:n]
        if self._braked:
            brake = g["brake"] + g["brake_rise"] * (s["mu"] - fallen)
            forgot = np.exp(INTEGRALS @ (2.0 * brake[:n] * jacobian[:n]))
            push *= forgot[:n]
        gained, terms = INTEGRALS @ push, LAST @ push
        if np.any(rests := (s["x"] == 0.0) & (g["start"] == 0.0)):
            gained, terms = np.where(rests, FROM_REST @ push, gained), np.where(rests, LAST_FROM_REST @ push, terms)
        np.add(s["energy"], gained, out=energy)
        if self._braked:
            energy /= forgot
            np.subtract(drive, brake * energy, out=rates)
        else:
            rates[:] = drive
        last, rate, off, inner = energy[-1], rates[-1], np.zeros_like(width), energy[:n]
        if some_end:
            # From the standstill back; and for the path with its end where the slope would have it.
            off = np.where(ends, -last / (2.0 * rate), 0.0)
            back = (last * forgot[-1] - TO_REST @ push) / forgot[:n] if self._braked else last - TO_REST @ push
            terms = np.where(ends, LAST_TO_REST @ push, terms)
            inner = np.where(ends, back + 2.0 * rates[:n] * past[:n] * (off / width), inner)
        np.divide(jacobian[:n], np.sqrt(np.maximum(inner, 1e-300)), out=pace[:n])
        took = WEIGHTS @ pace[:n]
        return (
            width, span, last, rate, drive[-1], jacobian[-1], energy.min(axis=0), rates.min(axis=0),
            took * (1.0 + off / width), off, np.abs(LAST @ pace[:n]).sum(axis=0) / took,
            np.abs(terms).sum(axis=0) / np.maximum(s["energy"], np.abs(last)),
        )  # fmt: skip

    def _tried(self) -> Panel:
        """The panels of all lanes."""
        count = len(self._lanes)
        made = np.empty((len(Panel._fields), count))
        for k in range(0, count, _STRIP):
            strip = slice(k, min(k + _STRIP, count))
            for row, value in zip(made, self._try(strip), strict=True):
                row[strip] = value
        return Panel._make(made)

    def _step(self) -> Mask:
        """Try a panel for each lane, and lay the next one; which lanes go on."""
        g, s, p = self._given, self._now, self._tried()
        wish, time, error = s["wish"], s["time"] + p.took, np.maximum(p.tail, p.coarse)
        noise = 1e-13 * (np.abs(s["drive"]) + np.abs(s["rate"]))
        stops = (wish != _END) & (p.lowest <= 0.0)
        peaks = (wish != _PEAK) & (s["rate"] > noise) & (p.slowest < -noise)
        late = (wish != _CUT) & ~stops & (time > g["left"])
        sure = ~(stops | peaks | late) & (error < self._resolved) & ((wish != _END) | (p.rate < 0.0))
        off = self._missed(p, time)
        there = (wish == _ON) | (np.abs(off) <= _CLOSE * p.width)
        done = sure & there & (wish >= _END)
        if np.any(done):
            self._finish(np.flatnonzero(done), p, off, error)
        if np.any(summit := sure & there & (wish == _PEAK)):
            self._pass_summit(np.flatnonzero(summit), p, off)
        new = self._lay_again(p, error, off, sure & ~there, ((_CUT, late), (_END, stops), (_PEAK, peaks)))
        law, on = self._law(self._lanes), sure & there & ~done
        if np.any(on):
            new = self._go_on(new, p, law, on, time, error)
        self._now = s = s | new
        s |= self._ends_within(s, law)
        return np.asarray(~done & (s["x"] < g["furthest"]) & (s["right"] > s["x"]))

    def _missed(self, p: Panel, time: Floats) -> Floats:
        """How much further panels should end that are laid for something."""
        wish, off = self._now["wish"], p.off
        if np.any(at := wish == _PEAK):
            slope = SLOPE @ self._nodes[1, :NODES, : len(wish)]
            off = np.where(at, -p.rate / slope * p.stretch, off)
        if np.any(at := wish == _CUT):
            off = np.where(at, (self._given["left"] - time) * np.sqrt(p.last), off)
        return off

    def _lay_again(
        self, p: Panel, error: Floats, off: Floats, astray: Mask, happen: tuple[tuple[int, Mask], ...]
    ) -> dict[str, Any]:
        """Panels for the lanes where they were too wide, missed their end, or where something happens on the way."""
        g, s = self._given, self._now
        wish, x = s["wish"], s["x"]
        narrower = np.fmax(np.minimum(0.8 * (self._resolved / error) ** (1 / NODES), 0.7), 0.15)
        # If E is resolved and only the time is not, the standstill is near: then beyond it, to find it.
        stop = p.width - 0.52 * p.last / np.minimum(p.rate, -1e-300)
        beyond = (wish == _ON) & np.isnan(s["edge"]) & np.isnan(s["ahead"])
        beyond &= (p.coarse < self._resolved) & (p.rate < 0.0) & (stop < np.minimum(3.0 * p.width, TURN))
        right, following = x + np.where(beyond, stop, p.width * narrower), np.full_like(wish, _ON)
        ahead = np.where(wish == _END, np.where(astray, np.nan, s["right"]), s["ahead"])
        if np.any(near := astray & (np.abs(off) < 0.5 * p.width)):
            right, following = np.where(near, s["right"] + off, right), np.where(near, wish, following)
        energy, rates, pace = self._nodes
        for what, happens in happen:
            if not len(j := np.flatnonzero(happens & (p.coarse < 1e-4))):
                continue
            if what == _CUT:
                values = INTEGRALS @ pace[:NODES, j] - np.broadcast_to(g["left"] - s["time"], x.shape)[j]
            else:
                values = -(energy if what == _END else rates)[:, j]
            z = rises(values)
            z = np.where(wish[j] == _END, z * (2.0 - z), z)
            right[j], following[j] = x[j] + way_of(p.span[j] * z, s["sinh"][j], s["cosh"][j]), what
            ahead[j] = right[j] if what == _END else np.where(wish[j] == _END, _NEVER, ahead[j])
        return {"right": right, "wish": following, "ahead": ahead}

    def _go_on(
        self, new: Mapping[str, Any], p: Panel, law: Friction, on: Mask, time: Floats, error: Floats
    ) -> dict[str, Any]:
        """What follows the panels that are resolved."""
        g, s = self._given, self._now
        x = s["right"]
        slip = np.where(np.isnan(s["edge"]), g["slip"] + g["radius"] * x, s["edge"])
        mu, drive = law.coefficient(slip), p.drive
        anew = on & (np.abs(g["mu"] - mu) > 0.5 * g["mu"])
        if np.any(anew):  # what is left of it has more digits than the difference
            cos, sin = (np.cos(x), np.sin(x)) if self._turns else (1.0, 0.0)
            normal = g["share"] * (g["press"] * cos - g["press_slope"] * sin) - g["water"]
            drive = np.where(anew, g["fall"] * cos - g["fall_slope"] * sin - g["constant"] - mu * normal, drive)
        grown = np.expm1(p.span)
        bent = 0.5 * grown * grown / (1.0 + grown)
        sinh = s["sinh"] + s["cosh"] * grown + (s["sinh"] - s["cosh"]) * bent
        cosh = s["cosh"] + s["sinh"] * grown + (s["cosh"] - s["sinh"]) * bent
        span = np.minimum(p.span * np.minimum(0.9 * (self._resolved / error) ** (1 / NODES), 3.0), _WIDEST)
        ahead = new["ahead"] - x
        near = (ahead > 0.0) & (ahead < np.minimum(way_of(_WIDEST, sinh, cosh), TURN))
        stop = 0.52 * p.last / np.maximum(-p.rate, 1e-300)
        way = way_of(span, sinh, cosh)
        way = np.where(near, ahead, np.where(stop < 2.0 * way, stop, way))
        found = {
            "x": x, "sinh": sinh, "cosh": cosh, "slip": slip, "energy": p.last, "time": time, "drive": drive, "mu": mu,
            "rate": np.where(s["wish"] == _PEAK, 0.0, p.rate), "missing": s["missing"] + error * error * p.took,
            "doubt": s["doubt"] + _doubt(g, s, p), "right": x + way,
            "wish": np.where(near, np.int8(_END), np.int8(_ON)),
        }  # fmt: skip
        return dict(new) | {n: np.where(on, v, new.get(n, s[n])) for n, v in found.items()}

    # -- what is found at their ends

    def _pass_summit(self, j: Indices, p: Panel, off: Floats) -> None:
        """Where the mass is fastest."""
        j = j[p.last[j] > self.top[self._lanes[j]]]
        k, s = self._lanes[j], self._now
        self.top[k] = p.last[j] + p.rate[j] * off[j]
        self.peak[k] = s["right"][j] + off[j]
        self.peak_time[k] = s["time"][j] + p.took[j] + off[j] / np.sqrt(p.last[j])

    def _finish(self, j: Indices, p: Panel, off: Floats, error: Floats) -> None:
        """Lanes that stand still, or whose time is over."""
        k, s, g = self._lanes[j], _some(self._now, j), _some(self._given, j)
        cut = s["wish"] == _CUT
        self.good[k], self.cut[k], self.rate[k], self.end[k] = True, cut, p.rate[j], s["right"] + off[j]
        self.energy[k] = np.where(cut, p.last[j] + 2 * p.rate[j] * off[j], 0.0)
        self.duration[k] = np.where(cut, g["left"], s["time"] + p.took[j])
        p = Panel(*(v[j] for v in p))
        self.missing[k] = (s["missing"] + error[j] ** 2 * p.took) / self.duration[k]
        self.doubt[k] = s["doubt"] + _doubt(g, s, p)
        self.mu[k] = self._law(k).coefficient(g["slip"] + g["radius"] * self.end[k])
        k = k[self.energy[k] > self.top[k]]  # at the end of time
        self.top[k], self.peak[k], self.peak_time[k] = self.energy[k], self.end[k], self.duration[k]
