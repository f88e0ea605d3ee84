"""Output of results: tables, traces, pictures, reports and files."""
