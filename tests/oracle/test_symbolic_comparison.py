"""minkref's events and intervals equal the symbolic oracle's."""

from __future__ import annotations

from minkref.fuzz.judges.plane.event_comparison import TYPES, compare
from minkref.fuzz.judges.plane.interval_comparison import compare_intervals

SEED = 20120811


def test_arrangement_events_are_those_of_every_pair_and_triple() -> None:
    print(f"seed {SEED}")
    table = compare(SEED, pairs=300, triples=1000)
    assert table.differences == 0, table.smallest
    assert all(3 * table.degenerate[kinds] >= table.pairs[kinds] for kinds in TYPES)
    assert table.events["triple swap"] and table.events["parallel overlap"]


def test_contact_intervals_are_those_of_the_definition() -> None:
    print(f"seed {SEED}")
    table = compare_intervals(SEED, 500)
    assert table.differences == 0, table.smallest
    assert all(3 * table.degenerate[kinds] >= table.pairs[kinds] for kinds in TYPES)
