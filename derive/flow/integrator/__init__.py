"""Integrator of lanes, in restricted Python: how a mass moves and comes to rest.

The balance of angular momentum about the centre of the arc, with t* = t sqrt(g/R), divided by the dimensionless moment
of inertia Theta*, reads in the direction of travel:

    d omega*/dt* = drive - mu (press + polar omega*^2 - water) - other resistance,    d phi/dt* = omega*

drive     weight and shaking along the arc: W (sin(psi) + k_h cos(psi)), where the dip of the chord psi turns with phi
press     normal force of weight and shaking, to which the centripetal term is added and from which water pressure is
          subtracted
mu        friction as a function of slip, speed or time; 0 where contact is lost, that is where the bracket is negative
other     cohesion, drag, viscosity

A lane is one motion. Its numbers, called cells, are attributes (see `derive.flow.layout`). The program of a scene
contains only the terms of its effects, as operations on series, in increments since the lane's phase began. A step is a
Taylor series in time or in the rotation, as long as its radius of convergence allows. Events are roots of the step's
series. Under rate weakening the variable of a step is tau instead of the time (see `derive.flow.pace`).

step       steps of moving lanes to the first event, and the consequences of events: standstill, an upright chord,
           lift-off and landing, edges of tables, the end time
recurrence  series of omega^2 in the rotation without products of series
rotation   steps in powers of the rotation, with omega^2 as the state
energy     closed form of omega^2 in the rotation
hyperbolic  the same under hyperbolically softening friction
softening  the same under exponentially softening friction, and the duration of both
waves      time in phases that have a closed form
swing      phases from rest that have a closed form
rest       lanes at rest, until the next break of a function of time or the root of the net moment
phases     stick or slip at a standstill; the numbers of the phase that begins; greatest speed and rotation
records    samples that a resting or gliding mass passes without series
shaken     samples that a turning mass passes by short series
tables     the piece of each table that applies to a lane
series     the series of a step, and how long they allow it to be
roots      polynomials of many lanes: values and roots
one_lane   definitions that execute the text for one lane, as plain Python with numbers of any kind

`derive.flow.restricted` writes the integrators in C and in NumPy from this text, statement by statement. Functions of
`Lanes` work on all lanes of a batch side by side, with vectors V of numbers and masks M. If a function has a mask
`here`, assignments to cells apply to these lanes. Without such a lane, a function that returns nothing does nothing.
"""

# Modules, each uses only earlier modules.
FROM_REST = ("energy", "hyperbolic", "softening", "waves", "swing")
TEXT = (
    "roots",
    "tables",
    "series",
    "phases",
    "records",
    "step",
    "shaken",
    "recurrence",
    "rotation",
    *FROM_REST,
    "rest",
)
