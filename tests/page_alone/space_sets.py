"""Sets in space as lists of closed shells (vertices, faces) that may lie side by side or overlap."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from itertools import product
from math import lcm
from typing import Any

from conversation import number_of
from minkref import _core
from plane_sets import Ring, rings_of, set_of_rings, sum_of, trapezoids

Point = tuple[Fraction, ...]
Face = list[int]
Shell = tuple[list[Point], list[Face]]


def shell_of(value: Any) -> Shell:
    points = [tuple(number_of(c) for c in point) for point in value["vertices"]]
    return points, [list(face) for face in value["faces"]]


def minus(a: Point, b: Point) -> Point:
    return tuple(x - y for x, y in zip(a, b, strict=True))


def plus(a: Point, b: Point) -> Point:
    return tuple(x + y for x, y in zip(a, b, strict=True))


def dot(a: Point, b: Point) -> Fraction:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Point, b: Point) -> Point:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def normal_of(corners: list[Point]) -> Point:
    """Twice the area of a planar polygon, as a vector."""
    total: Point = (Fraction(0),) * 3
    for k in range(1, len(corners) - 1):
        total = plus(total, cross(minus(corners[k], corners[0]), minus(corners[k + 1], corners[0])))
    return total


def corners_of(shell: Shell, face: Face) -> list[Point]:
    return [shell[0][k] for k in face]


def is_convex(shell: Shell) -> bool:
    used = {k for face in shell[1] for k in face}
    for face in shell[1]:
        corners = corners_of(shell, face)
        n = normal_of(corners)
        if any(dot(n, minus(shell[0][k], corners[0])) > 0 for k in used):
            return False
    return True


def hull(points: Iterable[Point]) -> Shell | None:
    """Triangles around the convex hull; None where it is flat."""
    given = sorted(set(points))
    factor = lcm(*(c.denominator for p in given for c in p))
    whole = [tuple(int(c * factor) for c in p) for p in given]
    start = independent(whole)
    if start is None:
        return None
    middle = tuple(sum(whole[k][axis] for k in start) for axis in range(3))  # times 4
    faces: list[tuple[Face, Any, int]] = []

    def add(a: int, b: int, c: int) -> None:
        n = cross(minus(whole[b], whole[a]), minus(whole[c], whole[a]))
        level = dot(n, whole[a])
        if dot(n, middle) > 4 * level:
            a, b, n, level = b, a, tuple(-x for x in n), -level
        faces.append(([a, b, c], n, level))

    for k in range(4):
        add(*(start[j] for j in range(4) if j != k))
    for k, point in enumerate(whole):
        seen = [face for face in faces if dot(face[1], point) > face[2]]
        if not seen:
            continue
        sides = {(f[i], f[i - 2]) for f, _, _ in seen for i in range(3)}
        faces[:] = [face for face in faces if dot(face[1], point) <= face[2]]
        for a, b in sides:
            if (b, a) not in sides:
                add(a, b, k)
    return given, [face for face, _, _ in faces]


def independent(points: list[Any]) -> list[int] | None:
    """Four points that lie in no plane."""
    if len(points) < 4:
        return None
    edge = minus(points[1], points[0])
    for k in range(2, len(points)):
        n = cross(edge, minus(points[k], points[0]))
        if any(n):
            for j in range(2, len(points)):
                if dot(n, minus(points[j], points[0])):
                    return [0, 1, k, j]
            return None
    return None


def fan(corners: list[Point]) -> list[list[Point]]:
    """A planar polygon as strictly convex pieces that have all its vertices."""
    n = normal_of(corners)
    ring = list(corners)
    pieces: list[list[Point]] = []
    while len(ring) > 3 and not all(turn(n, ring, k) > 0 for k in range(len(ring))):
        for k in range(len(ring)):
            a, b, c = ring[k - 1], ring[k], ring[(k + 1) % len(ring)]
            others = [p for p in ring if p not in (a, b, c)]
            if turn(n, ring, k) > 0 and not any(within(n, (a, b, c), p) for p in others):
                pieces.append([a, b, c])
                del ring[k]
                break
        else:
            raise ValueError("no ear")
    return [*pieces, ring]


def turn(n: Point, ring: list[Point], k: int) -> Fraction:
    a, b, c = ring[k - 1], ring[k], ring[(k + 1) % len(ring)]
    return dot(n, cross(minus(b, a), minus(c, b)))


def within(n: Point, triangle: tuple[Point, ...], p: Point) -> bool:
    return all(
        dot(n, cross(minus(triangle[(k + 1) % 3], triangle[k]), minus(p, triangle[k]))) >= 0
        for k in range(3)
    )


def convex_faces(shell: Shell) -> list[list[Point]]:
    return [piece for face in shell[1] for piece in fan(corners_of(shell, face))]


def sums(first: Iterable[Point], second: Iterable[Point]) -> Shell | None:
    return hull(plus(a, b) for a, b in product(first, list(second)))


def moved(shell: Shell, by: Point) -> Shell:
    return [plus(point, by) for point in shell[0]], shell[1]


def parts_of(shell: Shell) -> list[list[int]]:
    """The vertices of each connected piece of the surface."""
    group = list(range(len(shell[0])))

    def root(k: int) -> int:
        while group[k] != k:
            k = group[k]
        return k

    for face in shell[1]:
        for k in face:
            group[root(k)] = root(face[0])
    found: dict[int, list[int]] = {}
    for k in sorted({k for face in shell[1] for k in face}):
        found.setdefault(root(k), []).append(k)
    return list(found.values())


def sum_in_space(P: Shell, Q: Shell) -> list[Shell]:
    """Shells whose points of positive winding number are P + Q, without parts of no volume."""
    if not P[0] or not Q[0]:
        return []
    for one, other in ((P, Q), (Q, P)):
        if not one[1] and len(one[0]) == 1:
            return [moved(other, one[0][0])] if other[1] else []
    if not P[1] or is_convex(P):
        P, Q = Q, P
    if not P[1]:
        return []
    if not Q[1] or is_convex(Q):
        if is_convex(P):
            found = sum_of_bodies(P, Q) if Q[1] else None
            found = found or sums(P[0], Q[0])
            return [found] if found else []
        rest = Q[0] if not Q[1] else [Q[0][k] for k in sorted({k for f in Q[1] for k in f})]
        pieces = [sums(face, rest) for face in convex_faces(P)]
        return [moved(P, rest[0]), *(piece for piece in pieces if piece)]
    for route in (sum_of_blocks, sum_of_prisms):
        blocks = route(P, Q)
        if blocks is not None:
            return blocks
    pieces = [sums(a, b) for a in convex_faces(P) for b in convex_faces(Q)]
    whole = [moved(P, Q[0][part[0]]) for part in parts_of(Q)]
    whole += [moved(Q, P[0][part[0]]) for part in parts_of(P)]
    return [*whole, *(piece for piece in pieces if piece)]


def sum_of_bodies(P: Shell, Q: Shell) -> Shell:
    """The reference's sum of convex bodies."""
    found = _core.convex_sum(body_of(P), body_of(Q), ("1", "1", "1")).surface
    return [tuple(Fraction(c) for c in p) for p in found.points()], found.rings()


