"""Questions to the index through Python, singly, as batches and from several threads; its build."""

from __future__ import annotations

import math
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from itertools import pairwise
from typing import Any

import numpy
import pytest
from indexed_sums import (
    FORMS,
    LONG,
    NAMES,
    Index,
    Rings,
    arrays,
    operands,
    points,
    scales,
    window_of,
)
from minkref import _core
from minkref.plane.commands.scale_index import STAGES

# Questions without rings.


def test_the_area_is_within_its_error(index: Index) -> None:
    for scale in scales(index):
        exact = Fraction(_core.minkowski_sum(index.P, index.Q, scale).region.area())
        value, error = index.area(scale)
        assert 0 <= error < math.inf
        assert abs(Fraction(value) - exact) <= Fraction(error), scale


@pytest.mark.parametrize("name", [name for name in NAMES if name != LONG])
def test_the_error_of_the_area_is_small(indices: dict[str, Index], name: str) -> None:
    for scale in scales(indices[name]):
        value, error = indices[name].area(scale)
        assert error <= 1e-9 * (1 + value)


def test_the_polynomial_of_the_area_is_exact(index: Index) -> None:
    for scale in scales(index):
        exact = Fraction(_core.minkowski_sum(index.P, index.Q, scale).region.area())
        a0, a1, a2 = index.area_polynomial(scale)
        assert a0 + Fraction(scale) * (a1 + Fraction(scale) * a2) == exact, scale


def test_one_polynomial_holds_up_to_the_next_events(indices: dict[str, Index]) -> None:
    index = indices["several components"]
    for a, b in pairwise(index.event_scales()):
        told = {index.area_polynomial(str(a + (b - a) * k / 4)) for k in (1, 2, 3)}
        assert len(told) == 1
        a0, a1, a2 = told.pop()
        for s in (a, b):
            exact = Fraction(_core.minkowski_sum(index.P, index.Q, str(s)).region.area())
            assert a0 + s * (a1 + s * a2) == exact


def test_components_and_holes_and_the_sum_are_those_of_the_static_route(index: Index) -> None:
    for scale in scales(index):
        expected = _core.minkowski_sum(index.P, index.Q, scale, tight_passages=True)
        found = index.sum(scale, True)
        counts = (expected.components, expected.holes)
        assert index.components_and_holes(scale) == counts, scale
        assert (found.components, found.holes) == counts
        assert found.region.canonical_json() == expected.region.canonical_json()
        assert found.tight_passages == expected.tight_passages
        assert index.sum(scale).tight_passages == expected.tight_passages  # found when asked for
    assert index.first_difference(scales(index)) == ""


def test_neighbours_are_the_events_beside_a_scale(index: Index) -> None:
    exact = index.event_scales()
    assert exact == sorted(set(exact))
    low, high = index.window
    for scale in scales(index, 20):
        s = Fraction(scale)
        below = [event for event in exact if event < s]
        above = [event for event in exact if event > s]
        assert index.neighbours(scale) == (
            below[-1] if below else None,
            s in exact,
            above[0] if above else None,
        )
    within = [e for e in exact if (low is None or e >= low) and (high is None or e <= high)]
    assert {Fraction(row[0]) for row in index.boundary_events()} <= set(within)


# Many questions.


def same(one: Rings, other: Rings) -> bool:
    """Whether two answers agree completely."""
    heads = [(r.scale, r.form, len(r), r.features()) for r in (one, other)]
    errors = [r.error if r.form == "double" else None for r in (one, other)]
    return (
        heads[0] == heads[1]
        and errors[0] == errors[1]
        and all(
            a.dtype == b.dtype and numpy.array_equal(a, b)
            for (_, a), (_, b) in zip(arrays(one), arrays(other), strict=True)
        )
    )


@pytest.mark.parametrize("threads", [1, 2, 5])
@pytest.mark.parametrize("form", FORMS)
def test_a_batch_is_the_single_answers_in_their_order(
    indices: dict[str, Index], form: str, threads: int
) -> None:
    for name in ("several components", "letters", LONG, "nothing"):
        index = indices[name]
        asked = scales(index)[::-1]
        asked += asked[:3]
        batch = index.batch(asked, form, threads)
        assert [rings.scale for rings in batch] == asked
        for scale, rings in zip(asked, batch, strict=True):
            assert same(rings, index.rings(scale, form)), (name, scale)
    assert index.batch([], form, threads) == []


