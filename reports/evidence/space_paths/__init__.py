"""Valid scales of paths in space: both routes, static sums at and beside each bound and the slow
engine agree; the time of large paths."""
