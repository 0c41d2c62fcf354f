"""The audit's entries, by section of the paper."""