def test_batches_and_rings_are_doubles_where_no_form_is_named(indices: dict[str, Index]) -> None:
    index = indices["islands"]
    assert index.rings("2").form == index.batch(["2"])[0].form == "double"


def test_a_scale_may_be_told_in_any_way(indices: dict[str, Index]) -> None:
    index = indices["islands"]
    for text in ("5/2", "2.5", "25e-1", "10/4"):
        rings = index.rings(text)
        assert rings.scale == "5/2"
        assert same(rings, index.rings("5/2"))


def test_several_threads_get_the_same_answers() -> None:
    P, Q = operands("letters")
    index = Index(P, Q, "1/4", "4", 2)
    asked = scales(index, 30)

    def answer(scale: str) -> list[Any]:
        return [
            *(index.rings(scale, form) for form in FORMS),
            index.sum(scale).region.canonical_json(),
            index.area(scale),
            index.area_polynomial(scale),
            index.components_and_holes(scale),
            index.neighbours(scale),
            index.topology_events(),
            index.lives("hole"),
        ]

    expected = {scale: answer(scale) for scale in asked}
    with ThreadPoolExecutor(8) as pool:
        for scale, found in zip(asked * 3, pool.map(answer, asked * 3), strict=True):
            wanted = expected[scale]
            assert found[len(FORMS) :] == wanted[len(FORMS) :], scale
            assert all(map(same, found[: len(FORMS)], wanted[: len(FORMS)])), scale


# A lazy index.


@pytest.mark.parametrize("name", NAMES)
def test_a_lazy_index_answers_as_a_built_one(indices: dict[str, Index], name: str) -> None:
    index = indices[name]
    lazy = Index(index.P, index.Q, *window_of(name), lazy=True)
    assert (lazy.window, lazy.is_of(index.P, index.Q)) == (index.window, True)
    assert lazy.edges() == index.edges()
    for scale in scales(index, 6):
        found, expected = (
            {point for form in FORMS[1:3] for point in points(one, one.rings(scale, form))}
            for one in (lazy, index)
        )
        assert found == expected, scale
        assert lazy.components_and_holes(scale) == index.components_and_holes(scale)
        sums = [one.sum(scale, True) for one in (lazy, index)]
        assert sums[0].region.canonical_json() == sums[1].region.canonical_json()
        assert sums[0].tight_passages == sums[1].tight_passages
        area = Fraction(sums[1].region.area())
        assert all(abs(Fraction(v) - area) <= e for v, e in [lazy.area(scale), index.area(scale)])


QUESTIONS: dict[str, Callable[[Index], Any]] = {
    "counts": lambda index: index.counts(),
    "tracks": lambda index: index.rings("2", "track").tracks.tolist(),
    "integers": lambda index: index.track_integers.tolist(),
    "doubles": lambda index: index.track_doubles.tolist(),
    "neighbours": lambda index: index.neighbours("2"),
    "lives": lambda index: index.lives("hole"),
    "polynomial": lambda index: index.area_polynomial("2"),
}


@pytest.mark.parametrize("question", QUESTIONS)
def test_a_lazy_index_is_built_for_what_only_an_index_knows(
    indices: dict[str, Index], question: str
) -> None:
    index = indices["islands"]
    lazy = Index(index.P, index.Q, lazy=True)
    assert (index.is_built, lazy.is_built) == (True, False)
    assert QUESTIONS[question](lazy) == QUESTIONS[question](index)
    assert lazy.is_built


@pytest.mark.parametrize("threads", [1, 3])
def test_a_batch_builds_a_lazy_index_if_that_is_worth_while(
    indices: dict[str, Index], threads: int
) -> None:
    index = indices["islands"]
    lazy, other = (Index(index.P, index.Q, lazy=True) for _ in range(2))
    asked = [f"{k}/100" for k in range(50, 2000)]
    batch = lazy.batch(asked, "double", threads)
    assert lazy.is_built
    assert same(batch[0], other.rings(asked[0]))  # the price is known from the first sum on
    assert all(map(same, batch[1:], index.batch(asked[1:])))
    other.batch(asked[:2], "double", threads)
    assert not other.is_built


