"""Events of facets in space equal the symbolic oracle's."""

from __future__ import annotations

from minkref.fuzz.judges.space import (
    facet_arrangement,
    facet_tuple_comparison,
    space_event_comparison,
)
from minkref.oracle.symbolic.rational import Rational
from minkref.oracle.symbolic.space.space_standing import on_segment, shared
from thoroughness import draws

SEED = 20120811


def test_events_of_two_facets() -> None:
    print(f"seed {SEED}")
    table = space_event_comparison.compare(SEED, count := draws(6, 40))
    assert not table.differences, table.differences[:2]
    kinds = space_event_comparison.KINDS
    assert all(table.pairs[kind] >= count for kind in kinds) and table.without_events > 0


def test_events_of_three_and_four_facets() -> None:
    table = facet_tuple_comparison.compare(seed=1912, quadruples=draws(40, 400))
    assert not table.differences, table.differences[:2]
    assert table.events["triple birth"] and table.events["four touch"]


def test_sides_in_one_plane_that_come_to_pass_through_one_point() -> None:
    """Two pairs of facets and a side of other facets are coplanar at all scales."""
    pair = space_event_comparison.solids_of(1912, 385)
    assert pair is not None
    judged = facet_arrangement.judge_list(pair, ("1/5", "2"), 160, draws(1, 3))
    assert judged is not None and judged.faults == []


def test_three_facets_come_to_pass_through_one_point() -> None:
    """Needs many draws: pairs of polyhedra with facets folded onto each other at a side."""
    table = facet_tuple_comparison.compare(1912, 60, first=draws(16, 20))
    assert not table.differences, table.differences[:2]
    assert table.events["triple pass"]


def test_a_point_shares_itself_alone_with_a_segment() -> None:
    def point(*numbers: int) -> tuple[Rational, ...]:
        return tuple(map(Rational, numbers))

    x, other, end = point(1, 0, 0), point(5, 5, 5), point(2, 0, 0)
    assert shared((x, x), (point(0, 0, 0), end)) == (x, x)
    assert not on_segment(other, (x, x))
