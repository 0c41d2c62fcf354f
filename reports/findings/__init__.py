"""The wall of findings: wrong answers of libraries, with programs that show them."""
