"""The arrangement of the facets of sP + Q at one scale, by data that stay constant between events:
which facets meet, on which sides the ends of their intersections lie, in which order other facets
cross them, and the common parts of three facets with two in one plane. Static, from the definition;
for small operands."""

from __future__ import annotations

import random
from collections import Counter, defaultdict
from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import combinations, pairwise
from typing import Any

from minkref import _core
from minkref.fuzz.judges.space.space_event_comparison import moving_facet
from minkref.fuzz.judges.space.space_routes import core_polyhedron
from minkref.fuzz.space.general_pairs import GeneralPair
from minkref.oracle.symbolic.rational import Rational, rational
from minkref.oracle.symbolic.space.space_events import planes_parallel
from minkref.oracle.symbolic.space.space_moving import MovingFacet, Vector, cross, dot, minus
from minkref.oracle.symbolic.space.space_standing import (
    Segment3,
    in_polygon,
    on_segment,
    polygons_meet,
    share_an_area,
    shared,
    shared_by_convex,
    shared_by_polygons,
)

END = -1  # beside numbers of facets
Arrangement = dict[tuple[int, ...], Any]
"""Facts by the numbers, ascending, of two or three facets that meet, and only of such facets."""


class MovingFacets:
    """Facets with their parallel pairs, which do not depend on the scale."""

    def __init__(self, facets: Sequence[MovingFacet]) -> None:
        self.facets = facets
        self.pairs = list(combinations(range(len(facets)), 2))
        self.parallel = {(i, j) for i, j in self.pairs if planes_parallel(facets[i], facets[j])}

    def at(self, s: Rational) -> Arrangement:
        """O(n^2) pairs, and for each facet all pairs of facets that meet it."""
        corners = [facet.corners(s) for facet in self.facets]
        boxes = [_box(each) for each in corners]
        found: Arrangement = {}
        segments: dict[int, dict[int, Segment3]] = defaultdict(dict)
        in_one_plane: dict[int, set[int]] = defaultdict(set)
        for i, j in self.pairs:
            if _apart(boxes[i], boxes[j]):
                continue
            if (i, j) in self.parallel:
                if _in_one_plane(corners[i], corners[j]) and polygons_meet(corners[i], corners[j]):
                    found[i, j] = _of_parallel(corners[i], corners[j])
                    in_one_plane[i].add(j)
                continue
            common = shared_by_polygons(corners[i], corners[j])
            if common is not None:
                segments[i][j] = segments[j][i] = self._along(i, j, common)
        for i, others in segments.items():
            for j, segment in others.items():
                if i < j:
                    ends = [(_sides(x, corners[i]), _sides(x, corners[j])) for x in segment]
                    crossings = self._crossings(i, j, segment, segments)
                    found[i, j] = (segment[0] == segment[1], ends, crossings)
        for i, beside in in_one_plane.items():
            for j in beside:
                for k in segments[i].keys() & segments[j].keys():
                    common = shared(segments[i][k], segments[j][k])
                    if common is not None:
                        low, high = self._along(i, k, common)
                        found[i, j, k] = [_places(x, corners, (i, j, k)) for x in (low, high)]
                for k in beside & in_one_plane.get(j, set()):
                    area = shared_by_convex([corners[each] for each in (i, j, k)])
                    if area:
                        found[i, j, k] = sorted({_places(x, corners, (i, j, k)) for x in area})
        return found

    def _along(self, i: int, j: int, segment: Segment3) -> Segment3:
        direction = cross(self.facets[i].plane()[:3], self.facets[j].plane()[:3])
        low, high = sorted(segment, key=lambda x: dot(direction, x))
        return low, high

    def _crossings(
        self, i: int, j: int, segment: Segment3, segments: dict[int, dict[int, Segment3]]
    ) -> list[Any]:
        """Other facets that share a point with both, and the segment's ends, in order along the
        segment; elements at one point together."""
        direction = cross(self.facets[i].plane()[:3], self.facets[j].plane()[:3])
        at: dict[Rational, list[Any]] = defaultdict(list)
        for x in dict.fromkeys(segment):
            at[dot(direction, x)].append(END)
        for k in segments[i].keys() & segments[j].keys():
            common = shared(segment, segments[i][k])
            common = common and shared(common, segments[j][k])
            for x in dict.fromkeys(common or ()):
                at[dot(direction, x)].append(k)
        return [sorted(at[key]) for key in sorted(at)]


