"""Implicit steps, for brakes that explicit steps cannot follow."""
