"""Whether a surface crosses or touches itself, by edges and whole faces."""

from __future__ import annotations

from minkref.fuzz.geometry.plane import in_box, turn
from minkref.fuzz.geometry.polyhedron import Face, Polyhedron
from minkref.fuzz.geometry.space import Whole, area_vector, dot, flattened, longest_axis
from minkref.fuzz.space.boxes import BoxTree, box_of

Flat = tuple[int, int]
Edge = tuple[int, int]


def self_crossing(surface: Polyhedron) -> tuple[Edge, Face] | None:
    """Returns an edge, by its vertices, and a face that share more than common vertices, or than
    the edge as an edge of the face; None without such a pair. For a surface without `fault`. Exact,
    in integers."""
    points = surface.wholes
    faces = [(face, area_vector([points[k] for k in face])) for face in surface.faces]
    tree = BoxTree([box_of([points[k] for k in face]) for face in surface.faces])
    for ring in surface.faces:
        for a, b in zip(ring, ring[1:] + ring[:1], strict=True):
            if a > b:
                continue  # once, not from both sides
            for number in tree.meeting(box_of((points[a], points[b]))):
                if _cross(points, (a, b), *faces[number]):
                    return (a, b), surface.faces[number]
    return None


def _cross(points: tuple[Whole, ...], edge: Edge, face: Face, n: Whole) -> bool:
    p, q = points[edge[0]], points[edge[1]]
    level = dot(n, points[face[0]])
    at_p, at_q = dot(n, p) - level, dot(n, q) - level
    if (at_p > 0 and at_q > 0) or (at_p < 0 and at_q < 0):
        return False
    axis = longest_axis(n)
    ring = [flattened(points[k], axis) for k in face]
    if at_p == at_q == 0:
        return _cross_in_plane(flattened(p, axis), flattened(q, axis), edge, face, ring)
    if (at_p == 0 and edge[0] in face) or (at_q == 0 and edge[1] in face):
        return False
    # The edge's point in the plane, times the difference of the heights.
    times = at_p - at_q
    x, y, z = (at_p * v - at_q * u for u, v in zip(p, q, strict=True))
    return _holds([(times * u, times * v) for u, v in ring], flattened((x, y, z), axis))


def _cross_in_plane(p: Flat, q: Flat, edge: Edge, face: Face, ring: list[Flat]) -> bool:
    sides = list(zip(face, face[1:] + face[:1], strict=True))
    if edge in sides or edge[::-1] in sides:
        return False
    for k, side in enumerate(sides):
        a, b = ring[k], ring[(k + 1) % len(ring)]
        shared = set(edge) & set(side)
        if shared:
            one, other = (q if edge[0] in shared else p), (b if side[0] in shared else a)
            at = p if edge[0] in shared else q
            if turn(at, one, other) == 0 and (in_box(at, one, other) or in_box(at, other, one)):
                return True
        elif turn(a, b, p) * turn(a, b, q) <= 0 and turn(p, q, a) * turn(p, q, b) <= 0:
            if any(in_box(a, b, c) for c in (p, q)) or any(in_box(p, q, c) for c in (a, b)):
                return True
            if turn(a, b, p) != 0 or turn(a, b, q) != 0:
                return True
    double = [(2 * x, 2 * y) for x, y in ring]
    return _holds(double, (p[0] + q[0], p[1] + q[1]))


def _holds(ring: list[Flat], point: Flat) -> bool:
    """The point lies in the closed polygon."""
    odd = False
    for k, b in enumerate(ring):
        a = ring[k - 1]
        side = turn(a, b, point)
        if side == 0 and in_box(a, b, point):
            return True
        if (a[1] <= point[1]) != (b[1] <= point[1]):
            odd ^= (side > 0) == (b[1] > a[1])
    return odd
