"""Events of facets in space are those of the symbolic oracle."""

from __future__ import annotations

from minkref.fuzz.judges import facet_tuple_comparison, space_event_comparison
from minkref.oracle.symbolic.rational import Rational
from minkref.oracle.symbolic.space_standing import on_segment, shared

SEED = 20120811


def test_events_of_two_facets() -> None:
    print(f"seed {SEED}")
    table = space_event_comparison.compare(SEED, 40)
    assert not table.differences, table.differences[:2]
    kinds = space_event_comparison.KINDS
    assert all(table.pairs[kind] >= 40 for kind in kinds) and table.without_events > 0


def test_events_of_three_and_four_facets() -> None:
    table = facet_tuple_comparison.compare(seed=1, quadruples=500)
    assert not table.differences, table.differences[:2]
    assert table.events["triple birth"] and table.events["four touch"]


def test_a_point_shares_itself_alone_with_a_segment() -> None:
    def point(*numbers: int) -> tuple[Rational, ...]:
        return tuple(map(Rational, numbers))

    x, other, end = point(1, 0, 0), point(5, 5, 5), point(2, 0, 0)
    assert shared((x, x), (point(0, 0, 0), end)) == (x, x)
    assert not on_segment(other, (x, x))
