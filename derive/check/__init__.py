"""Certificates: error bounds proved from the definition, independent of the generator."""
