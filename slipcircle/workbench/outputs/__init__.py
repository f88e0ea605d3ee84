"""Conversions of results to tables, pictures, HTML pages, reports and CSV."""
