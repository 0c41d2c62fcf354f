"""Judges polygons that `--tolerance` writes: inside or around the true sum, and near it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import gmpy2
from minkref.reports.evidence.as_written.covering import Neighbourhood
from minkref.reports.evidence.as_written.curves import Arc, Grown, Piece, Place
from minkref.reports.evidence.as_written.distance import Ring, edges, to_segment, within
from minkref.reports.evidence.as_written.measures import angle
from minkref.reports.evidence.as_written.read_plane import Polygons
from minkref.reports.evidence.as_written.tally import Tally
from minkref.reports.evidence.as_written.units import TIE, Real, exact, exact_double

READINGS: dict[str, Callable[[str], Any]] = {
    "as decimals": exact, "as doubles": lambda text: exact_double(float(text)),
}  # fmt: skip


class Asked:
    """A sum with a disc, its operand's rings, and a tolerance."""

    def __init__(self, rings: list[Ring], of: Grown, tolerance: Any) -> None:
        self.of, self.tolerance = of, tolerance
        self.sum = Neighbourhood(rings, of.squared)
        # (radius + tolerance)², rational if the radius is
        reach = of.squared + 2 * tolerance * of.radius + tolerance**2
        self.wider = Neighbourhood(rings, reach * (1 + TIE))
        self.holes = list(hole_points(of, self.sum))
        self.judged: dict[object, list[tuple[str, str]]] = {}  # formats often have the same numbers

    def judge(self, tally: Tally, writer: str, polygons: Polygons, outside: bool) -> None:
        for reading, number in READINGS.items():
            rings = _read(polygons, number)
            tally.numbers[f"{writer} {reading}"] += 2 * sum(map(len, rings))
            key = outside, tuple(map(tuple, rings))
            if key not in self.judged:
                self.judged[key] = list(self._around(rings) if outside else self._inside(rings))
            for fault, told in self.judged[key]:
                tally.fault(f"{writer} {reading}", fault, told)

    def _inside(self, rings: list[Ring]) -> Iterator[tuple[str, str]]:
        out = self.sum.outside_of(rings)
        if out:
            yield "an inside file reaches out of the sum", f"{len(out)} edges, as {_shown(out[0])}"
        elif any(within(p, rings) for p in self.holes):
            yield "an inside file covers a hole of the sum", ""
        missed = next((p for p in samples(self.of) if not self._near(p, rings)), None)
        if missed:
            yield "a point of the sum is farther than the tolerance", _shown([missed])

    def _around(self, rings: list[Ring]) -> Iterator[tuple[str, str]]:
        met = self.sum.met_by(rings)
        if met:
            yield "an outside file cuts into the sum", f"{len(met)} edges, as {_shown(met[0])}"
        elif not all(_has(rings, ring[0]) for ring in self.sum.rings):
            yield "an outside file misses a part of the sum", ""
        far = self.wider.outside_of(rings)
        if far:
            yield "a point of the file is farther than the tolerance", _shown(far[0])

    def _near(self, p: Place, rings: list[Ring]) -> bool:
        most = self.tolerance**2 * (1 + TIE)
        return within(p, rings) or any(to_segment(p, edge) <= most for edge in edges(rings))


def _read(polygons: Polygons, number: Callable[[str], Any]) -> list[Ring]:
    return [[(number(x), number(y)) for x, y in ring] for one in polygons for ring in one]


def _has(rings: list[Ring], p: Place) -> bool:
    return within(p, rings) or any(to_segment(p, edge) == 0 for edge in edges(rings))


def _shown(places: Any) -> str:
    return ", ".join(f"({float(x)!r}, {float(y)!r})" for x, y in places)


def middle(piece: Piece, radius: Real, beyond: Real) -> Place:
    """The middle of a piece, moved out of the sum by `beyond`."""
    if not isinstance(piece.curve, Arc):
        assert piece.start and piece.end
        long = gmpy2.sqrt(gmpy2.mpfr(piece.curve.dx**2 + piece.curve.dy**2))
        x, y = ((a + b) / 2 for a, b in zip(piece.start, piece.end, strict=True))
        return x + beyond * piece.curve.dy / long, y - beyond * piece.curve.dx / long
    turn = angle(piece) / 2
    c, s = gmpy2.cos(turn), gmpy2.sin(turn)
    x, y = piece.curve.x, piece.curve.y
    ux, uy = (piece.start[0] - x, piece.start[1] - y) if piece.start else (radius, gmpy2.mpq(0))
    far = 1 + beyond / radius
    return x + far * (c * ux - s * uy), y + far * (s * ux + c * uy)


def samples(of: Grown) -> Iterator[Place]:
    """The sum's corners and the pieces' middles."""
    for piece in (piece for ring in of.rings for piece in ring):
        if piece.start:
            yield piece.start
        yield middle(piece, of.radius, gmpy2.mpq(0))


def hole_points(of: Grown, near: Neighbourhood) -> Iterator[Place]:
    """A point inside each hole, just beside the boundary."""
    for ring in (hole for component in of.components for hole in component[1:]):
        p = middle(ring[0], of.radius, of.radius / gmpy2.mpq(2) ** 500)
        if near.has(p):
            raise ValueError(f"a point beside a hole's boundary is in the sum: {_shown([p])}")
        yield p
