"""The page of a part on a path: place and scale, and the polygons in which it collides."""
