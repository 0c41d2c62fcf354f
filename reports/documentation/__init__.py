"""The documentation on trial: its links, and the code that it shows."""
