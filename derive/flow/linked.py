"""What scenes link from the fragments, compared with the equation of motion that is derived from the balance laws."""

from collections.abc import Mapping, Sequence
from itertools import product
from typing import Any

from sympy import Add, Expr, Integer, symbols

from derive.algebra import dynamics
from derive.algebra.prove import prove_zero
from derive.declare.effects import EFFECTS, LAWS
from derive.flow.fragments import QUANTITIES, balance, gravity, of_effect, of_law
from derive.flow.lowering import ONE, ZERO, Fragment
from derive.flow.recurrences import first, number, numbers


def net_moment(parts: Sequence[Fragment], cells: Mapping[str, Any]) -> Expr:
    """The rate of the angular velocity omega_star where a phase begins, from what the parts add to the balance."""
    at: dict[str, Expr] = {"omega": dynamics.omega_star, "x": ZERO, "sin(x)": ZERO, "vers(x)": ZERO}
    for part in parts:
        cells = numbers(part.scalar, cells)
        at = first(part.series, at, cells)
    for quantity in (*QUANTITIES, "mu"):
        bases, increments = [], []
        for part in parts:
            if quantity in part.adds:
                base, _, terms = part.adds[quantity]
                bases.append(cells[base])
                increments += [number(c, cells) * at[r] for c, r in terms]
        cells = {**cells, f"{quantity}_0": Add(*bases), f"{quantity}_size": ONE}
        at[f"d{quantity}"] = Add(*increments)
    whole = balance()
    return first(whole.series, at, numbers(whole.scalar, cells))["net"]


def prove() -> list[str]:
    """Prove that weight, centripetal term and constant friction, as they are linked, are the derived (3.11).

    In both directions of travel, at the start (where the drive is from the limit friction) and later (from the terms).
    """
    claims = []
    theta, driving, pressing = symbols("Theta J_theta J_r", positive=True)  # so that it is known which way it is driven
    positive = {dynamics.theta_star: theta, dynamics.j_theta: driving, dynamics.j_r: pressing}
    derived, limit = (dynamics.balance()[equation].subs(positive) for equation in ("3.11", "3.21"))
    given = {
        "driving_moment": driving / theta,
        "normal_load": pressing / theta,
        "polar_moment": dynamics.polar / theta,
        "constant.coefficient": dynamics.mu,
        "LIMIT": limit,
        "LIFTED": ZERO,
    }
    parts = [gravity(), *(of_effect(e) for e in EFFECTS if e.name == "centripetal"), of_law(LAWS[0])]
    for direction, departed in product((1, -1), (0, 1)):
        claims.append(f"(3.11), direction {direction}, {'later' if departed else 'at the start'}")
        net = net_moment(parts, given | {"DIRECTION": Integer(direction), "departed": Integer(departed)})
        prove_zero(theta * net - derived.subs(driving, direction * driving), claims[-1])
    return claims
