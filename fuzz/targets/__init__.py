"""Targets to test, and how to ask each."""
