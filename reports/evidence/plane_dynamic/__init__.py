"""A step of the dynamic sum gives what a static sum gives, computes nothing from scratch, and
counts the events that it crosses."""
