"""A family of invalid input, and verdicts on its refusal."""
