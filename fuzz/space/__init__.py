"""Sums of polyhedra that others made, verified in plain fractions."""
