"""The symbolic oracle against `minkref events`: every pair and triple of convolution edges.

compare(seed, pairs, triples) draws small operands until enough pairs of moving segments of each
type were seen, and says where the two differ. Run it: `python -m
minkref.fuzz.judges.plane.event_comparison SEED PAIRS TRIPLES` prints the table as JSON and exits
with 1 if there is a difference.
"""

from __future__ import annotations

import json
import random
import sys
from collections import Counter
from dataclasses import dataclass, field
from itertools import combinations
from math import comb
from typing import Any

from minkref.fuzz.judges.plane.event_rows import compared, show, symbolic_rows
from minkref.fuzz.plane.families.small_operands import Rings, random_operand
from minkref.oracle.symbolic.arrangement import pairwise_events, threefold_events
from minkref.oracle.symbolic.convolution import reduced_convolution
from minkref.oracle.symbolic.moving import MovingSegment, parallel
from minkref.oracle.symbolic.pairs import CONDITIONS, candidates
from minkref.oracle.symbolic.rational import rationals
from minkref.oracle.symbolic.solutions import solution

TYPES = ("SS", "ST", "TT")
SIZES = (1, 2, 2, 3, 4, 60)
LONGEST = 40  # segments: all triples of more would take too long


@dataclass
class Difference:
    """An operand pair with events that only one side has."""

    P: Rings
    Q: Rings
    only_symbolic: list[str]
    only_minkref: list[str]

    def size(self) -> int:
        return sum(len(ring) for ring in (*self.P, *self.Q))


@dataclass
class Table:
    """Counts of a comparison; `smallest`: the difference with the fewest vertices of each kind."""

    seed: int
    operands: int = 0
    segments: int = 0
    pairs: Counter[str] = field(default_factory=Counter)
    degenerate: Counter[str] = field(default_factory=Counter)
    triples: int = 0
    several_places: int = 0
    events: Counter[str] = field(default_factory=Counter)
    left_out_too_long: int = 0
    differences: int = 0
    smallest: dict[str, Difference] = field(default_factory=dict)

    def document(self) -> dict[str, Any]:
        """The table as JSON has it."""
        return {**vars(self), "smallest": {k: vars(d) for k, d in self.smallest.items()}}

    def note(self, what: str, difference: Difference) -> None:
        self.differences += 1
        known = self.smallest.get(what)
        if known is None or difference.size() < known.size():
            self.smallest[what] = difference


def is_degenerate(a: MovingSegment, b: MovingSegment) -> bool:
    """Parallel, an end on the other's line at no or every scale, or two ends there at one scale."""
    kinds, data = a.kind + b.kind, a.data + b.data
    roots = [solution(f"pair {kinds} {condition}", "ab")(*data) for condition in CONDITIONS]
    if parallel(a, b) or any(below == 0 for _, below in roots):
        return True
    return len(set(candidates(a, b))) < len(CONDITIONS)


def compare_operands(P: Rings, P_set: Any, Q: Rings, Q_set: Any, table: Table) -> None:
    """Adds one operand pair to the table."""
    exact = [[[rationals(corner) for corner in ring] for ring in rings] for rings in (P, Q)]
    edges = reduced_convolution(*exact)  # type: ignore[arg-type]
    if len(edges) > LONGEST:
        table.left_out_too_long += 1
        return
    segments = [edge.segment for edge in edges]
    table.operands += 1
    table.segments += len(edges)
    table.triples += comb(len(edges), 3)
    for a, b in combinations(segments, 2):
        table.pairs[a.kind + b.kind] += 1
        table.degenerate[a.kind + b.kind] += is_degenerate(a, b)
    found = pairwise_events(segments) + threefold_events(segments)
    ours = symbolic_rows(edges, found)
    table.events.update(f"{each.kind} {each.event.change}" for each in found)
    table.several_places += sum(count > 1 for count in Counter(row[:4] for row in ours).values())
    listed = compared(edges, found, P_set, Q_set)
    for what, (extra, missing) in listed.items():
        if extra or missing:
            shown = sorted(map(show, extra))[:20], sorted(map(show, missing))[:20]
            table.note(what, Difference(P, Q, *shown))


def compare(seed: int, pairs: int, triples: int) -> Table:
    """Compares at least `pairs` pairs of moving segments of each type SS, ST, TT and `triples`
    triples. The same seed and counts give the same table."""
    rng = random.Random(seed)
    table = Table(seed)
    while table.triples < triples or any(table.pairs[kinds] < pairs for kinds in TYPES):
        size, other = rng.choice(SIZES), rng.choice(SIZES)
        P, P_set = random_operand(rng, size)
        Q, Q_set = random_operand(rng, size if rng.random() < 0.6 else other)
        compare_operands(P, P_set, Q, Q_set, table)
    return table


def main(arguments: list[str]) -> int:
    table = compare(*map(int, arguments))
    print(json.dumps(table.document(), indent=1))
    return 1 if table.differences else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
