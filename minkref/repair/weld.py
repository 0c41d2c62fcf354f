"""Vertices nearer than a distance, made one."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from itertools import product

Vector = tuple[Fraction, ...]


def squared_distance(a: Vector, b: Vector) -> Fraction:
    return sum(((p - q) ** 2 for p, q in zip(a, b, strict=True)), Fraction(0))


def welded(points: Iterable[Vector], distance: Fraction) -> dict[Vector, Vector]:
    """Map each moved point to the new place. In the order given, a point nearer
    than `distance` to a place kept before moves to the nearest such place, of equally near ones to
    the first; any other point is kept. Kept places are at least `distance` apart, so that welding
    again changes nothing. Exact. Linear: few kept places lie near a point."""
    kept: dict[tuple[int, ...], list[tuple[int, Vector]]] = {}
    moves: dict[Vector, Vector] = {}
    seen: set[Vector] = set()
    limit = distance**2
    for point in points:
        if point in seen:
            continue
        seen.add(point)
        cell = tuple(x // distance for x in point)
        near = [
            (apart, number, place)
            for step in product((-1, 0, 1), repeat=len(cell))
            for number, place in kept.get(tuple(c + s for c, s in zip(cell, step, strict=True)), ())
            if (apart := squared_distance(place, point)) < limit
        ]
        if near:
            moves[point] = min(near)[2]
        else:
            kept.setdefault(cell, []).append((len(seen), point))
    return moves
