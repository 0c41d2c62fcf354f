"""Certificates of discs that touch a set from outside, and of its bridges."""
