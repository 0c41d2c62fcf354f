"""Invalid input, one family for each refusal: the damage, its place, and the words to name."""
