"""Motion in tau instead of the time t*, with dt* = (1 + pace omega*) dtau, in which rate weakening needs no quotient.

Friction mu = far + (mu_0 - far)/(1 + pace omega*) falls from mu_0 at rest to far at great speed. Per tau the rates of
rotation and speed are therefore polynomials of the registers:

    d phi/dtau = omega* + pace omega*^2,    d omega*/dtau = net(mu_0) + pace omega* net(far)

where net(mu) is the net moment under a constant friction mu.
"""

from sympy import Expr

from derive.declare.effects import SPEED
from derive.declare.symbols import Forms
from derive.flow.lowering import ZERO, Fragment, Lowering, cell, series, varying


def of_friction(coefficient: Expr) -> Forms:
    """Return far and pace of a friction coefficient by cell, empty unless it is such a quotient."""
    far, change = coefficient.as_independent(SPEED, as_Add=True)
    _, quotient = change.as_independent(SPEED, as_Add=False)
    slower = 1 / quotient
    per_speed = slower.diff(SPEED)
    if SPEED not in change.free_symbols:
        return {}
    if slower != 1 + per_speed * SPEED:
        return {}
    return {"far": far, "per_speed": per_speed}


def fragment() -> Fragment:
    """Return the fragment of the rates of rotation and speed in tau. It replaces those in time."""
    bases = {cell(x): varying(x) for x in ("driving", "resisting", "normal")}
    whole = {cell(x): (ZERO, series(x)) for x in ("gain", "omega")}
    low = Lowering("pace", bases | whole)
    others = cell("driving") - cell("resisting")
    pressed = cell("grip") * cell("normal")
    per_speed = cell("per_speed")
    change = per_speed * cell("omega")
    low.cells["pace"] = per_speed
    low.cells["gain_0"], increment = low.split(others - cell("far") * pressed)
    low.register(increment, "dgain")
    low.register(series("dgain"), "gain", "gain_0")
    _, increment = low.split(others - cell("mu_0") * pressed + change * cell("gain"))
    low.register(increment, "dnet")
    return low.fragment(states={"x": cell("omega") * (1 + change)})
