"""Proofs for parts on paths, fits and traps."""
