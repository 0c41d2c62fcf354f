"""What is said about one answer, and why."""
