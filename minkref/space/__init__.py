"""Operands and sums in space, for the commands that take them."""
