"""Judges for parts on paths, and for traps."""
