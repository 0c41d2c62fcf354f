"""Sums in the plane with a factor for each axis are exact: on random pairs, a third of them
degenerate, all routes agree with the slow engine and with CGAL; certificates are verified by all
checkers, and forged ones refused; updates of convex polygons are the static sums, and cost what
changes."""
