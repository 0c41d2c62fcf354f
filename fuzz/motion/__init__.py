"""Parts on paths as a setting of `verify`: questions about them, and verdicts."""
