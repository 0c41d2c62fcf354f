"""The documentation on trial: links, and shown code."""
