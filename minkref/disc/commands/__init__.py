"""Commands on sums with a disc."""
