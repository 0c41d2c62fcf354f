"""Laws and hand-made cases of the contact of two moving segments."""

from __future__ import annotations

import random
from collections import Counter

import pytest
from minkref.fuzz.judges.plane.segment_draws import draw
from minkref.oracle.symbolic.moving import MovingSegment, cross, parallel, s_edge, t_edge
from minkref.oracle.symbolic.pairs import CONDITIONS, Event, Interval, contact_set, pair_events
from minkref.oracle.symbolic.rational import Rational, rationals
from minkref.oracle.symbolic.solutions import branch, solution
from minkref.oracle.symbolic.standing import common, minus

SEED = 4711
KINDS = ("SS", "ST", "TS", "TT")


def drawn(count: int) -> list[tuple[MovingSegment, MovingSegment]]:
    print(f"seed {SEED}")
    rng = random.Random(SEED)
    found = []
    for i in range(count):
        (a, b), _ = draw(rng, KINDS[i % 4])
        found.append((a, b))
    return found


def moved(segment: MovingSegment, v: tuple[int, int], w: tuple[int, int]) -> MovingSegment:
    """The segment after translating P by v and Q by w."""
    p, q = rationals(v), rationals(w)
    shifts = (p, p, q) if segment.kind == "S" else (p, q, q)
    shift = [x for pair in shifts for x in pair]
    data = tuple(x + y for x, y in zip(segment.data, shift, strict=True))
    return MovingSegment(segment.kind, data)


def exchanged(segment: MovingSegment) -> MovingSegment:
    """The same segment, divided by s, when the operands are exchanged: sP + Q = s (Q/s + P)."""
    a, b, c = segment.data[:2], segment.data[2:4], segment.data[4:]
    return MovingSegment("T", c + a + b) if segment.kind == "S" else MovingSegment("S", b + c + a)


def events(a: MovingSegment, b: MovingSegment) -> list[Event]:
    return [] if parallel(a, b) else pair_events(a, b)


def test_contact_of_a_hand_made_pair_is_born_and_dies() -> None:
    """s (0,0)(1,0) on the x axis, and (2,-1)(2,1) + s (1/2,0): it is met while s >= 2 + s/2."""
    a, b = s_edge((0, 0), (1, 0), (0, 0)), t_edge(("1/2", 0), (2, -1), (2, 1))
    assert pair_events(a, b) == [Event(Rational(4), "birth", (Rational(4), Rational(0)))]
    c = t_edge((1, 1), (0, 0), (0, 5))  # (s, s) to (s, s + 5), against (3,3) to (3 + s,3)
    assert contact_set(s_edge((0, 0), (1, 0), (3, 3)), c) == Interval(Rational(3), Rational(3))
    assert [e.change for e in pair_events(s_edge((0, 0), (1, 0), (3, 3)), c)] == ["touch"]


def test_contact_may_last_for_all_scales_or_none() -> None:
    corner = s_edge((1, 1), (2, 1), (0, 0)), s_edge((1, 1), (1, 2), (0, 0))
    assert contact_set(*corner) == Interval(None, None)
    assert pair_events(*corner) == []
    apart = s_edge((0, 1), (1, 1), (0, 0)), t_edge((0, 0), (-1, -1), (0, -2))
    assert contact_set(*apart) is None


def test_contact_does_not_depend_on_the_order_of_the_segments_or_their_ends() -> None:
    for a, b in drawn(400):
        assert contact_set(a, b) == contact_set(b, a)
        x = a.data
        turned = (*x[2:4], *x[:2], *x[4:]) if a.kind == "S" else (*x[:2], *x[4:], *x[2:4])
        assert contact_set(MovingSegment(a.kind, turned), b) == contact_set(a, b)


def test_contact_is_translation_covariant() -> None:
    """P by v and Q by w: no scale moves, and the place moves by s v + w."""
    v, w = (3, -7), (2, 5)
    for a, b in drawn(400):
        assert contact_set(moved(a, v, w), moved(b, v, w)) == contact_set(a, b)
        there = [(e.at[0] + e.s * 3 + 2, e.at[1] - e.s * 7 + 5) for e in events(a, b)]
        assert [e.at for e in events(moved(a, v, w), moved(b, v, w))] == there


def test_exchanging_the_operands_maps_events_to_their_inverses() -> None:
    word = {"birth": "death", "death": "birth", "touch": "touch"}
    for a, b in drawn(400):
        expected = [
            Event(1 / e.s, word[e.change], (e.at[0] / e.s, e.at[1] / e.s)) for e in events(a, b)
        ]
        assert events(exchanged(a), exchanged(b)) == expected[::-1]


def test_contact_with_a_refined_edge_is_that_with_its_parts() -> None:
    print(f"seed {SEED}")
    rng = random.Random(SEED)
    for a, b in drawn(300):
        p = [Rational(rng.randint(1, 8), 9)]
        x = a.data if a.kind == "S" else a.data[2:]
        cut = (x[0] + p[0] * (x[2] - x[0]), x[1] + p[0] * (x[3] - x[1]))
        if a.kind == "S":
            parts = [(*x[:2], *cut, *x[4:]), (*cut, *x[2:])]
        else:
            parts = [(*a.data[:4], *cut), (*a.data[:2], *cut, *a.data[4:])]
        found = [contact_set(MovingSegment(a.kind, part), b) for part in parts]
        whole = contact_set(a, b)
        bounded = [each for each in found if each is not None]
        assert (whole is None) == (not bounded)
        if whole is not None:
            lows, highs = [i.low for i in bounded], [i.high for i in bounded]
            assert whole.low == (None if None in lows else min(x for x in lows if x is not None))
            assert whole.high == (None if None in highs else max(x for x in highs if x is not None))


def test_a_scan_over_scales_finds_no_other_contact() -> None:
    print(f"seed {SEED}")
    rng = random.Random(SEED)
    for a, b in drawn(300):
        found = contact_set(a, b)
        for _ in range(60):
            s = Rational(rng.randint(1, 400), rng.choice([1, 7, 30, 400]))
            inside = (
                found is not None
                and (found.low or 0) <= s
                and (found.high is None or s <= found.high)
            )
            assert (common(a.at(s), b.at(s)) is not None) == inside


def test_branches_of_the_conditions_are_those_of_the_definition() -> None:
    """once: the end is on the line there and nowhere else; always; never."""
    seen: Counter[str] = Counter()
    for a, b in drawn(400):
        for condition in CONDITIONS:
            case, s = branch(
                *solution(f"pair {a.kind}{b.kind} {condition}", "ab")(*a.data, *b.data)
            )
            seen[case] += 1
            moving, line = (a, b) if condition[0] == "t" else (b, a)
            for scale in [Rational(k, 7) for k in (1, 5, 9, 40)] + ([s] if s is not None else []):
                start, end = line.at(scale)
                off = minus(moving.at(scale)[int(condition[2])], start)
                expected = case == "always" or scale == s
                assert (cross(minus(end, start), off) == 0) == expected
    assert min(seen["once"], seen["always"], seen["never"]) > 50


def test_parallel_pairs_and_segments_without_length_are_refused() -> None:
    a = s_edge((0, 0), (1, 0), (0, 0))
    with pytest.raises(ValueError, match="parallel"):
        pair_events(a, t_edge((0, 0), (4, 0), (2, 0)))
    with pytest.raises(ValueError, match="length zero"):
        t_edge((0, 0), (1, 1), (1, 1))
    with pytest.raises(ValueError, match="kind"):
        MovingSegment("U", rationals(range(6)))
    with pytest.raises(TypeError, match="exact"):
        s_edge((0.5, 0), (1, 0), (0, 0))
