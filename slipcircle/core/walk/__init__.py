"""The integrator, in C where it is compiled, otherwise in NumPy."""
