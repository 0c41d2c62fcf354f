"""Generators of cases, a file each."""
