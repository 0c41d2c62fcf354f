"""Event scales of a disc swept along a polygon, by the symbolic oracle."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from minkref.oracle.symbolic import solutions
from minkref.oracle.symbolic.disc import disc, disc_contact
from minkref.oracle.symbolic.disc.disc import AlgebraicScale, Arc, Offset
from minkref.oracle.symbolic.rational import rational, rationals, text

Vertex = tuple[int, int]
Edge = tuple[Vertex, Vertex]  # with the polygon on its left
Corner = tuple[Vertex, Vertex, Vertex]  # the arc about the middle one, where the polygon turns left
Feature = Edge | Corner


@dataclass(frozen=True)
class Root:
    """A condition's root s > 0. `case`: once, always or never. `terms`: the scale is the sum of c
    sqrt(m) over (m, c). `polynomial`: the scale's minimal polynomial, the highest power first."""

    case: str
    terms: tuple[tuple[int, str], ...] = ()
    polynomial: tuple[int, ...] = ()


@dataclass(frozen=True)
class Touch:
    """Two features touch as `name` says; `meet`: themselves, not only their line or circle."""

    name: str
    root: Root
    meet: bool


def end_on_line(end: int, of: Edge, line: Edge, radius: int) -> Root:
    """The end 0 or 1 of an offset edge comes to the line of another."""
    return _root(disc.end_on_line(_offset(of).q if end else _offset(of).p, _offset(of),
                                  _offset(line), rational(radius)))  # fmt: skip


def end_on_circle(end: int, of: Edge, corner: Corner, radius: int) -> Root:
    """The end 0 or 1 of an offset edge, where an arc ends too, comes to the circle of an arc."""
    return _root(disc.end_on_circle(_offset(of).q if end else _offset(of).p, _offset(of),
                                    _arc(corner), rational(radius)))  # fmt: skip


def circle_on_line(corner: Corner, line: Edge, radius: int) -> Root:
    return _root(disc.circle_on_line(_arc(corner), _offset(line), rational(radius)))


def circles(first: Corner, second: Corner, radius: int) -> Root:
    return _root(disc.circles(_arc(first), _arc(second), rational(radius)))


def three_lines(edges: Sequence[Edge], radius: int) -> Root:
    first, second, third = map(_offset, edges)
    return _root(disc.three_lines(first, second, third, rational(radius)))


def three_circles(corners: Sequence[Corner], radius: int) -> Root:
    first, second, third = map(_arc, corners)
    return _root(disc.three_circles(first, second, third, rational(radius)))


def touches(first: Feature, second: Feature, radius: int) -> list[Touch]:
    """Where two features touch themselves, at s > 0."""
    found = disc_contact.pair_disc_events(_feature(first), _feature(second), rational(radius))
    return [Touch(x.name, _root(x.scale), bool(x.meet)) for x in found if x.meet]


def ring_touches(ring: Sequence[Vertex], radius: int) -> list[Touch]:
    """Returns touches between all pairs of non-consecutive features of a polygon, ascending."""
    found = disc_contact.polygon_events(ring, rational(radius))
    return [Touch(x.name, _root(x.scale), bool(x.meet)) for x in found]


def greatest_degrees() -> dict[str, int]:
    """Returns, by condition, the degree of the polynomial in s without lengths, for general
    data."""
    kept = solutions.all_solutions()
    return {
        name.removeprefix("disc "): int(found["degree"])
        for name, found in kept.items()
        if name.startswith("disc ")
    }


def _root(scale: AlgebraicScale) -> Root:
    if scale.value is None:
        return Root(scale.case)
    terms = tuple((m, text(c)) for m, c in scale.value.terms)
    return Root(scale.case, terms, scale.polynomial)


def _offset(edge: Edge) -> Offset:
    (x0, y0), (x1, y1) = map(rationals, edge)
    return Offset((x0, y0), (x1, y1))


def _arc(corner: Corner) -> Arc:
    return Arc(_offset(corner[:2]), _offset(corner[1:]))


def _feature(feature: Feature) -> Offset | Arc:
    return _offset(feature) if len(feature) == 2 else _arc(feature)
