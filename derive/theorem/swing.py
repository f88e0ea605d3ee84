"""One swing of a slide, from rest to the next standstill, as Taylor series in time with bounded remainders.

With the dip psi = dip - x of the chord after a rotation x, and omega = x', the balance of moments over Theta* is

    omega' = weight sin psi - cohesion - mu (press cos psi + polar omega^2 - pore),  mu = residual + drop exp(-decay x).

A step of the motion is a polynomial of t with balls for coefficients. The last ball contains this coefficient of the
Taylor series about every state of the step (Lagrange). The derivatives of the polynomial therefore enclose the
derivatives of the motion, and its integral encloses the rotation. The proof consists of the signs of omega' and omega''
on a whole step and of balls for their zeros by Newton's method.

With E = omega^2/2, dE/dx = omega' as a function of x. Where E is equal and the mass presses on the arc, less friction,
load or resistance make omega' greater, and so does a swing that began at a greater dip. Solutions of an equation of
first order do not cross. Rest and peak of uncertain coefficients therefore lie between those of two extreme swings.
"""

from typing import Any, NamedTuple

from flint import arb, arb_poly, arb_series, ctx

FIRST_STEP = arb(0.5)
HALVINGS = 60  # of a step after which a claim counts as undecided


class Undecided(ArithmeticError):
    """Balls too wide for a decision."""


class Swing(NamedTuple):
    """Coefficients of the balance of moments."""

    dip: arb
    weight: arb
    press: arb
    polar: arb
    cohesion: arb
    pore: arb
    residual: arb
    drop: arb
    decay: arb

    def friction(self, x: Any) -> Any:
        """Return the friction coefficient after a rotation x in rad, as a ball or a series."""
        return (-self.decay * x).exp() * self.drop + self.residual

    def normal(self, x: Any, omega: Any) -> Any:
        """Return the normal force on the arc over Theta*, after a rotation x in rad at the angular velocity omega."""
        return (self.dip - x).cos() * self.press + omega * omega * self.polar - self.pore

    def acceleration(self, x: Any, omega: Any) -> Any:
        """Return omega', the angular acceleration of a moving mass, after a rotation x at the velocity omega."""
        return (self.dip - x).sin() * self.weight - self.cohesion - self.friction(x) * self.normal(x, omega)

    def taylor(self, x: arb, omega: arb) -> list[arb]:
        """Return the Taylor coefficients of omega in time about a state, up to the cap of series, lowest first.

        Each iteration of Picard adds a coefficient.
        """
        speed = arb_series([omega], 1)
        for _ in range(1, ctx.cap):
            speed = self.acceleration(speed.integral() + x, speed).integral() + omega
        return list(speed)

    def reversed(self, rest: arb) -> "Swing":
        """Return the swing in the other direction, from the end of this swing after the rotation ``rest``.

        Friction is not recovered.
        """
        return self._replace(dip=rest - self.dip, drop=(-self.decay * rest).exp() * self.drop)


class Step(NamedTuple):
    """Part of a swing: its length in time, the rotation and omega as functions of the time since it began."""

    length: arb
    x: arb_poly
    omega: arb_poly


class Standstill(NamedTuple):
    """End of a swing: rotation and time (over sqrt(R/g)); rotation and omega at the peak; all steps."""

    rest: arb
    time: arb
    peak_at: arb
    peak: arb
    steps: list[Step]


def until(length: arb) -> arb:
    """Return the ball that covers [0, length], as a time."""
    return length * arb(0.5, 0.5)


def bounded(swing: Swing, x: arb, omega: arb, length: arb) -> tuple[arb, arb]:
    """Return balls that contain x and omega during a time that begins at the state (x, omega).

    Picard's iteration maps the balls into themselves.
    """
    times = until(length)
    wide = omega
    for _ in range(20):
        place = x + times * wide
        change = times * swing.acceleration(place, wide)
        if wide.contains(omega + change):
            return place, wide
        wide = omega + change * arb(1, 0.2)
    raise Undecided("the speed is not bounded")


