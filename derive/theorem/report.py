"""Theorems from the command line: exact decimals as input, and decimals that bound each proved number as output."""

import json
from collections import defaultdict, deque
from collections.abc import Iterator, Mapping
from decimal import ROUND_CEILING, ROUND_FLOOR, Context, Decimal
from fractions import Fraction
from functools import partial
from typing import NamedTuple

from flint import arb

from derive.check.truth import as_ball, fraction
from derive.kinds import TextMap, Texts, ValueDict, Values
from derive.progress import track
from derive.theorem.motion import EFFORTS, Slide, Theorem, first_swing, theorem

# The slide of Vaiont: Table 2-1 of the paper with the residual friction of its section 4, and the softening that the
# scene of this name assumes.
VAIONT = {"radius_m": "1492.6", "theta_1_deg": "215.2", "theta_2_deg": "276.9", "friction_deg": "10"}
SOFTENING = {"peak_friction_deg": "22.5", "length_m": "1"}
SCENES: dict[str, ValueDict] = {"vaiont": {}, "vaiont-frozen": {"rotation": False}, "vaiont-softening": SOFTENING}
PARTS = 2000  # largest number of parts of uncertain inputs
PART_DIGITS = 1  # of each part, with the spare digits one more than are shown; uncertain inputs allow no more
SHOWN_DIGITS = 6
FINE = 1 / 16  # share of a part that is not divided further once it is decided, so that enclosures are narrow
STRESSES = ("cohesion_kPa", "pore_pressure_kPa")  # divided by the unit weight
OTHERS = dict.fromkeys(STRESSES, "0") | {"gravity_m_s2": "9.81"}
POSITIVE = (Fraction(1, 10**9), 10**9)
BOUNDS: dict[str, tuple[Fraction | int, int]] = {
    "radius_m": POSITIVE,
    "theta_1_deg": (90, 450),
    "theta_2_deg": (90, 450),
    "friction_deg": (0, 89),
    "peak_friction_deg": (0, 89),
    "length_m": POSITIVE,
    **dict.fromkeys(STRESSES, (0, 10**9)),
    "unit_weight_kN_m3": POSITIVE,
    "gravity_m_s2": POSITIVE,
}


class _Interval(NamedTuple):
    """Closed interval between two rational numbers."""

    low: Fraction
    high: Fraction

    def ball(self) -> arb:
        """Return a ball that covers the interval, at the current precision."""
        return as_ball(self.low).union(as_ball(self.high))


def interval(text: str) -> _Interval:
    """Return the interval of a decimal, "10" or "10+-0.1" with an uncertainty; raise ArithmeticError for other text."""
    decimals = [Decimal(part) for part in text.split("+-", 1)]
    if not all(x.is_finite() and abs(x.adjusted()) <= 100 for x in decimals):
        raise ArithmeticError
    centre, radius = (*map(Fraction, decimals), Fraction(0))[:2]
    return _Interval(centre - radius, centre + radius)


def _intervals(texts: TextMap) -> dict[str, _Interval]:
    """Return the intervals of quantities by name from their decimals, or raise a ValueError that lists all mistakes."""
    intervals, faults = dict[str, _Interval](), list[str]()
    for name, text in texts.items():
        least, most = BOUNDS[name]
        try:
            intervals[name] = interval(text)
        except ArithmeticError:
            faults.append(f"{name} {text!r}: give a decimal, or one with its uncertainty: 10 or 10+-0.1")
            continue
        if not (least <= intervals[name].low and intervals[name].high <= most):
            faults.append(f"{name} {text}: allowed are {least} to {most}")
    if faults:
        raise ValueError("\n".join(faults))
    first = intervals["theta_1_deg"]
    second = intervals["theta_2_deg"]
    if not first.high < second.low <= second.high <= first.low + 180:
        raise ValueError(
            "theta_2_deg: has to be above theta_1_deg, by 180 at most: beyond a half disc it is in tension"
        )
    if "peak_friction_deg" in intervals and intervals["friction_deg"].high > intervals["peak_friction_deg"].low:
        raise ValueError("peak_friction_deg: has to be at least friction_deg, to which friction falls")
    for name in STRESSES:
        if intervals[name].high and "unit_weight_kN_m3" not in intervals:
            raise ValueError(f"{name}: add unit_weight_kN_m3, over which it acts")
    return intervals


def _slide(given: Mapping[str, _Interval], **switches: bool) -> Slide:
    """Return the slide with these valid quantities, at the current precision.

    ``switches`` are the fields rotation and centripetal.
    """
    degree = arb.pi() / 180
    balls = {name: x.ball() * (degree if "deg" in name else 1) for name, x in given.items()}
    peak = balls.get("peak_friction_deg")
    unit_weight = balls.get("unit_weight_kN_m3", arb(1))
    return Slide(
        balls["radius_m"],
        balls["theta_1_deg"],
        balls["theta_2_deg"],
        balls["friction_deg"].tan(),
        balls["gravity_m_s2"],
        peak.tan() if peak is not None else None,
        balls.get("length_m", arb(1)),
        balls["cohesion_kPa"] / unit_weight,
        balls["pore_pressure_kPa"] / unit_weight,
        **switches,
    )


