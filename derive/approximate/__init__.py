"""From a closed form to polynomials and rationals for each tier of accuracy."""
