"""A case: two operands and a scale; the list of a run."""
