"""Shared parts of the workbench: quantities of results, distributions, files and markup."""
