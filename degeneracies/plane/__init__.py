"""The families of the plane: what is degenerate about P, Q and a scale, one module a subject."""
