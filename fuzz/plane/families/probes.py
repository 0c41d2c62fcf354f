"""Scales at, next to and between the boundary events of a pair."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache

from minkref import _core

STEPS = (Fraction(1, 2**10), Fraction(1, 2**40))


@lru_cache(maxsize=64)
def boundary_scales(P: str, Q: str) -> tuple[Fraction, ...]:
    """Returns the scales at which the boundary of sP + Q changes, ascending. Empty if an operand
    has no area. Kept for a while: a pair's probes come one after another."""
    first, second = _core.PolygonSet.from_json(P), _core.PolygonSet.from_json(Q)
    if not (first.is_region and second.is_region):
        return ()
    moving = _core.DynamicSum(first, second)
    return tuple(sorted({Fraction(row[0]) for row in moving.boundary_events()}))


def scale_probes(P: str, Q: str, most: int) -> list[tuple[str, str]]:
    """Returns up to `most` rows (position, scale) with position `at`, `below` or `above` an event,
    or `far` from them all: in the middle between two. Every row except far rows lies nearer to its
    event than to any other."""
    events = boundary_scales(P, Q)
    if not events:
        return [("far", text) for text in ("1", "1/2", "2")][:most]
    wanted = max(1, -(-most // 4))
    chosen = sorted({k * (len(events) - 1) // max(1, wanted - 1) for k in range(wanted)})
    rows: list[tuple[str, Fraction]] = []
    for turn, k in enumerate(chosen):
        event = events[k]
        before = events[k - 1] if k else Fraction(0)
        after = events[k + 1] if k + 1 < len(events) else 2 * event + 1
        step = STEPS[turn % 2]
        rows += [
            ("at", event),
            ("below", event - min(step, (event - before) / 4)),
            ("above", event + min(step, (after - event) / 4)),
            ("far", (event + after) / 2),
        ]
    return [(position, str(scale)) for position, scale in rows[:most]]
