"""Ranges of scales, and the cells of all places of a segment at them."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import inf
from typing import Any

from minkref.certify.moving_parts import Corner, Gap, cut, levels
from minkref.scale_ranges import ScaleRange

ALL = ScaleRange(Fraction(0), None, False, False)
#: Just below a scale; True: just above it.
Cut = tuple[Any, bool]


def cuts(scales: ScaleRange) -> tuple[Cut, Cut]:
    """Where a range begins and ends."""
    low = (scales.low, not scales.low_in)
    return low, (inf, False) if scales.high is None else (scales.high, scales.high_in)


def between(low: Cut, high: Cut) -> ScaleRange | None:
    """None where nothing is between."""
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
    """As certificates have it."""
    high = None if scales.high is None else str(scales.high)
    return {
        "from": str(scales.low), "to": high, "from_in": scales.low_in, "to_in": scales.high_in,
    }  # fmt: skip


def cell(scales: ScaleRange) -> list[Corner]:
    """A segment at all scales of a range, counter-clockwise."""
    s, w = scales.low.as_integer_ratio()
    S, W = (1, 0) if scales.high is None else scales.high.as_integer_ratio()
    return list(dict.fromkeys([(0, s, w), (w, s, w), (W, S, W), (0, S, W)]))


def is_outside(corners: Sequence[Corner], scales: ScaleRange) -> bool:
    """Whether all corners are at one end of a range that does not belong to it."""
    ends = []
    if not scales.low_in:
        ends.append(scales.low.as_integer_ratio())
    if not scales.high_in:
        ends.append((1, 0) if scales.high is None else scales.high.as_integer_ratio())
    return any(all(s * W == S * w for _, s, w in corners) for S, W in ends)


def left_of(corners: Sequence[Corner], gap: Gap, scales: ScaleRange, contact: str) -> list[Corner]:
    """What of a cell is not held apart: nothing, or a polygon with a place at one of the scales."""
    at = levels(gap, corners)
    if min(at) > 0 or (contact == "allowed" and min(at) == 0):
        return []
    rest = cut(corners, gap)
    return [] if is_outside(rest, scales) else rest
