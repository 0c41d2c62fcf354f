"""Compares a DXF's bulges with the arcs between its corners.

A writer may cut an arc into two parts. Where the cut rounds to an end of the arc, one part has no
length in doubles; its turn then belongs to the neighbouring part.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product

import gmpy2
from minkref.reports.evidence.as_written.curves import Grown, Piece
from minkref.reports.evidence.as_written.measures import bulge
from minkref.reports.evidence.as_written.read_dxf import Corner
from minkref.reports.evidence.as_written.tally import Tally
from minkref.reports.evidence.as_written.units import Real, exact, is_double_of, unit, units_off

Place = tuple[str, str]


def compare(tally: Tally, ring: list[Corner], of: Grown) -> None:
    for start, end, curved, beside in _sides(ring):
        piece = _between(of, start, end)
        if piece is None:
            continue
        if not beside:
            tally.number(".dxf", curved, bulge(piece), "a bulge")
            continue
        tally.numbers[".dxf"] += 1
        true = bulge(piece)
        if not any(units_off(one, true) <= 1 + len(beside) for one in _totals(curved, beside)):
            tally.fault(".dxf", "parts of an arc that are not all of it", f"{curved} and {beside}")


def _sides(ring: list[Corner]) -> Iterator[tuple[Place, Place, str, list[str]]]:
    """Sides with a length, each with the bulges of neighbouring sides without length."""
    n = len(ring)
    empty = [_touch(ring[k][:2], ring[(k + 1) % n][:2]) for k in range(n)]
    for k, (x, y, curved) in enumerate(ring):
        if not empty[k]:
            beside = [ring[m % n][2] for m in (k - 1, k + 1) if n > 1 and empty[m % n]]
            yield (x, y), ring[(k + 1) % n][:2], curved, beside


def _touch(a: Place, b: Place) -> bool:
    """Whether two places may stand for one place, given both roundings."""
    return all(abs(exact(p) - exact(q)) <= 2 * unit(exact(p)) for p, q in zip(a, b, strict=True))


def _totals(curved: str, beside: list[str]) -> Iterator[Real]:
    """The total bulge, with or without each neighbour's bulge."""
    for taken in product((False, True), repeat=len(beside)):
        parts = [curved, *(one for one, is_taken in zip(beside, taken, strict=True) if is_taken)]
        yield gmpy2.tan(sum((gmpy2.atan(gmpy2.mpfr(exact(one))) for one in parts), gmpy2.mpfr(0)))


def _between(of: Grown, start: Place, end: Place) -> Piece | None:
    """The piece with these ends, if unique."""
    found = [
        piece
        for ring in of.rings
        for piece in ring
        if piece.start and piece.end and _is(start, piece.start) and _is(end, piece.end)
    ]
    return found[0] if len(found) == 1 else None


def _is(written: Place, true: tuple[Real, Real]) -> bool:
    return all(is_double_of(exact(a), b) for a, b in zip(written, true, strict=True))
