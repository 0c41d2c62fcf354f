"""Sums with a disc against CGAL's exact offset: curve by curve, components and holes.

`python -m minkref.fuzz.judges.disc.offset_comparison SEED COUNT` compares sets of the cells of a
grid at radii at which much happens, prints the table as JSON and exits with 1 if there is a
difference."""

from __future__ import annotations

import json
import math
import random
import sys
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.fuzz.judges.disc.offset_cgal import (
    OffsetAnswer,
    OffsetJudge,
    Ring,
    Spot,
    is_in,
    spots_of_arc,
)

SECONDS = 60.0  # per offset by CGAL
LARGEST = 5  # cells of a grid along an axis
CRITICAL = [Fraction(k, 4) for k in (1, 2, 3, 4, 5, 6, 8, 10)]


@dataclass
class Table:
    """Counts and differences of a comparison."""

    counts: Counter[str] = field(default_factory=Counter)
    unanswered: list[str] = field(default_factory=list)
    differences: list[str] = field(default_factory=list)
    refuted: list[str] = field(default_factory=list)  # answers of CGAL, refuted by a point


def grid_set(dice: random.Random) -> _core.PolygonSet:
    """Some grid cells, each whole or halved by a diagonal: sets that touch at points, straight and
    facing edges, holes."""
    size = dice.randint(2, LARGEST)
    outside = frame = _polygon([(-1, -1), (size + 1, -1), (size + 1, size + 1), (-1, size + 1)])
    for x in range(size):
        for y in range(size):
            corners = [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)]
            if dice.random() < 0.4:
                if dice.random() < 0.4:
                    corners.pop(dice.randrange(4))
                outside = _core.minus(outside, _polygon(corners))
    return _core.minus(frame, outside)


def _polygon(corners: list[tuple[int, int]]) -> _core.PolygonSet:
    ring = [[str(x), str(y)] for x, y in corners]
    return _core.PolygonSet.from_json(json.dumps({"polygons": [{"holes": [], "outer": ring}]}))


def compare(seed: int, numbers: range, table: Table) -> None:
    """Grid sets by number. The same numbers give the same sets and radii."""
    with OffsetJudge(SECONDS) as judge:
        for number in numbers:
            dice = random.Random(f"minkref offsets {seed}:{number}")
            P = grid_set(dice)
            critical = dice.random() < 0.7
            radius = dice.choice(CRITICAL) if critical else Fraction(dice.randint(1, 2999), 1000)
            if not P.is_empty:
                table.counts["at radii of events" if critical else "at other radii"] += 1
                compare_one(judge, f"grid {seed}:{number}", P, radius, table)


def compare_one(
    judge: OffsetJudge, name: str, P: _core.PolygonSet, radius: Fraction, table: Table
) -> tuple[float, float | None]:
    """The seconds of both."""
    where = f"{name}, radius {radius}"
    answer = judge.offset(json.loads(P.canonical_json()), radius)
    try:
        found = _core.offset(P, str(radius**2))
    except RuntimeError as error:  # our fault: the set is valid
        table.differences.append(f"{where}: {error}")
        return 0.0, answer.seconds
    if answer.components is None:
        table.unanswered.append(f"{where}: {answer.why}")
        return found.seconds, None
    table.counts["compared"] += 1
    table.counts["holes"] += found.holes
    table.counts["curves"] += found.curves
    document = json.loads(found.canonical_json())
    if document["squared_radius"] != str(radius**2):
        table.differences.append(f"{where}: the sum is one of another radius")
    elif answer.components != _components(document) or answer.holes != found.holes:
        witness = _witness(P, radius, found, answer)
        if witness is None:
            told = f"{found.holes} holes, and CGAL has {answer.holes}"
            table.differences.append(f"{where}: {told}: {P.canonical_json()}")
        else:
            table.refuted.append(f"{where}: {witness}: {P.canonical_json()}")
    return found.seconds, answer.seconds


def _witness(
    P: _core.PolygonSet, radius: Fraction, found: _core.Offset, answer: OffsetAnswer
) -> str | None:
    """Returns a point beside a curve of either region that CGAL puts on the wrong side, by its
    exact distance from P; None without such a point, or if our region puts some point on the wrong
    side."""
    rings = [ring for rings in found.drawn_rings() for ring in rings]
    ours = [[spot for piece in ring for spot in _spots(piece)] for ring in rings]
    edges = _edges(P)
    wrong = None
    near = float(radius) / 100
    for path in (*ours, *answer.paths):
        for a, b in zip(path, [*path[1:], path[0]], strict=True):
            middle = ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)
            length = math.dist(a, b) or 1.0
            across = ((b[1] - a[1]) / length, (a[0] - b[0]) / length)
            for side in (-near, near):
                x, y = (round(middle[k] + side * across[k], 4) for k in (0, 1))
                truth = _squared_distance((Fraction(str(x)), Fraction(str(y))), edges) <= radius**2
                if truth != _is_inside((x, y), ours):
                    return None
                if truth != _is_inside((x, y), answer.paths):
                    wrong = f"({x}, {y}) is {'' if truth else 'not '}in the sum"
    return wrong


def _is_inside(spot: Spot, rings: Sequence[Sequence[Spot]]) -> bool:
    return sum(is_in(spot, ring) for ring in rings) % 2 == 1


def _spots(piece: tuple[str, float, float, float, float, float, float, float]) -> list[Spot]:
    """Some points on a piece, without its end."""
    kind, x0, y0, x1, y1, x, y, _ = piece
    if kind == "line":
        return [(x0, y0)]
    return spots_of_arc((x0, y0), (x1, y1), (x, y))


Exact = tuple[Fraction, Fraction]


def _edges(P: _core.PolygonSet) -> list[tuple[Exact, Exact]]:
    rings = [[(Fraction(x), Fraction(y)) for x, y in ring] for rings in P.rings() for ring in rings]
    return [edge for ring in rings for edge in zip(ring, [*ring[1:], ring[0]], strict=True)]


def _squared_distance(x: Exact, edges: list[tuple[Exact, Exact]]) -> Fraction:
    """From a point outside of the set."""
    found = []
    for a, b in edges:
        along, way = (b[0] - a[0], b[1] - a[1]), (x[0] - a[0], x[1] - a[1])
        square = along[0] ** 2 + along[1] ** 2
        t = min(max((along[0] * way[0] + along[1] * way[1]) / square, Fraction(0)), Fraction(1))
        found.append((way[0] - t * along[0]) ** 2 + (way[1] - t * along[1]) ** 2)
    return min(found)


def _components(document: dict[str, Any]) -> list[tuple[Ring, list[Ring]]]:
    def ring(curves: list[Any]) -> Ring:
        return tuple(tuple(curve) for curve in curves)

    return [
        (ring(component["outer"]), [ring(hole) for hole in component["holes"]])
        for component in document["components"]
    ]


def main(arguments: list[str]) -> int:
    seed, count = map(int, arguments)
    table = Table()
    compare(seed, range(count), table)
    print(json.dumps(vars(table), indent=1))
    return 1 if table.differences else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
