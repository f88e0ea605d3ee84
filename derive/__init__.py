"""From a definition to source text: SymPy derives, simplifies, stabilises and writes the package `generated`.

Nothing here is imported at run time. What does not hold raises a `ProofError` with the claim, what was found and what
was wanted, and stops the run: the docstrings do not repeat it. The folders, each needing only those above it:

``check``         the error bound of each kernel, from its certificate alone
``declare``       the quantities that are derived, and the effects that a scene may ask for, as data
``algebra``       definition -> closed form -> form without cancellation; balance laws -> motion; each step proved
``code``          SymPy expression -> straight-line `Program` -> its text, and its value as every machine rounds it
``approximate``   closed form -> best polynomials and rationals -> the kernels' programs for each tier of accuracy
``flow``          effects, laws and the balance -> operations on Taylor series, in C, in NumPy, and their derivatives
``generate``      the functions of `generated`, each with its program, its domain and its words -> its files
``judge``         what the paper claims, beside what follows from the definitions; and the hard cases
``build``         C source -> extension module, here and at install time

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
