"""Consequences of declaring each weight that a moment may have, in a copy of the project.

    python -m tests.campaigns.all_weights [WEIGHT ...] [--keep FOLDER]

adds for each weight (r, r*sin(theta), r*cos(theta), ... r**5*cos(theta); default: all 15) that is not declared one
`Moment` to the copy, runs ``python -m derive`` there, and prints the closed form, the proved bound of each tier, and
the worst error beside quadrature of the double integral, as this machine runs it. The exit status is 1 if more is seen
than proved, or if the best tier is above 1 ulp.
"""

import argparse
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from derive.declare.quantities import MOMENTS

ROOT = Path(__file__).resolve().parents[2]
WEIGHTS = tuple(
    f"{'r' if n == 1 else f'r**{n}'}{turn}" for n in range(1, 6) for turn in ("", "*sin(theta)", "*cos(theta)")
)
DECLARED = {str(moment.weight): moment.kernel[0] for moment in MOMENTS}
# Runs in the copy, where the oracle knows the new moments: worst errors in ulp as compiled, if it is, and in NumPy.
MEASURE = """
import json, sys
import numpy as np
from tests.support import oracle
from flint import ctx
from generated import _compiled, definitions, kernels, tiers
rng = np.random.default_rng(7)
half = np.pi / 2
parts = rng.uniform(0, half, 150), 10 ** rng.uniform(-100, -1, 40), half - 10 ** rng.uniform(-15, 0, 40)
alpha = np.concatenate(parts)
found = {}
for name in sys.argv[1:]:
    exact = [oracle.kernel(name, x) for x in alpha.tolist()]
    seen = {}
    for level in dict.fromkeys([next(iter(_compiled.LEVELS)), "numpy"]):
        call = _compiled.kernel(name, kernels.TEXTS[name], level)
        form = _compiled.LEVELS[level][0]
        for tier, forms in tiers.BOUNDS[name].items():
            relative, ulp = forms.get(form, forms["plain"])
            x = alpha.astype(np.float32) if tier == "float32" else alpha
            values = call(x, where=True, accuracy=relative if tier[0] == "1" else None)
            true = [oracle.kernel(name, float(v)) for v in x] if tier == "float32" else exact
            with ctx.workprec(300):
                errors = [oracle.ulps(float(v), e, kind=values.dtype.type) if ulp else
                          abs(float(oracle.exact(float(v)) / e - 1)) for v, e in zip(values, true)]
            seen[f"{tier}, {form}"] = (max(errors), ulp or relative)
    found[name] = seen
print(json.dumps(found))
"""
DERIVE = """
import sys
from derive.__main__ import main
if main(sys.argv[1:]):
    sys.exit(1)
"""


def kernel(weight: str) -> str:
    """Return the name of a weight's function of alpha."""
    return DECLARED.get(weight) or "kernel_" + re.sub(r"\W+", "_", weight.replace("**", "")).strip("_")


def copy(root: Path) -> None:
    """Return the packages and the oracle."""
    for package in ("derive", "generated", "slipcircle"):
        shutil.copytree(ROOT / package, root / package, ignore=shutil.ignore_patterns("__pycache__"))
    (root / "tests" / "support").mkdir(parents=True)
    for name in ("__init__.py", "support/__init__.py"):
        shutil.copy(ROOT / "tests" / name, root / "tests" / name)
    shutil.copy(ROOT / "tests" / "support" / "oracle.py", root / "tests" / "support")


def declare(root: Path, weights: Sequence[str]) -> None:
    """One `Moment` for each weight at the end of the list."""
    path = root / "derive" / "declare" / "quantities.py"
    lines = path.read_text("utf-8").splitlines(keepends=True)
    start = next(k for k, line in enumerate(lines) if line.startswith("MOMENTS = ("))
    end = next(k for k in range(start, len(lines)) if lines[k].startswith(")"))
    added = []
    for weight in (x for x in weights if x not in DECLARED):
        name, expression = kernel(weight), re.sub(r"\b(sin|cos)\b", r"sp.\1", weight)
        amplitude = f', amplitude=("{name}", "K")' if "theta" in weight else ""
        whole = f"whole_{name}" if amplitude else name
        added.append(f'    Moment("{whole}", "M", {expression}, "moment of the weight {weight}"{amplitude}),\n')
    path.write_text("".join([*lines[:end], *added, *lines[end:]]), "utf-8")


def run(root: Path, *command: str) -> str:
    """Return the output of Python in the copy, which sees no other."""
    done = subprocess.run(
        [sys.executable, *command], cwd=root, env=os.environ | {"PYTHONPATH": str(root)}, capture_output=True, text=True
    )
    if done.returncode:
        raise RuntimeError(done.stderr)
    return done.stdout


def follow(root: Path, weights: Sequence[str], *options: str) -> dict[str, dict[str, tuple[float, float]]]:
    """Declare in a copy, derive, measure: by kernel, tier and form what was seen and what is proved.

    Raises
    ------
    RuntimeError
        If a command fails, with what it said.
    """
    declare(root, weights)
    run(root, "-c", DERIVE, *options)
    found: dict[str, Any] = json.loads(run(root, "-c", MEASURE, *map(kernel, weights)))
    return {name: {tier: (seen, proved) for tier, (seen, proved) in tiers.items()} for name, tiers in found.items()}


def faults(found: dict[str, dict[str, tuple[float, float]]]) -> list[str]:
    """More seen than proved; a best tier above 1 ulp, fused."""
    wrong = []
    for name, tiers in found.items():
        wrong += [f"{name}, {tier}: {s:.3g} is more than {p:.3g}" for tier, (s, p) in tiers.items() if not s <= p]
        wrong += [f"{name}: {p} ulp" for tier, (_, p) in tiers.items() if tier == "best, fused" and p > 1]
    return wrong


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("weights", nargs="*", metavar="WEIGHT", help=f"of {', '.join(WEIGHTS)}; default: all")
    parser.add_argument("--keep", metavar="FOLDER", type=Path, help="leave the copy there")
    options = parser.parse_args()
    weights = options.weights or WEIGHTS
    if wrong := set(weights) - set(WEIGHTS):
        parser.error(f"no weight {', '.join(sorted(wrong))}; there are {', '.join(WEIGHTS)}")
    with tempfile.TemporaryDirectory() as temporary:
        root = options.keep or Path(temporary) / "copy"
        root.mkdir(parents=True, exist_ok=not options.keep)
        copy(root)
        found = follow(root, weights)
        text = (root / "generated" / "definitions.py").read_text("utf-8")
    for weight in weights:
        closed = re.search(rf"'{kernel(weight)}': lambda m, x: (.*),", text)
        print(f"{weight}: {closed[1].replace('m.', '') if closed else '?'}")
        for tier, (seen, proved) in found[kernel(weight)].items():
            print(f"    {tier:<16} proved {proved:<9.3g} worst seen {seen:<9.3g}")
    for fault in faults(found):
        print(fault)
    return 1 if faults(found) else 0


if __name__ == "__main__":
    sys.exit(main())
