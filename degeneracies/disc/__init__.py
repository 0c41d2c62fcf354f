"""Degenerate sums of a polygon set and a disc."""
