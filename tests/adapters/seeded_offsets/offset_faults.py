"""Seeded faults for `PlainOffset`, numbered: FAULTS[1] is the first, FAULTS[0] has none."""

from __future__ import annotations

import math
import struct
from collections.abc import Iterator
from itertools import pairwise
from typing import Any

from plain_offset import How, PlainOffset, Point, Ring, ccw, go, rings_of


def box_of(rings: list[Ring]) -> tuple[float, float, float, float]:
    xs, ys = ([p[k] for ring in rings for p in ring] for k in (0, 1))
    return min(xs), min(ys), max(xs), max(ys)


def square(x: float, y: float, side: float) -> Ring:
    return [(x, y), (x + side, y), (x + side, y + side), (x, y + side)]


class Fault(PlainOffset):
    """A right implementation with a wrong step."""


class DiameterForRadius(Fault):
    """Takes the radius for a diameter."""

    def radius(self, radius: float, P: dict[str, Any]) -> float:
        return radius / 2


class RadiusOnePercentMore(Fault):
    """Grows a hundredth too far."""

    def radius(self, radius: float, P: dict[str, Any]) -> float:
        return radius * 1.01


class RadiusSquared(Fault):
    """Compares squares, and forgets the root."""

    def radius(self, radius: float, P: dict[str, Any]) -> float:
        return math.copysign(radius * radius, radius)


class SignIgnored(Fault):
    """Grows, whatever the sign."""

    def radius(self, radius: float, P: dict[str, Any]) -> float:
        return abs(radius)


class SignReversed(Fault):
    """Erodes for growing, and grows for eroding."""

    def radius(self, radius: float, P: dict[str, Any]) -> float:
        return radius if "lines" in P else -radius


class ErodesTooLittle(Fault):
    """Erodes two hundredths less."""

    def radius(self, radius: float, P: dict[str, Any]) -> float:
        return radius * (0.98 if radius < 0 else 1)


class HugeRadiusCut(Fault):
    """Takes no radius larger than the set is wide."""

    def radius(self, radius: float, P: dict[str, Any]) -> float:
        lines = [[tuple(p) for p in line] for line in P.get("lines", [])]
        rings = lines or [r for polygon in rings_of(P) for r in polygon]
        if not rings:
            return radius
        x, y, right, up = box_of(rings)  # type: ignore[arg-type]
        return math.copysign(min(abs(radius), max(right - x, up - y) or abs(radius)), radius)


class RadiusOfTwoDigits(Fault):
    """Rounds the radius to two digits."""

    def radius(self, radius: float, P: dict[str, Any]) -> float:
        return float(f"{radius:.1e}")


class SixCorners(Fault):
    """Takes hexagons for discs."""

    corners = 6


class TwelveCorners(Fault):
    """Takes polygons with twelve corners for discs."""

    corners = 12


class SagittaOutside(Fault):
    """Takes polygons with sixteen corners around discs."""

    corners = 16

    def disc(self, v: Point, r: float) -> Ring:
        return super().disc(v, r / math.cos(math.pi / self.corners))


class ArcsReversed(Fault):
    """Draws arcs clockwise."""

    def disc(self, v: Point, r: float) -> Ring:
        return super().disc(v, r)[::-1]


class HalfDiscs(Fault):
    """Omits lower halves."""

    def disc(self, v: Point, r: float) -> Ring:
        return [p for p in super().disc(v, r) if p[1] >= v[1]]


class QuadrantLost(Fault):
    """Angles from three to six o'clock are taken for none."""

    def disc(self, v: Point, r: float) -> Ring:
        kept = [p for p in super().disc(v, r) if not (p[0] > v[0] and p[1] < v[1])]
        return [*kept, v]


class CentreMoved(Fault):
    """Draws discs a fiftieth radius too far right."""

    def disc(self, v: Point, r: float) -> Ring:
        return super().disc((v[0] + abs(r) / 50, v[1]), r)


class Ellipses(Fault):
    """Flattens discs by a twentieth."""

    def disc(self, v: Point, r: float) -> Ring:
        return [(x, v[1] + 0.95 * (y - v[1])) for x, y in super().disc(v, r)]


class SquaresForDiscs(Fault):
    """Takes squares for discs."""

    def disc(self, v: Point, r: float) -> Ring:
        return square(v[0] - abs(r), v[1] - abs(r), 2 * abs(r))


class DiamondsForDiscs(Fault):
    """Takes squares on their tips for discs."""

    corners, turn = 4, 0.0


class NoDiscs(Fault):
    """Bevels round corners, without the bevel."""

    def disc(self, v: Point, r: float) -> Ring:
        return []


