"""The text of `generated/slopes.py`: programs for real slopes, each with its docstring."""

from derive.algebra import slopes
from derive.algebra.slopes import NODES, REACH, WEIGHTS
from derive.code import emit
from derive.code.program import program

TITLE = "The mass between an arc and a ground of straight edges, and the slices above an arc; lengths over R."
_WORDS = {
    "x": "First end of the edge from the centre, horizontally, over R.",
    "y": "First end of the edge from the centre, upwards, over R.",
    "e_x": "From the first end to the second, horizontally, over R.",
    "e_y": "From the first end to the second, upwards, over R.",
    "angle": "From the first end to the second as seen from the centre, rad, counterclockwise positive.",
    "g": "1 - rho^2 of a point of the edge, rho its distance from the centre over R; below 1.",
    "sine": "sin(beta), beta from straight below the centre, positive down-slope.",
    "cosine": "cos(beta).",
    "beta": "Angle from straight below the centre, rad.",
    "height": "Of the slice, from the arc up to the ground, over R.",
    "pressure": "Pore pressure on the arc over gamma R.",
    "cohesion": "Over gamma R.",
    "mu": "Friction coefficient, tan(phi).",
    "k_h": "Horizontal acceleration over g, positive where it drives.",
    "factor": "Factor of safety, above 0.",
    "distance": "Of the ground above the arc's point, from the centre, over R.",
    "slope": "Of that line, its rise over a run to the right.",
}
# Where an example is: on slopes of 1 in 9 and 1 in 2, with water and an earthquake.
_GIVEN = {"x": -0.5, "y": -0.6, "e_x": 0.9, "e_y": 0.1, "angle": 1.3695, "g": 0.39, "sine": 0.5, "cosine": 0.866,
          "beta": 0.5, "height": 0.2, "pressure": 0.05, "cohesion": 0.03, "mu": 0.4, "k_h": 0.1, "factor": 1.2,
          "distance": 0.7, "slope": 0.5}  # fmt: skip

_LISTED = ", ".join(WEIGHTS)
# The docstring of each function besides its inputs: summary, formula, returns and a note.
_TEXTS = {
    "closed": (
        "Return the integrals over the ring between an edge and the arc under it: sector minus triangle.",
        "Of r dr dtheta, then of its products with r and r^2, with (cos, sin)(theta), and with r (cos, sin)(theta).",
        f"{_LISTED}, all over powers of R.",
        f"Accurate where the edge is longer than {REACH} (r1 + r2); `rings` elsewhere.",
    ),
    "rings": (
        "Return the integrands, over s from 0 to 1 along an edge, of the integrals over a ring; divided by P1 x e.",
        "(1 - rho^n)/(n rho^2) for n = 2, 3, 4, then (1 - rho^n)/(n rho^3) for n = 2, 3, to be times the point itself.",
        "area, polar, inertia, radial, moment.",
        f"With g = (1-s) g1 + s g2 + s (1-s) d^2 and Gauss' rule of {NODES} nodes: accurate however thin the ring, "
        f"where the edge is at most {REACH} (r1 + r2) long.",
    ),
    "head": (
        "Return the integral of the height of a line above the arc, from a point of the arc over an angle.",
        "height a + (slope cos - sin) (1 - cos(a)) - (slope sin + cos) (a - sin(a)), a the angle, sin and cos the "
        "point's.",
        "Over R.",
        "Over at most pi; accurate however near the line and however steep.",
    ),
    "drive": (
        "Return the driving moment of the slices about the centre, over dbeta and gamma R^3.",
        "Weight and k_h times it, at half the slice's height.",
        "Positive down-slope.",
    ),
    "ordinary_normal": (
        "Return the effective normal stress of the ordinary method (Fellenius), over gamma R.",
        "The forces between slices have no component along the radius: N' = W (cos a - k_h sin a) - u l.",
        "May be negative.",
    ),
    "bishop_strength": (
        "Return the strength of Bishop's simplified method times its lever, over gamma R.",
        "(c + mu (h - u)) cos(beta).",
        "Strength is this over `bishop_lever`.",
    ),
    "bishop_lever": (
        "Return m_alpha of Bishop's simplified method.",
        "cos(beta) - sin(beta) mu/F.",
        "Below 0.05 the method is of no use.",
    ),
    "bishop_normal": (
        "Return the effective normal stress of Bishop's simplified method, over gamma R.",
        "From the vertical balance of a slice that carries no vertical force to its neighbours.",
        "May be negative.",
    ),
    "radial_weight": (
        "Return the weight along the radius (2.23) by strips above the arc, over dbeta and gamma R^2.",
        "Integral of the cosine of a point's angle from straight below the centre, over a strip.",
        "Its integral over the arc is J_r, of the paper's mean normal stress.",
    ),
    "radial_tilt": (
        "Return the contribution of a unit of k_h to `radial_weight`.",
        "Integral of the sine of a point's angle from straight below the centre, over a strip.",
        "Its integral over the arc is dJ_r/dpsi.",
    ),
}


def slopes_module() -> str:
    """Return the text of `generated/slopes.py`."""
    several = {"closed": slopes.closed(), "rings": slopes.rings()}
    one = {"head": slopes.head()} | slopes.slices()
    functions = []
    for name, outputs in (several | {name: (form,) for name, form in one.items()}).items():
        free = {s.name for e in outputs for s in e.free_symbols}
        p = program(name, tuple(n for n in _WORDS if n in free), *outputs)
        summary, formula, returned, *notes = _TEXTS[name]
        inputs = [(n, "float or ndarray", _WORDS[n]) for n in p.inputs]
        returns = "tuple of ndarray" if len(outputs) > 1 else "float or ndarray", returned
        note = "No domain check; shapes broadcast."
        examples = emit.example(p, "generated.slopes", [_GIVEN[n] for n in p.inputs])
        text = emit.numpydoc(summary, formula, inputs, returns, *notes, note, examples=examples, width=114)
        functions.append((p, text))
    constants = (
        "# Edges up to REACH (r1 + r2) long are integrated by `rings` with Gauss' rule of NODES nodes, others by "
        f"`closed`.\nREACH, NODES = {float(REACH)!r}, {NODES}\n"
    )
    return emit.plain_module(TITLE, functions, constants, imports="\nfrom generated._evaluate import horner\n")