def pair(x: arb, digits: int) -> Texts:
    """Return decimals below and above all numbers of a ball, with this number of significant digits."""
    middle, radius = fraction(x.mid()), fraction(x.rad())
    ends = ((middle - radius, ROUND_FLOOR), (middle + radius, ROUND_CEILING))
    texts = []
    for end, way in ends:
        texts.append(str(Context(digits, way).divide(Decimal(end.numerator), Decimal(end.denominator))))
    return texts


class Division(NamedTuple):
    """Part of the inputs: its share of them, and its intervals."""

    share: float
    quantities: dict[str, _Interval]

    def halves(self) -> Iterator["Division"]:
        """Yield the halves of the part, divided where this narrows the coefficients of the motion most."""

        def spread(name: str) -> float:
            low, high = self.quantities[name]
            middle = (low + high) / 2
            swing = first_swing(_slide(self.quantities | {name: _Interval(middle, middle)}))
            return sum(float(x.rad()) for x in (*swing[:-1], swing.drop * swing.decay))

        divided = min((name for name, x in self.quantities.items() if x.low < x.high), key=spread)
        low, high = self.quantities[divided]
        middle = (low + high) / 2
        for half in (_Interval(low, middle), _Interval(middle, high)):
            yield Division(self.share / 2, self.quantities | {divided: half})


def divided(whole: dict[str, _Interval], parts: int, **switches: bool) -> tuple[Theorem, float]:
    """Return the theorem on all decided parts of uncertain inputs, and the share of the undecided parts.

    ``whole`` has the intervals of the inputs by name, and ``switches`` are the fields rotation and centripetal.

    The largest part is halved until it is decided and its share is at most `FINE`, or until ``parts`` parts are judged.
    """
    waiting = deque([Division(1.0, whole)])  # the largest part first
    shares = defaultdict[str, float](float)
    numbers: dict[str, arb] = {}
    reason = ""
    for _ in track(range(parts), "parts of the inputs", parts):
        if not waiting:
            break
        part = waiting.popleft()
        proof = theorem(partial(_slide, part.quantities, **switches), PART_DIGITS, EFFORTS[:1])
        if proof.status == "undecided" or part.share > FINE:
            reason = proof.reason
            waiting += part.halves()
            continue
        shares[proof.status] += part.share
        known = numbers or proof.numbers
        numbers = {key: x.union(proof.numbers[key]) for key, x in known.items() if key in proof.numbers}
    undecided = sum(part.share for part in waiting)
    proved = [f"{status}: {100 * share:.6g} % of the inputs" for status, share in shares.items()]
    status = " or ".join(shares) if shares and not undecided else "undecided"
    return Theorem(status, proved, numbers, reason if undecided else ""), undecided


def theorem_report(options: Values, digits: int, form: str, parts: int = PARTS) -> tuple[str, bool]:
    """Return the theorem on the slide of these options, by default on each scene, and whether all are decided.

    ``options`` are decimals of quantities by name and the switches rotation and centripetal. ``form`` is "text" or
    "json", and ``parts`` the most parts into which uncertain inputs are divided.
    """
    scenes = {"slide": dict(options)} if options else SCENES
    rows = []
    for name, chosen in scenes.items():
        switches = {key: chosen[key] for key in ("rotation", "centripetal") if key in chosen}
        quantities = _intervals(VAIONT | OTHERS | {key: text for key, text in chosen.items() if key not in switches})
        uncertain = [name for name, x in quantities.items() if x.low < x.high]
        proof = theorem(partial(_slide, quantities, **switches), digits, EFFORTS[:1] if uncertain else EFFORTS)
        undecided = float(proof.status == "undecided")
        if undecided and uncertain:
            digits = min(digits, SHOWN_DIGITS)
            proof, undecided = divided(quantities, parts, **switches)
            proof.reason += f"; narrower {', '.join(uncertain)} or more --parts would decide, digits would not" * (
                undecided > 0
            )
        elif undecided:
            proof.reason += "; more --digits may decide"
        about: ValueDict = {"name": name, "status": proof.status, "reason": proof.reason, "undecided_share": undecided}
        numbers = {key: pair(x, digits) for key, x in proof.numbers.items()}
        rows.append(about | numbers | {"proved": proof.proved})
    decided = not any(row["undecided_share"] for row in rows)
    if form == "json":
        return json.dumps(rows[0] if options else rows, indent=2), decided
    return "\n\n".join(_text(**row) for row in rows), decided


def _text(name: str, status: str, reason: str, undecided_share: float, proved: Texts, **numbers: Texts) -> str:
    """Return the lines of a theorem; each of ``numbers`` is a pair of decimals below and above it."""
    lines = [f"{name}: {status}"]
    if undecided_share:
        lines.append(f"undecided: {100 * undecided_share:.3g} % of the inputs; {reason}")
        if undecided_share < 1.0:
            lines.append("for the other inputs:")
    lines += [f"  {key:<20} {low} to {high}" for key, (low, high) in numbers.items()]
    return "\n".join([*lines, *(f"  - {claim}" for claim in proved)])
