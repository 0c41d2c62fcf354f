"""Each double written for an exact number of a sum with a disc is the nearest double, or lies
within bounds as close as docs/disc.md says. Numbers with 1,500 bits judge."""

from __future__ import annotations

import json
import math
import random
from fractions import Fraction
from typing import Any

import pytest
from minkref import _core
from mpmath import mp, mpf
from sympy import Poly, Rational, Symbol
from true_boundary import TrueBoundary, number
from turned_shapes import KINDS, shape_json, turned_shape

NARROW = 2.0**-36  # of areas and lengths
COUNT = 42  # sums of each kind


def ulp(x: Any) -> float:
    return math.ulp(float(x))


def drawn_rings(found: _core.Offset) -> list[Any]:
    return [ring for rings in found.drawn_rings() for ring in rings]


def look_at_sum(P: _core.PolygonSet, square: Fraction, where: str) -> TrueBoundary:
    """Corners, bulges and measures of the static sum."""
    found = _core.offset(P, str(square))
    truth = TrueBoundary(json.loads(found.canonical_json()))
    drawn = drawn_rings(found)
    vertices = {(piece[1], piece[2]) for ring in drawn for piece in ring}
    for ring in truth.rings:
        for x, y in ring.corners:
            assert (float(x), float(y)) in vertices, (where, float(x), float(y))
    assert len(drawn) == len(truth.rings)
    for ring in drawn:
        for piece in ring:
            look_at_piece(piece, truth, where)
    for bounds, exact in zip((found.area, found.length), truth.measures(), strict=True):
        look_at_bounds(bounds, exact, where)
    return truth


def look_at_piece(piece: Any, truth: TrueBoundary, where: str) -> None:
    """Checks that an arc's ends lie on the circle and that its bulge fits the angle, both within
    the ends' rounding."""
    kind, x0, y0, x1, y1, cx, cy, bulge = piece
    if kind == "line":
        assert bulge == 0
        return
    off = 2 * max(ulp(value) for value in (x0, y0, x1, y1, cx, cy))
    for x, y in ((x0, y0), (x1, y1)):
        assert abs(mp.hypot(mpf(x) - cx, mpf(y) - cy) - truth.radius) <= off, where
    ax, ay, bx, by = mpf(x0) - cx, mpf(y0) - cy, mpf(x1) - cx, mpf(y1) - cy
    turn = mp.atan2(ax * by - ay * bx, ax * bx + ay * by)
    assert abs(mp.tan(turn / 4) - bulge) <= ulp(bulge) + 2 * off / truth.radius, where


def look_at_bounds(bounds: tuple[float, float], exact: Any, where: str) -> None:
    low, high = bounds
    assert math.isfinite(low) and math.isfinite(high), where
    assert low <= exact <= high, (where, low, float(exact), high)
    assert high - low <= NARROW * low, (where, bounds)


def look_at_index(index: _core.DiscIndex, radius: float, truth: TrueBoundary, where: str) -> None:
    """Vertices within their bounds, which are small; area and length, read off."""
    square = str(Fraction(radius) ** 2)
    for bounds, exact in zip(index.measures(square), truth.measures(), strict=True):
        look_at_bounds(bounds, exact, where)
    if index.at_event(square):
        return
    corners = [corner for ring in truth.rings for corner in ring.corners]
    points, starts = index.vertices(radius)
    assert len(starts) == len(truth.rings), where
    size = max((math.dist(map(float, a), map(float, corners[0])) for a in corners), default=0.0)
    for x, y, error in points.tolist():
        assert error <= 2.0**-41 * (size + radius) + 2.0**-49 * (abs(x) + abs(y)), (where, error)
        near = min(max(abs(x - u), abs(y - v)) for u, v in corners)
        assert near <= error, (where, x, y, error, float(near))