class DiscsOfHolesLost(Fault):
    """Omits discs at holes' vertices."""

    def of_ring(self, ring: Ring, r: float, how: How, is_hole: bool) -> Iterator[Ring]:
        found = list(super().of_ring(ring, r, how, is_hole))
        return iter(found[::2] if is_hole else found)


class LastDiscLost(Fault):
    """Omits the disc at a ring's first vertex."""

    def of_ring(self, ring: Ring, r: float, how: How, is_hole: bool) -> Iterator[Ring]:
        return iter(list(super().of_ring(ring, r, how, is_hole))[:-1])


class FirstSideLost(Fault):
    """Omits a ring's first side."""

    def sides(self, ring: Ring, r: float) -> list[int]:
        return super().sides(ring, r)[1:]


class ClosingSideLost(Fault):
    """Does not close rings."""

    def sides(self, ring: Ring, r: float) -> list[int]:
        return super().sides(ring, r)[:-1]


class UprightSidesLost(Fault):
    """Omits rectangles at upright sides."""

    def rectangle(self, a: Point, b: Point, n: Point, r: float) -> Ring:
        return [] if a[0] == b[0] else super().rectangle(a, b, n, r)


class LevelSidesLost(Fault):
    """Omits rectangles at level sides."""

    def rectangle(self, a: Point, b: Point, n: Point, r: float) -> Ring:
        return [] if a[1] == b[1] else super().rectangle(a, b, n, r)


class LongSidesHalved(Fault):
    """Reaches only the middle of sides longer than ten radii."""

    def rectangle(self, a: Point, b: Point, n: Point, r: float) -> Ring:
        if math.dist(a, b) > 10 * abs(r):
            b = ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)
        return super().rectangle(a, b, n, r)


class SidesTooLow(Fault):
    """Makes rectangles a hundredth too low."""

    def rectangle(self, a: Point, b: Point, n: Point, r: float) -> Ring:
        return super().rectangle(a, b, n, 0.99 * r)


class NormalsByTheLargestNumber(Fault):
    """Normalises with the largest coordinate."""

    def normal(self, a: Point, b: Point) -> Point:
        x, y = super().normal(a, b)
        most = max(abs(x), abs(y))
        return (x / most, y / most)


class NormalsOnTheLeft(Fault):
    """Turns rings with more than six vertices around."""

    def of_ring(self, ring: Ring, r: float, how: How, is_hole: bool) -> Iterator[Ring]:
        return super().of_ring(ring[::-1] if len(ring) > 6 else ring, r, how, is_hole)


class HolesIgnored(Fault):
    """Drops the set's holes."""

    def polygons(self, polygons: list[list[Ring]], r: float) -> list[list[Ring]]:
        return [rings[:1] for rings in polygons]


class SecondHoleIgnored(Fault):
    """Knows only the first hole."""

    def polygons(self, polygons: list[list[Ring]], r: float) -> list[list[Ring]]:
        return [rings[:2] for rings in polygons]


class HolesKeepTheirSize(Fault):
    """Holes do not shrink."""

    def of_ring(self, ring: Ring, r: float, how: How, is_hole: bool) -> Iterator[Ring]:
        return iter([]) if is_hole else super().of_ring(ring, r, how, is_hole)


class HolesGrow(Fault):
    """Holes grow with the set."""

    def of_ring(self, ring: Ring, r: float, how: How, is_hole: bool) -> Iterator[Ring]:
        found = super().of_ring(ring, r, how, is_hole)
        return (one[::-1] for one in found) if is_hole else found


class HolesCloseEarly(Fault):
    """Fills holes less wide than two and a half radii."""

    def polygons(self, polygons: list[list[Ring]], r: float) -> list[list[Ring]]:
        return [[rings[0], *(h for h in rings[1:] if self._stays(h, r))] for rings in polygons]

    def _stays(self, hole: Ring, r: float) -> bool:
        x, y, right, up = box_of([hole])
        return min(right - x, up - y) > 2.5 * r


class FirstPolygonOnly(Fault):
    """Knows one polygon."""

    def polygons(self, polygons: list[list[Ring]], r: float) -> list[list[Ring]]:
        return polygons[:1]


class LastPolygonLost(Fault):
    """Drops the last polygon after two."""

    def polygons(self, polygons: list[list[Ring]], r: float) -> list[list[Ring]]:
        return polygons[:-1] if len(polygons) > 2 else polygons


