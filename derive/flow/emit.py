"""The text of `generated/flow.py`: fragments, as data."""

import inspect
from collections.abc import Sequence

from sympy import Float, sstr

from derive.declare.effects import ALL_EFFECTS, LAWS, Effect, Law
from derive.flow import equation
from derive.flow.fragments import INPUTS, QUANTITIES, fragments, pieces
from derive.flow.lowering import Fragment

_HEAD = '''"""The balance of momentum, as fragments of flow programs: what each effect and each law adds, as operations.

In dimensionless numbers, time t sqrt(g/R), angular velocity omega sqrt(R/g), stresses over sigma_ref:

{equation}

Fragments are joined to a scene's program by the names of what they make and take. ``..._0`` is a number where the phase
began and ``d...`` the series of its increment since; ``=1.0`` is a constant.
"""

from collections.abc import Callable
from typing import Any, NamedTuple


{fragment}

'''


def module(effects: Sequence[Effect] = ALL_EFFECTS, laws: Sequence[Law] = LAWS) -> str:
    """The module's text."""
    inputs = {name: repr(meaning) for name, meaning in INPUTS.items()}
    kinked = {law.name: _pieces(law) for law in laws if law.kinks}
    parts = {name: _fragment(f) for name, f in fragments(effects, laws).items()}
    blocks = (
        ("Numbers that every scene gives", "INPUTS", inputs),
        (
            "Laws of slip in pieces: their scale, where pieces begin over it, and their polynomials in what is beyond",
            "PIECES: dict[str, tuple[str, tuple[float, ...], Callable[..., Any]]]",
            kinked,
        ),
        ("Parts of programs", "FRAGMENTS: dict[str, Fragment]", parts),
    )
    text = _HEAD.format(fragment=inspect.getsource(Fragment), equation=equation.in_plain_text())
    for comment, name, rows in blocks:
        lines = "".join(f"    {x!r}: {row},\n" for x, row in rows.items())
        text += f"# {comment}.\n{name} = {{\n{lines}}}\n\n"
    return text + f"QUANTITIES = {QUANTITIES!r}  # what fragments add to\n\n{equation.text()}"


def _pieces(law: Law) -> str:
    """Scale, breaks and polynomials of a law as Python."""
    breaks, polynomials = pieces(law)
    names: set[str] = set()
    rows = []
    for polynomial in polynomials:
        coefficients = []
        for c in polynomial:
            names.update(str(x) for x in c.free_symbols)
            coefficients.append(sstr(Float(c) if c.is_Number else c))
        rows.append(f"({', '.join(coefficients)})")
    starts = tuple(map(float, breaks))
    return f"({law.scale!r}, {starts!r}, lambda {', '.join(sorted(names))}, **_: ({', '.join(rows)}))"


def _fragment(f: Fragment) -> str:
    lines = []
    for name, value in f._asdict().items():
        if name in ("scalar", "series") and value:
            rows = "".join(f"            {x!r},\n" for x in value)
            lines.append(f"        {name}=(\n{rows}        ),\n")
        elif name == "adds" and value:
            rows = "".join(f"            {x!r}: {added!r},\n" for x, added in value.items())
            lines.append(f"        {name}={{\n{rows}        }},\n")
        else:
            lines.append(f"        {name}={value!r},\n")
    return f"Fragment(\n{''.join(lines)}    )"
