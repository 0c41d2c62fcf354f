"""Walls around the programs of others."""
