"""Handmade cases of parallel moving segments, and their meaning scale by scale."""

from __future__ import annotations

import random
from itertools import pairwise
from typing import Any

from minkref.fuzz.judges.plane.segment_draws import draw
from minkref.oracle.symbolic.moving import MovingSegment, s_edge, t_edge
from minkref.oracle.symbolic.pairs import contact_set
from minkref.oracle.symbolic.parallels import always_on_one_line, parallel_events
from minkref.oracle.symbolic.rational import Rational, rationals
from minkref.oracle.symbolic.standing import common

SEED = 31


def events(a: MovingSegment, b: MovingSegment) -> list[tuple[Any, ...]]:
    return [(str(e.s), e.change, e.at, e.to) for e in parallel_events(a, b)]


def at(*place: int) -> tuple[Rational, ...]:
    return rationals(place)


def test_segments_on_one_line_meet_pass_and_part() -> None:
    """[0,2] at rest, and [5-s,6-s]: right ends level at 4, left ones at 5."""
    a, b = t_edge((0, 0), (0, 0), (2, 0)), t_edge((-1, 0), (5, 0), (6, 0))
    expected = [
        ("3", "birth", at(2, 0), None),
        ("4", "swap", at(2, 0), None),
        ("5", "swap", at(0, 0), None),
        ("6", "death", at(0, 0), None),
    ]
    assert events(a, b) == events(b, a) == expected


def test_a_growing_segment_passes_the_ends_of_one_at_rest() -> None:
    """[-s,s] and [-1,2]: the first segment has both ends inside until 1, its right end until 2."""
    a, b = s_edge((-1, 0), (1, 0), (0, 0)), t_edge((0, 0), (2, 0), (-1, 0))
    expected = [("1", "swap", at(-1, 0), None), ("2", "swap", at(2, 0), None)]
    assert events(a, b) == expected


def test_lines_that_coincide_once_overlap_touch_or_miss() -> None:
    a = t_edge((0, 0), (0, 0), (2, 0))
    assert events(a, t_edge((0, 1), (1, -3), (4, -3))) == [("3", "overlap", at(1, 0), at(2, 0))]
    assert events(a, t_edge((0, 1), (2, -3), (4, -3))) == [("3", "touch", at(2, 0), None)]
    assert events(a, t_edge((0, 1), (3, -3), (4, -3))) == []


def test_segments_that_end_where_the_other_begins_have_no_events() -> None:
    assert events(s_edge((0, 0), (1, 0), (0, 0)), t_edge((1, 0), (0, 0), (2, 0))) == []


def test_ends_that_are_one_point_at_all_scales_do_not_pass() -> None:
    """[0,s] and [0,2]: only the right ends pass."""
    a, b = s_edge((0, 0), (1, 0), (0, 0)), t_edge((0, 0), (0, 0), (2, 0))
    assert events(a, b) == [("2", "swap", at(2, 0), None)]


def test_ends_that_pass_at_one_scale_in_two_places_are_two_swaps() -> None:
    """[-s,s] and [-2,2]: both ends pass at once."""
    a, b = s_edge((-1, 0), (1, 0), (0, 0)), t_edge((0, 0), (-2, 0), (2, 0))
    assert events(a, b) == [("2", "swap", at(-2, 0), None), ("2", "swap", at(2, 0), None)]


def test_events_of_parallel_segments_are_where_contact_changes() -> None:
    """Between events contact is all there or not at all, and the shared ends stay the same ones."""
    print(f"seed {SEED}")
    rng = random.Random(SEED)
    level = 0
    for _ in range(600):
        (a, b), relation = draw(rng, rng.choice(["SS", "ST", "TS", "TT"]), 4)
        if relation not in ("parallel", "one line"):
            continue
        found, limits = contact_set(a, b), [e.s for e in parallel_events(a, b)]
        ordered = [*sorted({Rational(0), *limits}), max(limits, default=Rational(0)) + 9]
        for low, high in pairwise(ordered):
            inside = [low + (high - low) * k / 7 for k in range(1, 7)]
            assert len({common(a.at(s), b.at(s)) is not None for s in inside}) == 1
            if always_on_one_line(a, b):
                level += 1
                assert len({owners(a, b, s) for s in inside}) == 1
        assert found is not None or not limits
    assert level > 100


def owners(a: MovingSegment, b: MovingSegment, s: Rational) -> frozenset[tuple[str, int]]:
    """The ends that bound the segments' common part at scale s."""
    shared = common(a.at(s), b.at(s))
    named = [("a", i, x) for i, x in enumerate(a.at(s))] + [
        ("b", i, x) for i, x in enumerate(b.at(s))
    ]
    return frozenset((name, i) for name, i, x in named if shared and x in shared)
