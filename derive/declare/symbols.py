"""Symbols shared by all stages of the derivation.

They are declared real and nothing more: a stronger assumption (``positive=True``) makes SymPy drop the
limit branch of a ``Piecewise`` without a word.
"""

import sympy as sp

# Geometry of the arc (paper, section 1): half opening angle, polar angles of its ends and of its bisector.
alpha, theta, theta_1, theta_2, theta_m = sp.symbols("alpha theta theta_1 theta_2 theta_m", real=True)
r, u = sp.symbols("r u", real=True)  # of the definitions' integrals: r* = r/R and u = theta - theta_m
Forms = dict[str, sp.Expr]  # by name
a, b, omega_0, t = sp.symbols("a b omega_0 t", real=True)  # d(omega)/dt = a - b*omega**2 (3.16), omega(0) = omega_0


def in_words(form: sp.Expr) -> str:
    """Return a formula as readable text, with powers as ^, products as a blank, and ``x_star`` as x*."""
    text = str(sp.sstr(form))
    text = text.replace("**", "^")
    text = text.replace("*", " ")
    return text.replace("_star", "*")
