"""What can be tested, and how each is asked."""
