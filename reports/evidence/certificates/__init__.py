"""Certificates of sums, tight passages and events, in the plane and in space, are verified by both
checkers, each alone; their size, and the time to make and to follow them."""
