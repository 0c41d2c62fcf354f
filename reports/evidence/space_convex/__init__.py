"""Sums of convex polyhedra under non-uniform scaling, updated or from scratch, are CGAL's hull of
all sums of vertices, and their certificates hold."""
