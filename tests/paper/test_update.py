"""The paper's update: with all formulas in their right form and all events it is exact; each
formula as printed loses the sum, on the smallest cases that are known."""

from __future__ import annotations

import random
from fractions import Fraction

import pytest
from minkref import _core
from minkref.fuzz.judges.plane.rounded_sums import compare, significant_bits
from minkref.fuzz.plane.families.catalogue import FAMILIES
from minkref.fuzz.plane.families.random_pairs import random_pair

SEED = 27
SCALES = 25  # of each pair: 1,000 in all
CORRECTED = {name: corrected for name, _, corrected, _ in _core.paper_readings()}
DRAWN = [
    (family, index)
    for family in ("random", "holes", "touching", "collinear", "degenerate", "lattice", "rational")
    for index in range(0, 120, 20)
][:40]

# The sum of this pair has a hole that vanishes at 541/186, where three edges share a point.
HOLE_P = "POLYGON ((-3 -2, 4 -1, 1 3, -3 -2))"
HOLE_Q = "POLYGON ((-40 -40, 40 -40, 40 40, -40 40, -40 -40), (0 20, 17 -11, -19 -9, 0 20))"


def scales_of(update: _core.PaperUpdate, dice: random.Random, count: int) -> list[str]:
    """Scales, half of them from the event array."""
    events = [event[0] for event in update.events()] or ["1"]
    return [
        dice.choice(events) if k % 2 else str(Fraction(dice.randint(1, 90), dice.randint(9, 40)))
        for k in range(count)
    ]


@pytest.mark.parametrize("adjacent", ["left-out", "taken"])
@pytest.mark.parametrize(("family", "index"), DRAWN)
def test_all_corrected_in_rational_numbers_is_the_exact_sum(
    family: str, index: int, adjacent: str
) -> None:
    """Compares digests, up and down, at scales of which half are events."""
    pair = FAMILIES[family].pair(SEED, index)
    P, Q = (_core.PolygonSet.from_json(text) for text in (pair.P, pair.Q))
    update = _core.PaperUpdate(P, Q, "1", "rational", CORRECTED | {"adjacent": adjacent})
    dynamic = _core.DynamicSum(P, Q)
    for scale in scales_of(update, random.Random(f"{family} {index}"), SCALES):
        update.move_to(scale)
        dynamic.move_to(scale)
        found, expected = update.sum(), dynamic.sum()
        assert found.region.canonical_json() == expected.region.canonical_json(), scale
        assert (found.components, found.holes) == (expected.components, expected.holes)


@pytest.mark.parametrize("arithmetic", ["rational", "double", "mpfr:100"])
@pytest.mark.parametrize("form", ["printed", "corrected"])
def test_there_and_back_is_as_before_where_intersections_are_sorted(
    arithmetic: str, form: str
) -> None:
    """Only the order that is kept along an edge depends on the way."""
    readings = {"order": "sorted"} | (CORRECTED if form == "corrected" else {})
    for index in (30, 300, 900):
        pair = random_pair(SEED, index)
        P, Q = (_core.PolygonSet.from_json(text) for text in (pair.P, pair.Q))
        update = _core.PaperUpdate(P, Q, "1", arithmetic, readings)
        first = update.sum().region
        for scale in ("3", "1/5", "1"):
            update.move_to(scale)
        assert update.sum().region.canonical_json() == first.canonical_json()
        there = _core.PaperUpdate(P, Q, "7/5", arithmetic, readings).sum().region
        update.move_to("7/5")
        assert update.sum().region.canonical_json() == there.canonical_json()


def test_doubles_and_mpfr_of_53_bits_answer_alike() -> None:
    """The same roundings in the same order: nothing overflows here."""
    for index in (60, 600, 1200):
        pair = random_pair(SEED, index)
        P, Q = (_core.PolygonSet.from_json(text) for text in (pair.P, pair.Q))
        for readings in ({}, CORRECTED):
            one, other = (
                _core.PaperUpdate(P, Q, "13/10", arithmetic, readings)
                for arithmetic in ("double", "mpfr:53")
            )
            assert one.events() == other.events()
            assert one.sum().region.canonical_json() == other.sum().region.canonical_json()


@pytest.mark.parametrize("bits", [53, 200, 1000])
def test_consistency_fails_in_rounding_arithmetic_of_any_precision(bits: int) -> None:
    """Section 4.2.1: rounding calls solvable conditions inconsistent, and loses regions. Rational
    numbers lose none."""
    pair = random_pair(SEED, 900)
    P, Q = (_core.PolygonSet.from_json(text) for text in (pair.P, pair.Q))
    printed = CORRECTED | {"solve": "printed"}
    exact = _core.PaperUpdate(P, Q, "1", "rational", printed).events()
    assert exact == _core.PaperUpdate(P, Q, "1", "rational", CORRECTED).events()
    rounded = _core.PaperUpdate(P, Q, "1", f"mpfr:{bits}", printed).events()
    assert len(rounded) < len(exact)


@pytest.mark.parametrize(
    ("reading", "value", "same"),
    [
        ("solve", "printed", True),
        ("solve", "least-squares", True),
        ("adjacent", "taken", True),
        ("no-root", "never", False),
    ],
)
def test_what_changes_nothing_in_rational_numbers(reading: str, value: str, same: bool) -> None:
    """A condition without a slope has no root and may hold at all scales: `never` loses edges."""
    right = True
    for index in range(0, 300, 30):
        pair = random_pair(3, index)
        P, Q = (_core.PolygonSet.from_json(text) for text in (pair.P, pair.Q))
        update = _core.PaperUpdate(P, Q, "7/5", "rational", CORRECTED | {reading: value})
        right = right and update.sum().region == _core.minkowski_sum(P, Q, "7/5").region
    assert right is same


