"""The verdict on one answer, and its reasons."""