def look_at_events(rows: Any, where: str) -> None:
    """Checks that adjacent doubles bound a radius around a root of its polynomial, and that the
    event's place is equally close to its vertices."""
    for _, square, polynomial, (low, high), (x, y), features in rows:
        assert high in (low, math.nextafter(low, math.inf)), where
        coefficients = [Rational(str(c)) for c in reversed(polynomial)]
        squares = (Rational(str(Fraction(end) ** 2)) for end in (low, high))
        assert Poly(coefficients, Symbol("x")).count_roots(*squares) > 0, where
        if low == high:
            assert square is None or Fraction(square) == Fraction(low) ** 2
        for kind, u, v in features:
            if kind == "vertex":
                distance = mp.hypot(mpf(x) - number(u), mpf(y) - number(v))
                assert abs(distance - mpf(low)) <= 2 * (ulp(x) + ulp(y) + ulp(low)), where


@pytest.mark.parametrize("kind", KINDS)
def test_turned_shapes(kind: str) -> None:
    print("seed 46")
    for case in range(COUNT):
        dice = random.Random(f"46 {kind} {case}")
        shape, square = turned_shape(kind, dice)
        P = _core.PolygonSet.from_json(shape_json(shape))
        P.validate(kind)
        where = f"{kind} {case}: {P.to_json()} {square}"
        look_at_sum(P, square, where)
        if case % 6:
            continue
        index = _core.disc_index(P)
        radius = float(mp.sqrt(number(str(square)))) * dice.choice((1, 1, 0.75, 1.5))
        truth = look_at_sum(P, Fraction(radius) ** 2, where)
        look_at_index(index, radius, truth, where)
        look_at_events(index.rows(0, len(index.kinds())), where)


def sum_of(shape: str, square: Fraction) -> tuple[_core.Offset, TrueBoundary]:
    P = _core.read_text(shape, "wkt", "example")
    P.validate("example")
    return _core.offset(P, str(square)), look_at_sum(P, square, shape)


def test_the_corner_of_a_slot_that_a_disc_just_fills() -> None:
    """Walls parallel except for 10^-18: the hole's apex is at (3/2, 5/2)."""
    slot = "POLYGON ((0 0, 3 0, 3 4, 2 4, 2.000000000000000001 1, 1 1, 1 4, 0 4, 0 0))"
    found, _ = sum_of(slot, Fraction("0.50000000000000000025") ** 2)
    starts = {(piece[1], piece[2]) for ring in drawn_rings(found) for piece in ring}
    assert (1.5, 2.5) in starts


@pytest.mark.parametrize("route", ["definition", "paper"])
def test_far_from_the_origin_an_area_is_sharp(route: str) -> None:
    square = "POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0))"
    P = _core.read_text(square, "wkt", "example").translated("500000", "6500000")
    found = _core.offset(P, "1/4", 1, route)
    low, high = found.area
    assert low <= 100 + 20 + math.pi / 4 <= high and high - low < 1e-10


def test_vertices_beyond_doubles_are_refused() -> None:
    huge = _core.read_text("POLYGON ((0 0, 1e400 0, 0 1e400, 0 0))", "wkt", "example")
    with pytest.raises(_core.LimitExceeded, match="beyond the range of doubles"):
        _core.disc_index(huge).vertices(1.0)


def test_numbers_that_are_doubles_are_these() -> None:
    """Both bounds equal a radius that is a double, and zero is written 0."""
    frame = "POLYGON ((-4 -4, 4 -4, 4 4, -4 4, -4 -4), (-2 -2, -2 2, 2 2, 2 -2, -2 -2))"
    P = _core.read_text(frame, "wkt", "example")
    (row,) = [row for row in _core.diagram_events(P).rows(0, 99) if row[0] == "maximum"]
    assert row[3] == (2.0, 2.0) and row[4] == (0.0, 0.0)
    assert math.copysign(1, row[4][0]) == 1
    assert _core.disc_index(P).radii()[-1] == (2.0, 2.0)
