"""Motion of a frozen mass while a record is a straight line: the speed is quadratic in time, and the path cubic.

Time is a fraction of the length of the straight line, and moments are multiplied by that length.
"""

from functools import cache

from sympy import Expr, diff, integrate, solve, symbols

from derive.algebra import dynamics
from derive.algebra.prove import prove_zero

time, omega, net, rise = symbols("time omega net rise", real=True)
fall, fall_slope, press, press_slope = symbols("fall fall_slope press press_slope", real=True)


@cache
def motion() -> tuple[Expr, Expr]:
    """Return speed and path after a time of sliding, derived from (3.11) without the centripetal term.

    J_theta and J_r are linear in time. The net moment over Theta* is ``net`` at first, and rises by ``rise``.
    """
    linear = {dynamics.j_theta: fall + fall_slope * time, dynamics.j_r: press + press_slope * time, dynamics.polar: 0}
    rate = dynamics.balance()["3.11"].subs(linear) / dynamics.theta_star
    moment = net + rise * time
    numbers = {net: rate.subs(time, 0), rise: diff(rate, time)}
    prove_zero(rate - moment.subs(numbers), "the net moment is linear")
    speed = omega + integrate(moment, time)
    return speed, integrate(speed, time)


@cache
def roots() -> tuple[Expr, list[Expr]]:
    """Return the time at which the net moment is zero, and the times at which the speed is zero."""
    speed, _ = motion()
    (level,) = solve(diff(speed, time), time)
    stops = solve(speed, time)
    for stop in stops:
        prove_zero(speed.subs(time, stop), "a mass stops at a root of its speed")
    return level, stops


def prove() -> str:
    """Derive the motion and its roots, and return a summary."""
    _, stops = roots()
    return f"speed and path under a straight line derived from (3.11), and {len(stops)} roots of the speed"
