"""Faults seeded in implementations and adapters are found by `minkref verify`, nearly all within a
minute, or there is a reason why not; which degenerate family shows which."""
