"""Faces cut into strictly convex pieces."""

from __future__ import annotations

from fractions import Fraction

from space_sets import Point, Shell, corners_of, cross, dot, minus, normal_of


def fan(corners: list[Point]) -> list[list[Point]]:
    """A planar polygon as strictly convex pieces that have all its vertices."""
    n = normal_of(corners)
    ring = list(corners)
    pieces: list[list[Point]] = []
    while len(ring) > 3 and not all(turn(n, ring, k) > 0 for k in range(len(ring))):
        for k in range(len(ring)):
            a, b, c = ring[k - 1], ring[k], ring[(k + 1) % len(ring)]
            others = [p for p in ring if p not in (a, b, c)]
            if turn(n, ring, k) > 0 and not any(within(n, (a, b, c), p) for p in others):
                pieces.append([a, b, c])
                del ring[k]
                break
        else:
            raise ValueError("no ear")
    return [*pieces, ring]


def turn(n: Point, ring: list[Point], k: int) -> Fraction:
    a, b, c = ring[k - 1], ring[k], ring[(k + 1) % len(ring)]
    return dot(n, cross(minus(b, a), minus(c, b)))


def within(n: Point, triangle: tuple[Point, ...], p: Point) -> bool:
    return all(
        dot(n, cross(minus(triangle[(k + 1) % 3], triangle[k]), minus(p, triangle[k]))) >= 0
        for k in range(3)
    )


def convex_faces(shell: Shell) -> list[list[Point]]:
    return [piece for face in shell[1] for piece in fan(corners_of(shell, face))]
