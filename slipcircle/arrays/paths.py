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
from numpy.polynomial import legendre
from numpy.typing import NDArray

from slipcircle.friction import Friction

Floats = NDArray[np.float64]
Mask = NDArray[np.bool_]
Indices = NDArray[np.intp]

NODES = 16
_ON, _PEAK, _END, _CUT = range(4)  # what a panel is laid for: the way on, the greatest speed, standstill, end of time
_NEVER = -1.0  # a standstill that is not reached in time
_CLOSE = 1e-7  # of a panel's width: so far off may its end be, which the slopes there mend to the square
_MOST = 100  # panels tried for a lane
_FIRST, _WIDEST = 2.2, 3.0  # widths of panels, in the variable of `_span`
_TURN = 1.0  # that a panel may make, rad
_STRIP = 512  # lanes whose nodes stay in the cache together

_Z, _WEIGHTS = ((x + shift) / 2 for x, shift in zip(legendre.leggauss(NODES), (1.0, 0.0), strict=True))
_SERIES = np.linalg.inv(legendre.legvander(2 * _Z - 1, NODES - 1))
_LAST = _SERIES[-2:].copy()
_LAST_FROM_REST, _LAST_TO_REST = _LAST / _Z, _LAST / (1.0 - _Z)  # see `_integrals`
_SLOPE = np.array([2 * legendre.legval(1.0, legendre.legder(row)) for row in _SERIES.T])  # at the end
_BARYCENTRIC = (1.0 / np.array([np.prod(np.delete(z - _Z, k)) for k, z in enumerate(_Z)]))[:, None]


def _integrals(weight: Callable[[Floats], Floats]) -> Floats:
    """Values at the nodes -> integrals from 0 to each node and to 1; what is left without a weight is interpolated."""
    ends = np.append(_Z, 1.0)
    places = ends[:, None] * _Z
    inside = weight(places)[:, :, None] * (legendre.legvander(2 * places - 1, NODES - 1) @ _SERIES) / weight(_Z)
    return np.asarray(np.einsum("e,egn,g->en", ends, inside, _WEIGHTS))


_INTEGRALS = _integrals(np.ones_like)
_FROM_REST = _integrals(lambda z: z)  # of what falls to zero where the mass starts from rest
_TO_REST = _FROM_REST[:NODES][::-1, ::-1].copy()  # from each node to 1, where it comes to rest

# How far along a panel the nodes and the end lie, and the rate of that; the second column where the mass stands still
# at the end: there the time is smooth in the root of the distance.
_PLACES = np.append(_Z, 1.0)[:, None]
_SHARES = np.hstack([_PLACES, _PLACES * (2.0 - _PLACES)])
_RATES = np.hstack([np.ones_like(_PLACES), 2.0 * (1.0 - _PLACES)])


def _way(span: Any, sinh: Any, cosh: Any) -> Any:
    """How far x moves over a span of its variable, a hyperbolic angle: as from rest under a drive that grows with x.

    x = pace (cosh - 1) from rest, x = pace (exp - 1) in motion: both are smooth where E, or what friction lost, first
    grows in proportion to x and then with a power of it.
    """
    grown = np.expm1(span)
    return sinh * grown + (cosh - sinh) * (0.5 * grown * grown / (1.0 + grown))


def _span(way: Any, sinh: Any, cosh: Any) -> Any:
    """The inverse of `_way`."""
    root = np.sqrt(sinh * sinh + way * way + 2 * way * cosh)
    return np.log1p(np.where(way > sinh, (way - sinh + root) / (cosh + sinh), 2 * way / (sinh - way + root)))


def _turned(angle: Floats) -> tuple[Floats, Floats]:
    """sin and 1 - cos of angles up to `_TURN`, by the series of the half angle's sine."""
    square = 0.25 * angle * angle
    s = square * (-1.0 / math.factorial(15))
    for k in range(13, 0, -2):
        s += (1.0 if k % 4 == 1 else -1.0) / math.factorial(k)
        s *= square if k > 1 else 0.5 * angle
    lift = 2.0 * s * s
    s *= 2.0
    return s * np.sqrt(1.0 - 0.5 * lift), lift


