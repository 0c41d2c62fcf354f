"""Invalid input: a family of it, and verdicts on how it is refused."""
