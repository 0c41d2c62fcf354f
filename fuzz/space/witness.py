"""Checks a witness in space, from the definition of the sum alone.

Works on whole faces, triangulates nothing, and shares no code with the search for the witness,
except the reading of a polyhedron.
"""

from __future__ import annotations

import random
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from itertools import product
from math import lcm

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point, Scale, factors
from minkref.fuzz.verdicts.verdict import Witness

Number = int | Fraction
Place = tuple[Number, Number, Number]
Edge = tuple[Place, Place]


@dataclass(frozen=True)
class Face:
    """A planar polygon, a normal, and its lowest and highest coordinates; or a point or segment as
    an operand, as a ring with one or two points."""

    ring: list[Place]
    normal: Place
    low: Place
    high: Place

    @property
    def edges(self) -> Iterator[Edge]:
        return zip(self.ring, self.ring[1:] + self.ring[:1], strict=True)

    @property
    def is_thin(self) -> bool:
        return len(self.ring) < 3


def holds(
    P: Polyhedron, Q: Polyhedron, scale: Scale, witness: Witness, tolerance: Fraction | None = None
) -> bool:
    """True iff the witness proves its statement. Inside: scale p + q is the point, and with a
    tolerance the cube with this half side around scale p lies in sP, or the cube around q in Q.
    Outside: sP and the set of all point - q have no two points that differ by at most the tolerance
    in every coordinate. The tolerance is the witness's unless given. O(mn) exact tests of face
    pairs, in integers except for points where faces meet lines."""
    s = factors(scale)
    reach = Fraction(witness.tolerance) if tolerance is None else tolerance
    x = _point(witness.point)
    scaled = [(s[0] * a, s[1] * b, s[2] * c) for a, b, c in P.vertices]
    if not witness.in_truth:
        mirrored = [(x[0] - a, x[1] - b, x[2] - c) for a, b, c in Q.vertices]
        unit = _unit([*scaled, *mirrored, (reach, reach, reach)])
        return not _near(_faces(P, scaled, unit), _faces(Q, mirrored, unit), int(reach * unit))
    if witness.p is None or witness.q is None:
        return False
    p, q = _point(witness.p), _point(witness.q)
    a = (s[0] * p[0], s[1] * p[1], s[2] * p[2])
    if (a[0] + q[0], a[1] + q[1], a[2] + q[2]) != x:
        return False
    unit = _unit([*scaled, *Q.vertices, a, q, (reach, reach, reach)])
    in_P, in_Q = _times(a, unit), _times(q, unit)
    P_faces, Q_faces = _faces(P, scaled, unit), _faces(Q, Q.vertices, unit)
    if not (contains(P_faces, in_P) and contains(Q_faces, in_Q)):
        return False
    if reach == 0:
        return True
    t = int(reach * unit)
    return not any(_box_meets(in_P, t, face) for face in P_faces) or not any(
        _box_meets(in_Q, t, face) for face in Q_faces
    )


def _point(texts: tuple[str, ...]) -> Point:
    x, y, z = (Fraction(text) for text in texts)
    return (x, y, z)


def _unit(points: Iterable[Point]) -> int:
    return lcm(*{number.denominator for point in points for number in point})


def _times(point: Point, unit: int) -> Place:
    return (int(point[0] * unit), int(point[1] * unit), int(point[2] * unit))


def _faces(polyhedron: Polyhedron, points: Iterable[Point], unit: int) -> list[Face]:
    places = [_times(point, unit) for point in points]
    found = []
    for face in polyhedron.faces or (range(len(places)),):
        ring = [places[index] for index in face]
        (x0, x1), (y0, y1), (z0, z1) = ((min(c), max(c)) for c in zip(*ring, strict=True))
        found.append(Face(ring, _normal(ring), (x0, y0, z0), (x1, y1, z1)))
    return found


def contains(faces: list[Face], point: Place) -> bool:
    """Whether the point lies in the closed set: on a face, or with an odd number of faces on a ray
    from the point. A ray that meets a face's rim is drawn anew."""
    if any(
        max(face.high[k] for face in faces) < point[k]
        or min(face.low[k] for face in faces) > point[k]
        for k in range(3)
    ):
        return False
    if any(_in_face(face, point) for face in faces):
        return True
    if any(face.is_thin for face in faces):
        return False
    dice = random.Random(f"ray {point}")
    while True:
        ray = (dice.randint(-999, 999), dice.randint(-999, 999), dice.randint(-999, 999))
        hits = [_ray_hits(face, point, ray) for face in faces]
        if None not in hits:
            return sum(1 for hit in hits if hit) % 2 == 1


def _ray_hits(face: Face, point: Place, ray: Place) -> bool | None:
    """Whether the ray passes through the face's inside; None if unclear."""
    along, height = _dot(face.normal, ray), _dot(face.normal, _minus(face.ring[0], point))
    if along == 0:
        return None
    t = Fraction(height, along)
    if t < 0:
        return False
    side = _side(face, (point[0] + t * ray[0], point[1] + t * ray[1], point[2] + t * ray[2]))
    return None if side == 0 else side > 0


