"""Sets and sums in the plane: operands, values, scales."""
