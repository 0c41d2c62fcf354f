"""Findings: wrong answers from libraries, programs to show each, a page, and reports to send."""
