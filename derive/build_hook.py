"""Build hook: binaries of kernels and integrator if they can be compiled, otherwise a pure Python wheel."""

import os
import sys
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface


class KernelsHook(BuildHookInterface[Any]):
    """Hook called by Hatchling for wheels. An editable install uses the binaries in place."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Compile the modules, and mark the wheel as specific to this platform.

        ``SLIPCIRCLE_BINARIES`` is a folder of binaries that are there already, by the name of their platform: they
        stand in place of their C text, which `python -m derive` writes again.
        """
        made = os.environ.get("SLIPCIRCLE_BINARIES")
        binaries = sorted(Path(made).iterdir()) if made else self._compiled()
        if version == "editable" or not binaries:
            return
        build_data["force_include"] |= {str(binary): f"generated/{binary.name}" for binary in binaries}
        build_data["pure_python"], build_data["infer_tag"] = False, not made
        if made:
            build_data["tag"] = f"cp311-abi3-{Path(made).name}"
            self.build_config.target_config["exclude"].append("generated/*.c")

    def _compiled(self) -> list[Path]:
        """Return the available binaries of this Python on this machine."""
        sys.path.insert(0, self.root)
        from derive.build import MODULES, build_all

        binaries, outcome = build_all(Path(self.root) / "generated")
        if len(binaries) < len(MODULES):
            self.app.display_warning(outcome)
        return binaries