def body_of(shell: Shell) -> _core.ConvexPolyhedron:
    points = [tuple(str(c) for c in point) for point in shell[0]]
    return _core.ConvexPolyhedron(_core.Polyhedron(points, shell[1]))


# Blocks: all faces perpendicular to an axis.


def axis_of(corners: list[Point]) -> int | None:
    axes = [axis for axis in range(3) if len({p[axis] for p in corners}) == 1]
    return axes[0] if axes else None


def cells_of(shell: Shell) -> list[tuple[tuple[Fraction, Fraction], ...]] | None:
    """Boxes that fill the set; None where a face is askew."""
    faces = [corners_of(shell, face) for face in shell[1]]
    if any(axis_of(corners) is None for corners in faces):
        return None
    walls = [corners for corners in faces if axis_of(corners) == 0]
    steps = [sorted({p[axis] for corners in faces for p in corners}) for axis in range(3)]
    gaps = [list(zip(row, row[1:], strict=False)) for row in steps]
    found = []
    for y, z in product(gaps[1], gaps[2]):
        at = ((y[0] + y[1]) / 2, (z[0] + z[1]) / 2)
        crossed = [w[0][0] for w in walls if odd(at, [(p[1], p[2]) for p in w])]
        for x in gaps[0]:
            if sum(wall <= x[0] for wall in crossed) % 2:
                found.append((x, y, z))
    return found


