"""Small simple rings on an integer grid, in plain integer arithmetic: the generator's own
predicates."""

from __future__ import annotations

import random

from minkref.fuzz.geometry.plane import doubled_area, in_box, segments_meet, turn

Node = tuple[int, int]
Ring = list[Node]


def counter_clockwise(ring: Ring) -> Ring:
    return ring if doubled_area(ring) > 0 else ring[::-1]


def segments_cross(a: Node, b: Node, c: Node, d: Node) -> bool:
    """The segments cross properly, or overlap along more than a point."""
    if max(a[0], b[0]) < min(c[0], d[0]) or max(c[0], d[0]) < min(a[0], b[0]):
        return False
    if max(a[1], b[1]) < min(c[1], d[1]) or max(c[1], d[1]) < min(a[1], b[1]):
        return False
    t1, t2, t3, t4 = turn(a, b, c), turn(a, b, d), turn(c, d, a), turn(c, d, b)
    if t1 == 0 and t2 == 0:
        (lo1, hi1), (lo2, hi2) = sorted((a, b)), sorted((c, d))
        return max(lo1, lo2) < min(hi1, hi2)
    return t1 * t2 < 0 and t3 * t4 < 0


def is_simple(ring: Ring) -> bool:
    """Distinct vertices, non-adjacent edges apart, adjacent edges meeting in their vertex only."""
    return _is_open(ring) and _meeting_edges(ring) is None


def scattered(dice: random.Random, vertices: int, width: int, height: int) -> Ring:
    """Random points of the grid [0, width] x [0, height], each once."""
    ring: Ring = []
    seen: set[Node] = set()
    for _ in range(vertices):
        node = (dice.randint(0, width), dice.randint(0, height))
        if node not in seen:
            seen.add(node)
            ring.append(node)
    return ring


def untangled(points: Ring) -> Ring | None:
    """Joins the points to a simple ring, reversing the stretch between two meeting edges until no
    edges meet (2-opt); None on failure."""
    ring = list(points)
    for _ in range(4 * len(ring)):
        meeting = _meeting_edges(ring)
        if meeting is None:
            return ring if _is_open(ring) else None
        i, j = meeting
        ring[i + 1 : j + 1] = ring[i + 1 : j + 1][::-1]
    return ring if is_simple(ring) else None


def _meeting_edges(ring: Ring) -> tuple[int, int] | None:
    """The first two edges that share no vertex and meet."""
    n = len(ring)
    for i in range(n - 2):
        a, b = ring[i], ring[i + 1]
        for j in range(i + 2, n if i else n - 1):
            if segments_meet(a, b, ring[j], ring[(j + 1) % n]):
                return (i, j)
    return None


def _is_open(ring: Ring) -> bool:
    """Three distinct vertices or more that bound an area; no edge folds back on the one before."""
    n = len(ring)
    if n < 3 or len(set(ring)) != n or doubled_area(ring) == 0:
        return False
    for i in range(n):
        a, b, c = ring[i - 2], ring[i - 1], ring[i]
        if turn(a, b, c) == 0 and (in_box(a, b, c) or in_box(b, c, a)):
            return False
    return True


def on_grid_cells(dice: random.Random, side: int, most_vertices: int) -> Ring | None:
    """The outline of a few random grid cells, its corners cut or sheared on the grid; None if the
    outline is not one simple ring or has too many vertices."""
    start = (dice.randrange(side), dice.randrange(side))
    cells = {start}
    stretch = max(1, side // 4)
    for _ in range(dice.randint(1, 6)):
        x, y = dice.choice(sorted(cells))
        dx, dy = dice.choice(((1, 0), (-1, 0), (0, 1), (0, -1)))
        for step in range(1, dice.randint(1, stretch) + 1):
            cell = (x + step * dx, y + step * dy)
            if 0 <= cell[0] < side and 0 <= cell[1] < side:
                cells.add(cell)
    ring = _outline(cells)
    if ring is None:
        return None
    if dice.random() < 0.6:
        ring = [_moved(dice, node, side) if dice.random() < 0.3 else node for node in ring]
    return ring if len(ring) <= most_vertices and is_simple(ring) else None


def _moved(dice: random.Random, node: Node, side: int) -> Node:
    x = min(side, max(0, node[0] + dice.randint(-1, 1)))
    y = min(side, max(0, node[1] + dice.randint(-1, 1)))
    return (x, y)


def _outline(cells: set[Node]) -> Ring | None:
    """Returns the corners around a set of cells; None if the boundary is not one ring."""
    following: dict[Node, Node] = {}
    for x, y in sorted(cells):
        sides = (
            ((x, y - 1), (x, y), (x + 1, y)),
            ((x + 1, y), (x + 1, y), (x + 1, y + 1)),
            ((x, y + 1), (x + 1, y + 1), (x, y + 1)),
            ((x - 1, y), (x, y + 1), (x, y)),
        )
        for neighbour, a, b in sides:
            if neighbour not in cells:
                if a in following:
                    return None
                following[a] = b
    first = min(following)
    ring = [first]
    node = following[first]
    while node != first:
        ring.append(node)
        node = following[node]
    if len(ring) != len(following):
        return None
    n = len(ring)
    return [ring[i] for i in range(n) if turn(ring[i - 1], ring[i], ring[(i + 1) % n]) != 0]


def inside(inner: Ring, outer: Ring) -> bool:
    """Whether every vertex of `inner` lies in the closed region of `outer`, and at least one off
    its rim."""
    deepest = 0
    for node in inner:
        place = _place(node, outer)
        if place < 0:
            return False
        deepest = max(deepest, place)
    return deepest > 0


def _place(p: Node, ring: Ring) -> int:
    """1 inside, 0 on the ring, -1 outside."""
    within = False
    x, y = p
    a = ring[-1]
    for b in ring:
        side = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])
        if side == 0 and in_box(a, b, p):
            return 0
        if (a[1] > y) != (b[1] > y) and (side > 0) == (b[1] > a[1]):
            within = not within
        a = b
    return 1 if within else -1


def rings_meet(first: Ring, second: Ring) -> bool:
    """The two rings share a point."""
    return any(
        segments_meet(a, b, c, d)
        for a, b in zip(first, first[1:] + first[:1], strict=True)
        for c, d in zip(second, second[1:] + second[:1], strict=True)
    )


def rings_cross(first: Ring, second: Ring) -> bool:
    """Some edges of the two rings cross properly or overlap; touching at points is allowed."""
    return any(
        segments_cross(a, b, c, d)
        for a, b in zip(first, first[1:] + first[:1], strict=True)
        for c, d in zip(second, second[1:] + second[:1], strict=True)
    )
