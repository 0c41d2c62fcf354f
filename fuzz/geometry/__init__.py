"""Plain geometry of the plane and of space, in fractions and integers."""
