"""The entries, by section of the paper."""
