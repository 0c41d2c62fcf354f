"""Three moving segments through one point: hand-made cases and laws."""

from __future__ import annotations

import random
from itertools import permutations

from minkref.fuzz.judges.plane.segment_draws import draw
from minkref.oracle.symbolic.moving import MovingSegment, parallel, s_edge, t_edge
from minkref.oracle.symbolic.pairs import Event, Interval
from minkref.oracle.symbolic.rational import Rational, rationals
from minkref.oracle.symbolic.triples import (
    Triple,
    ends_passed,
    meeting_scales,
    shared_at,
    swaps,
    triple_events,
)

SEED = 541
CORNERS = ((-3, -2), (4, -1), (1, 3))
HOLE = ((0, 20), (17, -11), (-19, -9))


def sides_of_the_hole() -> Triple:
    """Each side of the hole at the triangle's corner that reaches furthest into the hole."""
    return (
        t_edge(CORNERS[0], HOLE[0], HOLE[1]),
        t_edge(CORNERS[2], HOLE[1], HOLE[2]),
        t_edge(CORNERS[1], HOLE[2], HOLE[0]),
    )


def drawn(count: int) -> list[Triple]:
    print(f"seed {SEED}")
    rng = random.Random(SEED)
    found: list[Triple] = []
    for _ in range(count):
        kinds = "".join(rng.choice("ST") for _ in range(3))
        (a, b, c), _ = draw(rng, kinds, 4)
        found.append((a, b, c))
    return found


def test_the_hole_of_a_triangle_dies_at_a_triple_event() -> None:
    """With x on n.x = h + s m for each side (n normal to it, m from the corner) the determinant
    of the three equations vanishes at 541/186 only; no two sides begin or cease to meet there."""
    triple = sides_of_the_hole()
    s = Rational(541, 186)
    place = Rational(-59, 186), Rational(-107, 93)
    assert meeting_scales(triple) == [Interval(s, s)]
    assert triple_events(triple) == [Event(s, "swap", place)]
    assert [third for _, third in swaps(triple)] == [0, 1, 2]


def test_a_corner_that_runs_along_an_edge_swaps_nothing() -> None:
    """Two edges of one corner, and a third edge: when the corner reaches the third edge, pairs are
    born."""
    corner = (s_edge((1, 1), (3, 1), (0, 0)), s_edge((1, 1), (1, 3), (0, 0)))
    third = t_edge((0, 0), (0, 10), (10, 0))
    triple = (*corner, third)
    assert triple_events(triple) == []
    assert meeting_scales(triple) == [Interval(Rational(5), Rational(5))]


def test_three_edges_of_one_point_meet_at_all_scales_without_event() -> None:
    star = tuple(s_edge((1, 1), end, (2, 0)) for end in ((4, 1), (1, 5), (-2, -2)))
    triple = (star[0], star[1], star[2])
    assert meeting_scales(triple) == [Interval(None, None)]
    assert triple_events(triple) == []


def test_a_crossing_that_passes_an_end_on_a_common_line_is_no_swap_of_edges() -> None:
    """[0,4] and [1,6] lie on the x axis; x = s/2 crosses the first until 8, the second from 2."""
    a, b = t_edge((0, 0), (0, 0), (4, 0)), t_edge((0, 0), (1, 0), (6, 0))
    c = t_edge(("1/2", 0), (0, -1), (0, 1))
    assert triple_events((a, b, c)) == []
    assert [(str(e.s), third) for e, third in ends_passed((a, b, c))] == [("2", 0), ("8", 1)]
    assert meeting_scales((a, b, c)) == [Interval(Rational(2), Rational(8))]


def test_ends_that_pass_on_a_common_line_are_told_for_the_third_too() -> None:
    """[0,2] and [5-s,6-s] on [-9,9]: they meet from 3 to 6, ends are level at 4 and at 5."""
    a, b = t_edge((0, 0), (0, 0), (2, 0)), t_edge((-1, 0), (5, 0), (6, 0))
    c = t_edge((0, 0), (-9, 0), (9, 0))
    assert triple_events((a, b, c)) == []
    along_c = [(str(e.s), str(e.at[0])) for e, third in ends_passed((a, b, c)) if third == 2]
    assert along_c == [("3", "2"), ("4", "2"), ("5", "0"), ("6", "0")]


def test_an_end_that_enters_where_another_leaves_passes_nobody() -> None:
    """[3s,4s], [1,2] and [2s,2s+1]: at 1/2 all end at 2, and each pair of ends passes there. On the
    third segment, the first segment's end exists until then, and the second's from then on."""
    a, b = s_edge((4, 0), (3, 0), (0, 0)), t_edge((0, 0), (1, 0), (2, 0))
    c = t_edge((2, 0), (0, 0), (1, 0))
    assert [str(e.s) for e, third in ends_passed((a, b, c)) if third == 2] == ["1/4", "1/3", "2/3"]


def test_events_do_not_depend_on_the_order_of_the_segments() -> None:
    for triple in drawn(120):
        for a, b, c in permutations(triple):
            assert triple_events((a, b, c)) == triple_events(triple)
            assert meeting_scales((a, b, c)) == meeting_scales(triple)


def test_exchanging_the_operands_inverts_the_scales_of_triples() -> None:
    def exchanged(x: MovingSegment) -> MovingSegment:
        a, b, c = x.data[:2], x.data[2:4], x.data[4:]
        return MovingSegment("T", c + a + b) if x.kind == "S" else MovingSegment("S", b + c + a)

    seen = 0
    for a, b, c in drawn(400):
        expected = [
            Event(1 / e.s, "swap", (e.at[0] / e.s, e.at[1] / e.s)) for e in triple_events((a, b, c))
        ]
        seen += len(expected)
        assert triple_events((exchanged(a), exchanged(b), exchanged(c))) == expected[::-1]
    assert seen > 10


def test_a_scan_over_scales_finds_no_other_concurrency() -> None:
    print(f"seed {SEED}")
    rng = random.Random(SEED)
    for triple in drawn(150):
        found = meeting_scales(triple)
        for _ in range(40):
            s = Rational(rng.randint(1, 90), rng.choice([1, 7, 30]))
            inside = any((i.low or 0) <= s and (i.high is None or s <= i.high) for i in found)
            assert (shared_at(triple, s) is not None) == inside


def test_a_swap_lies_on_all_three_segments() -> None:
    for triple in drawn(400):
        for event, third in swaps(triple):
            assert shared_at(triple, event.s) == (event.at, event.at)
            assert not any(parallel(triple[third], x) for x in triple if x is not triple[third])


def test_translation_moves_the_place_and_not_the_scale() -> None:
    a, b, c = sides_of_the_hole()
    far = rationals((5, -2, 9, 9, 9, 9))
    moved = [
        MovingSegment("T", tuple(x + y for x, y in zip(e.data, far, strict=True)))
        for e in (a, b, c)
    ]
    (event,), (known,) = triple_events((moved[0], moved[1], moved[2])), triple_events((a, b, c))
    assert event.s == known.s
    assert event.at == (known.at[0] + 5 * known.s + 9, known.at[1] - 2 * known.s + 9)
