"""Events of two parallel moving segments. docs/definitions.md, Critical scales."""

from __future__ import annotations

from itertools import product

from .moving import MovingSegment, Point, cross, parallel
from .pairs import Event, bounds, contact_set, end_meetings
from .rational import Rational, cells
from .standing import common, minus


def on_one_line(first: MovingSegment, second: MovingSegment, s: Rational) -> bool:
    """Tell whether parallel segments lie on one line at scale s."""
    return cross(minus(second.at(s)[0], first.at(s)[0]), first.direction()) == 0


def always_on_one_line(first: MovingSegment, second: MovingSegment) -> bool:
    """Tell whether parallel segments lie on one line at every scale. Their lines' distance is
    linear in s (the solution of `t=0` has degree 1), so two scales decide."""
    return on_one_line(first, second, Rational(1)) and on_one_line(first, second, Rational(2))


def parallel_events(first: MovingSegment, second: MovingSegment) -> list[Event]:
    """Find the events of two parallel segments, ascending by (s, change, at). Exact; constant time.

    Lines that coincide at one scale give `touch` or `overlap` if the segments share a point or a
    segment there. Lines that always coincide give `birth` and `death` where the segments start and
    stop sharing points, and `swap` where ends of both pass each other meanwhile. Raises ValueError
    unless the segments are parallel."""
    if not parallel(first, second):
        raise ValueError("the segments are not parallel")
    found = contact_set(first, second)
    if not always_on_one_line(first, second):
        events = bounds(found, first, second)
        return [Event(e.s, "overlap" if e.to else e.change, e.at, e.to) for e in events]
    # Contact exists just below and just above a passing, so a passing never ends the contact.
    events = [*bounds(found, first, second), *passings(first, second)]
    return sorted(events, key=lambda event: (event.s, event.change, event.at))


def passings(first: MovingSegment, second: MovingSegment) -> list[Event]:
    """Find where ends of two segments, always on one line, pass each other, while the segments
    share a point just below and just above. One event per point."""
    marks, inner = cells(end_meetings(first.kind + second.kind, first.data + second.data))
    found = []
    for i, mark in enumerate(marks):
        below, above = inner[i], inner[i + 1]
        if not all(common(first.at(s), second.at(s)) for s in (below, above)):
            continue
        places: set[Point] = set()
        for t, u in product((0, 1), repeat=2):
            sides = [lead(first, second, t, u, s) for s in (below, mark, above)]
            if sides[1] == 0 and sides[0] * sides[2] < 0:
                places.add(first.at(mark)[t])
        found += [Event(mark, "swap", place) for place in sorted(places)]
    return found


def lead(first: MovingSegment, second: MovingSegment, t: int, u: int, s: Rational) -> Rational:
    """Measure along the first segment how far its end t is ahead of the second's end u."""
    x, y = minus(first.at(s)[t], second.at(s)[u]), first.direction()
    return x[0] * y[0] + x[1] * y[1]
