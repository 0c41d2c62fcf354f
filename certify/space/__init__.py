"""Proofs of sums of polyhedra."""
