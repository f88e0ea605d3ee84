"""Compiler from definitions to source text: SymPy derives, simplifies and approximates, and `generated` is written.

Nothing here is imported at run time. A false claim raises a `ProofError` with the claim, the computed and the required
value, and stops the run; docstrings do not repeat this. Each folder imports only folders above it:

===============  ======================================================================================================
``kinds``        types for annotations
``progress``     how much of a long task is done
``stages``       stages of a run and its record: without a change it is not repeated
``check``        the error bound of each kernel, proved from its certificate alone
``declare``      the quantities to derive and the effects that a scene may contain, as data
``algebra``      definition -> closed form; balance laws -> motion; each step proved
``code``         SymPy expression -> straight-line `Program` -> its text, and its value as every machine rounds it
``approximate``  closed form -> best polynomials and rationals -> the kernels' programs for each tier of accuracy
``flow``         effects, laws and the balance -> operations on Taylor series; the integrator's text -> C and NumPy
``generate``     the functions of `generated`, each with its program, domain and docstring -> its files
``judge``        claims of the paper, compared with results of its definitions; the hard cases
``build``        C source -> extension module, here and at install time
``guards``       faults of declarations, before anything is derived
===============  ======================================================================================================

How to add a friction law, an effect or a moment
------------------------------------------------
1. Declare it, as in the examples below. Each declaration is one entry of a tuple; its fields are explained in the
   docstring of its class.
2. Run ``python -m derive``. It looks for faults of the declaration, proves it, imports the new modules in a separate
   process, writes `generated` and compiles it; or it stops with one line and exit status 1, and `generated` is
   unchanged.
3. Use it: laws and effects are then in scene files, ``slipcircle plan``, ``slipcircle schema`` and the Python API; a
   moment is a function of `generated`.
4. Test it: a test of `tests/test_extending.py` follows the examples to the letter and shows suitable comparisons.

A friction law has a formula for the coefficient in `SLIP` or `SPEED` and the parameters of the law, each by a symbol of
its name: here the parameters of softening laws. Slip and speed must be divided by a parameter in their unit, and the
coefficient may nowhere be negative. Its functions are sums, products, powers, exp, log, sin, cos and tanh, and min and
max that change branch at a parameter. The decrease of friction between two slips is derived from it, without
cancellation. At the end of ``LAWS`` in ``derive/declare/effects.py``::

    Law("inverse_square", "residual + (peak - residual)/(1 + slip/length)^2", _SOFTENING,
        coefficient=_R + (_P - _R) / (1 + SLIP / _L) ** 2),

A scene file then says ``law = "inverse_square"`` in its table ``[friction]``.

An effect, with its contributions to the balance of momentum (3.11) and its parameters: a ``pressure`` adds to the pore
pressure, a ``resistance`` opposes the motion (the other terms: `effects.Effect`). A parameter has a name and unit,
help, its key in scene files, which ends in the unit, its symbol in the balance, and its conversion to a dimensionless
number: a formula in VALUE, ALPHA, GRAVITY, RADIUS, DENSITY, REFERENCE, THETA, STRENGTH (by which a strength is
multiplied) and the effect's other parameters. It is at least 0 unless ``lower`` and ``upper`` are given; with
``lower=0.0`` it is above 0. At the end of ``EFFECTS`` in ``derive/declare/effects.py``::

    Effect("suction", "suction increases the effective stress", (
        Parameter("suction", "Pa", "mean suction along the slip surface", "suction_kPa",
                  symbol=sp.Symbol("suction", real=True), dimensionless=VALUE / REFERENCE),),
           source="Bishop (1959)", pressure=-sp.Symbol("suction", real=True)),

A scene with the table ``[suction]`` and its key ``suction_kPa`` then has this term; other scenes do not.

A moment of the sliding mass, with its weight in the double integral over r and theta. At the end of ``MOMENTS`` in
``derive/declare/quantities.py``::

    Moment("area", symbol="S*", weight=r, help="area of the moving mass"),

It is then a function of `generated` in every tier of accuracy, each with its certificate, and a row of ``slipcircle
cost`` and of ``python -m derive hard``, and the tests compare it with quadrature. The shapes of its approximants are
stated in ``derive/approximate/shapes.json``. A weight with sin(theta) or cos(theta) needs a name and a symbol for its
amplitude too; the moment itself is then a function of both ends. Weights other than r**n, +-r**n*sin(theta) and
+-r**n*cos(theta), n = 1 to 5, are refused.

An ``equation`` is a number in the paper; a declaration without it has a ``source`` or none.

The tests solve each effect a second time without the code derived here: its term belongs in
``tests/support/taylor.py`` too.
"""
