"""Interface of the integrator, in C if it is compiled and otherwise in NumPy."""
