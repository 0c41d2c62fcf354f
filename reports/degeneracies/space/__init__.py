"""Pages about families: pictures and rows for their cases."""
