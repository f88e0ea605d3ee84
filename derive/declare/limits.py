"""Limits of plausible numbers by unit, and ranges in which numbers are usual."""

# Limits of plausible numbers by unit: values beyond are in a wrong unit or mistyped.
LIMITS = {
    "": (1e-12, 1e12),
    "m": (1e-13, 1e20),
    "s": (1e-12, 1e18),
    "m/s": (1e-18, 3e8),
    "m/s^2": (1e-13, 1e15),
    "N/m^3": (1e-3, 1e9),
    "Pa": (1e-9, 1e15),
    "Pa/m": (1e-9, 1e12),
    "Pa s": (1e-12, 1e20),
    "Pa/K": (1e-9, 1e15),
    "J/m^3 K": (1e-3, 1e15),
}
# Ranges that soils have by unit, and SI values of other units in which a number beyond them may have been meant.
USUAL = {"N/m^3": (5e3, 1e5), "Pa": (50.0, 1e8)}
LEAST = {"N/m^3": 1e3, "Pa": 50.0}  # less, except 0, is questioned in all units
PREFIXES = {"": 1.0, "k": 1e3, "M": 1e6}  # of the units in which scene files write numbers
OTHER_UNITS = {"N/m^3": {"kN/m^3": 1e3, "kg/m^3": 9.81}, "Pa": {"kPa": 1e3, "MPa": 1e6}}
QUESTIONED_FRICTION = 2.0  # more is questioned: was that an angle?
USUAL_FRICTION = (0.0174550649282176, 10.0)  # tan(1 deg): less was an angle in rad; more was one in deg
