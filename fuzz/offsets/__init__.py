"""Targets asked for sets grown by a disc, and verdicts."""
