"""Cuts that resolve notches, each the shortest, found among all walls; and pieces between them."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import cmp_to_key
from itertools import pairwise
from typing import Any

from .outline import Point, cross, dot, edges_of, minus

Cut = tuple[Point, Point]
Polygons = Sequence[Sequence[Sequence[tuple[Any, Any]]]]


def cuts(polygons: Polygons, vertices: Sequence[Point]) -> list[Cut]:
    """Cuts one after another, from vertices in their order: in each sector of the interior of more
    than half a turn the shortest way within the cone between the prolongations of both walls, to a
    wall or an earlier cut; of equally long ways to the least end. O(n^2)."""
    walls = [(edge.a, edge.b) for edge in edges_of(polygons)]
    boundary = len(walls)
    found: list[Cut] = []
    for v in vertices:
        for first, second in _wide_sectors(walls, boundary, v):
            end = _nearest(walls, v, first, second)
            found.append((v, end))
            walls.append((v, end))
    return found


def _wide_sectors(walls: list[Cut], boundary: int, v: Point) -> list[tuple[Point, Point]]:
    """The walls' ways at both sides of an interior sector of more than half a turn."""
    in_order = cmp_to_key(_turn_order)
    rays: list[tuple[Point, bool]] = []  # a way, and whether the interior follows after it
    for k, (a, b) in enumerate(walls):
        if a == v:
            rays.append((minus(b, v), True))
        elif b == v:
            rays.append((minus(a, v), k >= boundary))
        elif cross(minus(b, a), minus(v, a)) == 0 and dot(minus(a, v), minus(b, v)) < 0:
            rays += [(minus(b, v), True), (minus(a, v), k >= boundary)]
    rays.sort(key=lambda ray: in_order(ray[0]))
    found = []
    for (way, inside), (after, _) in zip(rays, [*rays[1:], *rays[:1]], strict=True):
        if inside and cross(way, after) < 0:
            found.append((way, after))
    return found


def _turn_order(p: Point, q: Point) -> int:
    """Counter-clockwise from the positive x-axis."""
    upper = [way[1] > 0 or (way[1] == 0 and way[0] > 0) for way in (p, q)]
    if upper[0] != upper[1]:
        return -1 if upper[0] else 1
    turn = cross(p, q)
    return (turn < 0) - (turn > 0)


def _nearest(walls: list[Cut], v: Point, first: Point, second: Point) -> Point:
    """The nearest point of all walls at most half a turn after `first` and before `second`."""
    best: tuple[Fraction, Point] | None = None
    for a, b in walls:
        way, start = minus(b, a), minus(a, v)
        if cross(start, way) == 0 and (a == v or b == v or dot(start, minus(b, v)) < 0):
            continue  # a wall through v
        low, high = Fraction(0), Fraction(1)
        for at_start, slope in ((cross(first, start), cross(first, way)),
                                (cross(start, second), cross(way, second))):  # fmt: skip
            if slope > 0:
                low = max(low, -at_start / slope)
            elif slope < 0:
                high = min(high, -at_start / slope)
            elif at_start < 0:
                high = Fraction(-1)
        if low > high:
            continue
        t = min(max(-dot(start, way) / dot(way, way), low), high)
        end = a[0] + t * way[0], a[1] + t * way[1]
        far = dot(minus(end, v), minus(end, v))
        if best is None or (far, end) < best:
            best = far, end
    assert best is not None
    return best[1]


def pieces(polygons: Polygons, made: Sequence[Cut]) -> list[list[list[Point]]]:
    """Outer rings and holes of the components of the interior without the cuts; a slit is run along
    both ways. Each piece is a list of rings, the outer ring first."""
    ways = _directed(polygons, made)
    leaving: dict[Point, list[Point]] = {}
    for a, b in ways:
        leaving.setdefault(a, []).append(b)
    rings = []
    left = dict.fromkeys(ways)
    while left:
        start = next(iter(left))
        ring, way = [], start
        while way in left:
            del left[way]
            ring.append(way[0])
            way = (way[1], _first_left(way, leaving[way[1]]))
        rings.append(ring)
    outer = [ring for ring in rings if _doubled_area(ring) > 0]
    found = [[ring] for ring in outer]
    for ring in rings:
        if _doubled_area(ring) <= 0:
            around = [piece for piece in found if _is_around(piece[0], ring)]
            min(around, key=lambda piece: _doubled_area(piece[0])).append(ring)
    return found


def _directed(polygons: Polygons, made: Sequence[Cut]) -> list[Cut]:
    """Walls with the interior on their left, cut at all ends; cuts both ways."""
    given = [(edge.a, edge.b) for edge in edges_of(polygons)]
    given += [way for a, b in made for way in ((a, b), (b, a))]
    ends = {p for way in given for p in way}
    found = []
    for a, b in given:
        along = minus(b, a)
        on = [(dot(along, minus(p, a)), p) for p in ends if cross(along, minus(p, a)) == 0]
        stops = [p for far, p in sorted(on) if 0 <= far <= dot(along, along)]
        found += list(pairwise(stops))
    return found


def _first_left(way: Cut, ends: list[Point]) -> Point:
    """The end of the way that goes on with the interior on its left: the first clockwise from the
    way back."""
    back = minus(way[0], way[1])

    def before(p: Point, q: Point) -> int:
        return _clockwise(back, minus(p, way[1]), minus(q, way[1]))

    return min(ends, key=cmp_to_key(before))


def _clockwise(start: Point, p: Point, q: Point) -> int:
    def half(way: Point) -> int:
        side = cross(start, way)
        if side == 0:
            return 2 if dot(start, way) < 0 else 4  # a way straight back comes last
        return 1 if side < 0 else 3

    if half(p) != half(q):
        return half(p) - half(q)
    turn = cross(p, q)
    return (turn > 0) - (turn < 0)


def _doubled_area(ring: list[Point]) -> Fraction:
    pairs = zip(ring, [*ring[1:], *ring[:1]], strict=True)
    return sum((cross(p, q) for p, q in pairs), Fraction(0))


def _is_around(ring: list[Point], inner: list[Point]) -> bool:
    """Whether the middle of the inner ring's first side lies inside, or on the ring."""
    (ax, ay), (bx, by) = inner[0], inner[1 % len(inner)]
    x, y = (ax + bx) / 2, (ay + by) / 2
    inside = False
    for (px, py), (qx, qy) in zip(ring, [*ring[1:], *ring[:1]], strict=True):
        if (py > y) != (qy > y) and px + (y - py) / (qy - py) * (qx - px) > x:
            inside = not inside
    return inside


def is_convex(piece: list[list[Point]]) -> bool:
    """Whether a piece has one ring, that nowhere turns right."""
    if len(piece) > 1:
        return False
    [ring] = piece
    corners = zip(ring, [*ring[1:], *ring[:1]], [*ring[2:], *ring[:2]], strict=True)
    return all(cross(minus(q, p), minus(r, q)) >= 0 for p, q, r in corners)
