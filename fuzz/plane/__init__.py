"""The plane as a setting of `verify`: cases, questions about them, and verdicts."""
