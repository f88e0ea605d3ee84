"""Symbolic derivation: from definitions to closed forms, each step proved."""
