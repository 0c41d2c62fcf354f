"""Parts on paths, fits and traps: values and texts."""
