"""Triangles of a closed walk that does not cross itself, by clipping ears. Exact, in integers.

The walk may pass a vertex or a diagonal twice (rings that touch, bridges). A corner is an ear iff
it turns left, its diagonal leaves both ends into the interior, and the triangle holds no other
vertex. The rest's boundary is one walk, so anything that enters a triangle has a non-convex vertex
there: only such vertices are tested. Cost: quadratic at worst.
"""

from __future__ import annotations

from .bridges import between, minus
from .exact import InputError, Vector, cross


def triangles(walk: list[Vector]) -> list[list[Vector]]:
    """Cut the inside of a walk into counter-clockwise triangles with disjoint interiors."""
    n = len(walk)
    after = [*range(1, n), 0]
    before = [n - 1, *range(n - 1)]

    def turn(i: int) -> int:
        return cross(minus(walk[i], walk[before[i]]), minus(walk[after[i]], walk[i]))

    blunt = {i for i in range(n) if turn(i) <= 0}
    found: list[list[Vector]] = []
    at, left, tried = 0, n, 0
    while left > 3:
        if is_ear(walk, before, after, at, blunt):
            found.append([walk[before[at]], walk[at], walk[after[at]]])
            a, c = before[at], after[at]
            after[a], before[c] = c, a
            blunt.discard(at)
            for i in (a, c):
                (blunt.discard if turn(i) > 0 else blunt.add)(i)
            left -= 1
            tried = 0
            # Skipping a vertex keeps the triangles from forming a fan of slivers.
            at = after[c]
        else:
            at = after[at]
            tried += 1
            if tried > left:
                raise InputError(f"no ear at {walk[at]}: rings cross or overlap")
    if turn(at) <= 0:
        raise InputError(f"no ear at {walk[at]}: rings cross or overlap")
    found.append([walk[before[at]], walk[at], walk[after[at]]])
    return found


def is_ear(
    walk: list[Vector], before: list[int], after: list[int], at: int, blunt: set[int]
) -> bool:
    if at in blunt:
        return False
    a, b, c = walk[before[at]], walk[at], walk[after[at]]
    if a == c:
        return False
    ac = minus(c, a)
    if not between(minus(b, a), ac, minus(walk[before[before[at]]], a)):
        return False
    ca = (-ac[0], -ac[1])
    if not between(minus(walk[after[after[at]]], c), ca, minus(b, c)):
        return False
    left, right = min(a[0], b[0], c[0]), max(a[0], b[0], c[0])
    low, high = min(a[1], b[1], c[1]), max(a[1], b[1], c[1])
    ab, bc = minus(b, a), minus(c, b)
    for i in blunt:
        p = walk[i]
        if left <= p[0] <= right and low <= p[1] <= high and p not in (a, b, c):
            if (
                cross(ab, minus(p, a)) >= 0
                and cross(bc, minus(p, b)) >= 0
                and cross(ca, minus(p, c)) >= 0
            ):
                return False
    return True
