"""Benchmarks of the dynamic update: what `minkref bench` runs, and the evidence."""
