"""The flow: the declared balance lowered to operations on Taylor series, and the operations themselves."""
