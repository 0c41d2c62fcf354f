"""Degenerate sets to unite."""
