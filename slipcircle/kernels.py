"""Kernels of a circular arc under a unique name, since another package on the path may be called `generated`."""

from generated import *  # noqa: F403
from generated import __all__ as __all__
