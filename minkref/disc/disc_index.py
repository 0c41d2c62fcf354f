"""Sums with a disc at all radii, as a value."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.argument_types import double, expect_sets, number, whole
from minkref.disc.eroded import eroded_by_disc
from minkref.errors import Refusal
from minkref.exact import read_number

Number = str | int | Fraction
Bounds = tuple[float, float]


def square_of(radius: Number | None, squared_radius: Number | None, where: str) -> str:
    """Return a radius's square, from the radius or the square."""
    if (radius is None) == (squared_radius is None):
        raise Refusal("one radius is asked for", where, "give radius or squared_radius")
    name, given = ("squared_radius", squared_radius) if radius is None else ("radius", radius)
    place, mend = f"{name} {given}", "give a positive number, as 7/5"
    value = read_number(number(name, given), name.replace("_", " "), place, mend)
    if value <= 0:
        raise Refusal(f"the {name.replace('_', ' ')} is not above 0", place, mend, "bad-radius")
    return str(value if radius is None else value**2)


@dataclass(frozen=True)
class OffsetEvent:
    """A change of the boundary. `kind`: corner, joint, saddle, ridge or maximum. The radius equals
    a double or lies between two neighbouring doubles; its square is a root of `polynomial`, the
    lowest coefficient first, and equals `squared_radius` if known to be rational. `place`: the
    nearest doubles. `features`: all equally near features, as ("vertex", x, y) or ("edge", ring,
    number). Terms: docs/disc.md."""

    kind: str
    radius: Bounds
    squared_radius: Fraction | None
    polynomial: tuple[Fraction, ...]
    place: tuple[float, float]
    features: tuple[tuple[str, str, str], ...]


class DiscIndex:
    """`P` + a disc about the origin at all radii: finds the outer Voronoi diagram of P once, then
    answers for any radius. Exact: proves the events, and their completeness. Building takes O(n log
    n + k) for k compared candidates, on `threads`; P may be a segment or a point, and is validated
    first. Raises BadInput; LimitExceeded if 1,024 bits do not separate two places. Behar & Lien
    2012, Appendix; docs/disc.md."""

    def __init__(self, P: _core.PolygonSet, threads: int = 1) -> None:
        expect_sets(P=P)
        P.validate("P")
        self._index = _core.disc_index(P, max(1, whole("threads", threads)))

    def __len__(self) -> int:
        return len(self._index)

    def __repr__(self) -> str:
        return f"<DiscIndex: {len(self)} radii of events, {self._index.parts} parts>"

    @property
    def radii(self) -> list[Bounds]:
        """Bounds for the events' radii, each radius once, ascending: neighbouring doubles, or equal
        doubles for a double. Found when first asked for, about 150 µs each."""
        return self._index.radii()

    def events(self) -> list[OffsetEvent]:
        """List all events by radius. About 30 µs each."""
        return [event_of(row) for row in self._index.rows(0, len(self._index.kinds()))]

    def components_and_holes(
        self, radius: Number | None = None, squared_radius: Number | None = None
    ) -> tuple[int, int]:
        """Count components and holes. Exact, at events too. O(n)."""
        return self._index.counts(square_of(radius, squared_radius, "components_and_holes"))

    def area_and_length(
        self, radius: Number | None = None, squared_radius: Number | None = None
    ) -> tuple[Bounds, Bounds]:
        """Return the sum's area and its boundary's length, each between two doubles that differ by
        less than 2^-36 of the value. O(n) comparisons of whole numbers, and O(k) for k corners,
        without the boundary; the exact boundary decides if these bounds are not sharp enough."""
        return self._index.measures(square_of(radius, squared_radius, "area_and_length"))

    def canonical_json(
        self, radius: Number | None = None, squared_radius: Number | None = None
    ) -> str:
        """Write the canonical form, exactly: read off within O(n log n), or computed by the static
        sum at an event's radius."""
        return self._index.canonical_json(square_of(radius, squared_radius, "canonical_json"))

    def vertices(self, radius: float) -> tuple[Any, Any]:
        """Return all boundary vertices, ring by ring, the sum to the left: an array of x, y and an
        error bound for both, at most 2^-42 of the radius and the size of P, and 2^-50 of the
        coordinates; and the row at which each ring starts. At an event's radius, returns the
        vertices just above the event. Raises LimitExceeded for vertices beyond doubles.
        Microseconds, and about 100 µs for a corner that needs exact numbers."""
        return self._index.vertices(double("radius", radius))


def inradius(P: _core.PolygonSet, threads: int = 1) -> list[OffsetEvent]:
    """Find the largest discs within P: events at the inradius, each with a place and the features
    bounding the disc. Exact; a flat ridge shows its events' places. Validates P, which must have an
    area. Takes as long as a DiscIndex. Raises BadInput, LimitExceeded. docs/erosion.md."""
    expect_sets(P=P)
    P.validate("P")
    count = max(1, whole("threads", threads))
    return [event_of(row) for row in eroded_by_disc(P, "P").largest(count)]


def event_of(row: Any) -> OffsetEvent:
    """An event from the row of the extension module."""
    kind, square, polynomial, radius, place, features = row
    return OffsetEvent(
        kind, radius, None if square is None else Fraction(square),
        tuple(map(Fraction, polynomial)), place, tuple(features),
    )  # fmt: skip
