"""Erosion, opening, closing, no-fit and inner-fit against the slow engine and by laws; a cut-out
piece goes back at one place."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise
from typing import Any

import minkref
import pytest
from minkref import PolygonSet, _core
from minkref.fuzz.judges.plane.erosion_pairs import erosion_case
from minkref.fuzz.judges.plane.places_pairs import jigsaw, place_faults
from minkref.fuzz.judges.plane.slow_erosion import judge
from minkref.fuzz.plane.families.random_pairs import random_pair
from thoroughness import draws

SEED = 3310
SQUARE = PolygonSet([(0, 0), (9, 0), (9, 9), (0, 9)])
ROOM = PolygonSet([[(0, 0), (9, 0), (9, 9), (0, 9)], [(3, 3), (5, 3), (5, 5), (3, 5)]])


@pytest.mark.parametrize("index", range(draws(45, 300)))
def test_erosions_are_those_of_the_slow_engine(index: int) -> None:
    """Compares regions, remnants, single places; prints the case."""
    ruling = judge(erosion_case(SEED, index), 5)
    assert ruling.compared > 8 and not ruling.messages, ruling.messages


@pytest.mark.parametrize("index", range(draws(30, 200)))
def test_places_of_parts_are_right_one_by_one(index: int) -> None:
    compared, faults = place_faults(SEED, index)
    assert compared and not faults, faults


@pytest.mark.parametrize("index", range(draws(20, 100)))
def test_a_cut_out_piece_fits_where_it_was_cut_out(index: int) -> None:
    container, piece, at = jigsaw(SEED, index)
    places = minkref.inner_fit(container, piece)
    assert (places.points, places.region.is_empty) == (((at,),), True), (container, piece)


def test_operators_and_values() -> None:
    P, Q = ROOM, PolygonSet([(1, 1), (4, 1), (4, 4), (1, 4)])
    less = P - Q
    assert isinstance(less, minkref.Erosion) and less == minkref.erode(P, Q)
    assert (less.components, less.holes, less.area) == (1, 0, 11)
    assert less.points == (((-1, 4), (-1, -1), (4, -1)),)
    assert (-1, 0) in less and (-1, Fraction(9, 2)) in less and (0, 0) not in less
    assert P + Q == minkref.minkowski_sum(P, Q).region
    assert (3, 4) in P and (4, 4) not in P and ("9", Fraction(1, 3)) in P
    assert (less.is_empty, (Q - P).is_empty) == (False, True)
    assert (SQUARE - SQUARE).points == (((0, 0),),)
    with pytest.raises(TypeError):
        P - 3  # type: ignore[operator]
    with pytest.raises(minkref.BadInput):
        assert "POLYGON((0 0,1 0,0 1,0 0))" in P


def test_closing_has_the_set_and_opening_lies_within() -> None:
    for index in range(draws(20, 100)):
        pair = random_pair(SEED, index)
        P, Q = (PolygonSet.from_json(text) for text in (pair.P, pair.Q))
        closed, opened = minkref.closing(P, Q), minkref.opening(P, Q, 3)
        assert minkref.subtract(P, [closed.region]).is_empty, index
        assert minkref.subtract(opened.region, [P.scaled("3")]).is_empty, index
        assert closed == minkref.closing(closed.region, Q), index
        assert opened.region == minkref.opening(opened.region, Q).region, index


def test_erosion_is_dual_to_the_sum_of_the_outside() -> None:
    """The outside plus -Q leaves the erosion of the box."""
    for index in range(draws(20, 100)):
        case = erosion_case(SEED + 1, index)
        if _core.erosion(case.P, case.Q, case.scale).components == 0:
            continue
        outside = _core.Outside(case.P).set
        summed = _core.minkowski_sum(outside, _core.negated(case.Q), case.scale, "winding").region
        frame = PolygonSet([summed.rings()[0][0]])
        left = minkref.subtract(frame, [summed])
        assert left == minkref.erode(case.P, case.Q, case.scale).region, index


@pytest.mark.parametrize("index", range(draws(12, 60)))
def test_components_and_holes_live_as_static_erosions_have_them(index: int) -> None:
    """By both routes, at scales between events and just beside each."""
    case = erosion_case(SEED + 2, index)
    least = Fraction(_core.least_scale_with_room(case.P, case.Q) or 0)
    low, high = (least or Fraction(1)) * Fraction(3, 4), (least or Fraction(1)) * 4
    found = [
        minkref.events(case.P, case.Q, "topology", low, high, route=route, erode=True)
        for route in ("dynamic", "index")
    ]
    assert list(found[0]) == list(found[1])
    scales = sorted({low, high, *(event.scale for event in found[0])})
    asked = {(a + b) / 2 for a, b in pairwise(scales)}
    asked |= {s + (1 if up else -1) * Fraction(1, 10**9) for s in scales[1:-1] for up in (0, 1)}
    for s in sorted(asked)[:14]:
        left = minkref.erode(case.P, case.Q, s)
        alive = [
            sum((one.birth is None or one.birth < s) and (one.death is None or s < one.death)
                for one in lives)
            for lives in (found[0].components, found[0].holes)
        ]  # fmt: skip
        assert alive == [left.components, left.holes], (index, s)


def test_no_fit_tells_exact_fits_from_overlaps() -> None:
    hole = PolygonSet([(0, 0), (2, 0), (2, 2), (0, 2)])
    found = minkref.no_fit(ROOM, hole)
    assert [fit["points"] for fit in found.exact_fits] == [[(3, 3)]]
    assert (found.region.area(), found.components, found.holes) == ("121", 1, 0)
    smaller = minkref.no_fit(ROOM, hole.scaled("1/2"))
    assert (smaller.holes, smaller.exact_fits) == (1, [])


BAD: dict[str, tuple[Any, str]] = {
    "empty Q": (lambda: minkref.erode(SQUARE, PolygonSet()), "empty"),
    "scale": (lambda: minkref.erode(SQUARE, SQUARE, 0), "greater than zero"),
    "scale of two": (lambda: minkref.erode(SQUARE, SQUARE, (1, -1)), "greater than zero"),
    "route": (lambda: minkref.erode(SQUARE, SQUARE, 1, "papr"), "paper"),
    "invalid": (
        lambda: minkref.erode(PolygonSet([(0, 0), (1, 1), (1, 0), (0, 1)], validate=False), SQUARE),
        "ring",
    ),
}


@pytest.mark.parametrize("name", BAD)
def test_bad_input_is_refused_in_words(name: str) -> None:
    call, word = BAD[name]
    with pytest.raises(minkref.BadInput) as refused:
        call()
    error = refused.value
    assert word in f"{error} {error.mend}"
