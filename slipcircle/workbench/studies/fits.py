"""Back-analysis of several numbers: least squares by Levenberg and Marquardt's method, from many starts at once."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from slipcircle.workbench.studies.problem import Floats, SearchProblem

_STARTS, _APART = 48, 0.03  # of fits, and shares of the ranges between them
_STEPS, _LONGEST = 80, 0.25  # of a fit, and share of a range that one may take


class Fit(NamedTuple):
    """Where the observations are best met: shares of the ranges, sum of squares, whether no step makes it smaller."""

    shares: Floats
    chi_square: float
    is_settled: bool


def fits(problem: SearchProblem, shares: Floats) -> list[Fit]:
    """All different minima that are reached from the best of these shares, (fields, count), the best first."""
    starts = _starts(problem, shares)
    if not starts.size:
        return []
    shares, r, jacobian = levenberg_marquardt(problem, starts)
    is_settled = _is_settled(shares, r, jacobian)
    chi_square = np.sum(r**2, axis=0)
    same_below = 1.0 if problem.is_weighted else 1e-3  # change of the residuals, in standard errors or shares
    found: list[Fit] = []
    for k in np.argsort(chi_square):
        steps = [shares[:, k] - other.shares for other in found]
        if not any(np.max(np.abs(s)) < 1e-5 or np.max(np.abs(jacobian[:, :, k] @ s)) < same_below for s in steps):
            found.append(Fit(shares[:, k], float(chi_square[k]), bool(is_settled[k])))
    return [fit for fit in found if fit.is_settled] or found


def _starts(problem: SearchProblem, shares: Floats) -> Floats:
    """The best points of those, apart from each other."""
    r = problem.residuals(shares)
    chosen = list[int]()
    for k in np.argsort(np.sum(r**2, axis=0)):  # NaN comes last
        if len(chosen) == _STARTS or np.isnan(r[0, k]):
            break
        if all(np.max(np.abs(shares[:, k] - shares[:, other])) > _APART for other in chosen):
            chosen.append(int(k))
    return shares[:, chosen]


def levenberg_marquardt(problem: SearchProblem, shares: Floats) -> tuple[Floats, Floats, Floats]:
    """Shares of the ranges, residuals and Jacobian at the minima that starts, (fields, count), lead to."""
    damping = np.full(shares.shape[1], 1e-3)
    r, jacobian = problem.linearised(shares)
    for _ in range(_STEPS):
        step = _damped_step(shares, r, jacobian, damping)
        trial = np.clip(shares + np.clip(step, -_LONGEST, _LONGEST), 0.0, 1.0)
        trial_r, trial_jacobian = problem.linearised(trial)
        is_better = np.sum(trial_r**2, axis=0) < np.sum(r**2, axis=0)  # not where nothing moves
        shares, r = np.where(is_better, trial, shares), np.where(is_better, trial_r, r)
        jacobian = np.where(is_better, trial_jacobian, jacobian)
        damping = np.clip(np.where(is_better, damping / 8, damping * 4), 1e-15, 1e12)
        if np.all(~is_better & (damping > 1e8)) or np.max(np.abs(step)) < 1e-14:
            break
    return shares, r, jacobian


def _damped_step(shares: Floats, r: Floats, jacobian: Floats, damping: Floats) -> Floats:
    """The step of each start, from (J'J + damping diag J'J) step = -J'r; a field at the end of its range is held."""
    normal = np.einsum("ofn,ogn->nfg", jacobian, jacobian)
    downhill = -np.einsum("ofn,on->nf", jacobian, r)
    held = _is_held(shares.T, downhill)
    damped = np.einsum("nff->nf", normal) * (1.0 + damping[:, None]) + 1e-30
    normal[held[:, :, None] | held[:, None, :]] = 0.0
    np.einsum("nff->nf", normal)[...] = np.where(held, 1.0, damped)
    return np.linalg.solve(normal, np.where(held, 0.0, downhill)[..., None])[..., 0].T


def _is_held(shares: Floats, downhill: Floats) -> NDArray[np.bool_]:
    """Whether a field is at an end of its range, and downhill lies beyond."""
    return ((shares <= 0.0) & (downhill < 0.0)) | ((shares >= 1.0) & (downhill > 0.0))


def _is_settled(shares: Floats, r: Floats, jacobian: Floats) -> NDArray[np.bool_]:
    """Whether no residuals are left, or they are normal to what changes with each field that is not held."""
    lengths = np.linalg.norm(jacobian, axis=0) * np.linalg.norm(r, axis=0)
    cosine = -np.einsum("ofn,on->fn", jacobian, r) / np.where(lengths > 0.0, lengths, 1.0)
    is_flat = (np.abs(cosine) < 1e-3) | _is_held(shares, cosine)
    return np.all(is_flat, axis=0) | (np.linalg.norm(r, axis=0) < 1e-7)
