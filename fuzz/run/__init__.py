"""A run: workers, verdicts into a matrix and findings."""
