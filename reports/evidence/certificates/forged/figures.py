"""Points, rings, components, holes and digests of a step `eq`, found anew from cells: for
lies whose figures all agree. From docs/certificates.md; exact."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from minkref.reports.evidence.certificates.forged.ideas import Unfit, sha, tight
from minkref.reports.evidence.certificates.forged.raw import Json

Point = tuple[Fraction, Fraction]
Line = tuple[Point, Point]  # a point and a direction
Edge = tuple[int, int]


def vertices(operand: Json, axes: Sequence[str] = ("1", "1")) -> list[Point]:
    a, b = map(Fraction, axes)
    return [
        (a * Fraction(x), b * Fraction(y))
        for polygon in operand["polygons"]
        for ring in [polygon["outer"], *(polygon.get("holes") or [])]
        for x, y in ring
    ]


def elements(step: Json, case: Json, axes: Sequence[str], s: Fraction) -> list[Json]:
    """All elements of a step at the scale s."""
    P = [(s * x, s * y) for x, y in vertices(case["P"], axes)]
    Q = vertices(case["Q"])
    x0, y0, x1, y1 = map(Fraction, step["box"])
    up, right = (Fraction(0), Fraction(1)), (Fraction(1), Fraction(0))
    found: list[Json] = [((x0, y0), up), ((x0, y0), right), ((x1, y1), up), ((x1, y1), right)]
    for name, *indices in step["elements"]:
        if name in "PQ":
            i, k, j = indices
            own, far = (P, Q) if name == "P" else (Q, P)
            direction = own[k][0] - own[i][0], own[k][1] - own[i][1]
            found.append(((own[i][0] + far[j][0], own[i][1] + far[j][1]), direction))
        elif name == "meet":
            found.append(meet(found[indices[0]], found[indices[1]]))
        else:
            found.append((found[indices[0]], up))
    return found


def meet(one: Line, other: Line) -> Point:
    (a, v), (b, w) = one, other
    along = cross(v, w)
    t = cross((b[0] - a[0], b[1] - a[1]), w) / along
    return a[0] + t * v[0], a[1] + t * v[1]


def cross(v: Point, w: Point) -> Fraction:
    return v[0] * w[1] - v[1] * w[0]


def area(ring: Sequence[Point]) -> Fraction:
    """Twice the signed area."""
    return sum((cross(ring[i - 1], ring[i]) for i in range(len(ring))), Fraction(0))


@dataclass
class Figure:
    """The lie's polygons, with indices, and the counts and digest."""

    polygons: list[list[list[int]]]
    components: int
    holes: int
    form: Json
    area: Fraction  # twice

    @property
    def digest(self) -> str:
        return sha(tight(self.form))


def told(step: Json, case: Json, axes: Sequence[str], scale: str) -> Figure:
    """The figure that the cells of a step `eq` have if their proofs are believed. Raises Unfit
    where the cells bound no rings."""
    points = elements(step, case, axes, Fraction(scale))
    covered = [proof[0] == "cov" for proof in step["proofs"]]
    cells = step["cells"]
    owner = {edge: c for c, cell in enumerate(cells) for edge in edges(cell)}
    rim = {edge for edge, c in owner.items()
           if covered[c] and not covered[owner.get(edge[::-1], c)]}  # fmt: skip
    parts = classes(cells, owner, covered, True)
    gaps = classes(cells, owner, covered, False)
    outside = {gaps[c] for edge, c in owner.items() if edge[::-1] not in owner and not covered[c]}
    rings = walks(cells, owner, rim)
    of: dict[int, list[list[int]]] = {}
    for ring in rings:
        of.setdefault(parts[owner[ring[0], ring[1]]], []).append(ring)
    polygons = []
    for own in of.values():
        ordered = sorted(own, key=lambda ring: area([points[i] for i in ring]) < 0)
        polygons.append(ordered)
    whole = sum((area([points[i] for i in ring]) for ring in rings), Fraction(0))
    form = canonical([[[points[i] for i in ring] for ring in rings] for rings in polygons])
    return Figure(
        polygons, len(set(parts.values())), len(set(gaps.values()) - outside), form, whole
    )


def edges(ring: Sequence[int]) -> list[Edge]:
    return [(ring[i - 1], ring[i]) for i in range(len(ring))]


def classes(
    cells: Json, owner: dict[Edge, int], covered: list[bool], which: bool
) -> dict[int, int]:
    """For each cell that is covered, or not, the least cell of the class."""
    root = {c: c for c in range(len(cells)) if covered[c] is which}

    def top(c: int) -> int:
        while root[c] != c:
            c = root[c]
        return c

    for (a, b), c in owner.items():
        other = owner.get((b, a))
        if c in root and other in root:
            low, high = sorted((top(c), top(other)))
            root[high] = low
    return {c: top(c) for c in root}


def walks(cells: Json, owner: dict[Edge, int], rim: set[Edge]) -> list[list[int]]:
    """Rings of the boundary edges: each walk turns through the wedge of covered cells."""
    rest, rings = set(rim), []
    while rest:
        edge = min(rest)
        walk: list[int] = []
        while edge in rest:
            rest.remove(edge)
            if edge[0] in walk:  # split where a walk comes again
                first = walk.index(edge[0])
                rings.append(walk[first:])
                walk = walk[:first]
            walk.append(edge[0])
            edge = onwards(cells, owner, rim, edge)
        if edge[0] != walk[0]:
            first = walk.index(edge[0])
            rings.append(walk[:first])
            walk = walk[first:]
        rings.append(walk)
    return rings


def onwards(cells: Json, owner: dict[Edge, int], rim: set[Edge], edge: Edge) -> Edge:
    for _ in range(len(owner)):
        cell = cells[owner[edge]]
        after = cell[(cell.index(edge[1]) + 1) % len(cell)]
        edge = edge[1], after
        if edge in rim:
            return edge
        edge = edge[::-1]
        if edge not in owner:
            raise Unfit
    raise Unfit


def canonical(polygons: Sequence[Sequence[Sequence[Point]]]) -> Json:
    """The canonical form of these polygons, as lists of texts."""
    bodies = []
    for outer, *holes in polygons:
        bodies.append((least(outer), sorted(map(least, holes))))
    return {"polygons": [{"holes": [texts(hole) for hole in holes], "outer": texts(outer)}
                         for outer, holes in sorted(bodies)]}  # fmt: skip


def least(ring: Sequence[Point]) -> list[Point]:
    """Without straight vertices, from the least vertex on."""
    n = len(ring)
    kept = [
        ring[i] for i in range(n)
        if cross(minus(ring[i], ring[i - 1]), minus(ring[(i + 1) % n], ring[i]))
    ]  # fmt: skip
    if not kept:
        raise Unfit
    start = kept.index(min(kept))
    return kept[start:] + kept[:start]


def minus(a: Point, b: Point) -> Point:
    return a[0] - b[0], a[1] - b[1]


def texts(ring: Sequence[Point]) -> list[list[str]]:
    return [[str(x), str(y)] for x, y in ring]
