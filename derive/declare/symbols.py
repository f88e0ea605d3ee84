"""The symbols every stage of the derivation shares.

They are declared real and nothing more: a stronger assumption (``positive=True``) makes SymPy drop the
limit branch of a ``Piecewise`` without a word.
"""

import sympy as sp

# Geometry of the arc (paper, section 1): half opening angle, polar angles of its ends and of its bisector.
alpha = sp.Symbol("alpha", real=True)
theta = sp.Symbol("theta", real=True)
theta_1 = sp.Symbol("theta_1", real=True)
theta_2 = sp.Symbol("theta_2", real=True)
theta_m = sp.Symbol("theta_m", real=True)

# Integration variables of the definitions: r* = r/R and u = theta - theta_m.
r = sp.Symbol("r", real=True)
u = sp.Symbol("u", real=True)

# Motion, dimensionless: d(omega)/dt = a - b*omega**2 (3.16), omega(0) = omega_0.
a = sp.Symbol("a", real=True)
b = sp.Symbol("b", real=True)
omega_0 = sp.Symbol("omega_0", real=True)
t = sp.Symbol("t", real=True)


def in_words(form: sp.Expr) -> str:
    """A form as one reads it: powers raised, products by a blank, ``x_star`` as x*."""
    return str(sp.sstr(form)).replace("**", "^").replace("*", " ").replace("_star", "*")
