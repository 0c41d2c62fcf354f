"""Sums in the plane are exact: on the paper's pairs and on random ones all routes, CGAL's methods,
the slow engine and points decided from the definition agree, or a witness shows who is wrong."""
