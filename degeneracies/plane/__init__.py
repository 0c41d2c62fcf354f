"""The families of the plane: degenerate operands P, Q and scale, one module a subject."""
