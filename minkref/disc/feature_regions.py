"""Regions of features, the alpha-shape and rest material, as values."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from minkref import _core
from minkref.argument_types import expect_sets, whole
from minkref.disc.disc_index import Bounds, Number, square_of

Place = tuple[str, str]
"""A drawn line or arc: kind, start, end, and an arc's centre; arcs run counter-clockwise."""
Step = tuple[str, float, float, float, float, float, float]


@dataclass(frozen=True)
class FeatureRegion:
    """A feature's region: the space between hidden parts of the boundary of P and the chords at the
    feature's corners. `events` counts as DiscIndex.events does; `reflex_vertices` has one entry for
    each wedge. `area` equals a double or lies between two neighbouring doubles; `terms` gives the
    area exactly, as factors by products of square roots ("" for 1)."""

    events: tuple[int, ...]
    reflex_vertices: tuple[Place, ...]
    area: Bounds
    terms: dict[str, Fraction]


@dataclass(frozen=True)
class FeatureRest:
    """The rest material within one region: what a closing with the disc adds to P there."""

    components: int
    area: Bounds


class RegionsAt:
    """Regions, alpha-shape and rest material at one radius. The alpha-shape consists of P and all
    regions; its components and holes are those of the closed sum of P and the disc between events.
    At the radius of an event: the state just below."""

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
            FeatureRegion(tuple(events), tuple(leaves), area, _fractions(terms))
            for events, leaves, area, terms in self._found.features()
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

    def rest_outlines(self, feature: int) -> list[list[Step]]:
        """Draw the rest's rings, with the rest on the right, in nearest doubles."""
        return self._found.rest_outlines(feature)


class FeatureRegions:
    """Regions of the features of `P` at all radii: finds the outer Voronoi diagram of P once, then
    answers for any radius. Exact. Building costs and refuses what DiscIndex does; an answer takes
    O(n), rest material O(k²) comparisons of doubles for k corners of one feature. Behar & Lien
    2012, Sec. 8.2."""

    def __init__(self, P: _core.PolygonSet, threads: int = 1) -> None:
        expect_sets(P=P)
        P.validate("P")
        self._regions = _core.feature_regions(P, max(1, whole("threads", threads)))

    def at(self, radius: Number | None = None, squared_radius: Number | None = None) -> RegionsAt:
        """Find the regions at a radius, given by itself or by its square."""
        return RegionsAt(self._regions.at(square_of(radius, squared_radius, "at")))

    def at_infinity(self) -> RegionsAt:
        """Find the regions at an infinite radius: they fill the convex hull."""
        return RegionsAt(self._regions.at(None))


def _fractions(terms: dict[str, str]) -> dict[str, Fraction]:
    return {product: Fraction(factor) for product, factor in terms.items()}
