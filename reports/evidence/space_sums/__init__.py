"""Sums of polyhedra of any shape agree by both routes, with CGAL's Nef polyhedra, with Manifold's
volumes and at points of the slow engine, keep the laws of sums, and are written as closed
triangles."""
