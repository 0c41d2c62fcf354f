"""Degenerate paths of a part among obstacles, and traps."""