def step(swing: Swing, x: arb, omega: arb, length: arb, tolerance: arb) -> Step:
    """Return the step from a state with the longest of a length and its halves whose remainder meets the tolerance.

    The tolerance is relative to the largest term of the series.
    """
    *thin, _ = swing.taylor(x, omega)
    order = len(thin)
    for _ in range(HALVINGS):
        *_, last = swing.taylor(*bounded(swing, x, omega, length))
        largest = max(c.abs_upper() * length**k for k, c in enumerate(thin))
        if last.abs_upper() * length**order < largest * tolerance:
            speed = arb_poly([*thin, last])
            return Step(length, speed.integral() + x, speed)
        length /= 2
    raise Undecided("the series of the motion do not converge")


def zero(f: arb_poly, length: arb) -> arb:
    """Return a ball around the single zero of a decreasing polynomial on [0, length], by Newton's method."""
    slope = f.derivative()
    root = until(length)
    for _ in range(ctx.prec):
        middle = root.mid()
        closer = root.intersection(middle - f(middle) / slope(root))
        if not closer.rad() < root.rad() / 2:
            break
        root = closer
    return root


def next_standstill(swing: Swing, tolerance: arb) -> Standstill:
    """Return the next standstill of a swing that starts: omega' > 0 up to the peak, where its sign changes once.

    ``tolerance`` bounds the relative remainder of each step.
    """
    x = omega = time = peak_at = peak = arb(0)
    length = FIRST_STEP
    steps: list[Step] = []
    rises = True
    while True:
        part = step(swing, x, omega, length, tolerance)
        length, crosses = decided(part, rises)
        end = length
        if crosses:
            root = zero(part.omega.derivative() if rises else part.omega, length)
            if rises:
                peak_at, peak = part.x(root), part.omega(root)
            else:
                end = root
            rises = False
        steps.append(part._replace(length=end))
        times = until(end.upper())
        if not swing.normal(part.x(times), part.omega(times)) > 0:
            raise Undecided("the mass does not certainly press on the arc all the way")
        x, omega = part.x(end), part.omega(end)
        time += end
        if end is not length:
            return Standstill(x, time, peak_at, peak, steps)
        length = min(2 * length, FIRST_STEP)


GREATER = ("dip", "pore", "decay")  # greater coefficients that prolong a swing
LESS = ("press", "polar", "cohesion", "residual", "drop")  # lesser ones


def between(swing: Swing, tolerance: arb) -> Standstill:
    """Return the next standstill for uncertain coefficients, with rest and peak between those of extreme swings.

    ``tolerance`` bounds the relative remainder of each step.
    """
    stand = next_standstill(swing, tolerance)
    if all(x.rad() < tolerance for x in swing):
        return stand
    ends = []
    for more, less in ((arb.upper, arb.lower), (arb.lower, arb.upper)):
        extremes = dict.fromkeys(GREATER, more) | dict.fromkeys(LESS, less)
        coefficients = {name: end(getattr(swing, name)) for name, end in extremes.items()}
        ends.append(next_standstill(swing._replace(**coefficients), tolerance))
    longest, shortest = ends
    return stand._replace(
        rest=stand.rest.intersection(shortest.rest.union(longest.rest)),
        peak=stand.peak.intersection(shortest.peak.union(longest.peak)),
    )


def decided(part: Step, rises: bool) -> tuple[arb, bool]:
    """Return the longest of a step's length and its halves with certain signs, and whether it contains the event.

    ``rises`` is whether the mass accelerates at the beginning of the step.

    While the mass accelerates, omega' > 0 and the event is the zero of omega'. Then omega' < 0 and the event is the
    zero of omega.
    """
    length, _, omega = part
    event = omega.derivative() if rises else omega
    slope = event.derivative()
    for _ in range(HALVINGS):
        times = until(length)
        at_end = event(length)
        falls = slope(times) < 0
        if falls and at_end < 0 and (not rises or omega(length) > 0):
            return length, True
        if at_end > 0 and (falls or (rises and event(times) > 0)):
            return length, False
        length /= 2
    raise Undecided("whether the mass speeds up, slows down or stands is not certain")