def test_threads_share_a_lazy_index() -> None:
    P, Q = operands("several components")
    index, lazy = Index(P, Q), Index(P, Q, lazy=True)
    asked = scales(index, 12) * 20
    with ThreadPoolExecutor(8) as pool:
        found = pool.map(lambda scale: lazy.sum(scale).region.canonical_json(), asked)
        expected = {scale: index.sum(scale).region.canonical_json() for scale in asked}
        assert list(found) == [expected[scale] for scale in asked]


def test_indices_may_be_built_at_the_same_time() -> None:
    names = ("letters", "islands", "several components", "random 2")
    with ThreadPoolExecutor(4) as pool:
        built = list(pool.map(lambda name: Index(*operands(name)), names * 3))
    for name, index in zip(names * 3, built, strict=True):
        assert index.first_difference(["1", "7/5"]) == "", name


def test_progress_tells_of_each_stage_and_may_end_the_build() -> None:
    told: list[tuple[str, int, int]] = []
    P, Q = operands("letters")
    Index(P, Q, None, None, 2, 0, lambda *now: told.append(now))
    assert list(dict.fromkeys(stage for stage, _, _ in told)) == list(STAGES)
    assert all(0 <= done <= total for _, done, total in told)
    for stage in STAGES:
        done = [now[1] for now in told if now[0] == stage]
        assert done == sorted(done)

    def stop(stage: str, done: int, total: int) -> None:
        raise InterruptedError(stage)

    with pytest.raises(InterruptedError):
        Index(P, Q, None, None, 2, 0, stop)


# Updates.


def test_an_update_is_a_new_index_and_tells_what_it_reused() -> None:
    teeth = [[(x, 2), (x, 30), (x - 2, 30), (x - 2, 2)] for x in range(160, 0, -4)]
    ring = [(0, 0), (160, 0), *(p for tooth in teeth for p in tooth)]
    moved = [(x, 31) if (x, y) == (80, 30) else (x, y) for x, y in ring]
    P, new_P = _core.PolygonSet(ring), _core.PolygonSet(moved)
    Q = _core.PolygonSet([(0, 0), (2, 0), (1, 1)])
    index = Index(P, Q, "1/2", "2")
    updated, fresh = index.updated(P=new_P), Index(new_P, Q, "1/2", "2")
    assert (updated.is_of(new_P, Q), index.is_of(P, Q)) == (True, True)
    assert updated.event_scales() == fresh.event_scales()
    assert updated.tracks() == fresh.tracks()
    for scale in scales(fresh):
        assert updated.sum(scale).region == fresh.sum(scale).region
    assert updated.reuse()["reused"] > 10 * updated.reuse()["rebuilt"] > 0
    assert index.updated().reuse()["rebuilt"] == 0
    wide = Q.scaled("2")
    again = updated.updated(Q=wide, threads=2)
    assert again.sum("1").region == _core.minkowski_sum(new_P, wide, "1").region


def test_an_update_of_a_lazy_index_is_lazy_until_it_is_built() -> None:
    square = _core.PolygonSet([(0, 0), (4, 0), (4, 4), (0, 4)])
    lazy = Index(square, square, "1", "2", lazy=True)
    assert not lazy.updated(P=square.scaled("2")).is_built
    assert lazy.updated(P=square.scaled("2")).reuse() == {}
    assert lazy.event_scales() == []
    assert lazy.updated(P=square.scaled("2")).is_built


def test_an_update_refuses_what_a_build_refuses() -> None:
    square = _core.PolygonSet([(0, 0), (4, 0), (4, 4), (0, 4)])
    crossed = _core.PolygonSet([(0, 0), (4, 4), (4, 0), (0, 4)], validate=False)
    with pytest.raises(_core.BadInput, match="P"):
        Index(square, square, "1", "2").updated(P=crossed)
