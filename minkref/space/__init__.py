"""Operands and sums in space for commands."""
