"""Erosion, opening and closing, no-fit and inner-fit: values of Python (docs/erosion.md)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import pairwise
from typing import Any

from minkref import _core
from minkref.argument_types import expect_sets, scale_text, text_of
from minkref.errors import Refusal, choice
from minkref.exact import digest
from minkref.plane.parents import passage_values, place_of
from minkref.plane.small_picture import places_picture

Number = str | int | Fraction
PlaneScale = Number | Sequence[Number]
Passages = list[dict[str, Any]]


@dataclass(frozen=True)
class Erosion:
    """A closed set: a region, and remnants, points and polylines beside the region. Remnants have
    `points`, and features in `contacts` for each segment, like tight passages in `minkref sum
    --json`; openings name no contacts. `components` and `holes` count the region's. `point in
    erosion` asks the whole closed set."""

    region: _core.PolygonSet
    components: int
    holes: int
    remnants: Passages = field(compare=False)
    points: tuple[tuple[tuple[Fraction, Fraction], ...], ...]
    seconds: float = field(compare=False, default=0.0)

    @property
    def is_empty(self) -> bool:
        """Tell whether nothing is left."""
        return self.region.is_empty and not self.remnants

    @property
    def area(self) -> Fraction:
        """The exact area."""
        return Fraction(self.region.area())

    @property
    def digest(self) -> str:
        """The SHA-256 of the region's canonical JSON."""
        return digest(self.region.canonical_json())

    def _repr_svg_(self) -> str:
        """The picture in a notebook, with remnants."""
        return places_picture(self, "erosion", self.remnants)

    def __contains__(self, point: object) -> bool:
        if point in self.region:
            return True
        return any(point in _core.PolygonSet(piece) for one in self.points for piece in _ways(one))


@dataclass(frozen=True)
class NoFit:
    """Places of a moving shape beside a fixed shape. `region`: the closed set of places where both
    meet. On the region's boundary and at `exact_fits` they touch without overlap; elsewhere inside,
    interiors overlap."""

    region: _core.PolygonSet
    components: int
    holes: int
    exact_fits: Passages = field(compare=False)
    seconds: float = field(compare=False, default=0.0)

    def _repr_svg_(self) -> str:
        """The picture in a notebook, with exact fits."""
        return places_picture(self, "no-fit", self.exact_fits)


def erode(
    P: _core.PolygonSet, Q: _core.PolygonSet, scale: PlaneScale = 1, route: str = "paper"
) -> Erosion:
    """Compute the erosion of P, scaled by `scale` > 0 about the origin, by Q: all places x with
    x + Q within the scaled P, also called Minkowski difference. `scale`: one factor, or one for
    each axis.

    Exact and in canonical form, with its remnants: places where Q fits exactly. Either operand may
    be a segment or a point. The routes `paper`, `winding` and `definition` give the same. Both
    operands are validated first. Takes the time of the sum of P's outside and -Q; none where Q's
    box does not fit into that of P. Raises BadInput, also for an empty Q. docs/erosion.md."""
    _validate(P=P, Q=Q)
    if text_of("route", route) not in _core.ROUTES:
        what = f"there is no route {route!r}"
        raise Refusal(what, "route", choice(route, tuple(_core.ROUTES)), "unknown-route")
    return erosion_from(_core.erosion(P, Q, scale_text("scale", scale), route))


def opening(P: _core.PolygonSet, Q: _core.PolygonSet, scale: PlaneScale = 1) -> Erosion:
    """Compute the opening of P, scaled, by Q: the union of all copies of Q within the scaled P, its
    erosion by Q plus Q. Copies at remnants count. Exact. As erode."""
    _validate(P=P, Q=Q)
    return erosion_from(_core.opening(P, Q, scale_text("scale", scale)))


def closing(P: _core.PolygonSet, Q: _core.PolygonSet, scale: PlaneScale = 1) -> Erosion:
    """Compute the closing of P, scaled, by Q: the sum of the scaled P and Q, eroded by Q. Exact. As
    erode; refuses two operands that are both a point or a segment, as minkowski_sum does."""
    _validate(P=P, Q=Q)
    return erosion_from(_core.closing(P, Q, scale_text("scale", scale)))


def inner_fit(
    container: _core.PolygonSet, part: _core.PolygonSet, scale: PlaneScale = 1
) -> Erosion:
    """Compute the places of `part`, never turned, at which it lies within the scaled container: the
    erosion of the container by the part. A place is where the part's origin comes to lie. On the
    region's boundary and at remnants, the exact fits, the part touches the container's boundary.
    Exact. As erode. docs/erosion.md."""
    _validate(container=container, part=part)
    return erode(container, part, scale)


def no_fit(A: _core.PolygonSet, B: _core.PolygonSet, scale: PlaneScale = 1) -> NoFit:
    """Compute the places of B, never turned, at which B meets the scaled A: the sum of the scaled A
    and -B, often called no-fit polygon, with the exact fits inside it. Holes, several parts and
    touching rings count. Exact. As minkowski_sum. docs/erosion.md."""
    _validate(A=A, B=B)
    found = _core.minkowski_sum(
        A, _core.negated(B), scale_text("scale", scale), "paper", "rational", True
    )
    fits = passage_values(found.passage_rows())
    return NoFit(found.region, found.components, found.holes, fits, found.seconds)


def erosion_from(found: _core.Sum) -> Erosion:
    """Convert the extension module's answer."""
    rows = found.passage_rows()
    points = tuple(tuple(map(place_of, places)) for places, _ in rows)
    return Erosion(
        found.region, found.components, found.holes, passage_values(rows), points, found.seconds
    )


def sum_of(P: _core.PolygonSet, Q: _core.PolygonSet) -> _core.PolygonSet:
    """`P + Q`."""
    _validate(P=P, Q=Q)
    return _core.minkowski_sum(P, Q, "1").region


def erosion_of(P: _core.PolygonSet, Q: _core.PolygonSet) -> Erosion:
    """`P - Q`."""
    return erode(P, Q)


def _ways(points: tuple[tuple[Fraction, Fraction], ...]) -> list[Any]:
    """Make shapes: a point, or a polyline's segments."""
    if len(points) == 1:
        return [points[0]]
    return [{"type": "LineString", "coordinates": [list(a), list(b)]} for a, b in pairwise(points)]


def _validate(**operands: _core.PolygonSet) -> None:
    expect_sets(**operands)
    for name, operand in operands.items():
        operand.validate(name)