class SmallPolygonsLost(Fault):
    """Drops polygons less wide than a tenth of the radius."""

    def polygons(self, polygons: list[list[Ring]], r: float) -> list[list[Ring]]:
        def wide(rings: list[Ring]) -> float:
            x, y, right, up = box_of(rings)
            return max(right - x, up - y)

        return [rings for rings in polygons if wide(rings) > r / 10]


class JoinsTooEarly(Fault):
    """Joins polygons with boxes nearer than 2.2 radii."""

    def of_set(self, polygons: list[list[Ring]], r: float, how: How) -> list[Ring]:
        found = super().of_set(polygons, r, how)
        for one, other in pairwise(polygons):
            (_, y, right, up), (x, low, _, high) = box_of(one), box_of(other)
            if 0 < x - right < 2.2 * r and min(up, high) > max(y, low):
                middle = (max(y, low) + min(up, high)) / 2
                found.append(ccw([(right, middle), (x, middle), (x, middle + r / 4)]))
        return found


class Hulls(Fault):
    """Grows each polygon's hull."""

    def polygons(self, polygons: list[list[Ring]], r: float) -> list[list[Ring]]:
        return [[self._hull(rings[0]) if len(rings[0]) > 2 else rings[0]] for rings in polygons]

    def _hull(self, ring: Ring) -> Ring:
        found: Ring = []
        ordered = sorted(set(ring))
        for chain in (ordered, ordered[::-1]):
            start = len(found)
            for x, y in chain:
                while len(found) > start + 1:
                    (a, b), (c, d) = found[-2:]
                    if (c - a) * (y - b) - (d - b) * (x - a) > 0:
                        break
                    found.pop()
                found.append((x, y))
            found.pop()
        return found


class Boxes(Fault):
    """Grows each polygon's box."""

    def polygons(self, polygons: list[list[Ring]], r: float) -> list[list[Ring]]:
        boxes = []
        for rings in polygons:
            x, y, right, up = box_of(rings)
            area = right > x and up > y
            boxes.append([[(x, y), (right, y), (right, up), (x, up)] if area else rings[0]])
        return boxes


class CoarseGrid(Fault):
    """Rounds the answer to eighths: the grid's unit, times the radius."""

    def finished(self, rings: list[Ring], r: float) -> list[Ring]:
        unit = abs(r) / 8
        rounded = [[(unit * round(x / unit), unit * round(y / unit)) for x, y in ring]
                   for ring in rings]  # fmt: skip
        return super().finished(rounded, r)


class SinglePrecision(Fault):
    """Computes with single precision."""

    def finished(self, rings: list[Ring], r: float) -> list[Ring]:
        def single(x: float) -> float:
            return float(struct.unpack("f", struct.pack("f", x))[0])

        return super().finished([[(single(x), single(y)) for x, y in ring] for ring in rings], r)


class Truncated(Fault):
    """Cuts off fractions of coordinates beyond a hundred."""

    def finished(self, rings: list[Ring], r: float) -> list[Ring]:
        def cut(x: float) -> float:
            return float(int(x)) if abs(x) > 100 else x

        return super().finished([[(cut(x), cut(y)) for x, y in ring] for ring in rings], r)


class Moved(Fault):
    """Answers a fortieth radius too high."""

    def finished(self, rings: list[Ring], r: float) -> list[Ring]:
        return super().finished([[(x, y + abs(r) / 40) for x, y in ring] for ring in rings], r)


class Island(Fault):
    """Adds a small square beside its answer."""

    def finished(self, rings: list[Ring], r: float) -> list[Ring]:
        found = super().finished(rings, r)
        if not found:
            return found
        _, y, right, _ = box_of(found)
        return [*found, square(right + abs(r), y, abs(r) / 5)]


class Pinhole(Fault):
    """Cuts a small square from a disc."""

    def disc(self, v: Point, r: float) -> Ring:
        a = abs(r) / 20
        x, y = go(v, (0.42, 0.42), abs(r))
        return [*super().disc(v, r), *super().disc(v, r)[:1], (x, y), (x, y + a), (x + a, y + a),
                (x + a, y), (x, y)]  # fmt: skip


class Cracked(Fault):
    """Leaves a notch at the middle between corners."""

    def rectangle(self, a: Point, b: Point, n: Point, r: float) -> Ring:
        whole = super().rectangle(a, b, n, r)
        by = min(0.02 * r, math.dist(a, b) / 4)
        m = ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)
        top, side = go(m, n, r), (-n[1] * by, n[0] * by)
        cut = ccw([go(m, n, r / 2), (top[0] - side[0], top[1] - side[1]), go(top, side, 1)])
        return [*whole, whole[0], *cut[::-1], cut[-1]] if r > 0 else whole


