"""Segments, points and regions with touching rings, on a few lattice points: the index has all
other routes' sums and events."""

from __future__ import annotations

import json
from collections import Counter
from fractions import Fraction
from typing import Any

import pytest
from minkref.fuzz.plane.families.pinched_pairs import pinched_pair
from minkref.fuzz.plane.families.touching_cells import WINDOWS, window_of
from minkref.reports.evidence.plane_index.sums import same_events, same_sums_by_all_routes
from thoroughness import draws

SEED = 5
Point = tuple[Fraction, ...]


@pytest.mark.parametrize("index", range(draws(14, 40)))
def test_sums_and_events_are_those_of_the_other_routes(index: int) -> None:
    pair = pinched_pair(SEED, index)
    task = (f"pinched {SEED} {index}", pair.P, pair.Q, window_of(index), ())
    for same in (same_sums_by_all_routes, same_events):
        name, compared, fault = same(task)
        assert not fault, f"{name}: {fault}\n{pair.P}\n{pair.Q}"
        assert compared > 0 or same is same_events, name


def test_the_family_has_segments_points_and_rings_that_touch() -> None:
    kinds: Counter[str] = Counter()
    in_windows = set()
    for index in range(40):
        pair = pinched_pair(SEED, index)
        for operand in (pair.P, pair.Q):
            kind = kind_of(json.loads(operand)["polygons"])
            kinds[kind] += 1
            in_windows.add((kind, window_of(index)))
    assert kinds["segment"] == 20
    assert kinds["point"] == 4
    assert kinds["touching"] >= 40
    # A segment beside touching rings once met no window, and was wrong in windows only.
    assert in_windows >= {(kind, window) for kind in ("segment", "touching") for window in WINDOWS}
    assert len({window for kind, window in in_windows if kind == "point"}) == 4


def kind_of(polygons: list[dict[str, Any]]) -> str:
    rings = [
        [tuple(map(Fraction, p)) for p in ring]
        for polygon in polygons
        for ring in (polygon["outer"], *polygon["holes"])
    ]
    if len(rings[0]) < 3:
        return ("point", "segment")[len(rings[0]) - 1]
    touching = any(
        other is not ring and lies_on(p, other) for ring in rings for p in ring for other in rings
    )
    return "touching" if touching else "apart"


def lies_on(p: Point, ring: list[Point]) -> bool:
    sides = zip(ring, ring[1:] + ring[:1], strict=True)
    return any(
        (b[0] - a[0]) * (p[1] - a[1]) == (b[1] - a[1]) * (p[0] - a[0])
        and all(min(a[k], b[k]) <= p[k] <= max(a[k], b[k]) for k in (0, 1))
        for a, b in sides
    )
