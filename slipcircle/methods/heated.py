"""One phase of motion under undrained-adiabatic thermal pressurisation, in the phase plane.

While friction depends on the slip at most, E and the excess pore pressure p obey a linear system in the rotation x:
E' = 2 (drive + mu lambda p - brake E) and p' = kappa mu (sigma' without p - p), solved by collocation as E alone is.
"""

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from slipcircle.methods.chebyshev import NODES
from slipcircle.methods.phaseplane import (
    AT_HAIRS,
    BACK,
    EPS,
    HAIRS,
    MEAN,
    MOST_PANELS,
    PLACES,
    Course,
    Z,
    energy_on_panels,
    standstill,
)

Floats = NDArray[np.float64]
Energies = tuple[Callable[[Any], Any], Callable[[float], float]]


class Heated(Course):
    """A phase in which friction heats the slip surface; see `slipcircle.methods.phaseplane.Course`.

    ``excess_at`` is the excess pore pressure over sigma_ref at a rotation.
    """

    def driving(self, x: Any) -> Any:
        """The drive at x, with the pressure there."""
        risen = self.excess_at(x) - self.start.excess
        return super().driving(x) + self.friction(x) * self.balance.values["level"] * risen

    def pressing(self, x: Any, energy: Any) -> Any:
        """The effective mean normal stress over sigma_ref."""
        excess = self.excess_at(x)
        return self.balance.get("effective_stress", press=self.press(x), omega_2=energy, excess=excess)

    def resistance(self, x: Any, energy: Any) -> Any:
        """The moment over Theta* of all that opposes the motion."""
        local = {"press": self.press(x), "omega_2": energy, "excess": self.excess_at(x), "mu": self.friction(x)}
        return self.balance.get("resistance", **local) + 0.0 * x

    @property
    def excess(self) -> float:
        """Excess pore pressure over sigma_ref where the phase ends."""
        return float(self.excess_at(self.end if self.change is None else self.change[1]))

    def excess_when(self, t: Floats) -> Floats:
        """Excess pore pressure over sigma_ref at times since the start of the phase."""
        return np.asarray(self.excess_at(self.when(t)[0]))

    def _collocate(self, longest: float) -> tuple[Energies, float, bool]:
        """E and p on panels, until E is zero, or the path ends, or more than the longest time has passed."""
        scale = min(self.law.scale / self.radius, 1.0, self.furthest)
        if self.drive > 0.0:
            scale = min(scale, self.drive)
        elif self.drive < 0.0:  # the way to a standstill
            scale = min(scale, self.start.energy / -self.drive)
        kinks = sorted((k - self.start.slip) / self.radius for k in self.law.kinks if k > self.start.slip)
        start = np.array([self.start.energy, self.start.excess])
        left, width, values, least = 0.0, scale / 16, start, 0.0
        edges, known = [0.0], list[tuple[Floats, Floats]]()
        for _ in range(MOST_PANELS):
            right = min([left + width, self.furthest, *(k for k in kinks if k > left)])
            half = right - left
            slopes, terms, before = self._panel(left, half, values)
            means = slopes @ MEAN.T
            states, series = values[:, None] + half * Z * means, slopes @ BACK.T
            # Also before the first node: what falls within a hair of the start would pass unseen.
            missed = np.abs(series @ AT_HAIRS.T - before).max(axis=1) - 64 * EPS * np.abs(series).sum(axis=1)
            tails = np.abs(series[:, -2:]).sum(axis=1) + np.maximum(missed, 0.0)
            held = states @ BACK.T
            hair = np.abs(values - held @ AT_HAIRS[0]) + np.abs(held[:, -2:]).sum(axis=1)
            missing = np.minimum(tails / terms, (np.maximum(missed, 0.0) * half + hair) / np.maximum(values, 1e-300))
            if np.any(missing > 4e-15) and half > 1e-13 * right:
                width = half / 2
                continue
            self.unresolved = max(self.unresolved, float(missing.max()))
            edges.append(right)
            known.append((values, means @ BACK.T))
            energy, value = states[0], float(values[0])
            ended = energy.min() <= 0.0
            least += half / math.sqrt(max(float(energy.max()), value, 1e-300))
            if not (ended or right >= self.furthest or least > longest or (math.isinf(longest) and right > 1e7)):
                left, values, width = right, states[:, 0], 2 * half
                continue
            found = self._keep(np.array(edges), known)
            if not ended:
                self.panels = np.array(edges)
                return found, right, False
            end = standstill(found[1], left, left + half * Z, energy)
            if left == 0.0 and end < 0.1 * half:  # a series is not relatively accurate next to its panel's start
                width, least, edges, known = max(4 * end, 0.01 * half), 0.0, [0.0], []
                continue
            self.panels = np.array([*edges[:-1], end])
            return found, end, True
        raise ValueError(
            f"friction: changes too sharply for {MOST_PANELS} panels of the energy equation, near a slip of "
            f"{self.start.slip + self.radius * left:.6g} m; give a smoother law"
        )

    def _panel(self, left: float, half: float, values: Floats) -> tuple[Floats, Floats, Floats]:
        """E' and p' at a panel's nodes, the sizes of their terms, and E' and p' before the first node."""
        x = left + half * PLACES
        level, kappa = self.balance.values["level"], self.balance.values["kappa"]
        mu, brake, drive = self.friction(x) + 0.0 * x, self.braking(x), super().driving(x)
        dry = {"press": self.press(x), "excess": 0.0}
        stress, polar = (self.balance.get("effective_stress", **dry, omega_2=0.0), self._dynamic)
        # (E', p') = right - matrix (E, p), at all places.
        right = np.array([2 * (drive - mu * level * self.start.excess), kappa * mu * stress])
        matrix = np.array([[2 * brake, -2 * mu * level], [-kappa * mu * polar, kappa * mu]])
        known = right - np.einsum("ijx,j->ix", matrix, values)
        gain = half * Z[:, None] * MEAN
        system = np.block([[matrix[i, j, :NODES, None] * gain for j in (0, 1)] for i in (0, 1)])
        system[np.diag_indices(2 * NODES)] += 1.0
        slopes = np.linalg.solve(system, known[:, :NODES].ravel()).reshape(2, NODES)
        hairs = values[:, None] + half * HAIRS * (slopes @ MEAN.T @ BACK.T @ AT_HAIRS.T)
        before = right[:, NODES:] - np.einsum("ijx,jx->ix", matrix[:, :, NODES:], hairs)
        terms = np.maximum(np.abs(slopes).max(axis=1), [2 * np.abs(drive).max(), np.abs(kappa * mu * stress).max()])
        return slopes, np.maximum(terms, 1e-300), before

    @property
    def _dynamic(self) -> float:
        """What E adds to the effective stress."""
        still = {"press": 0.0, "excess": 0.0}
        get = self.balance.get
        return float(get("effective_stress", **still, omega_2=1.0) - get("effective_stress", **still, omega_2=0.0))

    def _keep(self, edges: Floats, known: list[tuple[Floats, Floats]]) -> Energies:
        """E and p as functions, from their values at the panels' left edges and the series of their mean slopes."""
        energy, excess = (
            energy_on_panels(edges, np.array([v[i] for v, _ in known]), np.array([m[i] for _, m in known]).T)
            for i in (0, 1)
        )
        self.breaks, self.excess_at = edges[1:-1].tolist(), excess[0]
        return energy
