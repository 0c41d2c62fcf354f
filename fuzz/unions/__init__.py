"""Targets asked for unions in the plane, and verdicts."""
