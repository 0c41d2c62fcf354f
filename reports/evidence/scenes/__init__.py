"""Scenes are exact: the union of many placed, scaled sums is that of CGAL and of the slow engine, a
change gives what a scene made anew gives, and it is fast."""
