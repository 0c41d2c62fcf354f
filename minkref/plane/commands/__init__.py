"""Parts of commands for sums in the plane."""
