"""Cells of a grid that touch, beside segments, a point and each other: the index and the dynamic
sum are the sums of all other routes at, between and beside all events. All of them, and more, are
in the evidence (`touching_rings`)."""

from __future__ import annotations

import json

import pytest
from minkref import _core
from minkref.fuzz.families.touching_cells import (
    DIRECTIONS,
    WINDOWS,
    beside_segments,
    random_cells,
    touching_sets,
    window_of,
)
from minkref.reports.evidence.touching_rings import Task, cell_tasks, same_as_static

SEED = 3
EVERY = 53  # of 3 x 3 cells; in step with neither directions, orders nor windows


@pytest.mark.parametrize("task", list(cell_tasks(2)), ids=lambda task: task[0])
def test_sums_of_two_by_two_cells(task: Task) -> None:
    check(task)


@pytest.mark.parametrize("task", list(cell_tasks(3))[::EVERY], ids=lambda task: task[0])
def test_sums_of_some_of_three_by_three_cells(task: Task) -> None:
    check(task)


@pytest.mark.parametrize("index", range(60))
def test_sums_of_random_cells(index: int) -> None:
    pair = random_cells(SEED, index)
    check((f"random cells {SEED} {index}", pair.P, pair.Q, window_of(index)))


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
    drawn = {(window_of(index), index % 3 == 2) for index in range(60)}
    assert drawn == {(window, regions) for window in WINDOWS for regions in (True, False)}


def test_the_sets_are_all_and_valid() -> None:
    assert len(list(touching_sets(2))) == 2
    sets = list(touching_sets(3))
    assert len(sets) == 80  # 76 but for rings paired otherwise in an image of the same cells
    assert len(list(beside_segments(3))) == len(sets) * (2 * len(DIRECTIONS) + 1)


def test_rings_are_paired_in_each_way() -> None:
    """Both pairings of one touch are the same set, of one ring less or more."""
    counts: dict[str, set[int]] = {}
    for case in beside_segments(3):
        if not case.name.endswith("point"):
            continue
        region = _core.PolygonSet.from_json(case.Q)
        form = _core.canonicalize(region)[0].canonical_json()
        counts.setdefault(form, set()).add(region.rings)
    assert any(len(rings) > 1 for rings in counts.values())