def _box(corners: Sequence[Vector]) -> list[tuple[Rational, Rational]]:
    return [(min(column), max(column)) for column in zip(*corners, strict=True)]


def _apart(a: list[tuple[Rational, Rational]], b: list[tuple[Rational, Rational]]) -> bool:
    return any(u[1] < v[0] or v[1] < u[0] for u, v in zip(a, b, strict=True))


def _sides(x: Vector, corners: Sequence[Vector]) -> tuple[int, ...]:
    """Returns the sides on which the point lies."""
    count = len(corners)
    return tuple(k for k in range(count) if on_segment(x, (corners[k], corners[(k + 1) % count])))


def _places(x: Vector, corners: Sequence[Sequence[Vector]], which: tuple[int, ...]) -> Any:
    return tuple(_sides(x, corners[k]) for k in which)


def _in_one_plane(f: Sequence[Vector], g: Sequence[Vector]) -> bool:
    normal = cross(minus(f[1], f[0]), minus(f[2], f[0]))
    return dot(normal, minus(g[0], f[0])) == 0


def _of_parallel(f: Sequence[Vector], g: Sequence[Vector]) -> Any:
    """Whether two facets in one plane share an area, and where each facet's corners lie in the
    other."""
    places = [
        [_sides(x, other) if in_polygon(x, other) else None for x in own]
        for own, other in ((f, g), (g, f))
    ]
    return share_an_area(f, g), places


@dataclass
class Judged:
    counts: Counter[str] = field(default_factory=Counter)
    faults: list[str] = field(default_factory=list)


def judge_list(
    pair: GeneralPair, window: tuple[str, str], most_facets: int, events: int
) -> Judged | None:
    """Compares the reference's list with the list from all pairs of facets, and arrangements around
    some events in it. None if the facets are too many."""
    P, Q = core_polyhedron(pair.P), core_polyhedron(pair.Q)
    found = _core.space_events(P, Q, *window, concurrent=True)
    facets = dict(found.counts())["facets"]
    if facets > most_facets:
        return None
    judged = Judged()
    every = _core.space_events_of_all_pairs(P, Q, *window, concurrent=True)
    scales: set[Rational] = set()
    for name in ("rows", "concurrent"):
        rows, others = (getattr(each, name)(0, 10**9) for each in (found, every))
        judged.counts[f"{name} compared"] += len(rows)
        scales |= {rational(row[0]) for row in rows}
        if rows != others:
            judged.faults.append(f"not those of all pairs: {name}")
    moving = MovingFacets([moving_facet(pair.P, pair.Q, *found.facet(k)) for k in range(facets)])
    around = [rational(window[0]), *sorted(scales), rational(window[1])]
    dice = random.Random(f"minkref event lists {pair.name}")
    for k in dice.sample(range(len(scales)), min(events, len(scales))):
        judged.counts["events looked at"] += 1
        before, s, after = around[k : k + 3]
        judged.faults += [f"at {s}: {fault}" for fault in _around(moving, before, s, after)]
    return judged


def _around(moving: MovingFacets, before: Rational, s: Rational, after: Rational) -> list[str]:
    """An event at s, its neighbours at `before` and `after`: what does not fit."""
    faults = []
    here = moving.at(s)
    told: list[Arrangement] = []
    for low, high in pairwise((before, s, after)):
        if low == high:  # the end of the window
            continue
        first, last = (moving.at(low + (high - low) * part / 7) for part in (1, 6))
        if first != last:
            faults.append(f"the arrangement changes between {low} and {high}")
        told.append(first)
    if told and all(here == each for each in told):
        faults.append("the arrangement does not change")
    return faults
