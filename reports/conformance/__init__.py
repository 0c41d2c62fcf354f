"""The conformance report: verdicts, pictures, and a page for each kind of finding."""
