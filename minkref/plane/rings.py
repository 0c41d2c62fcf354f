"""Closed lists, which have no first member."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from _typeshed import SupportsRichComparisonT


def from_least(ring: Sequence[SupportsRichComparisonT]) -> list[SupportsRichComparisonT]:
    """Start a closed list at its least member: equal for equal closed lists."""
    first = ring.index(min(ring))
    return [*ring[first:], *ring[:first]]
