"""How the cost of each job grows with its input."""
