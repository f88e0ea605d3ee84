"""From a definition to source text: SymPy derives, simplifies, stabilises and writes the package `generated`.

Nothing here is imported at run time. What does not hold raises a `ProofError` with the claim, what was found and what
was wanted, and stops the run: the docstrings do not repeat it. The stages, in the order in which `python -m derive`
walks them:

``quantities``, ``symbols``   what is derived, declared once as data
``integrate``                 definition -> closed form, each step proved
``rules``, ``remainders``     closed form -> form without cancellation, by named rules, each step proved
``minimax``, ``shapes``       closed form -> best polynomials and rationals, in the shapes that are recorded
``programs``, ``search``      shapes -> the kernels' programs for each tier of accuracy; and where the shapes come from
``dynamics``                  balance laws -> equation of motion -> its solution in time, proved
``effects``                   what a scene may ask for, declared once as data
``growth``                    how the moments of an arc grow with its half angle, proved
``fragments``, ``lowering``   effects, laws and the balance -> operations on Taylor series: the parts of flow programs
``series``, ``tangents``      what these operations do, proved, in C and in NumPy; and their derivatives
``program``, ``exact``        SymPy expression -> straight-line `Program`, and its value as every machine rounds it
``functions``                 the functions of `generated`: each with its program, its domain and its words
``emit``, ``emit_c``          `Program` -> NumPy source, and C source of ufunc loops
``certificates``              the error bound of each kernel, proved by ``certify``, ``truth`` and ``rounding``
``write``                     source -> the files of `generated`, atomically, or a diff against them
``build``, ``build_hook``     C source -> extension module, here and at install time

Beside them stands ``judge``: what follows from the definitions (``appendices``, ``mechanics``, ``section``,
``postulates``), what the ``paper`` claims, and ``verify``, which compares; ``hard`` measures the hard cases.

To add something, declare it, then run ``python -m derive``: it proves the declaration, writes `generated`, and from
there it is in plans, scene files and `slipcircle schema`. The tests follow what stands here to the letter.

A friction law, ``coefficient`` its formula; its fall from one slip to a greater one, without cancellation, follows.
At the end of ``LAWS`` in ``derive/declare/effects.py``::

    Law("inverse_square", "Fig. 4-1", (_PEAK, _RESIDUAL, _LENGTH), ("slip",),
        "residual + (peak - residual)/(1 + slip/length)^2", _R + (_P - _R) / (1 + SLIP / _L) ** 2, "length"),

An effect: what it adds to the balance of momentum (the fields of `effects.Effect`), and its parameters. What makes a
parameter dimensionless is a formula in VALUE, ALPHA, GRAVITY, REFERENCE and THETA, where the effect depends on time or
speed also in RADIUS, DENSITY and the effect's other parameters. At the end of
``EFFECTS`` in ``derive/declare/effects.py``::

    Effect("suction", "2.20", (
        Parameter("suction", "Pa", _BELOW_0, _INFINITY, "mean suction in the pores along the slip surface",
                  "suction_kPa", 1e3, sp.Symbol("suction", real=True), VALUE / REFERENCE),), (),
           "suction presses the grains together (Bishop 1959)", pressure=-sp.Symbol("suction", real=True)),

A moment of the mass: its weight in the double integral. At the end of ``MOMENTS`` in ``derive/declare/quantities.py``::

    Moment("area", "S*", "1.10", r, "area of the moving mass"),

It is then a function of `generated` in every tier, each with its certificate, and a row of ``slipcircle cost`` and of
``python -m derive hard``, and the tests compare it with quadrature. The first run searches for the shapes of its
approximants (a minute) and records them. A weight with sin(theta) or cos(theta) names its amplitude too. Other weights
than r**n, +-r**n*sin(theta) and +-r**n*cos(theta), n = 1 to 5, are refused, or with ``certified=False`` sampled only.

Of an effect the tests ask for the same again in words of their own, its term in ``tests/taylor.py``.
"""
