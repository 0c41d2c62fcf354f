"""Checks that polygons form a polygon set, from the definition (docs/definitions.md, "Polygon
set").

- A ring is simple: two edges share at most the vertex between neighbours.
- Two rings share no stretch and do not cross: cut at its points shared with the other ring, each
  ring has all pieces inside the other, or all outside. One point per piece decides.
- A hole lies inside its outer ring, and inside no other hole of its polygon.
- Outer rings lie outside each other, or inside a hole of the other's polygon.

Exact. Cost: pairs of edges whose boxes overlap along x, and shared points times edges.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction

from .exact import InputError, Point, text_of
from .operand import Polygon, Ring
from .place import inside

Box = tuple[Fraction, Fraction, Fraction, Fraction]  # left, bottom, right, top


def refuse_invalid(polygons: Sequence[Polygon]) -> None:
    """Raise InputError unless the polygons form a polygon set. Ignores orientation."""
    rings = [ring for part in polygons for ring in (part.outer, *part.holes)]
    names = [
        f"polygon {p}, " + (f"hole {h - 1}" if h else "outer ring")
        for p, part in enumerate(polygons)
        for h in range(len(part.holes) + 1)
    ]
    holders = containments(rings, names)
    at = 0
    outers: list[int] = []
    holes: dict[int, list[int]] = {}
    for part in polygons:
        outers.append(at)
        holes[at] = list(range(at + 1, at + 1 + len(part.holes)))
        at += 1 + len(part.holes)
    for outer in outers:
        for hole in holes[outer]:
            if outer not in holders[hole]:
                raise InputError(f"{names[hole]}: the hole lies outside of its outer ring")
            if holders[hole].intersection(holes[outer]):
                raise InputError(f"{names[hole]}: the hole lies in another hole")
    for first in outers:
        for second in holders[first].intersection(outers):
            if not holders[first].intersection(holes[second]):
                raise InputError(f"{names[first]} and {names[second]}: the polygons overlap")


def containments(rings: Sequence[Ring], names: Sequence[str]) -> list[set[int]]:
    """Return the rings around each ring. InputError if a ring is not simple or two rings overlap or
    cross."""
    shared = shared_points(rings, names)
    holders: list[set[int]] = [set() for _ in rings]
    for r, s in overlapping([box_of(ring) for ring in rings]):
        points = shared.get((min(r, s), max(r, s)), set())
        for inner, outer in ((r, s), (s, r)):
            found = {inside([rings[outer]], p) for p in piece_points(rings[inner], points)}
            if len(found) > 1:
                raise InputError(f"{names[inner]} and {names[outer]}: the rings cross")
            if True in found:
                holders[inner].add(outer)
    return holders


def shared_points(rings: Sequence[Ring], names: Sequence[str]) -> dict[tuple[int, int], set[Point]]:
    """Return the points where two rings touch, or cross at a vertex. InputError if a ring is not
    simple, or if two rings overlap or cross between vertices."""
    edges = [(r, i, *edge) for r, ring in enumerate(rings) for i, edge in enumerate(sides(ring))]
    found: dict[tuple[int, int], set[Point]] = {}
    for k, m in overlapping([box_of(edge[2:]) for edge in edges]):
        (r, i, a, b), (s, j, c, d) = edges[min(k, m)], edges[max(k, m)]
        crossing, ends = meeting(a, b, c, d)
        if r == s:
            neighbours = j == i + 1 or (i == 0 and j == len(rings[r]) - 1)
            if crossing or len(ends) > neighbours:
                how = "cross" if crossing else "overlap" if len(ends) > 1 else "touch"
                where = f"edges {i} and {j}, {places(a, b)} and {places(c, d)}"
                raise InputError(f"{names[r]}: the ring is not simple: {where}, {how}")
        elif crossing or len(ends) > 1:
            how = "cross" if crossing else "overlap along an edge"
            where = f"{places(a, b)} and {places(c, d)}"
            raise InputError(f"{names[r]} and {names[s]}: the rings {how}: {where}")
        elif ends:
            found.setdefault((r, s), set()).update(ends)
    return found


def meeting(a: Point, b: Point, c: Point, d: Point) -> tuple[bool, set[Point]]:
    """Tell whether the segments ab and cd cross inside both; return the ends of each that lie on
    the other: two for an overlap."""
    of_c, of_d, of_a, of_b = side(a, b, c), side(a, b, d), side(c, d, a), side(c, d, b)
    if of_c * of_d < 0 and of_a * of_b < 0:
        return True, set()
    ends = {p for p, at in ((c, of_c), (d, of_d)) if at == 0 and spans(a, b, p)}
    return False, ends | {p for p, at in ((a, of_a), (b, of_b)) if at == 0 and spans(c, d, p)}


def piece_points(ring: Ring, cuts: set[Point]) -> list[Point]:
    """Return one point, inside an edge, for each piece of the ring between cuts, which are points
    on the ring."""
    stops: list[Point] = []
    for a, b in sides(ring):
        on = [p for p in cuts if p not in (a, b) and spans(a, b, p) and side(a, b, p) == 0]
        stops += [a, *sorted(on, reverse=b < a)]
    begins = [k for k, p in enumerate(stops) if p in cuts] or [0]
    ends = [*stops[1:], stops[0]]
    return [
        (Fraction(stops[k][0] + ends[k][0], 2), Fraction(stops[k][1] + ends[k][1], 2))
        for k in begins
    ]


def overlapping(boxes: Sequence[Box]) -> Iterator[tuple[int, int]]:
    """Yield the pairs of closed boxes that share a point, each pair once."""
    active: list[int] = []
    for k in sorted(range(len(boxes)), key=lambda k: boxes[k][0]):
        left, bottom, _, top = boxes[k]
        active = [m for m in active if boxes[m][2] >= left]
        for m in active:
            if boxes[m][1] <= top and bottom <= boxes[m][3]:
                yield m, k
        active.append(k)


def box_of(points: Sequence[Point]) -> Box:
    xs, ys = [x for x, _ in points], [y for _, y in points]
    return min(xs), min(ys), max(xs), max(ys)


def sides(ring: Ring) -> Iterator[tuple[Point, Point]]:
    return zip(ring, [*ring[1:], ring[0]], strict=True)


def side(a: Point, b: Point, p: Point) -> int:
    """Return 1 to the left of the line from a to b, 0 on the line, -1 to the right."""
    turn = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
    return (turn > 0) - (turn < 0)


def spans(a: Point, b: Point, p: Point) -> bool:
    """Tell whether the segment's box contains the point."""
    return all(min(a[i], b[i]) <= p[i] <= max(a[i], b[i]) for i in (0, 1))


def places(*points: Point) -> str:
    return " ".join(f"({text_of(x)[:40]}, {text_of(y)[:40]})" for x, y in points)
