"""A derived case that does not exist."""

from __future__ import annotations


class NoCase(Exception):
    """Says why; the run goes on without the case."""
