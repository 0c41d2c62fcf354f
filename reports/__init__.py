"""Pages for people: the conformance report and the evidence."""
