"""What sums, updates, the index and verified cases in the plane cost, beside CGAL and beside the
paper's Table 1, in one run each."""
