"""Parts of commands for paths, fits and traps."""
