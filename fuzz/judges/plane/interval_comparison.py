"""The contact intervals of single pairs of moving segments against minkref's `pair_intervals`."""

from __future__ import annotations

import random
from collections import Counter
from dataclasses import dataclass, field

from minkref import _core
from minkref.fuzz.judges.plane.event_comparison import is_degenerate
from minkref.fuzz.judges.plane.paper_pairs import contact_bounds
from minkref.fuzz.judges.plane.segment_draws import Row, build, draw_rows
from minkref.oracle.symbolic.moving import MovingSegment

TYPES = ("SS", "ST", "TT")


@dataclass
class IntervalTable:
    """Counts of a comparison, and the first difference for each of minkref's words for the case."""

    seed: int
    pairs: Counter[str] = field(default_factory=Counter)
    degenerate: Counter[str] = field(default_factory=Counter)
    relations: Counter[str] = field(default_factory=Counter)
    cases: Counter[str] = field(default_factory=Counter)
    differences: int = 0
    smallest: dict[str, str] = field(default_factory=dict)


def compare_intervals(seed: int, count: int) -> IntervalTable:
    """Compares `count` pairs of each type, most deliberately in special position."""
    rng = random.Random(seed)
    table = IntervalTable(seed)
    asked: list[tuple[tuple[str, tuple[int, ...]], ...]] = []
    drawn: list[tuple[str, tuple[MovingSegment, MovingSegment]]] = []
    for kinds in TYPES:
        for _ in range(count):
            rows, relation = draw_rows(rng, kinds, rng.choice([2, 5, 1000]))
            a, b = (build(kind, *row) for kind, row in zip(kinds, rows, strict=True))
            drawn.append((kinds, (a, b)))
            asked.append(tuple((k, flat(row)) for k, row in zip(kinds, rows, strict=True)))
            table.pairs[kinds] += 1
            table.relations[relation] += 1
            table.degenerate[kinds] += is_degenerate(a, b)
    answers = _core.pair_intervals([(first, second) for first, second in asked])
    for (kinds, pair), question, (case, empty, low, high) in zip(
        drawn, asked, answers, strict=True
    ):
        table.cases[case] += 1
        theirs = None if empty else (None if low == "0" else low, high)
        if contact_bounds(*pair) != theirs:
            table.differences += 1
            table.smallest.setdefault(
                f"{kinds} {case}", f"{question}: {contact_bounds(*pair)}, minkref {theirs}"
            )
    return table


def flat(row: Row) -> tuple[int, ...]:
    return tuple(x for vector in row for x in vector)
