"""The events of pairs of edges and of triples are all there, once and in order: by computer
algebra, by orientation signs at single scales, and as many as the paper's pairs have."""
