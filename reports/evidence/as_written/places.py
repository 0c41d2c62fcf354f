"""Compares a file's places with the true corners, for any order of rings."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator

import gmpy2
from minkref.reports.evidence.as_written.curves import Arc, Grown, Piece, Place
from minkref.reports.evidence.as_written.tally import Tally, told
from minkref.reports.evidence.as_written.units import Real, exact_double, is_double_of, unit

Double = tuple[float, float]


def nearest(value: Real) -> float:
    """The double next to a true number."""
    return float(gmpy2.mpq(value))


def beside(value: float) -> tuple[float, float, float]:
    return value, math.nextafter(value, math.inf), math.nextafter(value, -math.inf)


def written(places: set[Double], true: Place) -> Iterator[Double]:
    """The file's places within one unit of a true place."""
    for x in beside(nearest(true[0])):
        for y in beside(nearest(true[1])):
            if (x, y) in places and all(
                is_double_of(exact_double(a), b) for a, b in zip((x, y), true, strict=True)
            ):
                yield x, y


def compare(tally: Tally, writer: str, places: list[Double], of: Grown) -> None:
    """Every corner has to be written, and every place that is written to be on the boundary."""
    tally.numbers[writer] += 2 * len(places)
    finite = {place for place in places if all(map(math.isfinite, place))}
    for place in places:
        if place not in finite:
            tally.fault(writer, "NaN or infinity", str(place))
    pieces = [piece for ring in of.rings for piece in ring]
    matched: set[Double] = set()
    for piece in pieces:
        if piece.start is None:
            continue
        found = list(written(finite, piece.start))
        matched.update(found)
        if not found:
            _missing(tally, writer, finite, piece.start)
    for place in finite - matched:
        if not any(on(place, piece, of) for piece in pieces):
            tally.fault(writer, "a place that is not on the boundary", str(place))


def _missing(tally: Tally, writer: str, places: set[Double], true: Place) -> None:
    def far(place: Double) -> Real:
        return max(abs(exact_double(a) - b) for a, b in zip(place, true, strict=True))

    near = min(places, key=far, default=None)
    shown = f"true ({told(true[0])}, {told(true[1])}), next is {near}"
    if near is None:
        tally.fault(writer, "a corner is missing", shown)
        return
    tiny = [a for a, b in zip(near, true, strict=True) if b == 0 and a != 0]
    off = max(
        abs(exact_double(a) - b) / unit(b)
        for a, b in zip(near, true, strict=True)
        if b != 0 or a == 0
    )
    if tiny and off <= 1:
        tally.fault(writer, "0 is written as another number", shown)
        return
    tally.fault(writer, f"a corner is off by more than {scale_of(off)} units", shown)


def scale_of(units: Real) -> str:
    """The power of a thousand that a number of units reaches."""
    for most in (1, 1000, 10**6, 10**9):
        if units <= most * 1000:
            return f"{most:,}"
    return f"{10**12:,}"


def on(place: Double, piece: Piece, of: Grown) -> bool:
    """Whether a written place lies on a piece's curve, up to the rounding of both coordinates."""
    x, y = map(exact_double, place)
    slack = unit(x) + unit(y)
    curve = piece.curve
    if isinstance(curve, Arc):
        far = gmpy2.sqrt(gmpy2.mpfr((x - curve.x) ** 2 + (y - curve.y) ** 2))
        return bool(abs(far - of.radius) <= slack)
    long = gmpy2.sqrt(gmpy2.mpfr(curve.dx**2 + curve.dy**2))
    far = (curve.dy * x - curve.dx * y - curve.c) / long
    return bool(abs(far - of.radius) <= slack)


def doubles(places: Iterable[tuple[str, str]]) -> list[Double]:
    return [(float(x), float(y)) for x, y in places]
