"""Piecewise functions: earthquake records, tabulated friction laws, and Python functions."""

from slipcircle.tables.forcing import STRONGEST, in_time
from slipcircle.tables.series import LaneSeries, Pulse, Series, bad_sample

__all__ = ["STRONGEST", "LaneSeries", "Pulse", "Series", "bad_sample", "in_time"]
