"""Walls around foreign programs."""
