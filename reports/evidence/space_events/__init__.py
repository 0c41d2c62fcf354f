"""The events of two, three and four facets in space are those of computer algebra, of all pairs of
facets, and of arrangements at single scales."""
