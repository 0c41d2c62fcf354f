"""The one grammar for numbers as texts in answers and declarations from others
(docs/adapter-protocol.md)."""

from __future__ import annotations

import re
from fractions import Fraction

LONGEST_NUMBER = 100_000  # characters
GRAMMAR = "n, n/d, or a decimal with an exponent of four digits at most, in ASCII digits"
# Each part reads in only one way: refusing a long text that is no number takes linear time.
_NUMBER = re.compile(
    r"[+-]?([0-9]+(\.[0-9]*)?|\.[0-9]+)([eE][+-]?[0-9]{1,4})?|[+-]?[0-9]+/0*[1-9][0-9]*"
)


def is_number(text: str) -> bool:
    return len(text) <= LONGEST_NUMBER and _NUMBER.fullmatch(text) is not None


def number_of(text: str) -> Fraction:
    """Reads a number exactly. ValueError for any other text."""
    if not is_number(text):
        raise ValueError(f"{text[:40]!r} is not a number: {GRAMMAR}")
    return Fraction(text)
