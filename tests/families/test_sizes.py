"""Families that promise a size, a limit or a number: all members keep it, and formulas hold."""

from __future__ import annotations

import json
from collections.abc import Callable
from fractions import Fraction
from itertools import pairwise, product

import pytest
from minkref import _core
from minkref.degeneracies.catalogue import FAMILIES
from minkref.degeneracies.make_corpus import SEED
from minkref.degeneracies.plane.convolutions import crossing_combs, crossing_spirals
from minkref.degeneracies.plane.draft import Draft, Facts
from minkref.degeneracies.plane.outline import PLANE
from minkref.fuzz.geometry.plane import Shape
from thoroughness import draws

LARGEST = Fraction(2) ** 1024 - Fraction(2) ** 971
LEAST_NORMAL, LEAST = Fraction(1, 2**1022), Fraction(1, 2**1074)
THIRD = Fraction(1, 3)

Box = tuple[list[Fraction], list[Fraction]]


def holes(P: Shape, Q: Shape) -> int:
    facts = Facts.of(Draft(P, Q, Fraction(1)))
    return _core.minkowski_sum(facts.P, facts.Q, "1").holes


def coordinates(facts: Facts) -> list[Fraction]:
    return [c for point in (*facts.vertices.P, *facts.vertices.Q) for c in point]


def box_of_sum(facts: Facts) -> Box:
    """The least x and y, the greatest."""
    P, Q, s = facts.vertices.P, facts.vertices.Q, facts.scale
    low, high = (
        [s * extreme(p[k] for p in P) + extreme(q[k] for q in Q) for k in (0, 1)]
        for extreme in (min, max)
    )
    return low, high


@pytest.mark.parametrize(("m", "n"), [(2, 2), (2, 3), (3, 2), (3, 3), (5, 2), (2, 6), (4, 5)])
def test_combs_have_holes_by_the_formula(m: int, n: int) -> None:
    for thick, room in ((THIRD, 0), (Fraction(1, 2), 3)):
        P, Q = crossing_combs(m, n, thick, room)
        assert sum(len(ring) for shape in (P, Q) for part in shape for ring in part) == 8 * (m + n)
        assert holes(P, Q) == (m * n - 1) ** 2


@pytest.mark.parametrize(("m", "n"), [(3, 3), (3, 4), (4, 3), (3, 7), (6, 3), (5, 5)])
def test_spirals_have_holes_by_the_formula(m: int, n: int) -> None:
    for steps, wall in product(((3, 3), (3, 5), (5, 4)), (THIRD, Fraction(1, 2))):
        P, Q = crossing_spirals(m, n, steps, wall, THIRD, 0)
        assert sum(len(ring) for shape in (P, Q) for part in shape for ring in part) == (
            8 * (m + n) - 8
        )
        assert holes(P, Q) == m * n * (m - 1) * (n - 1) - m - n + 3


@pytest.mark.parametrize("name", ["combs", "spirals"])
def test_sums_grow_with_the_size_that_is_asked_for(name: str) -> None:
    usual = [FAMILIES[name].member(7, index)[0] for index in range(20)]
    assert all(facts.P.vertices + facts.Q.vertices <= 40 for facts in usual)
    assert max(facts.at.region.vertices for facts in usual) <= 300
    sizes = (40, 56, 72, 88)
    large = [FAMILIES[name].member(7, 0, size)[0] for size in sizes]
    vertices = [facts.P.vertices + facts.Q.vertices for facts in large]
    assert vertices == list(sizes)
    assert large[-1].at.holes > 600 and large[-1].at.region.vertices > 25 * vertices[-1]
    assert [f.at.holes for f in large] == sorted({f.at.holes for f in large})
    most = FAMILIES[name].member(7, 0, 2000)[0]
    assert most.P.vertices + most.Q.vertices <= 96 and most.at.holes >= large[-1].at.holes


@pytest.mark.parametrize("name", ["combs", "spirals"])
def test_sums_have_far_more_vertices_than_operands(name: str) -> None:
    for index in range(draws(10, 30)):
        facts = FAMILIES[name].member(7, index)[0]
        assert facts.at.region.vertices > 2 * (facts.P.vertices + facts.Q.vertices)
        assert facts.at.holes >= 9


@pytest.mark.parametrize("name", ["limits-of-float64", "limits-of-integers"])
def test_members_at_limits_differ_by_the_thousand(name: str) -> None:
    drawn = [FAMILIES[name].member(5, index)[0] for index in range(draws(240, 1000))]
    count = len({facts.P.to_json() + facts.Q.to_json() for facts in drawn})
    assert count >= 0.999 * len(drawn)
    slanted = [facts for facts in drawn if has_slanted_edges(facts.Q)]
    assert 0.3 <= len(slanted) / len(drawn) <= 0.9
    assert len({facts.P.vertices for facts in drawn}) >= 5


