"""Pages about the degenerate families, with drawings."""
