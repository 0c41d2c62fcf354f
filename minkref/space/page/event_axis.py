"""The axis of events on the page of `minkref view` in space: how many there are of each kind along
the scales of a window, and which are next to each frame."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.errors import Refusal, refusing
from minkref.page.template import json_for_script
from minkref.space.operand import SpaceOperand
from minkref.space.scaling import Scaling

BINS = 160
FRAMES = 9  # where no scales are given, evenly over the window
MOST_EVENTS = 3_000_000  # of a kind
KINDS = ("vertex", "edge", "parallel", "triple", "four")


def frames_of(window: tuple[str, str]) -> list[Scaling]:
    """Scales of a window, both ends included."""
    first, last = map(Fraction, window)
    found = [first + (last - first) * k / (FRAMES - 1) for k in range(FRAMES)]
    return [(str(s), str(s), str(s)) for s in found]


def events_text(
    P: SpaceOperand, Q: SpaceOperand, window: tuple[str, str], scalings: list[Scaling], threads: int
) -> tuple[str, dict[str, int]]:
    """The data of the events for the page, and the number of events of each kind."""
    for scaling in scalings:
        if len(set(scaling)) > 1:
            mend = "leave out --from and --to, or give scales with one factor for all axes"
            raise Refusal("events are those of one factor", ",".join(scaling), mend)
    found = refusing(
        f"{P.name} and {Q.name}",
        lambda: _core.space_events(P.surface, Q.surface, *window, threads, None, True, MOST_EVENTS),
    )
    counts = {kind: dict(found.counts())[kind] for kind in KINDS}
    every = [(Fraction(row[0]), row[1]) for row in found.rows(0, len(found))]
    more = counts["triple"] + counts["four"]
    every += [(Fraction(row[0]), row[1]) for row in found.concurrent(0, more)]
    every.sort()
    scales = [s for s, _ in every]
    first, last = map(Fraction, window)
    data = {
        "from": window[0],
        "to": window[1],
        "counts": counts,
        "bins": _bins(every, first, last),
        "frames": [
            {"share": float((s - first) / (last - first)), **_beside(scales, s)}
            for s in (Fraction(scaling[0]) for scaling in scalings)
        ],
    }
    return json_for_script(data), counts


def _bins(every: list[tuple[Fraction, str]], first: Fraction, last: Fraction) -> list[list[int]]:
    """For each of as many equal parts of the window, how many events there are of each kind."""
    bins = [[0] * len(KINDS) for _ in range(BINS)]
    for s, kind in every:
        place = min(int((s - first) / (last - first) * BINS), BINS - 1)
        bins[place][KINDS.index(kind)] += 1
    return bins


def _beside(scales: list[Fraction], s: Fraction) -> dict[str, Any]:
    """How many are at this scale, and the next ones below and above."""
    low, high = bisect_left(scales, s), bisect_right(scales, s)
    return {
        "at": high - low,
        "below": str(scales[low - 1]) if low > 0 else None,
        "above": str(scales[high]) if high < len(scales) else None,
    }
