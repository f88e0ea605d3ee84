"""Scenes as they come in: TOML files, their keys, records and pulses."""
