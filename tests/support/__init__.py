"""Shared parts of tests: quadrature of the definitions, Taylor series, reference data, scenes, readers of output."""
