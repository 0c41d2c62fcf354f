"""Pictures of a set grown or eroded by a disc: arcs as paths of many short steps."""

from __future__ import annotations

import json
from fractions import Fraction

from minkref import _core
from minkref.fuzz.offsets.drawn_curves import drawn_curves
from minkref.fuzz.verdicts.verdict import Outcome
from minkref.reports.conformance.plane_pictures import Picture, comparison_pictures

STEPS = 180  # of a whole circle


def offset_pictures(expected: str, radius: Fraction, outcome: Outcome) -> list[Picture]:
    """Expected, got and difference, where the pictures' polygons differ."""
    got = outcome.got
    if got is not None and "components" in json.loads(got):
        got = _polygons(got, radius)
    return comparison_pictures(_polygons(expected, radius), outcome, got)


def _polygons(text: str, radius: Fraction) -> str:
    """Curves as polygons, in canonical JSON; polygons as they are."""
    if "polygons" in json.loads(text):
        return text
    origin = _origin(text)
    drawn = drawn_curves(text, abs(radius), origin)
    rings = [
        [
            [(origin[0] + Fraction(x), origin[1] + Fraction(y)) for x, y in path]
            for path in ([p for piece in ring for p in piece.path(STEPS)] for ring in rings)
            if len(set(path)) > 2
        ]
        for rings in drawn.rings
    ]
    found, *_ = _core.region_of_rings([each for each in rings if each], radius < 0)
    canonical: str = found.canonical_json()
    return canonical


def _origin(text: str) -> tuple[Fraction, Fraction]:
    """The centre of an arc: each ring has one."""
    components = json.loads(text)["components"]
    curves = [curve for each in components for curve in each["outer"] if curve[0] == "arc"]
    return (
        (Fraction(curves[0][1]), Fraction(curves[0][2])) if curves else (Fraction(0), Fraction(0))
    )
