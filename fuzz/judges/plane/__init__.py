"""Judges for sums and events in the plane."""
