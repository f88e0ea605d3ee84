"""Slope of a scene file: its circle with factors of safety, and the section that moves along it."""

from dataclasses import dataclass, replace

from slipcircle.base.errors import complaint, raise_all
from slipcircle.base.inputerror import InputError
from slipcircle.base.kinds import Tell, Texts, ValueDict, Values
from slipcircle.ground import Section, circle_through, circle_touching, outside_between, simple_slope
from slipcircle.layers import LayeredSection
from slipcircle.workbench.files.profile import Arguments, GroundProfile, Surcharges, numbered_points
from slipcircle.workbench.stability.critical import Critical, at_circle
from slipcircle.workbench.stability.search import critical
from slipcircle.workbench.stability.stability import METHODS, Slope, require_drive

_FLATTEST = 1e5  # radius over the size of the ground, beyond which a mass is a thin skin
_OF_MOTION = ("gravity", "width")  # in [ground], not used by statics


@dataclass(frozen=True)
class SlopeInput:
    """Slope of a scene file, as read.

    Attributes
    ----------
    given : mapping
        Arguments by path of the table, in SI units.
    strength : mapping
        Strength and pore pressure of a single soil; empty for a soil without strength and for layers.
    profile : Profile, optional
        Layers, if any.
    surcharge : list of tuple
        Left and right x in m, and the pressures there in Pa.
    """

    given: Arguments
    strength: Values
    profile: GroundProfile | None
    surcharge: Surcharges

    @property
    def ground(self) -> ValueDict:
        """Arguments of [ground], with a simple slope replaced by its points."""
        ground = dict(self.given["ground"])
        if simple := {n: ground.pop(n) for n in ("height", "angle", "run") if n in ground}:
            ground["ground"] = simple_slope(**simple)
        return ground

    @property
    def water(self) -> ValueDict:
        """Arguments of [water] and [[pond]]: level, confinement, unit weight of water, and ponds."""
        water = dict(self.given.get("water", {}))
        if "unit_weight" in water:
            water["water_unit_weight"] = water.pop("unit_weight")
        return water | {
            "ponds": [tuple(map(pond.get, ("from", "to", "level"))) for pond in numbered_points(self.given, "pond")]
        }

    @property
    def limits(self) -> ValueDict:
        """Limits of the search, and the seismic coefficient."""
        return self.given.get("search", {})

    @property
    def start(self) -> str:
        """Method whose factor of safety starts the motion: as given, else the method of the search, else Bishop's."""
        circle = self.given.get("circle", {})
        named = circle.get("critical")
        return str(circle.get("start", named if named in METHODS else "bishop"))

    def slope(self) -> Slope:
        """Return the slope for the computation of factors of safety."""
        fields = {name: value for name, value in self.ground.items() if name not in _OF_MOTION}
        fields |= self.water | self.given.get("tension_crack", {})
        fields |= {name: self.limits[name] for name in ("k_h", "k_h_on_surcharge") if name in self.limits}
        soils = {"layers": self.profile.layers} if self.profile else self.strength
        return Slope(**fields, **soils, surcharge=self.surcharge)

    def stability(self, tell: Tell) -> tuple[ValueDict, Critical | None]:
        """Return the given or the critical circle, and its factors of safety; None without strength.

        The circle has the arguments "centre", "radius" and "between" of `Section`. `tell` is called with lines of
        progress.
        """
        circle = {name: value for name, value in self.given.get("circle", {}).items() if name != "start"}
        has_strength = self.profile is not None or bool(self.strength)
        if "critical" in circle:
            if not has_strength:
                needs = "circle.critical: needs friction or cohesion, and a pore pressure that is not a record"
                raise InputError("critical", [needs])
            limits = {name: self.limits[name] for name in ("entry", "exit", "depth") if name in self.limits}
            least = critical(self.slope(), circle["critical"], **limits, tell=tell)
            if least.radius > _FLATTEST * least.slope.size:
                raise InputError("critical", ["{depth}: is missing: the search leads to ever thinner masses"])
            searched = replace(least, start=self.start)
            return {"centre": searched.centre, "radius": searched.radius, "between": searched.between}, searched
        circle = _circle(circle)
        ground = self.ground
        geometry = Section(ground["ground"], **circle, **self.water, unit_weight=1.0, base=ground.get("base"))
        raise_all("Section", complaint([outside_between(geometry)], ()))
        # The circle is known to be above the base, which may lie higher than ground beside it.
        fixed = at_circle(replace(self.slope(), base=None), geometry) if has_strength else None
        pushed = "shaking" in self.given or self.given[""].get("initial_velocity")
        if not pushed and not (self.profile and fixed and fixed.facing):
            require_drive(geometry)
        return circle, fixed and replace(_deep_enough(fixed, geometry), start=self.start)

    def section(self, circle: Values) -> Section:
        """Return the section that moves along a circle, a mapping with "centre", "radius" and "between"."""
        common = self.ground | self.water | dict(circle)
        if self.profile is None:
            return Section(**common)
        profile = self.profile
        return LayeredSection(
            **common,
            layers=profile.layers,
            strength=profile.strength,
            foreland=profile.foreland,
            surcharge=self.surcharge,
            rate=profile.rate,
            crack=self.given.get("tension_crack", {}).get("crack", 0.0),
        )


def motion_mistakes(values: Arguments, layered: bool) -> Texts:
    """Return a message for each table that factors of safety use but motions do not.

    `values` are the arguments by path of the table, and `layered` states whether the file has layers.
    """
    alone = "is for factors of safety alone (slipcircle search)"
    mistakes = []
    if values.get("tension_crack", {}).get("crack_water"):
        why = "a crack opens and empties as soon as the mass moves"
        mistakes.append(f"tension_crack.water_m: {alone}: {why}; leave it out")
    present = {"tension_crack": "tension_crack" in values, "surcharge": bool(numbered_points(values, "surcharge"))}
    for name in (name for name, there in present.items() if there and not layered):
        fix = "put the soil into [soils.NAME], with one [[layers]] of it"
        mistakes.append(f"{name}: a motion uses it on layered ground only: {fix}; or leave it out")
    return mistakes


def _deep_enough(circle: Critical, section: Section) -> Critical:
    """Return the factors of safety of a circle, or raise an error if a tension crack cuts off its mass.

    `circle` are these factors, and `section` is the mass along the circle without a crack.
    """
    slope = circle.slope
    if slope.crack and not any(circle.factors_of_safety.values()):
        uncracked = at_circle(replace(slope, crack=0.0, crack_water=0.0), section)
        if any(uncracked.factors_of_safety.values()):
            words = f"{{crack}} = {slope.crack:g}: is deeper than the mass, which is {float(section.depth):.4g} m thick"
            raise InputError("Section", [words])
    return circle


def _circle(circle: ValueDict) -> ValueDict:
    """Return centre, radius and range of a circle from any of the ways to define it.

    `circle` has the arguments of [circle] in SI units.
    """
    if "through" not in circle:
        return circle
    points = circle.pop("through")
    if len(points) != 2:
        raise InputError("circle_through", ["{through}: must be two points, [[x, y], [x, y]]"])
    between = circle.pop("between", None)
    if "touching" in circle:
        centre, radius = circle_touching(points[0], points[1], circle["touching"])
    else:
        centre, radius = circle_through(*points, **circle)
    return {"centre": centre, "radius": radius, "between": between}
