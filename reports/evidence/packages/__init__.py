"""The wheel works on a bare machine, the sources in another build, and a fresh clone with the
README's commands alone."""
