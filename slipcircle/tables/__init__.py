"""Functions given by pieces: records, friction in pieces or by lists, Python functions."""

from slipcircle.tables.forcing import STRONGEST, in_time
from slipcircle.tables.series import LaneSeries, Pulse, Series, bad_sample

__all__ = ["STRONGEST", "LaneSeries", "Pulse", "Series", "bad_sample", "in_time"]
