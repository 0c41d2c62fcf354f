"""The radii at which a sum with a disc changes, and what happens there, are those of CGAL, of
Boost.Polygon, of computer algebra and of a judge of exact numbers; between them nothing changes."""
