"""Basics: checks, numbers as text, functions of time."""

VERSION = "0.1.0"
