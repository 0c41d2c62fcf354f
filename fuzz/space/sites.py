"""Places on a polyhedron's faces, next to every connected part of space that the faces separate."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point, Whole, dot
from minkref.fuzz.space.boxes import Box, BoxTree, box_of
from minkref.oracle.slow.space.exposed import lifted, seen, viewing_axis
from minkref.oracle.slow.space.solid import plane_of

Flat = tuple[Fraction, Fraction]
Ring = list[Flat]
FINENESS = 1 << 20  # boxes are rounded to multiples, which keeps the order of numbers


def sites(solid: Polyhedron) -> Iterator[tuple[Whole, Point]]:
    """Yields a face's normal and a place inside the face, one for each piece into which the edges
    of other faces cut it. Faces are convex, with disjoint insides, and do not cross. Other faces
    touch a piece at most at single points inside it, so the space just above it is connected, and
    the space below: every connected part of space without the faces lies next to some piece."""
    rings = [[solid.vertices[k] for k in face] for face in solid.faces]
    boxes = [_box(ring) for ring in rings]
    tree = BoxTree(boxes)
    for number, ring in enumerate(rings):
        n, offset = plane_of(ring)
        axis = viewing_axis(n)
        flat = [seen(point, axis) for point in ring]
        parts = [flat if _area(flat) > 0 else flat[::-1]]
        near = [other for other in tree.meeting(boxes[number]) if other != number]
        level = {k: dot(_fractions(n), solid.vertices[k]) for f in near for k in solid.faces[f]}
        for other in near:
            face = solid.faces[other]
            for i, j in zip(face, face[1:] + face[:1], strict=True):
                if level[i] == level[j] == offset:
                    a, b = seen(solid.vertices[i], axis), seen(solid.vertices[j], axis)
                    parts = [piece for part in parts for piece in _split(part, a, b)]
        for part in parts:
            x, y = (sum((p[k] for p in part), Fraction(0)) / len(part) for k in range(2))
            yield n, lifted((x, y), (n, offset))


def _fractions(n: Whole) -> Point:
    return (Fraction(n[0]), Fraction(n[1]), Fraction(n[2]))


def _box(ring: list[Point]) -> Box:
    return box_of(
        (int(x * FINENESS // 1), int(y * FINENESS // 1), int(z * FINENESS // 1)) for x, y, z in ring
    )


def _area(ring: Ring) -> Fraction:
    """Twice, with sign."""
    sides = zip(ring, ring[1:] + ring[:1], strict=True)
    return sum((a[0] * b[1] - b[0] * a[1] for a, b in sides), Fraction(0))


def _split(ring: Ring, a: Flat, b: Flat) -> list[Ring]:
    """Cuts a convex ring along the line of a segment that passes through its inside."""
    start, end = Fraction(0), Fraction(1)
    for u, v in zip(ring, ring[1:] + ring[:1], strict=True):
        at_a, at_b = _turn(u, v, a), _turn(u, v, b)
        if at_a <= 0 and at_b <= 0:
            return [ring]
        if at_a < 0:
            start = max(start, at_a / (at_a - at_b))
        if at_b < 0:
            end = min(end, at_a / (at_a - at_b))
    return [ring] if start >= end else [_half(ring, a, b), _half(ring, b, a)]


def _half(ring: Ring, a: Flat, b: Flat) -> Ring:
    """On the left of the line."""
    kept: Ring = []
    for k, corner in enumerate(ring):
        before, here = _turn(a, b, ring[k - 1]), _turn(a, b, corner)
        if (before > 0 > here) or (before < 0 < here):
            t = before / (before - here)
            (x, y), (p, q) = ring[k - 1], corner
            kept.append((x + t * (p - x), y + t * (q - y)))
        if here >= 0:
            kept.append(corner)
    return kept


def _turn(a: Flat, b: Flat, c: Flat) -> Fraction:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
