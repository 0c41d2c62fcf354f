"""Findings about sets grown or eroded by a disc, judged once more: the distance of the witness from
the set or its outside, by the definition, in plain fractions. Shares no code with the judge of
`verify`."""

from __future__ import annotations

from fractions import Fraction
from typing import Any


def confirmed(finding: dict[str, Any]) -> bool:
    """Whether a finding's witness (from the document of `verify`) is as far from the set as stated,
    and in the grown set, or not, at each radius within the tolerance."""
    witness, operand = finding["witness"], finding["P"]["set"]
    if witness["squared_distance"] is None:
        return not operand["polygons"]
    x, y = map(Fraction, witness["point"])
    radius, half = Fraction(witness["radius"]), Fraction(witness.get("tolerance", "0"))
    square = squared(operand["polygons"], x, y, radius < 0)
    if Fraction(witness["squared_distance"]) != square:
        return False
    if radius < 0:
        bound = half - radius if witness["in_truth"] else -radius - half
        return bool(bound > 0 and (square >= bound**2) == witness["in_truth"])
    bound = radius - half if witness["in_truth"] else radius + half
    return bool(bound > 0 and (square <= bound**2) == witness["in_truth"])


def squared(
    polygons: list[dict[str, Any]], x: Fraction, y: Fraction, from_outside: bool = False
) -> Fraction:
    """0 in the set: rays to the right cross each polygon an odd number of times. Outside, 0 there
    and the distance from the boundary in the set."""
    least, is_in = None, False
    for polygon in polygons:
        crossings = 0
        for ring in (polygon["outer"], *polygon.get("holes", [])):
            points = [
                (Fraction(a) - x, Fraction(b) - y) for a, b in ring
            ]  # as seen from the witness
            for (a, b), (c, d) in zip(points, points[1:] + points[:1], strict=True):
                if (b > 0) != (d > 0) and a + (c - a) * b / (b - d) > 0:
                    crossings += 1
                far = _from_origin(a, b, c, d)
                least = far if least is None or far < least else least
        is_in = is_in or crossings % 2 == 1
    if is_in != from_outside:
        return Fraction(0)
    assert least is not None
    return least


def _from_origin(a: Fraction, b: Fraction, c: Fraction, d: Fraction) -> Fraction:
    """From the segment between (a, b) and (c, d)."""
    dx, dy = c - a, d - b
    length = dx * dx + dy * dy
    part = -(a * dx + b * dy)
    if part <= 0 or not length:
        return a * a + b * b
    if part >= length:
        return c * c + d * d
    return (a * d - b * c) ** 2 / length
