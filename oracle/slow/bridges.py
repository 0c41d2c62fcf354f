"""A component with holes as one closed walk: a bridge joins each hole to the outer walk.

A bridge is a diagonal that the walk passes in both directions. Coordinates are integers.
"""

from __future__ import annotations

from .exact import InputError, Vector, cross
from .walks import Component


def between(low: Vector, way: Vector, high: Vector) -> bool:
    """Tell whether `way` lies strictly inside the counter-clockwise turn from `low` to `high` (a
    full turn for equal directions)."""
    if cross(low, high) > 0:
        return cross(low, way) > 0 and cross(way, high) > 0
    if cross(low, high) == 0 and low[0] * high[0] + low[1] * high[1] < 0:
        return cross(low, way) > 0
    same = cross(low, way) == 0 and low[0] * way[0] + low[1] * way[1] > 0
    last = cross(high, way) == 0 and high[0] * way[0] + high[1] * way[1] > 0
    return not same and not last and not (cross(high, way) > 0 and cross(way, low) > 0)


def minus(a: Vector, b: Vector) -> Vector:
    return a[0] - b[0], a[1] - b[1]


def wedge_holds(walk: list[Vector], at: int, target: Vector) -> bool:
    """Tell whether walk[at] sees the target inside its wedge of the interior."""
    here = walk[at]
    after = minus(walk[(at + 1) % len(walk)], here)
    before = minus(walk[at - 1], here)
    return between(after, minus(target, here), before)


def blocked(walk: list[Vector], a: Vector, b: Vector) -> bool:
    """Tell whether an edge of the walk meets the segment from a to b anywhere but at a."""
    left, right = min(a[0], b[0]), max(a[0], b[0])
    low, high = min(a[1], b[1]), max(a[1], b[1])
    ab = minus(b, a)
    c = walk[-1]
    for d in walk:
        if (
            (c[0] >= left or d[0] >= left)
            and (c[0] <= right or d[0] <= right)
            and (c[1] >= low or d[1] >= low)
            and (c[1] <= high or d[1] <= high)
        ):
            side_c, side_d = cross(ab, minus(c, a)), cross(ab, minus(d, a))
            if a in (c, d):
                # The edge starts at a and meets the rest only along the same ray.
                other = d if c == a else c
                way = minus(other, a)
                if cross(ab, way) == 0 and ab[0] * way[0] + ab[1] * way[1] > 0:
                    return True
            elif side_c * side_d <= 0:
                cd = minus(d, c)
                if cross(cd, minus(a, c)) * cross(cd, minus(b, c)) <= 0:
                    return True
        c = d
    return False


def joined(part: Component) -> list[Vector]:
    """Return the closed walk. Takes holes from left to right: among the vertices before a hole's
    least vertex, in lexicographic order, the hole sees a vertex of the outer walk, with no later
    hole between."""
    rings = hole_walks(part)
    walk = rings[0]
    for hole in sorted(rings[1:], key=min):
        first = min(hole)
        before = [i for i, point in enumerate(walk) if point < first]
        before.sort(key=lambda i: (walk[i][0] - first[0]) ** 2 + (walk[i][1] - first[1]) ** 2)
        starts = [i for i, point in enumerate(hole) if point == first]
        bridge = next(
            (
                (i, j)
                for i in before
                if wedge_holds(walk, i, first)
                for j in starts
                if wedge_holds(hole, j, walk[i]) and not blocked(walk, walk[i], first)
            ),
            None,
        )
        if bridge is None:
            raise InputError(f"no bridge to the hole at {first}: rings cross or overlap")
        i, j = bridge
        walk = [*walk[: i + 1], *hole[j:], *hole[:j], hole[j], *walk[i:]]
    return walk


def hole_walks(part: Component) -> list[list[Vector]]:
    """Return a component's walks, the outer walk first, with touching rings inserted: rings of one
    component that share a vertex become a single walk."""
    walks: list[list[Vector]] = []
    for ring in [part.outer, *part.holes]:
        walks.append([edge.start for edge in ring])
    merged = [walks[0]]
    rest = walks[1:]
    while rest:
        touching = [hole for hole in rest if set(hole) & set(merged[-1])]
        if not touching:
            merged.append(rest.pop(0))
            continue
        for hole in touching:
            rest.remove(hole)
            merged[-1] = spliced(merged[-1], hole)
    return merged


def spliced(walk: list[Vector], hole: list[Vector]) -> list[Vector]:
    """Insert a touching hole into the walk, from the wedge around the hole."""
    for at, point in enumerate(walk):
        for j, other in enumerate(hole):
            if point == other and wedge_holds(walk, at, hole[(j + 1) % len(hole)]):
                return [*walk[: at + 1], *hole[j + 1 :], *hole[: j + 1], *walk[at + 1 :]]
    raise InputError("a hole touches from outside: rings cross or overlap")
