"""Events of a disc before the judge of places (oracle/places): each event's place, kind and
features, the changes of holes and components, and their places; laws for sets written differently,
or moved.

`python -m minkref.fuzz.judges.disc.disc_places SEED COUNT` compares sets from place_draws.py,
prints the table as JSON and exits with 1 on a fault."""

from __future__ import annotations

import json
import random
import sys
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.fuzz.features.place_draws import changed, drawn_set, set_of
from minkref.fuzz.geometry.plane import Point, Shape
from minkref.oracle.places import Boundary, event_faults, history_faults

Row = dict[str, Any]
Rows = tuple[list[Row], list[Row]]  # all events, and those at which holes or components change
NEAR = 1e-9


@dataclass
class Table:
    """`counts`: sets by kind, events by kind, changes, and sets with several events, or several
    changes, at one radius."""

    counts: Counter[str] = field(default_factory=Counter)
    faults: list[str] = field(default_factory=list)

    def add(self, other: Table) -> None:
        self.counts.update(other.counts)
        self.faults += other.faults


def rows_of(P: _core.PolygonSet) -> Rows:
    """Returns rows as `minkref events P disc` lists them, for both kinds."""
    index = _core.disc_index(P)
    every = [_row(*row) for row in index.rows(0, len(index.kinds()))]
    changes = []
    for event, _, born, ended, joined in index.changes():
        told = {
            "born": [{"hole": hole, "of": of} for hole, of in born],
            "ended": ended,
            "joined": [list(polygons) for polygons in joined],
        }
        changes.append({**every[event], "changes": told})
    return every, changes


def _row(
    kind: str, square: str | None, polynomial: Any, radius: Any, place: Any, features: Any
) -> Row:
    return {
        "kind": kind,
        "squared_radius": square,
        "polynomial": list(polynomial),
        "radius": {"low": radius[0], "high": radius[1]},
        "place": list(place),
        "features": [
            {"vertex": [first, second]} if name == "vertex" else {"edge": [int(first), int(second)]}
            for name, first, second in features
        ],
    }


def faults_of(shape: Shape, rows: Rows) -> list[str]:
    """Returns the judge's faults with both lists."""
    boundary = Boundary([
        [[(Fraction(x), Fraction(y)) for x, y in ring] for ring in polygon] for polygon in shape
    ])  # fmt: skip
    found, faults = [], []
    for row in rows[0]:
        _, wrong = event_faults(boundary, row)
        faults += wrong
    for row in rows[1]:
        event, wrong = event_faults(boundary, row)
        faults += wrong
        if event is not None:
            found.append((row, event))
    # Rows without a place have been told; the others tell too little without them.
    return faults if len(found) < len(rows[1]) else faults + history_faults(boundary, found)


def compare(seed: int, numbers: Sequence[int], table: Table) -> None:
    for number in numbers:
        name, shape = drawn_set(seed, number)
        rows = rows_of(set_of(shape))
        count(name, rows, table.counts)
        table.faults += [f"{name}: {fault}" for fault in faults_of(shape, rows)]
        table.faults += [f"{name}: {fault}" for fault in law_faults(seed, number, shape, rows)]


def count(name: str, rows: Rows, counts: Counter[str]) -> None:
    counts.update(["sets", f"sets: {name.split()[0]}", *(row["kind"] for row in rows[0])])
    counts["events"] += len(rows[0])
    for change in ("born", "ended", "joined"):
        counts[change] += sum(len(row["changes"][change]) for row in rows[1])
    for what, own in (("events", rows[0]), ("changes", rows[1])):
        squares = Counter(json.dumps(row["polynomial"]) for row in own)
        counts[f"sets with several {what} at one radius"] += any(n > 1 for n in squares.values())
    births = Counter(
        json.dumps(row["polynomial"]) for row in rows[1] for _ in row["changes"]["born"]
    )
    counts["sets with several births at one radius"] += any(n > 1 for n in births.values())


def law_faults(seed: int, number: int, shape: Shape, rows: Rows) -> list[str]:
    """Faults against two laws. A set written differently has the same rows. A mirrored, turned or
    enlarged set has the images of all events, and as many holes and components change at each
    radius."""
    dice = random.Random(f"minkref places law {seed}:{number}")
    way, other, change = changed(dice, shape)
    there = rows_of(set_of(other))
    faults = []
    for what, mine, theirs in zip(("events", "changes"), rows, there, strict=True):
        wanted = _places(mine, shape, change, exact=way == "order")
        found = _places(theirs, other, lambda p: p, exact=way == "order")
        if what == "changes" and way != "order":
            # Coordinates decide the place told among equal places, and the hole that keeps its
            # name.
            wanted, found = _changes(mine, 3 if way == "larger" else 1), _changes(theirs, 1)
        if not _are_alike(wanted, found):
            faults.append(f"{way}: other {what}")
    return faults


def _places(
    rows: list[Row], shape: Shape, change: Callable[[Point], Point], exact: bool
) -> list[Any]:
    """Kind, place, features and changes. `exact`: edges by their ends, and rows in their order.
    Else sorted, and edges by their lines: if two parts of an edge meet at the nearest point, a
    mirror image names the other part."""
    rings = [ring for polygon in shape for ring in polygon]

    def named(feature: Row) -> list[str]:
        if "vertex" in feature:
            x, y = map(Fraction, feature["vertex"])
            return list(map(str, change((x, y))))
        ring, k = feature["edge"]
        p, q = (change(rings[ring][j % len(rings[ring])]) for j in (k, k + 1))
        return list(map(str, (*p, *q))) if exact else _line(p, q)

    found = []
    for row in rows:
        x, y = change((Fraction(row["place"][0]), Fraction(row["place"][1])))
        told = row.get("changes")
        holes = [told["born"], told["ended"], len(told["joined"])] if told and exact else None
        features = sorted(map(named, row["features"]))
        found.append([float(x), float(y), row["kind"], features, holes])
    if exact:
        return found
    return sorted(found, key=lambda each: (round(each[0], 6), round(each[1], 6), each[2:]))


def _line(p: Point, q: Point) -> list[str]:
    """The line through two points, as slope and height, or as x."""
    dx, dy = q[0] - p[0], q[1] - p[1]
    if dx == 0:
        return [str(p[0])]
    slope = Fraction(dy) / dx
    return [str(slope), str(p[1] - slope * p[0])]


def _changes(rows: list[Row], factor: int) -> list[Any]:
    """Counts changes of each kind, by radius."""
    found: dict[float, Counter[str]] = {}
    for row in rows:
        own = found.setdefault(round(factor * row["radius"]["low"], 6), Counter())
        own.update({name: len(told) for name, told in row["changes"].items()})
    return sorted([radius, sorted(own.items())] for radius, own in found.items())


def _are_alike(a: Any, b: Any) -> bool:
    """Doubles may be rounded otherwise."""
    if isinstance(a, float) and isinstance(b, float):
        return abs(a - b) <= NEAR * max(1.0, abs(a))
    if isinstance(a, (list, tuple)):
        return len(a) == len(b) and all(map(_are_alike, a, b))
    return bool(a == b)


def main(arguments: list[str]) -> int:
    seed, sets = map(int, arguments)
    table = Table()
    compare(seed, range(sets), table)
    print(json.dumps(vars(table), indent=1))
    return 1 if table.faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
