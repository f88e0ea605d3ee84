"""What the command line shows of motions, plans and ladders: records for machines, tables for people."""

import math
from collections.abc import Iterable, Sequence
from dataclasses import asdict
from itertools import combinations
from typing import TYPE_CHECKING, Any

import numpy as np

from generated.effects import COMBINATIONS
from slipcircle.motion.motion import Motion
from slipcircle.motion.plan import Plan
from slipcircle.scene.friction import friction
from slipcircle.studies.ladder import Rung

if TYPE_CHECKING:
    from slipcircle.sensitivity import Sensitivity
    from slipcircle.studies.backanalysis import BackAnalysis


def motion_record(motion: Motion) -> dict[str, Any]:
    """A motion as JSON holds it: SI units, radians, full precision.

    null for a factor of safety without a drive, and for a limit friction where nothing presses.
    """
    scene, law = motion.plan.scene, friction(motion.plan.scene.friction)
    safety = motion.factor_of_safety
    return {
        "scene": scene.name,
        "note": scene.note,
        "effects": list(motion.plan.effects),
        "left_out": list(motion.plan.left_out),
        "method": motion.plan.method,
        "friction": float(law.coefficient(0.0)) if law.constant else {"law": law.law} | dict(law.parameters),
        "limit_friction": motion.limit_friction if np.isfinite(motion.limit_friction) else None,
        "factor_of_safety": safety if np.isfinite(safety) else None,
        "yield_coefficient": motion.yield_coefficient,
        "dimensionless": {k: float(v) for k, v in asdict(scene.arc.dimensionless).items()},
        "moves": motion.moves,
        "arrested": motion.arrested,
        "duration": motion.duration,
        "run_out": motion.run_out,
        "peak": {k: float(v) for k, v in asdict(motion.peak).items()},
        "end": {k: float(v) for k, v in asdict(motion.end).items()},
        "energy": {k: float(v) for k, v in asdict(motion.energy).items()} | {"residual": float(motion.energy.residual)},
        "error_estimate": motion.error_estimate,
        "warnings": list(motion.warnings),
    }


def motion_column(motion: Motion, alike: bool) -> list[tuple[str, str]]:
    """The table of one motion: label and value of each row; labels name times if all motions last alike."""
    arc, law = motion.plan.scene.arc, friction(motion.plan.scene.friction)
    d, mu = arc.dimensionless, float(law.coefficient(0.0))
    shared = [
        ("Theta*", f"{d.moment_of_inertia:.5f}"), ("J_r", f"{d.radial_weight:.5f}"),
        ("J_theta", f"{d.weight_moment:.5f}"), ("lambda", f"{d.resistance_factor:.5f}"),
        ("A", f"{d.dynamic_coefficient:.5f}"),
        ("method", motion.plan.method + ("" if "rotation" in motion.plan.effects else ", frozen geometry")),
        ("effects", ", ".join(motion.plan.effects) or "none"),
        ("left out", ", ".join(motion.plan.left_out) or "none"),
        ("friction angle", f"{np.degrees(np.arctan(mu)):.2f} deg" + ("" if law.constant else f" at first, {law.law}")),
        ("limit friction angle", f"{np.degrees(np.arctan(motion.limit_friction)):.2f} deg"),
        ("factor of safety", f"{motion.factor_of_safety:.4f}"),
        ("yield coefficient k_y", f"{motion.yield_coefficient:.4f}"),
        ("normal stress at start", f"{arc.static_normal_stress / 1e6:.3f} MPa"),
        ("moves", "yes" if motion.moves else "no"),
        ("duration", f"{motion.duration:.2f} s"),
    ]  # fmt: skip
    times = {"1/3": 1 / 3 * motion.duration, "2/3": 2 / 3 * motion.duration}
    states = [(f"after {t:.4g} s" if alike else f"after {part}", motion.at(t)) for part, t in times.items()]
    for label, state in [*states, ("at the end", motion.end)]:
        shared += [
            (f"velocity {label}", f"{state.velocity:.2f} m/s"),
            (f"displacement {label}", f"{state.displacement:.1f} m"),
            (f"rotation {label}", f"{np.degrees(state.rotation):.2f} deg"),
        ]
    return [
        *shared,
        ("peak velocity", f"{motion.peak.velocity:.2f} m/s"),
        ("comes to rest", "yes" if motion.arrested else "no, still moving at the end"),
        ("estimated error", f"{motion.error_estimate:.1e}"),
    ]


