"""The section of the Vaiont slide, Table 2-1 of the paper; scene files have it as text."""

import numpy as np

from slipcircle import Arc

RADIUS, UNIT_WEIGHT = 1492.6, 20e3  # m, N/m^3
ENDS_DEG = (215.2, 276.9)
ENDS = float(np.deg2rad(ENDS_DEG[0])), float(np.deg2rad(ENDS_DEG[1]))
FIELDS = {"radius": RADIUS, "theta_1": ENDS[0], "theta_2": ENDS[1], "unit_weight": UNIT_WEIGHT}
ARC = Arc(RADIUS, *ENDS, UNIT_WEIGHT)
