"""Valid scales of paths, held scales, traps and discs in the plane: three routes, the definition at
and beside each bound, enclosing rings, ways out and all pairs agree; their certificates hold; the
times of large paths."""