def backanalysis_record(found: "BackAnalysis") -> dict[str, Any]:
    """A back-analysis as JSON holds it: null for what is not known; matrices by fields in their order."""
    from slipcircle.studies.backanalysis import angle_deg

    return {
        "scene": found.motion.plan.scene.name,
        "fields": [{"name": name, "unit": unit} for name, unit in found.units.items()],
        "method": found.method,
        "observed": {n: {"value": value, "standard_error": sigma} for n, (value, sigma) in found.observed.items()},
        "degrees_of_freedom": found.degrees_of_freedom,
        "solutions": [
            {
                "values": s.values,
                "friction_angles_deg": {n: d for n, v in s.values.items() if (d := angle_deg(n, v)) is not None},
                "standard_errors": s.standard_errors,
                "covariance": None if s.covariance is None else s.covariance.tolist(),
                "correlation": None if s.correlation is None else s.correlation.tolist(),
                "error_estimate": s.error_estimate if np.isfinite(s.error_estimate) else None,
                "chi_square": s.chi_square,
                "residuals": s.residuals,
                "motion": motion_record(s.motion),
            }
            for s in found.solutions
        ],
        "warnings": list(found.warnings),
    }


def backanalysis_rows(found: "BackAnalysis") -> list[list[str]]:
    """A back-analysis as rows of a table, a column for each solution."""
    from slipcircle.studies.backanalysis import FITTED, UNITS, angle_deg
    from slipcircle.studies.fields import OBSERVED, outputs_of

    columns = []
    for s in found.solutions:
        rows, errors = {}, s.standard_errors or {}
        for name, value in s.values.items():
            unit, error = found.units[name], errors.get(name, 0.0)
            rows[f"{name} ({unit})" if unit else name] = _with_error(value, error, ".8g")
            if (degrees := angle_deg(name, value)) is not None:
                angle = _with_error(degrees, np.degrees(error / (1 + value**2)), ".4f")
                rows["friction angle" if name == "friction" else f"{name}, angle"] = f"{angle} deg"
            elif unit == "rad":
                rows[f"{name} (deg)"] = _with_error(np.degrees(value), np.degrees(error), ".4f")
        if s.correlation is not None:
            names = list(s.values)
            for i, j in combinations(range(len(names)), 2):
                rows[f"correlation of {names[i]} and {names[j]}"] = f"{s.correlation[i, j]:+.3f}"
        for name, value in outputs_of(s.motion, OBSERVED.values()).items():
            kind = next(k for k, output in OBSERVED.items() if output == name)
            seen, sigma = found.observed.get(kind, (None, None))
            of = "" if seen is None else f" (observed {seen:.6g}" + (f" +- {sigma:.2g})" if sigma else ")")
            rows[words(name, UNITS[kind])] = f"{value:.6g}{of}"
        if found.method == FITTED:
            known = all(sigma for _, sigma in found.observed.values())
            free = found.degrees_of_freedom
            rows[f"chi-square, degrees of freedom {free}" if known else "misfit"] = f"{s.chi_square:.3g}"
        columns.append(rows | {"swings": f"{len(s.motion.phases) - 1}", "numerical error": f"{s.error_estimate:.1e}"})
    return [[label, *(c.get(label, "") for c in columns)] for label in columns[0]]


def _with_error(value: float, error: float, form: str) -> str:
    """A number with its standard error, to two digits of that; in its own form where there is none."""
    if not error > 0.0:
        return f"{value:{form}}"
    form = decimals(error)
    return f"{value:{form}} +- {error:{form}}"


def decimals(error: float) -> str:
    """The form of numbers that are known up to an error: two digits of that."""
    return f".{min(max(1 - math.floor(math.log10(error)), 0), 12)}f"


def words(name: str, unit: str = "") -> str:
    """An output or a status as tables have it."""
    return name.lower().replace("run_out", "run-out").replace("_", " ") + (f" ({unit})" if unit else "")


def sensitivity_record(found: "Sensitivity") -> dict[str, Any]:
    """Derivatives as JSON holds them: SI units and radians, null for an elasticity of what is zero."""
    columns = zip(found.parameters.items(), found.values.T.tolist(), found.elasticities.T.tolist(), strict=True)
    return {
        "outputs": [{"name": n, "unit": unit, "value": found.at[n]} for n, unit in found.outputs.items()],
        "parameters": [
            {
                "name": name,
                "unit": unit,
                "value": found.at[name],
                "derivatives": dict(zip(found.outputs, slopes, strict=True)),
                "elasticities": {n: e if np.isfinite(e) else None for n, e in zip(found.outputs, per, strict=True)},
            }
            for (name, unit), slopes, per in columns
        ],
    }


