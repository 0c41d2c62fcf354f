"""Each fault planted in the reference, in the plane, in space and in sums with a disc, is caught by
a judge, a law or a test."""
