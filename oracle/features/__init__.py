"""Judges features of a growing disc: medial axis by triples of sites, merge tree, bars, tracks."""

from .judge import Judge

__all__ = ["Judge"]