def sensitivity_rows(found: "Sensitivity") -> list[list[str]]:
    """Derivatives as rows of a table, per unit of the key that a scene file has for each parameter."""
    from slipcircle.base.distributions import keys_of

    rows = []
    for k, name in enumerate(found.parameters):
        of = keys_of()[name]
        value = of.from_si(found.at[name])
        cells = []
        for output, slope in zip(found.outputs, found.values[:, k] * of.slope(value), strict=True):
            at = found.at[output]
            per_cent = f" ({slope * value / at:+.2g})" if at and slope * value else ""
            cells.append(f"{slope + 0.0:.4g}{per_cent}")
        rows.append([of.key, f"{value:.6g}", *cells])
    return rows


def plan_record(plan: Plan) -> dict[str, Any]:
    """A plan as JSON holds it."""
    return {
        "scene": plan.scene.name,
        "effects": list(plan.effects),
        "left_out": list(plan.left_out),
        "law": plan.law,
        "method": plan.method,
        "why": plan.why,
        "functions": list(plan.functions),
        "operations": plan.operations,
        "cost": plan.cost,
        "error_estimate": plan.error_estimate,
        "accuracy": plan.accuracy,
    }


def plan_rows(plan: Plan) -> list[tuple[str, str]]:
    """A plan as rows of a table."""
    return [
        ("effects", ", ".join(plan.effects) or "none"),
        ("left out", ", ".join(plan.left_out) or "none"),
        ("friction law", plan.law),
        ("method", plan.method),
        *([("because", plan.why)] if plan.why else []),
        ("functions", "\n".join(plan.functions)),
        ("operations, all of them once", plan.operations),
        ("expected cost", f"about {plan.cost} floating-point operations"),
        ("error to expect", f"{plan.error_estimate:.1e} (asked for {plan.accuracy:.1e})"),
    ]


LADDER = ("effect added", "time", "operations", "peak", "run-out", "duration", "rests", "differs")


def ladder_rows(rungs: Iterable[Rung]) -> list[list[str]]:
    """A ladder as rows of a table; how far each differs from the fullest."""
    return [
        [f"+ {r.added}" if r.added else "none", _seconds(r.seconds), f"{r.cost}", f"{r.peak_velocity:.2f} m/s",
         f"{r.run_out:.4g} m", f"{r.duration:.2f} s", _rests(r), f"{100 * r.difference:.3g} %"]
        for r in rungs
    ]  # fmt: skip


def _rests(r: Rung) -> str:
    return "no" if not r.arrested else "yes" if r.peak_velocity else "stays"


def _seconds(x: float) -> str:
    return f"{x * 1e6:.0f} us" if x < 1e-3 else f"{x * 1e3:.1f} ms" if x < 1e-2 else f"{x * 1e3:.0f} ms"


ALL = ("effects", "operations", "of these")


def combination_rows() -> list[list[str]]:
    """Operation counts of every combination of effects."""
    return [[", ".join(c) or "none", str(f.count), f.operations] for c, f in COMBINATIONS.items()]


def show(
    head: Sequence[str], rows: Iterable[Sequence[str]], title: str = "", caption: str = "", *, tight: bool = False
) -> None:
    """Print a table on stdout, at most 100 columns wide; plain text where stdout is no terminal."""
    try:
        from rich import box
        from rich.console import Console
        from rich.table import Table
    except ImportError as error:
        raise ImportError("tables need rich: pip install 'slipcircle[scenes]', or ask for --json") from error
    shown = Table(
        *head, title=title or None, title_justify="left", title_style="bold", caption=caption or None,
        caption_justify="left", caption_style="", box=box.SIMPLE_HEAD, show_header=any(head),
        padding=0 if tight else (0, 1), show_edge=not tight,
    )  # fmt: skip
    for row in rows:
        shown.add_row(*row)
    console = Console(highlight=False, markup=False, emoji=False)  # a scene's name is anybody's text
    console.width = min(console.width, 100) if console.is_terminal else 100
    console.print(shown)