@pytest.mark.parametrize("arithmetic", ["double", "mpfr:53", "mpfr:200", "mpfr:1000"])
def test_consistency_loses_a_corner_of_the_sum_of_two_triangles(arithmetic: str) -> None:
    P = _core.PolygonSet([(2, 0), (3, 3), (1, 2)])
    Q = _core.PolygonSet([(0, 1), (1, 0), (1, 2)])
    expected = _core.minkowski_sum(P, Q, "1").region
    printed = CORRECTED | {"solve": "printed"}
    assert _core.PaperUpdate(P, Q, "1", "rational", printed).sum().region == expected
    for solve, right in (("printed", False), ("least-squares", True), ("corrected", True)):
        program = _core.PaperUpdate(P, Q, "1", arithmetic, CORRECTED | {"solve": solve})
        assert (
            compare(P, Q, "1", program.sum(), significant_bits(arithmetic)).same_structure is right
        )


def test_a_hole_born_at_a_triple_event_is_missed_where_the_order_is_kept() -> None:
    """The hole exists below 541/186. From above, the kept order has a loop at the hole's place that
    runs the wrong way; from below, the loop that should have gone runs so too, and collision
    detection omits it."""
    P, Q = _core.PolygonSet(HOLE_P), _core.PolygonSet(HOLE_Q)
    for order, first, last, right in (
        ("sorted", "3", "5/2", True),
        ("kept", "3", "5/2", False),
        ("kept", "5/2", "3", True),
    ):
        update = _core.PaperUpdate(P, Q, first, "rational", CORRECTED | {"order": order})
        update.move_to(last)
        expected = _core.minkowski_sum(P, Q, last)
        assert expected.holes == (1 if last == "5/2" else 0)
        assert (update.sum().region == expected.region) is right


@pytest.mark.parametrize("name", ["observation", "interval"])
def test_each_misprinted_formula_loses_the_sum_of_two_triangles(name: str) -> None:
    P = _core.PolygonSet("POLYGON ((0 0, 3 0, 0 2, 0 0))")
    Q = _core.PolygonSet("POLYGON ((0 0, 5 1, 2 2, 1 4, 0 0))")
    expected = _core.minkowski_sum(P, Q, "1").region
    right = _core.PaperUpdate(P, Q, "1", "rational", CORRECTED).sum().region
    wrong = _core.PaperUpdate(P, Q, "1", "rational", CORRECTED | {name: "printed"}).sum().region
    assert right == expected
    assert wrong != expected


def test_a_wrong_scale_arithmetic_or_reading_is_refused() -> None:
    P = _core.PolygonSet([(0, 0), (1, 0), (0, 1)])
    for scale, arithmetic, readings in (
        ("0", "rational", {}),
        ("1", "mpfr:x", {}),
        ("1", "rational", {"observation": "right"}),
        ("1", "rational", {"solve": "tolerance:-1"}),
        ("1", "rational", {"solve": "tolerance:nan"}),
        ("1", "rational", {"no reading": "printed"}),
    ):
        with pytest.raises(_core.BadInput):
            _core.PaperUpdate(P, P, scale, arithmetic, readings)
    update = _core.PaperUpdate(P, P, "1", "rational", {})
    for scale in ("0", "-1"):
        with pytest.raises(_core.BadInput):
            update.move_to(scale)


def test_points_segments_and_nothing_as_operands() -> None:
    triangle = _core.PolygonSet([(0, 0), (3, 0), (0, 2)])
    for other in (_core.PolygonSet((1, 2)), _core.PolygonSet([(0, 0), (1, 3)]), _core.PolygonSet()):
        for P, Q in ((triangle, other), (other, triangle)):
            update = _core.PaperUpdate(P, Q, "2", "rational", CORRECTED)
            for scale in ("2", "1/3"):
                update.move_to(scale)
                assert update.sum().region == _core.minkowski_sum(P, Q, scale).region


@pytest.mark.parametrize("arithmetic", ["rational", "double", "mpfr:100"])
def test_the_list_has_the_intersections_that_a_search_of_all_pairs_finds(arithmetic: str) -> None:
    """Takes edges with a common vertex and omits parallel edges: both counts agree; with small
    integers no arithmetic errs at these scales."""
    readings = CORRECTED | {"adjacent": "taken", "parallel": "left-out"}
    for index in (30, 300, 900):
        pair = random_pair(SEED, index)
        P, Q = (_core.PolygonSet.from_json(text) for text in (pair.P, pair.Q))
        exact = _core.PaperUpdate(P, Q, "1", "rational", readings)
        update = _core.PaperUpdate(P, Q, "1", arithmetic, readings)
        for scale in ("3", "1/4", "7/4"):
            listed = update.move_to(scale)["updated"]
            found = update.search_intersections(scale)[0]
            assert update.place_intersections()[0] == listed
            assert exact.search_intersections(scale)[0] == exact.move_to(scale)["updated"]
            assert found == exact.search_intersections(scale)[0] > 0


def test_a_search_of_all_pairs_refuses_a_scale_that_is_not_positive() -> None:
    update = _core.PaperUpdate(_core.PolygonSet(HOLE_P), _core.PolygonSet(HOLE_Q))
    for scale in ("0", "-1"):
        with pytest.raises(_core.BadInput, match="not greater than zero"):
            update.search_intersections(scale)
