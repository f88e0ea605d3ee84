"""Computing time and error of the alternative ways to compute a result."""
