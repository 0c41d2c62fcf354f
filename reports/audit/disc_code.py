"""Events of two swept-disc features from the code of `reference/disc`, corrected or with printed
sentences of the Appendix, beside the symbolic oracle's events."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sp
from minkref import _core
from minkref.fuzz.judges.disc.paper_disc import Feature, Vertex, touches
from minkref.reports.audit.disc import exact
from minkref.reports.audit.entry import CheckFailed, text

CODE = ("reference/disc/pairs/feature_pair.hpp", "reference/disc/pairs/pair_contact.hpp")


@dataclass(frozen=True)
class CodeEvent:
    """An event at one scale: the change to the features' shared points, their counts before, at and
    after the event (-1: a segment), and whether the place lies on both features."""

    scale: Any  # a number of sympy
    change: str
    shared: tuple[int, int, int]
    meets: bool


def code_events(
    first: Feature, second: Feature, radius: int, printed: Sequence[str] = ()
) -> list[CodeEvent]:
    """Events, ascending. `printed`: sentences taken literally (docs/disc.md)."""
    rows = _core.disc_pair(_texts(first), _texts(second), list(printed), radius == 1)
    return [
        CodeEvent(_root(found) / radius, change, shared, any(meets for *_, meets, _ in contacts))
        for change, found, shared, contacts in rows
    ]


def scales_by_both(first: Feature, second: Feature, radius: int) -> list[Any]:
    """Scales of two features' events, from the code; raises CheckFailed if the symbolic oracle
    finds other scales."""
    rows = _core.disc_pair(_texts(first), _texts(second))
    roots = {touch.root for touch in touches(first, second, radius)}
    values = sorted((exact(root) * radius for root in roots), key=float)
    if len(values) != len(rows) or not all(
        _is_root(value, found) for value, (_, found, _, _) in zip(values, rows, strict=True)
    ):
        raise CheckFailed(text((first, second, rows, values)))
    return [value / radius for value in values]


def scales_of_ends(first: Feature, second: Feature) -> list[Any]:
    """Scales at which an end of the first feature, an arc, meets the second feature's circle, from
    the code, for a disc of radius 1. Ascending."""
    return [
        _root(found)
        for _, found, _, contacts in _core.disc_pair(_texts(first), _texts(second))
        if any(contact[:2] == ("end on circle", "a") for contact in contacts)
    ]


def contacts_of_ring(ring: Sequence[Vertex]) -> int:
    """Number of contacts over all feature pairs of a polygon, from the code."""
    found = _core.disc_pair_events(_polygon(ring))
    return sum(len(event[3]) for *_, event in found.rows(0, len(found)))


def polynomials_of_boundary(ring: Sequence[Vertex]) -> list[list[str]]:
    """Polynomials of the squared radii at which the boundary of polygon plus disc changes, from the
    code; monic, lowest coefficient first."""
    found = _core.diagram_events(_polygon(ring))
    return [polynomial for _, _, polynomial, *_ in found.rows(0, len(found))]


def lines_of_sum(ring: Sequence[Vertex]) -> list[tuple[str, ...]]:
    """Of the offset edges on the boundary of the sum of a polygon with a disc, by the code: the
    direction `(dx, dy)` and `c`, for which `dy x - dx y = c + s r |(dx, dy)|` at the scale s."""
    components = json.loads(_core.offset(_polygon(ring), "1").canonical_json())["components"]
    return [tuple(curve[1:]) for curve in components[0]["outer"] if curve[0] == "line"]


def _polygon(ring: Sequence[Vertex]) -> _core.PolygonSet:
    corners = ",".join(f'["{x}","{y}"]' for x, y in ring)
    return _core.PolygonSet.from_json(f'{{"polygons":[{{"outer":[{corners}],"holes":[]}}]}}')


def _texts(feature: Feature) -> list[tuple[str, str]]:
    return [(str(x), str(y)) for x, y in feature]


def _is_root(value: Any, found: Any) -> bool:
    """Whether the square is a root of the polynomial, and the number within the bounds."""
    _, polynomial, (low, high) = found
    square = sp.expand(value**2)
    total = sum((sp.Rational(c) * square**k for k, c in enumerate(polynomial)), sp.Integer(0))
    near = float(value)
    return bool(sp.expand(total) == 0) and low * (1 - 1e-12) <= near <= high * (1 + 1e-12)


def _root(found: Any) -> Any:
    """The radius, whose square is a root of a polynomial of degree 1 or 2."""
    _, polynomial, (low, _) = found
    c = [sp.Rational(coefficient) for coefficient in polynomial]
    if len(c) == 2:
        return sp.sqrt(-c[0])
    half = sp.sqrt(c[1] ** 2 / 4 - c[0])
    return min(
        (sp.sqrt(-c[1] / 2 + way * half) for way in (-1, 1)),
        key=lambda root: abs(complex(root) - low),
    )
