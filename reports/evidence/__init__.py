"""The evidence: a script for each claim, run and kept by run.py."""
