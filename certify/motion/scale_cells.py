"""Ranges of scales, and parts of cells within a range."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import inf
from typing import Any

from minkref.certify.motion.moving_parts import Corner, Gap, cut, ends_of, levels
from minkref.motion.scale_ranges import ScaleRange

ALL = ScaleRange(Fraction(0), None, False, False)
#: Just below a scale; True: just above it.
Cut = tuple[Any, bool]


def cuts(scales: ScaleRange) -> tuple[Cut, Cut]:
    """Where a range begins and ends."""
    low = (scales.low, not scales.low_in)
    return low, (inf, False) if scales.high is None else (scales.high, scales.high_in)


def between(low: Cut, high: Cut) -> ScaleRange | None:
    """Returns the scales between two cuts, or None."""
    if not low < high:
        return None
    end = None if high[0] == inf else Fraction(high[0])
    return ScaleRange(Fraction(low[0]), end, not low[1], high[1])


def common(one: ScaleRange, other: ScaleRange) -> ScaleRange | None:
    (a, b), (c, d) = cuts(one), cuts(other)
    return between(max(a, c), min(b, d))


def is_within(one: ScaleRange, other: ScaleRange) -> bool:
    (a, b), (c, d) = cuts(one), cuts(other)
    return c <= a and b <= d


def document(scales: ScaleRange) -> dict[str, Any]:
    """Returns the range as certificates write ranges."""
    high = None if scales.high is None else str(scales.high)
    return {
        "from": str(scales.low), "to": high, "from_in": scales.low_in, "to_in": scales.high_in,
    }  # fmt: skip


def is_outside(corners: Sequence[Corner], scales: ScaleRange) -> bool:
    """Whether all corners lie at one end of a range that does not belong to it."""
    is_in = scales.low_in, scales.high_in
    ends = [end for end, told in zip(ends_of(scales), is_in, strict=True) if not told]
    return any(all(s * W == S * w for _, s, w in corners) for S, W in ends)


def left_of(corners: Sequence[Corner], gap: Gap, scales: ScaleRange, contact: str) -> list[Corner]:
    """The part of a cell not held apart: none, or a polygon with a place at one of the scales."""
    at = levels(gap, corners)
    if min(at) > 0 or (contact == "allowed" and min(at) == 0):
        return []
    rest = cut(corners, gap)
    return [] if is_outside(rest, scales) else rest
