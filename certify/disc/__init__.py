"""Certificates: discs touching a set from outside, bridges."""
