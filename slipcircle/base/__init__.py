"""What everything else stands on: checks, whole files, functions of time, distributions."""

VERSION = "0.1.0"
