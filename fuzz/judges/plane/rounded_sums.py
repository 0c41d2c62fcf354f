"""A sum in rounded numbers beside the exact one: the same structure with coordinates a little off,
or another structure."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from minkref import _core

Point = tuple[Fraction, Fraction]
Ring = list[Point]
LARGEST = 10**6  # ulps beyond which rings differ; or half the digits, if fewer


def significant_bits(arithmetic: str) -> int | None:
    """Returns the significant bits of an arithmetic's numbers; None for exact numbers."""
    if arithmetic.startswith("mpfr:"):
        return int(arithmetic.removeprefix("mpfr:"))
    return None if arithmetic == "rational" else 53


def most_places(bits: int) -> int:
    """The ulps up to which a coordinate counts as the same in numbers of so many bits."""
    return min(LARGEST, 1 << bits // 2)


@dataclass(frozen=True)
class Comparison:
    """`ulps`: the largest error of a coordinate, in units in the last place of the exact sum's
    largest coordinate; None if the structure differs. Then `point` belongs to only one set, named
    by `in_sum`: pairs of triangles decide this from the definition. None if rings differ but the
    sets do not."""

    same_structure: bool
    ulps: Fraction | None = None
    point: tuple[str, str] | None = None
    in_sum: bool | None = None


def compare(
    P: _core.PolygonSet,
    Q: _core.PolygonSet,
    scale: str,
    got: _core.Sum,
    bits: int | None,
    exact: _core.Sum | None = None,
) -> Comparison:
    """Compares the sum `got` at this scale, in numbers of so many bits (None: exact numbers, which
    must be equal), with the `exact` sum, which is computed unless given. Equal structure means:
    equally many rings, and for each outer ring and each hole a counterpart with as many vertices,
    each near its counterpart."""
    exact = exact or _core.minkowski_sum(P, Q, scale)
    if got.region == exact.region:
        return Comparison(True, Fraction(0))
    off = None if bits is None else largest_difference(exact.region, got.region, bits)
    if off is not None:
        return Comparison(True, off)
    found = _core.difference(exact.region, got.region)
    if found is None:
        return Comparison(False)
    x, y = found["point"]
    in_sum = _core.decide(P, Q, scale, x, y)["contact"] != "empty"
    return Comparison(False, None, (x, y), in_sum)


def largest_difference(
    exact: _core.PolygonSet, got: _core.PolygonSet, bits: int
) -> Fraction | None:
    """The largest difference between corresponding coordinates, in units in the last place; None if
    the rings do not correspond."""
    unit = _unit(exact, bits)
    most = unit * most_places(bits)
    wanted, offered = _rings(exact), _rings(got)
    if len(wanted) != len(offered):
        return None
    off = Fraction(0)
    for kind, ring in wanted:
        place = next(
            (
                (distance, k)
                for k, (other, candidate) in enumerate(offered)
                if other == kind and (distance := _distance(ring, candidate, most)) is not None
            ),
            None,
        )
        if place is None:
            return None
        off = max(off, place[0])
        offered.pop(place[1])
    return off / unit


def _rings(region: _core.PolygonSet) -> list[tuple[bool, Ring]]:
    """Lists rings, each with a flag for outer rings."""
    return [(k == 0, ring) for polygon in region.rings() for k, ring in enumerate(polygon)]


def _unit(region: _core.PolygonSet, bits: int) -> Fraction:
    """The unit in the last place of the largest coordinate."""
    return last_place(
        max((abs(x) for _, ring in _rings(region) for point in ring for x in point), default=1),
        bits,
    )


def last_place(largest: Fraction | int, bits: int) -> Fraction:
    """The distance between neighbours among numbers of so many bits, at this number; at 0 as at
    1."""
    largest = abs(Fraction(largest)) or Fraction(1)
    exponent = largest.numerator.bit_length() - largest.denominator.bit_length()
    if largest < Fraction(2) ** exponent:
        exponent -= 1
    return Fraction(2) ** (exponent - bits + 1)


def _distance(ring: Ring, other: Ring, most: Fraction) -> Fraction | None:
    """The distance of the vertices that differ most, if the rings run alike; None beyond `most`."""
    if len(ring) != len(other):
        return None
    first = ring[0]
    for shift, start in enumerate(other):
        if _apart(first, start) > most:
            continue
        turned = other[shift:] + other[:shift]
        off = max(_apart(a, b) for a, b in zip(ring, turned, strict=True))
        if off <= most:
            return off
    return None


def _apart(a: Point, b: Point) -> Fraction:
    return max(abs(a[0] - b[0]), abs(a[1] - b[1]))
