"""The plane as a setting of `verify`: its cases, what is asked about them, and verdicts."""
