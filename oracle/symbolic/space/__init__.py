"""Edges and facets in space."""
