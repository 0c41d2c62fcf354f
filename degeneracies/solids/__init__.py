"""Degenerate families of polyhedra of any shape in space."""
