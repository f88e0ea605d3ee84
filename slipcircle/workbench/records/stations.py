"""Stations and components of records from the names of their files."""

import re
from typing import NamedTuple

from slipcircle.workbench.records.columns import is_vertical

# Components at the end of a file's name, as PEER, K-NET, ESM and COSMOS write them: azimuths, axes, channel codes.
_AXIS = "NS|EW|UD|UP|DN|DWN|DOWN|VERT?|VRT|VERTICAL|FN|FP|H1|H2"
_NAMED = re.compile(
    rf"(?P<station>.*?)(?:(?<!\d)(?P<azimuth>[0-2]\d\d|3[0-5]\d|360)|[-_. ](?P<axis>{_AXIS})(?P<level>[12]?)"
    r"|[-_. ](?P<letter>[NEWSVZXYLT]))",
    re.IGNORECASE,
)
_SEED = re.compile(r"(?P<station>.*?)(?:^|[-_. ])[BCEHS][NGHL](?P<channel>[NEZ123])(?P<rest>\..*)?")


class Place(NamedTuple):
    """Station, or the text before the component, and component in the name of a file."""

    station: str
    component: str

    @property
    def is_vertical(self) -> bool:
        """Whether the component is vertical."""
        return is_vertical(self.component)


def place_of(name: str, component: str = "") -> Place:
    """Return station and component from the name of a file without its folder, or from its header or column."""
    stem, dot, suffix = name.rpartition(".")
    is_axis = re.fullmatch(f"(?:{_AXIS})[12]?", suffix, re.IGNORECASE)  # K-NET names components by the suffix
    plain = name if is_axis or not dot else stem
    named = _SEED.fullmatch(plain) or _NAMED.fullmatch(plain)
    if named is None:
        return Place(plain, component)
    parts = {"level": "", "rest": ""} | named.groupdict(default="")
    named_component = next(parts[key] for key in ("azimuth", "axis", "letter", "channel") if parts.get(key))
    station = parts["station"].rstrip("-_. ") + parts["level"] + parts["rest"]
    component = component or named_component.upper()
    return Place(station, component)
