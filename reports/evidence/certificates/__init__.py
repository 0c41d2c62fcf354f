"""Certificates of sums, tight passages and events, in the plane and in space, and of the witnesses
of `minkref verify`, are verified by both checkers, each alone; size, and time to make and to
follow them."""
