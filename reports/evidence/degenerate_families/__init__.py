"""The corpus of degenerate cases is made again to the byte; new members of every family are
verified by both checkers; how often doubles fail on them."""
