"""Invalid input, one family for each refusal: what is damaged, where, and what has to be named."""
