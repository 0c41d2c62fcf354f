"""Sums with a disc."""
