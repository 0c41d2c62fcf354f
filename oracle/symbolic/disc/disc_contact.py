"""Where features of a swept disc touch, whether the features themselves reach there, and all events
of a polygon: every pair of features, every condition."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import combinations
from typing import Any

from ..moving import Point
from ..rational import Rational
from . import disc
from .disc import AlgebraicScale, Arc, Offset, Place, cross
from .radicals import Radical, number, square_root

Feature = Offset | Arc


@dataclass(frozen=True, slots=True)
class DiscEvent:
    """A touch of two features as `name` says, at the point `at`; `meet`: both features contain the
    point, not just their line and circle."""

    name: str
    first: Feature
    second: Feature
    scale: AlgebraicScale
    at: Place | None
    meet: bool | None


def moved_out(point: Point, edge: Offset, r: Rational, s: Radical) -> Place:
    """Offset a point on an edge: point + s r n. Exact."""
    x, y = edge.edge
    out = s * r / square_root(x * x + y * y)
    return number(point[0]) + out * y, number(point[1]) - out * x


def on_offset(x: Place, edge: Offset, s: Radical, r: Rational) -> bool:
    """Tell whether an offset edge contains a point at scale s, by the definition. Exact."""
    start = moved_out(edge.p, edge, r, s)
    off, e = (x[0] - start[0], x[1] - start[1]), edge.edge
    reach = off[0] * e[0] + off[1] * e[1]
    length = e[0] * e[0] + e[1] * e[1]
    return cross(off, e).sign() == 0 and reach.sign() >= 0 and (number(length) - reach).sign() >= 0


def on_arc(x: Place, arc: Arc, s: Radical, r: Rational) -> bool:
    """Tell whether an arc contains a point at scale s: at its radius, between its normals.
    Exact."""
    off = (x[0] - arc.centre[0], x[1] - arc.centre[1])
    (a, b), (c, d) = arc.before.edge, arc.after.edge
    radius = s * r
    return (
        (off[0] * off[0] + off[1] * off[1] - radius * radius).sign() == 0
        and cross((b, -a), off).sign() >= 0
        and cross(off, (d, -c)).sign() >= 0
    )


def on(x: Place, feature: Feature, s: Radical, r: Rational) -> bool:
    test: Any = on_offset if isinstance(feature, Offset) else on_arc
    return bool(test(x, feature, s, r))


def ends(feature: Feature) -> list[tuple[Point, Offset]]:
    """List a feature's ends, each a point on an offset edge."""
    if isinstance(feature, Offset):
        return [(feature.p, feature), (feature.q, feature)]
    return [(feature.centre, feature.before), (feature.centre, feature.after)]


def pair_conditions(
    first: Feature, second: Feature, r: Rational
) -> Iterator[tuple[str, AlgebraicScale, Callable[[Radical], Place]]]:
    """Yield every condition on two features, solved, with the contact point at a scale."""
    for feature, other in ((first, second), (second, first)):
        for end, edge in ends(feature):
            if isinstance(other, Offset):
                name, scale = "end on line", disc.end_on_line(end, edge, other, r)
            else:
                name, scale = "end on circle", disc.end_on_circle(end, edge, other, r)
            yield name, scale, partial(moved_out, end, edge, r)
    if isinstance(first, Arc) and isinstance(second, Arc):
        x, y = ((a + b) / 2 for a, b in zip(first.centre, second.centre, strict=True))
        middle = number(x), number(y)
        yield "circles", disc.circles(first, second, r), lambda s: middle
    for arc, line in ((first, second), (second, first)):
        if isinstance(arc, Arc) and isinstance(line, Offset):
            # From the centre, against the line's normal.
            place = partial(moved_out, arc.centre, line, -r)
            yield "circle on line", disc.circle_on_line(arc, line, r), place


def pair_disc_events(first: Feature, second: Feature, r: Rational) -> list[DiscEvent]:
    """Find all conditions on two features, including conditions at no scale or every scale.
    Exact."""
    found = []
    for name, scale, place in pair_conditions(first, second, r):
        at, meet = None, None
        if scale.value is not None:
            at = place(scale.value)
            meet = on(at, first, scale.value, r) and on(at, second, scale.value, r)
        found.append(DiscEvent(name, first, second, scale, at, meet))
    return found


def adjacent(first: Feature, second: Feature) -> bool:
    """Tell whether the features share an end at every scale."""
    return any(end in ends(second) for end in ends(first))


def polygon_events(polygon: Sequence[Any], r: Rational) -> list[DiscEvent]:
    """Find the events for a disc of radius s r swept along one ring, ascending: touches of two
    features that are not adjacent, on the features themselves. O(n^2), exact."""
    features: list[Feature] = [*disc.offsets(polygon), *disc.arcs(polygon)]
    found = [
        event
        for a, b in combinations(features, 2)
        if not adjacent(a, b)
        for event in pair_disc_events(a, b, r)
        if event.meet
    ]
    return sorted(found, key=lambda event: Ascending(event.scale.value or number(0)))


class Ascending:
    """Sums of radicals, ordered as numbers."""

    def __init__(self, value: Radical) -> None:
        self.value = value

    def __lt__(self, other: Ascending) -> bool:
        return (self.value - other.value).sign() < 0
