"""Measures of records: intensities, spectra, published regressions, and synthetic records."""
