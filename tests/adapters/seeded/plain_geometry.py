"""Points, rings and their predicates, without rounding."""

from __future__ import annotations

from itertools import pairwise

Point = tuple[int, int]  # fractions do as well
Ring = list[Point]


def turn(a: Point, b: Point, c: Point) -> int:
    """Twice the signed area of the triangle."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def area(ring: Ring) -> int:
    """Twice the signed area of a ring."""
    return sum(p[0] * q[1] - p[1] * q[0] for p, q in zip(ring, ring[1:] + ring[:1], strict=True))


def within(a: Point, b: Point, p: Point) -> bool:
    """Whether p, on the line of a and b, lies strictly between them."""
    return (a[0] - p[0]) * (b[0] - p[0]) + (a[1] - p[1]) * (b[1] - p[1]) < 0


def in_wedge(before: Point, at: Point, after: Point, to: Point) -> bool:
    """Whether the way from `at` to `to` lies strictly in the wedge on the left of the corner."""
    if turn(before, at, after) > 0 or (
        turn(before, at, after) == 0 and not within(before, after, at)
    ):
        return turn(at, after, to) > 0 and turn(before, at, to) > 0
    return turn(at, after, to) > 0 or turn(before, at, to) > 0


def is_around(outer: Ring, hole: Ring) -> bool:
    """By the first of the hole's corners and edge middles that does not lie on the outer ring."""
    outer = [(2 * x, 2 * y) for x, y in outer]
    corners = [(2 * x, 2 * y) for x, y in hole]
    middles = [(p[0] + q[0], p[1] + q[1]) for p, q in pairwise(hole)]
    return next((place for p in corners + middles if (place := side(outer, p))), 1) > 0


def side(ring: Ring, p: Point) -> int:
    """1 inside, 0 on the ring, -1 outside."""
    inside = False
    for a, b in zip(ring, ring[1:] + ring[:1], strict=True):
        way = turn(a, b, p)
        if way == 0 and min(a, b) <= p <= max(a, b):
            return 0
        if (a[1] > p[1]) != (b[1] > p[1]) and (way > 0) == (b[1] > a[1]):
            inside = not inside
    return 1 if inside else -1


def without_straight_corners(ring: Ring) -> Ring:
    """The corners at which a ring turns."""
    n = len(ring)
    if n < 3:
        return ring
    return [p for k, p in enumerate(ring) if turn(ring[k - 1], p, ring[(k + 1) % n]) != 0]


def walks(rings: list[Ring]) -> list[Ring]:
    """Joins the same edges into rings, so that each corner bounds one wedge of the interior."""
    ahead: dict[Point, list[Point]] = {}
    for ring in rings:
        for a, b in zip(ring, ring[1:] + ring[:1], strict=True):
            ahead.setdefault(a, []).append(b)
    found: list[Ring] = []
    while any(ahead.values()):
        start = next(p for p, choices in ahead.items() if choices)
        walk = [start]
        first = at = ahead[start].pop()
        back = start
        while True:
            choices = ahead[at] + ([first] if at == start else [])
            to = next_clockwise(back, at, choices)
            if at == start and to == first:
                break
            ahead[at].remove(to)
            walk.append(at)
            back, at = at, to
        found.append(walk)
    return found


def next_clockwise(back: Point, at: Point, choices: list[Point]) -> Point:
    """The first one clockwise after the way back: the two edges bound one wedge."""
    best = choices[0]
    for other in choices[1:]:
        right, right_best = turn(at, back, other) < 0, turn(at, back, best) < 0
        if (right and not right_best) or (right == right_best and turn(at, other, best) < 0):
            best = other
    return best
