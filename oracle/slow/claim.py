"""Compares a claimed polygon set with the sum; finds a rational point inside the difference.

Ring parity defines both sets, so even a very wrong claim has a meaning. Take a piece of a line that
belongs to one set's edges an odd number of times and to the other's an even number of times: of two
points close to the piece, on either side, exactly one set contains one.
"""

from __future__ import annotations

import itertools
from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction

from .exact import InputError, Point
from .minkowski import minkowski_sum
from .operand import Operand
from .place import inside
from .witness import Meeting, witness

Ring = Sequence[Point]


@dataclass(frozen=True)
class Claim:
    """The comparison's result. `equal`: the claim and the sum are the same set. `canonical`: their
    texts are equal too (rings, with order and starts). Otherwise `point` lies in the interior of
    the difference, `in_truth` tells whether the sum contains `point`, and `proof` shows how."""

    equal: bool
    canonical: bool
    point: Point | None
    in_truth: bool
    proof: Meeting | None


def check_claim(P: Operand, Q: Operand, scale: Fraction, claim: Operand) -> Claim:
    """Compare a claim with the sum. Exact. InputError if the claim is no polygon set, or if
    `minkowski_sum` refuses the operands. Cost: the sum, and the square of both sets' edges at
    worst. The proof does not use the sum."""
    if claim.ends:
        raise InputError("a claim is a polygon set or empty, no point or segment")
    truth = minkowski_sum(P, Q, scale)
    point = difference(claim.rings(), Operand(truth.polygons, []).rings())
    if point is None:
        same = claim.polygons == truth.polygons
        return Claim(True, same, None, False, None)
    proof = witness(P, Q, scale, point)
    return Claim(False, False, point, proof.in_sum, proof)


def difference(one: Sequence[Ring], other: Sequence[Ring]) -> Point | None:
    """Find a point in the interior of two sets' symmetric difference; None for equal sets."""
    for start, end in lone_pieces(one, other):
        middle = ((start[0] + end[0]) / 2, (start[1] + end[1]) / 2)
        way = (start[1] - end[1], end[0] - start[0])
        for sign in (1, -1):
            normal = (sign * way[0], sign * way[1])
            t = min(hits(middle, normal, [*one, *other]), default=Fraction(1)) / 2
            point = (middle[0] + t * normal[0], middle[1] + t * normal[1])
            if inside(one, point) != inside(other, point):
                return point
    return None


def edges_of(rings: Sequence[Ring]) -> Iterator[tuple[Point, Point]]:
    for ring in rings:
        for index, point in enumerate(ring):
            yield ring[index - 1], point


def lone_pieces(one: Sequence[Ring], other: Sequence[Ring]) -> Iterator[tuple[Point, Point]]:
    """Yield pieces that belong to one set's edges an odd number of times, to the other's an even
    number. Cuts a piece wherever another edge meets its line, so no other edge contains its
    middle."""
    every = [*edges_of(one), *edges_of(other)]
    lines: dict[tuple[Fraction, ...], list[tuple[Point, Point]]] = defaultdict(list)
    for a, b in every:
        lines[line_of(a, b)].append((min(a, b), max(a, b)))
    for line, edges in lines.items():
        # An odd count over both sets means an odd count for exactly one set.
        odd: set[Point] = set()
        for a, b in edges:
            odd ^= {a, b}
        stops = sorted(odd)
        for a, b in zip(stops[::2], stops[1::2], strict=True):
            cuts = sorted({a, b, *(p for p in meetings(line, every) if a < p < b)})
            yield from itertools.pairwise(cuts)


def line_of(a: Point, b: Point) -> tuple[Fraction, ...]:
    """Return the line through two points, as u x + v y = w with u = 1, or u = 0 and v = 1."""
    u, v = b[1] - a[1], a[0] - b[0]
    first = u or v
    return u / first, v / first, (u * a[0] + v * a[1]) / first


def meetings(line: tuple[Fraction, ...], edges: Sequence[tuple[Point, Point]]) -> Iterator[Point]:
    u, v, w = line
    for a, b in edges:
        at_a, at_b = u * a[0] + v * a[1] - w, u * b[0] + v * b[1] - w
        if at_a == 0:
            yield a
        if at_b == 0:
            yield b
        if at_a * at_b < 0:
            t = at_a / (at_a - at_b)
            yield a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])


def hits(middle: Point, way: Point, rings: Sequence[Ring]) -> Iterator[Fraction]:
    """Yield the parameters t > 0 where middle + t way hits an edge."""
    level = way[0] * middle[1] - way[1] * middle[0]
    for a, b in edges_of(rings):
        at_a = way[0] * a[1] - way[1] * a[0] - level
        at_b = way[0] * b[1] - way[1] * b[0] - level
        if at_a * at_b > 0:
            continue
        points = [a, b]
        if at_a != at_b:
            t = at_a / (at_a - at_b)
            points = [(a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]))]
        norm = way[0] ** 2 + way[1] ** 2
        for x, y in points:
            reach = ((x - middle[0]) * way[0] + (y - middle[1]) * way[1]) / norm
            if reach > 0:
                yield reach
