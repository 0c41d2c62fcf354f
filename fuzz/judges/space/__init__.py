"""Judges of sums of polyhedra."""
