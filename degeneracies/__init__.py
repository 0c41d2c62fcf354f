"""Degenerate test cases, each with proofs of its degeneracy and its expected result."""
