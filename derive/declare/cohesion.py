"""Laws of cohesion as a function of slip, derived from the friction laws."""

from dataclasses import replace

from derive.declare.effects import LAWS, Parameter


def _of_cohesion(p: Parameter) -> Parameter:
    """Return the parameter of a law of cohesion for a parameter of a friction law."""
    if p.unit:
        return replace(p, help=p.help.replace("friction", "cohesion"))
    name = "cohesion" if p.name == "coefficient" else p.name
    words = p.help.replace("friction coefficients", "cohesions").replace("friction coefficient", "cohesion")
    words = words.removesuffix(", tan(phi)")
    return replace(p, name=name, unit="Pa", help=words, key=f"{name}_kPa")


# Laws of slip, by which cohesion changes as friction does.
COHESION_LAWS = tuple(
    replace(law, help=law.help.replace("friction", "cohesion"), parameters=tuple(map(_of_cohesion, law.parameters)))
    for law in LAWS
    if {*law.depends_on} <= {"slip"}
)
