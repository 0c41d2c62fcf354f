"""Streams, documents, files of output, signals and exits of commands."""
