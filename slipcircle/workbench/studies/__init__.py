"""Uncertain scenes: distributions, samples, blocks for any executor, and what their results say."""
