"""The symbolic oracle against the reference's events of facet pairs in space.

compare(seed, pairs) draws small polyhedra until enough facet pairs of each kind were seen, half
with events, and reports where both differ. Run it: `python -m
minkref.fuzz.judges.space.space_event_comparison SEED PAIRS` prints the table as JSON and exits with
1 on a difference.
"""

from __future__ import annotations

import json
import random
import sys
from collections import Counter, defaultdict
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

from minkref import _core
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.judges.space.space_routes import core_polyhedron
from minkref.fuzz.space.general_pairs import FAMILIES, GeneralPair, pair_of_family
from minkref.oracle.symbolic.rational import rational
from minkref.oracle.symbolic.space.facet_pairs import FacetEvents, facet_events
from minkref.oracle.symbolic.space.space_moving import MovingFacet, facet

KINDS = ("vertex", "edge", "once", "always")
"""Pairs with an event of a vertex, with one of an edge; planes that are one once, or always."""

FROM, TO = "1/50", "50"
OF_A_KIND = 60  # most facet pairs of a kind from two polyhedra
STRAY = 40  # most pairs without events
MOST_FACETS = 4_000
Key = tuple[int, int]
Told = tuple[str, str, str, tuple[str, ...] | None]  # scale, kind, change, place


@dataclass
class Difference:
    pair: str
    facets: list[str]
    only_symbolic: list[str]
    only_minkref: list[str]


@dataclass
class Table:
    """Counts and differences of a comparison."""

    seed: int
    polyhedra: int = 0
    pairs: Counter[str] = field(default_factory=Counter)
    degenerate: Counter[str] = field(default_factory=Counter)
    events: Counter[str] = field(default_factory=Counter)
    without_events: int = 0
    differences: list[Difference] = field(default_factory=list)

    def document(self) -> dict[str, Any]:
        return {**vars(self), "differences": [vars(each) for each in self.differences[:20]]}


def compare(seed: int, pairs: int) -> Table:
    """Compares at least `pairs` facet pairs of each kind. Equal arguments give equal tables."""
    table = Table(seed)
    while any(table.pairs[kind] < pairs for kind in KINDS):
        drawn = solids_of(seed, table.polyhedra)
        table.polyhedra += 1
        if drawn is not None:
            _compare_polyhedra(drawn.name, drawn.P, drawn.Q, pairs, table)
    return table


def solids_of(seed: int, index: int) -> GeneralPair | None:
    """Draws two solids, from families in turn. None if the draw is not solid."""
    families = [name for name in FAMILIES if name != "thin"]
    try:
        return pair_of_family(families[index % len(families)], seed, index)
    except ValueError:  # a knot that crosses itself
        return None


def _compare_polyhedra(name: str, P: Polyhedron, Q: Polyhedron, wanted: int, table: Table) -> None:
    found = _core.space_events(core_polyhedron(P), core_polyhedron(Q), FROM, TO)
    count = dict(found.counts())["facets"]
    if count > MOST_FACETS:
        return
    listed: dict[Key, list[Told]] = defaultdict(list)
    for s, kind, change, i, _, j, _, place in found.rows(0, len(found)):
        listed[i, j].append((s, kind, change, None if kind == "parallel" else place))
    dice = random.Random(f"minkref space events {name}")
    moving: dict[int, MovingFacet] = {}

    def facet_of(number: int) -> MovingFacet:
        if number not in moving:
            moving[number] = moving_facet(P, Q, *found.facet(number))
        return moving[number]

    taken: Counter[str] = Counter()
    for i, j in _drawn(dice, list(listed), count):
        guess = {kind for _, kind, _, _ in listed.get((i, j), [])} or {"none"}
        if all(taken[kind] >= (STRAY if kind == "none" else OF_A_KIND) for kind in guess):
            continue
        known = facet_events(facet_of(i), facet_of(j))
        kinds = _kinds(known)
        if kinds and all(table.pairs[kind] >= 2 * wanted for kind in kinds):
            continue
        taken.update(guess)
        for kind in kinds:
            table.pairs[kind] += 1
            table.degenerate[kind] += known.degenerate
        table.without_events += not known.events
        ours = Counter(listed.get((i, j), []))
        theirs = Counter(_told(known))
        table.events.update(f"{kind} {change}" for _, kind, change, _ in theirs.elements())
        if _comparable(known, ours) != theirs:
            ours = _comparable(known, ours)
            table.differences.append(
                Difference(name, [_show(found.facet(i)), _show(found.facet(j))],
                           sorted(map(str, theirs - ours)), sorted(map(str, ours - theirs)))
            )  # fmt: skip


def _drawn(dice: random.Random, listed: list[Key], facets: int) -> Iterator[Key]:
    """Yields pairs with events in any order, then random others."""
    dice.shuffle(listed)
    yield from listed
    for _ in range(4 * STRAY):
        i, j = sorted((dice.randrange(facets), dice.randrange(facets)))
        if i != j:
            yield i, j


def _kinds(known: FacetEvents) -> list[str]:
    if known.standing == "crossing":
        return sorted({event.kind for event in known.events})
    return [known.standing] if known.standing in KINDS else []


def _told(known: FacetEvents) -> list[Told]:
    """Returns the events in the window."""
    low, high = rational(FROM), rational(TO)
    return [
        (str(e.s), e.kind, e.change, None if e.at is None else tuple(map(str, e.at)))
        for e in known.events
        if low <= e.s <= high
    ]


def _comparable(known: FacetEvents, ours: Counter[Told]) -> Counter[Told]:
    """Drops places of facets that are coplanar at a single scale: no place is theirs alone."""
    if known.standing == "crossing" or known.standing == "always":
        return Counter(
            {(s, kind, change, place and tuple(place)): n
             for (s, kind, change, place), n in ours.items()}
        )  # fmt: skip
    return Counter({(s, kind, change, None): n for (s, kind, change, _), n in ours.items()})


def moving_facet(
    P: Polyhedron, Q: Polyhedron, kind: str, of_P: list[int], of_Q: list[int]
) -> MovingFacet:
    p, q = list(dict.fromkeys(of_P)), list(dict.fromkeys(of_Q))
    return facet(
        kind,
        [[str(x) for x in P.vertices[v]] for v in p],
        [[str(x) for x in Q.vertices[v]] for v in q],
    )


def _show(found: tuple[str, list[int], list[int]]) -> str:
    kind, of_P, of_Q = found
    return f"{kind} {of_P} + {of_Q}"


def main(arguments: list[str]) -> int:
    seed, pairs = map(int, arguments)
    table = compare(seed, pairs)
    print(json.dumps(table.document(), indent=1))
    return 1 if table.differences else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
