"""Valid and held scales of paths in space: both routes, static sums at and beside each bound and
the slow engine agree; fits anywhere and traps of prisms are the plane's; the time of large
paths."""
