"""The parents of a boundary event, from their definition (docs/definitions.md): all convolution
edges that run along the boundary just below the scale, or just above it, and come to the place."""

from __future__ import annotations

import functools
import json
from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise
from typing import Any

import pytest
from minkref import _core
from minkref.fuzz.plane.families.lattice_pairs import lattice_pair
from minkref.plane.event_lists import ArrangementEventList, BoundaryEventList

Point = tuple[Fraction, Fraction]
Segment = tuple[Point, Point]
Edge = tuple[str, int, int, int, int]

Route = type[_core.DynamicSum] | type[_core.ScaleIndex]

SEED = 41
PAIRS = 12
# Later pairs in which a side of the boundary lies on several convolution edges at an event.
ON_ONE_LINE = (43, 48, 54, 68, 118)


def rings_of(operand: _core.PolygonSet) -> list[list[Point]]:
    """All rings, in numbering order."""
    return [
        [(Fraction(x), Fraction(y)) for x, y in ring]
        for polygon in json.loads(operand.to_json())["polygons"]
        for ring in (polygon["outer"], *polygon["holes"])
    ]


def at_scale(edge: Edge, P: list[list[Point]], Q: list[list[Point]], s: Fraction) -> Segment:
    kind, ring, index, other_ring, vertex = edge
    scaled = [[(s * x, s * y) for x, y in points] for points in P]
    ours, others = (scaled, Q) if kind == "S" else (Q, scaled)
    a, b = ours[ring][index], ours[ring][(index + 1) % len(ours[ring])]
    v = others[other_ring][vertex]
    return (a[0] + v[0], a[1] + v[1]), (b[0] + v[0], b[1] + v[1])


def along(edge: Segment, point: Point) -> Fraction | None:
    """The point's parameter from 0 to 1 on the edge's line; None beside the line."""
    (x0, y0), (x1, y1) = edge
    dx, dy = x1 - x0, y1 - y0
    x, y = point[0] - x0, point[1] - y0
    if dx * y != dy * x:
        return None
    return (dx * x + dy * y) / (dx * dx + dy * dy)


def on_boundary(edge: Segment, boundary: list[Segment]) -> list[tuple[Point, Point]]:
    """The pieces of positive length shared by the edge and boundary edges, sorted along the
    edge."""
    pieces = []
    for a, b in boundary:
        t, u = along(edge, a), along(edge, b)
        if t is None or u is None:
            continue
        low, high = max(min(t, u), Fraction(0)), min(max(t, u), Fraction(1))
        if low < high:
            pieces.append((low, high))
    (x0, y0), (x1, y1) = edge

    def point(t: Fraction) -> Point:
        return x0 + t * (x1 - x0), y0 + t * (y1 - y0)

    return [(point(low), point(high)) for low, high in sorted(pieces)]


@functools.lru_cache(maxsize=8)
def sides_of_sum(P: _core.PolygonSet, Q: _core.PolygonSet, s: Fraction) -> list[Segment]:
    return [
        side
        for ring in rings_of(_core.minkowski_sum(P, Q, str(s)).region)
        for side in pairwise([*ring, ring[0]])
    ]


def limits(
    edge: Edge, P: _core.PolygonSet, Q: _core.PolygonSet, s: Fraction, step: Fraction
) -> Iterator[tuple[Point, Point]]:
    """Limits at s of the edge's pieces on the boundary, from the side of `step`: between events the
    pieces move linearly, so that the pieces at s + step and s + 2 step tell the limits."""
    ps, qs = rings_of(P), rings_of(Q)
    found = [
        on_boundary(at_scale(edge, ps, qs, t), sides_of_sum(P, Q, t))
        for t in (s + step, s + 2 * step)
    ]
    assert len(found[0]) == len(found[1]), "an event within two steps"
    for near, far in zip(*found, strict=True):
        a, b = ((2 * n[0] - f[0], 2 * n[1] - f[1]) for n, f in zip(near, far, strict=True))
        yield a, b


def comes_to(piece: tuple[Point, Point], place: Point) -> bool:
    if piece[0] == piece[1]:
        return piece[0] == place
    t = along(piece, place)
    return t is not None and 0 <= t <= 1


def named(parent: dict[str, Any]) -> Edge:
    return (parent["kind"], *parent["edge"], *parent["vertex"])


@pytest.mark.parametrize("route", [_core.DynamicSum, _core.ScaleIndex])
@pytest.mark.parametrize("index", [*range(PAIRS), *ON_ONE_LINE])
def test_parents_are_the_edges_that_come_to_the_place(index: int, route: Route) -> None:
    pair = lattice_pair(SEED, index)
    P, Q = (_core.PolygonSet.from_json(text) for text in (pair.P, pair.Q))
    arrangement = ArrangementEventList(_core.ArrangementEvents(P, Q), "arrangement")
    scales = sorted({Fraction(event["s"]) for event in arrangement.events(0, len(arrangement))})
    moving = route(P, Q)
    edges = [(row[0], *row[2:]) for row in moving.edges()]
    found = BoundaryEventList(moving, "boundary")
    for event in found.events(0, len(found)):
        s = Fraction(event["s"])
        place = Fraction(event["at"][0]), Fraction(event["at"][1])
        parents = {named(parent) for parent in event["parents"]}
        at = scales.index(s)
        below = scales[at - 1] if at else Fraction(0)
        above = scales[at + 1] if at + 1 < len(scales) else s + 1
        for edge in edges:
            pieces = [
                piece
                for step in ((below - s) / 3, (above - s) / 3)
                for piece in limits(edge, P, Q, s, step)
            ]
            told = f"lattice:{SEED}:{index} at {s}, {edge}"
            if edge in parents:
                assert pieces, f"{told} is a parent and never runs along the boundary"
            elif any(comes_to(piece, place) for piece in pieces):
                pytest.fail(f"{told} comes to {event['at']} and is no parent")
