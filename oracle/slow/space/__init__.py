"""Sums of polyhedra from their definition."""
