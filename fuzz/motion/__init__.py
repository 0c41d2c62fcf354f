"""Parts on paths as a setting of `verify`: what is asked about them, and verdicts."""
