"""The evidence: one script for each claim, run and kept by run.py."""
