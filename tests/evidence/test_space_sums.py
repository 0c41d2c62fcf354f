"""The step about sums of general polyhedra, on some of its pairs."""

from __future__ import annotations

import pytest

pytest.importorskip("minkref._core", reason="the extension module is not built")

from minkref.fuzz.judges.space.space_laws import LAWS
from minkref.fuzz.judges.space.space_routes import ROUTES, routes
from minkref.fuzz.space.general_pairs import FAMILIES, OF_PARTS
from minkref.reports.evidence.framework.part import Size
from minkref.reports.evidence.space_sums.small_pairs import EVERY_FOR_LAWS, judge


@pytest.mark.parametrize("index", [3, 4, 11, 12])  # a slot, a ring, a thin one, polycubes
def test_all_answers_agree(index: int) -> None:
    row = judge((index, Size.QUICK))
    assert row["messages"] == []
    assert row["compared"]["points"] > 0
    assert set(row["answers"]) >= set(routes()) and row["answers"]
    assert ("cells" in row["answers"]) == (index == 12)


def test_laws_are_asked_of_all_families() -> None:
    families = len(FAMILIES) + len(OF_PARTS)
    for every in EVERY_FOR_LAWS:
        assert {index % families for index in range(0, every * families, every)} == set(
            range(families)
        )


@pytest.mark.parametrize("route", ROUTES)
def test_a_route_keeps_the_laws(route: str) -> None:
    """Takes a pair whose two components give all laws something to say."""
    assert route in routes()
    row = judge((13, Size.QUICK))
    assert row["messages"] == []
    assert route in row["answers"]
    assert set(row["laws"]) == set(LAWS)
