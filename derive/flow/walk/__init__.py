"""How a mass moves and comes to rest: the integrator of lanes, in restricted Python.

The balance of momentum about the centre of the arc, made dimensionless with t* = t sqrt(g/R) and divided by the
dimensionless moment of inertia Theta*, in the direction of travel:

    d omega*/dt* = drive - mu (press + polar omega*^2 - water) - other resistance,    d phi/dt* = omega*

drive     weight and shaking along the arc: W (sin(psi) + k_h cos(psi)), psi the dip of the chord, which turns with phi
press     their normal force on it, from which the centripetal term and water pressure add and take
mu        friction, of slip, speed or time; no friction where contact is lost, that is where the bracket is below zero
other     cohesion, drag, viscosity

A lane is one motion: its numbers, "cells", are attributes (`derive.flow.layout` says what they hold). The program of a
scene has the terms of its effects only, as operations on series, in increments since the lane's phase began. A step is
a Taylor series in time, as long as its radius of convergence allows; events are roots of series that the step has.

step       a moving lane goes along its series to the first event, and what follows there: standstill, an upright chord,
           lift-off and landing, edges of tables, the end time
rest       a resting lane waits for the next break of what changes with time, or for the root of its net moment
phases     stick or slip at a standstill; the numbers of the phase that begins; greatest speed and rotation
records    samples that a resting or gliding mass passes without series
tables     the piece of each table in which a lane is
series     the series of a step, and their radius of convergence
roots      polynomials of many lanes: values and roots
one_lane   what this text means for one lane, as plain Python with numbers of any kind

From the text `derive.flow.restricted` writes the integrators in C and in NumPy, which share each statement. Functions
of `Lanes` are about all lanes of a batch, with vectors V of numbers and masks M; those of a `Lane` about one. An `if`
on a mask runs its body for each lane in which it holds. Where a function of lanes has a mask `here`, what it assigns to
a cell is assigned there.
"""

TEXT = ("roots", "tables", "series", "phases", "records", "step", "rest")  # modules, each uses the ones before
