"""The families in space: what is degenerate about convex P, Q and a scaling, a module a subject."""
