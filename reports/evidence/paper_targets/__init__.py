"""The paper's own programs, as targets, before others: its sums in MPFR beside CGAL's static sums,
its critical scales beside computer algebra's, and all of it on cases of the corpus; each difference
is settled by a point or a scale."""