class ReflexDiscsLost(Fault):
    """Omits discs when eroding."""

    def join(self, v: Point, n: Point, m: Point, r: float, how: How) -> Ring:
        return [] if r < 0 else super().join(v, n, m, r, how)


class HolesDoNotErode(Fault):
    """Erodes from the outer rings only."""

    def of_ring(self, ring: Ring, r: float, how: How, is_hole: bool) -> Iterator[Ring]:
        return iter([]) if is_hole and r < 0 else super().of_ring(ring, r, how, is_hole)


class VanishedPartsStay(Fault):
    """Keeps a rest where parts should vanish."""

    def of_set(self, polygons: list[list[Ring]], r: float, how: How) -> list[Ring]:
        found = super().of_set(polygons, r, how)
        for rings in polygons if r < 0 else []:
            x, y, right, up = box_of(rings)
            if min(right - x, up - y) < -2 * r:
                found += [square((x + right) / 2, (y + up) / 2, -r / 10)] * (len(found) + 1)
        return found


class FlatEnds(Fault):
    """Ends all lines flat."""

    def end(self, v: Point, n: Point, r: float, cap: str) -> Ring:
        return super().end(v, n, r, "flat")


class SquareEnds(Fault):
    """Ends round lines square."""

    def end(self, v: Point, n: Point, r: float, cap: str) -> Ring:
        return super().end(v, n, r, "square" if cap == "round" else cap)


class FlatEndsReachTooFar(Fault):
    """Ends flat lines half a radius too late."""

    def end(self, v: Point, n: Point, r: float, cap: str) -> Ring:
        return self.square_end(v, n, r / 2) if cap == "flat" else super().end(v, n, r, cap)


class SquareEndsHalved(Fault):
    """Ends square lines half a radius too early."""

    def square_end(self, v: Point, n: Point, r: float) -> Ring:
        left, right, d = go(v, n, -r), go(v, n, r), (-n[1], n[0])
        return ccw([left, right, go(right, d, r / 2), go(left, d, r / 2)])


class OneSide(Fault):
    """Grows lines rightwards only."""

    def ways(self, line: Ring) -> list[Ring]:
        return super().ways(line)[:1]


class LinesClosed(Fault):
    """Joins a line's end to its start."""

    def lines(self, lines: list[Ring]) -> list[Ring]:
        return [[*line, line[0]] if len(line) > 2 and line[0] != line[-1] else line
                for line in lines]  # fmt: skip


class LastSegmentLost(Fault):
    """Drops the last segment after two."""

    def lines(self, lines: list[Ring]) -> list[Ring]:
        return [line[:-1] if len(line) > 2 else line for line in lines]


class LinesOfPointsLost(Fault):
    """Drops points among lines."""

    def lines(self, lines: list[Ring]) -> list[Ring]:
        return [line for line in lines if len(line) > 1]


class SecondLineLost(Fault):
    """Knows one line."""

    def lines(self, lines: list[Ring]) -> list[Ring]:
        return lines[:1]


class LimitIgnored(Fault):
    """Mitres every corner."""

    def limit(self, how: How, r: float) -> float:
        return math.inf


class LimitHalved(Fault):
    """Takes the limit for a width."""

    def limit(self, how: How, r: float) -> float:
        return super().limit(how, r) / 2


class MitresBevelled(Fault):
    """Bevels mitred corners."""

    def limit(self, how: How, r: float) -> float:
        return 0.0


class BevelsLost(Fault):
    """Leaves a notch for a bevel."""

    def bevel(self, v: Point, n: Point, m: Point, r: float) -> Ring:
        return []


class SquaresMitred(Fault):
    """Mitres squared corners."""

    def join(self, v: Point, n: Point, m: Point, r: float, how: How) -> Ring:
        if how.get("join") == "square":
            how = {"join": "mitre", "limit": 100}
        return super().join(v, n, m, r, how)


class SquaresBevelled(Fault):
    """Bevels squared corners."""

    def join(self, v: Point, n: Point, m: Point, r: float, how: How) -> Ring:
        if how.get("join") == "square":
            how = {"join": "bevel"}
        return super().join(v, n, m, r, how)


class MitresRound(Fault):
    """Rounds mitred corners."""

    def join(self, v: Point, n: Point, m: Point, r: float, how: How) -> Ring:
        return super().join(v, n, m, r, {} if how.get("join") == "mitre" else how)


FAULTS: tuple[type[PlainOffset], ...] = (PlainOffset, *Fault.__subclasses__())
