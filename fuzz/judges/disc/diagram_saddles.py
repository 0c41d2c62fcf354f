"""Places right between two features nearest to each other, from the edges of an outer Voronoi
diagram. All numbers are rational and exact."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from fractions import Fraction

from minkref.fuzz.features.outline import Feature, Outline, Piece, Point

NEAR = 1e-9  # times the set's size: closer candidates are compared exactly


@dataclass(frozen=True)
class Saddle:
    at: Point
    squared_radius: Fraction
    features: frozenset[Feature]


def saddles(outline: Outline, sides: Iterable[frozenset[Feature]]) -> list[Saddle]:
    """Finds places equally far from exactly two features, among pairs of features."""
    pairs = [tuple(pair) for pair in sides]
    beside: dict[Feature, set[Feature]] = {}
    for a, b in pairs:
        beside.setdefault(a, set()).add(b)
        beside.setdefault(b, set()).add(a)
    of_feature: dict[Feature, list[Piece]] = {}
    for piece in outline.pieces:
        for feature in (piece.line, ("vertex", *piece.start), ("vertex", *piece.end)):
            of_feature.setdefault(feature, []).append(piece)
    found = []
    for pair in pairs:
        place = _between(*sorted(pair, key=lambda feature: feature[0]))
        if place is None or not outline.is_outside(float(place[0][0]), float(place[0][1])):
            continue
        around = {piece for own in pair for f in (own, *beside[own]) for piece in of_feature[f]}
        # The neighbours first: they refute most.
        if _nearest(outline, place, around) and _nearest(outline, place, outline.pieces) == set(
            pair
        ):
            found.append(Saddle(*place, frozenset(pair)))
    return found


def _between(line: Feature, vertex: Feature) -> tuple[Point, Fraction] | None:
    """The middle between a line and a vertex, or two vertices, and its squared distance to both."""
    if vertex[0] == "line":
        return None
    x, y = vertex[1:]
    if line[0] == "vertex":
        u, v = line[1:]
    else:
        _, dx, dy, c = line
        over = (dy * x - dx * y - c) / Fraction(dx * dx + dy * dy)
        u, v = x - over * dy, y + over * dx
    square = ((u - x) ** 2 + (v - y) ** 2) / 4
    return (((u + x) / 2, (v + y) / 2), square) if square > 0 else None


def _nearest(
    outline: Outline, place: tuple[Point, Fraction], pieces: Iterable[Piece]
) -> set[Feature]:
    """Returns the features among the pieces at the distance in `place`; none if a piece lies
    nearer."""
    (x, y), square = place
    u, v = float(x), float(y)
    reach = float(square) ** 0.5 + NEAR * outline.size
    found: set[Feature] = set()
    for piece in pieces:
        if piece.rounded_distance(u, v) > reach:
            continue
        for feature, own in _feet(piece, x, y):
            if own < square:
                return set()
            if own == square:
                found.add(feature)
    # A vertex on a straight line counts as no feature.
    return {f for f in found if not found & set(outline.straight.get(f, []))}


def _feet(piece: Piece, x: Fraction, y: Fraction) -> Iterator[tuple[Feature, Fraction]]:
    """Yields a piece's nearest features, with squared distances. Right in front of an end these are
    the end and the line, unless the place lies behind the line."""
    dx, dy = piece.along
    (ax, ay), (bx, by) = piece.start, piece.end
    after_start = (x - ax) * dx + (y - ay) * dy
    after_end = (x - bx) * dx + (y - by) * dy
    if after_start <= 0:
        yield ("vertex", *piece.start), (x - ax) ** 2 + (y - ay) ** 2
    if after_end >= 0:
        yield ("vertex", *piece.end), (x - bx) ** 2 + (y - by) ** 2
    over = (x - ax) * dy - (y - ay) * dx
    is_inside = after_start > 0 and after_end < 0
    if is_inside or (after_start >= 0 and after_end <= 0 and over > 0):
        yield piece.line, over**2 / (dx * dx + dy * dy)
