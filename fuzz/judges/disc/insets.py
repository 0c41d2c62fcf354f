"""Judges erosions by a disc by exact distances from P's boundary."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import TypeVar

from minkref import _core
from minkref.disc.disc import Disc
from minkref.disc.polygons import inset_near
from minkref.errors import Refusal
from minkref.fuzz.judges.disc.inset_remnants import remnant_faults, sides_of
from minkref.fuzz.plane.families.catalogue import FAMILIES
from minkref.fuzz.plane.families.dice import Dice

Place = tuple[Fraction, Fraction]
N = TypeVar("N", Fraction, float)
FROM = (
    "random",
    "holes",
    "fit",
    "comb",
    "lattice",
    "cells",
    "touching",
    "nested",
    "spiral",
    "star",
)
MOST = 60  # vertices
POINTS = 40


def inset_case(seed: int, index: int) -> tuple[_core.PolygonSet, str, _core.DiscIndex]:
    """Draw a set and a squared radius, every third at an event; index the outside."""
    attempt = 0
    while True:
        dice = Dice(f"minkref insets {seed} {index} {attempt}")
        attempt += 1
        pair = FAMILIES[dice.choice(FROM)].pair(seed, index // 4 + dice.randrange(40))
        P = _core.PolygonSet.from_json(pair.P)
        if not P.is_region or P.vertices > MOST:
            continue
        around = _core.disc_index(_core.Outside(P).set)
        rows = around.rows(0, len(around.kinds()))
        squares = [row[1] for row in rows if row[1] is not None]
        if index % 3 == 2 and squares:
            return P, dice.choice(squares), around
        largest = Fraction(around.radii()[-1][1])
        share = Fraction(dice.randint(1, 36), 32)
        radius = (share * largest).limit_denominator(1000) or Fraction(1, 1000)
        return P, str(radius**2), around


def inset_faults(seed: int, index: int) -> tuple[int, list[str]]:
    """Compare, count comparisons, list faults."""
    P, square, around = inset_case(seed, index)
    found, other = _core.inset(P, square), _core.inset(P, square, 1, "paper")
    faults: list[str] = []
    count = 0

    def expect(what: str, holds: bool) -> None:
        nonlocal count
        count += 1
        if not holds:
            faults.append(f"insets:{seed}:{index}, squared radius {square}: {what}")

    expect("the routes differ", found.canonical_json() == other.canonical_json())
    bodies, holes = around.counts(square)
    expect("components and holes", (found.components, found.holes) == (holes, bodies - 1))
    low, high = map(Fraction, around.radii()[-1])
    below, above = (_core.inset(P, str(r * r)) for r in (low - low / 10**9, high + high / 10**9))
    expect("less than the inradius leaves nothing", below.components > 0)
    expect("more than the inradius leaves something", not above.components + above.holes)
    expect("more than the inradius leaves a remnant", not above.tight_passages())
    _vertices(expect, found, P, float(Fraction(square)))
    _polygons(expect, found, P, Fraction(square), Dice(f"minkref inset points {seed} {index}"))
    passages = found.tight_passages()
    for points, _, contacts in passages:
        expect("a remnant without two contacts", len(points) in (1, 2) and len(contacts) > 1)
    spots = [spots for _, spots, _ in passages]
    told = list(remnant_faults(P, Fraction(square), around, spots))
    for fault in told or [""]:
        expect(fault, not fault)
    return count, faults


def _vertices(expect: object, found: _core.Offset, P: _core.PolygonSet, square: float) -> None:
    """Check that drawn corners keep the radius as distance, up to rounding."""
    assert callable(expect)
    sides = [[(float(x), float(y)) for x, y in side] for side in sides_of(P)]
    size = max(abs(c) for side in sides for point in side for c in point) + 1
    for rings in found.drawn_rings():
        for ring in rings:
            for piece in ring:
                away = min(_away((piece[1], piece[2]), *side) for side in sides)
                off = abs(math.sqrt(away) - math.sqrt(square))
                expect("a corner at another distance", off < 1e-9 * size)


def _polygons(
    expect: object, found: _core.Offset, P: _core.PolygonSet, square: Fraction, dice: Dice
) -> None:
    """Check polygon sets inside and around, and random points, by exact distances."""
    assert callable(expect)
    disc = Disc("disc", square)
    within = Fraction(1, 50)
    try:
        inner, outer = (inset_near(P, disc, within, outside) for outside in (False, True))
    except Refusal:
        return
    sides = sides_of(P)
    for polygon in inner.rings():
        for x in (x for ring in polygon for x in ring):
            expect("a corner inside is too near", x in P and _nearest(x, sides) >= square)
    expect("the area", Fraction(inner.area()) <= Fraction(found.area[1]))
    expect("the area around", Fraction(outer.area()) >= Fraction(found.area[0]))
    low, high = disc.bounds(60)
    left, bottom, right, top = map(Fraction, P.bounding_box())
    for _ in range(POINTS):
        s, t = (Fraction(dice.randrange(1 << 20), 1 << 20) for _ in range(2))
        x = (left + s * (right - left), bottom + t * (top - bottom))
        away = _nearest(x, sides) if x in P else Fraction(-1)
        expect("a point inside is too near", x not in inner or away >= square)
        expect("a point with room is left out", away < (high + within) ** 2 or x in inner)
        expect("a point with room is outside", away < square or x in outer)
        bound = max(low - within, Fraction(0)) ** 2
        expect("a point around is too near", x not in outer or away >= bound)


def _nearest(x: Place, sides: list[tuple[Place, Place]]) -> Fraction:
    return min(_away(x, *side) for side in sides)


def _away(x: tuple[N, N], a: tuple[N, N], b: tuple[N, N]) -> N:
    """Return the squared distance from a segment."""
    u, v = (b[0] - a[0], b[1] - a[1]), (x[0] - a[0], x[1] - a[1])
    length, along = u[0] * u[0] + u[1] * u[1], u[0] * v[0] + u[1] * v[1]
    if along <= 0:
        return v[0] * v[0] + v[1] * v[1]
    if along >= length:
        w = (x[0] - b[0], x[1] - b[1])
        return w[0] * w[0] + w[1] * w[1]
    cross = u[0] * v[1] - u[1] * v[0]
    return cross * cross / length
