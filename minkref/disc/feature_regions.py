"""Regions of features, the alpha-shape and rest material, as values."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from minkref import _core
from minkref.disc.disc_index import Bounds

Place = tuple[str, str]
"""A drawn line or arc: kind, start, end, and an arc's centre; arcs run counter-clockwise."""
Step = tuple[str, float, float, float, float, float, float]


@dataclass(frozen=True)
class FeatureRegion:
    """A feature's region: the space between hidden parts of the boundary of P and the chords at the
    feature's corners. `node`: of the merge tree; none of a hole that has ended. `events` counts as
    DiscIndex.events does; `reflex_vertices` has one entry for each wedge. `area` equals a double or
    lies between two neighbouring doubles; `terms` gives the area exactly, as factors by products of
    square roots ("" for 1)."""

    node: int | None
    events: tuple[int, ...]
    reflex_vertices: tuple[Place, ...]
    area: Bounds
    terms: dict[str, Fraction]


@dataclass(frozen=True)
class FeatureRest:
    """The rest material within one region: what a closing with the disc adds to P there."""

    components: int
    area: Bounds


@dataclass(frozen=True)
class RestArc:
    """An arc that bounds rest material, or a part of one: about a corner of a feature,
    counter-clockwise from one foot towards the other. Points are expressions. `from_circles` and
    `to_circles`: corners whose circles end the part at its start and at its end; none at a foot. So
    all numbers follow exactly: the rest's area is that within its boundary's chords, less the
    arcs' segments."""

    corner: Place
    feet: tuple[Place, Place]
    from_circles: tuple[Place, ...]
    to_circles: tuple[Place, ...]


class RegionsAt:
    """Regions, alpha-shape and rest material at one alpha, twice the radius of the disc (Behar &
    Lien 2012, Sec. 8.2; docs/disc.md). Exact: O(n) for all regions, and O(k²) comparisons of
    doubles for the rest of a feature with k corners. The alpha-shape consists of P and all
    regions; its components and holes are those of the closed sum of P and the disc between events.
    At an event: the state just below."""

    def __init__(self, found: _core.RegionsAt) -> None:
        self._found = found

    @property
    def components(self) -> int:
        """Components of the alpha-shape as a closed set: what touches is one."""
        return self._found.components

    @property
    def holes(self) -> int:
        """Bounded components of the alpha-shape's complement."""
        return self._found.holes

    @property
    def features(self) -> list[FeatureRegion]:
        """All features with their regions, by their first events. Exact; microseconds for each
        corner. Raises LimitExceeded if 2^14 bits do not tell an area from a double."""
        return [
            FeatureRegion(node, tuple(events), tuple(leaves), area, _fractions(terms))
            for node, events, leaves, area, terms in self._found.features()
        ]

    @property
    def shape_area(self) -> Bounds:
        """The alpha-shape's area."""
        return self._found.shape_area()[0]

    def chords(self, feature: int) -> list[tuple[Place, Place]]:
        """A feature's bridges: both nearest points of each of its corners, as expressions."""
        return self._found.chords(feature)

    def corners(self, feature: int) -> list[list[Place]]:
        """List the corners of a region's rings, as expressions, with the region on the right."""
        return self._found.corners(feature)

    def outlines(self, feature: int) -> list[list[Step]]:
        """Draw a region's rings, with the region on the right, in nearest doubles."""
        return self._found.outlines(feature)

    @property
    def rest(self) -> list[FeatureRest]:
        """The rest material of each feature. Raises BadInput at an infinite radius."""
        return [FeatureRest(components, area) for components, area in self._found.rest()]

    @property
    def rest_area(self) -> Bounds:
        """The area of all rest material: closing minus P, enclosed like `FeatureRegion.area`."""
        return self._found.rest_area()

    def rest_arcs(self, feature: int) -> list[RestArc]:
        """List the arcs that bound a feature's rest, exactly."""
        return [
            RestArc(corner, (foot, other), tuple(first), tuple(last))
            for corner, foot, other, first, last in self._found.rest_arcs(feature)
        ]

    def rest_outlines(self, feature: int) -> list[list[Step]]:
        """Draw the rest's rings, with the rest on the right, in nearest doubles."""
        return self._found.rest_outlines(feature)


def _fractions(terms: dict[str, str]) -> dict[str, Fraction]:
    return {product: Fraction(factor) for product, factor in terms.items()}
