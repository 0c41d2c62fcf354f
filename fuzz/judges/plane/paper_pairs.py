"""Scales at which two edges of a convolution meet, by the symbolic oracle."""

from __future__ import annotations

from minkref.fuzz.judges.plane.segment_draws import build
from minkref.oracle.symbolic.moving import MovingSegment
from minkref.oracle.symbolic.pairs import contact_set
from minkref.oracle.symbolic.rational import text

Bounds = tuple[str | None, str | None] | None
Numbers = tuple[str, tuple[int, ...]]  # (kind, (px, py, qx, qy, dx, dy)): from s p + q along d


def contact_interval(a: Numbers, b: Numbers) -> Bounds:
    """The interval's bounds, None for 0 and for no end; None if the edges never meet."""
    return contact_bounds(_segment(a), _segment(b))


def contact_bounds(a: MovingSegment, b: MovingSegment) -> Bounds:
    """Bounds on the scales at which two segments meet."""
    found = contact_set(a, b)
    if found is None:
        return None
    return (
        None if found.low is None else text(found.low),
        None if found.high is None else text(found.high),
    )


def _segment(numbers: Numbers) -> MovingSegment:
    kind, (px, py, qx, qy, dx, dy) = numbers
    return build(kind, (px, py), (qx, qy), (dx, dy))
