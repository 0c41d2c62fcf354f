"""Solids as a workshop makes them: L and U profiles, rings, cups, brackets with bores, gears.
Coordinates are integers."""

from __future__ import annotations

import json
import random
from fractions import Fraction
from math import cos, pi, sin

from minkref import _core
from minkref.fuzz.geometry.plane import turn
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point
from minkref.fuzz.plane.families.integer_rings import (
    Ring,
    counter_clockwise,
    rings_meet,
    scattered,
    untangled,
)
from minkref.fuzz.space.prism import Prism


def prism_over(outer: Ring, holes: list[Ring], low: int, high: int) -> Polyhedron:
    """A prism over a polygon with separate holes; a lid with holes is triangulated."""
    polygon = {"outer": _text(outer), "holes": [_text(hole) for hole in holes]}
    region = _core.PolygonSet.from_json(json.dumps({"polygons": [polygon]}))
    return Prism(region, Fraction(low), Fraction(high)).polyhedron()


def _text(ring: Ring) -> list[list[str]]:
    return [[str(x), str(y)] for x, y in ring]


def plate(a: int, b: int, c: int) -> Polyhedron:
    """A box with a corner in the origin."""
    return prism_over([(0, 0), (a, 0), (a, b), (0, b)], [], 0, c)


def l_solid(dice: random.Random, most: int) -> Polyhedron:
    """A profile of two arms; 8 faces."""
    a, b = dice.randint(2, most), dice.randint(2, most)
    u, v = dice.randint(1, a - 1), dice.randint(1, b - 1)
    return prism_over(l_outline(a, b, u, v), [], 0, dice.randint(1, most))


def l_outline(a: int, b: int, u: int, v: int) -> Ring:
    return [(0, 0), (a, 0), (a, v), (u, v), (u, b), (0, b)]


def u_solid(dice: random.Random, slot: int, most: int) -> Polyhedron:
    """Two arms, perhaps of different height, at a slot of this width; 10 faces."""
    left, right, floor = (dice.randint(1, most) for _ in range(3))
    one, other = (floor + dice.randint(1, most) for _ in range(2))
    end = left + slot
    outline = [(0, 0), (end + right, 0), (end + right, other), (end, other)]
    outline += [(end, floor), (left, floor), (left, one), (0, one)]
    return prism_over(outline, [], 0, dice.randint(1, most))


def dented_prism(dice: random.Random, corners: int, grid: int) -> Polyhedron:
    """A prism over a random non-convex polygon with up to so many corners."""
    while True:
        ring = untangled(scattered(dice, corners, grid, grid))
        if ring is None:
            continue
        ring = _bent(counter_clockwise(ring))
        turns = [turn(ring[k - 2], ring[k - 1], ring[k]) for k in range(len(ring))]
        if min(turns) < 0:
            return prism_over(ring, [], 0, dice.randint(1, grid))


def _bent(ring: Ring) -> Ring:
    """Without its straight corners."""
    count = len(ring)
    return [ring[k] for k in range(count) if turn(ring[k - 1], ring[k], ring[(k + 1) % count]) != 0]


def square_ring(width: int, depth: int, walls: tuple[int, int, int, int], high: int) -> Polyhedron:
    """A hole of this size through a plate, between walls of four widths (left, right, front,
    back); 16 faces."""
    left, right, front, back = walls
    outer = [(0, 0), (left + width + right, 0), (left + width + right, front + depth + back)]
    outer.append((0, front + depth + back))
    return _between(outer, _hole(left, front, width, depth), 0, high, None)


def cup(
    width: int, depth: int, height: int, walls: tuple[int, int, int, int], floor: int
) -> Polyhedron:
    """A pocket of this size, open at the top, in walls of four widths, above a floor; 14 faces."""
    left, right, front, back = walls
    outer = [(0, 0), (left + width + right, 0), (left + width + right, front + depth + back)]
    outer.append((0, front + depth + back))
    return _between(outer, _hole(left, front, width, depth), 0, floor + height, floor)


def _hole(x: int, y: int, width: int, depth: int) -> Ring:
    return [(x, y), (x + width, y), (x + width, y + depth), (x, y + depth)]


def _between(outer: Ring, hole: Ring, low: int, high: int, floor: int | None) -> Polyhedron:
    """Between two rectangles, the hole down to the floor, or through."""
    bottom = low if floor is None else floor
    vertices: list[Point] = []
    for ring, height in ((outer, low), (outer, high), (hole, bottom), (hole, high)):
        vertices += [(Fraction(x), Fraction(y), Fraction(height)) for x, y in ring]
    faces: list[tuple[int, ...]] = []
    for k in range(4):
        n = (k + 1) % 4
        faces.append((k, n, 4 + n, 4 + k))
        faces.append((8 + n, 8 + k, 12 + k, 12 + n))
        faces.append((4 + k, 4 + n, 12 + n, 12 + k))
        if floor is None:
            faces.append((n, k, 8 + k, 8 + n))
    if floor is not None:
        faces += [(3, 2, 1, 0), (8, 9, 10, 11)]
    return Polyhedron(tuple(vertices), tuple(faces))


def bracket(dice: random.Random, bores: int, most: int) -> Polyhedron:
    """An L profile or a plate with polygonal bores of 3 or 4 corners."""
    side = 3 * most
    if dice.random() < 0.5:
        outer = l_outline(side, side, side // 2, side // 2)
    else:
        outer = [(0, 0), (side, 0), (side, side), (0, side)]
    holes: list[Ring] = []
    while len(holes) < bores:
        x, y, r = dice.randint(1, side - 2), dice.randint(1, side - 2), dice.randint(1, most - 1)
        hole = [(x, y), (x, y + r), (x + r, y)]
        if dice.random() < 0.5:
            hole.insert(2, (x + r, y + r))
        inside = all(
            u < side and v < side and (len(outer) == 4 or u < side // 2 or v < side // 2)
            for u, v in hole
        )
        apart = all(_beside(hole, other) for other in holes)
        if inside and apart and not rings_meet(outer, hole):
            holes.append(hole)
    return prism_over(outer, holes, 0, dice.randint(1, most))


def _beside(one: Ring, other: Ring) -> bool:
    """The boxes around the rings have no point in common."""
    return any(
        max(a[k] for a in first) < min(b[k] for b in second)
        for k in (0, 1)
        for first, second in ((one, other), (other, one))
    )


def gear(dice: random.Random, teeth: int, radius: int, high: int, bore: bool = False) -> Polyhedron:
    """Four corners for each tooth, on two circles; 4 teeth + 2 faces, without a bore. At least
    three teeth, and a radius of ten."""
    start = dice.random()
    depth = Fraction(dice.randint(55, 75), 100)
    outline: Ring = []
    for k in range(4 * teeth):
        # The floats only choose points of the grid.
        angle = 2 * pi * (k + start) / (4 * teeth)
        r = float(radius if k % 4 < 2 else radius * depth)
        outline.append((round(r * cos(angle)), round(r * sin(angle))))
    hub = max(1, radius // 5)
    holes = [[(-hub, -hub), (-hub, hub), (hub, hub), (hub, -hub)]] if bore else []
    return prism_over(_bent(outline), holes, 0, high)
