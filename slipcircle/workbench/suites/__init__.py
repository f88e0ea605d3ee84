"""Intensity measures of ground-motion records, published regressions, and synthetic records."""
