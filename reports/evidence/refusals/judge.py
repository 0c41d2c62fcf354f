"""Judge repairs in the plane: compare the set described by written rings with the repaired set
everywhere, in Fractions, by vertical strips, without the program's help."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from itertools import combinations, pairwise

Point = tuple[Fraction, Fraction]
Ring = Sequence[Point]
Edge = tuple[Point, Point, tuple[int, int, int], int]  # ends by x, ring it is of, way
INSIDE: dict[str, Callable[[int], bool]] = {
    "nonzero": lambda number: number != 0,
    "evenodd": lambda number: number % 2 == 1,
    "positive": lambda number: number > 0,
}
WRITTEN, REPAIRED = 0, 1


def difference(
    written: Sequence[Sequence[Ring]], repaired: Sequence[Sequence[Ring]], rule: str
) -> str:
    """Return a point at which the union of the polygons as written (what an outer ring encloses by
    the rule, less what its holes enclose) and the repaired set (even-odd) differ; nothing if they
    differ nowhere but on lines."""
    edges = [*_edges(written, WRITTEN), *_edges(repaired, REPAIRED)]
    for left, right in pairwise(sorted(_stops(edges))):
        middle = (left + right) / 2
        crossed = sorted(
            (_height(edge, middle), edge[2], edge[3])
            for edge in edges
            if edge[0][0] <= left and right <= edge[1][0]
        )
        winding: dict[tuple[int, int, int], int] = {}
        for (low, name, way), (high, *_) in pairwise(crossed):
            winding[name] = winding.get(name, 0) + way
            if low < high and _is_in(winding, written, rule) != _is_in_repaired(winding):
                return f"({middle}, {(low + high) / 2})"
    return ""


def _edges(polygons: Sequence[Sequence[Ring]], side: int) -> Iterator[Edge]:
    for p, rings in enumerate(polygons):
        for r, ring in enumerate(rings):
            for a, b in zip(ring, [*ring[1:], *ring[:1]], strict=True):
                if a[0] != b[0]:
                    first, last = sorted((a, b))
                    yield first, last, (side, p, r), 1 if a[0] < b[0] else -1


def _stops(edges: list[Edge]) -> set[Fraction]:
    """Where edges begin, end and cross."""
    stops = {point[0] for first, last, *_ in edges for point in (first, last)}
    for (a, b, *_), (c, d, *_) in combinations(edges, 2):
        if max(a[0], c[0]) >= min(b[0], d[0]):
            continue
        slope = (b[1] - a[1]) / (b[0] - a[0])
        other = (d[1] - c[1]) / (d[0] - c[0])
        if slope == other:
            continue
        x = (c[1] - other * c[0] - a[1] + slope * a[0]) / (slope - other)
        if max(a[0], c[0]) < x < min(b[0], d[0]):
            stops.add(x)
    return stops


def _height(edge: Edge, x: Fraction) -> Fraction:
    (ax, ay), (bx, by), *_ = edge
    return ay + (by - ay) * (x - ax) / (bx - ax)


def doubled_area(ring: Ring) -> Fraction:
    ends = zip(ring, [*ring[1:], *ring[:1]], strict=True)
    return sum((ax * by - ay * bx for (ax, ay), (bx, by) in ends), Fraction(0))


def _is_in(
    winding: dict[tuple[int, int, int], int], written: Sequence[Sequence[Ring]], rule: str
) -> bool:
    def encloses(p: int, r: int) -> bool:
        number = winding.get((WRITTEN, p, r), 0)
        return number != 0 and INSIDE[rule](-number if doubled_area(written[p][r]) < 0 else number)

    return any(
        encloses(p, 0) and not any(encloses(p, r) for r in range(1, len(rings)))
        for p, rings in enumerate(written)
    )


def _is_in_repaired(winding: dict[tuple[int, int, int], int]) -> bool:
    return sum(number for (side, *_), number in winding.items() if side == REPAIRED) % 2 == 1


def welded(polygons: Sequence[Sequence[Ring]], distance: Fraction) -> list[list[Ring]]:
    """Move vertices as welding once moves them, by comparing all with all."""
    kept: list[Point] = []
    for x, y in (point for rings in polygons for ring in rings for point in ring):
        if all((x - a) ** 2 + (y - b) ** 2 >= distance**2 for a, b in kept):
            kept.append((x, y))

    def moved(point: Point) -> Point:
        apart = [((point[0] - a) ** 2 + (point[1] - b) ** 2, k) for k, (a, b) in enumerate(kept)]
        nearest, k = min(apart)
        return kept[k] if nearest < distance**2 else point

    return [[[moved(point) for point in ring] for ring in rings] for rings in polygons]


def untold(
    written: Sequence[Sequence[Ring]], repaired: Sequence[Sequence[Ring]], named: set[int]
) -> list[int]:
    """Return rings, counted through all polygons, without a change and without an equal ring,
    from any first point, after the repair."""
    kept = {_from_least(ring) for rings in repaired for ring in rings}
    every = [ring for rings in written for ring in rings]
    return [k for k, ring in enumerate(every) if k not in named and _from_least(ring) not in kept]


def _from_least(ring: Ring) -> tuple[Point, ...]:
    first = ring.index(min(ring))
    return (*ring[first:], *ring[:first])
