"""A face cut into triangles where no plane has all its vertices."""

from __future__ import annotations

from collections.abc import Sequence

IntegerVector = tuple[int, int, int]
Flat = tuple[int, int]


def ears(
    points: Sequence[IntegerVector], face: Sequence[int], normal: IntegerVector
) -> list[list[int]] | None:
    """Cut off the first ear again and again, seen along the longest axis of the normal; None if the
    projected ring crosses itself. Exact. O(n^3) at worst, for faces of few
    vertices."""
    axis = max(range(3), key=lambda k: abs(normal[k]))
    i, j = (axis + 1) % 3, (axis + 2) % 3
    if normal[axis] < 0:
        i, j = j, i
    flat = {v: (points[v][i], points[v][j]) for v in face}
    left = list(face)
    found: list[list[int]] = []
    while len(left) > 3:
        at = next((k for k in range(len(left)) if _is_ear(flat, left, k)), None)
        if at is None:
            return None
        found.append([left[at - 1], left[at], left[(at + 1) % len(left)]])
        del left[at]
    if _turn(*(flat[v] for v in left)) <= 0:
        return None
    return [*found, left]


def _turn(a: Flat, b: Flat, c: Flat) -> int:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _is_ear(flat: dict[int, Flat], ring: list[int], k: int) -> bool:
    corners = ring[k - 1], ring[k], ring[(k + 1) % len(ring)]
    a, b, c = (flat[v] for v in corners)
    if _turn(a, b, c) <= 0:
        return False
    return not any(
        _turn(a, b, p) >= 0 and _turn(b, c, p) >= 0 and _turn(c, a, p) >= 0
        for v in ring
        if v not in corners and (p := flat[v]) not in (a, b, c)
    )
