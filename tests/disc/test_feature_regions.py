"""Regions of features and rest material, through Python: cases by hand, and laws on random sets.
tests/disc/feature_regions_test.cpp has the counts of the alpha-shape."""

from __future__ import annotations

import math
import random
from fractions import Fraction

import pytest
from minkref import _core
from minkref.disc.feature_regions import RegionsAt
from minkref.disc.features import Features
from minkref.errors import Refusal
from minkref.fuzz.features.place_draws import drawn_set, set_of
from minkref.fuzz.geometry.plane import Shape, box, mapped

from tests.disc.sampled_closing import added_area

SEED = 1282


def tips(slope: Fraction) -> Shape:
    """Two flat tips of width 1 at the distance 2."""
    half = Fraction(1, 2)
    left = [(0, -half), (0, half), (-4, half + 4 * slope), (-4, -half - 4 * slope)]
    right = [(2 - x, -y) for x, y in left]
    return [[left], [right]]


def cap(chord: float, radius: float) -> float:
    """The area that a disc covers beyond a chord."""
    angle = 2 * math.asin(chord / 2 / radius)
    return radius**2 * (angle - math.sin(angle)) / 2


def near(bounds: tuple[float, float], value: float) -> bool:
    low, high = bounds
    return low - 1e-12 <= value <= high + 1e-12 and high <= math.nextafter(low, math.inf)


def test_rest_between_flat_tips_falls_apart_at_no_event() -> None:
    shape = tips(Fraction(1, 8))
    P = set_of(shape)
    all_of = Features(P)
    for radius, components in ((Fraction(51, 50), 2), (Fraction(6, 5), 2), (Fraction(5, 4), 2),
                               (Fraction(13, 10), 1), (Fraction(3), 1)):  # fmt: skip
        found = all_of.regions(2 * radius)
        middle = [k for k, rest in enumerate(found.rest) if rest.area[0] > 0]
        assert sum(found.rest[k].components for k in middle) == components, radius
        if radius < Fraction(5, 4):
            continue
        assert near(found.rest_area, 2 - 2 * cap(2, float(radius)))
    # Below 5/4 both discs overlap in the middle: they cover their common lens once.
    deep = float(all_of.regions(Fraction(12, 5)).rest_area[0])
    centre = 0.5 + math.sqrt(1.44 - 1)
    lens = 2 * cap(2 * math.sqrt(1.44 - centre**2), 1.2)
    assert deep == pytest.approx(2 - 2 * cap(2, 1.2) + lens, abs=1e-12)


def test_vertices_that_face_each_other_leave_no_rest() -> None:
    P = set_of([[[(0, 0), (-4, 3), (-4, -3)]], [[(2, 0), (6, -3), (6, 3)]]])
    for radius in (Fraction(101, 100), Fraction(6, 5), Fraction(8, 5)):
        found = Features(P).regions(2 * radius)
        assert found.components == 1
        assert [rest.components for rest in found.rest] == [0] * len(found.features)
        assert found.rest_area == (0, 0)
        assert {feature.area for feature in found.features} == {(0, 0)}


def test_slot_and_filled_hole() -> None:
    slot = [[[(0, 0), (9, 0), (9, 6), (5, 6), (5, 2), (4, 2), (4, 6), (0, 6)]]]
    found = Features(set_of(slot)).regions(2)
    assert [feature.terms for feature in found.features] == [{"": Fraction(4)}]
    assert near(found.rest_area, 4 - cap(1, 1))
    holed = [[box(0, 0, 9, 9), list(reversed(box(3, 3, 2, 4)))]]
    below, above = (Features(set_of(holed)).regions(alpha) for alpha in ("9/5", "11/5"))
    assert (below.holes, above.holes) == (1, 0)
    assert above.rest_area == (8, 8)
    # Between a corner's sides and the disc in front of it: (1 - π/4) ρ².
    assert near(below.rest_area, 4 * 0.81 * (1 - math.pi / 4))


def drawn(number: int) -> tuple[Shape, Features, list[Fraction]]:
    """A random set, its features, and some radii among its events'."""
    _, shape = drawn_set(SEED, number)
    P = set_of(shape)
    radii = [low for low, _ in _core.disc_index(P).radii()] or [1.0]
    dice = random.Random(f"{SEED} {number}")
    chosen = sorted(dice.uniform(0.8, 1.2) * dice.choice(radii) for _ in range(4))
    return shape, Features(P), [Fraction(f"{radius:.6g}") for radius in chosen]


def areas(found: RegionsAt) -> float:
    return sum(feature.area[1] for feature in found.features)


