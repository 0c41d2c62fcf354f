"""Contact of two moving segments: the exact set of scales, and its events.

The general solutions' roots are candidates; looking at the two segments at each candidate, and
between neighbours, decides which scales belong to the set. This suffices: contact begins and ends
only where one segment's end lies on the other's line (for parallel segments on one line: on the
other's end), and all these scales are candidates.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import product

from .moving import MovingSegment, Point, parallel
from .rational import Rational, cells
from .solutions import root, solution
from .standing import Common, common

CONDITIONS = ("t=0", "t=1", "u=0", "u=1")


class ContradictionError(AssertionError):
    """An answer ruled out by mathematics: this package is faulty."""


@dataclass(frozen=True, slots=True)
class Interval:
    """Scales from `low` to `high`, both ends included; None for 0 and for no bound."""

    low: Rational | None
    high: Rational | None


@dataclass(frozen=True, slots=True)
class Event:
    """A change at scale `s`, at the point `at`, or along the segment from `at` to `to`."""

    s: Rational
    change: str
    at: Point
    to: Point | None = None


def end_conditions(kinds: str, data: tuple[Rational, ...]) -> list[Rational]:
    """Find the scales at which one segment's end comes to the other's line. Exact.

    `kinds` and `data` describe both segments, which may have length zero."""
    return [
        scale
        for condition in CONDITIONS
        for scale in root(*solution(f"pair {kinds} {condition}", "ab")(*data))
    ]


def end_meetings(kinds: str, data: tuple[Rational, ...]) -> list[Rational]:
    """Find the scales at which parallel segments have level ends. Exact."""
    return [
        scale
        for t, u in product((0, 1), repeat=2)
        for scale in root(*solution(f"ends {kinds} t={t} u={u}", "ab")(*data))
    ]


def candidates(first: MovingSegment, second: MovingSegment) -> list[Rational]:
    """Find scales that include all scales at which two segments' contact can begin or end."""
    kinds, data = first.kind + second.kind, first.data + second.data
    found = end_conditions(kinds, data)
    return found + end_meetings(kinds, data) if parallel(first, second) else found


def intervals(marks: list[Rational], member: Callable[[Rational], bool]) -> Iterator[Interval]:
    """Find the maximal intervals of a closed set of scales with ends among `marks`. Raises
    ContradictionError if the set is not closed."""
    ordered, inner = cells(marks)
    at = [member(mark) for mark in ordered]
    between = [member(scale) for scale in inner]
    for i, inside in enumerate(at):
        if not inside and (between[i] or between[i + 1]):
            raise ContradictionError(f"contact near s = {ordered[i]} and not there")
    low: Rational | None = None
    running = between[0]
    for i, mark in enumerate(ordered):
        if not running and at[i]:
            low, running = mark, True
        if running and not between[i + 1]:
            yield Interval(low, mark)
            running = False
    if running:
        yield Interval(low, None)


def contact_set(first: MovingSegment, second: MovingSegment) -> Interval | None:
    """Find all s > 0 at which the two segments share a point; None without such s.

    Exact; constant time. The set is an interval: {(s, t, u): X(s, t) = Y(s, u)} becomes convex with
    coordinates s, s t or t, s u or u. Raises ContradictionError for several intervals."""
    found = list(
        intervals(
            candidates(first, second), lambda s: common(first.at(s), second.at(s)) is not None
        )
    )
    if len(found) > 1:
        raise ContradictionError(f"contact on several intervals: {found}")
    return found[0] if found else None


def pair_events(first: MovingSegment, second: MovingSegment) -> list[Event]:
    """Find birth, death or touch of two segments' contact, ascending. Raises ValueError for
    parallel segments, which have other events."""
    if parallel(first, second):
        raise ValueError("the segments are parallel")
    return bounds(contact_set(first, second), first, second)


def bounds(found: Interval | None, first: MovingSegment, second: MovingSegment) -> list[Event]:
    """Return the events at a contact interval's ends."""

    def event(scale: Rational, change: str) -> Event:
        shared: Common = common(first.at(scale), second.at(scale))
        if shared is None:
            raise ContradictionError(f"no contact at the end s = {scale} of an interval")
        return Event(scale, change, shared[0], shared[1] if shared[0] != shared[1] else None)

    if found is None:
        return []
    if found.low is not None and found.low == found.high:
        return [event(found.low, "touch")]
    events = [] if found.low is None else [event(found.low, "birth")]
    return events if found.high is None else [*events, event(found.high, "death")]
