"""Sums of bodies with faces perpendicular to axes, and of prisms."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise, product
from typing import Any

from plane_sets import Ring, rings_of, set_of_rings, sum_of, trapezoids
from space_sets import Face, Point, Shell, corners_of, normal_of


def axis_of(corners: list[Point]) -> int | None:
    axes = [axis for axis in range(3) if len({p[axis] for p in corners}) == 1]
    return axes[0] if axes else None


def cells_of(shell: Shell) -> list[tuple[tuple[Fraction, Fraction], ...]] | None:
    """Boxes that fill the set; None if a face is askew."""
    faces = [corners_of(shell, face) for face in shell[1]]
    if any(axis_of(corners) is None for corners in faces):
        return None
    walls = [corners for corners in faces if axis_of(corners) == 0]
    steps = [sorted({p[axis] for corners in faces for p in corners}) for axis in range(3)]
    gaps = [list(pairwise(row)) for row in steps]
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
    """The sums of all boxes on a common grid, as a shell of rectangles."""
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


def base_of(shell: Shell, axis: int) -> tuple[list[Ring], Fraction, Fraction] | None:
    """The rings under a prism, with the prism's lowest and highest coordinate."""
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
    """A convex prism over a counter-clockwise ring."""
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
