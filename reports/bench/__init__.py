"""Benchmarks of the dynamic update, for `minkref bench` and the evidence."""
