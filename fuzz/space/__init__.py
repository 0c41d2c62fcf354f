"""Foreign sums of polyhedra, verified in plain fractions."""
