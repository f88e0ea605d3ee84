"""Shared by the workbench: quantities of results, distributions, files, markup."""
