"""Degenerate test cases, each with a proof of what is degenerate and of what is expected."""
