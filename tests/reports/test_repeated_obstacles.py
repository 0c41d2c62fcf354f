"""Fig. 11: an environment of repeated obstacles, both sides of its speed-up in one arithmetic."""

from __future__ import annotations

from fractions import Fraction

import pytest
from minkref import _core
from minkref.reports.bench.repeated_obstacles import (
    AS_LISTED,
    COPIES,
    FROM_ONE,
    READINGS,
    REPETITIONS,
    SHARED_BY,
    SORTED,
    environment,
    placed_sums,
    timed,
)
from minkref.reports.paper.entry import Verdict
from minkref.reports.paper.repeated_obstacles_entry import entry


@pytest.mark.parametrize("shapes", SHARED_BY)
def test_an_environment_has_twelve_copies_of_different_shapes(shapes: int) -> None:
    scene = environment(shapes)
    assert len(scene.copies) == COPIES
    assert len({shape.canonical_json() for shape in scene.shapes}) == shapes
    assert {copy.shape for copy in scene.copies} == set(range(shapes))


def test_each_order_is_timed_as_often_and_ends_with_the_same_intersections() -> None:
    found = timed(1, "rational", lambda text: None)
    assert list(found.orders) == [AS_LISTED, SORTED, FROM_ONE]
    assert all(len(seconds) == REPETITIONS for seconds in (found.scratch, *found.orders.values()))
    scene = environment(1)
    exact = _core.PaperUpdate(scene.shapes[0], scene.turned_robot, "1", "rational", READINGS)
    placed = 0
    for copy in scene.copies:
        exact.move_to(copy.scale)
        placed += exact.place_intersections()[0]
    assert found.intersections == placed > COPIES


def test_the_entry_tells_medians_and_draws_the_environment() -> None:
    found = entry([timed(1, "double", lambda text: None)])
    assert len(found.tables[0].rows) == 3 and len(found.claims) == len(found.pictures) == 2
    assert found.verdict in (Verdict.IN_KIND, Verdict.CONSISTENT, Verdict.NOT_REPRODUCED)


def test_places_are_of_the_sums_drawn() -> None:
    (_, total), copy = placed_sums(1)[0], environment(1).copies[0]
    back = total.translated(*(str(-Fraction(x)) for x in copy.place))
    scene = environment(1)
    assert back == _core.minkowski_sum(scene.shapes[0], scene.turned_robot, copy.scale).region
