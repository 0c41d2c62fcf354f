"""Proofs for sums in the plane, events and tight passages."""
