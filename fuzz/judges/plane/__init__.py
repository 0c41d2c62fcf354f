"""Judges of sums and events in the plane."""
