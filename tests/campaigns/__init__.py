"""Runs too long for every day, ``python -m tests.campaigns.NAME``; tests take a sample of each."""
