"""Verdicts on single answers, and their reasons."""
