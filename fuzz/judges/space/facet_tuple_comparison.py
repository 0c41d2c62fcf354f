"""The symbolic oracle against the reference's events of three and of four facets in space.

compare(seed, quadruples) draws small polyhedra until enough quadruples of facets were seen, and
reports where both differ: a third have an event of four, a third an event of three, and the rest
combines facets that meet. Run it: `python -m minkref.fuzz.judges.space.facet_tuple_comparison SEED
QUADRUPLES` prints the table as JSON and exits with 1 on a difference.
"""

from __future__ import annotations

import json
import random
import sys
from collections import Counter, defaultdict
from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import combinations
from typing import Any

from minkref import _core
from minkref.fuzz.judges.space.space_event_comparison import (
    FROM,
    TO,
    Difference,
    moving_facet,
    solids_of,
)
from minkref.fuzz.judges.space.space_routes import core_polyhedron
from minkref.fuzz.space.general_pairs import GeneralPair
from minkref.oracle.symbolic.rational import rational
from minkref.oracle.symbolic.space.coplanar_triples import TupleEvent
from minkref.oracle.symbolic.space.facet_tuples import (
    parallel_among,
    quadruple_event,
    triple_events,
)
from minkref.oracle.symbolic.space.space_moving import MovingFacet

MOST_FACETS = 1_000
OF_EACH = 60  # most quadruples of each origin from two polyhedra
Numbers = tuple[int, ...]
Told = tuple[str, str, tuple[str, ...]]  # scale, change, place


@dataclass
class Table:
    """Counts and differences of a comparison."""

    seed: int
    polyhedra: int = 0
    quadruples: int = 0
    triples: int = 0
    degenerate: int = 0
    events: Counter[str] = field(default_factory=Counter)
    differences: list[Difference] = field(default_factory=list)

    def document(self) -> dict[str, Any]:
        return {**vars(self), "differences": [vars(each) for each in self.differences[:20]]}


def compare(seed: int, quadruples: int, first: int = 0, step: int = 1) -> Table:
    """At least so many quadruples, of pairs of polyhedra `first`, `first + step`, ... The same
    arguments give the same table."""
    table = Table(seed)
    index = first
    while table.quadruples < quadruples:
        pair = solids_of(seed, index)
        if pair is not None:
            _compare_polyhedra(pair, table)
        index += step
    return table


class _Listed:
    """The reference's events, by facets."""

    def __init__(self, pair: GeneralPair) -> None:
        P, Q = core_polyhedron(pair.P), core_polyhedron(pair.Q)
        self.found = _core.space_events(P, Q, FROM, TO, concurrent=True)
        self.pair = pair
        self.moving: dict[int, MovingFacet] = {}
        self.of: dict[Numbers, list[Told]] = defaultdict(list)
        for s, _, change, facets, _, place in self.found.concurrent(0, 10**9):
            self.of[tuple(facets)].append((s, change, tuple(place)))
        self.meeting = sorted({(row[3], row[5]) for row in self.found.rows(0, len(self.found))})

    def facet(self, number: int) -> MovingFacet:
        if number not in self.moving:
            found = self.found.facet(number)
            self.moving[number] = moving_facet(self.pair.P, self.pair.Q, *found)
        return self.moving[number]


def _compare_polyhedra(pair: GeneralPair, table: Table) -> None:
    listed = _Listed(pair)
    if dict(listed.found.counts())["facets"] > MOST_FACETS:
        return
    table.polyhedra += 1
    dice = random.Random(f"minkref facet tuples {pair.name}")
    seen: set[Numbers] = set()
    for numbers in _drawn(dice, listed):
        if numbers in seen or len(set(numbers)) < 4:
            continue
        seen.add(numbers)
        table.quadruples += 1
        table.degenerate += _is_degenerate(listed, numbers)
        for count in (3, 4):
            for some in combinations(numbers, count):
                if count == 3 and some in seen:
                    continue
                seen.add(some)
                table.triples += count == 3
                _compare_tuple(listed, some, table)


def _drawn(dice: random.Random, listed: _Listed) -> Iterator[Numbers]:
    """Yields quadruples with events of four, some with events of three, and some from pairs that
    meet."""
    fours = [numbers for numbers in listed.of if len(numbers) == 4]
    yield from dice.sample(fours, min(OF_EACH, len(fours)))
    triples = [numbers for numbers in listed.of if len(numbers) == 3]
    pairs = listed.meeting
    beside: dict[int, list[int]] = defaultdict(list)
    for i, j in pairs:
        beside[i].append(j)
        beside[j].append(i)
    for numbers in dice.sample(triples, min(OF_EACH, len(triples))):
        others = beside[dice.choice(numbers)]
        if others:
            yield tuple(sorted((*numbers, dice.choice(others))))
    for i, j in dice.sample(pairs, min(OF_EACH, len(pairs))):
        yield tuple(sorted((i, j, dice.choice(beside[i]), dice.choice(beside[j]))))


def _compare_tuple(listed: _Listed, numbers: Numbers, table: Table) -> None:
    facets = [listed.facet(number) for number in numbers]
    theirs: Counter[Told] = Counter()
    found = triple_events(facets) if len(facets) == 3 else _of_four(facets)
    theirs.update(told for event in found if (told := _told(event)) is not None)
    ours = Counter(listed.of.get(numbers, []))
    kind = "triple" if len(facets) == 3 else "four"
    table.events.update(f"{kind} {change}" for _, change, _ in theirs.elements())
    if ours != theirs:
        table.differences.append(
            Difference(
                listed.pair.name,
                [str(listed.found.facet(number)) for number in numbers],
                sorted(map(str, theirs - ours)),
                sorted(map(str, ours - theirs)),
            )
        )


def _of_four(facets: list[MovingFacet]) -> list[TupleEvent]:
    event = None if parallel_among(facets) else quadruple_event(facets)
    return [] if event is None else [event]


def _told(event: TupleEvent) -> Told | None:
    """Returns the event's row, if within the window."""
    if not rational(FROM) <= event.s <= rational(TO):
        return None
    return str(event.s), event.change, tuple(map(str, event.at))


def _is_degenerate(listed: _Listed, numbers: Numbers) -> bool:
    """Whether facets share corners at all scales or are parallel, or their normals are coplanar."""
    corners = [set(zip(*listed.found.facet(number)[1:], strict=True)) for number in numbers]
    facets = [listed.facet(number) for number in numbers]
    return any(a & b for a, b in combinations(corners, 2)) or parallel_among(facets)


def main(arguments: list[str]) -> int:
    seed, quadruples = map(int, arguments)
    table = compare(seed, quadruples)
    print(json.dumps(table.document(), indent=1))
    return 1 if table.differences else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