def odd(at: tuple[Fraction, Fraction], ring: Ring) -> bool:
    """Whether a half-line upwards from the point crosses the ring an odd number of times."""
    inside = False
    for (x0, y0), (x1, y1) in zip(ring, ring[1:] + ring[:1], strict=True):
        if (x0 <= at[0]) != (x1 <= at[0]):
            inside ^= (y0 + (y1 - y0) * (at[0] - x0) / (x1 - x0)) > at[1]
    return inside


def sum_of_blocks(P: Shell, Q: Shell) -> list[Shell] | None:
    """The boxes' sums on one grid, as one shell of rectangles."""
    pair = cells_of(P), cells_of(Q)
    if pair[0] is None or pair[1] is None:
        return None
    boxes = {
        tuple((a[0] + b[0], a[1] + b[1]) for a, b in zip(p, q, strict=True))
        for p, q in product(*pair)
    }
    steps = [sorted({end for box in boxes for end in box[axis]}) for axis in range(3)]
    place = [{value: k for k, value in enumerate(row)} for row in steps]
    full: set[tuple[int, ...]] = set()
    for box in boxes:
        spans = [range(place[a][box[a][0]], place[a][box[a][1]]) for a in range(3)]
        full.update(product(*spans))
    return [surface_of_cells(full, steps)]


def surface_of_cells(full: set[tuple[int, ...]], steps: list[list[Fraction]]) -> Shell:
    names: dict[tuple[int, ...], int] = {}
    faces: list[Face] = []
    for cell in sorted(full):
        for axis, side in product(range(3), (0, 1)):
            beside = list(cell)
            beside[axis] += 2 * side - 1
            if tuple(beside) in full:
                continue
            u, v = (axis + 1) % 3, (axis + 2) % 3
            corner = list(cell)
            corner[axis] += side
            ring = []
            for du, dv in ((0, 0), (1, 0), (1, 1), (0, 1)):
                at = list(corner)
                at[u] += du
                at[v] += dv
                ring.append(names.setdefault(tuple(at), len(names)))
            faces.append(ring if side else ring[::-1])
    points = [tuple(steps[axis][at[axis]] for axis in range(3)) for at in names]
    return points, faces


# Prisms: all faces perpendicular or parallel to one axis.


def base_of(shell: Shell, axis: int) -> tuple[list[Ring], Fraction, Fraction] | None:
    """The rings under a prism, and where it begins and ends."""
    low, high = (f(p[axis] for p in shell[0]) for f in (min, max))
    u, v = (axis + 1) % 3, (axis + 2) % 3
    rings = []
    for face in shell[1]:
        corners = corners_of(shell, face)
        n = normal_of(corners)
        if n[axis] == 0:
            continue
        if n[u] or n[v] or corners[0][axis] not in (low, high):
            return None
        if corners[0][axis] == high:
            rings.append([(p[u], p[v]) for p in corners])
    return rings, low, high


def prism(ring: Ring, low: Fraction, high: Fraction, axis: int) -> Shell:
    """A convex one over a ring that runs counter-clockwise."""
    n = len(ring)
    points = []
    for level in (low, high):
        for p in ring:
            at: list[Any] = [None, None, None]
            at[axis], at[(axis + 1) % 3], at[(axis + 2) % 3] = level, *p
            points.append(tuple(at))
    walls = [[k, (k + 1) % n, n + (k + 1) % n, n + k] for k in range(n)]
    return points, [list(range(n))[::-1], list(range(n, 2 * n)), *walls]


def sum_of_prisms(P: Shell, Q: Shell) -> list[Shell] | None:
    """The sum of the bases in the plane, cut into trapezoids: a prism over each."""
    for axis in range(3):
        pair = base_of(P, axis), base_of(Q, axis)
        if pair[0] is not None and pair[1] is not None:
            (first, a, b), (second, c, d) = pair
            base = sum_of(set_of_rings(first), set_of_rings(second))
            return [prism(ring, a + c, b + d, axis) for ring in trapezoids(rings_of(base))]
    return None
