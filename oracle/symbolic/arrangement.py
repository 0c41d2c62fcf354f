"""All arrangement events of a set of moving segments: every pair, every triple. Brute force."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations

from .moving import MovingSegment, parallel
from .pairs import Event, Interval, contact_set, pair_events
from .parallels import parallel_events
from .triples import ends_passed, triple_events


@dataclass(frozen=True, slots=True)
class ArrangementEvent:
    """An event of segments, indices ascending; `kind` pair, parallel, triple, or end: a third
    segment passes an end of a segment that overlaps another along a line at all nearby scales."""

    kind: str
    segments: tuple[int, ...]
    event: Event


def pairwise_events(segments: Sequence[MovingSegment]) -> list[ArrangementEvent]:
    """Find all pair and parallel events, including swaps of end points. O(n^2), exact."""
    found = []
    for (i, a), (j, b) in combinations(enumerate(segments), 2):
        kind = "parallel" if parallel(a, b) else "pair"
        events = parallel_events(a, b) if kind == "parallel" else pair_events(a, b)
        found += [ArrangementEvent(kind, (i, j), event) for event in events]
    return found


def meet_at_once(found: Sequence[Interval | None]) -> bool:
    """Tell whether all these closed intervals share a scale."""
    known = [each for each in found if each is not None]
    low = max((each.low for each in known if each.low is not None), default=None)
    high = min((each.high for each in known if each.high is not None), default=None)
    return len(known) == len(found) and (low is None or high is None or low <= high)


def threefold_events(segments: Sequence[MovingSegment]) -> list[ArrangementEvent]:
    """Find all triple events, and all events of kind `end`. O(n^3), exact.

    All three segments share a point at such an event, so triples are left out if at no scale all
    three pairs are in contact."""
    contact = {(i, j): contact_set(a, b) for (i, a), (j, b) in combinations(enumerate(segments), 2)}
    found = []
    for which in combinations(range(len(segments)), 3):
        if not meet_at_once([contact[pair] for pair in combinations(which, 2)]):
            continue
        triple = (segments[which[0]], segments[which[1]], segments[which[2]])
        found += [ArrangementEvent("triple", which, event) for event in triple_events(triple)]
        passed = dict.fromkeys(event for event, _ in ends_passed(triple))
        found += [ArrangementEvent("end", which, event) for event in passed]
    return found