def has_slanted_edges(operand: _core.PolygonSet) -> bool:
    polygons = json.loads(operand.to_json())["polygons"]
    rings = [ring for part in polygons for ring in (part["outer"], *part["holes"])]
    edges = [(ring[k - 1], ring[k]) for ring in rings for k in range(len(ring))]
    return any(a[0] != b[0] and a[1] != b[1] for a, b in edges)


def kind_of_double(facts: Facts) -> str:
    """Asserts that all coordinates are doubles; names their limit."""
    values = coordinates(facts)
    assert all(Fraction(float(c)) == c for c in values)
    sizes = {abs(c) for c in values}
    low, high = box_of_sum(facts)
    if max(sizes) < LEAST_NORMAL:
        assert min(sizes) == LEAST
        return "least"
    most = max(sizes)
    assert min(values) == -most and max(values) == most
    assert min(low) < -most and most < max(high)
    return {LARGEST: "largest", LEAST_NORMAL: "least normal"}[most]


def test_doubles_up_to_the_limits() -> None:
    count = draws(100, 200)
    kinds = [kind_of_double(FAMILIES["limits-of-float64"].member(3, k)[0]) for k in range(count)]
    assert all(kinds.count(kind) > count / 5 for kind in ("least", "least normal", "largest"))
    family = FAMILIES["limits-of-float64"]
    corpus = {kind_of_double(family.member(SEED, k)[0]) for k in range(PLANE.count)}
    assert corpus == set(kinds)


def test_significands_are_full() -> None:
    """Looks at coordinates near the largest double; 2**971 is its distance to the next below."""
    drawn = [FAMILIES["limits-of-float64"].member(3, k)[0] for k in range(60)]
    large = [c for f in drawn if kind_of_double(f) == "largest" for c in coordinates(f)]
    full = [c for c in large if abs(c) >= 2**1023 and (c / 2**971) % 2]
    assert len(full) > len(large) / 10


def test_integers_up_to_the_limits() -> None:
    ranges = {(-(2**31), 2**31 - 1), (-(2**53), 2**53), (-(2**62), 2**62), (-(2**63), 2**63 - 1)}
    for seed, count in ((3, 100), (SEED, PLANE.count)):
        seen = set()
        for index in range(count):
            facts = FAMILIES["limits-of-integers"].member(seed, index)[0]
            values = coordinates(facts)
            assert all(c.denominator == 1 for c in values)
            limits = int(min(values)), int(max(values))
            low, high = box_of_sum(facts)
            assert min(low) < limits[0] and limits[1] < max(high)
            seen.add(limits)
        assert seen == ranges


@pytest.mark.parametrize(
    ("name", "low", "high", "is_extreme"),
    [
        ("scales-near-zero", f"1/{2**200}", "1", lambda scale: scale < Fraction(1, 10**6)),
        ("scales-far-out", "1", f"{2**200}", lambda scale: scale > 10**6),
    ],
)
def test_event_scales_accumulate(
    name: str, low: str, high: str, is_extreme: Callable[[Fraction], bool]
) -> None:
    for index in range(15):
        facts = FAMILIES[name].member(SEED, index)[0]
        events = _core.DynamicSum(facts.P, facts.Q, low, high).topology_events()
        deaths = sorted({Fraction(row[0]) for row in events if row[1:3] == ("hole", "death")})
        assert 3 <= len(deaths) <= 5 and facts.scale in deaths
        assert all(8 * a <= b for a, b in pairwise(deaths))
        assert is_extreme(deaths[0]) or is_extreme(deaths[-1])
        assert facts.scale < Fraction(1, 2**10) or facts.scale > 2**10


def test_what_only_nearly_belongs_does_not() -> None:
    """Drops a hole; moves an operand pair by one, or by half the least double."""
    family = FAMILIES["scales-near-zero"]
    facts = family.member(SEED, 0)[0]
    assert facts.Q.ring_count == 4 and family.belongs(facts)
    for hole in range(3):
        value = json.loads(facts.Q.to_json())
        del value["polygons"][0]["holes"][hole]
        fewer = _core.PolygonSet.from_json(json.dumps(value))
        assert not family.belongs(Facts(facts.P, fewer, facts.scale))
    for name, move in (("limits-of-integers", Fraction(1)), ("limits-of-float64", LEAST / 2)):
        facts = FAMILIES[name].member(SEED, 0)[0]
        assert FAMILIES[name].belongs(facts)
        P, Q = (operand.translated(str(move), str(move)) for operand in (facts.P, facts.Q))
        assert not FAMILIES[name].belongs(Facts(P, Q, facts.scale))
