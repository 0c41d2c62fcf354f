"""Hostile adapters, functions and files are refused or judged, with the sandbox and without it, and
leave nothing behind; what the sandbox costs."""
