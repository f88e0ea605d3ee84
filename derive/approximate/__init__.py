"""Approximation of closed forms by polynomials and rational functions for each tier of accuracy."""
