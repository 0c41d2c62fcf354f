"""Both routes to sums with a disc, by distances and by winding numbers: equal canonical forms.

`python -m minkref.fuzz.judges.disc.offset_routes SEED COUNT` compares them for sets of cells of a
grid, also turned, sheared and moved far away, at radii at which much happens; it prints the table
as JSON and exits with 1 if there is a difference."""

from __future__ import annotations

import json
import random
import sys
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field
from fractions import Fraction

from minkref import _core
from minkref.exact import set_json
from minkref.fuzz.judges.disc.offset_comparison import CRITICAL, grid_set

ROUTES = ("definition", "paper")
FAR = Fraction(10**14, 3)
SMALLEST_PARTS = (4, 8, 16)
Move = Callable[[Fraction, Fraction], tuple[Fraction, Fraction]]

# How a set is moved, and the squared growth factor.
MOVES: dict[str, tuple[Move, int | Fraction]] = {
    "as drawn": (lambda x, y: (x, y), 1),
    "turned": (lambda x, y: (3 * x - 4 * y, 4 * x + 3 * y), 25),
    "turned, by roots": (lambda x, y: ((2 * x - y) / 3, (x + 2 * y) / 3), Fraction(5, 9)),
    "sheared": (lambda x, y: (x + y / 3, y), 1),
    "far away": (lambda x, y: (x + FAR, y - FAR), 1),
}


@dataclass
class RouteTable:
    """Counts and differences of a comparison."""

    counts: Counter[str] = field(default_factory=Counter)
    differences: list[str] = field(default_factory=list)


def compare_routes(seed: int, numbers: range, table: RouteTable) -> None:
    """Compares sets by number, one in ten a point or a segment. Equal numbers give equal sets and
    radii."""
    for number in numbers:
        dice = random.Random(f"minkref disc routes {seed}:{number}")
        P = _thin_set(dice) if dice.random() < 0.1 else grid_set(dice)
        name = dice.choice(list(MOVES))
        move, growth = MOVES[name]
        moved = _moved(P, move)
        square, kind = _squared_radius(dice)
        square *= growth
        if P.is_empty:
            continue
        where = f"{seed}:{number}, {name}, squared radius {square}"
        try:
            forms = [_core.offset(moved, str(square), 1, route) for route in ROUTES]
        except RuntimeError as error:  # our fault: the set is valid
            table.differences.append(f"{where}: {error}: {moved.canonical_json()}")
            continue
        table.counts.update(("compared", name, kind))
        table.counts["holes"] += forms[0].holes
        table.counts["curves"] += forms[0].curves
        if forms[0].canonical_json() != forms[1].canonical_json():
            table.differences.append(f"{where}: {moved.canonical_json()}")


def _thin_set(dice: random.Random) -> _core.PolygonSet:
    corners = [(str(dice.randint(0, 5)), str(dice.randint(0, 5))) for _ in range(2)]
    return _core.PolygonSet.from_json(set_json([(list(dict.fromkeys(corners)), [])]))


def _moved(P: _core.PolygonSet, move: Move) -> _core.PolygonSet:
    def ring(corners: list[tuple[Fraction, Fraction]]) -> list[tuple[str, str]]:
        return [(str(x), str(y)) for x, y in (move(*corner) for corner in corners)]

    polygons = [[ring(each) for each in rings] for rings in P.rings()]
    return _core.PolygonSet.from_json(set_json([(rings[0], rings[1:]) for rings in polygons]))


def _squared_radius(dice: random.Random) -> tuple[Fraction, str]:
    """Half a grid width, the root of a fraction with small numbers, or any fraction."""
    draw = dice.random()
    if draw < 0.4:
        return dice.choice(CRITICAL) ** 2, "at halves of widths"
    if draw < 0.8:
        return Fraction(dice.randint(1, 60), dice.choice(SMALLEST_PARTS)), "at roots"
    return Fraction(dice.randint(1, 2999), 1000) ** 2, "at other radii"


def main(arguments: list[str]) -> int:
    seed, count = map(int, arguments)
    table = RouteTable()
    compare_routes(seed, range(count), table)
    print(json.dumps(vars(table), indent=1))
    return 1 if table.differences else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
