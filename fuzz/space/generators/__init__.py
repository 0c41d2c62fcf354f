"""Generators of single polyhedra, a file for each kind."""
