"""A disc's pair events equal the symbolic oracle's events, and printed events the formulas'."""

from __future__ import annotations

from minkref.fuzz.judges.disc.disc_pair_comparison import Table, compare, compare_printed
from minkref.fuzz.judges.disc.disc_pair_draws import KINDS
from minkref.fuzz.judges.disc.disc_pair_polygons import compare_polygons
from thoroughness import draws

SEED = 20120811
PAIRS = draws(75, 300)
POLYGONS = draws(10, 40)


def is_drawn_as_wanted(table: Table) -> bool:
    special = sum(count for name, count in table.relations.items() if name != "free")
    return all(table.pairs[kind] == PAIRS for kind in KINDS) and 3 * special >= len(KINDS) * PAIRS


def test_events_of_two_features_are_those_of_all_conditions() -> None:
    print(f"seed {SEED}")
    table = compare(SEED, PAIRS)
    assert not table.differences, table.differences[0]
    assert is_drawn_as_wanted(table)
    assert len(table.contacts) == 4 and min(table.contacts.values()) > draws(4, 20)
    assert {"birth", "death", "touch", "overlap"} <= set(table.changes)


def test_printed_events_are_those_of_the_formulas() -> None:
    print(f"seed {SEED}")
    table = compare_printed(SEED, PAIRS)
    assert not table.differences, table.differences[0]
    assert is_drawn_as_wanted(table)
    assert table.changes["none"] > PAIRS / 6 and table.changes["birth"] > PAIRS / 15


def test_events_of_polygons_are_those_of_all_pairs_of_features() -> None:
    print(f"seed {SEED}")
    table = compare_polygons(SEED, POLYGONS)
    assert not table.differences, table.differences[0]
    assert min(table.events["birth"], table.events["death"]) > 1.25 * POLYGONS
