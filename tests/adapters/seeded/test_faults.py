"""Every seeded fault differs from the sound sum on a listed case. `shown_by.json` holds for each
fault a case P, Q (P scaled already), or the calls that lead to a wrong one."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
import seeded_sums
from minkref.fuzz.geometry.region import region_of_rings
from plain_sum import PlainSum, Set
from seeded_sums import CALLABLE, FAULTS, sound
from time_limit import limited

SHOWN_BY: dict[str, list[list[Set]]] = json.loads(
    (Path(__file__).parent / "shown_by.json").read_text(encoding="utf-8")
)
SECONDS = 0.5
BY_CHANCE = 64  # calls; each goes wrong with a chance of a quarter or more


def answer(function: PlainSum, P: Set, Q: Set) -> tuple[Any, ...]:
    """The canonical result and faults of its rings; or the name of the exception raised."""
    try:
        with limited(SECONDS):
            result = function(P, Q)
    except Exception as error:  # noqa: BLE001 a fault may raise anything
        return (type(error).__name__,)
    if result is None:
        return ("nothing",)
    region = region_of_rings(result, turned=True)
    return (region.json, region.overlap, region.degenerate)


def test_there_are_enough_of_each_kind() -> None:
    kinds = [fault.kind for fault in FAULTS.values()]
    assert len(FAULTS) >= 100 and len(CALLABLE) >= 90
    assert all(kinds.count(kind) >= 6 for kind in kinds)


def test_names_and_descriptions_are_unique_and_short() -> None:
    abouts = [fault.about for fault in FAULTS.values()]
    makers = [fault.make for fault in FAULTS.values()]
    assert len(set(abouts)) == len(set(makers)) == len(FAULTS)
    assert all(20 <= len(about) <= 120 and about.endswith(".") for about in abouts)


def test_each_is_a_function_of_the_module() -> None:
    assert set(SHOWN_BY) == set(CALLABLE)
    for name in CALLABLE:
        assert getattr(seeded_sums, name) is getattr(seeded_sums, name)
    with pytest.raises(AttributeError):
        _ = seeded_sums.scales_twice
    with pytest.raises(AttributeError):
        _ = seeded_sums.nothing_of_this_name


@pytest.mark.parametrize("name", CALLABLE)
def test_the_fault_shows(name: str) -> None:
    fault = FAULTS[name].make()
    *before, (P, Q) = SHOWN_BY[name]
    for first in before:
        assert answer(fault, *first) == answer(sound, *first)
    right = answer(sound, P, Q)
    assert len(right) == 3 and right[1:] == (None, None)
    tries = BY_CHANCE if name.endswith("by_chance") else 1
    assert any(answer(fault, P, Q) != right for _ in range(tries))


@pytest.mark.parametrize("name", [name for name, calls in SHOWN_BY.items() if len(calls) > 1])
def test_a_fault_of_state_does_not_show_in_a_fresh_process(name: str) -> None:
    P, Q = SHOWN_BY[name][-1]
    assert answer(FAULTS[name].make(), P, Q) == answer(sound, P, Q)
