"""Changes between states of rings: exact, and no larger than the new content."""

from __future__ import annotations

import random

import pytest
from minkref.plane.page.replay import Replay
from minkref.plane.page.ring_changes import (
    Change,
    RingChanges,
    Row,
    SlotChange,
    splices_between,
    turned,
)


def carried_out(old: list[int], splices: list[list[int]]) -> list[int]:
    result = list(old)
    for at, removed, *added in splices:
        result = result[:at] + added + result[at + removed :]
    return result


@pytest.mark.parametrize("seed", range(200))
def test_splices_lead_to_the_ring(seed: int) -> None:
    dice = random.Random(seed)
    old = dice.sample(range(14), dice.randint(0, 14))
    ring = tuple(dice.sample(range(14), dice.randint(1, 14)))
    assert turned(carried_out(old, splices_between(old, ring))) == turned(ring)


def test_a_vertex_that_comes_is_one_splice() -> None:
    old = list(range(1000))
    ring = (*range(300, 1000), *range(200), 5000, *range(200, 300))
    assert splices_between(old, ring) == [[200, 0, 5000]]


def test_two_far_changes_are_two_small_splices() -> None:
    old = list(range(1000))
    ring = (*range(100), 5000, *range(101, 900), 5001, 5002, *range(902, 1000))
    assert splices_between(old, ring) == [[900, 2, 5001, 5002], [100, 1, 5000]]


def test_nothing_new_is_no_splice() -> None:
    assert splices_between([1, 2, 3], (2, 3, 1)) == []


def rows(*rings: list[int]) -> list[Row]:
    return [(bool(i), 0, i, ring) for i, ring in enumerate(rings)]


def test_a_ring_that_splits_keeps_its_slot_and_a_new_one_comes() -> None:
    changes = RingChanges()
    changes.step(rows(list(range(100))))
    change = changes.step(rows(list(range(90)), [90, *range(91, 100)]))
    assert change.gone == []
    assert [changed.slot for changed in change.changed] == [0, 1]
    assert change.changed[0].splices == [[90, 10]]
    assert change.changed[1].splices == [[0, 0, *range(90, 100)]]


def test_a_ring_that_ends_is_named_once() -> None:
    changes = RingChanges()
    changes.step(rows([0, 1, 2, 3], [4, 5, 6]))
    assert changes.step(rows([0, 1, 2, 3])) == Change([1], [])


def test_another_identity_alone_has_no_splices() -> None:
    changes = RingChanges()
    changes.step([(False, 0, 0, [0, 1, 2]), (True, 0, 4, [3, 4, 5])])
    change = changes.step([(False, 0, 0, [1, 2, 0]), (True, 0, 7, [3, 4, 5])])
    assert change == Change([], [SlotChange(1, (True, 0, 7), [])])


def test_the_replay_refuses_rings_that_are_not_those_of_the_changes() -> None:
    replay = Replay()
    replay.step(RingChanges().step(rows([0, 1, 2, 3])))
    replay.check(rows([2, 3, 0, 1]))
    for wrong in (rows([0, 2, 1, 3]), rows([0, 1, 2]), [(True, 0, 0, [0, 1, 2, 3])], []):
        with pytest.raises(AssertionError, match="rings of the sum"):
            replay.check(wrong)
