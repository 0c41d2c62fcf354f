"""What sums, events and convex updates in space cost, beside CGAL, Manifold and the paper's Table
2, in one run each."""
