"""The paper's way to the events of two edges and of two facets at 24 to 256 bits, as printed and as
corrected: events that are missed, invented, misplaced; in rational numbers and certified intervals
none."""
