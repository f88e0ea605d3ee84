"""Scenes that ship, by name. Values that are not the paper's carry their source, or the word "assumed"."""

from collections.abc import Callable

import numpy as np

from slipcircle.arc import Arc
from slipcircle.scene import Scene

# Table 2-1: the simplified Section 5 of the Vaiont slide.
_VAIONT = {"radius": 1492.6, "theta_1": np.deg2rad(215.2), "theta_2": np.deg2rad(276.9), "unit_weight": 20e3}
# Table 4-1. Theta* and A belong to twice the angle, J_theta is another integral: see `python -m derive verify`.
_TABLE_4_1 = {
    "moment_of_inertia": 0.4376,
    "radial_weight": 0.0870,
    "weight_moment": 0.0387,
    "resistance_factor": 0.1523,
    "dynamic_coefficient": 0.468,
}
_RESIDUAL = float(np.tan(np.deg2rad(10.0)))  # residual friction angle of section 4
_SECONDS = 30.0  # how far the paper plots the motion


def vaiont_as_printed() -> Scene:
    """The paper's example with the coefficients that its Table 4-1 prints."""
    return Scene(
        Arc(**_VAIONT, given=_TABLE_4_1), _RESIDUAL, ("centripetal",), end_time=_SECONDS, name="vaiont-as-printed",
        note="section 4 of the paper, with the coefficients of its Table 4-1",
    )  # fmt: skip


def vaiont_frozen() -> Scene:
    """The paper's example and assumptions (frozen geometry), with coefficients from its own definitions."""
    return Scene(
        Arc(**_VAIONT), _RESIDUAL, ("centripetal",), end_time=_SECONDS, name="vaiont-frozen",
        note="section 4 of the paper, with coefficients from its definitions",
    )  # fmt: skip


SCENES: dict[str, Callable[[], Scene]] = {"vaiont-as-printed": vaiont_as_printed, "vaiont-frozen": vaiont_frozen}
