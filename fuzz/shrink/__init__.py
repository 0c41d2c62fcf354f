"""The smallest case that still shows a fault."""
