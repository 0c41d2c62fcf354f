"""Concave features of a growing disc, verified: questions, cases and verdicts."""
