"""Judges of sums with a disc."""
