"""Certificates changed in one place are refused by both checkers, or what they still say is true by
another engine."""
