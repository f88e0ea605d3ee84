"""Suites of records: intensity measures of a record, and statistics of the displacements that a suite causes."""
