"""Proofs for sums of polyhedra."""
