"""Location of scene files: scenes that ship by name, others by path."""

import os
from difflib import get_close_matches
from importlib import resources
from os import PathLike
from pathlib import Path
from typing import Any

from slipcircle.base.kinds import Names, PathName

_FOLDER = resources.files("slipcircle") / "scenes"


def shipped() -> Names:
    """Return the names of the scenes that ship with the package, sorted."""
    return tuple(sorted(f.name.removesuffix(".toml") for f in _FOLDER.iterdir() if f.name.endswith(".toml")))


def find(name: PathName) -> Any:
    """Return the file of a scene that ships, by its name, or of another scene, by its path."""
    if not isinstance(name, str | PathLike):
        raise ValueError(f"scene {name!r}: must be the name of a scene that ships, or the path of a scene file")
    if name in (names := shipped()):
        return _FOLDER / f"{name}.toml"
    path = Path(name)
    for candidate in (path, Path(f"{name}.toml")):
        if os.path.exists(candidate) and not os.path.isdir(candidate):  # without an error for invalid file names
            return candidate
    if str(name) and os.path.isdir(path):
        raise ValueError(f"{path}: is a folder; give a scene's file")
    near = get_close_matches(path.stem, [*names, *(file.stem for file in path.parent.glob("*.toml"))], 1)
    is_path = path.suffix == ".toml" or len(path.parts) > 1 or not isinstance(name, str)
    unknown = f"scene {str(name)!r} is unknown; known are {', '.join(names)}"
    said = f"{path}: there is no such file" if is_path else unknown
    raise ValueError(said + "".join(f"; did you mean {n}?" for n in near))
