"""Scenes are exact and fast: unions of many placed, scaled sums equal CGAL's and the slow engine's,
and a changed scene equals a new one."""
