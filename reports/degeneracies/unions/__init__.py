"""Cases of unions on the pages of degenerate cases."""
