"""Judges of parts on paths, and of traps."""
