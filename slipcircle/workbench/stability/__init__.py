"""Factors of safety of given circles, and the search for the critical one."""
