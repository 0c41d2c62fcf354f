"""Proves by intervals with sixty digits that a place is a vertex of the outer Voronoi diagram.

Three features single out a place: a zero of three equations in its coordinates and its distance r.
Krawczyk's test proves that a small box holds one zero. Then no edge may lie nearer than r."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from enum import StrEnum
from fractions import Fraction
from itertools import combinations
from typing import Any

from minkref.fuzz.features.outline import Feature, Outline, Piece
from mpmath import iv, mp

DIGITS = 60
BOX = 1e-40  # half a side, of the size of the set and the radius
NEAR = 1e-6  # times the radius: closer edges are compared exactly
ROUNDED = 1e-13  # times the size: rounding of a distance in doubles
APART = 1e-8  # times size and radius: most distance between zero and place
STEPS = 12  # in Newton's iteration
Vector = list[Any]


class Ruling(StrEnum):
    VERTEX = "a vertex"
    PART = "a vertex of more features"
    NONE = "no vertex"
    UNDECIDED = "not decided"


def settle(
    outline: Outline, features: frozenset[Feature], spot: tuple[float, float], radius: float
) -> tuple[Ruling, str]:
    """Whether a place near `spot` is as far from all features, outside of the set, and from no edge
    less; and why, in words. Equal distance of more than three features is told to sixty digits."""
    old_digits = mp.dps, iv.dps
    mp.dps = iv.dps = DIGITS
    try:
        return _settle(outline, features, spot, radius)
    finally:
        mp.dps, iv.dps = old_digits


def _settle(
    outline: Outline, features: frozenset[Feature], spot: tuple[float, float], radius: float
) -> tuple[Ruling, str]:
    size = max(outline.size, radius)
    far_away = ""
    for chosen in combinations(sorted(features, key=str), 3):
        box = _place(chosen, spot, radius, BOX * size)
        if box is None:
            continue
        x, y, r = (float(mp.mpf(side.mid)) for side in box)
        if math.dist((x, y), spot) > APART * size or r <= 0:
            far_away = f"these are as far from ({x:.17g}, {y:.17g}) alone"
            continue
        if not outline.is_outside(x, y):
            return Ruling.NONE, "the place is in the set"
        return _among_edges(outline, features, box, r)
    if far_away:
        return Ruling.NONE, far_away
    return Ruling.UNDECIDED, "no three of the features are proven to single out a place"


def _among_edges(
    outline: Outline, features: frozenset[Feature], box: Vector, r: float
) -> tuple[Ruling, str]:
    tied: set[Feature] = set()
    x, y = (float(mp.mpf(side.mid)) for side in box[:2])
    for piece in outline.pieces:
        if piece.rounded_distance(x, y) > r * (1 + NEAR) + ROUNDED * outline.size:
            continue
        for feature, square in _feet(piece, box):
            over = square - box[2] ** 2
            if over.b < 0:
                return Ruling.NONE, f"{_name(feature)} is nearer"
            if over.a <= 0:
                tied.add(feature)
    for feature in features - tied:
        return Ruling.NONE, f"{_name(feature)} is farther"
    straight = {vertex for vertex in tied if features & set(outline.straight.get(vertex, []))}
    if tied - straight - features:
        told = ", ".join(map(_name, tied - straight - features))
        return Ruling.PART, f"proven to be as far from these, and to sixty digits from {told}"
    return Ruling.VERTEX, "proven to be as far from these, and no edge is nearer"


def _name(feature: Feature) -> str:
    return " ".join(map(str, feature))


def _is_on(vertex: Feature, line: Feature) -> bool:
    return bool(line[2] * vertex[1] - line[1] * vertex[2] == line[3])


def _place(
    chosen: Sequence[Feature], spot: tuple[float, float], radius: float, half: float
) -> Vector | None:
    """A box proven to hold one zero: x, y and r. None if the proof fails."""
    at: Vector = [mp.mpf(spot[0]), mp.mpf(spot[1]), mp.mpf(radius)]
    inverse: list[Vector] = []
    for _ in range(STEPS):
        values, slopes = _equations(chosen, at, mp)
        inverse = _inverse(slopes)
        if not inverse:
            return None
        at = [at[i] - sum(inverse[i][k] * values[k] for k in range(3)) for i in range(3)]
    middle = [iv.mpf(c) for c in at]
    side = iv.mpf([-half, half])
    box = [c + side for c in middle]
    values, slopes = _equations(chosen, middle, iv)[0], _equations(chosen, box, iv)[1]
    found = []
    for i in range(3):
        bent = middle[i]
        for k in range(3):
            bent -= iv.mpf(inverse[i][k]) * values[k]
        for k in range(3):
            slope = sum(iv.mpf(inverse[i][j]) * slopes[j][k] for j in range(3))
            bent += (iv.mpf(int(i == k)) - slope) * side
        if not (bent.a > box[i].a and bent.b < box[i].b):
            return None
        found.append(bent)
    return found


def _inverse(rows: Sequence[Vector]) -> list[Vector]:
    """Returns the inverse matrix, or an empty list."""
    a, b, c = rows
    over = [_crossed(b, c), _crossed(c, a), _crossed(a, b)]
    determinant = sum(a[k] * over[0][k] for k in range(3))
    if determinant == 0:
        return []
    return [[column[k] / determinant for column in over] for k in range(3)]


def _crossed(a: Vector, b: Vector) -> Vector:
    return [a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3] for k in range(3)]


def _equations(chosen: Sequence[Feature], at: Vector, numbers: Any) -> tuple[Vector, list[Vector]]:
    """Values and derivatives; values vanish where the third coordinate equals the distance to all
    features. A line and a vertex on it are equally far right in front of the vertex."""
    x, y, r = at
    values, slopes = [], []
    lines = [feature for feature in chosen if feature[0] == "line"]
    for feature in chosen:
        if feature[0] == "line":
            dx, dy, c = (_exact(part, numbers) for part in feature[1:])
            length = numbers.sqrt(dx * dx + dy * dy)
            values.append((dy * x - dx * y - c) / length - r)
            slopes.append([dy / length, -dx / length, numbers.mpf(-1)])
            continue
        u, v = (_exact(part, numbers) for part in feature[1:])
        through = next((line for line in lines if _is_on(feature, line)), None)
        if through is not None:
            dx, dy = (_exact(part, numbers) for part in through[1:3])
            values.append(dx * (x - u) + dy * (y - v))
            slopes.append([dx, dy, numbers.mpf(0)])
            continue
        values.append((x - u) ** 2 + (y - v) ** 2 - r**2)
        slopes.append([2 * (x - u), 2 * (y - v), -2 * r])
    return values, slopes


def _exact(value: Fraction | int, numbers: Any) -> Any:
    return numbers.mpf(value.numerator) / numbers.mpf(value.denominator)


def _feet(piece: Piece, box: Vector) -> Iterator[tuple[Feature, Any]]:
    """Yields a piece's possibly nearest features, with squared distances. If the foot may be an
    end, these are the end and the line."""
    x, y, _ = box
    ax, ay = (_exact(c, iv) for c in piece.start)
    bx, by = (_exact(c, iv) for c in piece.end)
    dx, dy = (_exact(c, iv) for c in piece.along)
    after_start = dx * (x - ax) + dy * (y - ay)
    after_end = dx * (x - bx) + dy * (y - by)
    if not after_start.a > 0:
        yield ("vertex", *piece.start), (x - ax) ** 2 + (y - ay) ** 2
    if not after_end.b < 0:
        yield ("vertex", *piece.end), (x - bx) ** 2 + (y - by) ** 2
    over = dy * (x - ax) - dx * (y - ay)
    is_inside = after_start.a > 0 and after_end.b < 0
    if is_inside or not (after_start.b < 0 or after_end.a > 0 or over.b < 0):
        yield piece.line, over**2 / (dx * dx + dy * dy)
