"""Judges for sums of polyhedra."""
