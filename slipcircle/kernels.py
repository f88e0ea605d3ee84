"""The kernels of a circular arc by the project's own name: `generated` is a name that others may have on a path too."""

from generated import *  # noqa: F403
from generated import __all__ as __all__
