"""Proofs of sums in the plane, of events and of tight passages."""
