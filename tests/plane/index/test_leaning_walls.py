"""Walls parallel up to 1e-2 or 1e-30, where positions along an edge are quotients of nearly
cancelling numbers: the index has the other routes' sums and events."""

from __future__ import annotations

import pytest
from minkref.fuzz.plane.families.leaning_walls import leaning_pair
from minkref.reports.evidence.plane_index.sums import same_events, same_sums
from thoroughness import draws

SEED = 5  # 17 of its first 150 pairs were internal errors while doubles told what they could not


@pytest.mark.parametrize("index", range(60, 150, draws(9, 3)))
def test_sums_and_events_are_those_of_the_other_routes(index: int) -> None:
    pair = leaning_pair(SEED, index)
    task = (f"leaning {SEED} {index}", pair.P, pair.Q, (None, None), ())
    for same in (same_sums, same_events):
        name, compared, fault = same(task)
        assert not fault, f"{name}: {fault}\n{pair.P}\n{pair.Q}"
        assert compared > 0
