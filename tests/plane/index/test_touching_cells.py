"""Grid cells that touch, beside segments, a point and each other: the index and the dynamic sum
equal all other routes' sums at, between and beside all events. The evidence (`touching_rings`)
tests all these sets and more."""

from __future__ import annotations

import json

import pytest
from minkref import _core
from minkref.fuzz.plane.families.touching_cells import (
    DIRECTIONS,
    WINDOWS,
    beside_segments,
    random_cells,
    touching_sets,
    window_of,
)
from minkref.reports.evidence.plane_index.touching_rings import Task, cell_tasks, same_as_static
from thoroughness import THOROUGH, draws

SEED = 3
# Strides over 2 x 2 and over 3 x 3 cells; in step with neither directions, orders nor windows.
EVERY = {2: draws(3, 1), 3: draws(211, 53)}
DRAWN = range(60) if THOROUGH else range(3, 60, 4)  # regions and segments in each window


@pytest.mark.parametrize("task", list(cell_tasks(2))[:: EVERY[2]], ids=lambda task: task[0])
def test_sums_of_two_by_two_cells(task: Task) -> None:
    check(task)


@pytest.mark.parametrize("task", list(cell_tasks(3))[:: EVERY[3]], ids=lambda task: task[0])
def test_sums_of_some_of_three_by_three_cells(task: Task) -> None:
    check(task)


@pytest.mark.parametrize("index", DRAWN)
def test_sums_of_random_cells(index: int) -> None:
    pair = random_cells(SEED, index)
    check((f"random cells {SEED} {index}", pair.P, pair.Q, window_of(index)))


FOUND = {
    "three components": (
        "LINESTRING (0 1, 0 2)",
        "MULTIPOLYGON (((3 4, 4 4, 4 5, 3 5, 3 4)), ((3 4, 2 4, 2 6, 1 6, 1 4, 0 4, 0 3, 2 3, "
        "2 2, 3 2, 3 4)), ((4 4, 4 2, 3 2, 3 1, 2 1, 2 0, 4 0, 4 1, 5 1, 5 2, 6 2, 6 5, 5 5, 5 4, "
        "4 4)))",
    ),
    "two holes": (
        "LINESTRING (1 -1, 2 -1)",
        "POLYGON ((-1 -1, 8 -1, 8 6, -1 6, -1 -1), (2 4, 3 4, 3 2, 4 2, 4 1, 1 1, 1 3, 2 3, 2 4), "
        "(4 3, 6 3, 6 2, 4 2, 4 3))",
    ),
    "a hole of ten corners": (
        "LINESTRING (2 -1, 2 0)",
        "POLYGON ((-1 -1, 7 -1, 7 4, -1 4, -1 -1), "
        "(0 3, 3 3, 3 2, 4 2, 4 3, 6 3, 6 2, 5 2, 5 1, 4 1, 4 0, 0 0, "
        "0 3), (5 1, 6 1, 6 0, 5 0, 5 1))",
    ),
}


@pytest.mark.parametrize("name", FOUND)
def test_sums_of_a_segment_that_once_ended_in_errors(name: str) -> None:
    """In traps and sweeps: the boundary of the swept sum was said to jump, or not to close."""
    P, Q = (_core.read_text(text, "wkt").to_json() for text in FOUND[name])
    for window in WINDOWS:
        check((name, P, Q, window))


def check(task: Task) -> None:
    name, compared, fault = same_as_static(task)
    assert not fault, f"{name}: {fault}\n{task[1]}\n{task[2]}"
    assert compared > 0, name


def test_a_segment_meets_every_window() -> None:
    kinds = {
        (task[3], min(len(json.loads(text)["polygons"][0]["outer"]) for text in task[1:3]))
        for task in cell_tasks(3)
    }
    assert kinds == {(window, corners) for window in WINDOWS for corners in (1, 2)}
    drawn = {(window_of(index), index % 3 == 2) for index in DRAWN}
    assert drawn == {(window, regions) for window in WINDOWS for regions in (True, False)}


def test_the_sets_are_all_and_valid() -> None:
    assert len(list(touching_sets(2))) == 2
    sets = list(touching_sets(3))
    assert len(sets) == 80  # 76 but for rings paired otherwise in an image of the same cells
    assert len(list(beside_segments(3))) == len(sets) * (2 * len(DIRECTIONS) + 1)


def test_rings_are_paired_in_each_way() -> None:
    """Both pairings at a touch describe the same set, with one ring less or more."""
    counts: dict[str, set[int]] = {}
    for case in beside_segments(3):
        if not case.name.endswith("point"):
            continue
        region = _core.PolygonSet.from_json(case.Q)
        form = _core.canonicalize(region)[0].canonical_json()
        counts.setdefault(form, set()).add(region.rings)
    assert any(len(rings) > 1 for rings in counts.values())
