"""Erosions, openings, closings, no-fit and inner-fit are right, with all remnants and exact fits:
by the slow engine, place by place from the definition, by CGAL's sums of what is outside, and by
laws; by a disc, by exact distances."""
