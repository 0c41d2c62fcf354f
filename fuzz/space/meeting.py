"""Whether a point lies in sP + Q, from the definition: iff sP meets x - Q. No sum is computed."""

from __future__ import annotations

import random
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from math import lcm
from typing import Literal

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point, Scale, Whole, dot, factors, middle, normal, whole
from minkref.fuzz.space.boxes import BoxTree, box_of, box_pairs
from minkref.fuzz.space.face_pieces import inside, pieces, polygon_of
from minkref.fuzz.space.membership import Surface, in_triangle
from minkref.fuzz.space.triangle_contact import Triangle, as_point, contact, farther_than

Contact = Literal["empty", "touch", "overlap"]
MOST_CORNERS = 40  # corners of sP cut with x - Q, mixed to find a place deep inside
MIXTURES = 60


@dataclass(frozen=True)
class Decision:
    """How sP and x - Q meet; where they do, scale p + q = x."""

    contact: Contact
    p: Point | None = None
    q: Point | None = None


class Meeting:
    """Two polyhedra and a scale, for questions about many points. Each question takes O(mn)
    comparisons of boxes, and exact tests for the remaining pairs of triangles."""

    def __init__(self, P: Polyhedron, Q: Polyhedron, scale: Scale) -> None:
        self.scale = factors(scale)
        self.sP = P.scaled(self.scale)
        self.Q = Q
        self.in_sP, self.in_Q = Surface(self.sP), Surface(Q)
        self.denominator = lcm(self.sP.denominator, Q.denominator)
        self._a = _times(self.in_sP.triangles, self.denominator // self.sP.denominator)
        self._b = _times(self.in_Q.triangles, self.denominator // Q.denominator)
        self._normals_a = [normal(*triangle) for triangle in self._a]
        # Normals for triangles of x - Q, which run the other way.
        self._normals_b = [(-x, -y, -z) for x, y, z in (normal(*t) for t in self._b)]
        self._boxes_a = [box_of(triangle) for triangle in self._a]
        self._boxes_b = [box_of(triangle) for triangle in self._b]
        self._shells_a = [self.sP.vertices[k] for k in sorted(set(self.sP.shells))]
        self._shells_b = [Q.vertices[k] for k in sorted(set(Q.shells))]

    def meets(self, x: Point) -> bool:
        """x lies in the closed sum."""
        return self.place(x) is not None

    def place(self, x: Point) -> Point | None:
        """Returns a common point of sP and x - Q; None if x lies outside the closed sum."""
        found = next(self._contacts(x), None)
        return self._nested(x) if found is None else found[0]

    def decide(self, x: Point) -> Decision:
        """Decides how sP and x - Q meet. A mere touch takes longest: each triangle is cut by the
        triangles that it meets."""
        found: Point | None = None
        for point, proper in self._contacts(x):
            found = found or point
            if proper:
                return self.decision("overlap", point, x)
        if found is None:
            found = self._nested(x)
            return Decision("empty") if found is None else self.decision("overlap", found, x)
        return self.decision("overlap" if self._interiors_meet(x) else "touch", found, x)

    def apart(self, x: Point, distance: Fraction) -> bool:
        """Whether the sum contains no point of the cube with half side `distance` around x."""
        if distance == 0:
            return not self.meets(x)
        a, b, _, unit = self._placed(x, distance)
        reach = int(distance * unit)
        for i, j in box_pairs(
            [box_of(t) for t in a] if unit != self.denominator else self._boxes_a,
            [box_of(t) for t in b],
            reach,
        ):
            if not farther_than(a[i], b[j], reach):
                return False
        return self._nested(x) is None

    def deep(self, x: Point, distance: Fraction) -> Decision | None:
        """Returns p and q that prove the cube with half side `distance` around x to lie in the sum:
        the cube around scale p lies in sP, or the cube around q in Q. None if none was found, which
        proves nothing. The arguments alone determine the places tried."""
        corners = self._common_corners(x)
        if not corners:
            return None
        dice = random.Random(f"deep {x}")
        for number in range(MIXTURES + len(corners)):
            if number < len(corners):
                place = corners[number]
            else:
                chosen = [dice.choice(corners) for _ in range(dice.randint(2, 6))]
                if number == len(corners):
                    chosen = corners
                place = middle(chosen)
            q = _difference(x, place)
            if not (self.in_sP.contains(place) and self.in_Q.contains(q)):
                continue
            if cube_inside(self.in_sP, place, distance) or cube_inside(self.in_Q, q, distance):
                return self.decision("overlap", place, x)
        return None

    def decision(self, kind: Contact, place: Point, x: Point) -> Decision:
        a, b, c = self.scale
        return Decision(kind, (place[0] / a, place[1] / b, place[2] / c), _difference(x, place))

    def _placed(
        self, x: Point, distance: Fraction = Fraction(0)
    ) -> tuple[list[Triangle], list[Triangle], int, int]:
        """Returns the triangles of sP and of x - Q times the last number, in integers; the third
        value is the factor by which the triangles of sP grew."""
        w = lcm(*((number * self.denominator).denominator for number in (*x, distance)))
        unit = self.denominator * w
        X, Y, Z = whole(x, unit)
        a = self._a if w == 1 else _times(self._a, w)
        b: list[Triangle] = [
            (
                (X - w * t[0][0], Y - w * t[0][1], Z - w * t[0][2]),
                (X - w * t[2][0], Y - w * t[2][1], Z - w * t[2][2]),
                (X - w * t[1][0], Y - w * t[1][1], Z - w * t[1][2]),
            )
            for t in self._b
        ]
        return a, b, w, unit

    def _contacts(self, x: Point) -> Iterator[tuple[Point, bool]]:
        """Yields common points of the surfaces of sP and x - Q, one for each pair of meeting
        triangles, and whether the triangles cross properly."""
        a, b, w, unit = self._placed(x)
        X, Y, Z = whole(x, unit)
        boxes_a = self._boxes_a
        if w != 1:
            boxes_a = [
                (w * k[0], w * k[1], w * k[2], w * k[3], w * k[4], w * k[5]) for k in boxes_a
            ]
        boxes_b = [
            (X - w * k[1], X - w * k[0], Y - w * k[3], Y - w * k[2], Z - w * k[5], Z - w * k[4])
            for k in self._boxes_b
        ]
        for i, j in box_pairs(boxes_a, boxes_b, 0):
            met = contact(a[i], self._normals_a[i], b[j], self._normals_b[j])
            if met is not None:
                yield as_point(met[0], unit), met[1]

    def _nested(self, x: Point) -> Point | None:
        """Returns a point of sP and x - Q, if a shell's first vertex lies inside the other
        solid."""
        for vertex in self._shells_a:
            if self.in_Q.contains(_difference(x, vertex)):
                return vertex
        for vertex in self._shells_b:
            place = _difference(x, vertex)
            if self.in_sP.contains(place):
                return place
        return None

    def _interiors_meet(self, x: Point) -> bool:
        """Whether the interiors meet: iff a surface piece of one lies inside the other, or on its
        surface with the same side outside."""
        a, b, _, unit = self._placed(x)
        for place, n in _all_pieces(a, self._normals_a, b):
            q = _difference(x, _shrunk(place, unit))
            winding = self.in_Q.winding(q)
            if winding is None:
                if _same_side(place, n, b, self._normals_b):
                    return True
            elif winding > 0:
                return True
        for place, _ in _all_pieces(b, self._normals_b, a):
            winding = self.in_sP.winding(_shrunk(place, unit))
            if winding is not None and winding > 0:
                return True
        return False

    def _common_corners(self, x: Point) -> list[Point]:
        """Returns some points of sP and x - Q, mostly corners of their intersection."""
        found = dict.fromkeys(
            vertex for vertex in self.sP.vertices if self.in_Q.contains(_difference(x, vertex))
        )
        for vertex in self.Q.vertices:
            place = _difference(x, vertex)
            if self.in_sP.contains(place):
                found[place] = None
        for point, _ in self._contacts(x):
            found[point] = None
            if len(found) >= 4 * MOST_CORNERS:
                break
        corners = list(found)
        return corners[:: 1 + len(corners) // MOST_CORNERS]


def decide(P: Polyhedron, Q: Polyhedron, scale: Scale, x: Point) -> Decision:
    """For a single point; `Meeting` is for many."""
    return Meeting(P, Q, scale).decide(x)


def cube_inside(surface: Surface, place: Point, distance: Fraction) -> bool:
    """Whether the inside contains the cube with half side `distance` around a place from the closed
    set."""
    if surface.winding(place) is None:
        return False
    w = lcm(*((number * surface.denominator).denominator for number in (*place, distance)))
    unit = surface.denominator * w
    reach = int(distance * unit)
    x, y, z = point = whole(place, unit)
    for triangle, box in zip(surface.triangles, surface.boxes, strict=True):
        if (
            w * box[0] > x + reach
            or w * box[1] < x - reach
            or w * box[2] > y + reach
            or w * box[3] < y - reach
            or w * box[4] > z + reach
            or w * box[5] < z - reach
        ):
            continue
        if reach == 0:
            continue  # the place itself is not on the surface
        grown = _times([triangle], w)[0]
        if not farther_than((point, point, point), grown, reach):
            return False
    return True


def _all_pieces(
    triangles: list[Triangle], normals: list[Whole], others: list[Triangle]
) -> Iterator[tuple[Point, Whole]]:
    tree = BoxTree([box_of(t) for t in others])
    for triangle, n in zip(triangles, normals, strict=True):
        near = [others[j] for j in tree.meeting(box_of(triangle))]
        for piece in pieces([polygon_of(triangle)], n, near):
            yield inside(piece), n


def _same_side(place: Point, n: Whole, others: list[Triangle], normals: list[Whole]) -> bool:
    """Whether some coplanar triangle that holds the place has its outside on the same side."""
    w = lcm(*(number.denominator for number in place))
    point = whole(place, w)
    for (a, b, c), m in zip(others, normals, strict=True):
        if dot(n, m) <= 0 or dot(m, point) != w * dot(m, a):
            continue
        if in_triangle(point, w, (a, b, c), m):
            return True
    return False


def _shrunk(place: Point, unit: int) -> Point:
    return (place[0] / unit, place[1] / unit, place[2] / unit)


def _difference(a: Point, b: Point) -> Point:
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def _times(triangles: list[Triangle], factor: int) -> list[Triangle]:
    if factor == 1:
        return triangles
    return [
        (
            (factor * a[0], factor * a[1], factor * a[2]),
            (factor * b[0], factor * b[1], factor * b[2]),
            (factor * c[0], factor * c[1], factor * c[2]),
        )
        for a, b, c in triangles
    ]
