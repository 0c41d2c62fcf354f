"""Whether a place is a vertex of the outer Voronoi diagram, proven by intervals of sixty digits.

Three features single out a place: a zero of three equations in its coordinates and its distance r.
Krawczyk's test proves that a small box holds one zero. Then no edge may be nearer than r."""

from __future__ import annotations

import math
from collections.abc import Sequence
from enum import StrEnum
from fractions import Fraction
from itertools import combinations
from typing import Any

from minkref.fuzz.judges.outer_diagram import Feature, Outline, Piece
from mpmath import iv, mp

DIGITS = 60
BOX = 1e-40  # half a side, of the size of the set and the radius
NEAR = 1e-6  # of the radius: edges that are looked at exactly
ROUNDED = 1e-13  # of the size: a distance in doubles
APART = 1e-8  # of size and radius: how far the zero may be from the place
STEPS = 12  # of Newton's iteration
Vector = list[Any]


class Ruling(StrEnum):
    VERTEX = "a vertex"
    NONE = "no vertex"
    UNDECIDED = "not decided"


def settle(
    outline: Outline, features: frozenset[Feature], spot: tuple[float, float], radius: float
) -> tuple[Ruling, str]:
    """Whether a place near `spot` is as far from all features, outside of the set, and from no edge
    less; and why, in words."""
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
        if _rounded_distance(piece, x, y) > r * (1 + NEAR) + ROUNDED * outline.size:
            continue
        feature, square = _squared_distance(piece, box)
        over = square - box[2] ** 2
        if over.b < 0:
            return Ruling.NONE, f"{_name(feature)} is nearer"
        if over.a <= 0:
            tied.add(feature)
    for feature in features:
        if feature[0] == "line":  # in front of an end its line is as near as the end
            ends = {("vertex", *p) for e in outline.pieces if e.line == feature
                    for p in (e.start, e.end)}  # fmt: skip
            if feature in tied or ends & tied & features:
                continue
        elif feature in tied:
            continue
        elif any(line in tied for line in _through(feature, features)):
            continue
        return Ruling.NONE, f"{_name(feature)} is farther"
    return Ruling.VERTEX, "proven to be as far from these, and no edge is nearer"


def _through(vertex: Feature, features: frozenset[Feature]) -> list[Feature]:
    return [f for f in features if f[0] == "line" and _is_on(vertex, f)]


def _name(feature: Feature) -> str:
    return " ".join(map(str, feature))


def _is_on(vertex: Feature, line: Feature) -> bool:
    return bool(line[2] * vertex[1] - line[1] * vertex[2] == line[3])


def _place(
    chosen: Sequence[Feature], spot: tuple[float, float], radius: float, half: float
) -> Vector | None:
    """A box that is proven to hold one zero: x, y and r. None where that does not succeed."""
    at: Vector = [mp.mpf(spot[0]), mp.mpf(spot[1]), mp.mpf(radius)]
    try:
        for _ in range(STEPS):
            values, slopes = _equations(chosen, at, mp)
            step = mp.matrix(slopes) ** -1 * mp.matrix(values)
            at = [at[k] - step[k] for k in range(3)]
        inverse = mp.matrix(_equations(chosen, at, mp)[1]) ** -1
    except ZeroDivisionError:
        return None
    middle = [iv.mpf(c) for c in at]
    side = iv.mpf([-half, half])
    box = [c + side for c in middle]
    values, slopes = _equations(chosen, middle, iv)[0], _equations(chosen, box, iv)[1]
    found = []
    for i in range(3):
        bent = middle[i]
        for k in range(3):
            bent -= iv.mpf(inverse[i, k]) * values[k]
        for k in range(3):
            slope = sum(iv.mpf(inverse[i, j]) * slopes[j][k] for j in range(3))
            bent += (iv.mpf(int(i == k)) - slope) * side
        if not (bent.a > box[i].a and bent.b < box[i].b):
            return None
        found.append(bent)
    return found


def _equations(chosen: Sequence[Feature], at: Vector, numbers: Any) -> tuple[Vector, list[Vector]]:
    """Values and derivatives, zero where `at` is as far from all as its third member says. A line
    and a vertex on it are as far right in front of the vertex."""
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


def _squared_distance(piece: Piece, box: Vector) -> tuple[Feature, Any]:
    """From the nearest part of a piece. Where the foot may be an end or not, that end's: right in
    front of it both are the same."""
    x, y, _ = box
    ax, ay = (_exact(c, iv) for c in piece.start)
    bx, by = (_exact(c, iv) for c in piece.end)
    dx, dy = (_exact(c, iv) for c in piece.along)
    if not (dx * (x - ax) + dy * (y - ay)).a > 0:
        return ("vertex", *piece.start), (x - ax) ** 2 + (y - ay) ** 2
    if not (dx * (x - bx) + dy * (y - by)).b < 0:
        return ("vertex", *piece.end), (x - bx) ** 2 + (y - by) ** 2
    return piece.line, (dy * (x - ax) - dx * (y - ay)) ** 2 / (dx * dx + dy * dy)


def _rounded_distance(piece: Piece, x: float, y: float) -> float:
    (ax, ay), (dx, dy) = map(float, piece.start), map(float, piece.along)
    t = ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy)
    t = min(max(t, 0.0), 1.0)
    return math.hypot(x - ax - t * dx, y - ay - t * dy)
