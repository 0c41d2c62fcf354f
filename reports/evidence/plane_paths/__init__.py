"""Valid scales of paths, held scales and traps in the plane: three routes, the definition at and
beside each bound, enclosing rings and ways out agree; their certificates hold; the time of a large
path."""
