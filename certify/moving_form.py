"""The canonical form of a sum between two events: its vertices are linear in the scale."""

from __future__ import annotations

import json
from fractions import Fraction
from typing import Any


def moving_form(polygons: list[list[list[list[str]]]]) -> dict[str, Any]:
    """Of vertices x0, x1, y0, y1, the points (x0 + s x1, y0 + s y1), by polygon and ring, the outer
    one first: rings that start with their least vertex, in ascending order
    (docs/certificates.md)."""
    return _ordered([[[tuple(map(Fraction, v)) for v in ring] for ring in p] for p in polygons])


def form_at(form: str, s: Fraction) -> str:
    """The canonical JSON of a moving form at a scale at which no vertices meet."""
    polygons = [
        [
            [_place([Fraction(x) for x in v], s) for v in ring]
            for ring in (polygon["outer"], *polygon["holes"])
        ]
        for polygon in json.loads(form)["polygons"]
    ]
    return json.dumps(_ordered(polygons), sort_keys=True, separators=(",", ":"))


def _place(v: list[Fraction], s: Fraction) -> tuple[Fraction, ...]:
    return v[0] + s * v[1], v[2] + s * v[3]


def _ordered(polygons: list[list[list[tuple[Fraction, ...]]]]) -> dict[str, Any]:
    turned = [[_turned(ring) for ring in polygon] for polygon in polygons]
    ordered = sorted([polygon[0], *sorted(polygon[1:])] for polygon in turned)
    plain = [[[[str(x) for x in v] for v in ring] for ring in polygon] for polygon in ordered]
    return {"polygons": [{"holes": polygon[1:], "outer": polygon[0]} for polygon in plain]}


def _turned(ring: list[tuple[Fraction, ...]]) -> list[tuple[Fraction, ...]]:
    least = ring.index(min(ring))
    return ring[least:] + ring[:least]
