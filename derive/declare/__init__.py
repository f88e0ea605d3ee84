"""What is derived, declared once as data."""
