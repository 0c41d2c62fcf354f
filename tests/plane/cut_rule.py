"""Cuts by the rule word for word, in plain fractions: every candidate end is tried against every
wall. Shares nothing with reference/."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import cmp_to_key

Point = tuple[Fraction, Fraction]
Wall = tuple[Point, Point]


def minus(a: Point, b: Point) -> Point:
    return a[0] - b[0], a[1] - b[1]


def cross(u: Point, w: Point) -> Fraction:
    return u[0] * w[1] - u[1] * w[0]


def dot(u: Point, w: Point) -> Fraction:
    return u[0] * w[0] + u[1] * w[1]


def at_most_half_a_turn(u: Point, w: Point) -> bool:
    """Whether w lies counter-clockwise of u, by more than nothing and by half a turn at most."""
    side = cross(u, w)
    return side > 0 or (side == 0 and dot(u, w) < 0)


def lies_on(x: Point, wall: Wall) -> bool:
    a, b = wall
    return cross(minus(b, a), minus(x, a)) == 0 and dot(minus(a, x), minus(b, x)) <= 0


def is_inside(x: Point, edges: list[Wall]) -> bool:
    """By the crossings of a ray to the right; x lies on no edge."""
    crossings = 0
    for (ax, ay), (bx, by) in edges:
        if (ay > x[1]) != (by > x[1]):
            crossings += ax + (x[1] - ay) / (by - ay) * (bx - ax) > x[0]
    return crossings % 2 == 1


def directions(v: Point, walls: list[Wall]) -> list[Point]:
    """The directions of all walls that leave v, counter-clockwise."""
    found = [minus(end, v) for wall in walls if lies_on(v, wall) for end in wall if end != v]

    def compare(u: Point, w: Point) -> int:
        halves = [
            direction[1] < 0 or (direction[1] == 0 and direction[0] < 0) for direction in (u, w)
        ]
        if halves[0] != halves[1]:
            return 1 if halves[0] else -1
        side = cross(u, w)
        return -1 if side > 0 else 1 if side < 0 else 0

    return sorted(found, key=cmp_to_key(compare))


def meets_inside(v: Point, w: Point, wall: Wall) -> bool:
    """Whether a wall has a point between v and w, neither of these."""
    along = minus(w, v)
    sides = [cross(along, minus(end, v)) for end in wall]
    for end, side in zip(wall, sides, strict=True):
        if side == 0 and 0 < dot(along, minus(end, v)) < dot(along, along):
            return True
    if sides[0] == sides[1] == 0:
        return lies_on(v, wall) and lies_on(w, wall)
    if sides[0] * sides[1] >= 0:
        return False
    a, b = wall
    t = cross(minus(a, v), minus(b, a)) / cross(along, minus(b, a))
    return 0 < t < 1


def reflex_sector(v: Point, walls: list[Wall], edges: list[Wall]) -> tuple[Point, Point] | None:
    """The walls' directions around the sector of the interior of more than half a turn at v."""
    around = directions(v, walls)
    for first, second in zip(around, around[1:] + around[:1], strict=True):
        if at_most_half_a_turn(first, second):
            continue
        into = -first[0] - second[0], -first[1] - second[1]
        step = Fraction(1)
        while any(
            meets_inside(v, (v[0] + 2 * step * into[0], v[1] + 2 * step * into[1]), wall)
            for wall in walls
        ):
            step /= 2
        if is_inside((v[0] + step * into[0], v[1] + step * into[1]), edges):
            return first, second
    return None


def candidates(v: Point, walls: list[Wall], rays: tuple[Point, Point]) -> Iterator[Point]:
    """Ends of walls, feet of perpendiculars, and where two rays from v meet walls."""
    for a, b in walls:
        along = minus(b, a)
        yield from (a, b)
        points = [dot(minus(v, a), along) / dot(along, along)]
        points += [
            cross(minus(v, a), ray) / cross(along, ray) for ray in rays if cross(along, ray) != 0
        ]
        for t in points:
            if 0 <= t <= 1:
                yield a[0] + t * along[0], a[1] + t * along[1]


def cut_from(v: Point, walls: list[Wall], edges: list[Wall]) -> Point | None:
    """Find the end of the shortest visible cut that resolves v; None if v is resolved already."""
    sector = reflex_sector(v, walls, edges)
    if sector is None:
        return None
    first, second = sector
    rays = (-first[0], -first[1]), (-second[0], -second[1])
    found = []
    for w in set(candidates(v, walls, rays)) - {v}:
        along = minus(w, v)
        if not (at_most_half_a_turn(first, along) and at_most_half_a_turn(along, second)):
            continue
        if any(meets_inside(v, w, wall) for wall in walls):
            continue
        if is_inside(((v[0] + w[0]) / 2, (v[1] + w[1]) / 2), edges):
            found.append((dot(along, along), w))
    return min(found)[1]


def cuts(edges: list[Wall], notches: list[Point]) -> list[tuple[int, Point, Point]]:
    """(number of the notch, start, end) of all cuts, one after another."""
    walls, found = list(edges), []
    for number, v in enumerate(notches):
        end = cut_from(v, walls, edges)
        if end is not None:
            found.append((number, v, end))
            walls.append((v, end))
    return found
