"""Certificates: error bounds proved from the definition, trusting nothing of the generator."""