def _near(first: list[Face], second: list[Face], t: int) -> bool:
    """Whether the closed sets have two points that differ by at most t in every coordinate: two
    faces come as near, or one set holds a vertex of the other."""
    for f in first:
        for g in second:
            if all(f.low[k] - t <= g.high[k] and g.low[k] - t <= f.high[k] for k in range(3)):
                if _faces_near(f, g, t):
                    return True
    return any(contains(second, place) for place in {face.ring[0] for face in first}) or any(
        contains(first, place) for place in {face.ring[0] for face in second}
    )


def _faces_near(f: Face, g: Face, t: int) -> bool:
    """Compares two faces: a corner of one and a point of the other are nearest, or two edges,
    unless the faces meet: then an edge of one meets the other face."""
    for one, other in ((f, g), (g, f)):
        if any(_box_meets(corner, t, other) for corner in one.ring):
            return True
        if any(_edge_meets(a, b, other) for a, b in one.edges):
            return True
    return any(_edges_near(edge, other, t) for edge in f.edges for other in g.edges)


def _edge_meets(a: Place, b: Place, face: Face) -> bool:
    """Whether the segment passes through the face's plane within the face. Segments in the plane
    are left to the tests of edges and corners."""
    at_a = _dot(face.normal, _minus(a, face.ring[0]))
    at_b = _dot(face.normal, _minus(b, face.ring[0]))
    if at_a == at_b or (at_a > 0 and at_b > 0) or (at_a < 0 and at_b < 0):
        return False
    return _side(face, _between(a, b, Fraction(at_a, at_a - at_b))) >= 0


def _box_meets(centre: Place, t: int, face: Face) -> bool:
    """Whether the closed cube with half side t meets the face: an edge, or else the face contains
    the cube's whole intersection with its plane."""
    if any(face.low[k] - t > centre[k] or face.high[k] + t < centre[k] for k in range(3)):
        return False
    if any(_edges_near((centre, centre), edge, t) for edge in face.edges):
        return True
    if face.is_thin:
        return False
    heights = []
    for i, j, k in product((-t, t), repeat=3):
        corner = (centre[0] + i, centre[1] + j, centre[2] + k)
        heights.append((_dot(face.normal, _minus(corner, face.ring[0])), corner))
    (low, a), (high, b) = min(heights), max(heights)
    if low > 0 or high < 0:
        return False
    return _side(face, a if low == high else _between(a, b, Fraction(low, low - high))) >= 0


def _edges_near(e: Edge, f: Edge, t: int) -> bool:
    """Whether the parallelogram of all differences meets the cube with half side t."""
    (a, b), (c, d) = e, f
    polygon = [_minus(a, c), _minus(b, c), _minus(b, d), _minus(a, d)]
    for axis in range(3):
        for sign in (-1, 1):
            polygon = _cut(polygon, axis, sign, t)
            if not polygon:
                return False
    return True


def _cut(polygon: list[Place], axis: int, sign: int, t: int) -> list[Place]:
    """The part of a convex polygon in the closed half-space `sign * coordinate <= t`."""
    kept: list[Place] = []
    for k, b in enumerate(polygon):
        a = polygon[k - 1]
        over_a, over_b = sign * a[axis] - t, sign * b[axis] - t
        if (over_a < 0 < over_b) or (over_b < 0 < over_a):
            kept.append(_between(a, b, Fraction(over_a, over_a - over_b)))
        if over_b <= 0:
            kept.append(b)
    return kept


def _between(a: Place, b: Place, t: Fraction) -> Place:
    return (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2]))


def _in_face(face: Face, point: Place) -> bool:
    if face.is_thin:
        return _edges_near((point, point), (face.ring[0], face.ring[-1]), 0)
    return _dot(face.normal, _minus(point, face.ring[0])) == 0 and _side(face, point) >= 0


def _side(face: Face, point: Place) -> int:
    """The side of a coplanar point: 1 inside the face, 0 on its rim, -1 outside."""
    lengths = [abs(number) for number in face.normal]
    axis = max((length, k) for k, length in enumerate(lengths))[1]
    u, v = (k for k in range(3) if k != axis)
    x, y = point[u], point[v]
    if not (face.low[u] <= x <= face.high[u] and face.low[v] <= y <= face.high[v]):
        return -1
    inside = False
    for a, b in face.edges:
        turn = (b[u] - a[u]) * (y - a[v]) - (b[v] - a[v]) * (x - a[u])
        if turn == 0 and min(a[u], b[u]) <= x <= max(a[u], b[u]):
            if min(a[v], b[v]) <= y <= max(a[v], b[v]):
                return 0
        if (a[v] > y) != (b[v] > y) and (turn > 0) == (b[v] > a[v]):
            inside = not inside
    return 1 if inside else -1


def _normal(ring: list[Place]) -> Place:
    x: Number = 0
    y: Number = 0
    z: Number = 0
    for a, b in zip(ring, ring[1:] + ring[:1], strict=True):
        x += a[1] * b[2] - a[2] * b[1]
        y += a[2] * b[0] - a[0] * b[2]
        z += a[0] * b[1] - a[1] * b[0]
    return (x, y, z)


def _minus(a: Place, b: Place) -> Place:
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def _dot(a: Place, b: Place) -> Number:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
