"""Wrong answers about a disc, for the judge of places to find. Each mutant changes one detail in
the lists from `disc_places.rows_of`; None if nothing can be changed."""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Iterator
from copy import deepcopy
from itertools import combinations
from typing import Any

from minkref.fuzz.geometry.plane import Shape

Row = dict[str, Any]
Rows = tuple[list[Row], list[Row]]
OF_AN_EVENT = ("kind", "place", "features")


def _pairs_at_one_radius(rows: list[Row]) -> Iterator[tuple[Row, Row]]:
    for a, b in combinations(rows, 2):
        if a["polynomial"] == b["polynomial"] and a["radius"] == b["radius"]:
            yield a, b


def swapped_places(dice: random.Random, shape: Shape, rows: Rows) -> Rows | None:
    """Lists two events at one radius at each other's place."""
    events, changes = deepcopy(rows)
    pairs = [(a, b) for a, b in _pairs_at_one_radius(events) if a["features"] != b["features"]]
    if not pairs:
        return None
    a, b = dice.choice(pairs)
    a["place"], b["place"] = b["place"], a["place"]
    return events, changes


def place_off_by_units(dice: random.Random, shape: Shape, rows: Rows) -> Rows | None:
    """Moves a coordinate by three doubles."""
    events, changes = deepcopy(rows)
    if not events:
        return None
    place, axis = dice.choice(events)["place"], dice.randrange(2)
    place[axis] += dice.choice((-3, 3)) * math.ulp(place[axis])
    return events, changes


def swapped_births(dice: random.Random, shape: Shape, rows: Rows) -> Rows | None:
    """Lists two holes born at one radius at each other's event."""
    events, changes = deepcopy(rows)
    born = [row for row in changes if row["changes"]["born"]]
    pairs = list(_pairs_at_one_radius(born))
    if not pairs:
        return None
    a, b = dice.choice(pairs)
    a["changes"]["born"], b["changes"]["born"] = b["changes"]["born"], a["changes"]["born"]
    return events, changes


def birth_elsewhere(dice: random.Random, shape: Shape, rows: Rows) -> Rows | None:
    """Gives a hole's birth to another event at its radius."""
    events, changes = deepcopy(rows)
    pairs = [
        (row, event) for row in changes if row["changes"]["born"] and not row["changes"]["joined"]
        for event in events
        if event["polynomial"] == row["polynomial"] and event["place"] != row["place"]
    ]  # fmt: skip
    if not pairs:
        return None
    row, event = dice.choice(pairs)
    row |= {name: event[name] for name in OF_AN_EVENT}
    return events, changes


def first_edge_of_line(dice: random.Random, shape: Shape, rows: Rows) -> Rows | None:
    """Gives an edge the name of another edge on its line."""
    events, changes = deepcopy(rows)
    rings = [ring for polygon in shape for ring in polygon]

    def line(ring: int, k: int) -> Any:
        (ax, ay), (bx, by) = rings[ring][k], rings[ring][(k + 1) % len(rings[ring])]
        return bx - ax, by - ay, ax, ay

    def are_on_one(e: Any, f: Any) -> bool:
        dx, dy, ax, ay = line(*e)
        ux, uy, bx, by = line(*f)
        return bool(
            dx * uy == dy * ux and dx * (by - ay) == dy * (bx - ax) and dx * ux + dy * uy > 0
        )

    names = [(ring, k) for ring, own in enumerate(rings) for k in range(len(own))]
    choices = [
        (each, name) for event in events for each in event["features"] if "edge" in each
        for name in names if list(name) != each["edge"] and are_on_one(each["edge"], name)
    ]  # fmt: skip
    if not choices:
        return None
    each, name = dice.choice(choices)
    each["edge"] = list(name)
    return events, changes


def other_kind(dice: random.Random, shape: Shape, rows: Rows) -> Rows | None:
    events, changes = deepcopy(rows)
    if not events:
        return None
    row = dice.choice(events)
    kinds = ("corner", "joint", "saddle", "ridge", "maximum")
    row["kind"] = dice.choice([kind for kind in kinds if kind != row["kind"]])
    return events, changes


def feature_dropped(dice: random.Random, shape: Shape, rows: Rows) -> Rows | None:
    events, changes = deepcopy(rows)
    choices = [row for row in events if len(row["features"]) > 3]
    if not choices:
        return None
    row = dice.choice(choices)
    row["features"].pop(dice.randrange(len(row["features"])))
    return events, changes


def other_hole_left(dice: random.Random, shape: Shape, rows: Rows) -> Rows | None:
    """Names a wrong hole as the parent of a hole."""
    events, changes = deepcopy(rows)
    holes = 1 + max((h for row in changes for h in row["changes"]["ended"]), default=0)
    choices = [each for row in changes for each in row["changes"]["born"] if holes > 2]
    if not choices:
        return None
    each = dice.choice(choices)
    each["of"] = dice.choice([k for k in range(holes) if k not in (each["hole"], each["of"])])
    return events, changes


def birth_dropped(dice: random.Random, shape: Shape, rows: Rows) -> Rows | None:
    events, changes = deepcopy(rows)
    choices = [row["changes"]["born"] for row in changes if row["changes"]["born"]]
    if not choices:
        return None
    dice.choice(choices).pop()
    return events, changes


def join_elsewhere(dice: random.Random, shape: Shape, rows: Rows) -> Rows | None:
    """Lets components join at another event at the radius, which joins none."""
    events, changes = deepcopy(rows)
    pairs = [
        (row, event) for row in changes if row["changes"]["joined"] and not row["changes"]["born"]
        for event in events
        if event["polynomial"] == row["polynomial"] and event["kind"] in ("corner", "joint")
    ]  # fmt: skip
    if not pairs:
        return None
    row, event = dice.choice(pairs)
    row |= {name: event[name] for name in OF_AN_EVENT}
    return events, changes


MUTANTS: dict[str, Callable[[random.Random, Shape, Rows], Rows | None]] = {
    each.__name__: each
    for each in (
        swapped_places, place_off_by_units, swapped_births, birth_elsewhere, first_edge_of_line,
        other_kind, feature_dropped, other_hole_left, birth_dropped, join_elsewhere,
    )
}  # fmt: skip
