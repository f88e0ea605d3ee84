"""Theorems on a slide: it moves, comes to rest once, keeps contact and stays at rest, with enclosures of its numbers.

The moments come from their definitions (`derive.check.truth`), and the motion from the balance of moments about the
centre of the arc, with psi the dip of the chord, for lengths in R and times in sqrt(R/g):

    Theta* omega' = C_theta sin psi - mu [C_r cos psi + I_p omega^2 - lambda u*] - lambda c*   ((2.20), (3.11)-(3.13)).
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import reduce
from itertools import accumulate
from typing import NamedTuple

from flint import arb

from derive.check.truth import enclosure, half_disc_limit, working
from derive.theorem.swing import Standstill, Swing, Undecided, between

BITS = 3.33  # a digit
SPARE = 6  # digits of each part of a motion, more than the sum is to have
MOST_SWINGS = 200
EFFORTS = (1, 3, 9)


class Slide(NamedTuple):
    """An arc and its friction, as balls, in SI units and radians."""

    radius: arb
    theta_1: arb
    theta_2: arb
    friction: arb
    gravity: arb
    peak_friction: arb | None = None  # initial value; it falls exponentially with slip
    length: arb = arb(1)  # of this fall
    cohesion: arb = arb(0)  # over the unit weight: m
    pore_pressure: arb = arb(0)  # too
    rotation: bool = True
    centripetal: bool = True


@dataclass
class Theorem:
    """Status of a motion, proved statements, enclosures by name, and the reason for an undecided status."""

    status: str = "undecided"
    proved: list[str] = field(default_factory=list)
    numbers: dict[str, arb] = field(default_factory=dict)
    reason: str = ""

    @property
    def digits(self) -> float:
        """Number of certain digits of the least certain result."""
        return min((x.rel_accuracy_bits() for x in self.numbers.values()), default=0) / BITS


def _moment(statement: str, alpha: arb) -> arb:
    """Return a moment of an arc up to a half disc, with half the opening angle alpha in rad.

    ``statement`` is its integrand, such as "r^2 cos u". A moment increases with the angle, as the integrand is
    positive.
    """
    if alpha < arb.pi() / 2:
        return enclosure((statement,), alpha)
    return enclosure((statement,), alpha.lower()).union(half_disc_limit((statement,)))


def first_swing(slide: Slide) -> Swing:
    """Return the coefficients of the first swing over Theta*; an arc that faces the other way is mirrored."""
    middle = (slide.theta_1 + slide.theta_2) / 2
    alpha = ((slide.theta_2 - slide.theta_1) / 2).min(arb.pi() / 2)
    inertia = _moment("r^3", alpha)
    over_stress = 2 * alpha / (slide.radius * inertia)  # lambda/Theta* over sigma_ref = gamma f R
    return Swing(
        dip=abs(arb.pi() * 3 / 2 - middle),
        weight=_moment("r^2 cos u", alpha) / inertia,
        press=_moment("r^1 cos u", alpha) / inertia,
        polar=_moment("r^2", alpha) / inertia * slide.centripetal,
        cohesion=slide.cohesion * over_stress,
        pore=slide.pore_pressure * over_stress,
        residual=slide.friction,
        drop=arb(0) if slide.peak_friction is None else slide.peak_friction - slide.friction,
        decay=slide.radius / slide.length,
    )


def theorem(slide: Callable[[], Slide], digits: int = 20, efforts: Sequence[int] = EFFORTS) -> Theorem:
    """Enclose a motion to a number of digits, with sufficient precision or as far as the inputs allow.

    Parameters
    ----------
    slide : callable
        Function that returns the slide at the current precision, so that exact inputs remain exact.
    digits : int
        Certain digits required of every number.
    efforts : sequence of int
        Multiples of the spare digits, tried in this order.

    Returns
    -------
    Theorem
        Theorem with the status "rests", "does not move", "never rests", or "undecided" with a reason.
    """
    proof = Theorem()
    for effort in efforts:
        before = proof.digits
        wanted = digits + effort * SPARE
        with working(int(BITS * (wanted + 4 * effort * SPARE)), wanted + SPARE):
            proof = Theorem()
            try:
                proof.status = _status(slide(), proof, arb(10) ** -wanted)
            except ArithmeticError as undecided:
                proof.reason = str(undecided)
        if proof.status != "undecided" and not before + 1 < proof.digits < digits + 1:
            break
    return proof


def about(x: arb) -> str:
    """Return the certain digits of a ball as a decimal, at most six of them."""
    return str(x.str(6, radius=False))


def _status(slide: Slide, proof: Theorem, tolerance: arb) -> str:
    """Return the status of the motion, and add statements and numbers to the proof as they are decided.

    ``tolerance`` bounds the relative remainder of each step in time.
    """
    swing = first_swing(slide)
    still = arb(0)
    normal = swing.normal(still, still)
    if not normal > 0:
        dip = "its chord has to dip by less than 90 degrees, the pore pressure to be below the normal stress"
        raise Undecided(f"the mass does not certainly press on the arc: {dip}")
    limit_friction = (swing.dip.sin() * swing.weight - swing.cohesion) / normal
    margin = swing.friction(still) - limit_friction
    proof.numbers |= {"limit_friction": limit_friction, "margin": margin}
    if margin > 0:
        proof.numbers |= dict.fromkeys(("rotation_rad", "run_out_m", "peak_velocity_m_s", "duration_s"), still)
        above = f"friction is above its limit of {about(limit_friction)} by {about(margin)}"
        proof.proved.append(f"{above}: it does not move")
        return "does not move"
    if not margin < 0:
        raise Undecided(f"whether friction is above its limit, by {margin.str(3)}, is not certain")
    proof.proved.append(f"friction is below its limit of {about(limit_friction)} by {about(-margin)}: the mass moves")
    if slide.rotation:
        return _swings(slide, swing, proof, tolerance)
    proof.proved.append("without rotation the net moment at rest never falls, so that omega^2 > 0: it never rests")
    return "never rests"


def _swings(slide: Slide, swing: Swing, proof: Theorem, tolerance: arb) -> str:
    """Enclose swings until the mass stays at rest, and return the status.

    Statements and numbers are added to the proof, and ``tolerance`` bounds the relative remainder of each step in time.
    """
    stands: list[Standstill] = []
    still = arb(0)
    while swing.acceleration(still, still) > 0:
        stand = between(swing, tolerance)
        stands.append(stand)
        if len(stands) == 1:
            proof.proved += [
                f"it speeds up until omega has its one maximum, after {about(stand.peak_at)} rad",
                f"it slows down until it stands, after {about(stand.rest)} rad, and does not stand sooner",
                "it presses on the arc all the way",
            ]
        if swing.residual == 0 and swing.drop == 0 and swing.cohesion == 0:
            proof.proved.append("nothing resists: it swings back as far as it came, and never rests")
            return "never rests"
        if len(stands) == MOST_SWINGS:
            raise Undecided(f"the mass still swings after {MOST_SWINGS} standstills")
        swing = swing.reversed(stand.rest)
    if not swing.acceleration(still, still) < 0:
        raise Undecided("whether the mass stays where it stands is not certain")
    if len(stands) > 1:
        proof.proved.append(f"it swings back {len(stands) - 1} times; the same holds of each swing")
    proof.proved.append("where it stands, the resistance exceeds what pulls it back: it stays")
    proof.numbers |= _numbers(slide, stands)
    return "rests"


def _numbers(slide: Slide, stands: list[Standstill]) -> dict[str, arb]:
    """Return the numbers of the whole motion by name in SI units; run-out and rotation are the greatest.

    The place of rest is added if the mass swings back, and the place of the peak if its swing is certain.
    """
    first, *others = stands
    farthest, *later = accumulate((-1) ** k * stand.rest for k, stand in enumerate(stands))
    # Friction makes each swing shorter than the swing before it; each must be proved to stay within the first.
    if not all(abs(place) < farthest for place in later):
        raise Undecided("at which standstill the mass is farthest is not certain")
    duration = sum((stand.time for stand in stands), arb(0))
    peak = reduce(arb.max, (stand.peak for stand in stands))
    numbers = {
        "rotation_rad": farthest,
        "run_out_m": farthest * slide.radius,
        "peak_velocity_m_s": peak * (slide.radius * slide.gravity).sqrt(),
        "duration_s": duration * (slide.radius / slide.gravity).sqrt(),
    }
    if others:
        numbers["end_displacement_m"] = later[-1] * slide.radius
    if all(first.peak > stand.peak for stand in others):
        numbers["peak_displacement_m"] = first.peak_at * slide.radius
    return numbers
