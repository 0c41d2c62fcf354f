"""Whether a point lies in sP + Q, if one operand is a point or a segment."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point, Scale, Whole, denominator_of, dot, whole
from minkref.fuzz.space.meeting import Decision, Meeting, cube_inside
from minkref.fuzz.space.triangle_contact import farther_than

Probe = tuple[Point, Point]  # ends of a segment in the other operand's coordinates
SHARES = (Fraction(1, 2), Fraction(1, 4), Fraction(3, 4), Fraction(1, 16), Fraction(15, 16))


class ThinMeeting(Meeting):
    """x lies in the sum iff the segment meets the other operand, mirrored at x. Each question
    takes O(n) winding numbers for n triangles of it."""

    def __init__(self, P: Polyhedron, Q: Polyhedron, scale: Scale) -> None:
        super().__init__(P, Q, scale)
        self._flat, self._body = (self.sP, self.in_Q) if P.is_thin else (Q, self.in_sP)

    def place(self, x: Point) -> Point | None:
        probe = self._probe(x)
        for t in self._stops(probe):
            place = _along(probe, t)
            if self._body.contains(place):
                return self._in_sP(x, place)
        return None

    def decide(self, x: Point) -> Decision:
        """Decides between touching and not: without an interior, sets cannot overlap."""
        place = self.place(x)
        return Decision("empty") if place is None else self.decision("touch", place, x)

    def apart(self, x: Point, distance: Fraction) -> bool:
        if distance == 0:
            return not self.meets(x)
        probe = self._probe(x)
        unit = denominator_of([*probe, (distance, distance, distance)]) * self._body.denominator
        a, b = (whole(end, unit) for end in probe)
        factor = unit // self._body.denominator
        return self.place(x) is None and all(
            farther_than((a, b, b), _times(triangle, factor), int(distance * unit))
            for triangle in self._body.triangles
        )

    def deep(self, x: Point, distance: Fraction) -> Decision | None:
        probe = self._probe(x)
        stops = self._stops(probe)
        for low, high in pairwise(stops) if len(stops) > 1 else ((stops[0], stops[0]),):
            for share in SHARES:
                place = _along(probe, low + share * (high - low))
                if self._body.contains(place) and cube_inside(self._body, place, distance):
                    return self.decision("overlap", self._in_sP(x, place), x)
        return None

    def _probe(self, x: Point) -> Probe:
        """Returns the places for meeting the other operand, for the sum x."""
        a, b = (
            (x[0] - end[0], x[1] - end[1], x[2] - end[2])
            for end in (self._flat.vertices[0], self._flat.vertices[-1])
        )
        return a, b

    def _in_sP(self, x: Point, place: Point) -> Point:
        """Converts a place in the other operand to the summand in sP."""
        if self._flat is not self.sP:
            return place
        return (x[0] - place[0], x[1] - place[1], x[2] - place[2])

    def _stops(self, probe: Probe) -> list[Fraction]:
        """0, 1 and where the segment passes through the planes of the triangles, ascending: the
        parts between are inside or outside as a whole."""
        unit = denominator_of(probe) * self._body.denominator
        a, b = (whole(end, unit) for end in probe)
        factor = unit // self._body.denominator
        found = {Fraction(0), Fraction(1)} if a != b else {Fraction(0)}
        for triangle, n in zip(self._body.triangles, self._body.normals, strict=True):
            height = factor * dot(n, triangle[0])
            at_a, at_b = dot(n, a) - height, dot(n, b) - height
            if (at_a < 0) != (at_b < 0):
                found.add(Fraction(at_a, at_a - at_b))
        return sorted(t for t in found if 0 <= t <= 1)


def _along(probe: Probe, t: Fraction) -> Point:
    a, b = probe
    return (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2]))


def _times(triangle: tuple[Whole, Whole, Whole], factor: int) -> tuple[Whole, Whole, Whole]:
    (a, b, c), k = triangle, factor
    return (
        (k * a[0], k * a[1], k * a[2]),
        (k * b[0], k * b[1], k * b[2]),
        (k * c[0], k * c[1], k * c[2]),
    )
