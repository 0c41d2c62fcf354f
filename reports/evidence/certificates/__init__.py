"""What the parts about certificates share: cases, both checkers, mutants, confirmation."""
