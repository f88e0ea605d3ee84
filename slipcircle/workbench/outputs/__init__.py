"""What is made of a motion: tables, traces, pictures, reports and files."""
