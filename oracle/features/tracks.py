"""Tracks: paths up the medial axis through places with one part from below and one part upwards;
they end where several parts meet, or the distance turns."""

from __future__ import annotations

from .levels import Levels

Track = tuple[int, int]  # levels of its ends


def tracks(levels: Levels) -> list[Track]:
    parts = [part for part in levels.graph.parts if not part.is_flat]
    places = range(len(levels.graph.places))
    arriving: dict[int, list[int]] = {k: [] for k in places}
    leaving: dict[int, list[int]] = {k: [] for k in places}
    for k, part in enumerate(parts):
        if part.high[0] == "place":
            arriving[part.high[1]].append(k)
        if part.low[0] == "place":
            leaving[part.low[1]].append(k)
    flat = {end[1] for part in levels.graph.parts if part.is_flat for end in (part.low, part.high)}
    after = {
        arriving[k][0]: leaving[k][0]
        for k in places
        if len(arriving[k]) == 1 == len(leaving[k]) and k not in flat
    }
    found = []
    for first in set(range(len(parts))) - set(after.values()):
        last = first
        while last in after:
            last = after[last]
        found.append((levels.level(parts[first].low), levels.level(parts[last].high)))
    return sorted(found)
