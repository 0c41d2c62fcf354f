"""Checks the witness of an offset in plain fractions, from the definition alone: a point lies in P
grown by r iff its distance from P is at most r, and in P eroded by r iff its distance from the
outside of P is at least r. No code from the finder."""

from __future__ import annotations

import json
from fractions import Fraction
from typing import Any

from minkref.fuzz.verdicts.verdict import Witness

Pair = tuple[Fraction, Fraction]


def holds(P_json: str, witness: Witness) -> bool:
    """Whether the squared distance is as stated, the nearest feature has it, and the point lies in
    all sums with a radius of at least `radius` - `tolerance`, or in none with at most `radius` +
    `tolerance`; a radius below 0 erodes, likewise. O(n)."""
    rings = _rings(P_json)
    if witness.radius is None:
        return False
    if not rings:
        return not witness.in_truth and witness.squared_distance is None
    if witness.squared_distance is None or witness.nearest is None:
        return False
    x = (Fraction(witness.point[0]), Fraction(witness.point[1]))
    radius, half = Fraction(witness.radius), Fraction(witness.tolerance)
    square = squared_distance(rings, x, radius < 0)
    if square != Fraction(witness.squared_distance) or square != _of_feature(witness.nearest, x):
        return False
    if radius < 0:
        within = square >= (half - radius) ** 2
        return within if witness.in_truth else -radius >= half and square < (radius + half) ** 2
    if witness.in_truth:
        return radius >= half and square <= (radius - half) ** 2
    return square > (radius + half) ** 2


def squared_distance(rings: list[list[Pair]], x: Pair, from_outside: bool = False) -> Fraction:
    """Measures from the rings and all points within, or from all points outside."""
    pairs = [(ring[k - 1], ring[k]) for ring in rings for k in range(len(ring))]
    winding = 0
    for (ax, ay), (bx, by) in pairs:
        side = (bx - ax) * (x[1] - ay) - (by - ay) * (x[0] - ax)
        if ay <= x[1] < by and side > 0:
            winding += 1
        if by <= x[1] < ay and side < 0:
            winding -= 1
    if bool(winding) != from_outside:
        return Fraction(0)
    return min(_from_segment(x, a, b) for a, b in pairs)


def _from_segment(x: Pair, a: Pair, b: Pair) -> Fraction:
    ux, uy, wx, wy = b[0] - a[0], b[1] - a[1], x[0] - a[0], x[1] - a[1]
    length = ux * ux + uy * uy
    t = (
        Fraction(0)
        if not length
        else min(max((ux * wx + uy * wy) / length, Fraction(0)), Fraction(1))
    )
    return (wx - t * ux) ** 2 + (wy - t * uy) ** 2


def _of_feature(nearest: tuple[str, ...], x: Pair) -> Fraction | None:
    kind, numbers = nearest[0], [Fraction(number) for number in nearest[1:]]
    if kind in ("inside", "outside"):
        return Fraction(0)
    if kind == "vertex" and len(numbers) == 2:
        return (x[0] - numbers[0]) ** 2 + (x[1] - numbers[1]) ** 2
    if kind == "edge" and len(numbers) == 4:
        return _from_segment(x, (numbers[0], numbers[1]), (numbers[2], numbers[3]))
    return None


def _rings(text: str) -> list[list[Pair]]:
    polygons: list[dict[str, Any]] = json.loads(text)["polygons"]
    return [
        [(Fraction(x), Fraction(y)) for x, y in ring]
        for polygon in polygons
        for ring in (polygon["outer"], *polygon["holes"])
    ]
