"""Symbolic derivation: from definitions to closed and stable forms, each step proved."""
