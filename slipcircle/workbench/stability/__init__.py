"""Factors of safety of given circles, and search for the critical circle."""
