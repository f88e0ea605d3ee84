"""From a definition to source text: SymPy derives, simplifies, stabilises and writes the package `generated`.

Nothing here is imported at run time. A claim that does not hold raises a `ProofError` with the claim, the computed and
the required value, and stops the run; docstrings do not repeat this. The folders, each of which imports only those
above it:

===============  ======================================================================================================
``progress``     how much of a long task is done
``check``        the error bound of each kernel, proved from its certificate alone
``declare``      the quantities to derive and the effects that a scene may contain, as data
``algebra``      definition -> closed form -> form without cancellation; balance laws -> motion; each step proved
``code``         SymPy expression -> straight-line `Program` -> its text, and its value as every machine rounds it
``approximate``  closed form -> best polynomials and rationals -> the kernels' programs for each tier of accuracy
``flow``         effects, laws and the balance -> operations on Taylor series; the integrator's text -> C and NumPy
``generate``     the functions of `generated`, each with its program, domain and docstring -> its files
``judge``        what the paper claims, compared with what follows from its definitions; the hard cases
``build``        C source -> extension module, here and at install time
===============  ======================================================================================================

How to add a friction law, an effect or a moment
------------------------------------------------
1. Declare it, as in the examples below. Each declaration is one entry of a tuple; its fields are explained in the
   docstring of its class.
2. Run ``python -m derive``. It proves the declaration, writes `generated` and compiles it, or stops at a claim that
   does not hold and leaves `generated` unchanged.
3. Use it: laws and effects are then in scene files, ``slipcircle plan``, ``slipcircle schema`` and the Python API; a
   moment is a function of `generated`.
4. Test it: a test of `tests/test_extending.py` follows the examples to the letter and shows what to compare with.

A friction law has a formula for the coefficient in `SLIP` or `SPEED` and the parameters of the law, here the declared
symbols of peak, residual and length. The decrease of friction between two slips is derived from it, without
cancellation. At the end of ``LAWS`` in ``derive/declare/effects.py``::

    Law("inverse_square", equation="Fig. 4-1", parameters=(_PEAK, _RESIDUAL, _LENGTH), depends_on=("slip",),
        help="residual + (peak - residual)/(1 + slip/length)^2",
        coefficient=_R + (_P - _R) / (1 + SLIP / _L) ** 2, scale="length"),

A scene file then says ``law = "inverse_square"`` in its table ``[friction]``.

An effect, with what it adds to the balance of momentum (3.11) and with its parameters: a ``pressure`` adds to the
pore pressure, a ``resistance`` opposes the motion (the other terms: `effects.Effect`). A parameter has a name and unit,
open bounds, help, its key in scene files with the number of SI units in one of the key's, the symbol that stands for
it in the balance, and what makes it dimensionless: a formula in VALUE, ALPHA, GRAVITY, REFERENCE and THETA, and, of an
effect that depends on time or speed, also in RADIUS, DENSITY and the effect's other parameters. At the end of
``EFFECTS`` in ``derive/declare/effects.py``::

    Effect("suction", equation="2.20", parameters=(
        Parameter("suction", "Pa", lower=_BELOW_0, upper=_INFINITY, help="mean suction along the slip surface",
                  key="suction_kPa", per_unit=1e3, symbol=sp.Symbol("suction", real=True),
                  dimensionless=VALUE / REFERENCE),), depends_on=(),
           help="suction increases the effective stress (Bishop 1959)", pressure=-sp.Symbol("suction", real=True)),

A scene with the table ``[suction]`` and its key ``suction_kPa`` then has this term; other scenes do not.

A moment of the sliding mass, with its weight in the double integral over r and theta. At the end of ``MOMENTS`` in
``derive/declare/quantities.py``::

    Moment("area", symbol="S*", equation="1.10", weight=r, help="area of the moving mass"),

It is then a function of `generated` in every tier of accuracy, each with its certificate, and a row of ``slipcircle
cost`` and of ``python -m derive hard``, and the tests compare it with quadrature. The first run searches for the
shapes of its approximants (about a minute) and records them. A weight with sin(theta) or cos(theta) needs a name and a
symbol for its amplitude too. Weights other than r**n, +-r**n*sin(theta) and +-r**n*cos(theta), n = 1 to 5, are refused,
or, with ``certified=False``, sampled only.

The tests solve each effect a second time without the code derived here: its term belongs in
``tests/support/taylor.py`` too.
"""
