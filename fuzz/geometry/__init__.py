"""Plain geometry for the plane and space, with fractions and integers."""