@pytest.mark.parametrize("number", range(24))
def test_rest_grows_and_keeps_within_the_regions(number: int) -> None:
    _, all_of, radii = drawn(number)
    last = 0.0
    for radius in radii:
        found = all_of.regions(2 * radius)
        low, high = found.rest_area
        assert high <= math.nextafter(low, math.inf), (SEED, number, radius)
        assert high >= last, (SEED, number, radius)
        assert low <= areas(found) * (1 + 1e-12) + 1e-300, (SEED, number, radius)
        for feature, rest in zip(found.features, found.rest, strict=True):
            assert rest.area[0] <= feature.area[1], (SEED, number, radius)
            assert (rest.components > 0) == (rest.area[1] > 0), (SEED, number, radius)
        last = low


@pytest.mark.parametrize("number", range(10))
def test_regions_are_those_of_the_live_features(number: int) -> None:
    _, all_of, radii = drawn(number)
    for radius in radii:
        found, alive = all_of.regions(2 * radius), all_of.at(2 * radius)
        bridges = {
            feature.node: sorted(tuple(sorted(bridge.ends)) for bridge in feature.bridges)
            for feature in alive
        }
        chords = {
            feature.node: sorted(tuple(sorted(chord)) for chord in found.chords(k))
            for k, feature in enumerate(found.features)
            if feature.node is not None
        }
        assert chords == bridges, (SEED, number, radius)
        assert all(not found.chords(k) for k, feature in enumerate(found.features)
                   if feature.node is None)  # fmt: skip


@pytest.mark.parametrize("number", range(12))
def test_at_an_event_areas_are_limits_from_below(number: int) -> None:
    shape, all_of, _ = drawn(number)
    index = _core.disc_index(set_of(shape))
    squares = {row[1] for row in index.rows(0, len(index.kinds())) if row[1] is not None}
    for square in sorted(squares, key=Fraction)[::3]:
        below = str(Fraction(square) * (1 - Fraction(1, 10**12)))
        found, before = (RegionsAt(all_of._found.regions(text)) for text in (square, below))
        for own, other in zip(found.rest, before.rest, strict=True):
            assert own.area[0] == pytest.approx(other.area[0], abs=1e-4), (SEED, number, square)
        assert found.shape_area[0] == pytest.approx(before.shape_area[0], abs=1e-4)


@pytest.mark.parametrize("number", range(8))
def test_rest_is_the_area_of_a_sampled_closing(number: int) -> None:
    shape, all_of, radii = drawn(number)
    for radius in radii[:2]:
        low, high = all_of.regions(2 * radius).rest_area
        least, most = added_area(shape, float(radius), 160)
        assert least <= high, (SEED, number, radius)
        assert low <= most, (SEED, number, radius)


@pytest.mark.parametrize("number", range(8))
def test_areas_scale_with_similar_sets(number: int) -> None:
    """By a power of two and a quarter turn: the very same doubles, times that power. By 5/3 and the
    turn of a triangle 3, 4, 5: the areas times 25/9, within the doubles' bounds."""
    shape, all_of, radii = drawn(number)
    turned = Features(set_of(mapped(shape, lambda p: (-4 * p[1], 4 * p[0]))))
    similar = Features(
        set_of(
            mapped(shape, lambda p: (p[0] - p[1] * Fraction(4, 3), p[1] + p[0] * Fraction(4, 3)))
        )
    )
    for radius in radii[:2]:
        found = all_of.regions(2 * radius)
        for own, other in ((found.rest_area, turned.regions(8 * radius).rest_area),
                           (found.shape_area, turned.regions(8 * radius).shape_area)):  # fmt: skip
            assert other == (16 * own[0], 16 * own[1]), (SEED, number, radius)
        other = similar.regions(radius * Fraction(10, 3))
        assert sorted(rest.components for rest in other.rest) == sorted(
            rest.components for rest in found.rest
        ), (SEED, number, radius)
        for own, its in ((found.rest_area, other.rest_area), (found.shape_area, other.shape_area)):
            assert Fraction(its[0]) <= Fraction(own[1]) * Fraction(25, 9), (SEED, number, radius)
            assert Fraction(own[0]) * Fraction(25, 9) <= Fraction(its[1]), (SEED, number, radius)


def test_refusals_name_the_mend() -> None:
    all_of = Features(set_of([[box(0, 0, 1, 1)]]))
    with pytest.raises(_core.BadInput, match="give a radius"):
        all_of.regions().rest_area  # noqa: B018
    with pytest.raises(_core.BadInput, match="features count from 0 on"):
        all_of.regions(2).chords(0)
    with pytest.raises(Refusal, match="is 0"):
        all_of.regions(0)
