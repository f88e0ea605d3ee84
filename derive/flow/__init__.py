"""The flow: from declared effects and laws to programs on Taylor series, and to the integrator that runs them.

=======  ===============================================  ========================================================
stage    input                                            output
=======  ===============================================  ========================================================
declare  `derive.declare.effects`: effects and laws       symbols of SymPy, by quantity
lower    one declaration (``lowering``, ``fragments``)    `Fragment`: operations on cells and series
link     the fragments of a recipe (``link``)             `Program`: ordered operations
write    fragments, linker, ``series``, ``integrator``    ``generated/{flow,program,series,integrator}``, ``_flow.c``
prove    programs (``linked``), series (``recurrences``)  claims, or `ProofError`
=======  ===============================================  ========================================================

Cells are numbers of a phase of motion, registers are series in time since it began.
"""
