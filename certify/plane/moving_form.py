"""The canonical form of a sum between two events, with vertices linear in the scale."""

from __future__ import annotations

import json
from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

from minkref.exact import digest
from minkref.plane.rings import from_least


class Figure(NamedTuple):
    """The boundary at a scale, or between two: a canonical or moving form, as JSON, and the points
    that its rings pass more than once, as often as they come again, ascending."""

    form: str
    touching: list[tuple[Fraction, ...]]
    components: int
    holes: int

    @property
    def digest(self) -> str:
        return digest(self.form)

    def at(self, s: Fraction) -> Figure:
        """The figure of a moving form at a scale at which nothing happens."""
        touching = sorted(_place(list(v), s) for v in self.touching)
        return Figure(_form_at(self.form, s), touching, self.components, self.holes)


def figure(form: str, touching: Sequence[Sequence[str]], components: int, holes: int) -> Figure:
    """With points as texts, in any order."""
    return Figure(form, sorted(tuple(map(Fraction, v)) for v in touching), components, holes)


def moving_form(polygons: list[list[list[list[str]]]]) -> str:
    """The form of vertices x0, x1, y0, y1, the points (x0 + s x1, y0 + s y1), by polygon and ring,
    the outer ring first: rings start with their least vertex, in ascending order
    (docs/certificates.md)."""
    return _text([[[tuple(map(Fraction, v)) for v in ring] for ring in p] for p in polygons])


def _form_at(form: str, s: Fraction) -> str:
    """The canonical JSON of a moving form at a scale at which no vertices meet."""
    polygons = [
        [
            [_place([Fraction(x) for x in v], s) for v in ring]
            for ring in (polygon["outer"], *polygon["holes"])
        ]
        for polygon in json.loads(form)["polygons"]
    ]
    return _text(polygons)


def _place(v: list[Fraction], s: Fraction) -> tuple[Fraction, ...]:
    return v[0] + s * v[1], v[2] + s * v[3]


def _text(polygons: list[list[list[tuple[Fraction, ...]]]]) -> str:
    turned = [[from_least(ring) for ring in polygon] for polygon in polygons]
    ordered = sorted([polygon[0], *sorted(polygon[1:])] for polygon in turned)
    plain = [[[[str(x) for x in v] for v in ring] for ring in polygon] for polygon in ordered]
    value = {"polygons": [{"holes": polygon[1:], "outer": polygon[0]} for polygon in plain]}
    return json.dumps(value, sort_keys=True, separators=(",", ":"))
