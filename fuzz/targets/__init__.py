"""Targets that can be tested, and how each target is asked."""
