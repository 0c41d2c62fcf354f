"""Laws about owners, on small random scenes."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise
from typing import Any

import minkref
import pytest
from scene_draws import ROBOTS, Draw, scenes, turned
from thoroughness import draws

SEED = 1116
Point = tuple[Fraction, Fraction]


def segments(ring: list[Point]) -> list[tuple[Point, Point]]:
    return [(ring[i], ring[(i + 1) % len(ring)]) for i in range(len(ring))]


def shared(first: tuple[Point, Point], second: tuple[Point, Point]) -> tuple[Any, Any] | None:
    """Cut a segment by another one with the same line and direction: two parameters, or None if
    they share no length."""
    (a, b), (c, d) = first, second
    way = (b[0] - a[0], b[1] - a[1])

    def turn(p: Point, q: Point) -> Fraction:
        return way[0] * (q[1] - p[1]) - way[1] * (q[0] - p[0])

    def along(p: Point) -> Fraction:
        over = way[0] ** 2 + way[1] ** 2
        return (way[0] * (p[0] - a[0]) + way[1] * (p[1] - a[1])) / over

    if turn(a, c) or turn(a, d) or along(c) >= along(d):
        return None
    low, high = max(Fraction(0), along(c)), min(Fraction(1), along(d))
    return (low, high) if low < high else None


def drawn(robot: str, law: int) -> Iterator[Draw]:
    """Draw scenes; segments, beside merged obstacles, get more."""
    count = draws(32, 200) if robot == "segment" else draws(6, 40)
    return scenes(SEED + law, count, robots=(robot,))


@pytest.mark.parametrize("robot", ROBOTS)
def test_owners_of_a_side_are_the_copies_whose_sums_run_along_it(robot: str) -> None:
    """Compares owners with the boundaries of all sums."""
    for draw in drawn(robot, 0):
        scene = draw.scene()
        bounds = [
            [
                one
                for polygon in scene.sum_of(k).rings()
                for ring in polygon
                for one in segments(ring)
            ]
            for k in range(len(draw.copies))
        ]
        rings = [ring for polygon in scene.union().rings() for ring in polygon]
        for ring, owners in zip(rings, scene.owners(), strict=True):
            for side, found in zip(segments(ring), owners, strict=True):
                expected = {
                    k for k, edges in enumerate(bounds) if any(shared(side, e) for e in edges)
                }
                assert {owner.copy for owner in found} == expected, (draw.told, side)
                assert len(found) == len(set(found)), (draw.told, side)


@pytest.mark.parametrize("robot", ROBOTS)
def test_parents_of_a_side_run_along_it(robot: str) -> None:
    """An edge of the shape at a vertex of the turned robot, or the reverse, made by hand: all
    owners run along the side in its direction, and leave no gap."""
    for draw in drawn(robot, 1):
        scene = draw.scene()
        rings = [ring for polygon in scene.union().rings() for ring in polygon]
        for ring, owners in zip(rings, scene.owners(), strict=True):
            for side, found in zip(segments(ring), owners, strict=True):
                parts = [shared(side, edge_of(draw, owner)) for owner in found]
                assert None not in parts, (draw.told, side)
                reached = Fraction(0)
                for low, high in sorted(part for part in parts if part is not None):
                    assert low <= reached, (draw.told, side)
                    reached = max(reached, high)
                assert reached == 1, (draw.told, side)


@pytest.mark.parametrize("robot", ROBOTS)
def test_owners_of_a_passage_touch_all_along_it(robot: str) -> None:
    """Each runs along a segment, either way, or through a point."""
    for draw in drawn(robot, 2):
        for passage in draw.scene(passages=True).passages():
            ends = passage.points if len(passage.points) > 1 else passage.points * 2
            for side, owners in zip(pairwise(ends), passage.owners, strict=True):
                assert owners, (draw.told, side)
                for owner in owners:
                    edge = edge_of(draw, owner)
                    if side[0] == side[1]:
                        assert holds(edge, side[0]), (draw.told, side, owner)
                    else:
                        found = shared(side, edge) or shared(side, edge[::-1])
                        assert found is not None, (draw.told, side, owner)


def holds(edge: tuple[Point, Point], x: Point) -> bool:
    """Tell whether a point lies on an edge."""
    (a, b), within = edge, zip(*edge, x, strict=True)
    turn = (b[0] - a[0]) * (x[1] - a[1]) - (b[1] - a[1]) * (x[0] - a[0])
    return turn == 0 and all(min(p, q) <= at <= max(p, q) for p, q, at in within)


def edge_of(draw: Draw, owner: minkref.Owner) -> tuple[Point, Point]:
    copy = draw.copies[owner.copy]
    shape = draw.shapes[str(copy.shape)].scaled(copy.scale).translated(*copy.place)
    sets = (shape, turned(draw.robot))
    edges, vertices = sets if owner.kind == "S" else sets[::-1]
    rings, others = (
        [ring for polygon in each.rings() for ring in polygon] for each in (edges, vertices)
    )
    ring, (x, y) = rings[owner.edge[0]], others[owner.vertex[0]][owner.vertex[1]]
    start, end = ring[owner.edge[1]], ring[(owner.edge[1] + 1) % len(ring)]
    return (start[0] + x, start[1] + y), (end[0] + x, end[1] + y)
