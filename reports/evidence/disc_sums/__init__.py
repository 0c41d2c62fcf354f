"""Sums with a disc are CGAL's exact offsets, curve by curve, by both routes; the index of all radii
gives the static sum at any radius; certificates hold, and no false one; how quick all are."""
