"""Sums with a disc about the origin."""