def _some(values: Mapping[str, Any], k: Any) -> dict[str, Any]:
    return {n: v[k] if np.ndim(v) else v for n, v in values.items()}


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
        self._resolved = min(max(math.sqrt(0.01 * accuracy), 3e-8), 3e-6)
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
            "mu": g["mu"], "rate": drive - brake * start, "right": _way(_FIRST, sinh, pace), "ahead": np.nan,
            "edge": np.nan, "missing": 0.0, "doubt": 0.0,
        }  # fmt: skip
        s: dict[str, Any] = {n: np.array(np.broadcast_to(v, start.shape)) for n, v in begin.items()}
        return s | {"wish": np.full(start.shape, _ON, np.int8)} | self._ends_within(s, s["right"], law)

    def _ends_within(self, s: Mapping[str, Any], right: Floats, law: Friction) -> dict[str, Floats]:
        """Ends of panels, at the law's next kink at the latest, and where the path ends; and the slip at a kink."""
        g, kink = self._given, np.full(right.shape, np.inf)
        right = np.minimum(right, np.minimum(g["furthest"], s["x"] + _TURN) if self._turns else g["furthest"])
        for k in law.kinks:
            kink = np.where((k > s["slip"]) & (k < kink), k, kink)
        place = (kink - g["slip"]) / g["radius"]
        beyond = place <= right
        return {"right": np.where(beyond, place, right), "edge": np.where(beyond, kink, np.nan)}

    # -- panels

    def _try(self, k: slice) -> tuple[Floats, ...]:
        """Integrate along the panels of some lanes."""
        g, s, n = _some(self._given, k), _some(self._now, k), NODES
        ends = s["wish"] == _END
        some_end = bool(np.any(ends))
        share, stretch = (t[:, ends.view(np.int8)] if some_end else t[:, :1] for t in (_SHARES, _RATES))
        width, sinh, cosh = s["right"] - s["x"], s["sinh"], s["cosh"]
        span = _span(width, sinh, cosh)
        grown = np.expm1(span * share)
        bent = grown * grown
        bent /= grown + 1.0
        bent *= 0.5  # cosh - 1, as in `_way`
        past = sinh * grown + (cosh - sinh) * bent
        jacobian = (sinh + cosh * grown + (sinh - cosh) * bent) * (span * stretch)
        fallen = self._law(self._lanes[k]).drop(s["slip"], g["radius"] * past)
        drive = s["drive"]
        if self._turns:
            cos, sin = np.cos(s["x"]), np.sin(s["x"])
            pressed = g["share"] * (g["press"] * cos - g["press_slope"] * sin)
            tilted = g["share"] * (g["press_slope"] * cos + g["press"] * sin)
            tilt = g["fall_slope"] * cos + g["fall"] * sin - s["mu"] * tilted
            sine, lift = _turned(past)
            normal = (pressed - g["water"]) - pressed * lift - tilted * sine
            drive = drive - (drive + (g["constant"] - s["mu"] * g["water"])) * lift - tilt * sine + fallen * normal
        else:
            drive = drive + fallen * (g["share"] * g["press"] - g["water"])
        energy, rates, pace = (a[:, k] for a in self._nodes)
        push = 2.0 * drive[:n] * jacobian[:n]
        if self._braked:
            brake = g["brake"] + g["brake_rise"] * (s["mu"] - fallen)
            forgot = np.exp(_INTEGRALS @ (2.0 * brake[:n] * jacobian[:n]))
            push *= forgot[:n]
        gained, terms = _INTEGRALS @ push, _LAST @ push
        if np.any(rests := (s["x"] == 0.0) & (g["start"] == 0.0)):
            gained, terms = np.where(rests, _FROM_REST @ push, gained), np.where(rests, _LAST_FROM_REST @ push, terms)
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
            back = (last * forgot[-1] - _TO_REST @ push) / forgot[:n] if self._braked else last - _TO_REST @ push
            terms = np.where(ends, _LAST_TO_REST @ push, terms)
            inner = np.where(ends, back + 2.0 * rates[:n] * past[:n] * (off / width), inner)
        np.divide(jacobian[:n], np.sqrt(np.maximum(inner, 1e-300)), out=pace[:n])
        took = _WEIGHTS @ pace[:n]
        return (
            width, span, last, rate, drive[-1], jacobian[-1], energy.min(axis=0), rates.min(axis=0),
            took * (1.0 + off / width), off, np.abs(_LAST @ pace[:n]).sum(axis=0) / took,
            np.abs(terms).sum(axis=0) / np.maximum(s["energy"], np.abs(last)),
        )  # fmt: skip

    def _step(self) -> Mask:
        """Try a panel for each lane, and lay the next one; which lanes go on."""
        g, s, count = self._given, self._now, len(self._lanes)
        made = np.empty((len(Panel._fields), count))
        for k in range(0, count, _STRIP):
            strip = slice(k, min(k + _STRIP, count))
            for row, value in zip(made, self._try(strip), strict=True):
                row[strip] = value
        p = Panel._make(made)
        wish, time, error = s["wish"], s["time"] + p.took, np.maximum(p.tail, p.coarse)
        noise = 1e-13 * (np.abs(s["drive"]) + np.abs(s["rate"]))
        stops = (wish != _END) & (p.lowest <= 0.0)
        peaks = (wish != _PEAK) & (s["rate"] > noise) & (p.slowest < -noise)
        late = (wish != _CUT) & ~stops & (time > g["left"])
        happens = stops | peaks | late
        sure = ~happens & (error < self._resolved)

        # whether it ends where it should
        off, aimed = p.off, wish != _ON
        if np.any(at := wish == _PEAK):
            off = np.where(at, -p.rate / (_SLOPE @ self._nodes[1, :NODES, :count]) * p.stretch, off)
        if np.any(at := wish == _CUT):
            off = np.where(at, (g["left"] - time) * np.sqrt(p.last), off)
        there = ~aimed | (np.abs(off) <= _CLOSE * p.width)
        astray, reached = sure & ~there, sure & there
        done = reached & (wish >= _END)
        if np.any(done):
            self._finish(np.flatnonzero(done), p, off, error)
        if np.any(summit := reached & (wish == _PEAK)):
            self._pass_summit(np.flatnonzero(summit), p, off)
        on = reached & ~done

        # not resolved: narrower; or, if only the time is not, as the standstill is near, beyond it
        narrower = np.fmax(np.minimum(0.8 * (self._resolved / error) ** (1 / NODES), 0.7), 0.15)
        stop = p.width - 0.52 * p.last / np.minimum(p.rate, -1e-300)
        beyond = (wish == _ON) & np.isnan(s["edge"]) & np.isnan(s["ahead"])
        beyond &= (p.coarse < self._resolved) & (p.rate < 0.0) & (stop < np.minimum(3.0 * p.width, _TURN))
        right, following = s["x"] + np.where(beyond, stop, p.width * narrower), np.full_like(wish, _ON)
        ahead = np.where(wish == _END, np.where(astray, np.nan, s["right"]), s["ahead"])
        if np.any(astray):
            near = astray & (np.abs(off) < 0.5 * p.width)
            right, following = np.where(near, s["right"] + off, right), np.where(near, wish, following)
        energy, rates, pace = self._nodes
        for what, happened in ((_CUT, late), (_END, stops), (_PEAK, peaks)):
            if len(j := np.flatnonzero(happened & (p.coarse < 1e-4))):
                if what == _CUT:
                    values = _INTEGRALS @ pace[:NODES, j] - (np.broadcast_to(g["left"], (count,)) - s["time"])[j]
                else:
                    values = -(energy if what == _END else rates)[:, j]
                right[j], following[j] = s["x"][j] + self._aim(values, p.span[j], _some(s, j)), what
                ahead[j] = right[j] if what == _END else np.where(wish[j] == _END, _NEVER, ahead[j])
        new = {"right": right, "wish": following, "ahead": ahead}
        law = self._law(self._lanes)
        if np.any(on):
            new = self._go_on(new, p, law, on, time, error)
        self._now = s = s | new
        s |= self._ends_within(s, s["right"], law)
        return np.asarray(~done & (s["x"] < g["furthest"]) & (s["right"] > s["x"]))

    def _aim(self, values: Floats, span: Floats, s: Mapping[str, Any]) -> Floats:
        """How far along a panel a function first rises above zero, from its values at the nodes and at the end."""
        first, edges = np.argmax(values > 0.0, axis=0), np.concatenate([[0.0], _Z, [1.0]])
        low, high, inside = edges[first], edges[first + 1], values[:NODES]
        z = 0.5 * (low + high)
        for _ in range(6):  # Newton's method, on the interpolation
            share = _BARYCENTRIC / (z - _Z[:, None])
            whole = share.sum(axis=0)
            value = (share * inside).sum(axis=0) / whole
            slope = (share * (value - inside) / (z - _Z[:, None])).sum(axis=0) / whole
            low, high = np.where(value > 0.0, low, z), np.where(value > 0.0, z, high)
            z = z - value / slope
            z = np.where((z >= low) & (z <= high), z, 0.5 * (low + high))
        return np.asarray(_way(span * np.where(s["wish"] == _END, z * (2.0 - z), z), s["sinh"], s["cosh"]))

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
        near = (ahead > 0.0) & (ahead < np.minimum(_way(_WIDEST, sinh, cosh), _TURN))
        stop = 0.52 * p.last / np.maximum(-p.rate, 1e-300)
        way = _way(span, sinh, cosh)
        way = np.where(near, ahead, np.where(stop < 2.0 * way, stop, way))
        found = {
            "x": x, "sinh": sinh, "cosh": cosh, "slip": slip, "energy": p.last, "time": time, "drive": drive, "mu": mu,
            "rate": np.where(s["wish"] == _PEAK, 0.0, p.rate), "missing": s["missing"] + error * error * p.took,
            "doubt": s["doubt"] + _doubt(g, s, p), "right": x + way, "wish": np.where(near, np.int8(_END), np.int8(_ON)),
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
