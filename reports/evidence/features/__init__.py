"""Features of a growing disc: the alpha-shape has the components and holes of the closed sum, and
its regions tile the rest of the convex hull; the rest material is what a closing adds."""
