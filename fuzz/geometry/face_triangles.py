"""A planar face cut into triangles, exactly."""

from __future__ import annotations

from collections.abc import Sequence

from minkref.fuzz.geometry.plane import turn
from minkref.fuzz.geometry.space import Whole, area_vector, flattened, longest_axis, normal

Corner = tuple[int, int]
Triple = tuple[int, int, int]


def face_triangles(ring: Sequence[Whole]) -> list[Triple]:
    """Returns positions in `ring` of triangles that cover the face once, without triangles of zero
    area. For a ring that is not simple some triangles overlap, but with their orientation they
    bound the same ring. O(n^3)."""
    if len(ring) == 3:
        triples = [(0, 1, 2)]
    else:
        vector = area_vector(ring)
        if vector == (0, 0, 0):
            triples = _fan(len(ring))
        else:
            axis = longest_axis(vector)
            corners = [flattened(point, axis) for point in ring]
            if vector[axis] < 0:
                corners = [(y, x) for x, y in corners]
            triples = ring_triangles(corners)
    return [(i, j, k) for i, j, k in triples if normal(ring[i], ring[j], ring[k]) != (0, 0, 0)]


def ring_triangles(corners: Sequence[Corner]) -> list[Triple]:
    """Cuts a counter-clockwise ring into triangles, some perhaps collinear. The ring may pass a
    point twice, as a ring with bridges to its holes does. Counter-clockwise triangles that bound
    the ring together cover it once, so only their turns matter."""
    count = len(corners)
    fan = _fan(count)
    if all(turn(corners[i], corners[j], corners[k]) >= 0 for i, j, k in fan):
        return fan
    left = list(range(count))
    triples: list[Triple] = []
    while len(left) > 3:
        place = _ear(corners, left)
        if place is None:
            return triples + [(left[0], left[k], left[k + 1]) for k in range(1, len(left) - 1)]
        triples.append((left[place - 1], left[place], left[(place + 1) % len(left)]))
        del left[place]
    return [*triples, (left[0], left[1], left[2])]


def _fan(count: int) -> list[Triple]:
    return [(0, k, k + 1) for k in range(1, count - 1)]


def _ear(corners: Sequence[Corner], left: list[int]) -> int | None:
    """The place of a corner to cut off: a true ear, or else one whose triangle has no area."""
    straight: int | None = None
    for place in range(len(left)):
        a, b, c = (corners[left[(place + step) % len(left)]] for step in (-1, 0, 1))
        side = turn(a, b, c)
        if side > 0 and not _blocked(corners, left, place, (a, b, c)):
            return place
        if side == 0 and straight is None:
            straight = place
    return straight


def _blocked(
    corners: Sequence[Corner], left: list[int], place: int, ear: tuple[Corner, Corner, Corner]
) -> bool:
    """Whether some other corner lies within the closed triangle; for a corner at the triangle's
    corner, whether the ring enters the triangle there."""
    a, b, c = ear
    count = len(left)
    mine = {(place - 1) % count, place, (place + 1) % count}
    for other in range(count):
        if other in mine:
            continue
        point = corners[left[other]]
        if turn(a, b, point) < 0 or turn(b, c, point) < 0 or turn(c, a, point) < 0:
            continue
        if point not in ear:
            return True
        at = ear.index(point)
        before, after = ear[at - 1], ear[(at + 1) % 3]
        for step in (-1, 1):
            far = corners[left[(other + step) % count]]
            if turn(point, after, far) > 0 and turn(point, far, before) > 0:
                return True
    return False
