"""At install time: binaries of kernels and integrator if they can be compiled, otherwise a pure Python wheel."""

import sys
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface


class KernelsHook(BuildHookInterface[Any]):
    """Called by Hatchling for wheels; an editable install uses the binary in place."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Compile, and mark the wheel as one for this platform."""
        sys.path.insert(0, self.root)
        from derive.build import PARTS, NoBinaryError, build

        for name in PARTS:
            try:
                binary = build(Path(self.root) / "generated", name=name)
            except (NoBinaryError, OSError) as error:
                self.app.display_warning(f"no compiled {name[1:]}, NumPy serves: {error}")
                continue
            if version != "editable":
                build_data["force_include"][str(binary)] = f"generated/{binary.name}"
                build_data["pure_python"], build_data["infer_tag"] = False, True
